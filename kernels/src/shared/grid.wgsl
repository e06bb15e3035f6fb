// Workgroups in one line. A dispatch has at most 65,535 workgroups a dimension, so the host folds a longer line into
// rows; the last row may run past its end, and every kernel that uses this stops there by its own count.

/// Place of a workgroup in the line.
fn line_of_groups(group: vec3<u32>, groups: vec3<u32>) -> u32 {
    return group.y * groups.x + group.x;
}
