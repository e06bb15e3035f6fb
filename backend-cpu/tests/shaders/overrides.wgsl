// Overrides by name and by id, defaults, expressions of overrides, in workgroup size and array length.
//! buffer 0: zero 16
//! override: width = 8
//! override: 7 = 2.5
//! override: flag = 1
//! dispatch: main 2 1 1
//! expect 0: u32 25 26 27 28 29 30 31 32 125 126 127 128 129 130 131 132

override width: u32 = 4u;
@id(7) override scale: f32 = 1.0;
override flag: bool = false;
override doubled: u32 = width * 2u;
override unset: i32 = -3;

@group(0) @binding(0) var<storage, read_write> out: array<u32>;
var<workgroup> cells: array<u32, doubled>;

@compute @workgroup_size(width)
fn main(@builtin(local_invocation_index) i: u32, @builtin(workgroup_id) group: vec3<u32>) {
    cells[doubled - 1u - i] = i;
    workgroupBarrier();
    let mirrored = cells[width + (width - 1u - i)];
    if flag && unset == -3 {
        out[width * group.x + i] = u32(scale * 10.0) + mirrored + 100u * group.x;
    }
}
