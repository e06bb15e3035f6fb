// Variables begin at zero: function, private and workgroup memory, in every workgroup and every loop turn.
//! buffer 0: zero 16
//! dispatch: main 4 1 1
//! expect 0: u32 3*16

struct Mixed {
    flag: bool,
    f: f32,
    list: array<vec3<i32>, 3>,
    m: mat2x2<f32>,
}

@group(0) @binding(0) var<storage, read_write> out: array<u32>;
var<workgroup> shared_words: array<u32, 4>;
var<workgroup> shared_mixed: Mixed;
var<private> private_mixed: Mixed;
var<private> private_set: vec2<u32> = vec2(3u, 4u);

fn is_zero(m: Mixed) -> bool {
    return !m.flag && m.f == 0.0 && all(m.list[0] == vec3(0)) && all(m.list[2] == vec3(0)) && all(m.m[1] == vec2(0.0));
}

@compute @workgroup_size(4)
fn main(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) i: u32) {
    var local: Mixed;
    var good = is_zero(local) && is_zero(private_mixed) && is_zero(shared_mixed) && shared_words[i] == 0u;
    workgroupBarrier();
    shared_words[i] = 1u + id.x;
    shared_mixed.flag = true;
    private_mixed.list[1] = vec3(1);
    for (var k = 0u; k < 3u; k++) {
        var fresh: array<u32, 2>;
        var counted = k;
        good &= fresh[0] == 0u && fresh[1] == 0u && counted == k;
        fresh[k & 1u] = 9u;
        counted += 7u;
    }
    out[id.x] = select(0u, private_set.x, good && private_set.y == 4u);
}
