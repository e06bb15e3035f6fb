//! Affine maps: where a node stands, and how the vertices of a mesh come into the scene.

use crate::vector::{Vector, add, cross, dot, scale};

/// An affine map: the images of the three axes, and of the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Affine(pub [[f64; 3]; 4]);

impl Affine {
    /// The map that moves nothing.
    pub const IDENTITY: Affine = Affine([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0; 3]]);

    /// A uniform scale about the origin, then a shift.
    pub fn placed(size: f64, at: [f64; 3]) -> Self {
        Affine([[size, 0.0, 0.0], [0.0, size, 0.0], [0.0, 0.0, size], at])
    }

    /// A turn by a quaternion (x, y, z, w) of length 1, after a scale along each axis, then a shift.
    pub fn decomposed(translation: [f64; 3], [x, y, z, w]: [f64; 4], size: [f64; 3]) -> Self {
        let axes = [
            [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + z * w), 2.0 * (x * z - y * w)],
            [2.0 * (x * y - z * w), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + x * w)],
            [2.0 * (x * z + y * w), 2.0 * (y * z - x * w), 1.0 - 2.0 * (x * x + y * y)],
        ];
        let axis = |i: usize| scale(axes[i], size[i]);
        Affine([axis(0), axis(1), axis(2), translation])
    }

    /// The image of a direction.
    pub fn linear(&self, [x, y, z]: Vector) -> Vector {
        add(add(scale(self.0[0], x), scale(self.0[1], y)), scale(self.0[2], z))
    }

    /// Whether what turned counter-clockwise turns clockwise.
    pub fn mirrors(&self) -> bool {
        let [a, b, c, _] = self.0;
        dot(cross(a, b), c) < 0.0
    }

    /// The image of a normal, of another length: by the transposed inverse but for the determinant's magnitude.
    pub fn normal(&self, [x, y, z]: Vector) -> Vector {
        let [a, b, c, _] = self.0;
        let turned = add(add(scale(cross(b, c), x), scale(cross(c, a), y)), scale(cross(a, b), z));
        scale(turned, if self.mirrors() { -1.0 } else { 1.0 })
    }

    /// The image of a point.
    pub fn apply(&self, point: Vector) -> Vector {
        add(self.linear(point), self.0[3])
    }

    /// `inner` first, then this.
    pub fn then(&self, inner: &Affine) -> Affine {
        let [a, b, c, origin] = inner.0;
        Affine([self.linear(a), self.linear(b), self.linear(c), self.apply(origin)])
    }
}
