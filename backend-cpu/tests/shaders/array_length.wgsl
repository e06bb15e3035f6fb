// The binding decides the length of a runtime-sized array, bare or at the end of a structure.
//! buffer 0: u32 9 8 7 6 5 4 3
//! buffer 1: zero 19
//! buffer 2: zero 3
//! dispatch: main 1 1 1
//! expect 1: u32 0*12 1 2 3 9 0*3
//! expect 2: u32 7 2 25
//! trap: 35 index 25 is out of bounds of length 2

struct Element {
    a: vec3<u32>,
    b: u32,
}

struct Tail {
    head: vec4<u32>,
    pad: u32,
    rest: array<Element>,
}

@group(0) @binding(0) var<storage, read> data: array<u32>;
@group(0) @binding(1) var<storage, read_write> tail: Tail;
@group(0) @binding(2) var<storage, read_write> out: array<u32>;

@compute @workgroup_size(1)
fn main() {
    out[0] = arrayLength(&data);
    out[1] = arrayLength(&tail.rest) + tail.rest[0].b;
    var sum = 0u;
    for (var i = 0u; i < arrayLength(&data); i++) {
        sum += data[i] * select(0u, 1u, i != 0u && i != 1u);
    }
    out[2] = sum;
    tail.rest[1].a = vec3(1u, 2u, 3u);
    tail.rest[sum].b = 9u;
}
