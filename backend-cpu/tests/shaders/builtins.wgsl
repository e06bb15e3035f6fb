// Builtin ids in three dimensions, as parameters and as members of a structure.
//! buffer 0: zero 24
//! dispatch: main 2 1 2
//! expect 0: u32 0 1 10 11 20 21 2 3 12 13 22 23 100 101 110 111 120 121 102 103 112 113 122 123

@group(0) @binding(0) var<storage, read_write> out: array<u32>;

struct Ids {
    @builtin(local_invocation_id) local: vec3<u32>,
    @builtin(workgroup_id) group: vec3<u32>,
}

@compute @workgroup_size(2, 3, 1)
fn main(
    ids: Ids,
    @builtin(global_invocation_id) global: vec3<u32>,
    @builtin(local_invocation_index) index: u32,
    @builtin(num_workgroups) groups: vec3<u32>,
) {
    let good = all(global == ids.group * vec3(2u, 3u, 1u) + ids.local) && index == ids.local.x + 2u * ids.local.y;
    let group = ids.group.x + groups.x * (ids.group.y + groups.y * ids.group.z);
    out[6u * group + index] = select(99999u, global.x + 10u * global.y + 100u * global.z, good);
}
