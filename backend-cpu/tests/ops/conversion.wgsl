// Value conversions and bitcasts between bool, i32, u32 and f32; floats are clamped, then truncated.

fn i32_of_f32(x: f32) -> i32 { return i32(x); }
// run: i32_of_f32(0.0) == 0i
// run: i32_of_f32(-0.0) == 0i
// run: i32_of_f32(0.99) == 0i
// run: i32_of_f32(-0.99) == 0i
// run: i32_of_f32(1.5) == 1i
// run: i32_of_f32(-1.5) == -1i
// run: i32_of_f32(2.1474835e+09) == 2147483520i
// run: i32_of_f32(2.1474836e+09) == 2147483520i
// run: i32_of_f32(-2.1474836e+09) == -2147483648i
// run: i32_of_f32(-2.147484e+09) == -2147483648i
// run: i32_of_f32(4.294967e+09) == 2147483520i
// run: i32_of_f32(4.2949673e+09) == 2147483520i
// run: i32_of_f32(1e+20) == 2147483520i
// run: i32_of_f32(-1e+20) == -2147483648i
// run: i32_of_f32(bitcast<f32>(0x7f800000u)) == 2147483520i
// run: i32_of_f32(bitcast<f32>(0xff800000u)) == -2147483648i
// run: i32_of_f32(bitcast<f32>(0x00000001u)) == 0i
// run: i32_of_f32(16777215.0) == 16777215i
// run: i32_of_f32(bitcast<f32>(0x7fc00000u)) == 0i

fn i32_of_f32_vec4(x: vec4<f32>) -> vec4<i32> { return vec4<i32>(x); }
// run: i32_of_f32_vec4(vec4<f32>(0.0, -0.0, 0.99, -0.99)) == vec4<i32>(0i, 0i, 0i, 0i)

fn u32_of_f32(x: f32) -> u32 { return u32(x); }
// run: u32_of_f32(0.0) == 0u
// run: u32_of_f32(-0.0) == 0u
// run: u32_of_f32(0.99) == 0u
// run: u32_of_f32(-0.99) == 0u
// run: u32_of_f32(1.5) == 1u
// run: u32_of_f32(-1.5) == 0u
// run: u32_of_f32(2.1474835e+09) == 0x7fffff80u
// run: u32_of_f32(2.1474836e+09) == 0x80000000u
// run: u32_of_f32(-2.1474836e+09) == 0u
// run: u32_of_f32(-2.147484e+09) == 0u
// run: u32_of_f32(4.294967e+09) == 0xffffff00u
// run: u32_of_f32(4.2949673e+09) == 0xffffff00u
// run: u32_of_f32(1e+20) == 0xffffff00u
// run: u32_of_f32(-1e+20) == 0u
// run: u32_of_f32(bitcast<f32>(0x7f800000u)) == 0xffffff00u
// run: u32_of_f32(bitcast<f32>(0xff800000u)) == 0u
// run: u32_of_f32(bitcast<f32>(0x00000001u)) == 0u
// run: u32_of_f32(16777215.0) == 0x00ffffffu
// run: u32_of_f32(bitcast<f32>(0x7fc00000u)) == 0u

fn u32_of_f32_vec4(x: vec4<f32>) -> vec4<u32> { return vec4<u32>(x); }
// run: u32_of_f32_vec4(vec4<f32>(0.0, -0.0, 0.99, -0.99)) == vec4<u32>(0u, 0u, 0u, 0u)

fn bool_of_f32(x: f32) -> bool { return bool(x); }
// run: bool_of_f32(0.0) == false
// run: bool_of_f32(-0.0) == false
// run: bool_of_f32(0.99) == true
// run: bool_of_f32(-0.99) == true
// run: bool_of_f32(1.5) == true
// run: bool_of_f32(-1.5) == true
// run: bool_of_f32(2.1474835e+09) == true
// run: bool_of_f32(2.1474836e+09) == true
// run: bool_of_f32(-2.1474836e+09) == true
// run: bool_of_f32(-2.147484e+09) == true
// run: bool_of_f32(4.294967e+09) == true
// run: bool_of_f32(4.2949673e+09) == true
// run: bool_of_f32(1e+20) == true
// run: bool_of_f32(-1e+20) == true
// run: bool_of_f32(bitcast<f32>(0x7f800000u)) == true
// run: bool_of_f32(bitcast<f32>(0xff800000u)) == true
// run: bool_of_f32(bitcast<f32>(0x00000001u)) == true
// run: bool_of_f32(16777215.0) == true

fn bool_of_f32_vec4(x: vec4<f32>) -> vec4<bool> { return vec4<bool>(x); }
// run: bool_of_f32_vec4(vec4<f32>(0.0, -0.0, 0.99, -0.99)) == vec4<bool>(false, false, true, true)

fn f32_of_i32(x: i32) -> f32 { return f32(x); }
// run: f32_of_i32(0i) == 0.0
// run: f32_of_i32(1i) == 1.0
// run: f32_of_i32(-1i) == -1.0
// run: f32_of_i32(2i) == 2.0
// run: f32_of_i32(-2i) == -2.0
// run: f32_of_i32(7i) == 7.0
// run: f32_of_i32(-7i) == -7.0
// run: f32_of_i32(100i) == 1e+02
// run: f32_of_i32(2147483647i) == 2.1474836e+09
// run: f32_of_i32(-2147483648i) == -2.1474836e+09
// run: f32_of_i32(-2147483647i) == -2.1474836e+09
// run: f32_of_i32(305419896i) == 3.054199e+08
// run: f32_of_i32(-305419896i) == -3.054199e+08
// run: f32_of_i32(1431655765i) == 1.4316558e+09
// run: f32_of_i32(65536i) == 65536.0
// run: f32_of_i32(16777217i) == 16777216.0
// run: f32_of_i32(16777219i) == 1.677722e+07
// run: f32_of_i32(-16777217i) == -16777216.0
// run: f32_of_i32(2147483583i) == 2.1474835e+09
// run: f32_of_i32(2147483647i) == 2.1474836e+09

fn f32_of_i32_vec4(x: vec4<i32>) -> vec4<f32> { return vec4<f32>(x); }
// run: f32_of_i32_vec4(vec4<i32>(0i, 1i, -1i, 2i)) == vec4<f32>(0.0, 1.0, -1.0, 2.0)

fn f32_of_u32(x: u32) -> f32 { return f32(x); }
// run: f32_of_u32(0u) == 0.0
// run: f32_of_u32(1u) == 1.0
// run: f32_of_u32(2u) == 2.0
// run: f32_of_u32(7u) == 7.0
// run: f32_of_u32(100u) == 1e+02
// run: f32_of_u32(0x7fffffffu) == 2.1474836e+09
// run: f32_of_u32(0x80000000u) == 2.1474836e+09
// run: f32_of_u32(0x80000001u) == 2.1474836e+09
// run: f32_of_u32(0xffffffffu) == 4.2949673e+09
// run: f32_of_u32(0xfffffffeu) == 4.2949673e+09
// run: f32_of_u32(0x12345678u) == 3.054199e+08
// run: f32_of_u32(0xaaaaaaaau) == 2.8633116e+09
// run: f32_of_u32(0x00010000u) == 65536.0
// run: f32_of_u32(65535u) == 65535.0
// run: f32_of_u32(0x01000001u) == 16777216.0
// run: f32_of_u32(0x01000003u) == 1.677722e+07
// run: f32_of_u32(0xffffff7fu) == 4.294967e+09
// run: f32_of_u32(0xffffff80u) == 4.2949673e+09
// run: f32_of_u32(0xffffff81u) == 4.2949673e+09

fn f32_of_u32_vec4(x: vec4<u32>) -> vec4<f32> { return vec4<f32>(x); }
// run: f32_of_u32_vec4(vec4<u32>(0u, 1u, 2u, 7u)) == vec4<f32>(0.0, 1.0, 2.0, 7.0)

fn f32_of_bool(x: bool) -> f32 { return f32(x); }
// run: f32_of_bool(true) == 1.0
// run: f32_of_bool(false) == 0.0
// run: f32_of_bool(true) == 1.0
// run: f32_of_bool(true) == 1.0

fn f32_of_bool_vec4(x: vec4<bool>) -> vec4<f32> { return vec4<f32>(x); }
// run: f32_of_bool_vec4(vec4<bool>(true, false, true, true)) == vec4<f32>(1.0, 0.0, 1.0, 1.0)

fn i32_of_u32(x: u32) -> i32 { return i32(x); }
// run: i32_of_u32(0u) == 0i
// run: i32_of_u32(1u) == 1i
// run: i32_of_u32(2u) == 2i
// run: i32_of_u32(7u) == 7i
// run: i32_of_u32(100u) == 100i
// run: i32_of_u32(0x7fffffffu) == 2147483647i
// run: i32_of_u32(0x80000000u) == -2147483648i
// run: i32_of_u32(0x80000001u) == -2147483647i
// run: i32_of_u32(0xffffffffu) == -1i
// run: i32_of_u32(0xfffffffeu) == -2i
// run: i32_of_u32(0x12345678u) == 305419896i
// run: i32_of_u32(0xaaaaaaaau) == -1431655766i
// run: i32_of_u32(0x00010000u) == 65536i
// run: i32_of_u32(65535u) == 65535i

fn i32_of_u32_vec4(x: vec4<u32>) -> vec4<i32> { return vec4<i32>(x); }
// run: i32_of_u32_vec4(vec4<u32>(0u, 1u, 2u, 7u)) == vec4<i32>(0i, 1i, 2i, 7i)

fn u32_of_i32(x: i32) -> u32 { return u32(x); }
// run: u32_of_i32(0i) == 0u
// run: u32_of_i32(1i) == 1u
// run: u32_of_i32(-1i) == 0xffffffffu
// run: u32_of_i32(2i) == 2u
// run: u32_of_i32(-2i) == 0xfffffffeu
// run: u32_of_i32(7i) == 7u
// run: u32_of_i32(-7i) == 0xfffffff9u
// run: u32_of_i32(100i) == 100u
// run: u32_of_i32(2147483647i) == 0x7fffffffu
// run: u32_of_i32(-2147483648i) == 0x80000000u
// run: u32_of_i32(-2147483647i) == 0x80000001u
// run: u32_of_i32(305419896i) == 0x12345678u
// run: u32_of_i32(-305419896i) == 0xedcba988u
// run: u32_of_i32(1431655765i) == 0x55555555u
// run: u32_of_i32(65536i) == 0x00010000u

fn u32_of_i32_vec4(x: vec4<i32>) -> vec4<u32> { return vec4<u32>(x); }
// run: u32_of_i32_vec4(vec4<i32>(0i, 1i, -1i, 2i)) == vec4<u32>(0u, 1u, 0xffffffffu, 2u)

fn i32_of_bool(x: bool) -> i32 { return i32(x); }
// run: i32_of_bool(true) == 1i
// run: i32_of_bool(false) == 0i
// run: i32_of_bool(false) == 0i
// run: i32_of_bool(true) == 1i

fn i32_of_bool_vec4(x: vec4<bool>) -> vec4<i32> { return vec4<i32>(x); }
// run: i32_of_bool_vec4(vec4<bool>(true, false, false, true)) == vec4<i32>(1i, 0i, 0i, 1i)

fn u32_of_bool(x: bool) -> u32 { return u32(x); }
// run: u32_of_bool(true) == 1u
// run: u32_of_bool(false) == 0u
// run: u32_of_bool(false) == 0u
// run: u32_of_bool(true) == 1u

fn u32_of_bool_vec4(x: vec4<bool>) -> vec4<u32> { return vec4<u32>(x); }
// run: u32_of_bool_vec4(vec4<bool>(true, false, false, true)) == vec4<u32>(1u, 0u, 0u, 1u)

fn bool_of_i32(x: i32) -> bool { return bool(x); }
// run: bool_of_i32(0i) == false
// run: bool_of_i32(1i) == true
// run: bool_of_i32(-1i) == true
// run: bool_of_i32(2i) == true
// run: bool_of_i32(-2i) == true
// run: bool_of_i32(7i) == true
// run: bool_of_i32(-7i) == true
// run: bool_of_i32(100i) == true
// run: bool_of_i32(2147483647i) == true
// run: bool_of_i32(-2147483648i) == true
// run: bool_of_i32(-2147483647i) == true
// run: bool_of_i32(305419896i) == true
// run: bool_of_i32(-305419896i) == true
// run: bool_of_i32(1431655765i) == true
// run: bool_of_i32(65536i) == true

fn bool_of_i32_vec4(x: vec4<i32>) -> vec4<bool> { return vec4<bool>(x); }
// run: bool_of_i32_vec4(vec4<i32>(0i, 1i, -1i, 2i)) == vec4<bool>(false, true, true, true)

fn bool_of_u32(x: u32) -> bool { return bool(x); }
// run: bool_of_u32(0u) == false
// run: bool_of_u32(1u) == true
// run: bool_of_u32(2u) == true
// run: bool_of_u32(7u) == true
// run: bool_of_u32(100u) == true
// run: bool_of_u32(0x7fffffffu) == true
// run: bool_of_u32(0x80000000u) == true
// run: bool_of_u32(0x80000001u) == true
// run: bool_of_u32(0xffffffffu) == true
// run: bool_of_u32(0xfffffffeu) == true
// run: bool_of_u32(0x12345678u) == true
// run: bool_of_u32(0xaaaaaaaau) == true
// run: bool_of_u32(0x00010000u) == true
// run: bool_of_u32(65535u) == true

fn bool_of_u32_vec4(x: vec4<u32>) -> vec4<bool> { return vec4<bool>(x); }
// run: bool_of_u32_vec4(vec4<u32>(0u, 1u, 2u, 7u)) == vec4<bool>(false, true, true, true)

fn bool_of_bool(x: bool) -> bool { return bool(x); }
// run: bool_of_bool(true) == true
// run: bool_of_bool(false) == false
// run: bool_of_bool(true) == true
// run: bool_of_bool(false) == false

fn bool_of_bool_vec4(x: vec4<bool>) -> vec4<bool> { return vec4<bool>(x); }
// run: bool_of_bool_vec4(vec4<bool>(true, false, true, false)) == vec4<bool>(true, false, true, false)

fn bits_of_f32(x: f32) -> u32 { return bitcast<u32>(x); }
// run: bits_of_f32(0.0) == 0u
// run: bits_of_f32(1.0) == 0x3f800000u
// run: bits_of_f32(-0.0) == 0x80000000u
// run: bits_of_f32(bitcast<f32>(0x7f800000u)) == 0x7f800000u
// run: bits_of_f32(-10.204444) == 0xc1234567u
// run: bits_of_f32(bitcast<f32>(0x00000001u)) == 1u

fn bits_of_f32_vec4(x: vec4<f32>) -> vec4<u32> { return bitcast<vec4<u32>>(x); }
// run: bits_of_f32_vec4(vec4<f32>(0.0, 1.0, -0.0, bitcast<f32>(0x7f800000u))) == vec4<u32>(0u, 0x3f800000u, 0x80000000u, 0x7f800000u)

fn f32_of_bits(x: u32) -> f32 { return bitcast<f32>(x); }
// run: f32_of_bits(0u) == 0.0
// run: f32_of_bits(0x3f800000u) == 1.0
// run: f32_of_bits(0x80000000u) == -0.0
// run: f32_of_bits(0x7f800000u) == bitcast<f32>(0x7f800000u)
// run: f32_of_bits(0xc1234567u) == -10.204444
// run: f32_of_bits(1u) == bitcast<f32>(0x00000001u)

fn f32_of_bits_vec4(x: vec4<u32>) -> vec4<f32> { return bitcast<vec4<f32>>(x); }
// run: f32_of_bits_vec4(vec4<u32>(0u, 0x3f800000u, 0x80000000u, 0x7f800000u)) == vec4<f32>(0.0, 1.0, -0.0, bitcast<f32>(0x7f800000u))

fn signed_bits_of_f32(x: f32) -> i32 { return bitcast<i32>(x); }
// run: signed_bits_of_f32(0.0) == 0i
// run: signed_bits_of_f32(1.0) == 1065353216i
// run: signed_bits_of_f32(-0.0) == -2147483648i
// run: signed_bits_of_f32(bitcast<f32>(0x7f800000u)) == 2139095040i
// run: signed_bits_of_f32(-10.204444) == -1054653081i
// run: signed_bits_of_f32(bitcast<f32>(0x00000001u)) == 1i

fn signed_bits_of_f32_vec4(x: vec4<f32>) -> vec4<i32> { return bitcast<vec4<i32>>(x); }
// run: signed_bits_of_f32_vec4(vec4<f32>(0.0, 1.0, -0.0, bitcast<f32>(0x7f800000u))) == vec4<i32>(0i, 1065353216i, -2147483648i, 2139095040i)

fn f32_of_signed_bits(x: i32) -> f32 { return bitcast<f32>(x); }
// run: f32_of_signed_bits(0i) == 0.0
// run: f32_of_signed_bits(1065353216i) == 1.0
// run: f32_of_signed_bits(-2147483648i) == -0.0
// run: f32_of_signed_bits(2139095040i) == bitcast<f32>(0x7f800000u)
// run: f32_of_signed_bits(-1054653081i) == -10.204444
// run: f32_of_signed_bits(1i) == bitcast<f32>(0x00000001u)

fn f32_of_signed_bits_vec4(x: vec4<i32>) -> vec4<f32> { return bitcast<vec4<f32>>(x); }
// run: f32_of_signed_bits_vec4(vec4<i32>(0i, 1065353216i, -2147483648i, 2139095040i)) == vec4<f32>(0.0, 1.0, -0.0, bitcast<f32>(0x7f800000u))

fn i32_bits_of_u32(x: u32) -> i32 { return bitcast<i32>(x); }
// run: i32_bits_of_u32(0u) == 0i
// run: i32_bits_of_u32(1u) == 1i
// run: i32_bits_of_u32(2u) == 2i
// run: i32_bits_of_u32(7u) == 7i
// run: i32_bits_of_u32(100u) == 100i
// run: i32_bits_of_u32(0x7fffffffu) == 2147483647i
// run: i32_bits_of_u32(0x80000000u) == -2147483648i
// run: i32_bits_of_u32(0x80000001u) == -2147483647i
// run: i32_bits_of_u32(0xffffffffu) == -1i
// run: i32_bits_of_u32(0xfffffffeu) == -2i
// run: i32_bits_of_u32(0x12345678u) == 305419896i
// run: i32_bits_of_u32(0xaaaaaaaau) == -1431655766i
// run: i32_bits_of_u32(0x00010000u) == 65536i
// run: i32_bits_of_u32(65535u) == 65535i

fn i32_bits_of_u32_vec4(x: vec4<u32>) -> vec4<i32> { return bitcast<vec4<i32>>(x); }
// run: i32_bits_of_u32_vec4(vec4<u32>(0u, 1u, 2u, 7u)) == vec4<i32>(0i, 1i, 2i, 7i)

fn u32_bits_of_i32(x: i32) -> u32 { return bitcast<u32>(x); }
// run: u32_bits_of_i32(0i) == 0u
// run: u32_bits_of_i32(1i) == 1u
// run: u32_bits_of_i32(-1i) == 0xffffffffu
// run: u32_bits_of_i32(2i) == 2u
// run: u32_bits_of_i32(-2i) == 0xfffffffeu
// run: u32_bits_of_i32(7i) == 7u
// run: u32_bits_of_i32(-7i) == 0xfffffff9u
// run: u32_bits_of_i32(100i) == 100u
// run: u32_bits_of_i32(2147483647i) == 0x7fffffffu
// run: u32_bits_of_i32(-2147483648i) == 0x80000000u
// run: u32_bits_of_i32(-2147483647i) == 0x80000001u
// run: u32_bits_of_i32(305419896i) == 0x12345678u
// run: u32_bits_of_i32(-305419896i) == 0xedcba988u
// run: u32_bits_of_i32(1431655765i) == 0x55555555u
// run: u32_bits_of_i32(65536i) == 0x00010000u

fn u32_bits_of_i32_vec4(x: vec4<i32>) -> vec4<u32> { return bitcast<vec4<u32>>(x); }
// run: u32_bits_of_i32_vec4(vec4<i32>(0i, 1i, -1i, 2i)) == vec4<u32>(0u, 1u, 0xffffffffu, 2u)

fn nan_keeps_its_bits(x: u32) -> u32 { return bitcast<u32>(bitcast<f32>(x)); }
// run: nan_keeps_its_bits(0x7fc00000u) == 0x7fc00000u
// run: nan_keeps_its_bits(0xffc00001u) == 0xffc00001u
// run: nan_keeps_its_bits(0x7fffffffu) == 0x7fffffffu
// run: nan_keeps_its_bits(0x7f812345u) == 0x7f812345u

fn negated_bits(x: u32) -> u32 { return bitcast<u32>(-bitcast<f32>(x)); }
// run: negated_bits(0u) == 0x80000000u
// run: negated_bits(0x80000000u) == 0u
// run: negated_bits(0x7fc00000u) == 0xffc00000u
// run: negated_bits(0xffc12345u) == 0x7fc12345u
// run: negated_bits(0x3f800000u) == 0xbf800000u

fn abs_bits(x: u32) -> u32 { return bitcast<u32>(abs(bitcast<f32>(x))); }
// run: abs_bits(0u) == 0u
// run: abs_bits(0x80000000u) == 0u
// run: abs_bits(0xffc12345u) == 0x7fc12345u
// run: abs_bits(0xbf800000u) == 0x3f800000u
