// Division and remainder are total: x / 0 is x, x % 0 is 0, the one overflow wraps; both truncate.

fn div_i32(x: i32, y: i32) -> i32 { return x / y; }
// run: div_i32(0i, 0i) == 0i
// run: div_i32(0i, 1i) == 0i
// run: div_i32(0i, -1i) == 0i
// run: div_i32(0i, 2i) == 0i
// run: div_i32(0i, -2i) == 0i
// run: div_i32(0i, 7i) == 0i
// run: div_i32(0i, -7i) == 0i
// run: div_i32(0i, 100i) == 0i
// run: div_i32(0i, 2147483647i) == 0i
// run: div_i32(0i, -2147483648i) == 0i
// run: div_i32(0i, -2147483647i) == 0i
// run: div_i32(0i, 305419896i) == 0i
// run: div_i32(0i, -305419896i) == 0i
// run: div_i32(0i, 1431655765i) == 0i
// run: div_i32(0i, 65536i) == 0i
// run: div_i32(1i, 0i) == 1i
// run: div_i32(1i, 1i) == 1i
// run: div_i32(1i, -1i) == -1i
// run: div_i32(1i, 2i) == 0i
// run: div_i32(1i, -2i) == 0i
// run: div_i32(1i, 7i) == 0i
// run: div_i32(1i, -7i) == 0i
// run: div_i32(1i, 100i) == 0i
// run: div_i32(1i, 2147483647i) == 0i
// run: div_i32(1i, -2147483648i) == 0i
// run: div_i32(1i, -2147483647i) == 0i
// run: div_i32(1i, 305419896i) == 0i
// run: div_i32(1i, -305419896i) == 0i
// run: div_i32(1i, 1431655765i) == 0i
// run: div_i32(1i, 65536i) == 0i
// run: div_i32(-1i, 0i) == -1i
// run: div_i32(-1i, 1i) == -1i
// run: div_i32(-1i, -1i) == 1i
// run: div_i32(-1i, 2i) == 0i
// run: div_i32(-1i, -2i) == 0i
// run: div_i32(-1i, 7i) == 0i
// run: div_i32(-1i, -7i) == 0i
// run: div_i32(-1i, 100i) == 0i
// run: div_i32(-1i, 2147483647i) == 0i
// run: div_i32(-1i, -2147483648i) == 0i
// run: div_i32(-1i, -2147483647i) == 0i
// run: div_i32(-1i, 305419896i) == 0i
// run: div_i32(-1i, -305419896i) == 0i
// run: div_i32(-1i, 1431655765i) == 0i
// run: div_i32(-1i, 65536i) == 0i
// run: div_i32(2i, 0i) == 2i
// run: div_i32(2i, 1i) == 2i
// run: div_i32(2i, -1i) == -2i
// run: div_i32(2i, 2i) == 1i
// run: div_i32(2i, -2i) == -1i
// run: div_i32(2i, 7i) == 0i
// run: div_i32(2i, -7i) == 0i
// run: div_i32(2i, 100i) == 0i
// run: div_i32(2i, 2147483647i) == 0i
// run: div_i32(2i, -2147483648i) == 0i
// run: div_i32(2i, -2147483647i) == 0i
// run: div_i32(2i, 305419896i) == 0i
// run: div_i32(2i, -305419896i) == 0i
// run: div_i32(2i, 1431655765i) == 0i
// run: div_i32(2i, 65536i) == 0i
// run: div_i32(-2i, 0i) == -2i
// run: div_i32(-2i, 1i) == -2i
// run: div_i32(-2i, -1i) == 2i
// run: div_i32(-2i, 2i) == -1i
// run: div_i32(-2i, -2i) == 1i
// run: div_i32(-2i, 7i) == 0i
// run: div_i32(-2i, -7i) == 0i
// run: div_i32(-2i, 100i) == 0i
// run: div_i32(-2i, 2147483647i) == 0i
// run: div_i32(-2i, -2147483648i) == 0i
// run: div_i32(-2i, -2147483647i) == 0i
// run: div_i32(-2i, 305419896i) == 0i
// run: div_i32(-2i, -305419896i) == 0i
// run: div_i32(-2i, 1431655765i) == 0i
// run: div_i32(-2i, 65536i) == 0i
// run: div_i32(7i, 0i) == 7i
// run: div_i32(7i, 1i) == 7i
// run: div_i32(7i, -1i) == -7i
// run: div_i32(7i, 2i) == 3i
// run: div_i32(7i, -2i) == -3i
// run: div_i32(7i, 7i) == 1i
// run: div_i32(7i, -7i) == -1i
// run: div_i32(7i, 100i) == 0i
// run: div_i32(7i, 2147483647i) == 0i
// run: div_i32(7i, -2147483648i) == 0i
// run: div_i32(7i, -2147483647i) == 0i
// run: div_i32(7i, 305419896i) == 0i
// run: div_i32(7i, -305419896i) == 0i
// run: div_i32(7i, 1431655765i) == 0i
// run: div_i32(7i, 65536i) == 0i
// run: div_i32(-7i, 0i) == -7i
// run: div_i32(-7i, 1i) == -7i
// run: div_i32(-7i, -1i) == 7i
// run: div_i32(-7i, 2i) == -3i
// run: div_i32(-7i, -2i) == 3i
// run: div_i32(-7i, 7i) == -1i
// run: div_i32(-7i, -7i) == 1i
// run: div_i32(-7i, 100i) == 0i
// run: div_i32(-7i, 2147483647i) == 0i
// run: div_i32(-7i, -2147483648i) == 0i
// run: div_i32(-7i, -2147483647i) == 0i
// run: div_i32(-7i, 305419896i) == 0i
// run: div_i32(-7i, -305419896i) == 0i
// run: div_i32(-7i, 1431655765i) == 0i
// run: div_i32(-7i, 65536i) == 0i
// run: div_i32(100i, 0i) == 100i
// run: div_i32(100i, 1i) == 100i
// run: div_i32(100i, -1i) == -100i
// run: div_i32(100i, 2i) == 50i
// run: div_i32(100i, -2i) == -50i
// run: div_i32(100i, 7i) == 14i
// run: div_i32(100i, -7i) == -14i
// run: div_i32(100i, 100i) == 1i
// run: div_i32(100i, 2147483647i) == 0i
// run: div_i32(100i, -2147483648i) == 0i
// run: div_i32(100i, -2147483647i) == 0i
// run: div_i32(100i, 305419896i) == 0i
// run: div_i32(100i, -305419896i) == 0i
// run: div_i32(100i, 1431655765i) == 0i
// run: div_i32(100i, 65536i) == 0i
// run: div_i32(2147483647i, 0i) == 2147483647i
// run: div_i32(2147483647i, 1i) == 2147483647i
// run: div_i32(2147483647i, -1i) == -2147483647i
// run: div_i32(2147483647i, 2i) == 1073741823i
// run: div_i32(2147483647i, -2i) == -1073741823i
// run: div_i32(2147483647i, 7i) == 306783378i
// run: div_i32(2147483647i, -7i) == -306783378i
// run: div_i32(2147483647i, 100i) == 21474836i
// run: div_i32(2147483647i, 2147483647i) == 1i
// run: div_i32(2147483647i, -2147483648i) == 0i
// run: div_i32(2147483647i, -2147483647i) == -1i
// run: div_i32(2147483647i, 305419896i) == 7i
// run: div_i32(2147483647i, -305419896i) == -7i
// run: div_i32(2147483647i, 1431655765i) == 1i
// run: div_i32(2147483647i, 65536i) == 32767i
// run: div_i32(-2147483648i, 0i) == -2147483648i
// run: div_i32(-2147483648i, 1i) == -2147483648i
// run: div_i32(-2147483648i, -1i) == -2147483648i
// run: div_i32(-2147483648i, 2i) == -1073741824i
// run: div_i32(-2147483648i, -2i) == 1073741824i
// run: div_i32(-2147483648i, 7i) == -306783378i
// run: div_i32(-2147483648i, -7i) == 306783378i
// run: div_i32(-2147483648i, 100i) == -21474836i
// run: div_i32(-2147483648i, 2147483647i) == -1i
// run: div_i32(-2147483648i, -2147483648i) == 1i
// run: div_i32(-2147483648i, -2147483647i) == 1i
// run: div_i32(-2147483648i, 305419896i) == -7i
// run: div_i32(-2147483648i, -305419896i) == 7i
// run: div_i32(-2147483648i, 1431655765i) == -1i
// run: div_i32(-2147483648i, 65536i) == -32768i
// run: div_i32(-2147483647i, 0i) == -2147483647i
// run: div_i32(-2147483647i, 1i) == -2147483647i
// run: div_i32(-2147483647i, -1i) == 2147483647i
// run: div_i32(-2147483647i, 2i) == -1073741823i
// run: div_i32(-2147483647i, -2i) == 1073741823i
// run: div_i32(-2147483647i, 7i) == -306783378i
// run: div_i32(-2147483647i, -7i) == 306783378i
// run: div_i32(-2147483647i, 100i) == -21474836i
// run: div_i32(-2147483647i, 2147483647i) == -1i
// run: div_i32(-2147483647i, -2147483648i) == 0i
// run: div_i32(-2147483647i, -2147483647i) == 1i
// run: div_i32(-2147483647i, 305419896i) == -7i
// run: div_i32(-2147483647i, -305419896i) == 7i
// run: div_i32(-2147483647i, 1431655765i) == -1i
// run: div_i32(-2147483647i, 65536i) == -32767i
// run: div_i32(305419896i, 0i) == 305419896i
// run: div_i32(305419896i, 1i) == 305419896i
// run: div_i32(305419896i, -1i) == -305419896i
// run: div_i32(305419896i, 2i) == 152709948i
// run: div_i32(305419896i, -2i) == -152709948i
// run: div_i32(305419896i, 7i) == 43631413i
// run: div_i32(305419896i, -7i) == -43631413i
// run: div_i32(305419896i, 100i) == 3054198i
// run: div_i32(305419896i, 2147483647i) == 0i
// run: div_i32(305419896i, -2147483648i) == 0i
// run: div_i32(305419896i, -2147483647i) == 0i
// run: div_i32(305419896i, 305419896i) == 1i
// run: div_i32(305419896i, -305419896i) == -1i
// run: div_i32(305419896i, 1431655765i) == 0i
// run: div_i32(305419896i, 65536i) == 4660i
// run: div_i32(-305419896i, 0i) == -305419896i
// run: div_i32(-305419896i, 1i) == -305419896i
// run: div_i32(-305419896i, -1i) == 305419896i
// run: div_i32(-305419896i, 2i) == -152709948i
// run: div_i32(-305419896i, -2i) == 152709948i
// run: div_i32(-305419896i, 7i) == -43631413i
// run: div_i32(-305419896i, -7i) == 43631413i
// run: div_i32(-305419896i, 100i) == -3054198i
// run: div_i32(-305419896i, 2147483647i) == 0i
// run: div_i32(-305419896i, -2147483648i) == 0i
// run: div_i32(-305419896i, -2147483647i) == 0i
// run: div_i32(-305419896i, 305419896i) == -1i
// run: div_i32(-305419896i, -305419896i) == 1i
// run: div_i32(-305419896i, 1431655765i) == 0i
// run: div_i32(-305419896i, 65536i) == -4660i
// run: div_i32(1431655765i, 0i) == 1431655765i
// run: div_i32(1431655765i, 1i) == 1431655765i
// run: div_i32(1431655765i, -1i) == -1431655765i
// run: div_i32(1431655765i, 2i) == 715827882i
// run: div_i32(1431655765i, -2i) == -715827882i
// run: div_i32(1431655765i, 7i) == 204522252i
// run: div_i32(1431655765i, -7i) == -204522252i
// run: div_i32(1431655765i, 100i) == 14316557i
// run: div_i32(1431655765i, 2147483647i) == 0i
// run: div_i32(1431655765i, -2147483648i) == 0i
// run: div_i32(1431655765i, -2147483647i) == 0i
// run: div_i32(1431655765i, 305419896i) == 4i
// run: div_i32(1431655765i, -305419896i) == -4i
// run: div_i32(1431655765i, 1431655765i) == 1i
// run: div_i32(1431655765i, 65536i) == 21845i
// run: div_i32(65536i, 0i) == 65536i
// run: div_i32(65536i, 1i) == 65536i
// run: div_i32(65536i, -1i) == -65536i
// run: div_i32(65536i, 2i) == 32768i
// run: div_i32(65536i, -2i) == -32768i
// run: div_i32(65536i, 7i) == 9362i
// run: div_i32(65536i, -7i) == -9362i
// run: div_i32(65536i, 100i) == 655i
// run: div_i32(65536i, 2147483647i) == 0i
// run: div_i32(65536i, -2147483648i) == 0i
// run: div_i32(65536i, -2147483647i) == 0i
// run: div_i32(65536i, 305419896i) == 0i
// run: div_i32(65536i, -305419896i) == 0i
// run: div_i32(65536i, 1431655765i) == 0i
// run: div_i32(65536i, 65536i) == 1i

fn div_i32_vec2(x: vec2<i32>, y: vec2<i32>) -> vec2<i32> { return x / y; }
// run: div_i32_vec2(vec2<i32>(0i, 1i), vec2<i32>(1i, 2i)) == vec2<i32>(0i, 0i)
// run: div_i32_vec2(vec2<i32>(2i, -2i), vec2<i32>(-7i, 2147483647i)) == vec2<i32>(0i, 0i)
// run: div_i32_vec2(vec2<i32>(-7i, 100i), vec2<i32>(305419896i, 1431655765i)) == vec2<i32>(0i, 0i)
// run: div_i32_vec2(vec2<i32>(-2147483648i, -2147483647i), vec2<i32>(1i, 2i)) == vec2<i32>(-2147483648i, -1073741823i)

fn div_i32_vec3(x: vec3<i32>, y: vec3<i32>) -> vec3<i32> { return x / y; }
// run: div_i32_vec3(vec3<i32>(0i, 1i, -1i), vec3<i32>(1i, 2i, 7i)) == vec3<i32>(0i, 0i, 0i)
// run: div_i32_vec3(vec3<i32>(2i, -2i, 7i), vec3<i32>(-7i, 2147483647i, -2147483647i)) == vec3<i32>(0i, 0i, 0i)
// run: div_i32_vec3(vec3<i32>(-7i, 100i, 2147483647i), vec3<i32>(305419896i, 1431655765i, 0i)) == vec3<i32>(0i, 0i, 2147483647i)
// run: div_i32_vec3(vec3<i32>(-2147483648i, -2147483647i, 305419896i), vec3<i32>(1i, 2i, 7i)) == vec3<i32>(-2147483648i, -1073741823i, 43631413i)

fn div_i32_vec4(x: vec4<i32>, y: vec4<i32>) -> vec4<i32> { return x / y; }
// run: div_i32_vec4(vec4<i32>(0i, 1i, -1i, 2i), vec4<i32>(1i, 2i, 7i, 100i)) == vec4<i32>(0i, 0i, 0i, 0i)
// run: div_i32_vec4(vec4<i32>(2i, -2i, 7i, -7i), vec4<i32>(-7i, 2147483647i, -2147483647i, -305419896i)) == vec4<i32>(0i, 0i, 0i, 0i)
// run: div_i32_vec4(vec4<i32>(-7i, 100i, 2147483647i, -2147483648i), vec4<i32>(305419896i, 1431655765i, 0i, -1i)) == vec4<i32>(0i, 0i, 2147483647i, -2147483648i)
// run: div_i32_vec4(vec4<i32>(-2147483648i, -2147483647i, 305419896i, -305419896i), vec4<i32>(1i, 2i, 7i, 100i)) == vec4<i32>(-2147483648i, -1073741823i, 43631413i, -3054198i)

fn div_i32_splat(x: vec3<i32>, y: i32) -> vec3<i32> { return x / y; }
// run: div_i32_splat(vec3<i32>(1i, -1i, 2i), -1i) == vec3<i32>(-1i, 1i, -2i)
// run: div_i32_splat(vec3<i32>(-1i, 2i, -2i), 2i) == vec3<i32>(0i, 1i, -1i)
// run: div_i32_splat(vec3<i32>(2i, -2i, 7i), -2i) == vec3<i32>(-1i, 1i, -3i)

fn div_i32_left(x: i32, y: vec2<i32>) -> vec2<i32> { return x / y; }
// run: div_i32_left(100i, vec2<i32>(2i, -2i)) == vec2<i32>(50i, -50i)

fn div_u32(x: u32, y: u32) -> u32 { return x / y; }
// run: div_u32(0u, 0u) == 0u
// run: div_u32(0u, 1u) == 0u
// run: div_u32(0u, 2u) == 0u
// run: div_u32(0u, 7u) == 0u
// run: div_u32(0u, 100u) == 0u
// run: div_u32(0u, 0x7fffffffu) == 0u
// run: div_u32(0u, 0x80000000u) == 0u
// run: div_u32(0u, 0x80000001u) == 0u
// run: div_u32(0u, 0xffffffffu) == 0u
// run: div_u32(0u, 0xfffffffeu) == 0u
// run: div_u32(0u, 0x12345678u) == 0u
// run: div_u32(0u, 0xaaaaaaaau) == 0u
// run: div_u32(0u, 0x00010000u) == 0u
// run: div_u32(0u, 65535u) == 0u
// run: div_u32(1u, 0u) == 1u
// run: div_u32(1u, 1u) == 1u
// run: div_u32(1u, 2u) == 0u
// run: div_u32(1u, 7u) == 0u
// run: div_u32(1u, 100u) == 0u
// run: div_u32(1u, 0x7fffffffu) == 0u
// run: div_u32(1u, 0x80000000u) == 0u
// run: div_u32(1u, 0x80000001u) == 0u
// run: div_u32(1u, 0xffffffffu) == 0u
// run: div_u32(1u, 0xfffffffeu) == 0u
// run: div_u32(1u, 0x12345678u) == 0u
// run: div_u32(1u, 0xaaaaaaaau) == 0u
// run: div_u32(1u, 0x00010000u) == 0u
// run: div_u32(1u, 65535u) == 0u
// run: div_u32(2u, 0u) == 2u
// run: div_u32(2u, 1u) == 2u
// run: div_u32(2u, 2u) == 1u
// run: div_u32(2u, 7u) == 0u
// run: div_u32(2u, 100u) == 0u
// run: div_u32(2u, 0x7fffffffu) == 0u
// run: div_u32(2u, 0x80000000u) == 0u
// run: div_u32(2u, 0x80000001u) == 0u
// run: div_u32(2u, 0xffffffffu) == 0u
// run: div_u32(2u, 0xfffffffeu) == 0u
// run: div_u32(2u, 0x12345678u) == 0u
// run: div_u32(2u, 0xaaaaaaaau) == 0u
// run: div_u32(2u, 0x00010000u) == 0u
// run: div_u32(2u, 65535u) == 0u
// run: div_u32(7u, 0u) == 7u
// run: div_u32(7u, 1u) == 7u
// run: div_u32(7u, 2u) == 3u
// run: div_u32(7u, 7u) == 1u
// run: div_u32(7u, 100u) == 0u
// run: div_u32(7u, 0x7fffffffu) == 0u
// run: div_u32(7u, 0x80000000u) == 0u
// run: div_u32(7u, 0x80000001u) == 0u
// run: div_u32(7u, 0xffffffffu) == 0u
// run: div_u32(7u, 0xfffffffeu) == 0u
// run: div_u32(7u, 0x12345678u) == 0u
// run: div_u32(7u, 0xaaaaaaaau) == 0u
// run: div_u32(7u, 0x00010000u) == 0u
// run: div_u32(7u, 65535u) == 0u
// run: div_u32(100u, 0u) == 100u
// run: div_u32(100u, 1u) == 100u
// run: div_u32(100u, 2u) == 50u
// run: div_u32(100u, 7u) == 14u
// run: div_u32(100u, 100u) == 1u
// run: div_u32(100u, 0x7fffffffu) == 0u
// run: div_u32(100u, 0x80000000u) == 0u
// run: div_u32(100u, 0x80000001u) == 0u
// run: div_u32(100u, 0xffffffffu) == 0u
// run: div_u32(100u, 0xfffffffeu) == 0u
// run: div_u32(100u, 0x12345678u) == 0u
// run: div_u32(100u, 0xaaaaaaaau) == 0u
// run: div_u32(100u, 0x00010000u) == 0u
// run: div_u32(100u, 65535u) == 0u
// run: div_u32(0x7fffffffu, 0u) == 0x7fffffffu
// run: div_u32(0x7fffffffu, 1u) == 0x7fffffffu
// run: div_u32(0x7fffffffu, 2u) == 0x3fffffffu
// run: div_u32(0x7fffffffu, 7u) == 0x12492492u
// run: div_u32(0x7fffffffu, 100u) == 0x0147ae14u
// run: div_u32(0x7fffffffu, 0x7fffffffu) == 1u
// run: div_u32(0x7fffffffu, 0x80000000u) == 0u
// run: div_u32(0x7fffffffu, 0x80000001u) == 0u
// run: div_u32(0x7fffffffu, 0xffffffffu) == 0u
// run: div_u32(0x7fffffffu, 0xfffffffeu) == 0u
// run: div_u32(0x7fffffffu, 0x12345678u) == 7u
// run: div_u32(0x7fffffffu, 0xaaaaaaaau) == 0u
// run: div_u32(0x7fffffffu, 0x00010000u) == 32767u
// run: div_u32(0x7fffffffu, 65535u) == 32768u
// run: div_u32(0x80000000u, 0u) == 0x80000000u
// run: div_u32(0x80000000u, 1u) == 0x80000000u
// run: div_u32(0x80000000u, 2u) == 0x40000000u
// run: div_u32(0x80000000u, 7u) == 0x12492492u
// run: div_u32(0x80000000u, 100u) == 0x0147ae14u
// run: div_u32(0x80000000u, 0x7fffffffu) == 1u
// run: div_u32(0x80000000u, 0x80000000u) == 1u
// run: div_u32(0x80000000u, 0x80000001u) == 0u
// run: div_u32(0x80000000u, 0xffffffffu) == 0u
// run: div_u32(0x80000000u, 0xfffffffeu) == 0u
// run: div_u32(0x80000000u, 0x12345678u) == 7u
// run: div_u32(0x80000000u, 0xaaaaaaaau) == 0u
// run: div_u32(0x80000000u, 0x00010000u) == 32768u
// run: div_u32(0x80000000u, 65535u) == 32768u
// run: div_u32(0x80000001u, 0u) == 0x80000001u
// run: div_u32(0x80000001u, 1u) == 0x80000001u
// run: div_u32(0x80000001u, 2u) == 0x40000000u
// run: div_u32(0x80000001u, 7u) == 0x12492492u
// run: div_u32(0x80000001u, 100u) == 0x0147ae14u
// run: div_u32(0x80000001u, 0x7fffffffu) == 1u
// run: div_u32(0x80000001u, 0x80000000u) == 1u
// run: div_u32(0x80000001u, 0x80000001u) == 1u
// run: div_u32(0x80000001u, 0xffffffffu) == 0u
// run: div_u32(0x80000001u, 0xfffffffeu) == 0u
// run: div_u32(0x80000001u, 0x12345678u) == 7u
// run: div_u32(0x80000001u, 0xaaaaaaaau) == 0u
// run: div_u32(0x80000001u, 0x00010000u) == 32768u
// run: div_u32(0x80000001u, 65535u) == 32768u
// run: div_u32(0xffffffffu, 0u) == 0xffffffffu
// run: div_u32(0xffffffffu, 1u) == 0xffffffffu
// run: div_u32(0xffffffffu, 2u) == 0x7fffffffu
// run: div_u32(0xffffffffu, 7u) == 0x24924924u
// run: div_u32(0xffffffffu, 100u) == 0x028f5c28u
// run: div_u32(0xffffffffu, 0x7fffffffu) == 2u
// run: div_u32(0xffffffffu, 0x80000000u) == 1u
// run: div_u32(0xffffffffu, 0x80000001u) == 1u
// run: div_u32(0xffffffffu, 0xffffffffu) == 1u
// run: div_u32(0xffffffffu, 0xfffffffeu) == 1u
// run: div_u32(0xffffffffu, 0x12345678u) == 14u
// run: div_u32(0xffffffffu, 0xaaaaaaaau) == 1u
// run: div_u32(0xffffffffu, 0x00010000u) == 65535u
// run: div_u32(0xffffffffu, 65535u) == 0x00010001u
// run: div_u32(0xfffffffeu, 0u) == 0xfffffffeu
// run: div_u32(0xfffffffeu, 1u) == 0xfffffffeu
// run: div_u32(0xfffffffeu, 2u) == 0x7fffffffu
// run: div_u32(0xfffffffeu, 7u) == 0x24924924u
// run: div_u32(0xfffffffeu, 100u) == 0x028f5c28u
// run: div_u32(0xfffffffeu, 0x7fffffffu) == 2u
// run: div_u32(0xfffffffeu, 0x80000000u) == 1u
// run: div_u32(0xfffffffeu, 0x80000001u) == 1u
// run: div_u32(0xfffffffeu, 0xffffffffu) == 0u
// run: div_u32(0xfffffffeu, 0xfffffffeu) == 1u
// run: div_u32(0xfffffffeu, 0x12345678u) == 14u
// run: div_u32(0xfffffffeu, 0xaaaaaaaau) == 1u
// run: div_u32(0xfffffffeu, 0x00010000u) == 65535u
// run: div_u32(0xfffffffeu, 65535u) == 0x00010000u
// run: div_u32(0x12345678u, 0u) == 0x12345678u
// run: div_u32(0x12345678u, 1u) == 0x12345678u
// run: div_u32(0x12345678u, 2u) == 0x091a2b3cu
// run: div_u32(0x12345678u, 7u) == 0x0299c335u
// run: div_u32(0x12345678u, 100u) == 0x002e9a76u
// run: div_u32(0x12345678u, 0x7fffffffu) == 0u
// run: div_u32(0x12345678u, 0x80000000u) == 0u
// run: div_u32(0x12345678u, 0x80000001u) == 0u
// run: div_u32(0x12345678u, 0xffffffffu) == 0u
// run: div_u32(0x12345678u, 0xfffffffeu) == 0u
// run: div_u32(0x12345678u, 0x12345678u) == 1u
// run: div_u32(0x12345678u, 0xaaaaaaaau) == 0u
// run: div_u32(0x12345678u, 0x00010000u) == 4660u
// run: div_u32(0x12345678u, 65535u) == 4660u
// run: div_u32(0xaaaaaaaau, 0u) == 0xaaaaaaaau
// run: div_u32(0xaaaaaaaau, 1u) == 0xaaaaaaaau
// run: div_u32(0xaaaaaaaau, 2u) == 0x55555555u
// run: div_u32(0xaaaaaaaau, 7u) == 0x18618618u
// run: div_u32(0xaaaaaaaau, 100u) == 0x01b4e81bu
// run: div_u32(0xaaaaaaaau, 0x7fffffffu) == 1u
// run: div_u32(0xaaaaaaaau, 0x80000000u) == 1u
// run: div_u32(0xaaaaaaaau, 0x80000001u) == 1u
// run: div_u32(0xaaaaaaaau, 0xffffffffu) == 0u
// run: div_u32(0xaaaaaaaau, 0xfffffffeu) == 0u
// run: div_u32(0xaaaaaaaau, 0x12345678u) == 9u
// run: div_u32(0xaaaaaaaau, 0xaaaaaaaau) == 1u
// run: div_u32(0xaaaaaaaau, 0x00010000u) == 43690u
// run: div_u32(0xaaaaaaaau, 65535u) == 43691u
// run: div_u32(0x00010000u, 0u) == 0x00010000u
// run: div_u32(0x00010000u, 1u) == 0x00010000u
// run: div_u32(0x00010000u, 2u) == 32768u
// run: div_u32(0x00010000u, 7u) == 9362u
// run: div_u32(0x00010000u, 100u) == 655u
// run: div_u32(0x00010000u, 0x7fffffffu) == 0u
// run: div_u32(0x00010000u, 0x80000000u) == 0u
// run: div_u32(0x00010000u, 0x80000001u) == 0u
// run: div_u32(0x00010000u, 0xffffffffu) == 0u
// run: div_u32(0x00010000u, 0xfffffffeu) == 0u
// run: div_u32(0x00010000u, 0x12345678u) == 0u
// run: div_u32(0x00010000u, 0xaaaaaaaau) == 0u
// run: div_u32(0x00010000u, 0x00010000u) == 1u
// run: div_u32(0x00010000u, 65535u) == 1u
// run: div_u32(65535u, 0u) == 65535u
// run: div_u32(65535u, 1u) == 65535u
// run: div_u32(65535u, 2u) == 32767u
// run: div_u32(65535u, 7u) == 9362u
// run: div_u32(65535u, 100u) == 655u
// run: div_u32(65535u, 0x7fffffffu) == 0u
// run: div_u32(65535u, 0x80000000u) == 0u
// run: div_u32(65535u, 0x80000001u) == 0u
// run: div_u32(65535u, 0xffffffffu) == 0u
// run: div_u32(65535u, 0xfffffffeu) == 0u
// run: div_u32(65535u, 0x12345678u) == 0u
// run: div_u32(65535u, 0xaaaaaaaau) == 0u
// run: div_u32(65535u, 0x00010000u) == 0u
// run: div_u32(65535u, 65535u) == 1u

fn div_u32_vec2(x: vec2<u32>, y: vec2<u32>) -> vec2<u32> { return x / y; }
// run: div_u32_vec2(vec2<u32>(0u, 1u), vec2<u32>(1u, 7u)) == vec2<u32>(0u, 0u)
// run: div_u32_vec2(vec2<u32>(7u, 100u), vec2<u32>(0x80000000u, 0xffffffffu)) == vec2<u32>(0u, 0u)
// run: div_u32_vec2(vec2<u32>(0x80000000u, 0x80000001u), vec2<u32>(0xaaaaaaaau, 65535u)) == vec2<u32>(0u, 32768u)
// run: div_u32_vec2(vec2<u32>(0xfffffffeu, 0x12345678u), vec2<u32>(2u, 100u)) == vec2<u32>(0x7fffffffu, 0x002e9a76u)

fn div_u32_vec3(x: vec3<u32>, y: vec3<u32>) -> vec3<u32> { return x / y; }
// run: div_u32_vec3(vec3<u32>(0u, 1u, 2u), vec3<u32>(1u, 7u, 0x7fffffffu)) == vec3<u32>(0u, 0u, 0u)
// run: div_u32_vec3(vec3<u32>(7u, 100u, 0x7fffffffu), vec3<u32>(0x80000000u, 0xffffffffu, 0x12345678u)) == vec3<u32>(0u, 0u, 7u)
// run: div_u32_vec3(vec3<u32>(0x80000000u, 0x80000001u, 0xffffffffu), vec3<u32>(0xaaaaaaaau, 65535u, 1u)) == vec3<u32>(0u, 32768u, 0xffffffffu)
// run: div_u32_vec3(vec3<u32>(0xfffffffeu, 0x12345678u, 0xaaaaaaaau), vec3<u32>(2u, 100u, 0x80000000u)) == vec3<u32>(0x7fffffffu, 0x002e9a76u, 1u)

fn div_u32_vec4(x: vec4<u32>, y: vec4<u32>) -> vec4<u32> { return x / y; }
// run: div_u32_vec4(vec4<u32>(0u, 1u, 2u, 7u), vec4<u32>(1u, 7u, 0x7fffffffu, 0x80000001u)) == vec4<u32>(0u, 0u, 0u, 0u)
// run: div_u32_vec4(vec4<u32>(7u, 100u, 0x7fffffffu, 0x80000000u), vec4<u32>(0x80000000u, 0xffffffffu, 0x12345678u, 0x00010000u)) == vec4<u32>(0u, 0u, 7u, 32768u)
// run: div_u32_vec4(vec4<u32>(0x80000000u, 0x80000001u, 0xffffffffu, 0xfffffffeu), vec4<u32>(0xaaaaaaaau, 65535u, 1u, 7u)) == vec4<u32>(0u, 32768u, 0xffffffffu, 0x24924924u)
// run: div_u32_vec4(vec4<u32>(0xfffffffeu, 0x12345678u, 0xaaaaaaaau, 0x00010000u), vec4<u32>(2u, 100u, 0x80000000u, 0xffffffffu)) == vec4<u32>(0x7fffffffu, 0x002e9a76u, 1u, 0u)

fn div_u32_splat(x: vec3<u32>, y: u32) -> vec3<u32> { return x / y; }
// run: div_u32_splat(vec3<u32>(1u, 2u, 7u), 2u) == vec3<u32>(0u, 1u, 3u)
// run: div_u32_splat(vec3<u32>(2u, 7u, 100u), 7u) == vec3<u32>(0u, 1u, 14u)
// run: div_u32_splat(vec3<u32>(7u, 100u, 0x7fffffffu), 100u) == vec3<u32>(0u, 1u, 0x0147ae14u)

fn div_u32_left(x: u32, y: vec2<u32>) -> vec2<u32> { return x / y; }
// run: div_u32_left(0x80000001u, vec2<u32>(7u, 100u)) == vec2<u32>(0x12492492u, 0x0147ae14u)

fn rem_i32(x: i32, y: i32) -> i32 { return x % y; }
// run: rem_i32(0i, 0i) == 0i
// run: rem_i32(0i, 1i) == 0i
// run: rem_i32(0i, -1i) == 0i
// run: rem_i32(0i, 2i) == 0i
// run: rem_i32(0i, -2i) == 0i
// run: rem_i32(0i, 7i) == 0i
// run: rem_i32(0i, -7i) == 0i
// run: rem_i32(0i, 100i) == 0i
// run: rem_i32(0i, 2147483647i) == 0i
// run: rem_i32(0i, -2147483648i) == 0i
// run: rem_i32(0i, -2147483647i) == 0i
// run: rem_i32(0i, 305419896i) == 0i
// run: rem_i32(0i, -305419896i) == 0i
// run: rem_i32(0i, 1431655765i) == 0i
// run: rem_i32(0i, 65536i) == 0i
// run: rem_i32(1i, 0i) == 0i
// run: rem_i32(1i, 1i) == 0i
// run: rem_i32(1i, -1i) == 0i
// run: rem_i32(1i, 2i) == 1i
// run: rem_i32(1i, -2i) == 1i
// run: rem_i32(1i, 7i) == 1i
// run: rem_i32(1i, -7i) == 1i
// run: rem_i32(1i, 100i) == 1i
// run: rem_i32(1i, 2147483647i) == 1i
// run: rem_i32(1i, -2147483648i) == 1i
// run: rem_i32(1i, -2147483647i) == 1i
// run: rem_i32(1i, 305419896i) == 1i
// run: rem_i32(1i, -305419896i) == 1i
// run: rem_i32(1i, 1431655765i) == 1i
// run: rem_i32(1i, 65536i) == 1i
// run: rem_i32(-1i, 0i) == 0i
// run: rem_i32(-1i, 1i) == 0i
// run: rem_i32(-1i, -1i) == 0i
// run: rem_i32(-1i, 2i) == -1i
// run: rem_i32(-1i, -2i) == -1i
// run: rem_i32(-1i, 7i) == -1i
// run: rem_i32(-1i, -7i) == -1i
// run: rem_i32(-1i, 100i) == -1i
// run: rem_i32(-1i, 2147483647i) == -1i
// run: rem_i32(-1i, -2147483648i) == -1i
// run: rem_i32(-1i, -2147483647i) == -1i
// run: rem_i32(-1i, 305419896i) == -1i
// run: rem_i32(-1i, -305419896i) == -1i
// run: rem_i32(-1i, 1431655765i) == -1i
// run: rem_i32(-1i, 65536i) == -1i
// run: rem_i32(2i, 0i) == 0i
// run: rem_i32(2i, 1i) == 0i
// run: rem_i32(2i, -1i) == 0i
// run: rem_i32(2i, 2i) == 0i
// run: rem_i32(2i, -2i) == 0i
// run: rem_i32(2i, 7i) == 2i
// run: rem_i32(2i, -7i) == 2i
// run: rem_i32(2i, 100i) == 2i
// run: rem_i32(2i, 2147483647i) == 2i
// run: rem_i32(2i, -2147483648i) == 2i
// run: rem_i32(2i, -2147483647i) == 2i
// run: rem_i32(2i, 305419896i) == 2i
// run: rem_i32(2i, -305419896i) == 2i
// run: rem_i32(2i, 1431655765i) == 2i
// run: rem_i32(2i, 65536i) == 2i
// run: rem_i32(-2i, 0i) == 0i
// run: rem_i32(-2i, 1i) == 0i
// run: rem_i32(-2i, -1i) == 0i
// run: rem_i32(-2i, 2i) == 0i
// run: rem_i32(-2i, -2i) == 0i
// run: rem_i32(-2i, 7i) == -2i
// run: rem_i32(-2i, -7i) == -2i
// run: rem_i32(-2i, 100i) == -2i
// run: rem_i32(-2i, 2147483647i) == -2i
// run: rem_i32(-2i, -2147483648i) == -2i
// run: rem_i32(-2i, -2147483647i) == -2i
// run: rem_i32(-2i, 305419896i) == -2i
// run: rem_i32(-2i, -305419896i) == -2i
// run: rem_i32(-2i, 1431655765i) == -2i
// run: rem_i32(-2i, 65536i) == -2i
// run: rem_i32(7i, 0i) == 0i
// run: rem_i32(7i, 1i) == 0i
// run: rem_i32(7i, -1i) == 0i
// run: rem_i32(7i, 2i) == 1i
// run: rem_i32(7i, -2i) == 1i
// run: rem_i32(7i, 7i) == 0i
// run: rem_i32(7i, -7i) == 0i
// run: rem_i32(7i, 100i) == 7i
// run: rem_i32(7i, 2147483647i) == 7i
// run: rem_i32(7i, -2147483648i) == 7i
// run: rem_i32(7i, -2147483647i) == 7i
// run: rem_i32(7i, 305419896i) == 7i
// run: rem_i32(7i, -305419896i) == 7i
// run: rem_i32(7i, 1431655765i) == 7i
// run: rem_i32(7i, 65536i) == 7i
// run: rem_i32(-7i, 0i) == 0i
// run: rem_i32(-7i, 1i) == 0i
// run: rem_i32(-7i, -1i) == 0i
// run: rem_i32(-7i, 2i) == -1i
// run: rem_i32(-7i, -2i) == -1i
// run: rem_i32(-7i, 7i) == 0i
// run: rem_i32(-7i, -7i) == 0i
// run: rem_i32(-7i, 100i) == -7i
// run: rem_i32(-7i, 2147483647i) == -7i
// run: rem_i32(-7i, -2147483648i) == -7i
// run: rem_i32(-7i, -2147483647i) == -7i
// run: rem_i32(-7i, 305419896i) == -7i
// run: rem_i32(-7i, -305419896i) == -7i
// run: rem_i32(-7i, 1431655765i) == -7i
// run: rem_i32(-7i, 65536i) == -7i
// run: rem_i32(100i, 0i) == 0i
// run: rem_i32(100i, 1i) == 0i
// run: rem_i32(100i, -1i) == 0i
// run: rem_i32(100i, 2i) == 0i
// run: rem_i32(100i, -2i) == 0i
// run: rem_i32(100i, 7i) == 2i
// run: rem_i32(100i, -7i) == 2i
// run: rem_i32(100i, 100i) == 0i
// run: rem_i32(100i, 2147483647i) == 100i
// run: rem_i32(100i, -2147483648i) == 100i
// run: rem_i32(100i, -2147483647i) == 100i
// run: rem_i32(100i, 305419896i) == 100i
// run: rem_i32(100i, -305419896i) == 100i
// run: rem_i32(100i, 1431655765i) == 100i
// run: rem_i32(100i, 65536i) == 100i
// run: rem_i32(2147483647i, 0i) == 0i
// run: rem_i32(2147483647i, 1i) == 0i
// run: rem_i32(2147483647i, -1i) == 0i
// run: rem_i32(2147483647i, 2i) == 1i
// run: rem_i32(2147483647i, -2i) == 1i
// run: rem_i32(2147483647i, 7i) == 1i
// run: rem_i32(2147483647i, -7i) == 1i
// run: rem_i32(2147483647i, 100i) == 47i
// run: rem_i32(2147483647i, 2147483647i) == 0i
// run: rem_i32(2147483647i, -2147483648i) == 2147483647i
// run: rem_i32(2147483647i, -2147483647i) == 0i
// run: rem_i32(2147483647i, 305419896i) == 9544375i
// run: rem_i32(2147483647i, -305419896i) == 9544375i
// run: rem_i32(2147483647i, 1431655765i) == 715827882i
// run: rem_i32(2147483647i, 65536i) == 65535i
// run: rem_i32(-2147483648i, 0i) == 0i
// run: rem_i32(-2147483648i, 1i) == 0i
// run: rem_i32(-2147483648i, -1i) == 0i
// run: rem_i32(-2147483648i, 2i) == 0i
// run: rem_i32(-2147483648i, -2i) == 0i
// run: rem_i32(-2147483648i, 7i) == -2i
// run: rem_i32(-2147483648i, -7i) == -2i
// run: rem_i32(-2147483648i, 100i) == -48i
// run: rem_i32(-2147483648i, 2147483647i) == -1i
// run: rem_i32(-2147483648i, -2147483648i) == 0i
// run: rem_i32(-2147483648i, -2147483647i) == -1i
// run: rem_i32(-2147483648i, 305419896i) == -9544376i
// run: rem_i32(-2147483648i, -305419896i) == -9544376i
// run: rem_i32(-2147483648i, 1431655765i) == -715827883i
// run: rem_i32(-2147483648i, 65536i) == 0i
// run: rem_i32(-2147483647i, 0i) == 0i
// run: rem_i32(-2147483647i, 1i) == 0i
// run: rem_i32(-2147483647i, -1i) == 0i
// run: rem_i32(-2147483647i, 2i) == -1i
// run: rem_i32(-2147483647i, -2i) == -1i
// run: rem_i32(-2147483647i, 7i) == -1i
// run: rem_i32(-2147483647i, -7i) == -1i
// run: rem_i32(-2147483647i, 100i) == -47i
// run: rem_i32(-2147483647i, 2147483647i) == 0i
// run: rem_i32(-2147483647i, -2147483648i) == -2147483647i
// run: rem_i32(-2147483647i, -2147483647i) == 0i
// run: rem_i32(-2147483647i, 305419896i) == -9544375i
// run: rem_i32(-2147483647i, -305419896i) == -9544375i
// run: rem_i32(-2147483647i, 1431655765i) == -715827882i
// run: rem_i32(-2147483647i, 65536i) == -65535i
// run: rem_i32(305419896i, 0i) == 0i
// run: rem_i32(305419896i, 1i) == 0i
// run: rem_i32(305419896i, -1i) == 0i
// run: rem_i32(305419896i, 2i) == 0i
// run: rem_i32(305419896i, -2i) == 0i
// run: rem_i32(305419896i, 7i) == 5i
// run: rem_i32(305419896i, -7i) == 5i
// run: rem_i32(305419896i, 100i) == 96i
// run: rem_i32(305419896i, 2147483647i) == 305419896i
// run: rem_i32(305419896i, -2147483648i) == 305419896i
// run: rem_i32(305419896i, -2147483647i) == 305419896i
// run: rem_i32(305419896i, 305419896i) == 0i
// run: rem_i32(305419896i, -305419896i) == 0i
// run: rem_i32(305419896i, 1431655765i) == 305419896i
// run: rem_i32(305419896i, 65536i) == 22136i
// run: rem_i32(-305419896i, 0i) == 0i
// run: rem_i32(-305419896i, 1i) == 0i
// run: rem_i32(-305419896i, -1i) == 0i
// run: rem_i32(-305419896i, 2i) == 0i
// run: rem_i32(-305419896i, -2i) == 0i
// run: rem_i32(-305419896i, 7i) == -5i
// run: rem_i32(-305419896i, -7i) == -5i
// run: rem_i32(-305419896i, 100i) == -96i
// run: rem_i32(-305419896i, 2147483647i) == -305419896i
// run: rem_i32(-305419896i, -2147483648i) == -305419896i
// run: rem_i32(-305419896i, -2147483647i) == -305419896i
// run: rem_i32(-305419896i, 305419896i) == 0i
// run: rem_i32(-305419896i, -305419896i) == 0i
// run: rem_i32(-305419896i, 1431655765i) == -305419896i
// run: rem_i32(-305419896i, 65536i) == -22136i
// run: rem_i32(1431655765i, 0i) == 0i
// run: rem_i32(1431655765i, 1i) == 0i
// run: rem_i32(1431655765i, -1i) == 0i
// run: rem_i32(1431655765i, 2i) == 1i
// run: rem_i32(1431655765i, -2i) == 1i
// run: rem_i32(1431655765i, 7i) == 1i
// run: rem_i32(1431655765i, -7i) == 1i
// run: rem_i32(1431655765i, 100i) == 65i
// run: rem_i32(1431655765i, 2147483647i) == 1431655765i
// run: rem_i32(1431655765i, -2147483648i) == 1431655765i
// run: rem_i32(1431655765i, -2147483647i) == 1431655765i
// run: rem_i32(1431655765i, 305419896i) == 209976181i
// run: rem_i32(1431655765i, -305419896i) == 209976181i
// run: rem_i32(1431655765i, 1431655765i) == 0i
// run: rem_i32(1431655765i, 65536i) == 21845i
// run: rem_i32(65536i, 0i) == 0i
// run: rem_i32(65536i, 1i) == 0i
// run: rem_i32(65536i, -1i) == 0i
// run: rem_i32(65536i, 2i) == 0i
// run: rem_i32(65536i, -2i) == 0i
// run: rem_i32(65536i, 7i) == 2i
// run: rem_i32(65536i, -7i) == 2i
// run: rem_i32(65536i, 100i) == 36i
// run: rem_i32(65536i, 2147483647i) == 65536i
// run: rem_i32(65536i, -2147483648i) == 65536i
// run: rem_i32(65536i, -2147483647i) == 65536i
// run: rem_i32(65536i, 305419896i) == 65536i
// run: rem_i32(65536i, -305419896i) == 65536i
// run: rem_i32(65536i, 1431655765i) == 65536i
// run: rem_i32(65536i, 65536i) == 0i

fn rem_i32_vec2(x: vec2<i32>, y: vec2<i32>) -> vec2<i32> { return x % y; }
// run: rem_i32_vec2(vec2<i32>(0i, 1i), vec2<i32>(1i, 2i)) == vec2<i32>(0i, 1i)
// run: rem_i32_vec2(vec2<i32>(2i, -2i), vec2<i32>(-7i, 2147483647i)) == vec2<i32>(2i, -2i)
// run: rem_i32_vec2(vec2<i32>(-7i, 100i), vec2<i32>(305419896i, 1431655765i)) == vec2<i32>(-7i, 100i)
// run: rem_i32_vec2(vec2<i32>(-2147483648i, -2147483647i), vec2<i32>(1i, 2i)) == vec2<i32>(0i, -1i)

fn rem_i32_vec3(x: vec3<i32>, y: vec3<i32>) -> vec3<i32> { return x % y; }
// run: rem_i32_vec3(vec3<i32>(0i, 1i, -1i), vec3<i32>(1i, 2i, 7i)) == vec3<i32>(0i, 1i, -1i)
// run: rem_i32_vec3(vec3<i32>(2i, -2i, 7i), vec3<i32>(-7i, 2147483647i, -2147483647i)) == vec3<i32>(2i, -2i, 7i)
// run: rem_i32_vec3(vec3<i32>(-7i, 100i, 2147483647i), vec3<i32>(305419896i, 1431655765i, 0i)) == vec3<i32>(-7i, 100i, 0i)
// run: rem_i32_vec3(vec3<i32>(-2147483648i, -2147483647i, 305419896i), vec3<i32>(1i, 2i, 7i)) == vec3<i32>(0i, -1i, 5i)

fn rem_i32_vec4(x: vec4<i32>, y: vec4<i32>) -> vec4<i32> { return x % y; }
// run: rem_i32_vec4(vec4<i32>(0i, 1i, -1i, 2i), vec4<i32>(1i, 2i, 7i, 100i)) == vec4<i32>(0i, 1i, -1i, 2i)
// run: rem_i32_vec4(vec4<i32>(2i, -2i, 7i, -7i), vec4<i32>(-7i, 2147483647i, -2147483647i, -305419896i)) == vec4<i32>(2i, -2i, 7i, -7i)
// run: rem_i32_vec4(vec4<i32>(-7i, 100i, 2147483647i, -2147483648i), vec4<i32>(305419896i, 1431655765i, 0i, -1i)) == vec4<i32>(-7i, 100i, 0i, 0i)
// run: rem_i32_vec4(vec4<i32>(-2147483648i, -2147483647i, 305419896i, -305419896i), vec4<i32>(1i, 2i, 7i, 100i)) == vec4<i32>(0i, -1i, 5i, -96i)

fn rem_i32_splat(x: vec3<i32>, y: i32) -> vec3<i32> { return x % y; }
// run: rem_i32_splat(vec3<i32>(1i, -1i, 2i), -1i) == vec3<i32>(0i, 0i, 0i)
// run: rem_i32_splat(vec3<i32>(-1i, 2i, -2i), 2i) == vec3<i32>(-1i, 0i, 0i)
// run: rem_i32_splat(vec3<i32>(2i, -2i, 7i), -2i) == vec3<i32>(0i, 0i, 1i)

fn rem_i32_left(x: i32, y: vec2<i32>) -> vec2<i32> { return x % y; }
// run: rem_i32_left(100i, vec2<i32>(2i, -2i)) == vec2<i32>(0i, 0i)

fn rem_u32(x: u32, y: u32) -> u32 { return x % y; }
// run: rem_u32(0u, 0u) == 0u
// run: rem_u32(0u, 1u) == 0u
// run: rem_u32(0u, 2u) == 0u
// run: rem_u32(0u, 7u) == 0u
// run: rem_u32(0u, 100u) == 0u
// run: rem_u32(0u, 0x7fffffffu) == 0u
// run: rem_u32(0u, 0x80000000u) == 0u
// run: rem_u32(0u, 0x80000001u) == 0u
// run: rem_u32(0u, 0xffffffffu) == 0u
// run: rem_u32(0u, 0xfffffffeu) == 0u
// run: rem_u32(0u, 0x12345678u) == 0u
// run: rem_u32(0u, 0xaaaaaaaau) == 0u
// run: rem_u32(0u, 0x00010000u) == 0u
// run: rem_u32(0u, 65535u) == 0u
// run: rem_u32(1u, 0u) == 0u
// run: rem_u32(1u, 1u) == 0u
// run: rem_u32(1u, 2u) == 1u
// run: rem_u32(1u, 7u) == 1u
// run: rem_u32(1u, 100u) == 1u
// run: rem_u32(1u, 0x7fffffffu) == 1u
// run: rem_u32(1u, 0x80000000u) == 1u
// run: rem_u32(1u, 0x80000001u) == 1u
// run: rem_u32(1u, 0xffffffffu) == 1u
// run: rem_u32(1u, 0xfffffffeu) == 1u
// run: rem_u32(1u, 0x12345678u) == 1u
// run: rem_u32(1u, 0xaaaaaaaau) == 1u
// run: rem_u32(1u, 0x00010000u) == 1u
// run: rem_u32(1u, 65535u) == 1u
// run: rem_u32(2u, 0u) == 0u
// run: rem_u32(2u, 1u) == 0u
// run: rem_u32(2u, 2u) == 0u
// run: rem_u32(2u, 7u) == 2u
// run: rem_u32(2u, 100u) == 2u
// run: rem_u32(2u, 0x7fffffffu) == 2u
// run: rem_u32(2u, 0x80000000u) == 2u
// run: rem_u32(2u, 0x80000001u) == 2u
// run: rem_u32(2u, 0xffffffffu) == 2u
// run: rem_u32(2u, 0xfffffffeu) == 2u
// run: rem_u32(2u, 0x12345678u) == 2u
// run: rem_u32(2u, 0xaaaaaaaau) == 2u
// run: rem_u32(2u, 0x00010000u) == 2u
// run: rem_u32(2u, 65535u) == 2u
// run: rem_u32(7u, 0u) == 0u
// run: rem_u32(7u, 1u) == 0u
// run: rem_u32(7u, 2u) == 1u
// run: rem_u32(7u, 7u) == 0u
// run: rem_u32(7u, 100u) == 7u
// run: rem_u32(7u, 0x7fffffffu) == 7u
// run: rem_u32(7u, 0x80000000u) == 7u
// run: rem_u32(7u, 0x80000001u) == 7u
// run: rem_u32(7u, 0xffffffffu) == 7u
// run: rem_u32(7u, 0xfffffffeu) == 7u
// run: rem_u32(7u, 0x12345678u) == 7u
// run: rem_u32(7u, 0xaaaaaaaau) == 7u
// run: rem_u32(7u, 0x00010000u) == 7u
// run: rem_u32(7u, 65535u) == 7u
// run: rem_u32(100u, 0u) == 0u
// run: rem_u32(100u, 1u) == 0u
// run: rem_u32(100u, 2u) == 0u
// run: rem_u32(100u, 7u) == 2u
// run: rem_u32(100u, 100u) == 0u
// run: rem_u32(100u, 0x7fffffffu) == 100u
// run: rem_u32(100u, 0x80000000u) == 100u
// run: rem_u32(100u, 0x80000001u) == 100u
// run: rem_u32(100u, 0xffffffffu) == 100u
// run: rem_u32(100u, 0xfffffffeu) == 100u
// run: rem_u32(100u, 0x12345678u) == 100u
// run: rem_u32(100u, 0xaaaaaaaau) == 100u
// run: rem_u32(100u, 0x00010000u) == 100u
// run: rem_u32(100u, 65535u) == 100u
// run: rem_u32(0x7fffffffu, 0u) == 0u
// run: rem_u32(0x7fffffffu, 1u) == 0u
// run: rem_u32(0x7fffffffu, 2u) == 1u
// run: rem_u32(0x7fffffffu, 7u) == 1u
// run: rem_u32(0x7fffffffu, 100u) == 47u
// run: rem_u32(0x7fffffffu, 0x7fffffffu) == 0u
// run: rem_u32(0x7fffffffu, 0x80000000u) == 0x7fffffffu
// run: rem_u32(0x7fffffffu, 0x80000001u) == 0x7fffffffu
// run: rem_u32(0x7fffffffu, 0xffffffffu) == 0x7fffffffu
// run: rem_u32(0x7fffffffu, 0xfffffffeu) == 0x7fffffffu
// run: rem_u32(0x7fffffffu, 0x12345678u) == 0x0091a2b7u
// run: rem_u32(0x7fffffffu, 0xaaaaaaaau) == 0x7fffffffu
// run: rem_u32(0x7fffffffu, 0x00010000u) == 65535u
// run: rem_u32(0x7fffffffu, 65535u) == 32767u
// run: rem_u32(0x80000000u, 0u) == 0u
// run: rem_u32(0x80000000u, 1u) == 0u
// run: rem_u32(0x80000000u, 2u) == 0u
// run: rem_u32(0x80000000u, 7u) == 2u
// run: rem_u32(0x80000000u, 100u) == 48u
// run: rem_u32(0x80000000u, 0x7fffffffu) == 1u
// run: rem_u32(0x80000000u, 0x80000000u) == 0u
// run: rem_u32(0x80000000u, 0x80000001u) == 0x80000000u
// run: rem_u32(0x80000000u, 0xffffffffu) == 0x80000000u
// run: rem_u32(0x80000000u, 0xfffffffeu) == 0x80000000u
// run: rem_u32(0x80000000u, 0x12345678u) == 0x0091a2b8u
// run: rem_u32(0x80000000u, 0xaaaaaaaau) == 0x80000000u
// run: rem_u32(0x80000000u, 0x00010000u) == 0u
// run: rem_u32(0x80000000u, 65535u) == 32768u
// run: rem_u32(0x80000001u, 0u) == 0u
// run: rem_u32(0x80000001u, 1u) == 0u
// run: rem_u32(0x80000001u, 2u) == 1u
// run: rem_u32(0x80000001u, 7u) == 3u
// run: rem_u32(0x80000001u, 100u) == 49u
// run: rem_u32(0x80000001u, 0x7fffffffu) == 2u
// run: rem_u32(0x80000001u, 0x80000000u) == 1u
// run: rem_u32(0x80000001u, 0x80000001u) == 0u
// run: rem_u32(0x80000001u, 0xffffffffu) == 0x80000001u
// run: rem_u32(0x80000001u, 0xfffffffeu) == 0x80000001u
// run: rem_u32(0x80000001u, 0x12345678u) == 0x0091a2b9u
// run: rem_u32(0x80000001u, 0xaaaaaaaau) == 0x80000001u
// run: rem_u32(0x80000001u, 0x00010000u) == 1u
// run: rem_u32(0x80000001u, 65535u) == 32769u
// run: rem_u32(0xffffffffu, 0u) == 0u
// run: rem_u32(0xffffffffu, 1u) == 0u
// run: rem_u32(0xffffffffu, 2u) == 1u
// run: rem_u32(0xffffffffu, 7u) == 3u
// run: rem_u32(0xffffffffu, 100u) == 95u
// run: rem_u32(0xffffffffu, 0x7fffffffu) == 1u
// run: rem_u32(0xffffffffu, 0x80000000u) == 0x7fffffffu
// run: rem_u32(0xffffffffu, 0x80000001u) == 0x7ffffffeu
// run: rem_u32(0xffffffffu, 0xffffffffu) == 0u
// run: rem_u32(0xffffffffu, 0xfffffffeu) == 1u
// run: rem_u32(0xffffffffu, 0x12345678u) == 0x0123456fu
// run: rem_u32(0xffffffffu, 0xaaaaaaaau) == 0x55555555u
// run: rem_u32(0xffffffffu, 0x00010000u) == 65535u
// run: rem_u32(0xffffffffu, 65535u) == 0u
// run: rem_u32(0xfffffffeu, 0u) == 0u
// run: rem_u32(0xfffffffeu, 1u) == 0u
// run: rem_u32(0xfffffffeu, 2u) == 0u
// run: rem_u32(0xfffffffeu, 7u) == 2u
// run: rem_u32(0xfffffffeu, 100u) == 94u
// run: rem_u32(0xfffffffeu, 0x7fffffffu) == 0u
// run: rem_u32(0xfffffffeu, 0x80000000u) == 0x7ffffffeu
// run: rem_u32(0xfffffffeu, 0x80000001u) == 0x7ffffffdu
// run: rem_u32(0xfffffffeu, 0xffffffffu) == 0xfffffffeu
// run: rem_u32(0xfffffffeu, 0xfffffffeu) == 0u
// run: rem_u32(0xfffffffeu, 0x12345678u) == 0x0123456eu
// run: rem_u32(0xfffffffeu, 0xaaaaaaaau) == 0x55555554u
// run: rem_u32(0xfffffffeu, 0x00010000u) == 65534u
// run: rem_u32(0xfffffffeu, 65535u) == 65534u
// run: rem_u32(0x12345678u, 0u) == 0u
// run: rem_u32(0x12345678u, 1u) == 0u
// run: rem_u32(0x12345678u, 2u) == 0u
// run: rem_u32(0x12345678u, 7u) == 5u
// run: rem_u32(0x12345678u, 100u) == 96u
// run: rem_u32(0x12345678u, 0x7fffffffu) == 0x12345678u
// run: rem_u32(0x12345678u, 0x80000000u) == 0x12345678u
// run: rem_u32(0x12345678u, 0x80000001u) == 0x12345678u
// run: rem_u32(0x12345678u, 0xffffffffu) == 0x12345678u
// run: rem_u32(0x12345678u, 0xfffffffeu) == 0x12345678u
// run: rem_u32(0x12345678u, 0x12345678u) == 0u
// run: rem_u32(0x12345678u, 0xaaaaaaaau) == 0x12345678u
// run: rem_u32(0x12345678u, 0x00010000u) == 22136u
// run: rem_u32(0x12345678u, 65535u) == 26796u
// run: rem_u32(0xaaaaaaaau, 0u) == 0u
// run: rem_u32(0xaaaaaaaau, 1u) == 0u
// run: rem_u32(0xaaaaaaaau, 2u) == 0u
// run: rem_u32(0xaaaaaaaau, 7u) == 2u
// run: rem_u32(0xaaaaaaaau, 100u) == 30u
// run: rem_u32(0xaaaaaaaau, 0x7fffffffu) == 0x2aaaaaabu
// run: rem_u32(0xaaaaaaaau, 0x80000000u) == 0x2aaaaaaau
// run: rem_u32(0xaaaaaaaau, 0x80000001u) == 0x2aaaaaa9u
// run: rem_u32(0xaaaaaaaau, 0xffffffffu) == 0xaaaaaaaau
// run: rem_u32(0xaaaaaaaau, 0xfffffffeu) == 0xaaaaaaaau
// run: rem_u32(0xaaaaaaaau, 0x12345678u) == 0x06d3a072u
// run: rem_u32(0xaaaaaaaau, 0xaaaaaaaau) == 0u
// run: rem_u32(0xaaaaaaaau, 0x00010000u) == 43690u
// run: rem_u32(0xaaaaaaaau, 65535u) == 21845u
// run: rem_u32(0x00010000u, 0u) == 0u
// run: rem_u32(0x00010000u, 1u) == 0u
// run: rem_u32(0x00010000u, 2u) == 0u
// run: rem_u32(0x00010000u, 7u) == 2u
// run: rem_u32(0x00010000u, 100u) == 36u
// run: rem_u32(0x00010000u, 0x7fffffffu) == 0x00010000u
// run: rem_u32(0x00010000u, 0x80000000u) == 0x00010000u
// run: rem_u32(0x00010000u, 0x80000001u) == 0x00010000u
// run: rem_u32(0x00010000u, 0xffffffffu) == 0x00010000u
// run: rem_u32(0x00010000u, 0xfffffffeu) == 0x00010000u
// run: rem_u32(0x00010000u, 0x12345678u) == 0x00010000u
// run: rem_u32(0x00010000u, 0xaaaaaaaau) == 0x00010000u
// run: rem_u32(0x00010000u, 0x00010000u) == 0u
// run: rem_u32(0x00010000u, 65535u) == 1u
// run: rem_u32(65535u, 0u) == 0u
// run: rem_u32(65535u, 1u) == 0u
// run: rem_u32(65535u, 2u) == 1u
// run: rem_u32(65535u, 7u) == 1u
// run: rem_u32(65535u, 100u) == 35u
// run: rem_u32(65535u, 0x7fffffffu) == 65535u
// run: rem_u32(65535u, 0x80000000u) == 65535u
// run: rem_u32(65535u, 0x80000001u) == 65535u
// run: rem_u32(65535u, 0xffffffffu) == 65535u
// run: rem_u32(65535u, 0xfffffffeu) == 65535u
// run: rem_u32(65535u, 0x12345678u) == 65535u
// run: rem_u32(65535u, 0xaaaaaaaau) == 65535u
// run: rem_u32(65535u, 0x00010000u) == 65535u
// run: rem_u32(65535u, 65535u) == 0u

fn rem_u32_vec2(x: vec2<u32>, y: vec2<u32>) -> vec2<u32> { return x % y; }
// run: rem_u32_vec2(vec2<u32>(0u, 1u), vec2<u32>(1u, 7u)) == vec2<u32>(0u, 1u)
// run: rem_u32_vec2(vec2<u32>(7u, 100u), vec2<u32>(0x80000000u, 0xffffffffu)) == vec2<u32>(7u, 100u)
// run: rem_u32_vec2(vec2<u32>(0x80000000u, 0x80000001u), vec2<u32>(0xaaaaaaaau, 65535u)) == vec2<u32>(0x80000000u, 32769u)
// run: rem_u32_vec2(vec2<u32>(0xfffffffeu, 0x12345678u), vec2<u32>(2u, 100u)) == vec2<u32>(0u, 96u)

fn rem_u32_vec3(x: vec3<u32>, y: vec3<u32>) -> vec3<u32> { return x % y; }
// run: rem_u32_vec3(vec3<u32>(0u, 1u, 2u), vec3<u32>(1u, 7u, 0x7fffffffu)) == vec3<u32>(0u, 1u, 2u)
// run: rem_u32_vec3(vec3<u32>(7u, 100u, 0x7fffffffu), vec3<u32>(0x80000000u, 0xffffffffu, 0x12345678u)) == vec3<u32>(7u, 100u, 0x0091a2b7u)
// run: rem_u32_vec3(vec3<u32>(0x80000000u, 0x80000001u, 0xffffffffu), vec3<u32>(0xaaaaaaaau, 65535u, 1u)) == vec3<u32>(0x80000000u, 32769u, 0u)
// run: rem_u32_vec3(vec3<u32>(0xfffffffeu, 0x12345678u, 0xaaaaaaaau), vec3<u32>(2u, 100u, 0x80000000u)) == vec3<u32>(0u, 96u, 0x2aaaaaaau)

fn rem_u32_vec4(x: vec4<u32>, y: vec4<u32>) -> vec4<u32> { return x % y; }
// run: rem_u32_vec4(vec4<u32>(0u, 1u, 2u, 7u), vec4<u32>(1u, 7u, 0x7fffffffu, 0x80000001u)) == vec4<u32>(0u, 1u, 2u, 7u)
// run: rem_u32_vec4(vec4<u32>(7u, 100u, 0x7fffffffu, 0x80000000u), vec4<u32>(0x80000000u, 0xffffffffu, 0x12345678u, 0x00010000u)) == vec4<u32>(7u, 100u, 0x0091a2b7u, 0u)
// run: rem_u32_vec4(vec4<u32>(0x80000000u, 0x80000001u, 0xffffffffu, 0xfffffffeu), vec4<u32>(0xaaaaaaaau, 65535u, 1u, 7u)) == vec4<u32>(0x80000000u, 32769u, 0u, 2u)
// run: rem_u32_vec4(vec4<u32>(0xfffffffeu, 0x12345678u, 0xaaaaaaaau, 0x00010000u), vec4<u32>(2u, 100u, 0x80000000u, 0xffffffffu)) == vec4<u32>(0u, 96u, 0x2aaaaaaau, 0x00010000u)

fn rem_u32_splat(x: vec3<u32>, y: u32) -> vec3<u32> { return x % y; }
// run: rem_u32_splat(vec3<u32>(1u, 2u, 7u), 2u) == vec3<u32>(1u, 0u, 1u)
// run: rem_u32_splat(vec3<u32>(2u, 7u, 100u), 7u) == vec3<u32>(2u, 0u, 2u)
// run: rem_u32_splat(vec3<u32>(7u, 100u, 0x7fffffffu), 100u) == vec3<u32>(7u, 0u, 47u)

fn rem_u32_left(x: u32, y: vec2<u32>) -> vec2<u32> { return x % y; }
// run: rem_u32_left(0x80000001u, vec2<u32>(7u, 100u)) == vec2<u32>(3u, 49u)
