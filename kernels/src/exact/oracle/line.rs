//! Lines of the source plane, and the cells of their table, in 128-bit integers.

/// A point of the grid.
pub type Point = [i32; 3];

/// a u + b v + c >= 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Line {
    /// Coefficient of u.
    pub a: i32,
    /// Coefficient of v.
    pub b: i32,
    /// The value at the origin.
    pub c: i64,
}

impl Line {
    /// The other side. a and b are above -2^31.
    #[must_use]
    pub fn negated(self) -> Self {
        Line { a: -self.a, b: -self.b, c: self.c.wrapping_neg() }
    }

    /// Whether a < 0, or a = 0 and b < 0.
    pub fn is_flipped(self) -> bool {
        (self.a, self.b) < (0, 0)
    }

    /// |a| + |b|.
    fn norm(self) -> i128 {
        i128::from(self.a).abs() + i128::from(self.b).abs()
    }

    /// c of whichever of the two sides is canonical.
    fn canonical_c(self) -> i128 {
        if self.is_flipped() { -i128::from(self.c) } else { self.c.into() }
    }

    /// Whether the canonical side has b < 0.
    fn quadrant(self) -> bool {
        self.b != 0 && (self.b < 0) != self.is_flipped()
    }
}

fn determinant(d: [i128; 3], e: [i128; 3], f: [i128; 3]) -> i128 {
    d[0] * (e[1] * f[2] - e[2] * f[1]) + d[1] * (e[2] * f[0] - e[0] * f[2]) + d[2] * (e[0] * f[1] - e[1] * f[0])
}

/// The line whose value at (u, v) is the determinant of v1 - r, v2 - r and (u, v, 0) - r.
pub fn edge_line(r: Point, v1: Point, v2: Point) -> Line {
    let from_r = |p: Point| [0, 1, 2].map(|axis| i128::from(p[axis]) - i128::from(r[axis]));
    let value = |u, v| determinant(from_r(v1), from_r(v2), from_r([u, v, 0]));
    let c = value(0, 0);
    Line { a: (value(1, 0) - c) as i32, b: (value(0, 1) - c) as i32, c: c as i64 }
}

/// Whether sample (u, v) is in the half-plane; on the line it is in the canonical one.
pub fn half_plane(line: Line, u: i32, v: i32) -> bool {
    let value = i128::from(line.a) * i128::from(u) + i128::from(line.b) * i128::from(v) + i128::from(line.c);
    value > 0 || value == 0 && !line.is_flipped()
}

/// Cell of a half-plane that covers the whole square.
pub const ALL: u32 = u32::MAX;
/// Cell of a half-plane that covers none of it.
pub const NONE: u32 = u32::MAX - 1;

/// The line's cell in a table of 2^k directions in two quadrants and 2^(k + 1) offsets over [-2^h, 2^h]^2, after |b|,
/// |c| and |a| + |b| have been cut to 30 bits.
pub fn line_cell(line: Line, h: u32, k: u32) -> u32 {
    let norm = line.norm();
    if i128::from(line.c).abs() >= norm << h {
        return if line.c < 0 { NONE } else { ALL };
    }
    let s = (norm as u32).leading_zeros();
    let cut = |x: i128, halvings: u32| x.abs() << s >> (halvings + 2);
    let d = cut(norm, 0);
    let c = cut(line.c.into(), h) * line.canonical_c().signum();
    let direction = (cut(line.b.into(), 0) << k).div_euclid(d).min((1 << k) - 1);
    let offset = ((d + c) << k).div_euclid(d).min((2 << k) - 1);
    u32::from(line.is_flipped()) << 31
        | u32::from(line.quadrant()) << (2 * k + 1)
        | (direction as u32) << (k + 1)
        | offset as u32
}

/// Whether `line_cell_fast` may return that cell: it holds the line once it is widened on every side by
/// max(2^-10, 2^(k - 16)) of a cell.
pub fn admissible(line: Line, h: u32, k: u32, cell: u32) -> bool {
    let norm = line.norm();
    if cell >= NONE {
        return i128::from(line.c).abs() >= norm << h && (cell == NONE) == (line.c < 0);
    }
    let named = cell >> 31 == u32::from(line.is_flipped()) && cell >> (2 * k + 1) & 1 == u32::from(line.quadrant());
    // Both axes in units of the slack, 2^-s of a cell, times their denominators.
    let s = 10.min(16 - k);
    let holds = |field: u32, bits: u32, value: i128, denominator: i128| {
        let low = i128::from(field & ((1 << bits) - 1)) << s;
        ((low - 1) * denominator..=(low + (1 << s) + 1) * denominator).contains(&(value << (k + s)))
    };
    named
        && norm > 0
        && holds(cell >> (k + 1), k, i128::from(line.b).abs(), norm)
        && holds(cell, k + 1, (norm << h) + line.canonical_c(), norm << h)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plane_through_the_receiver_cuts_the_source_where_it_should() {
        // Receiver above the origin; an edge parallel to y at x = 10, half-way down: its line is u = 20.
        let line = edge_line([0, 0, 100], [10, -5, 50], [10, 5, 50]);
        assert_eq!((line.b, line.c), (0, -20 * i64::from(line.a)));
        assert!(half_plane(line, 20, 7) != half_plane(line.negated(), 20, 7));
        assert_eq!(half_plane(line, 21, 0), line.a > 0);
    }

    #[test]
    fn cells_of_known_lines() {
        let cell = |a, b, c| line_cell(Line { a, b, c }, 4, 3);
        assert_eq!(cell(1, 0, 0), 8, "through the middle, direction 0");
        assert_eq!(cell(-1, 0, 0), 1 << 31 | 8);
        assert_eq!(cell(1, 1, 0), 4 << 4 | 8, "the diagonal");
        assert_eq!(cell(1, -1, -1), 1 << 7 | 4 << 4 | 7, "the other diagonal, just outside the middle");
        assert_eq!(cell(0, 5, 79), 7 << 4 | 15);
        assert_eq!((cell(0, 5, 80), cell(0, 5, -80), cell(0, 0, 0)), (ALL, NONE, ALL));
    }

    #[test]
    fn a_cell_is_admissible_and_those_further_off_are_not() {
        let line = Line { a: 3_000, b: -1_700, c: 12_345 };
        let cell = line_cell(line, 6, 5);
        assert!(admissible(line, 6, 5, cell));
        for wrong in [cell + 2, cell - 2, cell + (2 << 6), cell ^ 1 << 11, cell ^ 1 << 31, ALL, NONE] {
            assert!(!admissible(line, 6, 5, wrong), "{wrong:#x}");
        }
        // On a boundary both neighbours hold it.
        let line = Line { a: 1, b: 0, c: 2 };
        assert_eq!(line_cell(line, 4, 3), 9);
        assert!(admissible(line, 4, 3, 9) && admissible(line, 4, 3, 8) && !admissible(line, 4, 3, 7));
    }
}
