// Divergence: iterations until escape, at most 256, on 256 by 256 points of the plane; lanes leave the loop one by one.

@group(0) @binding(0) var<storage, read_write> results: array<u32>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3<u32>) {
    let cx = f32(id.x % 256u) * 0.0109375 - 2.2;
    let cy = f32(id.x / 256u) * 0.009375 - 1.2;
    var x = 0.0;
    var y = 0.0;
    var count = 0u;
    while count < 256u {
        let xx = x * x;
        let yy = y * y;
        if xx + yy > 4.0 {
            break;
        }
        let xy = x * y;
        y = xy + xy + cy;
        x = xx - yy + cx;
        count++;
    }
    results[id.x] = count;
}
