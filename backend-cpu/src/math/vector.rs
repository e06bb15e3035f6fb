//! Vectors and matrices of f32: the order of every sum, fixed.
//!
//! Components are slices of 1 to 4 f32; a matrix is a slice of columns. Everything component-wise is left to the scalar
//! functions. Invariant: each sum runs from component 0 upward, each product is rounded before it is added.

/// `dot(x, y)`: ((x₀y₀ + x₁y₁) + x₂y₂) + x₃y₃, unfused; also rows of matrix products.
#[must_use]
pub fn dot(x: &[f32], y: &[f32]) -> f32 {
    let mut products = x.iter().zip(y).map(|(x, y)| x * y);
    let first = products.next().unwrap_or(0.0);
    products.fold(first, |sum, product| sum + product)
}

/// `length(x)`: √dot(x, x); |x| of a scalar.
#[must_use]
pub fn length(x: &[f32]) -> f32 {
    match x {
        [x] => x.abs(),
        _ => dot(x, x).sqrt(),
    }
}

/// `distance(x, y)`: `length(x - y)`.
#[must_use]
pub fn distance(x: &[f32], y: &[f32]) -> f32 {
    length(&x.iter().zip(y).map(|(x, y)| x - y).collect::<Vec<_>>())
}

/// `normalize(x)`: each component divided by `length(x)`; the zero vector gives NaN.
#[must_use]
pub fn normalize(x: &[f32]) -> Vec<f32> {
    let length = length(x);
    x.iter().map(|x| x / length).collect()
}

/// `cross(x, y)`: (x₁y₂ − x₂y₁, x₂y₀ − x₀y₂, x₀y₁ − x₁y₀), unfused.
#[must_use]
pub fn cross(x: [f32; 3], y: [f32; 3]) -> [f32; 3] {
    [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]]
}

/// `faceForward(x, y, z)`: x where dot(y, z) < 0, else −x.
#[must_use]
pub fn face_forward(x: &[f32], y: &[f32], z: &[f32]) -> Vec<f32> {
    let keep = dot(y, z) < 0.0;
    x.iter().map(|&x| if keep { x } else { -x }).collect()
}

/// `reflect(x, n)`: x − (2·dot(n, x))·n.
#[must_use]
pub fn reflect(x: &[f32], n: &[f32]) -> Vec<f32> {
    let twice = 2.0 * dot(n, x);
    x.iter().zip(n).map(|(x, n)| x - twice * n).collect()
}

/// `refract(x, n, eta)`: with d = dot(n, x) and k = 1 − eta·eta·(1 − d·d), zero where k < 0, else
/// eta·x − (eta·d + √k)·n.
#[must_use]
pub fn refract(x: &[f32], n: &[f32], eta: f32) -> Vec<f32> {
    let d = dot(n, x);
    let k = 1.0 - eta * eta * (1.0 - d * d);
    if k < 0.0 {
        return vec![0.0; x.len()];
    }
    let along = eta * d + k.sqrt();
    x.iter().zip(n).map(|(x, n)| eta * x - along * n).collect()
}

/// `determinant(m)` of 2 to 4 columns, by the first column.
///
/// * 2: a₀b₁ − b₀a₁ for columns a, b.
/// * 3: dot(a, cross(b, c)).
/// * 4: ((a₀M₀ − a₁M₁) + a₂M₂) − a₃M₃, where Mᵢ is the determinant of the other columns without row i.
#[must_use]
pub fn determinant(columns: &[Vec<f32>]) -> f32 {
    match columns {
        [a, b] => a[0] * b[1] - b[0] * a[1],
        [a, b, c] => dot(a, &cross([b[0], b[1], b[2]], [c[0], c[1], c[2]])),
        [a, rest @ ..] => {
            let minor = |row: usize| {
                let without = |c: &Vec<f32>| c.iter().enumerate().filter(|&(i, _)| i != row).map(|(_, &x)| x).collect();
                determinant(&rest.iter().map(without).collect::<Vec<_>>())
            };
            a[0] * minor(0) - a[1] * minor(1) + a[2] * minor(2) - a[3] * minor(3)
        }
        [] => 1.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_run_upward() {
        assert_eq!(dot(&[1e8, 1.0, -1e8], &[1.0, 1.0, 1.0]), 0.0);
        assert_eq!(dot(&[1e8, -1e8, 1.0], &[1.0, 1.0, 1.0]), 1.0);
        assert_eq!(dot(&[-0.0], &[1.0]).to_bits(), 0x8000_0000);
    }

    #[test]
    fn lengths() {
        assert_eq!([length(&[-2.5]), length(&[3.0, 4.0]), distance(&[1.0, 1.0], &[4.0, 5.0])], [2.5, 5.0, 5.0]);
        assert_eq!(normalize(&[0.0, 3.0, 4.0]), [0.0, 0.6, 0.8]);
        assert!(normalize(&[0.0, 0.0])[0].is_nan());
    }

    #[test]
    fn geometry() {
        assert_eq!(cross([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]), [0.0, 0.0, 1.0]);
        assert_eq!(face_forward(&[1.0, 2.0], &[1.0, 0.0], &[1.0, 0.0]), [-1.0, -2.0]);
        assert_eq!(reflect(&[1.0, -1.0], &[0.0, 1.0]), [1.0, 1.0]);
        assert_eq!(refract(&[0.0, -1.0], &[0.0, 1.0], 0.5), [0.0, -1.0]);
        assert_eq!(refract(&[1.0, 0.0], &[0.0, 1.0], 2.0), [0.0, 0.0]);
    }

    #[test]
    fn determinants() {
        let columns = |m: &[&[f32]]| m.iter().map(|c| c.to_vec()).collect::<Vec<_>>();
        assert_eq!(determinant(&columns(&[&[1.0, 2.0], &[3.0, 4.0]])), -2.0);
        assert_eq!(determinant(&columns(&[&[2.0, 0.0, 1.0], &[1.0, 3.0, 0.0], &[0.0, 1.0, 4.0]])), 25.0);
        let four: [&[f32]; 4] =
            [&[1.0, 2.0, 3.0, 4.0], &[2.0, 1.0, 4.0, 3.0], &[0.0, 1.0, 1.0, 2.0], &[3.0, 0.0, 2.0, 1.0]];
        assert_eq!(determinant(&columns(&four)), -2.0);
    }
}
