// workgroupUniformLoad gives all invocations one value and is a barrier on both sides.
//! buffer 0: zero 16
//! dispatch: main 2 1 1
//! expect 0: u32 10 11 12 13 14 15 16 17 110 111 112 113 114 115 116 117

@group(0) @binding(0) var<storage, read_write> out: array<u32>;
var<workgroup> limit: u32;
var<workgroup> turn: vec2<u32>;

@compute @workgroup_size(8)
fn main(@builtin(local_invocation_index) i: u32, @builtin(workgroup_id) group: vec3<u32>) {
    if i == 7u {
        limit = 3u + group.x;
    }
    var sum = 0u;
    for (var k = 0u; k < workgroupUniformLoad(&limit); k++) {
        if i == k {
            turn = vec2(k, 10u * k);
        }
        sum += workgroupUniformLoad(&turn).y / 10u;
        workgroupBarrier();
    }
    // 0 + 1 + 2 for group 0, and 3 more for group 1.
    out[8u * group.x + i] = select(0u, 10u, sum == 3u) + select(0u, 110u, sum == 6u) + i;
}
