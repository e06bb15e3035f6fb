// A regular light and regular receivers on a plane parallel to it, as `grid.rs` describes them.

struct View {
    receiver_x: i32,
    receiver_y: i32,
    receiver_step_x: i32,
    receiver_step_y: i32,
    /// z of all receivers.
    height: i32,
    /// Receivers along x and y.
    columns: u32,
    rows: u32,
    sample_x: i32,
    sample_y: i32,
    sample_step_x: i32,
    sample_step_y: i32,
}

/// Receiver (column, row).
fn receiver_at(view: View, column: u32, row: u32) -> vec3<i32> {
    return vec3<i32>(
        view.receiver_x + view.receiver_step_x * bitcast<i32>(column),
        view.receiver_y + view.receiver_step_y * bitcast<i32>(row),
        view.height,
    );
}

/// y of a row of samples.
fn sample_row(view: View, row: u32) -> i32 {
    return view.sample_y + view.sample_step_y * bitcast<i32>(row);
}

/// The bits below k.
fn below(k: u32) -> u32 {
    return select((1u << k) - 1u, 0xffffffffu, k > 31u);
}
