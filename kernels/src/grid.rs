//! Workgroups in one line, folded into rows where a device allows no longer line.
//!
//! The WGSL side is `shared/grid.wgsl`. Invariant: a line has at least one workgroup, so that a kernel is launched, and
//! shown to write nothing, even for no items.

/// Most workgroups that a device accepts in one dimension.
pub const MAX_GROUPS: u32 = 65_535;

/// Dispatch size for `items` items, `per_group` for each workgroup. The last row may run past the end of the line.
pub fn line(items: u64, per_group: u32) -> [u32; 3] {
    let groups = items.div_ceil(u64::from(per_group)).max(1);
    let rows = groups.div_ceil(u64::from(MAX_GROUPS));
    [groups.div_ceil(rows) as u32, rows as u32, 1]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_covers_its_items_within_the_limit() {
        for (items, expected) in [
            (0, [1, 1, 1]),
            (1, [1, 1, 1]),
            (256, [1, 1, 1]),
            (257, [2, 1, 1]),
            (65_535 * 256, [65_535, 1, 1]),
            (65_535 * 256 + 1, [32_768, 2, 1]),
        ] {
            assert_eq!(line(items, 256), expected, "{items} items");
        }
    }
}
