// The side of a line that a point is on.

import package::shared::wide::{imul_wide, sgn64, sub64};

/// Sign of (b - a) x (c - a): 1 where a, b, c turn counter-clockwise, 0 where they are collinear. Coordinates are in
/// [-2^30, 2^30). Odd: exchanging two points negates it.
fn orient2d(a: vec2<i32>, b: vec2<i32>, c: vec2<i32>) -> i32 {
    let l = imul_wide(b.x - a.x, c.y - a.y);
    let r = imul_wide(b.y - a.y, c.x - a.x);
    return sgn64(sub64(l, r));
}
