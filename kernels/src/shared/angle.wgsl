// Angles of integer vectors without trigonometry.

import package::shared::fraction::ufrac;
import package::shared::wide::{uabs, umul_hi};

/// A binary angle, 2^32 to the turn: within 5 units of atan2(y, x) for |x|, |y| < 2^29 and within 8 beyond. (0, 0)
/// gives 0; atan2_bam(-y, x) = -atan2_bam(y, x) modulo 2^32.
///
/// Defined by its polynomial, every floor included: q = 4 floor(2^30 n / d) of the smaller by the larger magnitude,
/// both scaled to 29 bits and folded at 2/5 by atan(n / d) = pi/4 - atan((d - n) / (d + n)); z = floor(q q / 2^32);
/// then Horner's scheme in z, each product divided by 2^32 and rounded down.
fn atan2_bam(y: i32, x: i32) -> u32 {
    let ax = uabs(x);
    let ay = uabs(y);
    let larger = max(ax, ay);
    if (larger == 0u) {
        return 0u;
    }
    let s = countLeadingZeros(larger);
    let d0 = (larger << s) >> 3u; // in [2^28, 2^29)
    let n0 = (min(ax, ay) << s) >> 3u;
    let fold = 5u * n0 > 2u * d0;
    let n = select(n0, d0 - n0, fold);
    let d = select(d0, d0 + n0, fold); // n / d <= 3/7, d < 2^30
    let high = ufrac(n, d, 15u);
    let low = ufrac(high.y, d, 15u);
    let q = ((high.x << 15u) + low.x) << 2u;
    let z = umul_hi(q, q);
    var p = 374658932u - umul_hi(207245891u, z);
    p = 545657482u - umul_hi(p, z);
    p = 911383810u - umul_hi(p, z);
    p = 2734260801u - umul_hi(p, z);
    var t = (umul_hi(p, q) + 2u) >> 2u;
    t = select(t, 0x20000000u - t, fold);
    t = select(t, 0x40000000u - t, ay > ax);
    t = select(t, 0x80000000u - t, x < 0);
    return select(t, 0u - t, y < 0);
}

/// A pseudo-angle, 2^22 to the turn and monotone in the true angle: floor(2^20 |y| / (|x| + |y|)) in the first
/// quadrant, mirrored into the others. Coordinates are in [-2^29, 2^29]; (0, 0) gives 0.
fn diamond_angle(y: i32, x: i32) -> u32 {
    let ax = uabs(x);
    let ay = uabs(y);
    let p = ufrac(ay, max(ax + ay, 1u), 20u).x;
    let t = select(p, 0x200000u - p, x < 0);
    return select(t, (0u - t) & 0x3fffffu, y < 0);
}
