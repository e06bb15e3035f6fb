// Lines of the source plane: where the plane through a receiver and an edge cuts it, and which samples lie on which
// side.

import package::shared::wide::{add64, dot64, imul_wide, neg64};

/// The half-plane a u + b v + c >= 0; c is a signed 64-bit number.
struct Line {
    a: i32,
    b: i32,
    c: vec2<u32>,
}

/// The plane through r, v1 and v2, cut with the source plane z = 0: a u + b v + c is the determinant of v1 - r, v2 - r
/// and (u, v, 0) - r. Coordinates are x, y in [-2^14, 2^14) and z in [0, 2^15); |a|, |b| < 2^31 and |c| < 2^48.
/// Exchanging v1 and v2 negates it.
fn edge_line(r: vec3<i32>, v1: vec3<i32>, v2: vec3<i32>) -> Line {
    let d = v1 - r;
    let e = v2 - r;
    let n = vec3<i32>(d.y * e.z - d.z * e.y, d.z * e.x - d.x * e.z, d.x * e.y - d.y * e.x);
    let c = dot64(n, r);
    return Line(n.x, n.y, neg64(c));
}

/// Whether a line is the negation of its canonical one, which has a > 0, or a = 0 and b >= 0.
fn line_flip(ln: Line) -> bool {
    return (ln.a < 0) | ((ln.a == 0) & (ln.b < 0));
}

/// Whether sample (u, v) is in the half-plane; on the line it is in the canonical one only. |a|, |b| < 2^31,
/// u, v in [-2^30, 2^30), |c| <= 2^62. Negating a line with (a, b) != 0 complements it.
fn half_plane(ln: Line, u: i32, v: i32) -> bool {
    let t = add64(add64(imul_wide(ln.a, u), imul_wide(ln.b, v)), ln.c);
    let zero = (t.x | t.y) == 0u;
    return select((t.y >> 31u) == 0u, !line_flip(ln), zero);
}
