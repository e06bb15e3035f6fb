// Division and remainder are total: x / 0 is x, x % 0 is 0, and the one overflow wraps.

fn div_i32(x: i32, y: i32) -> i32 { return x / y; }
// run: div_i32(7i, 2i) == 3i
// run: div_i32(-7i, 2i) == -3i
