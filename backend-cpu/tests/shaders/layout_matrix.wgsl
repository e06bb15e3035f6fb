// Columns of three rows stand on 16 bytes; loads of columns and elements, constant and computed.
//! buffer 0: f32 1 2 3 -1 4 5 6 -1 7 8 9 -1 10 20 30 40
//! buffer 1: zero 14
//! dispatch: main 1 1 1
//! expect 1: f32 1 5 9 4 5 6 7 8 9 30 40 12 15 18

struct Matrices {
    m: mat3x3<f32>,
    n: mat2x2<f32>,
}

@group(0) @binding(0) var<storage, read> data: Matrices;
@group(0) @binding(1) var<storage, read_write> out: array<f32>;

@compute @workgroup_size(3)
fn main(@builtin(local_invocation_index) i: u32) {
    out[i] = data.m[i][i];
    out[3u + i] = data.m[1][i];
    let column = data.m[2];
    out[6u + i] = column[i];
    if i < 2u {
        out[9u + i] = data.n[1u][i];
    }
    let sum = data.m * vec3(1.0);
    out[11u + i] = sum[i];
}
