// Where the shadow of a coordinate may fall: the receiver's texels that a source segment reaches through it.

import package::shared::divide::fdiv64_sat;
import package::shared::wide::{add64, imul_wide, sub64};

/// First and last column, 2^t grid units wide, of the receiver plane z = hz that lines from the source segment [-s, s]
/// at z = 0 reach through coordinate v at height vz: the floors of (v hz -+ s (hz - vz)) / (vz 2^t). 0 < vz <= hz <
/// 2^15, |v|, |s| < 2^15, t <= 16.
fn influence_1d(v: i32, vz: i32, hz: i32, s: i32, t: u32) -> vec2<i32> {
    let through = imul_wide(v, hz);
    let spread = imul_wide(s, hz - vz);
    let d = bitcast<u32>(vz) << t;
    return vec2<i32>(fdiv64_sat(sub64(through, spread), d), fdiv64_sat(add64(through, spread), d));
}
