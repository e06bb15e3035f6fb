// Irradiance: what the samples that a receiver sees send to it, by groups of samples.
//
// Eisemann and Décoret, "Visibility Sampling on GPU and Applications", section 8: samples of one colour form a group
// with a mask of its own; what a receiver gets from a light of several colours is a sum over groups. The weight of a
// sample S at a receiver R with normal N is the form factor's kernel (Cohen and Wallace, "Radiosity and Realistic Image
// Synthesis", 1993, chapter 4): cos a cos b / d^2, where a is the angle at R, b that at S, where the light faces +z,
// and d the distance.
//
// Sample s of receiver r is hidden iff bit s % bits of `masks[(s / bits) * receivers + r]` is set; group g has those
// samples whose bits are set in its words `groups[g * words ..]`. For every group g and receiver r:
//
//     visible[g * receivers + r]         = how many samples of the group r sees
//     light[2 * (g * receivers + r) ..]  = the sum of their weights, in units of 2^-48 a square cell: low word, high
//     word
//
// With w = R - S, q = w . w and N of length 2^15 or less, a weight is floor(2^17 u / q), u = floor(2^16 (-N . w) w.z /
// q), 0 where the light is behind the receiver. Components of w are below 2^15, so q < 2^32; |N . w| <= 2^15 sqrt(q) <
// 2^31, though the sum of its products may wrap on the way; the first numerator is below 2^62, u at most 2^31 (2^16 |N|
// |w|^2 / q), the second numerator at most 2^48, and so is a weight. A sum of 1024 is at most 2^58. A receiver with z =
// 0 is none and gets 0.

import package::shared::divide::udiv64_32;
import package::shared::wide::{add64, shl64, umul_wide};
import package::shared::view::below;

struct Params {
    receivers: u32,
    /// Words of a mask.
    words: u32,
    samples: u32,
    /// Samples of a word.
    bits: u32,
    /// Receiver of the first invocation.
    first: u32,
}

@group(0) @binding(0) var<uniform> params: Params;
@group(0) @binding(1) var<storage, read> masks: array<u32>;
/// Where receivers stand, and how far the light's pattern is shifted for them, as `line_mask` has them.
@group(0) @binding(2) var<storage, read> receivers: array<vec4<i32>>;
@group(0) @binding(3) var<storage, read> groups: array<u32>;
/// Of length 2^15 or less.
@group(0) @binding(4) var<storage, read> normals: array<vec4<i32>>;
@group(0) @binding(5) var<storage, read> samples: array<vec2<i32>>;
@group(0) @binding(6) var<storage, read_write> visible: array<u32>;
@group(0) @binding(7) var<storage, read_write> light: array<u32>;

/// The samples of a group and word that a receiver sees.
fn seen(receiver: u32, group: u32, word: u32) -> u32 {
    let there = below(min(params.bits, params.samples - word * params.bits));
    return ~masks[word * params.receivers + receiver] & groups[group * params.words + word] & there;
}

/// The weight of a sample: w points from it to the receiver.
fn weight(w: vec3<i32>, normal: vec3<i32>) -> vec2<u32> {
    let facing = 0 - (normal.x * w.x + normal.y * w.y + normal.z * w.z);
    if (facing <= 0) {
        return vec2<u32>(0u);
    }
    let q = bitcast<u32>(w.x * w.x) + bitcast<u32>(w.y * w.y) + bitcast<u32>(w.z * w.z);
    let u = udiv64_32(shl64(umul_wide(bitcast<u32>(facing), bitcast<u32>(w.z)), 16u), q).x;
    let high = (u >> 15u) / q;
    return vec2<u32>(udiv64_32(vec2<u32>(u << 17u, (u >> 15u) - high * q), q).x, high);
}

@compute @workgroup_size(64)
fn count_groups(@builtin(global_invocation_id) id: vec3<u32>) {
    let receiver = params.first + id.x;
    if (receiver >= params.receivers) {
        return;
    }
    var count = 0u;
    if (receivers[receiver].z > 0) {
        for (var word = 0u; word < params.words; word += 1u) {
            count += countOneBits(seen(receiver, id.y, word));
        }
    }
    visible[id.y * params.receivers + receiver] = count;
}

@compute @workgroup_size(64)
fn irradiance(@builtin(global_invocation_id) id: vec3<u32>) {
    let receiver = params.first + id.x;
    if (receiver >= params.receivers) {
        return;
    }
    let r = receivers[receiver];
    let origin = r.xyz - vec3<i32>((r.w << 16u) >> 16u, r.w >> 16u, 0);
    let normal = normals[receiver].xyz;
    var sum = vec2<u32>(0u);
    if (r.z > 0) {
        for (var word = 0u; word < params.words; word += 1u) {
            var left = seen(receiver, id.y, word);
            while (left != 0u) {
                let sample = word * params.bits + firstTrailingBit(left);
                left &= left - 1u;
                sum = add64(sum, weight(origin - vec3<i32>(samples[sample], 0), normal));
            }
        }
    }
    let at = 2u * (id.y * params.receivers + receiver);
    light[at] = sum.x;
    light[at + 1u] = sum.y;
}
