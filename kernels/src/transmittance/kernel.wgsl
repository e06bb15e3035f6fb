// What transparent surfaces let through to a picture behind them, pixel by pixel.
//
// Engelhardt and Dachsbacher, "Granular Visibility Queries on the GPU" (I3D 2009), section 5: visibility need not be
// binary; behind transparent blockers a pixel counts as much as it is seen. For every pixel p whose blocker b =
// blockers[p] is one of `count`, and nearer than the picture, depths[p] > blocker_depths[p],
//
//     weights[p] = floor((weights[p] * through[b] + 128) / 256),
//
// with weights up to 2^16 - 1 and `through` in 1/256, 256 where all passes; larger factors count as 256. Other weights
// stay. The product grows with the weight and never exceeds it, so a pixel that is seen behind more blockers is never
// seen better, and one that is not seen stays so.

struct Params {
    pixels: u32,
    /// Number of blockers.
    count: u32,
    /// Number of the first workgroup.
    first: u32,
}

@group(0) @binding(0) var<uniform> params: Params;
@group(0) @binding(1) var<storage, read> depths: array<u32>;
@group(0) @binding(2) var<storage, read> blocker_depths: array<u32>;
@group(0) @binding(3) var<storage, read> blockers: array<u32>;
@group(0) @binding(4) var<storage, read> through: array<u32>;
@group(0) @binding(5) var<storage, read_write> weights: array<u32>;

@compute @workgroup_size(256)
fn attenuate(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let pixel = (params.first + group.x) * 256u + lane;
    if (pixel >= params.pixels) {
        return;
    }
    let blocker = blockers[pixel];
    if ((blocker < params.count) & (blocker_depths[pixel] < depths[pixel])) {
        weights[pixel] = (weights[pixel] * min(through[blocker], 256u) + 128u) >> 8u;
    }
}
