// Out-of-range indices mean the last element, negative ones too; nothing else is touched.
//! buffer 0: u32 1 2 3 4
//! buffer 1: zero 16
//! dispatch: main 1 1 1
//! expect 0: u32 1 2 3 42
//! expect 1: u32 4 4 1 4 30 30 10 2 9 9 7 4 2 66 0 0
//! trap: 19 out of bounds

@group(0) @binding(0) var<storage, read_write> data: array<u32>;
@group(0) @binding(1) var<storage, read_write> out: array<u32, 16>;
var<private> constants: array<u32, 3> = array(10u, 20u, 30u);
var<workgroup> cells: array<u32, 2>;

@compute @workgroup_size(1)
fn main(@builtin(local_invocation_index) zero: u32) {
    let four = zero + 4u;
    let minus = -1i - i32(zero);
    // The first access past the end:
    out[0] = data[four];
    out[1] = data[four * 0x10000000u];
    out[2] = data[zero];
    out[3] = data[minus];
    out[4] = constants[four];
    out[5] = constants[minus];
    out[6] = constants[zero];
    let v = vec2(1u, 2u);
    out[7] = v[four];
    var w = vec3(7u, 8u, 9u);
    out[8] = w[minus];
    out[9] = w[four];
    out[10] = w[zero];
    out[11] = arrayLength(&data);
    var m = mat2x2<f32>(1.0, 1.0, 2.0, 2.0);
    out[12] = u32(m[four][minus]);
    cells[four] = 66u;
    out[13] = cells[1];
    data[four + zero] = 42u;
}
