// Arithmetic that nothing hides: 64 rounds of a linear congruential step, an xorshift, an f32 product and an f32 sum.

@group(0) @binding(0) var<storage, read_write> results: array<u32>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3<u32>) {
    var bits = id.x;
    var value = f32(id.x);
    for (var i = 0u; i < 64u; i++) {
        bits = bits * 1664525u + 1013904223u;
        bits = bits ^ (bits >> 13u);
        value = value * 0.9995117;
        value = value + 0.5;
    }
    results[id.x] = bits ^ bitcast<u32>(value);
}
