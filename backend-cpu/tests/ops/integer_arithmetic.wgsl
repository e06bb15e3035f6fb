// Sums and products wrap modulo 2^32.

fn add_i32(x: i32, y: i32) -> i32 { return x + y; }
// run: add_i32(0i, 0i) == 0i
// run: add_i32(0i, 2i) == 2i
// run: add_i32(0i, -7i) == -7i
// run: add_i32(0i, -2147483648i) == -2147483648i
// run: add_i32(0i, -305419896i) == -305419896i
// run: add_i32(0i, 1i) == 1i
// run: add_i32(1i, 0i) == 1i
// run: add_i32(1i, 2i) == 3i
// run: add_i32(1i, -7i) == -6i
// run: add_i32(1i, -2147483648i) == -2147483647i
// run: add_i32(1i, -305419896i) == -305419895i
// run: add_i32(1i, 1i) == 2i
// run: add_i32(-1i, 0i) == -1i
// run: add_i32(-1i, 2i) == 1i
// run: add_i32(-1i, -7i) == -8i
// run: add_i32(-1i, -2147483648i) == 2147483647i
// run: add_i32(-1i, -305419896i) == -305419897i
// run: add_i32(-1i, 1i) == 0i
// run: add_i32(2i, 0i) == 2i
// run: add_i32(2i, 2i) == 4i
// run: add_i32(2i, -7i) == -5i
// run: add_i32(2i, -2147483648i) == -2147483646i
// run: add_i32(2i, -305419896i) == -305419894i
// run: add_i32(2i, 1i) == 3i
// run: add_i32(-2i, 0i) == -2i
// run: add_i32(-2i, 2i) == 0i
// run: add_i32(-2i, -7i) == -9i
// run: add_i32(-2i, -2147483648i) == 2147483646i
// run: add_i32(-2i, -305419896i) == -305419898i
// run: add_i32(-2i, 1i) == -1i
// run: add_i32(7i, 0i) == 7i
// run: add_i32(7i, 2i) == 9i
// run: add_i32(7i, -7i) == 0i
// run: add_i32(7i, -2147483648i) == -2147483641i
// run: add_i32(7i, -305419896i) == -305419889i
// run: add_i32(7i, 1i) == 8i
// run: add_i32(-7i, 0i) == -7i
// run: add_i32(-7i, 2i) == -5i
// run: add_i32(-7i, -7i) == -14i
// run: add_i32(-7i, -2147483648i) == 2147483641i
// run: add_i32(-7i, -305419896i) == -305419903i
// run: add_i32(-7i, 1i) == -6i
// run: add_i32(100i, 0i) == 100i
// run: add_i32(100i, 2i) == 102i
// run: add_i32(100i, -7i) == 93i
// run: add_i32(100i, -2147483648i) == -2147483548i
// run: add_i32(100i, -305419896i) == -305419796i
// run: add_i32(100i, 1i) == 101i
// run: add_i32(2147483647i, 0i) == 2147483647i
// run: add_i32(2147483647i, 2i) == -2147483647i
// run: add_i32(2147483647i, -7i) == 2147483640i
// run: add_i32(2147483647i, -2147483648i) == -1i
// run: add_i32(2147483647i, -305419896i) == 1842063751i
// run: add_i32(2147483647i, 1i) == -2147483648i
// run: add_i32(-2147483648i, 0i) == -2147483648i
// run: add_i32(-2147483648i, 2i) == -2147483646i
// run: add_i32(-2147483648i, -7i) == 2147483641i
// run: add_i32(-2147483648i, -2147483648i) == 0i
// run: add_i32(-2147483648i, -305419896i) == 1842063752i
// run: add_i32(-2147483648i, 1i) == -2147483647i
// run: add_i32(-2147483647i, 0i) == -2147483647i
// run: add_i32(-2147483647i, 2i) == -2147483645i
// run: add_i32(-2147483647i, -7i) == 2147483642i
// run: add_i32(-2147483647i, -2147483648i) == 1i
// run: add_i32(-2147483647i, -305419896i) == 1842063753i
// run: add_i32(-2147483647i, 1i) == -2147483646i
// run: add_i32(305419896i, 0i) == 305419896i
// run: add_i32(305419896i, 2i) == 305419898i
// run: add_i32(305419896i, -7i) == 305419889i
// run: add_i32(305419896i, -2147483648i) == -1842063752i
// run: add_i32(305419896i, -305419896i) == 0i
// run: add_i32(305419896i, 1i) == 305419897i
// run: add_i32(-305419896i, 0i) == -305419896i
// run: add_i32(-305419896i, 2i) == -305419894i
// run: add_i32(-305419896i, -7i) == -305419903i
// run: add_i32(-305419896i, -2147483648i) == 1842063752i
// run: add_i32(-305419896i, -305419896i) == -610839792i
// run: add_i32(-305419896i, 1i) == -305419895i
// run: add_i32(1431655765i, 0i) == 1431655765i
// run: add_i32(1431655765i, 2i) == 1431655767i
// run: add_i32(1431655765i, -7i) == 1431655758i
// run: add_i32(1431655765i, -2147483648i) == -715827883i
// run: add_i32(1431655765i, -305419896i) == 1126235869i
// run: add_i32(1431655765i, 1i) == 1431655766i
// run: add_i32(65536i, 0i) == 65536i
// run: add_i32(65536i, 2i) == 65538i
// run: add_i32(65536i, -7i) == 65529i
// run: add_i32(65536i, -2147483648i) == -2147418112i
// run: add_i32(65536i, -305419896i) == -305354360i
// run: add_i32(65536i, 1i) == 65537i

fn add_i32_vec2(x: vec2<i32>, y: vec2<i32>) -> vec2<i32> { return x + y; }
// run: add_i32_vec2(vec2<i32>(0i, 1i), vec2<i32>(1i, 2i)) == vec2<i32>(1i, 3i)
// run: add_i32_vec2(vec2<i32>(2i, -2i), vec2<i32>(-7i, 2147483647i)) == vec2<i32>(-5i, 2147483645i)
// run: add_i32_vec2(vec2<i32>(-7i, 100i), vec2<i32>(305419896i, 1431655765i)) == vec2<i32>(305419889i, 1431655865i)
// run: add_i32_vec2(vec2<i32>(-2147483648i, -2147483647i), vec2<i32>(1i, 2i)) == vec2<i32>(-2147483647i, -2147483645i)

fn add_i32_vec3(x: vec3<i32>, y: vec3<i32>) -> vec3<i32> { return x + y; }
// run: add_i32_vec3(vec3<i32>(0i, 1i, -1i), vec3<i32>(1i, 2i, 7i)) == vec3<i32>(1i, 3i, 6i)
// run: add_i32_vec3(vec3<i32>(2i, -2i, 7i), vec3<i32>(-7i, 2147483647i, -2147483647i)) == vec3<i32>(-5i, 2147483645i, -2147483640i)
// run: add_i32_vec3(vec3<i32>(-7i, 100i, 2147483647i), vec3<i32>(305419896i, 1431655765i, 0i)) == vec3<i32>(305419889i, 1431655865i, 2147483647i)
// run: add_i32_vec3(vec3<i32>(-2147483648i, -2147483647i, 305419896i), vec3<i32>(1i, 2i, 7i)) == vec3<i32>(-2147483647i, -2147483645i, 305419903i)

fn add_i32_vec4(x: vec4<i32>, y: vec4<i32>) -> vec4<i32> { return x + y; }
// run: add_i32_vec4(vec4<i32>(0i, 1i, -1i, 2i), vec4<i32>(1i, 2i, 7i, 100i)) == vec4<i32>(1i, 3i, 6i, 102i)
// run: add_i32_vec4(vec4<i32>(2i, -2i, 7i, -7i), vec4<i32>(-7i, 2147483647i, -2147483647i, -305419896i)) == vec4<i32>(-5i, 2147483645i, -2147483640i, -305419903i)
// run: add_i32_vec4(vec4<i32>(-7i, 100i, 2147483647i, -2147483648i), vec4<i32>(305419896i, 1431655765i, 0i, -1i)) == vec4<i32>(305419889i, 1431655865i, 2147483647i, 2147483647i)
// run: add_i32_vec4(vec4<i32>(-2147483648i, -2147483647i, 305419896i, -305419896i), vec4<i32>(1i, 2i, 7i, 100i)) == vec4<i32>(-2147483647i, -2147483645i, 305419903i, -305419796i)

fn add_i32_splat(x: vec3<i32>, y: i32) -> vec3<i32> { return x + y; }
// run: add_i32_splat(vec3<i32>(1i, -1i, 2i), -1i) == vec3<i32>(0i, -2i, 1i)
// run: add_i32_splat(vec3<i32>(-1i, 2i, -2i), 2i) == vec3<i32>(1i, 4i, 0i)
// run: add_i32_splat(vec3<i32>(2i, -2i, 7i), -2i) == vec3<i32>(0i, -4i, 5i)

fn add_i32_left(x: i32, y: vec2<i32>) -> vec2<i32> { return x + y; }
// run: add_i32_left(100i, vec2<i32>(2i, -2i)) == vec2<i32>(102i, 98i)

fn add_u32(x: u32, y: u32) -> u32 { return x + y; }
// run: add_u32(0u, 0u) == 0u
// run: add_u32(0u, 7u) == 7u
// run: add_u32(0u, 0x80000000u) == 0x80000000u
// run: add_u32(0u, 0xfffffffeu) == 0xfffffffeu
// run: add_u32(0u, 0x00010000u) == 0x00010000u
// run: add_u32(0u, 1u) == 1u
// run: add_u32(1u, 0u) == 1u
// run: add_u32(1u, 7u) == 8u
// run: add_u32(1u, 0x80000000u) == 0x80000001u
// run: add_u32(1u, 0xfffffffeu) == 0xffffffffu
// run: add_u32(1u, 0x00010000u) == 0x00010001u
// run: add_u32(1u, 1u) == 2u
// run: add_u32(2u, 0u) == 2u
// run: add_u32(2u, 7u) == 9u
// run: add_u32(2u, 0x80000000u) == 0x80000002u
// run: add_u32(2u, 0xfffffffeu) == 0u
// run: add_u32(2u, 0x00010000u) == 0x00010002u
// run: add_u32(2u, 1u) == 3u
// run: add_u32(7u, 0u) == 7u
// run: add_u32(7u, 7u) == 14u
// run: add_u32(7u, 0x80000000u) == 0x80000007u
// run: add_u32(7u, 0xfffffffeu) == 5u
// run: add_u32(7u, 0x00010000u) == 0x00010007u
// run: add_u32(7u, 1u) == 8u
// run: add_u32(100u, 0u) == 100u
// run: add_u32(100u, 7u) == 107u
// run: add_u32(100u, 0x80000000u) == 0x80000064u
// run: add_u32(100u, 0xfffffffeu) == 98u
// run: add_u32(100u, 0x00010000u) == 0x00010064u
// run: add_u32(100u, 1u) == 101u
// run: add_u32(0x7fffffffu, 0u) == 0x7fffffffu
// run: add_u32(0x7fffffffu, 7u) == 0x80000006u
// run: add_u32(0x7fffffffu, 0x80000000u) == 0xffffffffu
// run: add_u32(0x7fffffffu, 0xfffffffeu) == 0x7ffffffdu
// run: add_u32(0x7fffffffu, 0x00010000u) == 0x8000ffffu
// run: add_u32(0x7fffffffu, 1u) == 0x80000000u
// run: add_u32(0x80000000u, 0u) == 0x80000000u
// run: add_u32(0x80000000u, 7u) == 0x80000007u
// run: add_u32(0x80000000u, 0x80000000u) == 0u
// run: add_u32(0x80000000u, 0xfffffffeu) == 0x7ffffffeu
// run: add_u32(0x80000000u, 0x00010000u) == 0x80010000u
// run: add_u32(0x80000000u, 1u) == 0x80000001u
// run: add_u32(0x80000001u, 0u) == 0x80000001u
// run: add_u32(0x80000001u, 7u) == 0x80000008u
// run: add_u32(0x80000001u, 0x80000000u) == 1u
// run: add_u32(0x80000001u, 0xfffffffeu) == 0x7fffffffu
// run: add_u32(0x80000001u, 0x00010000u) == 0x80010001u
// run: add_u32(0x80000001u, 1u) == 0x80000002u
// run: add_u32(0xffffffffu, 0u) == 0xffffffffu
// run: add_u32(0xffffffffu, 7u) == 6u
// run: add_u32(0xffffffffu, 0x80000000u) == 0x7fffffffu
// run: add_u32(0xffffffffu, 0xfffffffeu) == 0xfffffffdu
// run: add_u32(0xffffffffu, 0x00010000u) == 65535u
// run: add_u32(0xffffffffu, 1u) == 0u
// run: add_u32(0xfffffffeu, 0u) == 0xfffffffeu
// run: add_u32(0xfffffffeu, 7u) == 5u
// run: add_u32(0xfffffffeu, 0x80000000u) == 0x7ffffffeu
// run: add_u32(0xfffffffeu, 0xfffffffeu) == 0xfffffffcu
// run: add_u32(0xfffffffeu, 0x00010000u) == 65534u
// run: add_u32(0xfffffffeu, 1u) == 0xffffffffu
// run: add_u32(0x12345678u, 0u) == 0x12345678u
// run: add_u32(0x12345678u, 7u) == 0x1234567fu
// run: add_u32(0x12345678u, 0x80000000u) == 0x92345678u
// run: add_u32(0x12345678u, 0xfffffffeu) == 0x12345676u
// run: add_u32(0x12345678u, 0x00010000u) == 0x12355678u
// run: add_u32(0x12345678u, 1u) == 0x12345679u
// run: add_u32(0xaaaaaaaau, 0u) == 0xaaaaaaaau
// run: add_u32(0xaaaaaaaau, 7u) == 0xaaaaaab1u
// run: add_u32(0xaaaaaaaau, 0x80000000u) == 0x2aaaaaaau
// run: add_u32(0xaaaaaaaau, 0xfffffffeu) == 0xaaaaaaa8u
// run: add_u32(0xaaaaaaaau, 0x00010000u) == 0xaaabaaaau
// run: add_u32(0xaaaaaaaau, 1u) == 0xaaaaaaabu
// run: add_u32(0x00010000u, 0u) == 0x00010000u
// run: add_u32(0x00010000u, 7u) == 0x00010007u
// run: add_u32(0x00010000u, 0x80000000u) == 0x80010000u
// run: add_u32(0x00010000u, 0xfffffffeu) == 65534u
// run: add_u32(0x00010000u, 0x00010000u) == 0x00020000u
// run: add_u32(0x00010000u, 1u) == 0x00010001u
// run: add_u32(65535u, 0u) == 65535u
// run: add_u32(65535u, 7u) == 0x00010006u
// run: add_u32(65535u, 0x80000000u) == 0x8000ffffu
// run: add_u32(65535u, 0xfffffffeu) == 65533u
// run: add_u32(65535u, 0x00010000u) == 0x0001ffffu
// run: add_u32(65535u, 1u) == 0x00010000u

fn add_u32_vec2(x: vec2<u32>, y: vec2<u32>) -> vec2<u32> { return x + y; }
// run: add_u32_vec2(vec2<u32>(0u, 1u), vec2<u32>(1u, 7u)) == vec2<u32>(1u, 8u)
// run: add_u32_vec2(vec2<u32>(7u, 100u), vec2<u32>(0x80000000u, 0xffffffffu)) == vec2<u32>(0x80000007u, 99u)
// run: add_u32_vec2(vec2<u32>(0x80000000u, 0x80000001u), vec2<u32>(0xaaaaaaaau, 65535u)) == vec2<u32>(0x2aaaaaaau, 0x80010000u)
// run: add_u32_vec2(vec2<u32>(0xfffffffeu, 0x12345678u), vec2<u32>(2u, 100u)) == vec2<u32>(0u, 0x123456dcu)

fn add_u32_vec3(x: vec3<u32>, y: vec3<u32>) -> vec3<u32> { return x + y; }
// run: add_u32_vec3(vec3<u32>(0u, 1u, 2u), vec3<u32>(1u, 7u, 0x7fffffffu)) == vec3<u32>(1u, 8u, 0x80000001u)
// run: add_u32_vec3(vec3<u32>(7u, 100u, 0x7fffffffu), vec3<u32>(0x80000000u, 0xffffffffu, 0x12345678u)) == vec3<u32>(0x80000007u, 99u, 0x92345677u)
// run: add_u32_vec3(vec3<u32>(0x80000000u, 0x80000001u, 0xffffffffu), vec3<u32>(0xaaaaaaaau, 65535u, 1u)) == vec3<u32>(0x2aaaaaaau, 0x80010000u, 0u)
// run: add_u32_vec3(vec3<u32>(0xfffffffeu, 0x12345678u, 0xaaaaaaaau), vec3<u32>(2u, 100u, 0x80000000u)) == vec3<u32>(0u, 0x123456dcu, 0x2aaaaaaau)

fn add_u32_vec4(x: vec4<u32>, y: vec4<u32>) -> vec4<u32> { return x + y; }
// run: add_u32_vec4(vec4<u32>(0u, 1u, 2u, 7u), vec4<u32>(1u, 7u, 0x7fffffffu, 0x80000001u)) == vec4<u32>(1u, 8u, 0x80000001u, 0x80000008u)
// run: add_u32_vec4(vec4<u32>(7u, 100u, 0x7fffffffu, 0x80000000u), vec4<u32>(0x80000000u, 0xffffffffu, 0x12345678u, 0x00010000u)) == vec4<u32>(0x80000007u, 99u, 0x92345677u, 0x80010000u)
// run: add_u32_vec4(vec4<u32>(0x80000000u, 0x80000001u, 0xffffffffu, 0xfffffffeu), vec4<u32>(0xaaaaaaaau, 65535u, 1u, 7u)) == vec4<u32>(0x2aaaaaaau, 0x80010000u, 0u, 5u)
// run: add_u32_vec4(vec4<u32>(0xfffffffeu, 0x12345678u, 0xaaaaaaaau, 0x00010000u), vec4<u32>(2u, 100u, 0x80000000u, 0xffffffffu)) == vec4<u32>(0u, 0x123456dcu, 0x2aaaaaaau, 65535u)

fn add_u32_splat(x: vec3<u32>, y: u32) -> vec3<u32> { return x + y; }
// run: add_u32_splat(vec3<u32>(1u, 2u, 7u), 2u) == vec3<u32>(3u, 4u, 9u)
// run: add_u32_splat(vec3<u32>(2u, 7u, 100u), 7u) == vec3<u32>(9u, 14u, 107u)
// run: add_u32_splat(vec3<u32>(7u, 100u, 0x7fffffffu), 100u) == vec3<u32>(107u, 200u, 0x80000063u)

fn add_u32_left(x: u32, y: vec2<u32>) -> vec2<u32> { return x + y; }
// run: add_u32_left(0x80000001u, vec2<u32>(7u, 100u)) == vec2<u32>(0x80000008u, 0x80000065u)

fn sub_i32(x: i32, y: i32) -> i32 { return x - y; }
// run: sub_i32(0i, 0i) == 0i
// run: sub_i32(0i, 2i) == -2i
// run: sub_i32(0i, -7i) == 7i
// run: sub_i32(0i, -2147483648i) == -2147483648i
// run: sub_i32(0i, -305419896i) == 305419896i
// run: sub_i32(0i, 1i) == -1i
// run: sub_i32(1i, 0i) == 1i
// run: sub_i32(1i, 2i) == -1i
// run: sub_i32(1i, -7i) == 8i
// run: sub_i32(1i, -2147483648i) == -2147483647i
// run: sub_i32(1i, -305419896i) == 305419897i
// run: sub_i32(1i, 1i) == 0i
// run: sub_i32(-1i, 0i) == -1i
// run: sub_i32(-1i, 2i) == -3i
// run: sub_i32(-1i, -7i) == 6i
// run: sub_i32(-1i, -2147483648i) == 2147483647i
// run: sub_i32(-1i, -305419896i) == 305419895i
// run: sub_i32(-1i, 1i) == -2i
// run: sub_i32(2i, 0i) == 2i
// run: sub_i32(2i, 2i) == 0i
// run: sub_i32(2i, -7i) == 9i
// run: sub_i32(2i, -2147483648i) == -2147483646i
// run: sub_i32(2i, -305419896i) == 305419898i
// run: sub_i32(2i, 1i) == 1i
// run: sub_i32(-2i, 0i) == -2i
// run: sub_i32(-2i, 2i) == -4i
// run: sub_i32(-2i, -7i) == 5i
// run: sub_i32(-2i, -2147483648i) == 2147483646i
// run: sub_i32(-2i, -305419896i) == 305419894i
// run: sub_i32(-2i, 1i) == -3i
// run: sub_i32(7i, 0i) == 7i
// run: sub_i32(7i, 2i) == 5i
// run: sub_i32(7i, -7i) == 14i
// run: sub_i32(7i, -2147483648i) == -2147483641i
// run: sub_i32(7i, -305419896i) == 305419903i
// run: sub_i32(7i, 1i) == 6i
// run: sub_i32(-7i, 0i) == -7i
// run: sub_i32(-7i, 2i) == -9i
// run: sub_i32(-7i, -7i) == 0i
// run: sub_i32(-7i, -2147483648i) == 2147483641i
// run: sub_i32(-7i, -305419896i) == 305419889i
// run: sub_i32(-7i, 1i) == -8i
// run: sub_i32(100i, 0i) == 100i
// run: sub_i32(100i, 2i) == 98i
// run: sub_i32(100i, -7i) == 107i
// run: sub_i32(100i, -2147483648i) == -2147483548i
// run: sub_i32(100i, -305419896i) == 305419996i
// run: sub_i32(100i, 1i) == 99i
// run: sub_i32(2147483647i, 0i) == 2147483647i
// run: sub_i32(2147483647i, 2i) == 2147483645i
// run: sub_i32(2147483647i, -7i) == -2147483642i
// run: sub_i32(2147483647i, -2147483648i) == -1i
// run: sub_i32(2147483647i, -305419896i) == -1842063753i
// run: sub_i32(2147483647i, 1i) == 2147483646i
// run: sub_i32(-2147483648i, 0i) == -2147483648i
// run: sub_i32(-2147483648i, 2i) == 2147483646i
// run: sub_i32(-2147483648i, -7i) == -2147483641i
// run: sub_i32(-2147483648i, -2147483648i) == 0i
// run: sub_i32(-2147483648i, -305419896i) == -1842063752i
// run: sub_i32(-2147483648i, 1i) == 2147483647i
// run: sub_i32(-2147483647i, 0i) == -2147483647i
// run: sub_i32(-2147483647i, 2i) == 2147483647i
// run: sub_i32(-2147483647i, -7i) == -2147483640i
// run: sub_i32(-2147483647i, -2147483648i) == 1i
// run: sub_i32(-2147483647i, -305419896i) == -1842063751i
// run: sub_i32(-2147483647i, 1i) == -2147483648i
// run: sub_i32(305419896i, 0i) == 305419896i
// run: sub_i32(305419896i, 2i) == 305419894i
// run: sub_i32(305419896i, -7i) == 305419903i
// run: sub_i32(305419896i, -2147483648i) == -1842063752i
// run: sub_i32(305419896i, -305419896i) == 610839792i
// run: sub_i32(305419896i, 1i) == 305419895i
// run: sub_i32(-305419896i, 0i) == -305419896i
// run: sub_i32(-305419896i, 2i) == -305419898i
// run: sub_i32(-305419896i, -7i) == -305419889i
// run: sub_i32(-305419896i, -2147483648i) == 1842063752i
// run: sub_i32(-305419896i, -305419896i) == 0i
// run: sub_i32(-305419896i, 1i) == -305419897i
// run: sub_i32(1431655765i, 0i) == 1431655765i
// run: sub_i32(1431655765i, 2i) == 1431655763i
// run: sub_i32(1431655765i, -7i) == 1431655772i
// run: sub_i32(1431655765i, -2147483648i) == -715827883i
// run: sub_i32(1431655765i, -305419896i) == 1737075661i
// run: sub_i32(1431655765i, 1i) == 1431655764i
// run: sub_i32(65536i, 0i) == 65536i
// run: sub_i32(65536i, 2i) == 65534i
// run: sub_i32(65536i, -7i) == 65543i
// run: sub_i32(65536i, -2147483648i) == -2147418112i
// run: sub_i32(65536i, -305419896i) == 305485432i
// run: sub_i32(65536i, 1i) == 65535i

fn sub_i32_vec2(x: vec2<i32>, y: vec2<i32>) -> vec2<i32> { return x - y; }
// run: sub_i32_vec2(vec2<i32>(0i, 1i), vec2<i32>(1i, 2i)) == vec2<i32>(-1i, -1i)
// run: sub_i32_vec2(vec2<i32>(2i, -2i), vec2<i32>(-7i, 2147483647i)) == vec2<i32>(9i, 2147483647i)
// run: sub_i32_vec2(vec2<i32>(-7i, 100i), vec2<i32>(305419896i, 1431655765i)) == vec2<i32>(-305419903i, -1431655665i)
// run: sub_i32_vec2(vec2<i32>(-2147483648i, -2147483647i), vec2<i32>(1i, 2i)) == vec2<i32>(2147483647i, 2147483647i)

fn sub_i32_vec3(x: vec3<i32>, y: vec3<i32>) -> vec3<i32> { return x - y; }
// run: sub_i32_vec3(vec3<i32>(0i, 1i, -1i), vec3<i32>(1i, 2i, 7i)) == vec3<i32>(-1i, -1i, -8i)
// run: sub_i32_vec3(vec3<i32>(2i, -2i, 7i), vec3<i32>(-7i, 2147483647i, -2147483647i)) == vec3<i32>(9i, 2147483647i, -2147483642i)
// run: sub_i32_vec3(vec3<i32>(-7i, 100i, 2147483647i), vec3<i32>(305419896i, 1431655765i, 0i)) == vec3<i32>(-305419903i, -1431655665i, 2147483647i)
// run: sub_i32_vec3(vec3<i32>(-2147483648i, -2147483647i, 305419896i), vec3<i32>(1i, 2i, 7i)) == vec3<i32>(2147483647i, 2147483647i, 305419889i)

fn sub_i32_vec4(x: vec4<i32>, y: vec4<i32>) -> vec4<i32> { return x - y; }
// run: sub_i32_vec4(vec4<i32>(0i, 1i, -1i, 2i), vec4<i32>(1i, 2i, 7i, 100i)) == vec4<i32>(-1i, -1i, -8i, -98i)
// run: sub_i32_vec4(vec4<i32>(2i, -2i, 7i, -7i), vec4<i32>(-7i, 2147483647i, -2147483647i, -305419896i)) == vec4<i32>(9i, 2147483647i, -2147483642i, 305419889i)
// run: sub_i32_vec4(vec4<i32>(-7i, 100i, 2147483647i, -2147483648i), vec4<i32>(305419896i, 1431655765i, 0i, -1i)) == vec4<i32>(-305419903i, -1431655665i, 2147483647i, -2147483647i)
// run: sub_i32_vec4(vec4<i32>(-2147483648i, -2147483647i, 305419896i, -305419896i), vec4<i32>(1i, 2i, 7i, 100i)) == vec4<i32>(2147483647i, 2147483647i, 305419889i, -305419996i)

fn sub_i32_splat(x: vec3<i32>, y: i32) -> vec3<i32> { return x - y; }
// run: sub_i32_splat(vec3<i32>(1i, -1i, 2i), -1i) == vec3<i32>(2i, 0i, 3i)
// run: sub_i32_splat(vec3<i32>(-1i, 2i, -2i), 2i) == vec3<i32>(-3i, 0i, -4i)
// run: sub_i32_splat(vec3<i32>(2i, -2i, 7i), -2i) == vec3<i32>(4i, 0i, 9i)

fn sub_i32_left(x: i32, y: vec2<i32>) -> vec2<i32> { return x - y; }
// run: sub_i32_left(100i, vec2<i32>(2i, -2i)) == vec2<i32>(98i, 102i)

fn sub_u32(x: u32, y: u32) -> u32 { return x - y; }
// run: sub_u32(0u, 0u) == 0u
// run: sub_u32(0u, 7u) == 0xfffffff9u
// run: sub_u32(0u, 0x80000000u) == 0x80000000u
// run: sub_u32(0u, 0xfffffffeu) == 2u
// run: sub_u32(0u, 0x00010000u) == 0xffff0000u
// run: sub_u32(0u, 1u) == 0xffffffffu
// run: sub_u32(1u, 0u) == 1u
// run: sub_u32(1u, 7u) == 0xfffffffau
// run: sub_u32(1u, 0x80000000u) == 0x80000001u
// run: sub_u32(1u, 0xfffffffeu) == 3u
// run: sub_u32(1u, 0x00010000u) == 0xffff0001u
// run: sub_u32(1u, 1u) == 0u
// run: sub_u32(2u, 0u) == 2u
// run: sub_u32(2u, 7u) == 0xfffffffbu
// run: sub_u32(2u, 0x80000000u) == 0x80000002u
// run: sub_u32(2u, 0xfffffffeu) == 4u
// run: sub_u32(2u, 0x00010000u) == 0xffff0002u
// run: sub_u32(2u, 1u) == 1u
// run: sub_u32(7u, 0u) == 7u
// run: sub_u32(7u, 7u) == 0u
// run: sub_u32(7u, 0x80000000u) == 0x80000007u
// run: sub_u32(7u, 0xfffffffeu) == 9u
// run: sub_u32(7u, 0x00010000u) == 0xffff0007u
// run: sub_u32(7u, 1u) == 6u
// run: sub_u32(100u, 0u) == 100u
// run: sub_u32(100u, 7u) == 93u
// run: sub_u32(100u, 0x80000000u) == 0x80000064u
// run: sub_u32(100u, 0xfffffffeu) == 102u
// run: sub_u32(100u, 0x00010000u) == 0xffff0064u
// run: sub_u32(100u, 1u) == 99u
// run: sub_u32(0x7fffffffu, 0u) == 0x7fffffffu
// run: sub_u32(0x7fffffffu, 7u) == 0x7ffffff8u
// run: sub_u32(0x7fffffffu, 0x80000000u) == 0xffffffffu
// run: sub_u32(0x7fffffffu, 0xfffffffeu) == 0x80000001u
// run: sub_u32(0x7fffffffu, 0x00010000u) == 0x7ffeffffu
// run: sub_u32(0x7fffffffu, 1u) == 0x7ffffffeu
// run: sub_u32(0x80000000u, 0u) == 0x80000000u
// run: sub_u32(0x80000000u, 7u) == 0x7ffffff9u
// run: sub_u32(0x80000000u, 0x80000000u) == 0u
// run: sub_u32(0x80000000u, 0xfffffffeu) == 0x80000002u
// run: sub_u32(0x80000000u, 0x00010000u) == 0x7fff0000u
// run: sub_u32(0x80000000u, 1u) == 0x7fffffffu
// run: sub_u32(0x80000001u, 0u) == 0x80000001u
// run: sub_u32(0x80000001u, 7u) == 0x7ffffffau
// run: sub_u32(0x80000001u, 0x80000000u) == 1u
// run: sub_u32(0x80000001u, 0xfffffffeu) == 0x80000003u
// run: sub_u32(0x80000001u, 0x00010000u) == 0x7fff0001u
// run: sub_u32(0x80000001u, 1u) == 0x80000000u
// run: sub_u32(0xffffffffu, 0u) == 0xffffffffu
// run: sub_u32(0xffffffffu, 7u) == 0xfffffff8u
// run: sub_u32(0xffffffffu, 0x80000000u) == 0x7fffffffu
// run: sub_u32(0xffffffffu, 0xfffffffeu) == 1u
// run: sub_u32(0xffffffffu, 0x00010000u) == 0xfffeffffu
// run: sub_u32(0xffffffffu, 1u) == 0xfffffffeu
// run: sub_u32(0xfffffffeu, 0u) == 0xfffffffeu
// run: sub_u32(0xfffffffeu, 7u) == 0xfffffff7u
// run: sub_u32(0xfffffffeu, 0x80000000u) == 0x7ffffffeu
// run: sub_u32(0xfffffffeu, 0xfffffffeu) == 0u
// run: sub_u32(0xfffffffeu, 0x00010000u) == 0xfffefffeu
// run: sub_u32(0xfffffffeu, 1u) == 0xfffffffdu
// run: sub_u32(0x12345678u, 0u) == 0x12345678u
// run: sub_u32(0x12345678u, 7u) == 0x12345671u
// run: sub_u32(0x12345678u, 0x80000000u) == 0x92345678u
// run: sub_u32(0x12345678u, 0xfffffffeu) == 0x1234567au
// run: sub_u32(0x12345678u, 0x00010000u) == 0x12335678u
// run: sub_u32(0x12345678u, 1u) == 0x12345677u
// run: sub_u32(0xaaaaaaaau, 0u) == 0xaaaaaaaau
// run: sub_u32(0xaaaaaaaau, 7u) == 0xaaaaaaa3u
// run: sub_u32(0xaaaaaaaau, 0x80000000u) == 0x2aaaaaaau
// run: sub_u32(0xaaaaaaaau, 0xfffffffeu) == 0xaaaaaaacu
// run: sub_u32(0xaaaaaaaau, 0x00010000u) == 0xaaa9aaaau
// run: sub_u32(0xaaaaaaaau, 1u) == 0xaaaaaaa9u
// run: sub_u32(0x00010000u, 0u) == 0x00010000u
// run: sub_u32(0x00010000u, 7u) == 65529u
// run: sub_u32(0x00010000u, 0x80000000u) == 0x80010000u
// run: sub_u32(0x00010000u, 0xfffffffeu) == 0x00010002u
// run: sub_u32(0x00010000u, 0x00010000u) == 0u
// run: sub_u32(0x00010000u, 1u) == 65535u
// run: sub_u32(65535u, 0u) == 65535u
// run: sub_u32(65535u, 7u) == 65528u
// run: sub_u32(65535u, 0x80000000u) == 0x8000ffffu
// run: sub_u32(65535u, 0xfffffffeu) == 0x00010001u
// run: sub_u32(65535u, 0x00010000u) == 0xffffffffu
// run: sub_u32(65535u, 1u) == 65534u

fn sub_u32_vec2(x: vec2<u32>, y: vec2<u32>) -> vec2<u32> { return x - y; }
// run: sub_u32_vec2(vec2<u32>(0u, 1u), vec2<u32>(1u, 7u)) == vec2<u32>(0xffffffffu, 0xfffffffau)
// run: sub_u32_vec2(vec2<u32>(7u, 100u), vec2<u32>(0x80000000u, 0xffffffffu)) == vec2<u32>(0x80000007u, 101u)
// run: sub_u32_vec2(vec2<u32>(0x80000000u, 0x80000001u), vec2<u32>(0xaaaaaaaau, 65535u)) == vec2<u32>(0xd5555556u, 0x7fff0002u)
// run: sub_u32_vec2(vec2<u32>(0xfffffffeu, 0x12345678u), vec2<u32>(2u, 100u)) == vec2<u32>(0xfffffffcu, 0x12345614u)

fn sub_u32_vec3(x: vec3<u32>, y: vec3<u32>) -> vec3<u32> { return x - y; }
// run: sub_u32_vec3(vec3<u32>(0u, 1u, 2u), vec3<u32>(1u, 7u, 0x7fffffffu)) == vec3<u32>(0xffffffffu, 0xfffffffau, 0x80000003u)
// run: sub_u32_vec3(vec3<u32>(7u, 100u, 0x7fffffffu), vec3<u32>(0x80000000u, 0xffffffffu, 0x12345678u)) == vec3<u32>(0x80000007u, 101u, 0x6dcba987u)
// run: sub_u32_vec3(vec3<u32>(0x80000000u, 0x80000001u, 0xffffffffu), vec3<u32>(0xaaaaaaaau, 65535u, 1u)) == vec3<u32>(0xd5555556u, 0x7fff0002u, 0xfffffffeu)
// run: sub_u32_vec3(vec3<u32>(0xfffffffeu, 0x12345678u, 0xaaaaaaaau), vec3<u32>(2u, 100u, 0x80000000u)) == vec3<u32>(0xfffffffcu, 0x12345614u, 0x2aaaaaaau)

fn sub_u32_vec4(x: vec4<u32>, y: vec4<u32>) -> vec4<u32> { return x - y; }
// run: sub_u32_vec4(vec4<u32>(0u, 1u, 2u, 7u), vec4<u32>(1u, 7u, 0x7fffffffu, 0x80000001u)) == vec4<u32>(0xffffffffu, 0xfffffffau, 0x80000003u, 0x80000006u)
// run: sub_u32_vec4(vec4<u32>(7u, 100u, 0x7fffffffu, 0x80000000u), vec4<u32>(0x80000000u, 0xffffffffu, 0x12345678u, 0x00010000u)) == vec4<u32>(0x80000007u, 101u, 0x6dcba987u, 0x7fff0000u)
// run: sub_u32_vec4(vec4<u32>(0x80000000u, 0x80000001u, 0xffffffffu, 0xfffffffeu), vec4<u32>(0xaaaaaaaau, 65535u, 1u, 7u)) == vec4<u32>(0xd5555556u, 0x7fff0002u, 0xfffffffeu, 0xfffffff7u)
// run: sub_u32_vec4(vec4<u32>(0xfffffffeu, 0x12345678u, 0xaaaaaaaau, 0x00010000u), vec4<u32>(2u, 100u, 0x80000000u, 0xffffffffu)) == vec4<u32>(0xfffffffcu, 0x12345614u, 0x2aaaaaaau, 0x00010001u)

fn sub_u32_splat(x: vec3<u32>, y: u32) -> vec3<u32> { return x - y; }
// run: sub_u32_splat(vec3<u32>(1u, 2u, 7u), 2u) == vec3<u32>(0xffffffffu, 0u, 5u)
// run: sub_u32_splat(vec3<u32>(2u, 7u, 100u), 7u) == vec3<u32>(0xfffffffbu, 0u, 93u)
// run: sub_u32_splat(vec3<u32>(7u, 100u, 0x7fffffffu), 100u) == vec3<u32>(0xffffffa3u, 0u, 0x7fffff9bu)

fn sub_u32_left(x: u32, y: vec2<u32>) -> vec2<u32> { return x - y; }
// run: sub_u32_left(0x80000001u, vec2<u32>(7u, 100u)) == vec2<u32>(0x7ffffffau, 0x7fffff9du)

fn mul_i32(x: i32, y: i32) -> i32 { return x * y; }
// run: mul_i32(0i, 0i) == 0i
// run: mul_i32(0i, 2i) == 0i
// run: mul_i32(0i, -7i) == 0i
// run: mul_i32(0i, -2147483648i) == 0i
// run: mul_i32(0i, -305419896i) == 0i
// run: mul_i32(0i, 1i) == 0i
// run: mul_i32(1i, 0i) == 0i
// run: mul_i32(1i, 2i) == 2i
// run: mul_i32(1i, -7i) == -7i
// run: mul_i32(1i, -2147483648i) == -2147483648i
// run: mul_i32(1i, -305419896i) == -305419896i
// run: mul_i32(1i, 1i) == 1i
// run: mul_i32(-1i, 0i) == 0i
// run: mul_i32(-1i, 2i) == -2i
// run: mul_i32(-1i, -7i) == 7i
// run: mul_i32(-1i, -2147483648i) == -2147483648i
// run: mul_i32(-1i, -305419896i) == 305419896i
// run: mul_i32(-1i, 1i) == -1i
// run: mul_i32(2i, 0i) == 0i
// run: mul_i32(2i, 2i) == 4i
// run: mul_i32(2i, -7i) == -14i
// run: mul_i32(2i, -2147483648i) == 0i
// run: mul_i32(2i, -305419896i) == -610839792i
// run: mul_i32(2i, 1i) == 2i
// run: mul_i32(-2i, 0i) == 0i
// run: mul_i32(-2i, 2i) == -4i
// run: mul_i32(-2i, -7i) == 14i
// run: mul_i32(-2i, -2147483648i) == 0i
// run: mul_i32(-2i, -305419896i) == 610839792i
// run: mul_i32(-2i, 1i) == -2i
// run: mul_i32(7i, 0i) == 0i
// run: mul_i32(7i, 2i) == 14i
// run: mul_i32(7i, -7i) == -49i
// run: mul_i32(7i, -2147483648i) == -2147483648i
// run: mul_i32(7i, -305419896i) == -2137939272i
// run: mul_i32(7i, 1i) == 7i
// run: mul_i32(-7i, 0i) == 0i
// run: mul_i32(-7i, 2i) == -14i
// run: mul_i32(-7i, -7i) == 49i
// run: mul_i32(-7i, -2147483648i) == -2147483648i
// run: mul_i32(-7i, -305419896i) == 2137939272i
// run: mul_i32(-7i, 1i) == -7i
// run: mul_i32(100i, 0i) == 0i
// run: mul_i32(100i, 2i) == 200i
// run: mul_i32(100i, -7i) == -700i
// run: mul_i32(100i, -2147483648i) == 0i
// run: mul_i32(100i, -305419896i) == -477218528i
// run: mul_i32(100i, 1i) == 100i
// run: mul_i32(2147483647i, 0i) == 0i
// run: mul_i32(2147483647i, 2i) == -2i
// run: mul_i32(2147483647i, -7i) == -2147483641i
// run: mul_i32(2147483647i, -2147483648i) == -2147483648i
// run: mul_i32(2147483647i, -305419896i) == 305419896i
// run: mul_i32(2147483647i, 1i) == 2147483647i
// run: mul_i32(-2147483648i, 0i) == 0i
// run: mul_i32(-2147483648i, 2i) == 0i
// run: mul_i32(-2147483648i, -7i) == -2147483648i
// run: mul_i32(-2147483648i, -2147483648i) == 0i
// run: mul_i32(-2147483648i, -305419896i) == 0i
// run: mul_i32(-2147483648i, 1i) == -2147483648i
// run: mul_i32(-2147483647i, 0i) == 0i
// run: mul_i32(-2147483647i, 2i) == 2i
// run: mul_i32(-2147483647i, -7i) == 2147483641i
// run: mul_i32(-2147483647i, -2147483648i) == -2147483648i
// run: mul_i32(-2147483647i, -305419896i) == -305419896i
// run: mul_i32(-2147483647i, 1i) == -2147483647i
// run: mul_i32(305419896i, 0i) == 0i
// run: mul_i32(305419896i, 2i) == 610839792i
// run: mul_i32(305419896i, -7i) == -2137939272i
// run: mul_i32(305419896i, -2147483648i) == 0i
// run: mul_i32(305419896i, -305419896i) == -502585408i
// run: mul_i32(305419896i, 1i) == 305419896i
// run: mul_i32(-305419896i, 0i) == 0i
// run: mul_i32(-305419896i, 2i) == -610839792i
// run: mul_i32(-305419896i, -7i) == 2137939272i
// run: mul_i32(-305419896i, -2147483648i) == 0i
// run: mul_i32(-305419896i, -305419896i) == 502585408i
// run: mul_i32(-305419896i, 1i) == -305419896i
// run: mul_i32(1431655765i, 0i) == 0i
// run: mul_i32(1431655765i, 2i) == -1431655766i
// run: mul_i32(1431655765i, -7i) == -1431655763i
// run: mul_i32(1431655765i, -2147483648i) == -2147483648i
// run: mul_i32(1431655765i, -305419896i) == 101806632i
// run: mul_i32(1431655765i, 1i) == 1431655765i
// run: mul_i32(65536i, 0i) == 0i
// run: mul_i32(65536i, 2i) == 131072i
// run: mul_i32(65536i, -7i) == -458752i
// run: mul_i32(65536i, -2147483648i) == 0i
// run: mul_i32(65536i, -305419896i) == -1450704896i
// run: mul_i32(65536i, 1i) == 65536i

fn mul_i32_vec2(x: vec2<i32>, y: vec2<i32>) -> vec2<i32> { return x * y; }
// run: mul_i32_vec2(vec2<i32>(0i, 1i), vec2<i32>(1i, 2i)) == vec2<i32>(0i, 2i)
// run: mul_i32_vec2(vec2<i32>(2i, -2i), vec2<i32>(-7i, 2147483647i)) == vec2<i32>(-14i, 2i)
// run: mul_i32_vec2(vec2<i32>(-7i, 100i), vec2<i32>(305419896i, 1431655765i)) == vec2<i32>(-2137939272i, 1431655732i)
// run: mul_i32_vec2(vec2<i32>(-2147483648i, -2147483647i), vec2<i32>(1i, 2i)) == vec2<i32>(-2147483648i, 2i)

fn mul_i32_vec3(x: vec3<i32>, y: vec3<i32>) -> vec3<i32> { return x * y; }
// run: mul_i32_vec3(vec3<i32>(0i, 1i, -1i), vec3<i32>(1i, 2i, 7i)) == vec3<i32>(0i, 2i, -7i)
// run: mul_i32_vec3(vec3<i32>(2i, -2i, 7i), vec3<i32>(-7i, 2147483647i, -2147483647i)) == vec3<i32>(-14i, 2i, -2147483641i)
// run: mul_i32_vec3(vec3<i32>(-7i, 100i, 2147483647i), vec3<i32>(305419896i, 1431655765i, 0i)) == vec3<i32>(-2137939272i, 1431655732i, 0i)
// run: mul_i32_vec3(vec3<i32>(-2147483648i, -2147483647i, 305419896i), vec3<i32>(1i, 2i, 7i)) == vec3<i32>(-2147483648i, 2i, 2137939272i)

fn mul_i32_vec4(x: vec4<i32>, y: vec4<i32>) -> vec4<i32> { return x * y; }
// run: mul_i32_vec4(vec4<i32>(0i, 1i, -1i, 2i), vec4<i32>(1i, 2i, 7i, 100i)) == vec4<i32>(0i, 2i, -7i, 200i)
// run: mul_i32_vec4(vec4<i32>(2i, -2i, 7i, -7i), vec4<i32>(-7i, 2147483647i, -2147483647i, -305419896i)) == vec4<i32>(-14i, 2i, -2147483641i, 2137939272i)
// run: mul_i32_vec4(vec4<i32>(-7i, 100i, 2147483647i, -2147483648i), vec4<i32>(305419896i, 1431655765i, 0i, -1i)) == vec4<i32>(-2137939272i, 1431655732i, 0i, -2147483648i)
// run: mul_i32_vec4(vec4<i32>(-2147483648i, -2147483647i, 305419896i, -305419896i), vec4<i32>(1i, 2i, 7i, 100i)) == vec4<i32>(-2147483648i, 2i, 2137939272i, -477218528i)

fn mul_i32_splat(x: vec3<i32>, y: i32) -> vec3<i32> { return x * y; }
// run: mul_i32_splat(vec3<i32>(1i, -1i, 2i), -1i) == vec3<i32>(-1i, 1i, -2i)
// run: mul_i32_splat(vec3<i32>(-1i, 2i, -2i), 2i) == vec3<i32>(-2i, 4i, -4i)
// run: mul_i32_splat(vec3<i32>(2i, -2i, 7i), -2i) == vec3<i32>(-4i, 4i, -14i)

fn mul_i32_left(x: i32, y: vec2<i32>) -> vec2<i32> { return x * y; }
// run: mul_i32_left(100i, vec2<i32>(2i, -2i)) == vec2<i32>(200i, -200i)

fn mul_u32(x: u32, y: u32) -> u32 { return x * y; }
// run: mul_u32(0u, 0u) == 0u
// run: mul_u32(0u, 7u) == 0u
// run: mul_u32(0u, 0x80000000u) == 0u
// run: mul_u32(0u, 0xfffffffeu) == 0u
// run: mul_u32(0u, 0x00010000u) == 0u
// run: mul_u32(0u, 1u) == 0u
// run: mul_u32(1u, 0u) == 0u
// run: mul_u32(1u, 7u) == 7u
// run: mul_u32(1u, 0x80000000u) == 0x80000000u
// run: mul_u32(1u, 0xfffffffeu) == 0xfffffffeu
// run: mul_u32(1u, 0x00010000u) == 0x00010000u
// run: mul_u32(1u, 1u) == 1u
// run: mul_u32(2u, 0u) == 0u
// run: mul_u32(2u, 7u) == 14u
// run: mul_u32(2u, 0x80000000u) == 0u
// run: mul_u32(2u, 0xfffffffeu) == 0xfffffffcu
// run: mul_u32(2u, 0x00010000u) == 0x00020000u
// run: mul_u32(2u, 1u) == 2u
// run: mul_u32(7u, 0u) == 0u
// run: mul_u32(7u, 7u) == 49u
// run: mul_u32(7u, 0x80000000u) == 0x80000000u
// run: mul_u32(7u, 0xfffffffeu) == 0xfffffff2u
// run: mul_u32(7u, 0x00010000u) == 0x00070000u
// run: mul_u32(7u, 1u) == 7u
// run: mul_u32(100u, 0u) == 0u
// run: mul_u32(100u, 7u) == 700u
// run: mul_u32(100u, 0x80000000u) == 0u
// run: mul_u32(100u, 0xfffffffeu) == 0xffffff38u
// run: mul_u32(100u, 0x00010000u) == 0x00640000u
// run: mul_u32(100u, 1u) == 100u
// run: mul_u32(0x7fffffffu, 0u) == 0u
// run: mul_u32(0x7fffffffu, 7u) == 0x7ffffff9u
// run: mul_u32(0x7fffffffu, 0x80000000u) == 0x80000000u
// run: mul_u32(0x7fffffffu, 0xfffffffeu) == 2u
// run: mul_u32(0x7fffffffu, 0x00010000u) == 0xffff0000u
// run: mul_u32(0x7fffffffu, 1u) == 0x7fffffffu
// run: mul_u32(0x80000000u, 0u) == 0u
// run: mul_u32(0x80000000u, 7u) == 0x80000000u
// run: mul_u32(0x80000000u, 0x80000000u) == 0u
// run: mul_u32(0x80000000u, 0xfffffffeu) == 0u
// run: mul_u32(0x80000000u, 0x00010000u) == 0u
// run: mul_u32(0x80000000u, 1u) == 0x80000000u
// run: mul_u32(0x80000001u, 0u) == 0u
// run: mul_u32(0x80000001u, 7u) == 0x80000007u
// run: mul_u32(0x80000001u, 0x80000000u) == 0x80000000u
// run: mul_u32(0x80000001u, 0xfffffffeu) == 0xfffffffeu
// run: mul_u32(0x80000001u, 0x00010000u) == 0x00010000u
// run: mul_u32(0x80000001u, 1u) == 0x80000001u
// run: mul_u32(0xffffffffu, 0u) == 0u
// run: mul_u32(0xffffffffu, 7u) == 0xfffffff9u
// run: mul_u32(0xffffffffu, 0x80000000u) == 0x80000000u
// run: mul_u32(0xffffffffu, 0xfffffffeu) == 2u
// run: mul_u32(0xffffffffu, 0x00010000u) == 0xffff0000u
// run: mul_u32(0xffffffffu, 1u) == 0xffffffffu
// run: mul_u32(0xfffffffeu, 0u) == 0u
// run: mul_u32(0xfffffffeu, 7u) == 0xfffffff2u
// run: mul_u32(0xfffffffeu, 0x80000000u) == 0u
// run: mul_u32(0xfffffffeu, 0xfffffffeu) == 4u
// run: mul_u32(0xfffffffeu, 0x00010000u) == 0xfffe0000u
// run: mul_u32(0xfffffffeu, 1u) == 0xfffffffeu
// run: mul_u32(0x12345678u, 0u) == 0u
// run: mul_u32(0x12345678u, 7u) == 0x7f6e5d48u
// run: mul_u32(0x12345678u, 0x80000000u) == 0u
// run: mul_u32(0x12345678u, 0xfffffffeu) == 0xdb975310u
// run: mul_u32(0x12345678u, 0x00010000u) == 0x56780000u
// run: mul_u32(0x12345678u, 1u) == 0x12345678u
// run: mul_u32(0xaaaaaaaau, 0u) == 0u
// run: mul_u32(0xaaaaaaaau, 7u) == 0xaaaaaaa6u
// run: mul_u32(0xaaaaaaaau, 0x80000000u) == 0u
// run: mul_u32(0xaaaaaaaau, 0xfffffffeu) == 0xaaaaaaacu
// run: mul_u32(0xaaaaaaaau, 0x00010000u) == 0xaaaa0000u
// run: mul_u32(0xaaaaaaaau, 1u) == 0xaaaaaaaau
// run: mul_u32(0x00010000u, 0u) == 0u
// run: mul_u32(0x00010000u, 7u) == 0x00070000u
// run: mul_u32(0x00010000u, 0x80000000u) == 0u
// run: mul_u32(0x00010000u, 0xfffffffeu) == 0xfffe0000u
// run: mul_u32(0x00010000u, 0x00010000u) == 0u
// run: mul_u32(0x00010000u, 1u) == 0x00010000u
// run: mul_u32(65535u, 0u) == 0u
// run: mul_u32(65535u, 7u) == 0x0006fff9u
// run: mul_u32(65535u, 0x80000000u) == 0x80000000u
// run: mul_u32(65535u, 0xfffffffeu) == 0xfffe0002u
// run: mul_u32(65535u, 0x00010000u) == 0xffff0000u
// run: mul_u32(65535u, 1u) == 65535u

fn mul_u32_vec2(x: vec2<u32>, y: vec2<u32>) -> vec2<u32> { return x * y; }
// run: mul_u32_vec2(vec2<u32>(0u, 1u), vec2<u32>(1u, 7u)) == vec2<u32>(0u, 7u)
// run: mul_u32_vec2(vec2<u32>(7u, 100u), vec2<u32>(0x80000000u, 0xffffffffu)) == vec2<u32>(0x80000000u, 0xffffff9cu)
// run: mul_u32_vec2(vec2<u32>(0x80000000u, 0x80000001u), vec2<u32>(0xaaaaaaaau, 65535u)) == vec2<u32>(0u, 0x8000ffffu)
// run: mul_u32_vec2(vec2<u32>(0xfffffffeu, 0x12345678u), vec2<u32>(2u, 100u)) == vec2<u32>(0xfffffffcu, 0x1c71c6e0u)

fn mul_u32_vec3(x: vec3<u32>, y: vec3<u32>) -> vec3<u32> { return x * y; }
// run: mul_u32_vec3(vec3<u32>(0u, 1u, 2u), vec3<u32>(1u, 7u, 0x7fffffffu)) == vec3<u32>(0u, 7u, 0xfffffffeu)
// run: mul_u32_vec3(vec3<u32>(7u, 100u, 0x7fffffffu), vec3<u32>(0x80000000u, 0xffffffffu, 0x12345678u)) == vec3<u32>(0x80000000u, 0xffffff9cu, 0xedcba988u)
// run: mul_u32_vec3(vec3<u32>(0x80000000u, 0x80000001u, 0xffffffffu), vec3<u32>(0xaaaaaaaau, 65535u, 1u)) == vec3<u32>(0u, 0x8000ffffu, 0xffffffffu)
// run: mul_u32_vec3(vec3<u32>(0xfffffffeu, 0x12345678u, 0xaaaaaaaau), vec3<u32>(2u, 100u, 0x80000000u)) == vec3<u32>(0xfffffffcu, 0x1c71c6e0u, 0u)

fn mul_u32_vec4(x: vec4<u32>, y: vec4<u32>) -> vec4<u32> { return x * y; }
// run: mul_u32_vec4(vec4<u32>(0u, 1u, 2u, 7u), vec4<u32>(1u, 7u, 0x7fffffffu, 0x80000001u)) == vec4<u32>(0u, 7u, 0xfffffffeu, 0x80000007u)
// run: mul_u32_vec4(vec4<u32>(7u, 100u, 0x7fffffffu, 0x80000000u), vec4<u32>(0x80000000u, 0xffffffffu, 0x12345678u, 0x00010000u)) == vec4<u32>(0x80000000u, 0xffffff9cu, 0xedcba988u, 0u)
// run: mul_u32_vec4(vec4<u32>(0x80000000u, 0x80000001u, 0xffffffffu, 0xfffffffeu), vec4<u32>(0xaaaaaaaau, 65535u, 1u, 7u)) == vec4<u32>(0u, 0x8000ffffu, 0xffffffffu, 0xfffffff2u)
// run: mul_u32_vec4(vec4<u32>(0xfffffffeu, 0x12345678u, 0xaaaaaaaau, 0x00010000u), vec4<u32>(2u, 100u, 0x80000000u, 0xffffffffu)) == vec4<u32>(0xfffffffcu, 0x1c71c6e0u, 0u, 0xffff0000u)

fn mul_u32_splat(x: vec3<u32>, y: u32) -> vec3<u32> { return x * y; }
// run: mul_u32_splat(vec3<u32>(1u, 2u, 7u), 2u) == vec3<u32>(2u, 4u, 14u)
// run: mul_u32_splat(vec3<u32>(2u, 7u, 100u), 7u) == vec3<u32>(14u, 49u, 700u)
// run: mul_u32_splat(vec3<u32>(7u, 100u, 0x7fffffffu), 100u) == vec3<u32>(700u, 10000u, 0xffffff9cu)

fn mul_u32_left(x: u32, y: vec2<u32>) -> vec2<u32> { return x * y; }
// run: mul_u32_left(0x80000001u, vec2<u32>(7u, 100u)) == vec2<u32>(0x80000007u, 100u)
