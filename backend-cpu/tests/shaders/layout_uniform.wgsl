// A uniform buffer: constant and computed indices, structures by value.
//! buffer 0: u32 5 0*3 1 2 3 4 10 20 30 40 100 200 300 400 7 8 9 0
//! buffer 1: zero 12
//! dispatch: main 1 1 1
//! expect 1: u32 1 20 300 2 20 200 7 8 9 116 227 338

struct Parameters {
    bias: u32,
    table: array<vec4<u32>, 3>,
    tail: vec3<u32>,
}

@group(0) @binding(0) var<uniform> parameters: Parameters;
@group(0) @binding(1) var<storage, read_write> out: array<u32>;

fn tail_of(p: Parameters, i: u32) -> u32 {
    return p.tail[i];
}

@compute @workgroup_size(3)
fn main(@builtin(local_invocation_index) i: u32) {
    let row = parameters.table[i];
    out[i] = row[i];
    out[3u + i] = parameters.table[i].y;
    out[6u + i] = tail_of(parameters, i);
    let sum = parameters.table[0] + parameters.table[1] + parameters.table[2];
    out[9u + i] = sum[i] + parameters.bias;
}
