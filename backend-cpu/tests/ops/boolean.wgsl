// Logic on bool, select, all, any.

fn and(x: bool, y: bool) -> bool { return x & y; }
// run: and(false, false) == false
// run: and(false, true) == false
// run: and(true, false) == false
// run: and(true, true) == true

fn and_vec4(x: vec4<bool>, y: vec4<bool>) -> vec4<bool> { return x & y; }
// run: and_vec4(vec4<bool>(false, false, true, true), vec4<bool>(false, true, false, true)) == vec4<bool>(false, false, false, true)

fn or(x: bool, y: bool) -> bool { return x | y; }
// run: or(false, false) == false
// run: or(false, true) == true
// run: or(true, false) == true
// run: or(true, true) == true

fn or_vec4(x: vec4<bool>, y: vec4<bool>) -> vec4<bool> { return x | y; }
// run: or_vec4(vec4<bool>(false, false, true, true), vec4<bool>(false, true, false, true)) == vec4<bool>(false, true, true, true)

fn eq(x: bool, y: bool) -> bool { return x == y; }
// run: eq(false, false) == true
// run: eq(false, true) == false
// run: eq(true, false) == false
// run: eq(true, true) == true

fn eq_vec4(x: vec4<bool>, y: vec4<bool>) -> vec4<bool> { return x == y; }
// run: eq_vec4(vec4<bool>(false, false, true, true), vec4<bool>(false, true, false, true)) == vec4<bool>(true, false, false, true)

fn ne(x: bool, y: bool) -> bool { return x != y; }
// run: ne(false, false) == false
// run: ne(false, true) == true
// run: ne(true, false) == true
// run: ne(true, true) == false

fn ne_vec4(x: vec4<bool>, y: vec4<bool>) -> vec4<bool> { return x != y; }
// run: ne_vec4(vec4<bool>(false, false, true, true), vec4<bool>(false, true, false, true)) == vec4<bool>(false, true, true, false)

fn land(x: bool, y: bool) -> bool { return x && y; }
// run: land(false, false) == false
// run: land(false, true) == false
// run: land(true, false) == false
// run: land(true, true) == true

fn lor(x: bool, y: bool) -> bool { return x || y; }
// run: lor(false, false) == false
// run: lor(false, true) == true
// run: lor(true, false) == true
// run: lor(true, true) == true

fn not_bool(x: bool) -> bool { return !x; }
// run: not_bool(false) == true
// run: not_bool(true) == false

fn not_vec2(x: vec2<bool>) -> vec2<bool> { return !x; }
// run: not_vec2(vec2<bool>(true, false)) == vec2<bool>(false, true)

fn all_vec2(x: vec2<bool>) -> bool { return all(x); }
// run: all_vec2(vec2<bool>(false, false)) == false
// run: all_vec2(vec2<bool>(true, false)) == false
// run: all_vec2(vec2<bool>(false, true)) == false
// run: all_vec2(vec2<bool>(true, true)) == true

fn any_vec2(x: vec2<bool>) -> bool { return any(x); }
// run: any_vec2(vec2<bool>(false, false)) == false
// run: any_vec2(vec2<bool>(true, false)) == true
// run: any_vec2(vec2<bool>(false, true)) == true
// run: any_vec2(vec2<bool>(true, true)) == true

fn all_vec3(x: vec3<bool>) -> bool { return all(x); }
// run: all_vec3(vec3<bool>(false, false, false)) == false
// run: all_vec3(vec3<bool>(true, false, false)) == false
// run: all_vec3(vec3<bool>(false, true, false)) == false
// run: all_vec3(vec3<bool>(true, true, false)) == false
// run: all_vec3(vec3<bool>(false, false, true)) == false
// run: all_vec3(vec3<bool>(true, false, true)) == false
// run: all_vec3(vec3<bool>(false, true, true)) == false
// run: all_vec3(vec3<bool>(true, true, true)) == true

fn any_vec3(x: vec3<bool>) -> bool { return any(x); }
// run: any_vec3(vec3<bool>(false, false, false)) == false
// run: any_vec3(vec3<bool>(true, false, false)) == true
// run: any_vec3(vec3<bool>(false, true, false)) == true
// run: any_vec3(vec3<bool>(true, true, false)) == true
// run: any_vec3(vec3<bool>(false, false, true)) == true
// run: any_vec3(vec3<bool>(true, false, true)) == true
// run: any_vec3(vec3<bool>(false, true, true)) == true
// run: any_vec3(vec3<bool>(true, true, true)) == true

fn all_vec4(x: vec4<bool>) -> bool { return all(x); }
// run: all_vec4(vec4<bool>(false, false, false, false)) == false
// run: all_vec4(vec4<bool>(true, false, false, false)) == false
// run: all_vec4(vec4<bool>(false, true, false, false)) == false
// run: all_vec4(vec4<bool>(true, true, false, false)) == false
// run: all_vec4(vec4<bool>(false, false, true, false)) == false
// run: all_vec4(vec4<bool>(true, false, true, false)) == false
// run: all_vec4(vec4<bool>(false, true, true, false)) == false
// run: all_vec4(vec4<bool>(true, true, true, false)) == false
// run: all_vec4(vec4<bool>(false, false, false, true)) == false
// run: all_vec4(vec4<bool>(true, false, false, true)) == false
// run: all_vec4(vec4<bool>(false, true, false, true)) == false
// run: all_vec4(vec4<bool>(true, true, false, true)) == false
// run: all_vec4(vec4<bool>(false, false, true, true)) == false
// run: all_vec4(vec4<bool>(true, false, true, true)) == false
// run: all_vec4(vec4<bool>(false, true, true, true)) == false
// run: all_vec4(vec4<bool>(true, true, true, true)) == true

fn any_vec4(x: vec4<bool>) -> bool { return any(x); }
// run: any_vec4(vec4<bool>(false, false, false, false)) == false
// run: any_vec4(vec4<bool>(true, false, false, false)) == true
// run: any_vec4(vec4<bool>(false, true, false, false)) == true
// run: any_vec4(vec4<bool>(true, true, false, false)) == true
// run: any_vec4(vec4<bool>(false, false, true, false)) == true
// run: any_vec4(vec4<bool>(true, false, true, false)) == true
// run: any_vec4(vec4<bool>(false, true, true, false)) == true
// run: any_vec4(vec4<bool>(true, true, true, false)) == true
// run: any_vec4(vec4<bool>(false, false, false, true)) == true
// run: any_vec4(vec4<bool>(true, false, false, true)) == true
// run: any_vec4(vec4<bool>(false, true, false, true)) == true
// run: any_vec4(vec4<bool>(true, true, false, true)) == true
// run: any_vec4(vec4<bool>(false, false, true, true)) == true
// run: any_vec4(vec4<bool>(true, false, true, true)) == true
// run: any_vec4(vec4<bool>(false, true, true, true)) == true
// run: any_vec4(vec4<bool>(true, true, true, true)) == true

fn all_scalar(x: bool) -> bool { return all(x); }
// run: all_scalar(true) == true
// run: all_scalar(false) == false

fn any_scalar(x: bool) -> bool { return any(x); }
// run: any_scalar(true) == true
// run: any_scalar(false) == false

fn select_bool(x: bool, y: bool, c: bool) -> bool { return select(x, y, c); }
// run: select_bool(true, false, false) == true
// run: select_bool(true, false, true) == false

fn select_bool_vec3(x: vec3<bool>, y: vec3<bool>, c: vec3<bool>) -> vec3<bool> { return select(x, y, c); }
// run: select_bool_vec3(vec3<bool>(true, false, true), vec3<bool>(false, true, false), vec3<bool>(true, false, false)) == vec3<bool>(false, false, true)

fn select_bool_whole(x: vec3<bool>, y: vec3<bool>, c: bool) -> vec3<bool> { return select(x, y, c); }
// run: select_bool_whole(vec3<bool>(true, false, true), vec3<bool>(false, true, false), false) == vec3<bool>(true, false, true)
// run: select_bool_whole(vec3<bool>(true, false, true), vec3<bool>(false, true, false), true) == vec3<bool>(false, true, false)

fn select_i32(x: i32, y: i32, c: bool) -> i32 { return select(x, y, c); }
// run: select_i32(-5i, 9i, false) == -5i
// run: select_i32(-5i, 9i, true) == 9i

fn select_i32_vec3(x: vec3<i32>, y: vec3<i32>, c: vec3<bool>) -> vec3<i32> { return select(x, y, c); }
// run: select_i32_vec3(vec3<i32>(-5i, 9i, -5i), vec3<i32>(9i, -5i, 9i), vec3<bool>(true, false, false)) == vec3<i32>(9i, 9i, -5i)

fn select_i32_whole(x: vec3<i32>, y: vec3<i32>, c: bool) -> vec3<i32> { return select(x, y, c); }
// run: select_i32_whole(vec3<i32>(-5i, 9i, -5i), vec3<i32>(9i, -5i, 9i), false) == vec3<i32>(-5i, 9i, -5i)
// run: select_i32_whole(vec3<i32>(-5i, 9i, -5i), vec3<i32>(9i, -5i, 9i), true) == vec3<i32>(9i, -5i, 9i)

fn select_u32(x: u32, y: u32, c: bool) -> u32 { return select(x, y, c); }
// run: select_u32(0xffffffffu, 3u, false) == 0xffffffffu
// run: select_u32(0xffffffffu, 3u, true) == 3u

fn select_u32_vec3(x: vec3<u32>, y: vec3<u32>, c: vec3<bool>) -> vec3<u32> { return select(x, y, c); }
// run: select_u32_vec3(vec3<u32>(0xffffffffu, 3u, 0xffffffffu), vec3<u32>(3u, 0xffffffffu, 3u), vec3<bool>(true, false, false)) == vec3<u32>(3u, 3u, 0xffffffffu)

fn select_u32_whole(x: vec3<u32>, y: vec3<u32>, c: bool) -> vec3<u32> { return select(x, y, c); }
// run: select_u32_whole(vec3<u32>(0xffffffffu, 3u, 0xffffffffu), vec3<u32>(3u, 0xffffffffu, 3u), false) == vec3<u32>(0xffffffffu, 3u, 0xffffffffu)
// run: select_u32_whole(vec3<u32>(0xffffffffu, 3u, 0xffffffffu), vec3<u32>(3u, 0xffffffffu, 3u), true) == vec3<u32>(3u, 0xffffffffu, 3u)

fn select_f32(x: f32, y: f32, c: bool) -> f32 { return select(x, y, c); }
// run: select_f32(-0.0, 2.5, false) == -0.0
// run: select_f32(-0.0, 2.5, true) == 2.5

fn select_f32_vec3(x: vec3<f32>, y: vec3<f32>, c: vec3<bool>) -> vec3<f32> { return select(x, y, c); }
// run: select_f32_vec3(vec3<f32>(-0.0, 2.5, -0.0), vec3<f32>(2.5, -0.0, 2.5), vec3<bool>(true, false, false)) == vec3<f32>(2.5, 2.5, -0.0)

fn select_f32_whole(x: vec3<f32>, y: vec3<f32>, c: bool) -> vec3<f32> { return select(x, y, c); }
// run: select_f32_whole(vec3<f32>(-0.0, 2.5, -0.0), vec3<f32>(2.5, -0.0, 2.5), false) == vec3<f32>(-0.0, 2.5, -0.0)
// run: select_f32_whole(vec3<f32>(-0.0, 2.5, -0.0), vec3<f32>(2.5, -0.0, 2.5), true) == vec3<f32>(2.5, -0.0, 2.5)

fn short_circuit(x: u32, y: u32) -> bool { return y != 0u && x / y > 2u || x == 5u; }
// run: short_circuit(9u, 3u) == true
// run: short_circuit(9u, 5u) == false
// run: short_circuit(5u, 0u) == true
// run: short_circuit(4u, 0u) == false
// run: short_circuit(5u, 5u) == true
