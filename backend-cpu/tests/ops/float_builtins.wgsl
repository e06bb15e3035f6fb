// abs, sign, min, max, clamp, saturate, step, mix, smoothstep, fma, degrees, radians, sqrt, inverseSqrt.

fn abs_f32(x: f32) -> f32 { return abs(x); }
// run: abs_f32(0.0) == 0.0
// run: abs_f32(-0.0) == 0.0
// run: abs_f32(0.5) == 0.5
// run: abs_f32(-0.5) == 0.5
// run: abs_f32(1.5) == 1.5
// run: abs_f32(2.5) == 2.5
// run: abs_f32(-1.5) == 1.5
// run: abs_f32(-2.5) == 2.5
// run: abs_f32(bitcast<f32>(0x7f800000u)) == bitcast<f32>(0x7f800000u)
// run: abs_f32(bitcast<f32>(0xff800000u)) == bitcast<f32>(0x7f800000u)

fn sign_f32(x: f32) -> f32 { return sign(x); }
// run: sign_f32(0.0) == 0.0
// run: sign_f32(3.5) == 1.0
// run: sign_f32(-2.0) == -1.0
// run: sign_f32(bitcast<f32>(0x00000001u)) == 1.0
// run: sign_f32(bitcast<f32>(0x80000001u)) == -1.0
// run: sign_f32(bitcast<f32>(0x7f800000u)) == 1.0
// run: sign_f32(bitcast<f32>(0xff800000u)) == -1.0

fn min_f32(x: f32, y: f32) -> f32 { return min(x, y); }
// run: min_f32(0.0, 0.0) == 0.0
// run: min_f32(0.0, -0.0) == 0.0
// run: min_f32(0.0, 1.0) == 0.0
// run: min_f32(0.0, -1.0) == -1.0
// run: min_f32(0.0, bitcast<f32>(0x7f800000u)) == 0.0
// run: min_f32(0.0, bitcast<f32>(0xff800000u)) == bitcast<f32>(0xff800000u)
// run: min_f32(0.0, bitcast<f32>(0x7fc00000u)) == 0.0
// run: min_f32(0.0, 0.1) == 0.0
// run: min_f32(0.0, bitcast<f32>(0x00000001u)) == 0.0
// run: min_f32(-0.0, 0.0) == -0.0
// run: min_f32(-0.0, -0.0) == -0.0
// run: min_f32(-0.0, 1.0) == -0.0
// run: min_f32(-0.0, -1.0) == -1.0
// run: min_f32(-0.0, bitcast<f32>(0x7f800000u)) == -0.0
// run: min_f32(-0.0, bitcast<f32>(0xff800000u)) == bitcast<f32>(0xff800000u)
// run: min_f32(-0.0, bitcast<f32>(0x7fc00000u)) == -0.0
// run: min_f32(-0.0, 0.1) == -0.0
// run: min_f32(-0.0, bitcast<f32>(0x00000001u)) == -0.0
// run: min_f32(1.0, 0.0) == 0.0
// run: min_f32(1.0, -0.0) == -0.0
// run: min_f32(1.0, 1.0) == 1.0
// run: min_f32(1.0, -1.0) == -1.0
// run: min_f32(1.0, bitcast<f32>(0x7f800000u)) == 1.0
// run: min_f32(1.0, bitcast<f32>(0xff800000u)) == bitcast<f32>(0xff800000u)
// run: min_f32(1.0, bitcast<f32>(0x7fc00000u)) == 1.0
// run: min_f32(1.0, 0.1) == 0.1
// run: min_f32(1.0, bitcast<f32>(0x00000001u)) == bitcast<f32>(0x00000001u)
// run: min_f32(-1.0, 0.0) == -1.0
// run: min_f32(-1.0, -0.0) == -1.0
// run: min_f32(-1.0, 1.0) == -1.0
// run: min_f32(-1.0, -1.0) == -1.0
// run: min_f32(-1.0, bitcast<f32>(0x7f800000u)) == -1.0
// run: min_f32(-1.0, bitcast<f32>(0xff800000u)) == bitcast<f32>(0xff800000u)
// run: min_f32(-1.0, bitcast<f32>(0x7fc00000u)) == -1.0
// run: min_f32(-1.0, 0.1) == -1.0
// run: min_f32(-1.0, bitcast<f32>(0x00000001u)) == -1.0
// run: min_f32(bitcast<f32>(0x7f800000u), 0.0) == 0.0
// run: min_f32(bitcast<f32>(0x7f800000u), -0.0) == -0.0
// run: min_f32(bitcast<f32>(0x7f800000u), 1.0) == 1.0
// run: min_f32(bitcast<f32>(0x7f800000u), -1.0) == -1.0
// run: min_f32(bitcast<f32>(0x7f800000u), bitcast<f32>(0x7f800000u)) == bitcast<f32>(0x7f800000u)
// run: min_f32(bitcast<f32>(0x7f800000u), bitcast<f32>(0xff800000u)) == bitcast<f32>(0xff800000u)
// run: min_f32(bitcast<f32>(0x7f800000u), bitcast<f32>(0x7fc00000u)) == bitcast<f32>(0x7f800000u)
// run: min_f32(bitcast<f32>(0x7f800000u), 0.1) == 0.1
// run: min_f32(bitcast<f32>(0x7f800000u), bitcast<f32>(0x00000001u)) == bitcast<f32>(0x00000001u)
// run: min_f32(bitcast<f32>(0xff800000u), 0.0) == bitcast<f32>(0xff800000u)
// run: min_f32(bitcast<f32>(0xff800000u), -0.0) == bitcast<f32>(0xff800000u)
// run: min_f32(bitcast<f32>(0xff800000u), 1.0) == bitcast<f32>(0xff800000u)
// run: min_f32(bitcast<f32>(0xff800000u), -1.0) == bitcast<f32>(0xff800000u)
// run: min_f32(bitcast<f32>(0xff800000u), bitcast<f32>(0x7f800000u)) == bitcast<f32>(0xff800000u)
// run: min_f32(bitcast<f32>(0xff800000u), bitcast<f32>(0xff800000u)) == bitcast<f32>(0xff800000u)
// run: min_f32(bitcast<f32>(0xff800000u), bitcast<f32>(0x7fc00000u)) == bitcast<f32>(0xff800000u)
// run: min_f32(bitcast<f32>(0xff800000u), 0.1) == bitcast<f32>(0xff800000u)
// run: min_f32(bitcast<f32>(0xff800000u), bitcast<f32>(0x00000001u)) == bitcast<f32>(0xff800000u)
// run: min_f32(bitcast<f32>(0x7fc00000u), 0.0) == 0.0
// run: min_f32(bitcast<f32>(0x7fc00000u), -0.0) == -0.0
// run: min_f32(bitcast<f32>(0x7fc00000u), 1.0) == 1.0
// run: min_f32(bitcast<f32>(0x7fc00000u), -1.0) == -1.0
// run: min_f32(bitcast<f32>(0x7fc00000u), bitcast<f32>(0x7f800000u)) == bitcast<f32>(0x7f800000u)
// run: min_f32(bitcast<f32>(0x7fc00000u), bitcast<f32>(0xff800000u)) == bitcast<f32>(0xff800000u)
// run: min_f32(bitcast<f32>(0x7fc00000u), bitcast<f32>(0x7fc00000u)) == nan
// run: min_f32(bitcast<f32>(0x7fc00000u), 0.1) == 0.1
// run: min_f32(bitcast<f32>(0x7fc00000u), bitcast<f32>(0x00000001u)) == bitcast<f32>(0x00000001u)
// run: min_f32(0.1, 0.0) == 0.0
// run: min_f32(0.1, -0.0) == -0.0
// run: min_f32(0.1, 1.0) == 0.1
// run: min_f32(0.1, -1.0) == -1.0
// run: min_f32(0.1, bitcast<f32>(0x7f800000u)) == 0.1
// run: min_f32(0.1, bitcast<f32>(0xff800000u)) == bitcast<f32>(0xff800000u)
// run: min_f32(0.1, bitcast<f32>(0x7fc00000u)) == 0.1
// run: min_f32(0.1, 0.1) == 0.1
// run: min_f32(0.1, bitcast<f32>(0x00000001u)) == bitcast<f32>(0x00000001u)
// run: min_f32(bitcast<f32>(0x00000001u), 0.0) == 0.0
// run: min_f32(bitcast<f32>(0x00000001u), -0.0) == -0.0
// run: min_f32(bitcast<f32>(0x00000001u), 1.0) == bitcast<f32>(0x00000001u)
// run: min_f32(bitcast<f32>(0x00000001u), -1.0) == -1.0
// run: min_f32(bitcast<f32>(0x00000001u), bitcast<f32>(0x7f800000u)) == bitcast<f32>(0x00000001u)
// run: min_f32(bitcast<f32>(0x00000001u), bitcast<f32>(0xff800000u)) == bitcast<f32>(0xff800000u)
// run: min_f32(bitcast<f32>(0x00000001u), bitcast<f32>(0x7fc00000u)) == bitcast<f32>(0x00000001u)
// run: min_f32(bitcast<f32>(0x00000001u), 0.1) == bitcast<f32>(0x00000001u)
// run: min_f32(bitcast<f32>(0x00000001u), bitcast<f32>(0x00000001u)) == bitcast<f32>(0x00000001u)

fn min_vec4(x: vec4<f32>, y: vec4<f32>) -> vec4<f32> { return min(x, y); }
// run: min_vec4(vec4<f32>(1.0, -2.0, 0.5, 7.0), vec4<f32>(0.5, -1.0, 0.75, -7.0)) == vec4<f32>(0.5, -2.0, 0.5, -7.0)

fn max_f32(x: f32, y: f32) -> f32 { return max(x, y); }
// run: max_f32(0.0, 0.0) == 0.0
// run: max_f32(0.0, -0.0) == 0.0
// run: max_f32(0.0, 1.0) == 1.0
// run: max_f32(0.0, -1.0) == 0.0
// run: max_f32(0.0, bitcast<f32>(0x7f800000u)) == bitcast<f32>(0x7f800000u)
// run: max_f32(0.0, bitcast<f32>(0xff800000u)) == 0.0
// run: max_f32(0.0, bitcast<f32>(0x7fc00000u)) == 0.0
// run: max_f32(0.0, 0.1) == 0.1
// run: max_f32(0.0, bitcast<f32>(0x00000001u)) == bitcast<f32>(0x00000001u)
// run: max_f32(-0.0, 0.0) == -0.0
// run: max_f32(-0.0, -0.0) == -0.0
// run: max_f32(-0.0, 1.0) == 1.0
// run: max_f32(-0.0, -1.0) == -0.0
// run: max_f32(-0.0, bitcast<f32>(0x7f800000u)) == bitcast<f32>(0x7f800000u)
// run: max_f32(-0.0, bitcast<f32>(0xff800000u)) == -0.0
// run: max_f32(-0.0, bitcast<f32>(0x7fc00000u)) == -0.0
// run: max_f32(-0.0, 0.1) == 0.1
// run: max_f32(-0.0, bitcast<f32>(0x00000001u)) == bitcast<f32>(0x00000001u)
// run: max_f32(1.0, 0.0) == 1.0
// run: max_f32(1.0, -0.0) == 1.0
// run: max_f32(1.0, 1.0) == 1.0
// run: max_f32(1.0, -1.0) == 1.0
// run: max_f32(1.0, bitcast<f32>(0x7f800000u)) == bitcast<f32>(0x7f800000u)
// run: max_f32(1.0, bitcast<f32>(0xff800000u)) == 1.0
// run: max_f32(1.0, bitcast<f32>(0x7fc00000u)) == 1.0
// run: max_f32(1.0, 0.1) == 1.0
// run: max_f32(1.0, bitcast<f32>(0x00000001u)) == 1.0
// run: max_f32(-1.0, 0.0) == 0.0
// run: max_f32(-1.0, -0.0) == -0.0
// run: max_f32(-1.0, 1.0) == 1.0
// run: max_f32(-1.0, -1.0) == -1.0
// run: max_f32(-1.0, bitcast<f32>(0x7f800000u)) == bitcast<f32>(0x7f800000u)
// run: max_f32(-1.0, bitcast<f32>(0xff800000u)) == -1.0
// run: max_f32(-1.0, bitcast<f32>(0x7fc00000u)) == -1.0
// run: max_f32(-1.0, 0.1) == 0.1
// run: max_f32(-1.0, bitcast<f32>(0x00000001u)) == bitcast<f32>(0x00000001u)
// run: max_f32(bitcast<f32>(0x7f800000u), 0.0) == bitcast<f32>(0x7f800000u)
// run: max_f32(bitcast<f32>(0x7f800000u), -0.0) == bitcast<f32>(0x7f800000u)
// run: max_f32(bitcast<f32>(0x7f800000u), 1.0) == bitcast<f32>(0x7f800000u)
// run: max_f32(bitcast<f32>(0x7f800000u), -1.0) == bitcast<f32>(0x7f800000u)
// run: max_f32(bitcast<f32>(0x7f800000u), bitcast<f32>(0x7f800000u)) == bitcast<f32>(0x7f800000u)
// run: max_f32(bitcast<f32>(0x7f800000u), bitcast<f32>(0xff800000u)) == bitcast<f32>(0x7f800000u)
// run: max_f32(bitcast<f32>(0x7f800000u), bitcast<f32>(0x7fc00000u)) == bitcast<f32>(0x7f800000u)
// run: max_f32(bitcast<f32>(0x7f800000u), 0.1) == bitcast<f32>(0x7f800000u)
// run: max_f32(bitcast<f32>(0x7f800000u), bitcast<f32>(0x00000001u)) == bitcast<f32>(0x7f800000u)
// run: max_f32(bitcast<f32>(0xff800000u), 0.0) == 0.0
// run: max_f32(bitcast<f32>(0xff800000u), -0.0) == -0.0
// run: max_f32(bitcast<f32>(0xff800000u), 1.0) == 1.0
// run: max_f32(bitcast<f32>(0xff800000u), -1.0) == -1.0
// run: max_f32(bitcast<f32>(0xff800000u), bitcast<f32>(0x7f800000u)) == bitcast<f32>(0x7f800000u)
// run: max_f32(bitcast<f32>(0xff800000u), bitcast<f32>(0xff800000u)) == bitcast<f32>(0xff800000u)
// run: max_f32(bitcast<f32>(0xff800000u), bitcast<f32>(0x7fc00000u)) == bitcast<f32>(0xff800000u)
// run: max_f32(bitcast<f32>(0xff800000u), 0.1) == 0.1
// run: max_f32(bitcast<f32>(0xff800000u), bitcast<f32>(0x00000001u)) == bitcast<f32>(0x00000001u)
// run: max_f32(bitcast<f32>(0x7fc00000u), 0.0) == 0.0
// run: max_f32(bitcast<f32>(0x7fc00000u), -0.0) == -0.0
// run: max_f32(bitcast<f32>(0x7fc00000u), 1.0) == 1.0
// run: max_f32(bitcast<f32>(0x7fc00000u), -1.0) == -1.0
// run: max_f32(bitcast<f32>(0x7fc00000u), bitcast<f32>(0x7f800000u)) == bitcast<f32>(0x7f800000u)
// run: max_f32(bitcast<f32>(0x7fc00000u), bitcast<f32>(0xff800000u)) == bitcast<f32>(0xff800000u)
// run: max_f32(bitcast<f32>(0x7fc00000u), bitcast<f32>(0x7fc00000u)) == nan
// run: max_f32(bitcast<f32>(0x7fc00000u), 0.1) == 0.1
// run: max_f32(bitcast<f32>(0x7fc00000u), bitcast<f32>(0x00000001u)) == bitcast<f32>(0x00000001u)
// run: max_f32(0.1, 0.0) == 0.1
// run: max_f32(0.1, -0.0) == 0.1
// run: max_f32(0.1, 1.0) == 1.0
// run: max_f32(0.1, -1.0) == 0.1
// run: max_f32(0.1, bitcast<f32>(0x7f800000u)) == bitcast<f32>(0x7f800000u)
// run: max_f32(0.1, bitcast<f32>(0xff800000u)) == 0.1
// run: max_f32(0.1, bitcast<f32>(0x7fc00000u)) == 0.1
// run: max_f32(0.1, 0.1) == 0.1
// run: max_f32(0.1, bitcast<f32>(0x00000001u)) == 0.1
// run: max_f32(bitcast<f32>(0x00000001u), 0.0) == bitcast<f32>(0x00000001u)
// run: max_f32(bitcast<f32>(0x00000001u), -0.0) == bitcast<f32>(0x00000001u)
// run: max_f32(bitcast<f32>(0x00000001u), 1.0) == 1.0
// run: max_f32(bitcast<f32>(0x00000001u), -1.0) == bitcast<f32>(0x00000001u)
// run: max_f32(bitcast<f32>(0x00000001u), bitcast<f32>(0x7f800000u)) == bitcast<f32>(0x7f800000u)
// run: max_f32(bitcast<f32>(0x00000001u), bitcast<f32>(0xff800000u)) == bitcast<f32>(0x00000001u)
// run: max_f32(bitcast<f32>(0x00000001u), bitcast<f32>(0x7fc00000u)) == bitcast<f32>(0x00000001u)
// run: max_f32(bitcast<f32>(0x00000001u), 0.1) == 0.1
// run: max_f32(bitcast<f32>(0x00000001u), bitcast<f32>(0x00000001u)) == bitcast<f32>(0x00000001u)

fn max_vec4(x: vec4<f32>, y: vec4<f32>) -> vec4<f32> { return max(x, y); }
// run: max_vec4(vec4<f32>(1.0, -2.0, 0.5, 7.0), vec4<f32>(0.5, -1.0, 0.75, -7.0)) == vec4<f32>(1.0, -1.0, 0.75, 7.0)

fn clamp_f32(x: f32, low: f32, high: f32) -> f32 { return clamp(x, low, high); }
// run: clamp_f32(0.0, 0.0, 1.0) == 0.0
// run: clamp_f32(0.0, -1.0, 0.1) == 0.0
// run: clamp_f32(0.0, 2.0, 1.0) == 1.0
// run: clamp_f32(-0.0, 0.0, 1.0) == -0.0
// run: clamp_f32(-0.0, -1.0, 0.1) == -0.0
// run: clamp_f32(-0.0, 2.0, 1.0) == 1.0
// run: clamp_f32(1.0, 0.0, 1.0) == 1.0
// run: clamp_f32(1.0, -1.0, 0.1) == 0.1
// run: clamp_f32(1.0, 2.0, 1.0) == 1.0
// run: clamp_f32(-1.0, 0.0, 1.0) == 0.0
// run: clamp_f32(-1.0, -1.0, 0.1) == -1.0
// run: clamp_f32(-1.0, 2.0, 1.0) == 1.0
// run: clamp_f32(bitcast<f32>(0x7f800000u), 0.0, 1.0) == 1.0
// run: clamp_f32(bitcast<f32>(0x7f800000u), -1.0, 0.1) == 0.1
// run: clamp_f32(bitcast<f32>(0x7f800000u), 2.0, 1.0) == 1.0
// run: clamp_f32(bitcast<f32>(0xff800000u), 0.0, 1.0) == 0.0
// run: clamp_f32(bitcast<f32>(0xff800000u), -1.0, 0.1) == -1.0
// run: clamp_f32(bitcast<f32>(0xff800000u), 2.0, 1.0) == 1.0
// run: clamp_f32(bitcast<f32>(0x7fc00000u), 0.0, 1.0) == 0.0
// run: clamp_f32(bitcast<f32>(0x7fc00000u), -1.0, 0.1) == -1.0
// run: clamp_f32(bitcast<f32>(0x7fc00000u), 2.0, 1.0) == 1.0
// run: clamp_f32(0.1, 0.0, 1.0) == 0.1
// run: clamp_f32(0.1, -1.0, 0.1) == 0.1
// run: clamp_f32(0.1, 2.0, 1.0) == 1.0
// run: clamp_f32(bitcast<f32>(0x00000001u), 0.0, 1.0) == bitcast<f32>(0x00000001u)
// run: clamp_f32(bitcast<f32>(0x00000001u), -1.0, 0.1) == bitcast<f32>(0x00000001u)
// run: clamp_f32(bitcast<f32>(0x00000001u), 2.0, 1.0) == 1.0

fn clamp_vec2(x: vec2<f32>, low: vec2<f32>, high: vec2<f32>) -> vec2<f32> { return clamp(x, low, high); }
// run: clamp_vec2(vec2<f32>(5.0, -5.0), vec2<f32>(0.0, -1.0), vec2<f32>(2.0, 1.0)) == vec2<f32>(2.0, -1.0)

fn saturate_f32(x: f32) -> f32 { return saturate(x); }
// run: saturate_f32(0.0) == 0.0
// run: saturate_f32(-0.0) == -0.0
// run: saturate_f32(1.0) == 1.0
// run: saturate_f32(-1.0) == 0.0
// run: saturate_f32(bitcast<f32>(0x7f800000u)) == 1.0
// run: saturate_f32(bitcast<f32>(0xff800000u)) == 0.0
// run: saturate_f32(bitcast<f32>(0x7fc00000u)) == 0.0
// run: saturate_f32(0.1) == 0.1
// run: saturate_f32(bitcast<f32>(0x00000001u)) == bitcast<f32>(0x00000001u)

fn saturate_vec3(x: vec3<f32>) -> vec3<f32> { return saturate(x); }
// run: saturate_vec3(vec3<f32>(1.5, 0.25, -0.25)) == vec3<f32>(1.0, 0.25, 0.0)

fn step_f32(edge: f32, x: f32) -> f32 { return step(edge, x); }
// run: step_f32(0.0, 0.0) == 1.0
// run: step_f32(0.0, 1.0) == 1.0
// run: step_f32(0.0, bitcast<f32>(0x7f800000u)) == 1.0
// run: step_f32(0.0, bitcast<f32>(0x7fc00000u)) == 0.0
// run: step_f32(0.0, bitcast<f32>(0x00000001u)) == 1.0
// run: step_f32(-0.0, 0.0) == 1.0
// run: step_f32(-0.0, 1.0) == 1.0
// run: step_f32(-0.0, bitcast<f32>(0x7f800000u)) == 1.0
// run: step_f32(-0.0, bitcast<f32>(0x7fc00000u)) == 0.0
// run: step_f32(-0.0, bitcast<f32>(0x00000001u)) == 1.0
// run: step_f32(1.0, 0.0) == 0.0
// run: step_f32(1.0, 1.0) == 1.0
// run: step_f32(1.0, bitcast<f32>(0x7f800000u)) == 1.0
// run: step_f32(1.0, bitcast<f32>(0x7fc00000u)) == 0.0
// run: step_f32(1.0, bitcast<f32>(0x00000001u)) == 0.0
// run: step_f32(-1.0, 0.0) == 1.0
// run: step_f32(-1.0, 1.0) == 1.0
// run: step_f32(-1.0, bitcast<f32>(0x7f800000u)) == 1.0
// run: step_f32(-1.0, bitcast<f32>(0x7fc00000u)) == 0.0
// run: step_f32(-1.0, bitcast<f32>(0x00000001u)) == 1.0
// run: step_f32(bitcast<f32>(0x7f800000u), 0.0) == 0.0
// run: step_f32(bitcast<f32>(0x7f800000u), 1.0) == 0.0
// run: step_f32(bitcast<f32>(0x7f800000u), bitcast<f32>(0x7f800000u)) == 1.0
// run: step_f32(bitcast<f32>(0x7f800000u), bitcast<f32>(0x7fc00000u)) == 0.0
// run: step_f32(bitcast<f32>(0x7f800000u), bitcast<f32>(0x00000001u)) == 0.0
// run: step_f32(bitcast<f32>(0xff800000u), 0.0) == 1.0
// run: step_f32(bitcast<f32>(0xff800000u), 1.0) == 1.0
// run: step_f32(bitcast<f32>(0xff800000u), bitcast<f32>(0x7f800000u)) == 1.0
// run: step_f32(bitcast<f32>(0xff800000u), bitcast<f32>(0x7fc00000u)) == 0.0
// run: step_f32(bitcast<f32>(0xff800000u), bitcast<f32>(0x00000001u)) == 1.0
// run: step_f32(bitcast<f32>(0x7fc00000u), 0.0) == 0.0
// run: step_f32(bitcast<f32>(0x7fc00000u), 1.0) == 0.0
// run: step_f32(bitcast<f32>(0x7fc00000u), bitcast<f32>(0x7f800000u)) == 0.0
// run: step_f32(bitcast<f32>(0x7fc00000u), bitcast<f32>(0x7fc00000u)) == 0.0
// run: step_f32(bitcast<f32>(0x7fc00000u), bitcast<f32>(0x00000001u)) == 0.0
// run: step_f32(0.1, 0.0) == 0.0
// run: step_f32(0.1, 1.0) == 1.0
// run: step_f32(0.1, bitcast<f32>(0x7f800000u)) == 1.0
// run: step_f32(0.1, bitcast<f32>(0x7fc00000u)) == 0.0
// run: step_f32(0.1, bitcast<f32>(0x00000001u)) == 0.0
// run: step_f32(bitcast<f32>(0x00000001u), 0.0) == 0.0
// run: step_f32(bitcast<f32>(0x00000001u), 1.0) == 1.0
// run: step_f32(bitcast<f32>(0x00000001u), bitcast<f32>(0x7f800000u)) == 1.0
// run: step_f32(bitcast<f32>(0x00000001u), bitcast<f32>(0x7fc00000u)) == 0.0
// run: step_f32(bitcast<f32>(0x00000001u), bitcast<f32>(0x00000001u)) == 1.0

fn step_vec2(edge: vec2<f32>, x: vec2<f32>) -> vec2<f32> { return step(edge, x); }
// run: step_vec2(vec2<f32>(1.0, 1.0), vec2<f32>(0.5, 1.0)) == vec2<f32>(0.0, 1.0)

fn mix_f32(x: f32, y: f32, a: f32) -> f32 { return mix(x, y, a); }
// run: mix_f32(0.0, 1.0, 0.25) == 0.25
// run: mix_f32(0.1, 0.7, 0.3) == 0.28
// run: mix_f32(1e+08, 1.0, 1.0) == 1.0
// run: mix_f32(1.0, 1e+08, 0.1) == 10000001.0
// run: mix_f32(-3.0, 5.0, 1.5) == 9.0
// run: mix_f32(2.0, -2.0, 0.0) == 2.0

fn mix_vec2(x: vec2<f32>, y: vec2<f32>, a: f32) -> vec2<f32> { return mix(x, y, a); }
// run: mix_vec2(vec2<f32>(0.1, 2.0), vec2<f32>(0.2, 4.0), 0.3) == vec2<f32>(0.13, 2.6)

fn mix_vec3(x: vec3<f32>, y: vec3<f32>, a: vec3<f32>) -> vec3<f32> { return mix(x, y, a); }
// run: mix_vec3(vec3<f32>(0.0, 1.0, 2.0), vec3<f32>(1.0, 2.0, 4.0), vec3<f32>(0.5, 0.25, 0.9)) == vec3<f32>(0.5, 1.25, 3.8)

fn smoothstep_f32(low: f32, high: f32, x: f32) -> f32 { return smoothstep(low, high, x); }
// run: smoothstep_f32(0.0, 1.0, 0.5) == 0.5
// run: smoothstep_f32(0.0, 1.0, 0.3) == 0.21600002
// run: smoothstep_f32(0.0, 1.0, 2.0) == 1.0
// run: smoothstep_f32(0.0, 1.0, -2.0) == 0.0
// run: smoothstep_f32(0.1, 0.9, 0.7) == 0.84375
// run: smoothstep_f32(-3.0, 7.0, 1.1) == 0.366458
// run: smoothstep_f32(2.0, 1.0, 1.2) == 0.89599997

fn smoothstep_vec2(low: vec2<f32>, high: vec2<f32>, x: vec2<f32>) -> vec2<f32> { return smoothstep(low, high, x); }
// run: smoothstep_vec2(vec2<f32>(0.0, 0.2), vec2<f32>(1.0, 0.4), vec2<f32>(0.6, 0.35)) == vec2<f32>(0.648, 0.84375)

fn fma_f32(x: f32, y: f32, z: f32) -> f32 { return fma(x, y, z); }
// run: fma_f32(1.0002441, 1.0002441, -1.0004883) == 5.9604645e-08
// run: fma_f32(2.0, 3.0, 4.0) == 1e+01
// run: fma_f32(0.1, 1e+01, -1.0) == 1.4901161e-08
// run: fma_f32(1e+30, 1e+30, bitcast<f32>(0xff800000u)) == bitcast<f32>(0xff800000u)
// run: fma_f32(bitcast<f32>(0x00000001u), 0.5, bitcast<f32>(0x00000001u)) == bitcast<f32>(0x00000002u)
// run: fma_f32(bitcast<f32>(0x00000001u), 0.5, bitcast<f32>(0x00000002u)) == bitcast<f32>(0x00000002u)
// run: fma_f32(1.0000001, 0.9999999, -1.0) == -1.4210855e-14
// run: fma_f32(3e+38, 2.0, -3e+38) == 3e+38
// run: fma_f32(16777216.0, 1.0, 0.5) == 16777216.0

fn fma_vec2(x: vec2<f32>, y: vec2<f32>, z: vec2<f32>) -> vec2<f32> { return fma(x, y, z); }
// run: fma_vec2(vec2<f32>(1.0002441, 2.0), vec2<f32>(1.0002441, 3.0), vec2<f32>(-1.0, 1.0)) == vec2<f32>(0.00048834085, 7.0)

fn degrees_f32(x: f32) -> f32 { return degrees(x); }
// run: degrees_f32(0.0) == 0.0
// run: degrees_f32(1.0) == 57.29578
// run: degrees_f32(-2.5) == -143.23946
// run: degrees_f32(1.8e+02) == 10313.24
// run: degrees_f32(3.1415927) == 1.8e+02
// run: degrees_f32(1e+30) == 5.729578e+31

fn degrees_vec2(x: vec2<f32>) -> vec2<f32> { return degrees(x); }
// run: degrees_vec2(vec2<f32>(9e+01, 0.7)) == vec2<f32>(5156.62, 40.107044)

fn radians_f32(x: f32) -> f32 { return radians(x); }
// run: radians_f32(0.0) == 0.0
// run: radians_f32(1.0) == 0.017453292
// run: radians_f32(-2.5) == -0.04363323
// run: radians_f32(1.8e+02) == 3.1415927
// run: radians_f32(3.1415927) == 0.054831136
// run: radians_f32(1e+30) == 1.7453293e+28

fn radians_vec2(x: vec2<f32>) -> vec2<f32> { return radians(x); }
// run: radians_vec2(vec2<f32>(9e+01, 0.7)) == vec2<f32>(1.5707964, 0.012217305)

fn sqrt_f32(x: f32) -> f32 { return sqrt(x); }
// run: sqrt_f32(0.0) == 0.0
// run: sqrt_f32(1.0) == 1.0
// run: sqrt_f32(2.0) == 1.4142135
// run: sqrt_f32(0.1) == 0.31622776
// run: sqrt_f32(3.0) == 1.7320508
// run: sqrt_f32(1e+30) == 1e+15
// run: sqrt_f32(bitcast<f32>(0x00000001u)) == 3.743392e-23
// run: sqrt_f32(bitcast<f32>(0x007fffffu)) == 1.0842021e-19
// run: sqrt_f32(3.4028235e+38) == 1.8446743e+19
// run: sqrt_f32(4.0) == 2.0
// run: sqrt_f32(0.3) == 0.5477226
// run: sqrt_f32(0.99999994) == 0.99999994
// run: sqrt_f32(1.0000001) == 1.0
// run: sqrt_f32(123456.0) == 351.36307
// run: sqrt_f32(-1.0) == nan
// run: sqrt_f32(-0.0) == -0.0
// run: sqrt_f32(bitcast<f32>(0x7f800000u)) == bitcast<f32>(0x7f800000u)

fn sqrt_vec3(x: vec3<f32>) -> vec3<f32> { return sqrt(x); }
// run: sqrt_vec3(vec3<f32>(4.0, 2.0, 9.0)) == vec3<f32>(2.0, 1.4142135, 3.0)

fn inverse_sqrt_f32(x: f32) -> f32 { return inverseSqrt(x); }
// run: inverse_sqrt_f32(1.0) == 1.0
// run: inverse_sqrt_f32(2.0) == 0.70710677
// run: inverse_sqrt_f32(0.1) == 3.1622777
// run: inverse_sqrt_f32(3.0) == 0.57735026
// run: inverse_sqrt_f32(1e+30) == 1e-15
// run: inverse_sqrt_f32(bitcast<f32>(0x00000001u)) == 2.6713738e+22
// run: inverse_sqrt_f32(bitcast<f32>(0x007fffffu)) == 9.223373e+18
// run: inverse_sqrt_f32(3.4028235e+38) == 5.421011e-20
// run: inverse_sqrt_f32(4.0) == 0.5
// run: inverse_sqrt_f32(0.3) == 1.8257418
// run: inverse_sqrt_f32(0.99999994) == 1.0
// run: inverse_sqrt_f32(1.0000001) == 0.99999994
// run: inverse_sqrt_f32(123456.0) == 0.002846059
// run: inverse_sqrt_f32(0.0) == bitcast<f32>(0x7f800000u)
// run: inverse_sqrt_f32(-0.0) == bitcast<f32>(0xff800000u)
// run: inverse_sqrt_f32(-1.0) == nan
// run: inverse_sqrt_f32(bitcast<f32>(0x7f800000u)) == 0.0

fn inverse_sqrt_vec2(x: vec2<f32>) -> vec2<f32> { return inverseSqrt(x); }
// run: inverse_sqrt_vec2(vec2<f32>(4.0, 2.0)) == vec2<f32>(0.5, 0.70710677)
