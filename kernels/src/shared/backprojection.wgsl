// The backprojection of a triangle: the half-planes of the source plane whose intersection it hides from a receiver.
//
// Eisemann and Décoret, "Visibility Sampling on GPU and Applications", section 4, without its division: the plane
// through the receiver and an edge meets the source in a line, whatever the heights of the vertices, so a vertex at or
// beyond either plane is no special case. The triangle's own plane is a fourth half-plane. It holds all that the other
// three hold unless a vertex is on the source's plane: then a sample on the triangle is not hidden.

import package::shared::crossing::edge_function;
import package::shared::line::{Line, edge_line};
import package::shared::wide::{dot64, neg64, sgn64};

/// A sample is hidden if it is in all three edges' half-planes, ties as in `half_plane`, and strictly inside `own`.
struct Backprojection {
    first: Line,
    second: Line,
    third: Line,
    /// The triangle's plane, positive on the other side than the receiver.
    own: Line,
}

/// Of triangle a b c, seen from r in the order that turns its inner side to the positive side of every line. Of a
/// triangle whose plane holds r all four are the empty half-plane -1 >= 0. Differences of coordinates are below 2^15
/// and x, y below 2^15 in magnitude, z in [0, 2^15): then |a|, |b| < 2^31 and |c| < 2^48 for every line, and below 2^47
/// for `own` on the grid.
fn backproject(r: vec3<i32>, a: vec3<i32>, b: vec3<i32>, c: vec3<i32>) -> Backprojection {
    let n = edge_function(a, b, c);
    let orientation = sgn64(dot64(n, a - r));
    if (orientation == 0) {
        let none = Line(0, 0, vec2<u32>(0xffffffffu));
        return Backprojection(none, none, none, none);
    }
    let turned = orientation < 0;
    let p = select(b, c, turned);
    let q = select(c, b, turned);
    let outward = n * orientation;
    let own = Line(outward.x, outward.y, neg64(dot64(outward, a)));
    return Backprojection(edge_line(r, a, p), edge_line(r, p, q), edge_line(r, q, a), own);
}
