// Texels of the Hough space: angle and distance of an oriented line, as the paper's table has them.
//
// Eisemann and Décoret, "Visibility Sampling on GPU and Applications", section 5: theta in [-pi, pi] wraps, r in
// [-sqrt(2)/2, sqrt(2)/2] of the source's side clamps. In integers, so that every device takes the same texel.

import package::shared::angle::atan2_bam;
import package::shared::divide::udiv64_32;
import package::shared::line::Line;
import package::shared::line_cell::{CELL_ALL, CELL_NONE};
import package::shared::root::isqrt64;
import package::shared::wide::{abs64, add64, ltu64, shl64, shr64, uabs, umul_wide};

/// angle << k | distance of a half-plane over the square of half side 2^h. The angle is the first k bits of the binary
/// angle of (a, b). With R = floor(sqrt(2 (a^2 + b^2))), so that 2^h R is the distance of the corners in the line's
/// units, and |c| < 2^h R: distance = 2^(k-1) + floor(2^(k-1) |c| / (2^h R)) for c >= 0, and 2^k - 1 less that for c <
/// 0. Else it is `CELL_ALL` or `CELL_NONE` by the sign of c. |a|, |b| < 2^31, |c| < 2^49, 1 <= k <= 12, h <= 15.
fn texel(ln: Line, h: u32, k: u32) -> u32 {
    let squares = add64(umul_wide(uabs(ln.a), uabs(ln.a)), umul_wide(uabs(ln.b), uabs(ln.b)));
    let corner = isqrt64(shl64(squares, 1u));
    let magnitude = abs64(ln.c);
    let negative = (ln.c.y >> 31u) != 0u;
    if (!ltu64(magnitude, shl64(vec2<u32>(corner, 0u), h))) {
        return select(CELL_ALL, CELL_NONE, negative);
    }
    let half = 1u << (k - 1u);
    let part = udiv64_32(shr64(shl64(magnitude, k - 1u), h), corner).x;
    let distance = select(half + part, half - 1u - part, negative);
    return ((atan2_bam(ln.b, ln.a) >> (32u - k)) << k) | distance;
}
