// Host-shareable layout: alignment of vectors, matrices and arrays; padding keeps what it held.
//! buffer 0: u32 0xeeee*40
//! dispatch: main 1 1 1
//! expect 0: u32 1 0xeeee*3 2 3 4 5 6 7 0xeeee 0xeeee 0x3f800000 0x40000000 0x40400000 0xeeee 0x40800000 0x40a00000 0x40c00000 0xeeee 8 0xeeee 9 10 11 0xeeee*3 12 13 14 0xeeee 15 16 17 0xeeee 18 0xeeee*3

struct Inner {
    a: u32,
    @align(8) b: vec2<u32>,
}

struct Element {
    v: vec3<u32>,
}

struct Outer {
    x: u32,
    v: vec3<u32>,
    after_vec3: u32,
    pair: vec2<u32>,
    m: mat2x3<f32>,
    inner: Inner,
    @size(16) sized: u32,
    list: array<Element, 2>,
    last: u32,
}

@group(0) @binding(0) var<storage, read_write> out: Outer;

@compute @workgroup_size(1)
fn main() {
    out.x = 1u;
    out.v = vec3(2u, 3u, 4u);
    out.after_vec3 = 5u;
    out.pair = vec2(6u, 7u);
    out.m = mat2x3<f32>(1.0, 2.0, 3.0, 4.0, 5.0, 6.0);
    var inner: Inner;
    inner.a = 8u;
    inner.b = vec2(9u, 10u);
    out.inner = inner;
    out.sized = 11u;
    out.list = array<Element, 2>(Element(vec3(12u, 13u, 14u)), Element(vec3(15u, 16u, 17u)));
    out.last = 18u;
}
