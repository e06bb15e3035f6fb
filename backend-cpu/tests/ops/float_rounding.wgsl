// floor, ceil, trunc, round, fract, modf, frexp, ldexp, quantizeToF16.

fn floor_f32(x: f32) -> f32 { return floor(x); }
// run: floor_f32(0.0) == 0.0
// run: floor_f32(-0.0) == -0.0
// run: floor_f32(0.5) == 0.0
// run: floor_f32(-0.5) == -1.0
// run: floor_f32(1.5) == 1.0
// run: floor_f32(2.5) == 2.0
// run: floor_f32(-1.5) == -2.0
// run: floor_f32(-2.5) == -3.0
// run: floor_f32(0.49999997) == 0.0
// run: floor_f32(-0.49999997) == -1.0
// run: floor_f32(0.1) == 0.0
// run: floor_f32(-0.1) == -1.0
// run: floor_f32(8388607.5) == 8388607.0
// run: floor_f32(-8388607.5) == -8388608.0
// run: floor_f32(8388609.0) == 8388609.0
// run: floor_f32(1e+20) == 1e+20
// run: floor_f32(-1e-20) == -1.0
// run: floor_f32(bitcast<f32>(0x00000001u)) == 0.0
// run: floor_f32(bitcast<f32>(0x7f800000u)) == bitcast<f32>(0x7f800000u)
// run: floor_f32(bitcast<f32>(0xff800000u)) == bitcast<f32>(0xff800000u)
// run: floor_f32(2.7) == 2.0
// run: floor_f32(-2.7) == -3.0
// run: floor_f32(1.0) == 1.0
// run: floor_f32(-1.0) == -1.0
// run: floor_f32(bitcast<f32>(0x7fc00000u)) == nan

fn floor_vec4(x: vec4<f32>) -> vec4<f32> { return floor(x); }
// run: floor_vec4(vec4<f32>(0.0, -0.0, 0.5, -0.5)) == vec4<f32>(0.0, -0.0, 0.0, -1.0)
// run: floor_vec4(vec4<f32>(1.5, 2.5, -1.5, -2.5)) == vec4<f32>(1.0, 2.0, -2.0, -3.0)
// run: floor_vec4(vec4<f32>(0.49999997, -0.49999997, 0.1, -0.1)) == vec4<f32>(0.0, -1.0, 0.0, -1.0)

fn ceil_f32(x: f32) -> f32 { return ceil(x); }
// run: ceil_f32(0.0) == 0.0
// run: ceil_f32(-0.0) == -0.0
// run: ceil_f32(0.5) == 1.0
// run: ceil_f32(-0.5) == -0.0
// run: ceil_f32(1.5) == 2.0
// run: ceil_f32(2.5) == 3.0
// run: ceil_f32(-1.5) == -1.0
// run: ceil_f32(-2.5) == -2.0
// run: ceil_f32(0.49999997) == 1.0
// run: ceil_f32(-0.49999997) == -0.0
// run: ceil_f32(0.1) == 1.0
// run: ceil_f32(-0.1) == -0.0
// run: ceil_f32(8388607.5) == 8388608.0
// run: ceil_f32(-8388607.5) == -8388607.0
// run: ceil_f32(8388609.0) == 8388609.0
// run: ceil_f32(1e+20) == 1e+20
// run: ceil_f32(-1e-20) == -0.0
// run: ceil_f32(bitcast<f32>(0x00000001u)) == 1.0
// run: ceil_f32(bitcast<f32>(0x7f800000u)) == bitcast<f32>(0x7f800000u)
// run: ceil_f32(bitcast<f32>(0xff800000u)) == bitcast<f32>(0xff800000u)
// run: ceil_f32(2.7) == 3.0
// run: ceil_f32(-2.7) == -2.0
// run: ceil_f32(1.0) == 1.0
// run: ceil_f32(-1.0) == -1.0
// run: ceil_f32(bitcast<f32>(0x7fc00000u)) == nan

fn ceil_vec4(x: vec4<f32>) -> vec4<f32> { return ceil(x); }
// run: ceil_vec4(vec4<f32>(0.0, -0.0, 0.5, -0.5)) == vec4<f32>(0.0, -0.0, 1.0, -0.0)
// run: ceil_vec4(vec4<f32>(1.5, 2.5, -1.5, -2.5)) == vec4<f32>(2.0, 3.0, -1.0, -2.0)
// run: ceil_vec4(vec4<f32>(0.49999997, -0.49999997, 0.1, -0.1)) == vec4<f32>(1.0, -0.0, 1.0, -0.0)

fn trunc_f32(x: f32) -> f32 { return trunc(x); }
// run: trunc_f32(0.0) == 0.0
// run: trunc_f32(-0.0) == -0.0
// run: trunc_f32(0.5) == 0.0
// run: trunc_f32(-0.5) == -0.0
// run: trunc_f32(1.5) == 1.0
// run: trunc_f32(2.5) == 2.0
// run: trunc_f32(-1.5) == -1.0
// run: trunc_f32(-2.5) == -2.0
// run: trunc_f32(0.49999997) == 0.0
// run: trunc_f32(-0.49999997) == -0.0
// run: trunc_f32(0.1) == 0.0
// run: trunc_f32(-0.1) == -0.0
// run: trunc_f32(8388607.5) == 8388607.0
// run: trunc_f32(-8388607.5) == -8388607.0
// run: trunc_f32(8388609.0) == 8388609.0
// run: trunc_f32(1e+20) == 1e+20
// run: trunc_f32(-1e-20) == -0.0
// run: trunc_f32(bitcast<f32>(0x00000001u)) == 0.0
// run: trunc_f32(bitcast<f32>(0x7f800000u)) == bitcast<f32>(0x7f800000u)
// run: trunc_f32(bitcast<f32>(0xff800000u)) == bitcast<f32>(0xff800000u)
// run: trunc_f32(2.7) == 2.0
// run: trunc_f32(-2.7) == -2.0
// run: trunc_f32(1.0) == 1.0
// run: trunc_f32(-1.0) == -1.0
// run: trunc_f32(bitcast<f32>(0x7fc00000u)) == nan

fn trunc_vec4(x: vec4<f32>) -> vec4<f32> { return trunc(x); }
// run: trunc_vec4(vec4<f32>(0.0, -0.0, 0.5, -0.5)) == vec4<f32>(0.0, -0.0, 0.0, -0.0)
// run: trunc_vec4(vec4<f32>(1.5, 2.5, -1.5, -2.5)) == vec4<f32>(1.0, 2.0, -1.0, -2.0)
// run: trunc_vec4(vec4<f32>(0.49999997, -0.49999997, 0.1, -0.1)) == vec4<f32>(0.0, -0.0, 0.0, -0.0)

fn round_f32(x: f32) -> f32 { return round(x); }
// run: round_f32(0.0) == 0.0
// run: round_f32(-0.0) == -0.0
// run: round_f32(0.5) == 0.0
// run: round_f32(-0.5) == -0.0
// run: round_f32(1.5) == 2.0
// run: round_f32(2.5) == 2.0
// run: round_f32(-1.5) == -2.0
// run: round_f32(-2.5) == -2.0
// run: round_f32(0.49999997) == 0.0
// run: round_f32(-0.49999997) == -0.0
// run: round_f32(0.1) == 0.0
// run: round_f32(-0.1) == -0.0
// run: round_f32(8388607.5) == 8388608.0
// run: round_f32(-8388607.5) == -8388608.0
// run: round_f32(8388609.0) == 8388609.0
// run: round_f32(1e+20) == 1e+20
// run: round_f32(-1e-20) == -0.0
// run: round_f32(bitcast<f32>(0x00000001u)) == 0.0
// run: round_f32(bitcast<f32>(0x7f800000u)) == bitcast<f32>(0x7f800000u)
// run: round_f32(bitcast<f32>(0xff800000u)) == bitcast<f32>(0xff800000u)
// run: round_f32(2.7) == 3.0
// run: round_f32(-2.7) == -3.0
// run: round_f32(1.0) == 1.0
// run: round_f32(-1.0) == -1.0
// run: round_f32(bitcast<f32>(0x7fc00000u)) == nan

fn round_vec4(x: vec4<f32>) -> vec4<f32> { return round(x); }
// run: round_vec4(vec4<f32>(0.0, -0.0, 0.5, -0.5)) == vec4<f32>(0.0, -0.0, 0.0, -0.0)
// run: round_vec4(vec4<f32>(1.5, 2.5, -1.5, -2.5)) == vec4<f32>(2.0, 2.0, -2.0, -2.0)
// run: round_vec4(vec4<f32>(0.49999997, -0.49999997, 0.1, -0.1)) == vec4<f32>(0.0, -0.0, 0.0, -0.0)

fn fract_f32(x: f32) -> f32 { return fract(x); }
// run: fract_f32(0.0) == 0.0
// run: fract_f32(-0.0) == 0.0
// run: fract_f32(0.5) == 0.5
// run: fract_f32(-0.5) == 0.5
// run: fract_f32(1.5) == 0.5
// run: fract_f32(2.5) == 0.5
// run: fract_f32(-1.5) == 0.5
// run: fract_f32(-2.5) == 0.5
// run: fract_f32(0.49999997) == 0.49999997
// run: fract_f32(-0.49999997) == 0.5
// run: fract_f32(0.1) == 0.1
// run: fract_f32(-0.1) == 0.9
// run: fract_f32(8388607.5) == 0.5
// run: fract_f32(-8388607.5) == 0.5
// run: fract_f32(8388609.0) == 0.0
// run: fract_f32(1e+20) == 0.0
// run: fract_f32(-1e-20) == 1.0
// run: fract_f32(bitcast<f32>(0x00000001u)) == bitcast<f32>(0x00000001u)
// run: fract_f32(bitcast<f32>(0x7f800000u)) == nan
// run: fract_f32(bitcast<f32>(0xff800000u)) == nan
// run: fract_f32(2.7) == 0.70000005
// run: fract_f32(-2.7) == 0.29999995
// run: fract_f32(1.0) == 0.0
// run: fract_f32(-1.0) == 0.0

fn fract_vec3(x: vec3<f32>) -> vec3<f32> { return fract(x); }
// run: fract_vec3(vec3<f32>(1.25, -1.25, 7.0)) == vec3<f32>(0.25, 0.75, 0.0)

fn modf_f32(x: f32) -> vec2<f32> { let parts = modf(x); return vec2(parts.fract, parts.whole); }
// run: modf_f32(0.0) == vec2<f32>(0.0, 0.0)
// run: modf_f32(-0.0) == vec2<f32>(0.0, -0.0)
// run: modf_f32(0.5) == vec2<f32>(0.5, 0.0)
// run: modf_f32(-0.5) == vec2<f32>(-0.5, -0.0)
// run: modf_f32(1.5) == vec2<f32>(0.5, 1.0)
// run: modf_f32(2.5) == vec2<f32>(0.5, 2.0)
// run: modf_f32(-1.5) == vec2<f32>(-0.5, -1.0)
// run: modf_f32(-2.5) == vec2<f32>(-0.5, -2.0)
// run: modf_f32(0.49999997) == vec2<f32>(0.49999997, 0.0)
// run: modf_f32(-0.49999997) == vec2<f32>(-0.49999997, -0.0)
// run: modf_f32(0.1) == vec2<f32>(0.1, 0.0)
// run: modf_f32(-0.1) == vec2<f32>(-0.1, -0.0)
// run: modf_f32(8388607.5) == vec2<f32>(0.5, 8388607.0)
// run: modf_f32(-8388607.5) == vec2<f32>(-0.5, -8388607.0)
// run: modf_f32(8388609.0) == vec2<f32>(0.0, 8388609.0)
// run: modf_f32(1e+20) == vec2<f32>(0.0, 1e+20)
// run: modf_f32(-1e-20) == vec2<f32>(-1e-20, -0.0)
// run: modf_f32(bitcast<f32>(0x00000001u)) == vec2<f32>(bitcast<f32>(0x00000001u), 0.0)
// run: modf_f32(bitcast<f32>(0x7f800000u)) == vec2<f32>(nan, bitcast<f32>(0x7f800000u))
// run: modf_f32(bitcast<f32>(0xff800000u)) == vec2<f32>(nan, bitcast<f32>(0xff800000u))
// run: modf_f32(2.7) == vec2<f32>(0.70000005, 2.0)
// run: modf_f32(-2.7) == vec2<f32>(-0.70000005, -2.0)
// run: modf_f32(1.0) == vec2<f32>(0.0, 1.0)
// run: modf_f32(-1.0) == vec2<f32>(0.0, -1.0)

fn modf_vec2(x: vec2<f32>) -> vec4<f32> { let parts = modf(x); return vec4(parts.fract, parts.whole); }
// run: modf_vec2(vec2<f32>(2.5, -3.75)) == vec4<f32>(0.5, -0.75, 2.0, -3.0)

fn frexp_fract(x: f32) -> f32 { return frexp(x).fract; }

fn frexp_exp(x: f32) -> i32 { return frexp(x).exp; }
// run: frexp_fract(0.0) == 0.0
// run: frexp_exp(0.0) == 0i
// run: frexp_fract(-0.0) == -0.0
// run: frexp_exp(-0.0) == 0i
// run: frexp_fract(1.0) == 0.5
// run: frexp_exp(1.0) == 1i
// run: frexp_fract(-1.0) == -0.5
// run: frexp_exp(-1.0) == 1i
// run: frexp_fract(0.75) == 0.75
// run: frexp_exp(0.75) == 0i
// run: frexp_fract(6.0) == 0.75
// run: frexp_exp(6.0) == 3i
// run: frexp_fract(0.1) == 0.8
// run: frexp_exp(0.1) == -3i
// run: frexp_fract(-1e+30) == -0.7888609
// run: frexp_exp(-1e+30) == 100i
// run: frexp_fract(bitcast<f32>(0x00000001u)) == 0.5
// run: frexp_exp(bitcast<f32>(0x00000001u)) == -148i
// run: frexp_fract(bitcast<f32>(0x007fffffu)) == 0.9999999
// run: frexp_exp(bitcast<f32>(0x007fffffu)) == -126i
// run: frexp_fract(bitcast<f32>(0x00800000u)) == 0.5
// run: frexp_exp(bitcast<f32>(0x00800000u)) == -125i
// run: frexp_fract(3.4028235e+38) == 0.99999994
// run: frexp_exp(3.4028235e+38) == 128i

fn frexp_vec3(x: vec3<f32>) -> vec3<f32> { let parts = frexp(x); return parts.fract + vec3<f32>(parts.exp); }
// run: frexp_vec3(vec3<f32>(6.0, 0.5, -8.0)) == vec3<f32>(3.75, 0.5, 3.5)

fn ldexp_f32(x: f32, e: i32) -> f32 { return ldexp(x, e); }
// run: ldexp_f32(1.0, 0i) == 1.0
// run: ldexp_f32(1.0, 1i) == 2.0
// run: ldexp_f32(1.0, -1i) == 0.5
// run: ldexp_f32(1.0, 10i) == 1024.0
// run: ldexp_f32(1.0, 127i) == 1.7014118e+38
// run: ldexp_f32(1.0, -126i) == bitcast<f32>(0x00800000u)
// run: ldexp_f32(1.0, -130i) == bitcast<f32>(0x00080000u)
// run: ldexp_f32(1.0, -149i) == bitcast<f32>(0x00000001u)
// run: ldexp_f32(1.0, -150i) == 0.0
// run: ldexp_f32(1.0, 128i) == bitcast<f32>(0x7f800000u)
// run: ldexp_f32(1.0, 149i) == bitcast<f32>(0x7f800000u)
// run: ldexp_f32(1.0, 276i) == bitcast<f32>(0x7f800000u)
// run: ldexp_f32(1.0, 300i) == bitcast<f32>(0x7f800000u)
// run: ldexp_f32(1.0, -300i) == 0.0
// run: ldexp_f32(1.0, 2147483647i) == bitcast<f32>(0x7f800000u)
// run: ldexp_f32(1.0, -2147483648i) == 0.0
// run: ldexp_f32(-1.5, 0i) == -1.5
// run: ldexp_f32(-1.5, 1i) == -3.0
// run: ldexp_f32(-1.5, -1i) == -0.75
// run: ldexp_f32(-1.5, 10i) == -1536.0
// run: ldexp_f32(-1.5, 127i) == -2.5521178e+38
// run: ldexp_f32(-1.5, -126i) == bitcast<f32>(0x80c00000u)
// run: ldexp_f32(-1.5, -130i) == bitcast<f32>(0x800c0000u)
// run: ldexp_f32(-1.5, -149i) == bitcast<f32>(0x80000002u)
// run: ldexp_f32(-1.5, -150i) == bitcast<f32>(0x80000001u)
// run: ldexp_f32(-1.5, 128i) == bitcast<f32>(0xff800000u)
// run: ldexp_f32(-1.5, 149i) == bitcast<f32>(0xff800000u)
// run: ldexp_f32(-1.5, 276i) == bitcast<f32>(0xff800000u)
// run: ldexp_f32(-1.5, 300i) == bitcast<f32>(0xff800000u)
// run: ldexp_f32(-1.5, -300i) == -0.0
// run: ldexp_f32(-1.5, 2147483647i) == bitcast<f32>(0xff800000u)
// run: ldexp_f32(-1.5, -2147483648i) == -0.0
// run: ldexp_f32(0.1, 0i) == 0.1
// run: ldexp_f32(0.1, 1i) == 0.2
// run: ldexp_f32(0.1, -1i) == 0.05
// run: ldexp_f32(0.1, 10i) == 102.4
// run: ldexp_f32(0.1, 127i) == 1.7014119e+37
// run: ldexp_f32(0.1, -126i) == bitcast<f32>(0x000ccccdu)
// run: ldexp_f32(0.1, -130i) == bitcast<f32>(0x0000cccdu)
// run: ldexp_f32(0.1, -149i) == 0.0
// run: ldexp_f32(0.1, -150i) == 0.0
// run: ldexp_f32(0.1, 128i) == 3.4028237e+37
// run: ldexp_f32(0.1, 149i) == bitcast<f32>(0x7f800000u)
// run: ldexp_f32(0.1, 276i) == bitcast<f32>(0x7f800000u)
// run: ldexp_f32(0.1, 300i) == bitcast<f32>(0x7f800000u)
// run: ldexp_f32(0.1, -300i) == 0.0
// run: ldexp_f32(0.1, 2147483647i) == bitcast<f32>(0x7f800000u)
// run: ldexp_f32(0.1, -2147483648i) == 0.0
// run: ldexp_f32(bitcast<f32>(0x00000001u), 0i) == bitcast<f32>(0x00000001u)
// run: ldexp_f32(bitcast<f32>(0x00000001u), 1i) == bitcast<f32>(0x00000002u)
// run: ldexp_f32(bitcast<f32>(0x00000001u), -1i) == 0.0
// run: ldexp_f32(bitcast<f32>(0x00000001u), 10i) == bitcast<f32>(0x00000400u)
// run: ldexp_f32(bitcast<f32>(0x00000001u), 127i) == 2.3841858e-07
// run: ldexp_f32(bitcast<f32>(0x00000001u), -126i) == 0.0
// run: ldexp_f32(bitcast<f32>(0x00000001u), -130i) == 0.0
// run: ldexp_f32(bitcast<f32>(0x00000001u), -149i) == 0.0
// run: ldexp_f32(bitcast<f32>(0x00000001u), -150i) == 0.0
// run: ldexp_f32(bitcast<f32>(0x00000001u), 128i) == 4.7683716e-07
// run: ldexp_f32(bitcast<f32>(0x00000001u), 149i) == 1.0
// run: ldexp_f32(bitcast<f32>(0x00000001u), 276i) == 1.7014118e+38
// run: ldexp_f32(bitcast<f32>(0x00000001u), 300i) == bitcast<f32>(0x7f800000u)
// run: ldexp_f32(bitcast<f32>(0x00000001u), -300i) == 0.0
// run: ldexp_f32(bitcast<f32>(0x00000001u), 2147483647i) == bitcast<f32>(0x7f800000u)
// run: ldexp_f32(bitcast<f32>(0x00000001u), -2147483648i) == 0.0
// run: ldexp_f32(bitcast<f32>(0x00ffffffu), 0i) == bitcast<f32>(0x00ffffffu)
// run: ldexp_f32(bitcast<f32>(0x00ffffffu), 1i) == bitcast<f32>(0x017fffffu)
// run: ldexp_f32(bitcast<f32>(0x00ffffffu), -1i) == bitcast<f32>(0x00800000u)
// run: ldexp_f32(bitcast<f32>(0x00ffffffu), 10i) == 2.4074123e-35
// run: ldexp_f32(bitcast<f32>(0x00ffffffu), 127i) == 3.9999998
// run: ldexp_f32(bitcast<f32>(0x00ffffffu), -126i) == 0.0
// run: ldexp_f32(bitcast<f32>(0x00ffffffu), -130i) == 0.0
// run: ldexp_f32(bitcast<f32>(0x00ffffffu), -149i) == 0.0
// run: ldexp_f32(bitcast<f32>(0x00ffffffu), -150i) == 0.0
// run: ldexp_f32(bitcast<f32>(0x00ffffffu), 128i) == 7.9999995
// run: ldexp_f32(bitcast<f32>(0x00ffffffu), 149i) == 16777215.0
// run: ldexp_f32(bitcast<f32>(0x00ffffffu), 276i) == bitcast<f32>(0x7f800000u)
// run: ldexp_f32(bitcast<f32>(0x00ffffffu), 300i) == bitcast<f32>(0x7f800000u)
// run: ldexp_f32(bitcast<f32>(0x00ffffffu), -300i) == 0.0
// run: ldexp_f32(bitcast<f32>(0x00ffffffu), 2147483647i) == bitcast<f32>(0x7f800000u)
// run: ldexp_f32(bitcast<f32>(0x00ffffffu), -2147483648i) == 0.0
// run: ldexp_f32(0.0, 0i) == 0.0
// run: ldexp_f32(0.0, 1i) == 0.0
// run: ldexp_f32(0.0, -1i) == 0.0
// run: ldexp_f32(0.0, 10i) == 0.0
// run: ldexp_f32(0.0, 127i) == 0.0
// run: ldexp_f32(0.0, -126i) == 0.0
// run: ldexp_f32(0.0, -130i) == 0.0
// run: ldexp_f32(0.0, -149i) == 0.0
// run: ldexp_f32(0.0, -150i) == 0.0
// run: ldexp_f32(0.0, 128i) == 0.0
// run: ldexp_f32(0.0, 149i) == 0.0
// run: ldexp_f32(0.0, 276i) == 0.0
// run: ldexp_f32(0.0, 300i) == 0.0
// run: ldexp_f32(0.0, -300i) == 0.0
// run: ldexp_f32(0.0, 2147483647i) == 0.0
// run: ldexp_f32(0.0, -2147483648i) == 0.0
// run: ldexp_f32(-0.0, 0i) == -0.0
// run: ldexp_f32(-0.0, 1i) == -0.0
// run: ldexp_f32(-0.0, -1i) == -0.0
// run: ldexp_f32(-0.0, 10i) == -0.0
// run: ldexp_f32(-0.0, 127i) == -0.0
// run: ldexp_f32(-0.0, -126i) == -0.0
// run: ldexp_f32(-0.0, -130i) == -0.0
// run: ldexp_f32(-0.0, -149i) == -0.0
// run: ldexp_f32(-0.0, -150i) == -0.0
// run: ldexp_f32(-0.0, 128i) == -0.0
// run: ldexp_f32(-0.0, 149i) == -0.0
// run: ldexp_f32(-0.0, 276i) == -0.0
// run: ldexp_f32(-0.0, 300i) == -0.0
// run: ldexp_f32(-0.0, -300i) == -0.0
// run: ldexp_f32(-0.0, 2147483647i) == -0.0
// run: ldexp_f32(-0.0, -2147483648i) == -0.0
// run: ldexp_f32(bitcast<f32>(0x7f800000u), 0i) == bitcast<f32>(0x7f800000u)
// run: ldexp_f32(bitcast<f32>(0x7f800000u), 1i) == bitcast<f32>(0x7f800000u)
// run: ldexp_f32(bitcast<f32>(0x7f800000u), -1i) == bitcast<f32>(0x7f800000u)
// run: ldexp_f32(bitcast<f32>(0x7f800000u), 10i) == bitcast<f32>(0x7f800000u)
// run: ldexp_f32(bitcast<f32>(0x7f800000u), 127i) == bitcast<f32>(0x7f800000u)
// run: ldexp_f32(bitcast<f32>(0x7f800000u), -126i) == bitcast<f32>(0x7f800000u)
// run: ldexp_f32(bitcast<f32>(0x7f800000u), -130i) == bitcast<f32>(0x7f800000u)
// run: ldexp_f32(bitcast<f32>(0x7f800000u), -149i) == bitcast<f32>(0x7f800000u)
// run: ldexp_f32(bitcast<f32>(0x7f800000u), -150i) == bitcast<f32>(0x7f800000u)
// run: ldexp_f32(bitcast<f32>(0x7f800000u), 128i) == bitcast<f32>(0x7f800000u)
// run: ldexp_f32(bitcast<f32>(0x7f800000u), 149i) == bitcast<f32>(0x7f800000u)
// run: ldexp_f32(bitcast<f32>(0x7f800000u), 276i) == bitcast<f32>(0x7f800000u)
// run: ldexp_f32(bitcast<f32>(0x7f800000u), 300i) == bitcast<f32>(0x7f800000u)
// run: ldexp_f32(bitcast<f32>(0x7f800000u), -300i) == bitcast<f32>(0x7f800000u)
// run: ldexp_f32(bitcast<f32>(0x7f800000u), 2147483647i) == bitcast<f32>(0x7f800000u)
// run: ldexp_f32(bitcast<f32>(0x7f800000u), -2147483648i) == bitcast<f32>(0x7f800000u)

fn ldexp_vec2(x: vec2<f32>, e: vec2<i32>) -> vec2<f32> { return ldexp(x, e); }
// run: ldexp_vec2(vec2<f32>(0.75, -3.0), vec2<i32>(3i, -1i)) == vec2<f32>(6.0, -1.5)

fn quantize(x: f32) -> f32 { return quantizeToF16(x); }
// run: quantize(0.0) == 0.0
// run: quantize(-0.0) == -0.0
// run: quantize(1.0) == 1.0
// run: quantize(0.1) == 0.099975586
// run: quantize(0.33333334) == 0.33325195
// run: quantize(65504.0) == 65504.0
// run: quantize(65519.0) == 65504.0
// run: quantize(6.552e+04) == bitcast<f32>(0x7f800000u)
// run: quantize(-7e+04) == bitcast<f32>(0xff800000u)
// run: quantize(1e-08) == 0.0
// run: quantize(6e-08) == 5.9604645e-08
// run: quantize(-5.9604645e-08) == -5.9604645e-08
// run: quantize(2.98e-08) == 0.0
// run: quantize(2.9802322e-08) == 0.0
// run: quantize(2.9802326e-08) == 5.9604645e-08
// run: quantize(1.0004883) == 1.0
// run: quantize(1.0004884) == 1.0009766
// run: quantize(1.0014648) == 1.0019531
// run: quantize(bitcast<f32>(0x00000001u)) == 0.0
// run: quantize(bitcast<f32>(0x7f800000u)) == bitcast<f32>(0x7f800000u)
// run: quantize(6.1e-05) == 6.097555e-05
// run: quantize(6.1005354e-05) == 6.1035156e-05
// run: quantize(6.1020255e-05) == 6.1035156e-05

fn quantize_vec2(x: vec2<f32>) -> vec2<f32> { return quantizeToF16(x); }
// run: quantize_vec2(vec2<f32>(0.2, -1.5)) == vec2<f32>(0.19995117, -1.5)
