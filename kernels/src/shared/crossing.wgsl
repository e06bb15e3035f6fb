// Where a plane through a receiver cuts the rows of a light, exactly.
//
// A linear function of the source plane is given by its normal and a point on its zero plane; along one light row it is
// E(k) = start + k * slope * step. Coordinates are those of the grid (`grid.rs`): differences below 2^15 in magnitude,
// so every component of a normal is below 2^31, and E below 2^48.

import package::shared::wide::{imul_wide, add64, neg64};

/// E(k) = start + k * (slope * step), start a signed 64-bit integer.
struct Function {
    slope: i32,
    start: vec2<u32>,
}

/// Normal of the plane through r and the edge p q.
fn edge_function(r: vec3<i32>, p: vec3<i32>, q: vec3<i32>) -> vec3<i32> {
    let d = p - r;
    let e = q - r;
    return vec3<i32>(d.y * e.z - d.z * e.y, d.z * e.x - d.x * e.z, d.x * e.y - d.y * e.x);
}

/// n . ((u + k step, v, 0) - origin) as a function of k.
fn along_row(n: vec3<i32>, origin: vec3<i32>, u: i32, v: i32) -> Function {
    let xy = add64(imul_wide(n.x, u - origin.x), imul_wide(n.y, v - origin.y));
    return Function(n.x, add64(xy, imul_wide(n.z, 0 - origin.z)));
}

/// The least k in [0, count] with E(k) >= 0, for E or -E, whichever grows; by bisection.
fn first_inside(f: Function, step: i32, count: u32) -> u32 {
    let falls = f.slope < 0;
    let slope = select(f.slope, 0 - f.slope, falls);
    let start = select(f.start, neg64(f.start), falls);
    var low = 0u;
    var high = count;
    while (low < high) {
        let k = (low + high) >> 1u;
        let value = add64(start, imul_wide(slope, step * bitcast<i32>(k)));
        if ((value.y >> 31u) == 0u) {
            high = k;
        } else {
            low = k + 1u;
        }
    }
    return low;
}
