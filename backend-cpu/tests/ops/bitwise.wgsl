// and, or, xor, not and shifts; shift amounts count modulo 32 at run time.

fn and_i32(x: i32, y: i32) -> i32 { return x & y; }
// run: and_i32(0i, 1i) == 0i
// run: and_i32(0i, -2i) == 0i
// run: and_i32(0i, 100i) == 0i
// run: and_i32(0i, -2147483647i) == 0i
// run: and_i32(0i, 1431655765i) == 0i
// run: and_i32(-1i, 1i) == 1i
// run: and_i32(-1i, -2i) == -2i
// run: and_i32(-1i, 100i) == 100i
// run: and_i32(-1i, -2147483647i) == -2147483647i
// run: and_i32(-1i, 1431655765i) == 1431655765i
// run: and_i32(-2i, 1i) == 0i
// run: and_i32(-2i, -2i) == -2i
// run: and_i32(-2i, 100i) == 100i
// run: and_i32(-2i, -2147483647i) == -2147483648i
// run: and_i32(-2i, 1431655765i) == 1431655764i
// run: and_i32(-7i, 1i) == 1i
// run: and_i32(-7i, -2i) == -8i
// run: and_i32(-7i, 100i) == 96i
// run: and_i32(-7i, -2147483647i) == -2147483647i
// run: and_i32(-7i, 1431655765i) == 1431655761i
// run: and_i32(2147483647i, 1i) == 1i
// run: and_i32(2147483647i, -2i) == 2147483646i
// run: and_i32(2147483647i, 100i) == 100i
// run: and_i32(2147483647i, -2147483647i) == 1i
// run: and_i32(2147483647i, 1431655765i) == 1431655765i
// run: and_i32(-2147483647i, 1i) == 1i
// run: and_i32(-2147483647i, -2i) == -2147483648i
// run: and_i32(-2147483647i, 100i) == 0i
// run: and_i32(-2147483647i, -2147483647i) == -2147483647i
// run: and_i32(-2147483647i, 1431655765i) == 1i
// run: and_i32(-305419896i, 1i) == 0i
// run: and_i32(-305419896i, -2i) == -305419896i
// run: and_i32(-305419896i, 100i) == 0i
// run: and_i32(-305419896i, -2147483647i) == -2147483648i
// run: and_i32(-305419896i, 1431655765i) == 1161888000i
// run: and_i32(65536i, 1i) == 0i
// run: and_i32(65536i, -2i) == 65536i
// run: and_i32(65536i, 100i) == 0i
// run: and_i32(65536i, -2147483647i) == 0i
// run: and_i32(65536i, 1431655765i) == 65536i

fn and_i32_vec4(x: vec4<i32>, y: vec4<i32>) -> vec4<i32> { return x & y; }
// run: and_i32_vec4(vec4<i32>(0i, 1i, -1i, 2i), vec4<i32>(-7i, 100i, 2147483647i, -2147483648i)) == vec4<i32>(0i, 0i, 2147483647i, 0i)
// run: and_i32_vec4(vec4<i32>(-2i, 7i, -7i, 100i), vec4<i32>(100i, 2147483647i, -2147483648i, -2147483647i)) == vec4<i32>(100i, 7i, -2147483648i, 0i)

fn or_i32(x: i32, y: i32) -> i32 { return x | y; }
// run: or_i32(0i, 1i) == 1i
// run: or_i32(0i, -2i) == -2i
// run: or_i32(0i, 100i) == 100i
// run: or_i32(0i, -2147483647i) == -2147483647i
// run: or_i32(0i, 1431655765i) == 1431655765i
// run: or_i32(-1i, 1i) == -1i
// run: or_i32(-1i, -2i) == -1i
// run: or_i32(-1i, 100i) == -1i
// run: or_i32(-1i, -2147483647i) == -1i
// run: or_i32(-1i, 1431655765i) == -1i
// run: or_i32(-2i, 1i) == -1i
// run: or_i32(-2i, -2i) == -2i
// run: or_i32(-2i, 100i) == -2i
// run: or_i32(-2i, -2147483647i) == -1i
// run: or_i32(-2i, 1431655765i) == -1i
// run: or_i32(-7i, 1i) == -7i
// run: or_i32(-7i, -2i) == -1i
// run: or_i32(-7i, 100i) == -3i
// run: or_i32(-7i, -2147483647i) == -7i
// run: or_i32(-7i, 1431655765i) == -3i
// run: or_i32(2147483647i, 1i) == 2147483647i
// run: or_i32(2147483647i, -2i) == -1i
// run: or_i32(2147483647i, 100i) == 2147483647i
// run: or_i32(2147483647i, -2147483647i) == -1i
// run: or_i32(2147483647i, 1431655765i) == 2147483647i
// run: or_i32(-2147483647i, 1i) == -2147483647i
// run: or_i32(-2147483647i, -2i) == -1i
// run: or_i32(-2147483647i, 100i) == -2147483547i
// run: or_i32(-2147483647i, -2147483647i) == -2147483647i
// run: or_i32(-2147483647i, 1431655765i) == -715827883i
// run: or_i32(-305419896i, 1i) == -305419895i
// run: or_i32(-305419896i, -2i) == -2i
// run: or_i32(-305419896i, 100i) == -305419796i
// run: or_i32(-305419896i, -2147483647i) == -305419895i
// run: or_i32(-305419896i, 1431655765i) == -35652131i
// run: or_i32(65536i, 1i) == 65537i
// run: or_i32(65536i, -2i) == -2i
// run: or_i32(65536i, 100i) == 65636i
// run: or_i32(65536i, -2147483647i) == -2147418111i
// run: or_i32(65536i, 1431655765i) == 1431655765i

fn or_i32_vec4(x: vec4<i32>, y: vec4<i32>) -> vec4<i32> { return x | y; }
// run: or_i32_vec4(vec4<i32>(0i, 1i, -1i, 2i), vec4<i32>(-7i, 100i, 2147483647i, -2147483648i)) == vec4<i32>(-7i, 101i, -1i, -2147483646i)
// run: or_i32_vec4(vec4<i32>(-2i, 7i, -7i, 100i), vec4<i32>(100i, 2147483647i, -2147483648i, -2147483647i)) == vec4<i32>(-2i, 2147483647i, -7i, -2147483547i)

fn xor_i32(x: i32, y: i32) -> i32 { return x ^ y; }
// run: xor_i32(0i, 1i) == 1i
// run: xor_i32(0i, -2i) == -2i
// run: xor_i32(0i, 100i) == 100i
// run: xor_i32(0i, -2147483647i) == -2147483647i
// run: xor_i32(0i, 1431655765i) == 1431655765i
// run: xor_i32(-1i, 1i) == -2i
// run: xor_i32(-1i, -2i) == 1i
// run: xor_i32(-1i, 100i) == -101i
// run: xor_i32(-1i, -2147483647i) == 2147483646i
// run: xor_i32(-1i, 1431655765i) == -1431655766i
// run: xor_i32(-2i, 1i) == -1i
// run: xor_i32(-2i, -2i) == 0i
// run: xor_i32(-2i, 100i) == -102i
// run: xor_i32(-2i, -2147483647i) == 2147483647i
// run: xor_i32(-2i, 1431655765i) == -1431655765i
// run: xor_i32(-7i, 1i) == -8i
// run: xor_i32(-7i, -2i) == 7i
// run: xor_i32(-7i, 100i) == -99i
// run: xor_i32(-7i, -2147483647i) == 2147483640i
// run: xor_i32(-7i, 1431655765i) == -1431655764i
// run: xor_i32(2147483647i, 1i) == 2147483646i
// run: xor_i32(2147483647i, -2i) == -2147483647i
// run: xor_i32(2147483647i, 100i) == 2147483547i
// run: xor_i32(2147483647i, -2147483647i) == -2i
// run: xor_i32(2147483647i, 1431655765i) == 715827882i
// run: xor_i32(-2147483647i, 1i) == -2147483648i
// run: xor_i32(-2147483647i, -2i) == 2147483647i
// run: xor_i32(-2147483647i, 100i) == -2147483547i
// run: xor_i32(-2147483647i, -2147483647i) == 0i
// run: xor_i32(-2147483647i, 1431655765i) == -715827884i
// run: xor_i32(-305419896i, 1i) == -305419895i
// run: xor_i32(-305419896i, -2i) == 305419894i
// run: xor_i32(-305419896i, 100i) == -305419796i
// run: xor_i32(-305419896i, -2147483647i) == 1842063753i
// run: xor_i32(-305419896i, 1431655765i) == -1197540131i
// run: xor_i32(65536i, 1i) == 65537i
// run: xor_i32(65536i, -2i) == -65538i
// run: xor_i32(65536i, 100i) == 65636i
// run: xor_i32(65536i, -2147483647i) == -2147418111i
// run: xor_i32(65536i, 1431655765i) == 1431590229i

fn xor_i32_vec4(x: vec4<i32>, y: vec4<i32>) -> vec4<i32> { return x ^ y; }
// run: xor_i32_vec4(vec4<i32>(0i, 1i, -1i, 2i), vec4<i32>(-7i, 100i, 2147483647i, -2147483648i)) == vec4<i32>(-7i, 101i, -2147483648i, -2147483646i)
// run: xor_i32_vec4(vec4<i32>(-2i, 7i, -7i, 100i), vec4<i32>(100i, 2147483647i, -2147483648i, -2147483647i)) == vec4<i32>(-102i, 2147483640i, 2147483641i, -2147483547i)

fn not_i32(x: i32) -> i32 { return ~x; }
// run: not_i32(0i) == -1i
// run: not_i32(1i) == -2i
// run: not_i32(-1i) == 0i
// run: not_i32(2i) == -3i
// run: not_i32(-2i) == 1i
// run: not_i32(7i) == -8i
// run: not_i32(-7i) == 6i
// run: not_i32(100i) == -101i
// run: not_i32(2147483647i) == -2147483648i
// run: not_i32(-2147483648i) == 2147483647i
// run: not_i32(-2147483647i) == 2147483646i
// run: not_i32(305419896i) == -305419897i
// run: not_i32(-305419896i) == 305419895i
// run: not_i32(1431655765i) == -1431655766i
// run: not_i32(65536i) == -65537i

fn shl_i32(x: i32, y: u32) -> i32 { return x << y; }
// run: shl_i32(0i, 0u) == 0i
// run: shl_i32(0i, 1u) == 0i
// run: shl_i32(0i, 5u) == 0i
// run: shl_i32(0i, 31u) == 0i
// run: shl_i32(0i, 32u) == 0i
// run: shl_i32(0i, 33u) == 0i
// run: shl_i32(0i, 63u) == 0i
// run: shl_i32(0i, 0xffffffffu) == 0i
// run: shl_i32(-1i, 0u) == -1i
// run: shl_i32(-1i, 1u) == -2i
// run: shl_i32(-1i, 5u) == -32i
// run: shl_i32(-1i, 31u) == -2147483648i
// run: shl_i32(-1i, 32u) == -1i
// run: shl_i32(-1i, 33u) == -2i
// run: shl_i32(-1i, 63u) == -2147483648i
// run: shl_i32(-1i, 0xffffffffu) == -2147483648i
// run: shl_i32(-2i, 0u) == -2i
// run: shl_i32(-2i, 1u) == -4i
// run: shl_i32(-2i, 5u) == -64i
// run: shl_i32(-2i, 31u) == 0i
// run: shl_i32(-2i, 32u) == -2i
// run: shl_i32(-2i, 33u) == -4i
// run: shl_i32(-2i, 63u) == 0i
// run: shl_i32(-2i, 0xffffffffu) == 0i
// run: shl_i32(-7i, 0u) == -7i
// run: shl_i32(-7i, 1u) == -14i
// run: shl_i32(-7i, 5u) == -224i
// run: shl_i32(-7i, 31u) == -2147483648i
// run: shl_i32(-7i, 32u) == -7i
// run: shl_i32(-7i, 33u) == -14i
// run: shl_i32(-7i, 63u) == -2147483648i
// run: shl_i32(-7i, 0xffffffffu) == -2147483648i
// run: shl_i32(2147483647i, 0u) == 2147483647i
// run: shl_i32(2147483647i, 1u) == -2i
// run: shl_i32(2147483647i, 5u) == -32i
// run: shl_i32(2147483647i, 31u) == -2147483648i
// run: shl_i32(2147483647i, 32u) == 2147483647i
// run: shl_i32(2147483647i, 33u) == -2i
// run: shl_i32(2147483647i, 63u) == -2147483648i
// run: shl_i32(2147483647i, 0xffffffffu) == -2147483648i
// run: shl_i32(-2147483647i, 0u) == -2147483647i
// run: shl_i32(-2147483647i, 1u) == 2i
// run: shl_i32(-2147483647i, 5u) == 32i
// run: shl_i32(-2147483647i, 31u) == -2147483648i
// run: shl_i32(-2147483647i, 32u) == -2147483647i
// run: shl_i32(-2147483647i, 33u) == 2i
// run: shl_i32(-2147483647i, 63u) == -2147483648i
// run: shl_i32(-2147483647i, 0xffffffffu) == -2147483648i
// run: shl_i32(-305419896i, 0u) == -305419896i
// run: shl_i32(-305419896i, 1u) == -610839792i
// run: shl_i32(-305419896i, 5u) == -1183502080i
// run: shl_i32(-305419896i, 31u) == 0i
// run: shl_i32(-305419896i, 32u) == -305419896i
// run: shl_i32(-305419896i, 33u) == -610839792i
// run: shl_i32(-305419896i, 63u) == 0i
// run: shl_i32(-305419896i, 0xffffffffu) == 0i
// run: shl_i32(65536i, 0u) == 65536i
// run: shl_i32(65536i, 1u) == 131072i
// run: shl_i32(65536i, 5u) == 2097152i
// run: shl_i32(65536i, 31u) == 0i
// run: shl_i32(65536i, 32u) == 65536i
// run: shl_i32(65536i, 33u) == 131072i
// run: shl_i32(65536i, 63u) == 0i
// run: shl_i32(65536i, 0xffffffffu) == 0i
// run: shl_i32(-2147483647i, 0u) == -2147483647i
// run: shl_i32(-2147483647i, 1u) == 2i
// run: shl_i32(-2147483647i, 5u) == 32i
// run: shl_i32(-2147483647i, 31u) == -2147483648i
// run: shl_i32(-2147483647i, 32u) == -2147483647i
// run: shl_i32(-2147483647i, 33u) == 2i
// run: shl_i32(-2147483647i, 63u) == -2147483648i
// run: shl_i32(-2147483647i, 0xffffffffu) == -2147483648i

fn shl_i32_vec3(x: vec3<i32>, y: vec3<u32>) -> vec3<i32> { return x << y; }
// run: shl_i32_vec3(vec3<i32>(0i, 1i, -1i), vec3<u32>(0u, 31u, 32u)) == vec3<i32>(0i, -2147483648i, -1i)
// run: shl_i32_vec3(vec3<i32>(2i, -2i, 7i), vec3<u32>(1u, 30u, 33u)) == vec3<i32>(4i, -2147483648i, 14i)
// run: shl_i32_vec3(vec3<i32>(-7i, 100i, 2147483647i), vec3<u32>(2u, 29u, 34u)) == vec3<i32>(-28i, -2147483648i, -4i)

fn shl_i32_by_0(x: i32) -> i32 { return x << 0u; }
// run: shl_i32_by_0(1i) == 1i
// run: shl_i32_by_0(-2i) == -2i
// run: shl_i32_by_0(100i) == 100i
// run: shl_i32_by_0(-2147483647i) == -2147483647i
// run: shl_i32_by_0(1431655765i) == 1431655765i

fn shl_i32_by_1(x: i32) -> i32 { return x << 1u; }
// run: shl_i32_by_1(1i) == 2i
// run: shl_i32_by_1(-2i) == -4i
// run: shl_i32_by_1(100i) == 200i
// run: shl_i32_by_1(-2147483647i) == 2i
// run: shl_i32_by_1(1431655765i) == -1431655766i

fn shl_i32_by_13(x: i32) -> i32 { return x << 13u; }
// run: shl_i32_by_13(1i) == 8192i
// run: shl_i32_by_13(-2i) == -16384i
// run: shl_i32_by_13(100i) == 819200i
// run: shl_i32_by_13(-2147483647i) == 8192i
// run: shl_i32_by_13(1431655765i) == -1431658496i

fn shl_i32_by_31(x: i32) -> i32 { return x << 31u; }
// run: shl_i32_by_31(1i) == -2147483648i
// run: shl_i32_by_31(-2i) == 0i
// run: shl_i32_by_31(100i) == 0i
// run: shl_i32_by_31(-2147483647i) == -2147483648i
// run: shl_i32_by_31(1431655765i) == -2147483648i

fn shr_i32(x: i32, y: u32) -> i32 { return x >> y; }
// run: shr_i32(0i, 0u) == 0i
// run: shr_i32(0i, 1u) == 0i
// run: shr_i32(0i, 5u) == 0i
// run: shr_i32(0i, 31u) == 0i
// run: shr_i32(0i, 32u) == 0i
// run: shr_i32(0i, 33u) == 0i
// run: shr_i32(0i, 63u) == 0i
// run: shr_i32(0i, 0xffffffffu) == 0i
// run: shr_i32(-1i, 0u) == -1i
// run: shr_i32(-1i, 1u) == -1i
// run: shr_i32(-1i, 5u) == -1i
// run: shr_i32(-1i, 31u) == -1i
// run: shr_i32(-1i, 32u) == -1i
// run: shr_i32(-1i, 33u) == -1i
// run: shr_i32(-1i, 63u) == -1i
// run: shr_i32(-1i, 0xffffffffu) == -1i
// run: shr_i32(-2i, 0u) == -2i
// run: shr_i32(-2i, 1u) == -1i
// run: shr_i32(-2i, 5u) == -1i
// run: shr_i32(-2i, 31u) == -1i
// run: shr_i32(-2i, 32u) == -2i
// run: shr_i32(-2i, 33u) == -1i
// run: shr_i32(-2i, 63u) == -1i
// run: shr_i32(-2i, 0xffffffffu) == -1i
// run: shr_i32(-7i, 0u) == -7i
// run: shr_i32(-7i, 1u) == -4i
// run: shr_i32(-7i, 5u) == -1i
// run: shr_i32(-7i, 31u) == -1i
// run: shr_i32(-7i, 32u) == -7i
// run: shr_i32(-7i, 33u) == -4i
// run: shr_i32(-7i, 63u) == -1i
// run: shr_i32(-7i, 0xffffffffu) == -1i
// run: shr_i32(2147483647i, 0u) == 2147483647i
// run: shr_i32(2147483647i, 1u) == 1073741823i
// run: shr_i32(2147483647i, 5u) == 67108863i
// run: shr_i32(2147483647i, 31u) == 0i
// run: shr_i32(2147483647i, 32u) == 2147483647i
// run: shr_i32(2147483647i, 33u) == 1073741823i
// run: shr_i32(2147483647i, 63u) == 0i
// run: shr_i32(2147483647i, 0xffffffffu) == 0i
// run: shr_i32(-2147483647i, 0u) == -2147483647i
// run: shr_i32(-2147483647i, 1u) == -1073741824i
// run: shr_i32(-2147483647i, 5u) == -67108864i
// run: shr_i32(-2147483647i, 31u) == -1i
// run: shr_i32(-2147483647i, 32u) == -2147483647i
// run: shr_i32(-2147483647i, 33u) == -1073741824i
// run: shr_i32(-2147483647i, 63u) == -1i
// run: shr_i32(-2147483647i, 0xffffffffu) == -1i
// run: shr_i32(-305419896i, 0u) == -305419896i
// run: shr_i32(-305419896i, 1u) == -152709948i
// run: shr_i32(-305419896i, 5u) == -9544372i
// run: shr_i32(-305419896i, 31u) == -1i
// run: shr_i32(-305419896i, 32u) == -305419896i
// run: shr_i32(-305419896i, 33u) == -152709948i
// run: shr_i32(-305419896i, 63u) == -1i
// run: shr_i32(-305419896i, 0xffffffffu) == -1i
// run: shr_i32(65536i, 0u) == 65536i
// run: shr_i32(65536i, 1u) == 32768i
// run: shr_i32(65536i, 5u) == 2048i
// run: shr_i32(65536i, 31u) == 0i
// run: shr_i32(65536i, 32u) == 65536i
// run: shr_i32(65536i, 33u) == 32768i
// run: shr_i32(65536i, 63u) == 0i
// run: shr_i32(65536i, 0xffffffffu) == 0i
// run: shr_i32(-2147483647i, 0u) == -2147483647i
// run: shr_i32(-2147483647i, 1u) == -1073741824i
// run: shr_i32(-2147483647i, 5u) == -67108864i
// run: shr_i32(-2147483647i, 31u) == -1i
// run: shr_i32(-2147483647i, 32u) == -2147483647i
// run: shr_i32(-2147483647i, 33u) == -1073741824i
// run: shr_i32(-2147483647i, 63u) == -1i
// run: shr_i32(-2147483647i, 0xffffffffu) == -1i

fn shr_i32_vec3(x: vec3<i32>, y: vec3<u32>) -> vec3<i32> { return x >> y; }
// run: shr_i32_vec3(vec3<i32>(0i, 1i, -1i), vec3<u32>(0u, 31u, 32u)) == vec3<i32>(0i, 0i, -1i)
// run: shr_i32_vec3(vec3<i32>(2i, -2i, 7i), vec3<u32>(1u, 30u, 33u)) == vec3<i32>(1i, -1i, 3i)
// run: shr_i32_vec3(vec3<i32>(-7i, 100i, 2147483647i), vec3<u32>(2u, 29u, 34u)) == vec3<i32>(-2i, 0i, 536870911i)

fn shr_i32_by_0(x: i32) -> i32 { return x >> 0u; }
// run: shr_i32_by_0(1i) == 1i
// run: shr_i32_by_0(-2i) == -2i
// run: shr_i32_by_0(100i) == 100i
// run: shr_i32_by_0(-2147483647i) == -2147483647i
// run: shr_i32_by_0(1431655765i) == 1431655765i

fn shr_i32_by_1(x: i32) -> i32 { return x >> 1u; }
// run: shr_i32_by_1(1i) == 0i
// run: shr_i32_by_1(-2i) == -1i
// run: shr_i32_by_1(100i) == 50i
// run: shr_i32_by_1(-2147483647i) == -1073741824i
// run: shr_i32_by_1(1431655765i) == 715827882i

fn shr_i32_by_13(x: i32) -> i32 { return x >> 13u; }
// run: shr_i32_by_13(1i) == 0i
// run: shr_i32_by_13(-2i) == -1i
// run: shr_i32_by_13(100i) == 0i
// run: shr_i32_by_13(-2147483647i) == -262144i
// run: shr_i32_by_13(1431655765i) == 174762i

fn shr_i32_by_31(x: i32) -> i32 { return x >> 31u; }
// run: shr_i32_by_31(1i) == 0i
// run: shr_i32_by_31(-2i) == -1i
// run: shr_i32_by_31(100i) == 0i
// run: shr_i32_by_31(-2147483647i) == -1i
// run: shr_i32_by_31(1431655765i) == 0i

fn and_u32(x: u32, y: u32) -> u32 { return x & y; }
// run: and_u32(0u, 1u) == 0u
// run: and_u32(0u, 100u) == 0u
// run: and_u32(0u, 0x80000001u) == 0u
// run: and_u32(0u, 0x12345678u) == 0u
// run: and_u32(0u, 65535u) == 0u
// run: and_u32(2u, 1u) == 0u
// run: and_u32(2u, 100u) == 0u
// run: and_u32(2u, 0x80000001u) == 0u
// run: and_u32(2u, 0x12345678u) == 0u
// run: and_u32(2u, 65535u) == 2u
// run: and_u32(100u, 1u) == 0u
// run: and_u32(100u, 100u) == 100u
// run: and_u32(100u, 0x80000001u) == 0u
// run: and_u32(100u, 0x12345678u) == 96u
// run: and_u32(100u, 65535u) == 100u
// run: and_u32(0x80000000u, 1u) == 0u
// run: and_u32(0x80000000u, 100u) == 0u
// run: and_u32(0x80000000u, 0x80000001u) == 0x80000000u
// run: and_u32(0x80000000u, 0x12345678u) == 0u
// run: and_u32(0x80000000u, 65535u) == 0u
// run: and_u32(0xffffffffu, 1u) == 1u
// run: and_u32(0xffffffffu, 100u) == 100u
// run: and_u32(0xffffffffu, 0x80000001u) == 0x80000001u
// run: and_u32(0xffffffffu, 0x12345678u) == 0x12345678u
// run: and_u32(0xffffffffu, 65535u) == 65535u
// run: and_u32(0x12345678u, 1u) == 0u
// run: and_u32(0x12345678u, 100u) == 96u
// run: and_u32(0x12345678u, 0x80000001u) == 0u
// run: and_u32(0x12345678u, 0x12345678u) == 0x12345678u
// run: and_u32(0x12345678u, 65535u) == 22136u
// run: and_u32(0x00010000u, 1u) == 0u
// run: and_u32(0x00010000u, 100u) == 0u
// run: and_u32(0x00010000u, 0x80000001u) == 0u
// run: and_u32(0x00010000u, 0x12345678u) == 0u
// run: and_u32(0x00010000u, 65535u) == 0u

fn and_u32_vec4(x: vec4<u32>, y: vec4<u32>) -> vec4<u32> { return x & y; }
// run: and_u32_vec4(vec4<u32>(0u, 1u, 2u, 7u), vec4<u32>(0x80000000u, 0x80000001u, 0xffffffffu, 0xfffffffeu)) == vec4<u32>(0u, 1u, 2u, 6u)
// run: and_u32_vec4(vec4<u32>(100u, 0x7fffffffu, 0x80000000u, 0x80000001u), vec4<u32>(0x80000001u, 0xffffffffu, 0xfffffffeu, 0x12345678u)) == vec4<u32>(0u, 0x7fffffffu, 0x80000000u, 0u)

fn or_u32(x: u32, y: u32) -> u32 { return x | y; }
// run: or_u32(0u, 1u) == 1u
// run: or_u32(0u, 100u) == 100u
// run: or_u32(0u, 0x80000001u) == 0x80000001u
// run: or_u32(0u, 0x12345678u) == 0x12345678u
// run: or_u32(0u, 65535u) == 65535u
// run: or_u32(2u, 1u) == 3u
// run: or_u32(2u, 100u) == 102u
// run: or_u32(2u, 0x80000001u) == 0x80000003u
// run: or_u32(2u, 0x12345678u) == 0x1234567au
// run: or_u32(2u, 65535u) == 65535u
// run: or_u32(100u, 1u) == 101u
// run: or_u32(100u, 100u) == 100u
// run: or_u32(100u, 0x80000001u) == 0x80000065u
// run: or_u32(100u, 0x12345678u) == 0x1234567cu
// run: or_u32(100u, 65535u) == 65535u
// run: or_u32(0x80000000u, 1u) == 0x80000001u
// run: or_u32(0x80000000u, 100u) == 0x80000064u
// run: or_u32(0x80000000u, 0x80000001u) == 0x80000001u
// run: or_u32(0x80000000u, 0x12345678u) == 0x92345678u
// run: or_u32(0x80000000u, 65535u) == 0x8000ffffu
// run: or_u32(0xffffffffu, 1u) == 0xffffffffu
// run: or_u32(0xffffffffu, 100u) == 0xffffffffu
// run: or_u32(0xffffffffu, 0x80000001u) == 0xffffffffu
// run: or_u32(0xffffffffu, 0x12345678u) == 0xffffffffu
// run: or_u32(0xffffffffu, 65535u) == 0xffffffffu
// run: or_u32(0x12345678u, 1u) == 0x12345679u
// run: or_u32(0x12345678u, 100u) == 0x1234567cu
// run: or_u32(0x12345678u, 0x80000001u) == 0x92345679u
// run: or_u32(0x12345678u, 0x12345678u) == 0x12345678u
// run: or_u32(0x12345678u, 65535u) == 0x1234ffffu
// run: or_u32(0x00010000u, 1u) == 0x00010001u
// run: or_u32(0x00010000u, 100u) == 0x00010064u
// run: or_u32(0x00010000u, 0x80000001u) == 0x80010001u
// run: or_u32(0x00010000u, 0x12345678u) == 0x12355678u
// run: or_u32(0x00010000u, 65535u) == 0x0001ffffu

fn or_u32_vec4(x: vec4<u32>, y: vec4<u32>) -> vec4<u32> { return x | y; }
// run: or_u32_vec4(vec4<u32>(0u, 1u, 2u, 7u), vec4<u32>(0x80000000u, 0x80000001u, 0xffffffffu, 0xfffffffeu)) == vec4<u32>(0x80000000u, 0x80000001u, 0xffffffffu, 0xffffffffu)
// run: or_u32_vec4(vec4<u32>(100u, 0x7fffffffu, 0x80000000u, 0x80000001u), vec4<u32>(0x80000001u, 0xffffffffu, 0xfffffffeu, 0x12345678u)) == vec4<u32>(0x80000065u, 0xffffffffu, 0xfffffffeu, 0x92345679u)

fn xor_u32(x: u32, y: u32) -> u32 { return x ^ y; }
// run: xor_u32(0u, 1u) == 1u
// run: xor_u32(0u, 100u) == 100u
// run: xor_u32(0u, 0x80000001u) == 0x80000001u
// run: xor_u32(0u, 0x12345678u) == 0x12345678u
// run: xor_u32(0u, 65535u) == 65535u
// run: xor_u32(2u, 1u) == 3u
// run: xor_u32(2u, 100u) == 102u
// run: xor_u32(2u, 0x80000001u) == 0x80000003u
// run: xor_u32(2u, 0x12345678u) == 0x1234567au
// run: xor_u32(2u, 65535u) == 65533u
// run: xor_u32(100u, 1u) == 101u
// run: xor_u32(100u, 100u) == 0u
// run: xor_u32(100u, 0x80000001u) == 0x80000065u
// run: xor_u32(100u, 0x12345678u) == 0x1234561cu
// run: xor_u32(100u, 65535u) == 65435u
// run: xor_u32(0x80000000u, 1u) == 0x80000001u
// run: xor_u32(0x80000000u, 100u) == 0x80000064u
// run: xor_u32(0x80000000u, 0x80000001u) == 1u
// run: xor_u32(0x80000000u, 0x12345678u) == 0x92345678u
// run: xor_u32(0x80000000u, 65535u) == 0x8000ffffu
// run: xor_u32(0xffffffffu, 1u) == 0xfffffffeu
// run: xor_u32(0xffffffffu, 100u) == 0xffffff9bu
// run: xor_u32(0xffffffffu, 0x80000001u) == 0x7ffffffeu
// run: xor_u32(0xffffffffu, 0x12345678u) == 0xedcba987u
// run: xor_u32(0xffffffffu, 65535u) == 0xffff0000u
// run: xor_u32(0x12345678u, 1u) == 0x12345679u
// run: xor_u32(0x12345678u, 100u) == 0x1234561cu
// run: xor_u32(0x12345678u, 0x80000001u) == 0x92345679u
// run: xor_u32(0x12345678u, 0x12345678u) == 0u
// run: xor_u32(0x12345678u, 65535u) == 0x1234a987u
// run: xor_u32(0x00010000u, 1u) == 0x00010001u
// run: xor_u32(0x00010000u, 100u) == 0x00010064u
// run: xor_u32(0x00010000u, 0x80000001u) == 0x80010001u
// run: xor_u32(0x00010000u, 0x12345678u) == 0x12355678u
// run: xor_u32(0x00010000u, 65535u) == 0x0001ffffu

fn xor_u32_vec4(x: vec4<u32>, y: vec4<u32>) -> vec4<u32> { return x ^ y; }
// run: xor_u32_vec4(vec4<u32>(0u, 1u, 2u, 7u), vec4<u32>(0x80000000u, 0x80000001u, 0xffffffffu, 0xfffffffeu)) == vec4<u32>(0x80000000u, 0x80000000u, 0xfffffffdu, 0xfffffff9u)
// run: xor_u32_vec4(vec4<u32>(100u, 0x7fffffffu, 0x80000000u, 0x80000001u), vec4<u32>(0x80000001u, 0xffffffffu, 0xfffffffeu, 0x12345678u)) == vec4<u32>(0x80000065u, 0x80000000u, 0x7ffffffeu, 0x92345679u)

fn not_u32(x: u32) -> u32 { return ~x; }
// run: not_u32(0u) == 0xffffffffu
// run: not_u32(1u) == 0xfffffffeu
// run: not_u32(2u) == 0xfffffffdu
// run: not_u32(7u) == 0xfffffff8u
// run: not_u32(100u) == 0xffffff9bu
// run: not_u32(0x7fffffffu) == 0x80000000u
// run: not_u32(0x80000000u) == 0x7fffffffu
// run: not_u32(0x80000001u) == 0x7ffffffeu
// run: not_u32(0xffffffffu) == 0u
// run: not_u32(0xfffffffeu) == 1u
// run: not_u32(0x12345678u) == 0xedcba987u
// run: not_u32(0xaaaaaaaau) == 0x55555555u
// run: not_u32(0x00010000u) == 0xfffeffffu
// run: not_u32(65535u) == 0xffff0000u

fn shl_u32(x: u32, y: u32) -> u32 { return x << y; }
// run: shl_u32(0u, 0u) == 0u
// run: shl_u32(0u, 1u) == 0u
// run: shl_u32(0u, 5u) == 0u
// run: shl_u32(0u, 31u) == 0u
// run: shl_u32(0u, 32u) == 0u
// run: shl_u32(0u, 33u) == 0u
// run: shl_u32(0u, 63u) == 0u
// run: shl_u32(0u, 0xffffffffu) == 0u
// run: shl_u32(2u, 0u) == 2u
// run: shl_u32(2u, 1u) == 4u
// run: shl_u32(2u, 5u) == 64u
// run: shl_u32(2u, 31u) == 0u
// run: shl_u32(2u, 32u) == 2u
// run: shl_u32(2u, 33u) == 4u
// run: shl_u32(2u, 63u) == 0u
// run: shl_u32(2u, 0xffffffffu) == 0u
// run: shl_u32(100u, 0u) == 100u
// run: shl_u32(100u, 1u) == 200u
// run: shl_u32(100u, 5u) == 3200u
// run: shl_u32(100u, 31u) == 0u
// run: shl_u32(100u, 32u) == 100u
// run: shl_u32(100u, 33u) == 200u
// run: shl_u32(100u, 63u) == 0u
// run: shl_u32(100u, 0xffffffffu) == 0u
// run: shl_u32(0x80000000u, 0u) == 0x80000000u
// run: shl_u32(0x80000000u, 1u) == 0u
// run: shl_u32(0x80000000u, 5u) == 0u
// run: shl_u32(0x80000000u, 31u) == 0u
// run: shl_u32(0x80000000u, 32u) == 0x80000000u
// run: shl_u32(0x80000000u, 33u) == 0u
// run: shl_u32(0x80000000u, 63u) == 0u
// run: shl_u32(0x80000000u, 0xffffffffu) == 0u
// run: shl_u32(0xffffffffu, 0u) == 0xffffffffu
// run: shl_u32(0xffffffffu, 1u) == 0xfffffffeu
// run: shl_u32(0xffffffffu, 5u) == 0xffffffe0u
// run: shl_u32(0xffffffffu, 31u) == 0x80000000u
// run: shl_u32(0xffffffffu, 32u) == 0xffffffffu
// run: shl_u32(0xffffffffu, 33u) == 0xfffffffeu
// run: shl_u32(0xffffffffu, 63u) == 0x80000000u
// run: shl_u32(0xffffffffu, 0xffffffffu) == 0x80000000u
// run: shl_u32(0x12345678u, 0u) == 0x12345678u
// run: shl_u32(0x12345678u, 1u) == 0x2468acf0u
// run: shl_u32(0x12345678u, 5u) == 0x468acf00u
// run: shl_u32(0x12345678u, 31u) == 0u
// run: shl_u32(0x12345678u, 32u) == 0x12345678u
// run: shl_u32(0x12345678u, 33u) == 0x2468acf0u
// run: shl_u32(0x12345678u, 63u) == 0u
// run: shl_u32(0x12345678u, 0xffffffffu) == 0u
// run: shl_u32(0x00010000u, 0u) == 0x00010000u
// run: shl_u32(0x00010000u, 1u) == 0x00020000u
// run: shl_u32(0x00010000u, 5u) == 0x00200000u
// run: shl_u32(0x00010000u, 31u) == 0u
// run: shl_u32(0x00010000u, 32u) == 0x00010000u
// run: shl_u32(0x00010000u, 33u) == 0x00020000u
// run: shl_u32(0x00010000u, 63u) == 0u
// run: shl_u32(0x00010000u, 0xffffffffu) == 0u
// run: shl_u32(0xfffffffeu, 0u) == 0xfffffffeu
// run: shl_u32(0xfffffffeu, 1u) == 0xfffffffcu
// run: shl_u32(0xfffffffeu, 5u) == 0xffffffc0u
// run: shl_u32(0xfffffffeu, 31u) == 0u
// run: shl_u32(0xfffffffeu, 32u) == 0xfffffffeu
// run: shl_u32(0xfffffffeu, 33u) == 0xfffffffcu
// run: shl_u32(0xfffffffeu, 63u) == 0u
// run: shl_u32(0xfffffffeu, 0xffffffffu) == 0u

fn shl_u32_vec3(x: vec3<u32>, y: vec3<u32>) -> vec3<u32> { return x << y; }
// run: shl_u32_vec3(vec3<u32>(0u, 1u, 2u), vec3<u32>(0u, 31u, 32u)) == vec3<u32>(0u, 0x80000000u, 2u)
// run: shl_u32_vec3(vec3<u32>(7u, 100u, 0x7fffffffu), vec3<u32>(1u, 30u, 33u)) == vec3<u32>(14u, 0u, 0xfffffffeu)
// run: shl_u32_vec3(vec3<u32>(0x80000000u, 0x80000001u, 0xffffffffu), vec3<u32>(2u, 29u, 34u)) == vec3<u32>(0u, 0x20000000u, 0xfffffffcu)

fn shl_u32_by_0(x: u32) -> u32 { return x << 0u; }
// run: shl_u32_by_0(1u) == 1u
// run: shl_u32_by_0(100u) == 100u
// run: shl_u32_by_0(0x80000001u) == 0x80000001u
// run: shl_u32_by_0(0x12345678u) == 0x12345678u
// run: shl_u32_by_0(65535u) == 65535u

fn shl_u32_by_1(x: u32) -> u32 { return x << 1u; }
// run: shl_u32_by_1(1u) == 2u
// run: shl_u32_by_1(100u) == 200u
// run: shl_u32_by_1(0x80000001u) == 2u
// run: shl_u32_by_1(0x12345678u) == 0x2468acf0u
// run: shl_u32_by_1(65535u) == 0x0001fffeu

fn shl_u32_by_13(x: u32) -> u32 { return x << 13u; }
// run: shl_u32_by_13(1u) == 8192u
// run: shl_u32_by_13(100u) == 0x000c8000u
// run: shl_u32_by_13(0x80000001u) == 8192u
// run: shl_u32_by_13(0x12345678u) == 0x8acf0000u
// run: shl_u32_by_13(65535u) == 0x1fffe000u

fn shl_u32_by_31(x: u32) -> u32 { return x << 31u; }
// run: shl_u32_by_31(1u) == 0x80000000u
// run: shl_u32_by_31(100u) == 0u
// run: shl_u32_by_31(0x80000001u) == 0x80000000u
// run: shl_u32_by_31(0x12345678u) == 0u
// run: shl_u32_by_31(65535u) == 0x80000000u

fn shr_u32(x: u32, y: u32) -> u32 { return x >> y; }
// run: shr_u32(0u, 0u) == 0u
// run: shr_u32(0u, 1u) == 0u
// run: shr_u32(0u, 5u) == 0u
// run: shr_u32(0u, 31u) == 0u
// run: shr_u32(0u, 32u) == 0u
// run: shr_u32(0u, 33u) == 0u
// run: shr_u32(0u, 63u) == 0u
// run: shr_u32(0u, 0xffffffffu) == 0u
// run: shr_u32(2u, 0u) == 2u
// run: shr_u32(2u, 1u) == 1u
// run: shr_u32(2u, 5u) == 0u
// run: shr_u32(2u, 31u) == 0u
// run: shr_u32(2u, 32u) == 2u
// run: shr_u32(2u, 33u) == 1u
// run: shr_u32(2u, 63u) == 0u
// run: shr_u32(2u, 0xffffffffu) == 0u
// run: shr_u32(100u, 0u) == 100u
// run: shr_u32(100u, 1u) == 50u
// run: shr_u32(100u, 5u) == 3u
// run: shr_u32(100u, 31u) == 0u
// run: shr_u32(100u, 32u) == 100u
// run: shr_u32(100u, 33u) == 50u
// run: shr_u32(100u, 63u) == 0u
// run: shr_u32(100u, 0xffffffffu) == 0u
// run: shr_u32(0x80000000u, 0u) == 0x80000000u
// run: shr_u32(0x80000000u, 1u) == 0x40000000u
// run: shr_u32(0x80000000u, 5u) == 0x04000000u
// run: shr_u32(0x80000000u, 31u) == 1u
// run: shr_u32(0x80000000u, 32u) == 0x80000000u
// run: shr_u32(0x80000000u, 33u) == 0x40000000u
// run: shr_u32(0x80000000u, 63u) == 1u
// run: shr_u32(0x80000000u, 0xffffffffu) == 1u
// run: shr_u32(0xffffffffu, 0u) == 0xffffffffu
// run: shr_u32(0xffffffffu, 1u) == 0x7fffffffu
// run: shr_u32(0xffffffffu, 5u) == 0x07ffffffu
// run: shr_u32(0xffffffffu, 31u) == 1u
// run: shr_u32(0xffffffffu, 32u) == 0xffffffffu
// run: shr_u32(0xffffffffu, 33u) == 0x7fffffffu
// run: shr_u32(0xffffffffu, 63u) == 1u
// run: shr_u32(0xffffffffu, 0xffffffffu) == 1u
// run: shr_u32(0x12345678u, 0u) == 0x12345678u
// run: shr_u32(0x12345678u, 1u) == 0x091a2b3cu
// run: shr_u32(0x12345678u, 5u) == 0x0091a2b3u
// run: shr_u32(0x12345678u, 31u) == 0u
// run: shr_u32(0x12345678u, 32u) == 0x12345678u
// run: shr_u32(0x12345678u, 33u) == 0x091a2b3cu
// run: shr_u32(0x12345678u, 63u) == 0u
// run: shr_u32(0x12345678u, 0xffffffffu) == 0u
// run: shr_u32(0x00010000u, 0u) == 0x00010000u
// run: shr_u32(0x00010000u, 1u) == 32768u
// run: shr_u32(0x00010000u, 5u) == 2048u
// run: shr_u32(0x00010000u, 31u) == 0u
// run: shr_u32(0x00010000u, 32u) == 0x00010000u
// run: shr_u32(0x00010000u, 33u) == 32768u
// run: shr_u32(0x00010000u, 63u) == 0u
// run: shr_u32(0x00010000u, 0xffffffffu) == 0u
// run: shr_u32(0xfffffffeu, 0u) == 0xfffffffeu
// run: shr_u32(0xfffffffeu, 1u) == 0x7fffffffu
// run: shr_u32(0xfffffffeu, 5u) == 0x07ffffffu
// run: shr_u32(0xfffffffeu, 31u) == 1u
// run: shr_u32(0xfffffffeu, 32u) == 0xfffffffeu
// run: shr_u32(0xfffffffeu, 33u) == 0x7fffffffu
// run: shr_u32(0xfffffffeu, 63u) == 1u
// run: shr_u32(0xfffffffeu, 0xffffffffu) == 1u

fn shr_u32_vec3(x: vec3<u32>, y: vec3<u32>) -> vec3<u32> { return x >> y; }
// run: shr_u32_vec3(vec3<u32>(0u, 1u, 2u), vec3<u32>(0u, 31u, 32u)) == vec3<u32>(0u, 0u, 2u)
// run: shr_u32_vec3(vec3<u32>(7u, 100u, 0x7fffffffu), vec3<u32>(1u, 30u, 33u)) == vec3<u32>(3u, 0u, 0x3fffffffu)
// run: shr_u32_vec3(vec3<u32>(0x80000000u, 0x80000001u, 0xffffffffu), vec3<u32>(2u, 29u, 34u)) == vec3<u32>(0x20000000u, 4u, 0x3fffffffu)

fn shr_u32_by_0(x: u32) -> u32 { return x >> 0u; }
// run: shr_u32_by_0(1u) == 1u
// run: shr_u32_by_0(100u) == 100u
// run: shr_u32_by_0(0x80000001u) == 0x80000001u
// run: shr_u32_by_0(0x12345678u) == 0x12345678u
// run: shr_u32_by_0(65535u) == 65535u

fn shr_u32_by_1(x: u32) -> u32 { return x >> 1u; }
// run: shr_u32_by_1(1u) == 0u
// run: shr_u32_by_1(100u) == 50u
// run: shr_u32_by_1(0x80000001u) == 0x40000000u
// run: shr_u32_by_1(0x12345678u) == 0x091a2b3cu
// run: shr_u32_by_1(65535u) == 32767u

fn shr_u32_by_13(x: u32) -> u32 { return x >> 13u; }
// run: shr_u32_by_13(1u) == 0u
// run: shr_u32_by_13(100u) == 0u
// run: shr_u32_by_13(0x80000001u) == 0x00040000u
// run: shr_u32_by_13(0x12345678u) == 37282u
// run: shr_u32_by_13(65535u) == 7u

fn shr_u32_by_31(x: u32) -> u32 { return x >> 31u; }
// run: shr_u32_by_31(1u) == 0u
// run: shr_u32_by_31(100u) == 0u
// run: shr_u32_by_31(0x80000001u) == 1u
// run: shr_u32_by_31(0x12345678u) == 0u
// run: shr_u32_by_31(65535u) == 0u
