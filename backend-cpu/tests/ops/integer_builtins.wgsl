// abs, sign, min, max, clamp, dot of integers.

fn abs_i32(x: i32) -> i32 { return abs(x); }
// run: abs_i32(0i) == 0i
// run: abs_i32(1i) == 1i
// run: abs_i32(-1i) == 1i
// run: abs_i32(2i) == 2i
// run: abs_i32(-2i) == 2i
// run: abs_i32(7i) == 7i
// run: abs_i32(-7i) == 7i
// run: abs_i32(100i) == 100i
// run: abs_i32(2147483647i) == 2147483647i
// run: abs_i32(-2147483648i) == -2147483648i
// run: abs_i32(-2147483647i) == 2147483647i
// run: abs_i32(305419896i) == 305419896i
// run: abs_i32(-305419896i) == 305419896i
// run: abs_i32(1431655765i) == 1431655765i
// run: abs_i32(65536i) == 65536i

fn min_i32(x: i32, y: i32) -> i32 { return min(x, y); }
// run: min_i32(0i, 1i) == 0i
// run: min_i32(0i, 2i) == 0i
// run: min_i32(0i, 7i) == 0i
// run: min_i32(0i, 100i) == 0i
// run: min_i32(0i, -2147483648i) == -2147483648i
// run: min_i32(0i, 305419896i) == 0i
// run: min_i32(0i, 1431655765i) == 0i
// run: min_i32(-1i, 1i) == -1i
// run: min_i32(-1i, 2i) == -1i
// run: min_i32(-1i, 7i) == -1i
// run: min_i32(-1i, 100i) == -1i
// run: min_i32(-1i, -2147483648i) == -2147483648i
// run: min_i32(-1i, 305419896i) == -1i
// run: min_i32(-1i, 1431655765i) == -1i
// run: min_i32(-2i, 1i) == -2i
// run: min_i32(-2i, 2i) == -2i
// run: min_i32(-2i, 7i) == -2i
// run: min_i32(-2i, 100i) == -2i
// run: min_i32(-2i, -2147483648i) == -2147483648i
// run: min_i32(-2i, 305419896i) == -2i
// run: min_i32(-2i, 1431655765i) == -2i
// run: min_i32(-7i, 1i) == -7i
// run: min_i32(-7i, 2i) == -7i
// run: min_i32(-7i, 7i) == -7i
// run: min_i32(-7i, 100i) == -7i
// run: min_i32(-7i, -2147483648i) == -2147483648i
// run: min_i32(-7i, 305419896i) == -7i
// run: min_i32(-7i, 1431655765i) == -7i
// run: min_i32(2147483647i, 1i) == 1i
// run: min_i32(2147483647i, 2i) == 2i
// run: min_i32(2147483647i, 7i) == 7i
// run: min_i32(2147483647i, 100i) == 100i
// run: min_i32(2147483647i, -2147483648i) == -2147483648i
// run: min_i32(2147483647i, 305419896i) == 305419896i
// run: min_i32(2147483647i, 1431655765i) == 1431655765i
// run: min_i32(-2147483647i, 1i) == -2147483647i
// run: min_i32(-2147483647i, 2i) == -2147483647i
// run: min_i32(-2147483647i, 7i) == -2147483647i
// run: min_i32(-2147483647i, 100i) == -2147483647i
// run: min_i32(-2147483647i, -2147483648i) == -2147483648i
// run: min_i32(-2147483647i, 305419896i) == -2147483647i
// run: min_i32(-2147483647i, 1431655765i) == -2147483647i
// run: min_i32(-305419896i, 1i) == -305419896i
// run: min_i32(-305419896i, 2i) == -305419896i
// run: min_i32(-305419896i, 7i) == -305419896i
// run: min_i32(-305419896i, 100i) == -305419896i
// run: min_i32(-305419896i, -2147483648i) == -2147483648i
// run: min_i32(-305419896i, 305419896i) == -305419896i
// run: min_i32(-305419896i, 1431655765i) == -305419896i
// run: min_i32(65536i, 1i) == 1i
// run: min_i32(65536i, 2i) == 2i
// run: min_i32(65536i, 7i) == 7i
// run: min_i32(65536i, 100i) == 100i
// run: min_i32(65536i, -2147483648i) == -2147483648i
// run: min_i32(65536i, 305419896i) == 65536i
// run: min_i32(65536i, 1431655765i) == 65536i

fn min_i32_vec2(x: vec2<i32>, y: vec2<i32>) -> vec2<i32> { return min(x, y); }
// run: min_i32_vec2(vec2<i32>(100i, 2147483647i), vec2<i32>(2147483647i, -2147483648i)) == vec2<i32>(100i, -2147483648i)

fn max_i32(x: i32, y: i32) -> i32 { return max(x, y); }
// run: max_i32(0i, 1i) == 1i
// run: max_i32(0i, 2i) == 2i
// run: max_i32(0i, 7i) == 7i
// run: max_i32(0i, 100i) == 100i
// run: max_i32(0i, -2147483648i) == 0i
// run: max_i32(0i, 305419896i) == 305419896i
// run: max_i32(0i, 1431655765i) == 1431655765i
// run: max_i32(-1i, 1i) == 1i
// run: max_i32(-1i, 2i) == 2i
// run: max_i32(-1i, 7i) == 7i
// run: max_i32(-1i, 100i) == 100i
// run: max_i32(-1i, -2147483648i) == -1i
// run: max_i32(-1i, 305419896i) == 305419896i
// run: max_i32(-1i, 1431655765i) == 1431655765i
// run: max_i32(-2i, 1i) == 1i
// run: max_i32(-2i, 2i) == 2i
// run: max_i32(-2i, 7i) == 7i
// run: max_i32(-2i, 100i) == 100i
// run: max_i32(-2i, -2147483648i) == -2i
// run: max_i32(-2i, 305419896i) == 305419896i
// run: max_i32(-2i, 1431655765i) == 1431655765i
// run: max_i32(-7i, 1i) == 1i
// run: max_i32(-7i, 2i) == 2i
// run: max_i32(-7i, 7i) == 7i
// run: max_i32(-7i, 100i) == 100i
// run: max_i32(-7i, -2147483648i) == -7i
// run: max_i32(-7i, 305419896i) == 305419896i
// run: max_i32(-7i, 1431655765i) == 1431655765i
// run: max_i32(2147483647i, 1i) == 2147483647i
// run: max_i32(2147483647i, 2i) == 2147483647i
// run: max_i32(2147483647i, 7i) == 2147483647i
// run: max_i32(2147483647i, 100i) == 2147483647i
// run: max_i32(2147483647i, -2147483648i) == 2147483647i
// run: max_i32(2147483647i, 305419896i) == 2147483647i
// run: max_i32(2147483647i, 1431655765i) == 2147483647i
// run: max_i32(-2147483647i, 1i) == 1i
// run: max_i32(-2147483647i, 2i) == 2i
// run: max_i32(-2147483647i, 7i) == 7i
// run: max_i32(-2147483647i, 100i) == 100i
// run: max_i32(-2147483647i, -2147483648i) == -2147483647i
// run: max_i32(-2147483647i, 305419896i) == 305419896i
// run: max_i32(-2147483647i, 1431655765i) == 1431655765i
// run: max_i32(-305419896i, 1i) == 1i
// run: max_i32(-305419896i, 2i) == 2i
// run: max_i32(-305419896i, 7i) == 7i
// run: max_i32(-305419896i, 100i) == 100i
// run: max_i32(-305419896i, -2147483648i) == -305419896i
// run: max_i32(-305419896i, 305419896i) == 305419896i
// run: max_i32(-305419896i, 1431655765i) == 1431655765i
// run: max_i32(65536i, 1i) == 65536i
// run: max_i32(65536i, 2i) == 65536i
// run: max_i32(65536i, 7i) == 65536i
// run: max_i32(65536i, 100i) == 65536i
// run: max_i32(65536i, -2147483648i) == 65536i
// run: max_i32(65536i, 305419896i) == 305419896i
// run: max_i32(65536i, 1431655765i) == 1431655765i

fn max_i32_vec2(x: vec2<i32>, y: vec2<i32>) -> vec2<i32> { return max(x, y); }
// run: max_i32_vec2(vec2<i32>(100i, 2147483647i), vec2<i32>(2147483647i, -2147483648i)) == vec2<i32>(2147483647i, 2147483647i)

fn clamp_i32(x: i32, low: i32, high: i32) -> i32 { return clamp(x, low, high); }
// run: clamp_i32(0i, 1i, -2i) == -2i
// run: clamp_i32(0i, -2i, 1i) == 0i
// run: clamp_i32(0i, 2147483647i, -2147483648i) == -2147483648i
// run: clamp_i32(-1i, 1i, -2i) == -2i
// run: clamp_i32(-1i, -2i, 1i) == -1i
// run: clamp_i32(-1i, 2147483647i, -2147483648i) == -2147483648i
// run: clamp_i32(-2i, 1i, -2i) == -2i
// run: clamp_i32(-2i, -2i, 1i) == -2i
// run: clamp_i32(-2i, 2147483647i, -2147483648i) == -2147483648i
// run: clamp_i32(-7i, 1i, -2i) == -2i
// run: clamp_i32(-7i, -2i, 1i) == -2i
// run: clamp_i32(-7i, 2147483647i, -2147483648i) == -2147483648i
// run: clamp_i32(2147483647i, 1i, -2i) == -2i
// run: clamp_i32(2147483647i, -2i, 1i) == 1i
// run: clamp_i32(2147483647i, 2147483647i, -2147483648i) == -2147483648i
// run: clamp_i32(-2147483647i, 1i, -2i) == -2i
// run: clamp_i32(-2147483647i, -2i, 1i) == -2i
// run: clamp_i32(-2147483647i, 2147483647i, -2147483648i) == -2147483648i
// run: clamp_i32(-305419896i, 1i, -2i) == -2i
// run: clamp_i32(-305419896i, -2i, 1i) == -2i
// run: clamp_i32(-305419896i, 2147483647i, -2147483648i) == -2147483648i
// run: clamp_i32(65536i, 1i, -2i) == -2i
// run: clamp_i32(65536i, -2i, 1i) == 1i
// run: clamp_i32(65536i, 2147483647i, -2147483648i) == -2147483648i

fn dot_i32_2(x: vec2<i32>, y: vec2<i32>) -> i32 { return dot(x, y); }
// run: dot_i32_2(vec2<i32>(0i, 1i), vec2<i32>(2i, -2i)) == -2i
// run: dot_i32_2(vec2<i32>(-1i, 2i), vec2<i32>(-2i, 7i)) == 16i
// run: dot_i32_2(vec2<i32>(-2i, 7i), vec2<i32>(7i, -7i)) == -63i
// run: dot_i32_2(vec2<i32>(-7i, 100i), vec2<i32>(-7i, 100i)) == 10049i

fn dot_i32_3(x: vec3<i32>, y: vec3<i32>) -> i32 { return dot(x, y); }
// run: dot_i32_3(vec3<i32>(0i, 1i, -1i), vec3<i32>(2i, -2i, 7i)) == -9i
// run: dot_i32_3(vec3<i32>(-1i, 2i, -2i), vec3<i32>(-2i, 7i, -7i)) == 30i
// run: dot_i32_3(vec3<i32>(-2i, 7i, -7i), vec3<i32>(7i, -7i, 100i)) == -763i
// run: dot_i32_3(vec3<i32>(-7i, 100i, 2147483647i), vec3<i32>(-7i, 100i, 2147483647i)) == 10050i

fn dot_i32_4(x: vec4<i32>, y: vec4<i32>) -> i32 { return dot(x, y); }
// run: dot_i32_4(vec4<i32>(0i, 1i, -1i, 2i), vec4<i32>(2i, -2i, 7i, -7i)) == -23i
// run: dot_i32_4(vec4<i32>(-1i, 2i, -2i, 7i), vec4<i32>(-2i, 7i, -7i, 100i)) == 730i
// run: dot_i32_4(vec4<i32>(-2i, 7i, -7i, 100i), vec4<i32>(7i, -7i, 100i, 2147483647i)) == -863i
// run: dot_i32_4(vec4<i32>(-7i, 100i, 2147483647i, -2147483648i), vec4<i32>(-7i, 100i, 2147483647i, -2147483648i)) == 10050i

fn abs_u32(x: u32) -> u32 { return abs(x); }
// run: abs_u32(0u) == 0u
// run: abs_u32(1u) == 1u
// run: abs_u32(2u) == 2u
// run: abs_u32(7u) == 7u
// run: abs_u32(100u) == 100u
// run: abs_u32(0x7fffffffu) == 0x7fffffffu
// run: abs_u32(0x80000000u) == 0x80000000u
// run: abs_u32(0x80000001u) == 0x80000001u
// run: abs_u32(0xffffffffu) == 0xffffffffu
// run: abs_u32(0xfffffffeu) == 0xfffffffeu
// run: abs_u32(0x12345678u) == 0x12345678u
// run: abs_u32(0xaaaaaaaau) == 0xaaaaaaaau
// run: abs_u32(0x00010000u) == 0x00010000u
// run: abs_u32(65535u) == 65535u

fn min_u32(x: u32, y: u32) -> u32 { return min(x, y); }
// run: min_u32(0u, 1u) == 0u
// run: min_u32(0u, 7u) == 0u
// run: min_u32(0u, 0x7fffffffu) == 0u
// run: min_u32(0u, 0x80000001u) == 0u
// run: min_u32(0u, 0xfffffffeu) == 0u
// run: min_u32(0u, 0xaaaaaaaau) == 0u
// run: min_u32(0u, 65535u) == 0u
// run: min_u32(2u, 1u) == 1u
// run: min_u32(2u, 7u) == 2u
// run: min_u32(2u, 0x7fffffffu) == 2u
// run: min_u32(2u, 0x80000001u) == 2u
// run: min_u32(2u, 0xfffffffeu) == 2u
// run: min_u32(2u, 0xaaaaaaaau) == 2u
// run: min_u32(2u, 65535u) == 2u
// run: min_u32(100u, 1u) == 1u
// run: min_u32(100u, 7u) == 7u
// run: min_u32(100u, 0x7fffffffu) == 100u
// run: min_u32(100u, 0x80000001u) == 100u
// run: min_u32(100u, 0xfffffffeu) == 100u
// run: min_u32(100u, 0xaaaaaaaau) == 100u
// run: min_u32(100u, 65535u) == 100u
// run: min_u32(0x80000000u, 1u) == 1u
// run: min_u32(0x80000000u, 7u) == 7u
// run: min_u32(0x80000000u, 0x7fffffffu) == 0x7fffffffu
// run: min_u32(0x80000000u, 0x80000001u) == 0x80000000u
// run: min_u32(0x80000000u, 0xfffffffeu) == 0x80000000u
// run: min_u32(0x80000000u, 0xaaaaaaaau) == 0x80000000u
// run: min_u32(0x80000000u, 65535u) == 65535u
// run: min_u32(0xffffffffu, 1u) == 1u
// run: min_u32(0xffffffffu, 7u) == 7u
// run: min_u32(0xffffffffu, 0x7fffffffu) == 0x7fffffffu
// run: min_u32(0xffffffffu, 0x80000001u) == 0x80000001u
// run: min_u32(0xffffffffu, 0xfffffffeu) == 0xfffffffeu
// run: min_u32(0xffffffffu, 0xaaaaaaaau) == 0xaaaaaaaau
// run: min_u32(0xffffffffu, 65535u) == 65535u
// run: min_u32(0x12345678u, 1u) == 1u
// run: min_u32(0x12345678u, 7u) == 7u
// run: min_u32(0x12345678u, 0x7fffffffu) == 0x12345678u
// run: min_u32(0x12345678u, 0x80000001u) == 0x12345678u
// run: min_u32(0x12345678u, 0xfffffffeu) == 0x12345678u
// run: min_u32(0x12345678u, 0xaaaaaaaau) == 0x12345678u
// run: min_u32(0x12345678u, 65535u) == 65535u
// run: min_u32(0x00010000u, 1u) == 1u
// run: min_u32(0x00010000u, 7u) == 7u
// run: min_u32(0x00010000u, 0x7fffffffu) == 0x00010000u
// run: min_u32(0x00010000u, 0x80000001u) == 0x00010000u
// run: min_u32(0x00010000u, 0xfffffffeu) == 0x00010000u
// run: min_u32(0x00010000u, 0xaaaaaaaau) == 0x00010000u
// run: min_u32(0x00010000u, 65535u) == 65535u

fn min_u32_vec2(x: vec2<u32>, y: vec2<u32>) -> vec2<u32> { return min(x, y); }
// run: min_u32_vec2(vec2<u32>(0x80000001u, 0xffffffffu), vec2<u32>(0xffffffffu, 0xfffffffeu)) == vec2<u32>(0x80000001u, 0xfffffffeu)

fn max_u32(x: u32, y: u32) -> u32 { return max(x, y); }
// run: max_u32(0u, 1u) == 1u
// run: max_u32(0u, 7u) == 7u
// run: max_u32(0u, 0x7fffffffu) == 0x7fffffffu
// run: max_u32(0u, 0x80000001u) == 0x80000001u
// run: max_u32(0u, 0xfffffffeu) == 0xfffffffeu
// run: max_u32(0u, 0xaaaaaaaau) == 0xaaaaaaaau
// run: max_u32(0u, 65535u) == 65535u
// run: max_u32(2u, 1u) == 2u
// run: max_u32(2u, 7u) == 7u
// run: max_u32(2u, 0x7fffffffu) == 0x7fffffffu
// run: max_u32(2u, 0x80000001u) == 0x80000001u
// run: max_u32(2u, 0xfffffffeu) == 0xfffffffeu
// run: max_u32(2u, 0xaaaaaaaau) == 0xaaaaaaaau
// run: max_u32(2u, 65535u) == 65535u
// run: max_u32(100u, 1u) == 100u
// run: max_u32(100u, 7u) == 100u
// run: max_u32(100u, 0x7fffffffu) == 0x7fffffffu
// run: max_u32(100u, 0x80000001u) == 0x80000001u
// run: max_u32(100u, 0xfffffffeu) == 0xfffffffeu
// run: max_u32(100u, 0xaaaaaaaau) == 0xaaaaaaaau
// run: max_u32(100u, 65535u) == 65535u
// run: max_u32(0x80000000u, 1u) == 0x80000000u
// run: max_u32(0x80000000u, 7u) == 0x80000000u
// run: max_u32(0x80000000u, 0x7fffffffu) == 0x80000000u
// run: max_u32(0x80000000u, 0x80000001u) == 0x80000001u
// run: max_u32(0x80000000u, 0xfffffffeu) == 0xfffffffeu
// run: max_u32(0x80000000u, 0xaaaaaaaau) == 0xaaaaaaaau
// run: max_u32(0x80000000u, 65535u) == 0x80000000u
// run: max_u32(0xffffffffu, 1u) == 0xffffffffu
// run: max_u32(0xffffffffu, 7u) == 0xffffffffu
// run: max_u32(0xffffffffu, 0x7fffffffu) == 0xffffffffu
// run: max_u32(0xffffffffu, 0x80000001u) == 0xffffffffu
// run: max_u32(0xffffffffu, 0xfffffffeu) == 0xffffffffu
// run: max_u32(0xffffffffu, 0xaaaaaaaau) == 0xffffffffu
// run: max_u32(0xffffffffu, 65535u) == 0xffffffffu
// run: max_u32(0x12345678u, 1u) == 0x12345678u
// run: max_u32(0x12345678u, 7u) == 0x12345678u
// run: max_u32(0x12345678u, 0x7fffffffu) == 0x7fffffffu
// run: max_u32(0x12345678u, 0x80000001u) == 0x80000001u
// run: max_u32(0x12345678u, 0xfffffffeu) == 0xfffffffeu
// run: max_u32(0x12345678u, 0xaaaaaaaau) == 0xaaaaaaaau
// run: max_u32(0x12345678u, 65535u) == 0x12345678u
// run: max_u32(0x00010000u, 1u) == 0x00010000u
// run: max_u32(0x00010000u, 7u) == 0x00010000u
// run: max_u32(0x00010000u, 0x7fffffffu) == 0x7fffffffu
// run: max_u32(0x00010000u, 0x80000001u) == 0x80000001u
// run: max_u32(0x00010000u, 0xfffffffeu) == 0xfffffffeu
// run: max_u32(0x00010000u, 0xaaaaaaaau) == 0xaaaaaaaau
// run: max_u32(0x00010000u, 65535u) == 0x00010000u

fn max_u32_vec2(x: vec2<u32>, y: vec2<u32>) -> vec2<u32> { return max(x, y); }
// run: max_u32_vec2(vec2<u32>(0x80000001u, 0xffffffffu), vec2<u32>(0xffffffffu, 0xfffffffeu)) == vec2<u32>(0xffffffffu, 0xffffffffu)

fn clamp_u32(x: u32, low: u32, high: u32) -> u32 { return clamp(x, low, high); }
// run: clamp_u32(0u, 1u, 100u) == 1u
// run: clamp_u32(0u, 100u, 1u) == 1u
// run: clamp_u32(0u, 0xffffffffu, 0xfffffffeu) == 0xfffffffeu
// run: clamp_u32(2u, 1u, 100u) == 2u
// run: clamp_u32(2u, 100u, 1u) == 1u
// run: clamp_u32(2u, 0xffffffffu, 0xfffffffeu) == 0xfffffffeu
// run: clamp_u32(100u, 1u, 100u) == 100u
// run: clamp_u32(100u, 100u, 1u) == 1u
// run: clamp_u32(100u, 0xffffffffu, 0xfffffffeu) == 0xfffffffeu
// run: clamp_u32(0x80000000u, 1u, 100u) == 100u
// run: clamp_u32(0x80000000u, 100u, 1u) == 1u
// run: clamp_u32(0x80000000u, 0xffffffffu, 0xfffffffeu) == 0xfffffffeu
// run: clamp_u32(0xffffffffu, 1u, 100u) == 100u
// run: clamp_u32(0xffffffffu, 100u, 1u) == 1u
// run: clamp_u32(0xffffffffu, 0xffffffffu, 0xfffffffeu) == 0xfffffffeu
// run: clamp_u32(0x12345678u, 1u, 100u) == 100u
// run: clamp_u32(0x12345678u, 100u, 1u) == 1u
// run: clamp_u32(0x12345678u, 0xffffffffu, 0xfffffffeu) == 0xfffffffeu
// run: clamp_u32(0x00010000u, 1u, 100u) == 100u
// run: clamp_u32(0x00010000u, 100u, 1u) == 1u
// run: clamp_u32(0x00010000u, 0xffffffffu, 0xfffffffeu) == 0xfffffffeu

fn dot_u32_2(x: vec2<u32>, y: vec2<u32>) -> u32 { return dot(x, y); }
// run: dot_u32_2(vec2<u32>(0u, 1u), vec2<u32>(7u, 100u)) == 100u
// run: dot_u32_2(vec2<u32>(2u, 7u), vec2<u32>(100u, 0x7fffffffu)) == 0x800000c1u
// run: dot_u32_2(vec2<u32>(100u, 0x7fffffffu), vec2<u32>(0x7fffffffu, 0x80000000u)) == 0x7fffff9cu
// run: dot_u32_2(vec2<u32>(0x80000000u, 0x80000001u), vec2<u32>(0x80000000u, 0x80000001u)) == 1u

fn dot_u32_3(x: vec3<u32>, y: vec3<u32>) -> u32 { return dot(x, y); }
// run: dot_u32_3(vec3<u32>(0u, 1u, 2u), vec3<u32>(7u, 100u, 0x7fffffffu)) == 98u
// run: dot_u32_3(vec3<u32>(2u, 7u, 100u), vec3<u32>(100u, 0x7fffffffu, 0x80000000u)) == 0x800000c1u
// run: dot_u32_3(vec3<u32>(100u, 0x7fffffffu, 0x80000000u), vec3<u32>(0x7fffffffu, 0x80000000u, 0x80000001u)) == 0xffffff9cu
// run: dot_u32_3(vec3<u32>(0x80000000u, 0x80000001u, 0xffffffffu), vec3<u32>(0x80000000u, 0x80000001u, 0xffffffffu)) == 2u

fn dot_u32_4(x: vec4<u32>, y: vec4<u32>) -> u32 { return dot(x, y); }
// run: dot_u32_4(vec4<u32>(0u, 1u, 2u, 7u), vec4<u32>(7u, 100u, 0x7fffffffu, 0x80000000u)) == 0x80000062u
// run: dot_u32_4(vec4<u32>(2u, 7u, 100u, 0x7fffffffu), vec4<u32>(100u, 0x7fffffffu, 0x80000000u, 0x80000001u)) == 0x800000c0u
// run: dot_u32_4(vec4<u32>(100u, 0x7fffffffu, 0x80000000u, 0x80000001u), vec4<u32>(0x7fffffffu, 0x80000000u, 0x80000001u, 0xffffffffu)) == 0x7fffff9bu
// run: dot_u32_4(vec4<u32>(0x80000000u, 0x80000001u, 0xffffffffu, 0xfffffffeu), vec4<u32>(0x80000000u, 0x80000001u, 0xffffffffu, 0xfffffffeu)) == 6u

fn sign_i32(x: i32) -> i32 { return sign(x); }
// run: sign_i32(0i) == 0i
// run: sign_i32(1i) == 1i
// run: sign_i32(-1i) == -1i
// run: sign_i32(2i) == 1i
// run: sign_i32(-2i) == -1i
// run: sign_i32(7i) == 1i
// run: sign_i32(-7i) == -1i
// run: sign_i32(100i) == 1i
// run: sign_i32(2147483647i) == 1i
// run: sign_i32(-2147483648i) == -1i
// run: sign_i32(-2147483647i) == -1i
// run: sign_i32(305419896i) == 1i
// run: sign_i32(-305419896i) == -1i
// run: sign_i32(1431655765i) == 1i
// run: sign_i32(65536i) == 1i

fn sign_vec3(x: vec3<i32>) -> vec3<i32> { return sign(x); }
// run: sign_vec3(vec3<i32>(-9i, 0i, 3i)) == vec3<i32>(-1i, 0i, 1i)

fn negate(x: i32) -> i32 { return -x; }
// run: negate(0i) == 0i
// run: negate(1i) == -1i
// run: negate(-1i) == 1i
// run: negate(2i) == -2i
// run: negate(-2i) == 2i
// run: negate(7i) == -7i
// run: negate(-7i) == 7i
// run: negate(100i) == -100i
// run: negate(2147483647i) == -2147483647i
// run: negate(-2147483648i) == -2147483648i
// run: negate(-2147483647i) == 2147483647i
// run: negate(305419896i) == -305419896i
// run: negate(-305419896i) == 305419896i
// run: negate(1431655765i) == -1431655765i
// run: negate(65536i) == -65536i

fn negate_vec2(x: vec2<i32>) -> vec2<i32> { return -x; }
// run: negate_vec2(vec2<i32>(-2147483648i, 5i)) == vec2<i32>(-2147483648i, -5i)
