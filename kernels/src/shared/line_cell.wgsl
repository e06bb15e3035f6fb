// Cells of the L1 ("diamond") line space: where a table keeps what it knows of all lines near one another.
//
// A line a u + b v + c = 0 is scaled to |a| + |b| = 1. Its direction is |b| in one of two quadrants, its offset is c by
// the half side 2^h of the centred square of samples. Both axes are piecewise linear in the line, so no trigonometry is
// needed, and the value at a sample is affine in each: its extremes over a cell are at the corners.
//
// A cell is flip << 31 | quadrant << (2k + 1) | direction << (k + 1) | offset, direction of k bits, offset of k + 1.

import package::shared::fraction::ufrac;
import package::shared::line::{Line, line_flip};
import package::shared::wide::{abs64, ltu64, shl64, shr64, uabs};

/// The half-plane covers the whole square.
const CELL_ALL: u32 = 0xffffffffu;
/// It covers none of it.
const CELL_NONE: u32 = 0xfffffffeu;

/// The cell of a half-plane. |a|, |b| < 2^31, any c, h <= 15, k <= 14. Where |c| >= 2^h (|a| + |b|) it is `CELL_ALL` or
/// `CELL_NONE` by the sign of c. Else, with |b|, |c| / 2^h and |a| + |b| scaled by one power of two so that the last
/// has 30 bits, the scaled values rounded down to B, C and D, and C negative where the canonical line's c is: direction
/// = min(floor(2^k B / D), 2^k - 1), offset = min(floor(2^k (1 + C / D)), 2^(k + 1) - 1); flip is `line_flip`, and
/// quadrant is 1 where the canonical line has b < 0.
fn line_cell(ln: Line, h: u32, k: u32) -> u32 {
    let ab = uabs(ln.b);
    let n1 = uabs(ln.a) + ab;
    let ac = abs64(ln.c);
    let negative = (ln.c.y >> 31u) != 0u;
    if (!ltu64(ac, shl64(vec2<u32>(n1, 0u), h))) {
        return select(CELL_ALL, CELL_NONE, negative);
    }
    let flip = line_flip(ln);
    let s = countLeadingZeros(n1);
    let d = (n1 << s) >> 2u; // in [2^29, 2^30)
    let m = ufrac((ab << s) >> 2u, d, k);
    let o = ufrac(shr64(shl64(ac, s), h + 2u).x, d, k);
    let one = 1u << k;
    let direction = min(m.x, one - 1u);
    let offset = select(one + o.x, one - o.x - select(0u, 1u, o.y != 0u), negative != flip);
    return pack_cell(ln, k, direction, min(offset, 2u * one - 1u));
}

fn pack_cell(ln: Line, k: u32, direction: u32, offset: u32) -> u32 {
    let flip = line_flip(ln);
    let quadrant = ((ln.b < 0) != flip) & (ln.b != 0);
    let index = (((select(0u, 1u, quadrant) << k) | direction) << (k + 1u)) | offset;
    return (select(0u, 1u, flip) << 31u) | index;
}

/// A cell that holds the line once it is widened on every side by max(2^-10, 2^(k - 16)) of a cell; which one may
/// differ from device to device. Only for tables whose entries allow for that slack and mark the samples in doubt,
/// which `half_plane` then decides: the final mask does not depend on the cell. Domain as `line_cell`.
/// float: filter - a total relative error below 2^-18 stays within the slack; doubtful samples are decided in integers
fn line_cell_fast(ln: Line, h: u32, k: u32) -> u32 {
    let one = 1u << k;
    let ab = uabs(ln.b);
    let n1 = uabs(ln.a) + ab;
    let ac = abs64(ln.c);
    let negative = (ln.c.y >> 31u) != 0u;
    let inv = f32(one) / f32(max(n1, 1u));
    let o = (f32(ac.y) * 4294967296.0 + f32(ac.x)) * inv / f32(1u << h);
    // The margin of 2^-17 exceeds the error, so that only what is outside is taken to be outside; both together are
    // less than the slack.
    if ((n1 == 0u) | (o > f32(one) * 1.00000762939453125)) {
        return select(CELL_ALL, CELL_NONE, negative);
    }
    let direction = min(u32(f32(ab) * inv), one - 1u);
    let p = u32(o);
    let offset = select(min(one + p, 2u * one - 1u), one - 1u - min(p, one - 1u), negative != line_flip(ln));
    return pack_cell(ln, k, direction, offset);
}
