//! The algebra of the predicates, on shrinking random inputs: what makes shared edges watertight.
//!
//! The definitions are checked here; that the WGSL is equal to them is the self-test's part.

use proptest::prelude::*;
use sightlines_kernels::exact::oracle::angle::{atan2_bam, diamond_angle};
use sightlines_kernels::exact::oracle::line::{self, Line, admissible, edge_line, half_plane, line_cell};
use sightlines_kernels::exact::oracle::plane::{self, edge15, orient2d};

/// Coordinates of all magnitudes below 2^bits, so that coincidences happen.
fn coordinate(bits: u32) -> impl Strategy<Value = i32> {
    let limit = 1 << bits;
    prop_oneof![-3..=3, -100..100, -limit..limit]
}

fn point(bits: u32) -> impl Strategy<Value = plane::Point> {
    [coordinate(bits), coordinate(bits)]
}

/// A point of the rasteriser's grid.
fn pixel() -> impl Strategy<Value = plane::Point> {
    let coordinate = || prop_oneof![0..6, 0..1 << 15];
    [coordinate(), coordinate()]
}

fn grid_point() -> impl Strategy<Value = line::Point> {
    let z = prop_oneof![0..4, 0..1 << 15];
    (coordinate(14), coordinate(14), z).prop_map(|(x, y, z)| [x, y, z])
}

fn any_line() -> impl Strategy<Value = Line> {
    let c = prop_oneof![-3..=3_i64, -(1_i64 << 30)..1 << 30, -(1_i64 << 61)..1 << 61];
    (coordinate(30), coordinate(30), c).prop_map(|(a, b, c)| Line { a, b, c })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 4096, max_global_rejects: 65_536, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn exchanging_two_points_negates_the_orientation(a in point(30), b in point(30), c in point(30)) {
        prop_assert_eq!(orient2d(a, b, c), -orient2d(b, a, c));
        prop_assert_eq!(orient2d(a, b, c), -orient2d(a, c, b));
        prop_assert_eq!(orient2d(a, b, c), orient2d(b, c, a));
    }

    #[test]
    fn a_pixel_is_on_exactly_one_side_of_an_edge(a in pixel(), b in pixel(), p in pixel()) {
        prop_assume!(a != b);
        prop_assert!((edge15(a, b, p) >= 0) != (edge15(b, a, p) >= 0));
    }

    #[test]
    fn triangles_of_one_edge_never_share_a_pixel(a in pixel(), b in pixel(), c in pixel(), d in pixel(), p in pixel()) {
        prop_assume!(orient2d(a, b, c) > 0 && orient2d(b, a, d) > 0);
        let inside = |t: [plane::Point; 3]| (0..3).all(|i| edge15(t[i], t[(i + 1) % 3], p) >= 0);
        prop_assert!(!(inside([a, b, c]) && inside([b, a, d])));
    }

    #[test]
    fn negating_a_line_complements_its_half_plane(line in any_line(), u in coordinate(29), v in coordinate(29)) {
        prop_assume!((line.a, line.b) != (0, 0));
        prop_assert!(half_plane(line, u, v) != half_plane(line.negated(), u, v));
        // The same for samples on the line.
        let value = i64::from(line.a) * i64::from(u) + i64::from(line.b) * i64::from(v);
        let through = Line { c: -value, ..line };
        prop_assert!(half_plane(through, u, v) != half_plane(through.negated(), u, v));
    }

    #[test]
    fn reversing_an_edge_complements_its_mask(r in grid_point(), v1 in grid_point(), v2 in grid_point()) {
        let (edge, reversed) = (edge_line(r, v1, v2), edge_line(r, v2, v1));
        prop_assert_eq!(reversed, edge.negated());
        prop_assume!((edge.a, edge.b) != (0, 0));
        let mask = |line| (0..64).fold(0_u64, |mask, s| {
            mask | u64::from(half_plane(line, (s % 8 - 4) * 512, (s / 8 - 4) * 512)) << s
        });
        prop_assert_eq!(mask(edge), !mask(reversed));
    }

    #[test]
    fn an_edge_seen_end_on_has_no_line(r in grid_point(), v in grid_point(), t in -8..8) {
        let end = [0, 1, 2].map(|axis| r[axis] + (v[axis] - r[axis]) * t);
        prop_assert_eq!(edge_line(r, v, end), Line { a: 0, b: 0, c: 0 });
    }

    #[test]
    fn a_line_is_in_its_own_cell(line in any_line(), h in 0..16_u32, k in 0..15_u32) {
        let cell = line_cell(line, h, k);
        prop_assert!(admissible(line, h, k, cell));
        if cell < line::NONE && (line.a, line.b) != (0, 0) && line.c != 0 {
            // The canonical line is the same for both sides, and so is its place in the table.
            prop_assert_eq!(line_cell(line.negated(), h, k), cell ^ 1 << 31);
        }
    }

    #[test]
    fn angles_are_odd(y in any::<i32>(), x in any::<i32>()) {
        prop_assert_eq!(atan2_bam(y.wrapping_neg(), x), atan2_bam(y, x).wrapping_neg().wrapping_add(
            // The negation of -2^31 is itself.
            if y == i32::MIN { atan2_bam(y, x).wrapping_mul(2) } else { 0 }
        ));
        let (y, x) = (y >> 2, x >> 2);
        prop_assert_eq!(diamond_angle(-y, x), diamond_angle(y, x).wrapping_neg() % (1 << 22));
    }
}
