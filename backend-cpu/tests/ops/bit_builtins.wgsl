// Counting, searching, reversing, extracting and inserting bits.

fn countOneBits_i32(x: i32) -> i32 { return countOneBits(x); }
// run: countOneBits_i32(0i) == 0i
// run: countOneBits_i32(1i) == 1i
// run: countOneBits_i32(2i) == 1i
// run: countOneBits_i32(-2147483648i) == 1i
// run: countOneBits_i32(-1i) == 32i
// run: countOneBits_i32(-2i) == 31i
// run: countOneBits_i32(2147483647i) == 31i
// run: countOneBits_i32(65536i) == 1i
// run: countOneBits_i32(-65536i) == 16i
// run: countOneBits_i32(305419896i) == 13i
// run: countOneBits_i32(-1073741824i) == 2i
// run: countOneBits_i32(-1073741825i) == 31i

fn countOneBits_i32_vec4(x: vec4<i32>) -> vec4<i32> { return countOneBits(x); }
// run: countOneBits_i32_vec4(vec4<i32>(0i, 1i, 2i, -2147483648i)) == vec4<i32>(0i, 1i, 1i, 1i)
// run: countOneBits_i32_vec4(vec4<i32>(-1i, -2i, 2147483647i, 65536i)) == vec4<i32>(32i, 31i, 31i, 1i)
// run: countOneBits_i32_vec4(vec4<i32>(-65536i, 305419896i, -1073741824i, -1073741825i)) == vec4<i32>(16i, 13i, 2i, 31i)

fn countOneBits_u32(x: u32) -> u32 { return countOneBits(x); }
// run: countOneBits_u32(0u) == 0u
// run: countOneBits_u32(1u) == 1u
// run: countOneBits_u32(2u) == 1u
// run: countOneBits_u32(0x80000000u) == 1u
// run: countOneBits_u32(0xffffffffu) == 32u
// run: countOneBits_u32(0xfffffffeu) == 31u
// run: countOneBits_u32(0x7fffffffu) == 31u
// run: countOneBits_u32(0x00010000u) == 1u
// run: countOneBits_u32(0xffff0000u) == 16u
// run: countOneBits_u32(0x12345678u) == 13u
// run: countOneBits_u32(0xc0000000u) == 2u
// run: countOneBits_u32(0xbfffffffu) == 31u

fn countOneBits_u32_vec4(x: vec4<u32>) -> vec4<u32> { return countOneBits(x); }
// run: countOneBits_u32_vec4(vec4<u32>(0u, 1u, 2u, 0x80000000u)) == vec4<u32>(0u, 1u, 1u, 1u)
// run: countOneBits_u32_vec4(vec4<u32>(0xffffffffu, 0xfffffffeu, 0x7fffffffu, 0x00010000u)) == vec4<u32>(32u, 31u, 31u, 1u)
// run: countOneBits_u32_vec4(vec4<u32>(0xffff0000u, 0x12345678u, 0xc0000000u, 0xbfffffffu)) == vec4<u32>(16u, 13u, 2u, 31u)

fn countLeadingZeros_i32(x: i32) -> i32 { return countLeadingZeros(x); }
// run: countLeadingZeros_i32(0i) == 32i
// run: countLeadingZeros_i32(1i) == 31i
// run: countLeadingZeros_i32(2i) == 30i
// run: countLeadingZeros_i32(-2147483648i) == 0i
// run: countLeadingZeros_i32(-1i) == 0i
// run: countLeadingZeros_i32(-2i) == 0i
// run: countLeadingZeros_i32(2147483647i) == 1i
// run: countLeadingZeros_i32(65536i) == 15i
// run: countLeadingZeros_i32(-65536i) == 0i
// run: countLeadingZeros_i32(305419896i) == 3i
// run: countLeadingZeros_i32(-1073741824i) == 0i
// run: countLeadingZeros_i32(-1073741825i) == 0i

fn countLeadingZeros_i32_vec4(x: vec4<i32>) -> vec4<i32> { return countLeadingZeros(x); }
// run: countLeadingZeros_i32_vec4(vec4<i32>(0i, 1i, 2i, -2147483648i)) == vec4<i32>(32i, 31i, 30i, 0i)
// run: countLeadingZeros_i32_vec4(vec4<i32>(-1i, -2i, 2147483647i, 65536i)) == vec4<i32>(0i, 0i, 1i, 15i)
// run: countLeadingZeros_i32_vec4(vec4<i32>(-65536i, 305419896i, -1073741824i, -1073741825i)) == vec4<i32>(0i, 3i, 0i, 0i)

fn countLeadingZeros_u32(x: u32) -> u32 { return countLeadingZeros(x); }
// run: countLeadingZeros_u32(0u) == 32u
// run: countLeadingZeros_u32(1u) == 31u
// run: countLeadingZeros_u32(2u) == 30u
// run: countLeadingZeros_u32(0x80000000u) == 0u
// run: countLeadingZeros_u32(0xffffffffu) == 0u
// run: countLeadingZeros_u32(0xfffffffeu) == 0u
// run: countLeadingZeros_u32(0x7fffffffu) == 1u
// run: countLeadingZeros_u32(0x00010000u) == 15u
// run: countLeadingZeros_u32(0xffff0000u) == 0u
// run: countLeadingZeros_u32(0x12345678u) == 3u
// run: countLeadingZeros_u32(0xc0000000u) == 0u
// run: countLeadingZeros_u32(0xbfffffffu) == 0u

fn countLeadingZeros_u32_vec4(x: vec4<u32>) -> vec4<u32> { return countLeadingZeros(x); }
// run: countLeadingZeros_u32_vec4(vec4<u32>(0u, 1u, 2u, 0x80000000u)) == vec4<u32>(32u, 31u, 30u, 0u)
// run: countLeadingZeros_u32_vec4(vec4<u32>(0xffffffffu, 0xfffffffeu, 0x7fffffffu, 0x00010000u)) == vec4<u32>(0u, 0u, 1u, 15u)
// run: countLeadingZeros_u32_vec4(vec4<u32>(0xffff0000u, 0x12345678u, 0xc0000000u, 0xbfffffffu)) == vec4<u32>(0u, 3u, 0u, 0u)

fn countTrailingZeros_i32(x: i32) -> i32 { return countTrailingZeros(x); }
// run: countTrailingZeros_i32(0i) == 32i
// run: countTrailingZeros_i32(1i) == 0i
// run: countTrailingZeros_i32(2i) == 1i
// run: countTrailingZeros_i32(-2147483648i) == 31i
// run: countTrailingZeros_i32(-1i) == 0i
// run: countTrailingZeros_i32(-2i) == 1i
// run: countTrailingZeros_i32(2147483647i) == 0i
// run: countTrailingZeros_i32(65536i) == 16i
// run: countTrailingZeros_i32(-65536i) == 16i
// run: countTrailingZeros_i32(305419896i) == 3i
// run: countTrailingZeros_i32(-1073741824i) == 30i
// run: countTrailingZeros_i32(-1073741825i) == 0i

fn countTrailingZeros_i32_vec4(x: vec4<i32>) -> vec4<i32> { return countTrailingZeros(x); }
// run: countTrailingZeros_i32_vec4(vec4<i32>(0i, 1i, 2i, -2147483648i)) == vec4<i32>(32i, 0i, 1i, 31i)
// run: countTrailingZeros_i32_vec4(vec4<i32>(-1i, -2i, 2147483647i, 65536i)) == vec4<i32>(0i, 1i, 0i, 16i)
// run: countTrailingZeros_i32_vec4(vec4<i32>(-65536i, 305419896i, -1073741824i, -1073741825i)) == vec4<i32>(16i, 3i, 30i, 0i)

fn countTrailingZeros_u32(x: u32) -> u32 { return countTrailingZeros(x); }
// run: countTrailingZeros_u32(0u) == 32u
// run: countTrailingZeros_u32(1u) == 0u
// run: countTrailingZeros_u32(2u) == 1u
// run: countTrailingZeros_u32(0x80000000u) == 31u
// run: countTrailingZeros_u32(0xffffffffu) == 0u
// run: countTrailingZeros_u32(0xfffffffeu) == 1u
// run: countTrailingZeros_u32(0x7fffffffu) == 0u
// run: countTrailingZeros_u32(0x00010000u) == 16u
// run: countTrailingZeros_u32(0xffff0000u) == 16u
// run: countTrailingZeros_u32(0x12345678u) == 3u
// run: countTrailingZeros_u32(0xc0000000u) == 30u
// run: countTrailingZeros_u32(0xbfffffffu) == 0u

fn countTrailingZeros_u32_vec4(x: vec4<u32>) -> vec4<u32> { return countTrailingZeros(x); }
// run: countTrailingZeros_u32_vec4(vec4<u32>(0u, 1u, 2u, 0x80000000u)) == vec4<u32>(32u, 0u, 1u, 31u)
// run: countTrailingZeros_u32_vec4(vec4<u32>(0xffffffffu, 0xfffffffeu, 0x7fffffffu, 0x00010000u)) == vec4<u32>(0u, 1u, 0u, 16u)
// run: countTrailingZeros_u32_vec4(vec4<u32>(0xffff0000u, 0x12345678u, 0xc0000000u, 0xbfffffffu)) == vec4<u32>(16u, 3u, 30u, 0u)

fn reverseBits_i32(x: i32) -> i32 { return reverseBits(x); }
// run: reverseBits_i32(0i) == 0i
// run: reverseBits_i32(1i) == -2147483648i
// run: reverseBits_i32(2i) == 1073741824i
// run: reverseBits_i32(-2147483648i) == 1i
// run: reverseBits_i32(-1i) == -1i
// run: reverseBits_i32(-2i) == 2147483647i
// run: reverseBits_i32(2147483647i) == -2i
// run: reverseBits_i32(65536i) == 32768i
// run: reverseBits_i32(-65536i) == 65535i
// run: reverseBits_i32(305419896i) == 510274632i
// run: reverseBits_i32(-1073741824i) == 3i
// run: reverseBits_i32(-1073741825i) == -3i

fn reverseBits_i32_vec4(x: vec4<i32>) -> vec4<i32> { return reverseBits(x); }
// run: reverseBits_i32_vec4(vec4<i32>(0i, 1i, 2i, -2147483648i)) == vec4<i32>(0i, -2147483648i, 1073741824i, 1i)
// run: reverseBits_i32_vec4(vec4<i32>(-1i, -2i, 2147483647i, 65536i)) == vec4<i32>(-1i, 2147483647i, -2i, 32768i)
// run: reverseBits_i32_vec4(vec4<i32>(-65536i, 305419896i, -1073741824i, -1073741825i)) == vec4<i32>(65535i, 510274632i, 3i, -3i)

fn reverseBits_u32(x: u32) -> u32 { return reverseBits(x); }
// run: reverseBits_u32(0u) == 0u
// run: reverseBits_u32(1u) == 0x80000000u
// run: reverseBits_u32(2u) == 0x40000000u
// run: reverseBits_u32(0x80000000u) == 1u
// run: reverseBits_u32(0xffffffffu) == 0xffffffffu
// run: reverseBits_u32(0xfffffffeu) == 0x7fffffffu
// run: reverseBits_u32(0x7fffffffu) == 0xfffffffeu
// run: reverseBits_u32(0x00010000u) == 32768u
// run: reverseBits_u32(0xffff0000u) == 65535u
// run: reverseBits_u32(0x12345678u) == 0x1e6a2c48u
// run: reverseBits_u32(0xc0000000u) == 3u
// run: reverseBits_u32(0xbfffffffu) == 0xfffffffdu

fn reverseBits_u32_vec4(x: vec4<u32>) -> vec4<u32> { return reverseBits(x); }
// run: reverseBits_u32_vec4(vec4<u32>(0u, 1u, 2u, 0x80000000u)) == vec4<u32>(0u, 0x80000000u, 0x40000000u, 1u)
// run: reverseBits_u32_vec4(vec4<u32>(0xffffffffu, 0xfffffffeu, 0x7fffffffu, 0x00010000u)) == vec4<u32>(0xffffffffu, 0x7fffffffu, 0xfffffffeu, 32768u)
// run: reverseBits_u32_vec4(vec4<u32>(0xffff0000u, 0x12345678u, 0xc0000000u, 0xbfffffffu)) == vec4<u32>(65535u, 0x1e6a2c48u, 3u, 0xfffffffdu)

fn firstLeadingBit_i32(x: i32) -> i32 { return firstLeadingBit(x); }
// run: firstLeadingBit_i32(0i) == -1i
// run: firstLeadingBit_i32(1i) == 0i
// run: firstLeadingBit_i32(2i) == 1i
// run: firstLeadingBit_i32(-2147483648i) == 30i
// run: firstLeadingBit_i32(-1i) == -1i
// run: firstLeadingBit_i32(-2i) == 0i
// run: firstLeadingBit_i32(2147483647i) == 30i
// run: firstLeadingBit_i32(65536i) == 16i
// run: firstLeadingBit_i32(-65536i) == 15i
// run: firstLeadingBit_i32(305419896i) == 28i
// run: firstLeadingBit_i32(-1073741824i) == 29i
// run: firstLeadingBit_i32(-1073741825i) == 30i

fn firstLeadingBit_i32_vec4(x: vec4<i32>) -> vec4<i32> { return firstLeadingBit(x); }
// run: firstLeadingBit_i32_vec4(vec4<i32>(0i, 1i, 2i, -2147483648i)) == vec4<i32>(-1i, 0i, 1i, 30i)
// run: firstLeadingBit_i32_vec4(vec4<i32>(-1i, -2i, 2147483647i, 65536i)) == vec4<i32>(-1i, 0i, 30i, 16i)
// run: firstLeadingBit_i32_vec4(vec4<i32>(-65536i, 305419896i, -1073741824i, -1073741825i)) == vec4<i32>(15i, 28i, 29i, 30i)

fn firstLeadingBit_u32(x: u32) -> u32 { return firstLeadingBit(x); }
// run: firstLeadingBit_u32(0u) == 0xffffffffu
// run: firstLeadingBit_u32(1u) == 0u
// run: firstLeadingBit_u32(2u) == 1u
// run: firstLeadingBit_u32(0x80000000u) == 31u
// run: firstLeadingBit_u32(0xffffffffu) == 31u
// run: firstLeadingBit_u32(0xfffffffeu) == 31u
// run: firstLeadingBit_u32(0x7fffffffu) == 30u
// run: firstLeadingBit_u32(0x00010000u) == 16u
// run: firstLeadingBit_u32(0xffff0000u) == 31u
// run: firstLeadingBit_u32(0x12345678u) == 28u
// run: firstLeadingBit_u32(0xc0000000u) == 31u
// run: firstLeadingBit_u32(0xbfffffffu) == 31u

fn firstLeadingBit_u32_vec4(x: vec4<u32>) -> vec4<u32> { return firstLeadingBit(x); }
// run: firstLeadingBit_u32_vec4(vec4<u32>(0u, 1u, 2u, 0x80000000u)) == vec4<u32>(0xffffffffu, 0u, 1u, 31u)
// run: firstLeadingBit_u32_vec4(vec4<u32>(0xffffffffu, 0xfffffffeu, 0x7fffffffu, 0x00010000u)) == vec4<u32>(31u, 31u, 30u, 16u)
// run: firstLeadingBit_u32_vec4(vec4<u32>(0xffff0000u, 0x12345678u, 0xc0000000u, 0xbfffffffu)) == vec4<u32>(31u, 28u, 31u, 31u)

fn firstTrailingBit_i32(x: i32) -> i32 { return firstTrailingBit(x); }
// run: firstTrailingBit_i32(0i) == -1i
// run: firstTrailingBit_i32(1i) == 0i
// run: firstTrailingBit_i32(2i) == 1i
// run: firstTrailingBit_i32(-2147483648i) == 31i
// run: firstTrailingBit_i32(-1i) == 0i
// run: firstTrailingBit_i32(-2i) == 1i
// run: firstTrailingBit_i32(2147483647i) == 0i
// run: firstTrailingBit_i32(65536i) == 16i
// run: firstTrailingBit_i32(-65536i) == 16i
// run: firstTrailingBit_i32(305419896i) == 3i
// run: firstTrailingBit_i32(-1073741824i) == 30i
// run: firstTrailingBit_i32(-1073741825i) == 0i

fn firstTrailingBit_i32_vec4(x: vec4<i32>) -> vec4<i32> { return firstTrailingBit(x); }
// run: firstTrailingBit_i32_vec4(vec4<i32>(0i, 1i, 2i, -2147483648i)) == vec4<i32>(-1i, 0i, 1i, 31i)
// run: firstTrailingBit_i32_vec4(vec4<i32>(-1i, -2i, 2147483647i, 65536i)) == vec4<i32>(0i, 1i, 0i, 16i)
// run: firstTrailingBit_i32_vec4(vec4<i32>(-65536i, 305419896i, -1073741824i, -1073741825i)) == vec4<i32>(16i, 3i, 30i, 0i)

fn firstTrailingBit_u32(x: u32) -> u32 { return firstTrailingBit(x); }
// run: firstTrailingBit_u32(0u) == 0xffffffffu
// run: firstTrailingBit_u32(1u) == 0u
// run: firstTrailingBit_u32(2u) == 1u
// run: firstTrailingBit_u32(0x80000000u) == 31u
// run: firstTrailingBit_u32(0xffffffffu) == 0u
// run: firstTrailingBit_u32(0xfffffffeu) == 1u
// run: firstTrailingBit_u32(0x7fffffffu) == 0u
// run: firstTrailingBit_u32(0x00010000u) == 16u
// run: firstTrailingBit_u32(0xffff0000u) == 16u
// run: firstTrailingBit_u32(0x12345678u) == 3u
// run: firstTrailingBit_u32(0xc0000000u) == 30u
// run: firstTrailingBit_u32(0xbfffffffu) == 0u

fn firstTrailingBit_u32_vec4(x: vec4<u32>) -> vec4<u32> { return firstTrailingBit(x); }
// run: firstTrailingBit_u32_vec4(vec4<u32>(0u, 1u, 2u, 0x80000000u)) == vec4<u32>(0xffffffffu, 0u, 1u, 31u)
// run: firstTrailingBit_u32_vec4(vec4<u32>(0xffffffffu, 0xfffffffeu, 0x7fffffffu, 0x00010000u)) == vec4<u32>(0u, 1u, 0u, 16u)
// run: firstTrailingBit_u32_vec4(vec4<u32>(0xffff0000u, 0x12345678u, 0xc0000000u, 0xbfffffffu)) == vec4<u32>(16u, 3u, 30u, 0u)

fn extractBits_i32(e: i32, offset: u32, count: u32) -> i32 { return extractBits(e, offset, count); }
// run: extractBits_i32(-253635901i, 0u, 0u) == 0i
// run: extractBits_i32(-253635901i, 0u, 32u) == -253635901i
// run: extractBits_i32(-253635901i, 0u, 1u) == -1i
// run: extractBits_i32(-253635901i, 31u, 1u) == -1i
// run: extractBits_i32(-253635901i, 4u, 8u) == 44i
// run: extractBits_i32(-253635901i, 16u, 16u) == -3871i
// run: extractBits_i32(-253635901i, 28u, 9u) == -1i
// run: extractBits_i32(-253635901i, 32u, 0u) == 0i
// run: extractBits_i32(-253635901i, 32u, 5u) == 0i
// run: extractBits_i32(-253635901i, 40u, 40u) == 0i
// run: extractBits_i32(-253635901i, 0xffffffffu, 0xffffffffu) == 0i
// run: extractBits_i32(-253635901i, 1u, 31u) == -126817951i
// run: extractBits_i32(-253635901i, 5u, 0xffffffffu) == -7926122i
// run: extractBits_i32(-253635901i, 12u, 20u) == -61923i
// run: extractBits_i32(2147483647i, 0u, 0u) == 0i
// run: extractBits_i32(2147483647i, 0u, 32u) == 2147483647i
// run: extractBits_i32(2147483647i, 0u, 1u) == -1i
// run: extractBits_i32(2147483647i, 31u, 1u) == 0i
// run: extractBits_i32(2147483647i, 4u, 8u) == -1i
// run: extractBits_i32(2147483647i, 16u, 16u) == 32767i
// run: extractBits_i32(2147483647i, 28u, 9u) == 7i
// run: extractBits_i32(2147483647i, 32u, 0u) == 0i
// run: extractBits_i32(2147483647i, 32u, 5u) == 0i
// run: extractBits_i32(2147483647i, 40u, 40u) == 0i
// run: extractBits_i32(2147483647i, 0xffffffffu, 0xffffffffu) == 0i
// run: extractBits_i32(2147483647i, 1u, 31u) == 1073741823i
// run: extractBits_i32(2147483647i, 5u, 0xffffffffu) == 67108863i
// run: extractBits_i32(2147483647i, 12u, 20u) == 524287i

fn insertBits_i32(e: i32, bits: i32, offset: u32, count: u32) -> i32 { return insertBits(e, bits, offset, count); }
// run: insertBits_i32(-1i, 0i, 0u, 0u) == -1i
// run: insertBits_i32(-1i, 0i, 0u, 32u) == 0i
// run: insertBits_i32(-1i, 0i, 0u, 1u) == -2i
// run: insertBits_i32(-1i, 0i, 31u, 1u) == 2147483647i
// run: insertBits_i32(-1i, 0i, 4u, 8u) == -4081i
// run: insertBits_i32(-1i, 0i, 16u, 16u) == 65535i
// run: insertBits_i32(-1i, 0i, 28u, 9u) == 268435455i
// run: insertBits_i32(-1i, 0i, 32u, 0u) == -1i
// run: insertBits_i32(-1i, 0i, 32u, 5u) == -1i
// run: insertBits_i32(-1i, 0i, 40u, 40u) == -1i
// run: insertBits_i32(-1i, 0i, 0xffffffffu, 0xffffffffu) == -1i
// run: insertBits_i32(-1i, 0i, 1u, 31u) == 1i
// run: insertBits_i32(-1i, 0i, 5u, 0xffffffffu) == 31i
// run: insertBits_i32(-1i, 0i, 12u, 20u) == 4095i
// run: insertBits_i32(19088743i, -19088744i, 0u, 0u) == 19088743i
// run: insertBits_i32(19088743i, -19088744i, 0u, 32u) == -19088744i
// run: insertBits_i32(19088743i, -19088744i, 0u, 1u) == 19088742i
// run: insertBits_i32(19088743i, -19088744i, 31u, 1u) == 19088743i
// run: insertBits_i32(19088743i, -19088744i, 4u, 8u) == 19089799i
// run: insertBits_i32(19088743i, -19088744i, 16u, 16u) == -1164425881i
// run: insertBits_i32(19088743i, -19088744i, 28u, 9u) == -2128394905i
// run: insertBits_i32(19088743i, -19088744i, 32u, 0u) == 19088743i
// run: insertBits_i32(19088743i, -19088744i, 32u, 5u) == 19088743i
// run: insertBits_i32(19088743i, -19088744i, 40u, 40u) == 19088743i
// run: insertBits_i32(19088743i, -19088744i, 0xffffffffu, 0xffffffffu) == 19088743i
// run: insertBits_i32(19088743i, -19088744i, 1u, 31u) == -38177487i
// run: insertBits_i32(19088743i, -19088744i, 5u, 0xffffffffu) == -610839801i
// run: insertBits_i32(19088743i, -19088744i, 12u, 20u) == -878082713i

fn extractBits_i32_vec3(e: vec3<i32>, offset: u32, count: u32) -> vec3<i32> { return extractBits(e, offset, count); }
// run: extractBits_i32_vec3(vec3<i32>(-65536i, 305419896i, -1073741824i), 12u, 7u) == vec3<i32>(-16i, -59i, 0i)

fn insertBits_i32_vec2(e: vec2<i32>, bits: vec2<i32>, offset: u32, count: u32) -> vec2<i32> { return insertBits(e, bits, offset, count); }
// run: insertBits_i32_vec2(vec2<i32>(-65536i, 305419896i), vec2<i32>(2i, -2147483648i), 1u, 31u) == vec2<i32>(4i, 0i)

fn extractBits_u32(e: u32, offset: u32, count: u32) -> u32 { return extractBits(e, offset, count); }
// run: extractBits_u32(0xf0e1d2c3u, 0u, 0u) == 0u
// run: extractBits_u32(0xf0e1d2c3u, 0u, 32u) == 0xf0e1d2c3u
// run: extractBits_u32(0xf0e1d2c3u, 0u, 1u) == 1u
// run: extractBits_u32(0xf0e1d2c3u, 31u, 1u) == 1u
// run: extractBits_u32(0xf0e1d2c3u, 4u, 8u) == 44u
// run: extractBits_u32(0xf0e1d2c3u, 16u, 16u) == 61665u
// run: extractBits_u32(0xf0e1d2c3u, 28u, 9u) == 15u
// run: extractBits_u32(0xf0e1d2c3u, 32u, 0u) == 0u
// run: extractBits_u32(0xf0e1d2c3u, 32u, 5u) == 0u
// run: extractBits_u32(0xf0e1d2c3u, 40u, 40u) == 0u
// run: extractBits_u32(0xf0e1d2c3u, 0xffffffffu, 0xffffffffu) == 0u
// run: extractBits_u32(0xf0e1d2c3u, 1u, 31u) == 0x7870e961u
// run: extractBits_u32(0xf0e1d2c3u, 5u, 0xffffffffu) == 0x07870e96u
// run: extractBits_u32(0xf0e1d2c3u, 12u, 20u) == 0x000f0e1du
// run: extractBits_u32(0x7fffffffu, 0u, 0u) == 0u
// run: extractBits_u32(0x7fffffffu, 0u, 32u) == 0x7fffffffu
// run: extractBits_u32(0x7fffffffu, 0u, 1u) == 1u
// run: extractBits_u32(0x7fffffffu, 31u, 1u) == 0u
// run: extractBits_u32(0x7fffffffu, 4u, 8u) == 255u
// run: extractBits_u32(0x7fffffffu, 16u, 16u) == 32767u
// run: extractBits_u32(0x7fffffffu, 28u, 9u) == 7u
// run: extractBits_u32(0x7fffffffu, 32u, 0u) == 0u
// run: extractBits_u32(0x7fffffffu, 32u, 5u) == 0u
// run: extractBits_u32(0x7fffffffu, 40u, 40u) == 0u
// run: extractBits_u32(0x7fffffffu, 0xffffffffu, 0xffffffffu) == 0u
// run: extractBits_u32(0x7fffffffu, 1u, 31u) == 0x3fffffffu
// run: extractBits_u32(0x7fffffffu, 5u, 0xffffffffu) == 0x03ffffffu
// run: extractBits_u32(0x7fffffffu, 12u, 20u) == 0x0007ffffu

fn insertBits_u32(e: u32, bits: u32, offset: u32, count: u32) -> u32 { return insertBits(e, bits, offset, count); }
// run: insertBits_u32(0xffffffffu, 0u, 0u, 0u) == 0xffffffffu
// run: insertBits_u32(0xffffffffu, 0u, 0u, 32u) == 0u
// run: insertBits_u32(0xffffffffu, 0u, 0u, 1u) == 0xfffffffeu
// run: insertBits_u32(0xffffffffu, 0u, 31u, 1u) == 0x7fffffffu
// run: insertBits_u32(0xffffffffu, 0u, 4u, 8u) == 0xfffff00fu
// run: insertBits_u32(0xffffffffu, 0u, 16u, 16u) == 65535u
// run: insertBits_u32(0xffffffffu, 0u, 28u, 9u) == 0x0fffffffu
// run: insertBits_u32(0xffffffffu, 0u, 32u, 0u) == 0xffffffffu
// run: insertBits_u32(0xffffffffu, 0u, 32u, 5u) == 0xffffffffu
// run: insertBits_u32(0xffffffffu, 0u, 40u, 40u) == 0xffffffffu
// run: insertBits_u32(0xffffffffu, 0u, 0xffffffffu, 0xffffffffu) == 0xffffffffu
// run: insertBits_u32(0xffffffffu, 0u, 1u, 31u) == 1u
// run: insertBits_u32(0xffffffffu, 0u, 5u, 0xffffffffu) == 31u
// run: insertBits_u32(0xffffffffu, 0u, 12u, 20u) == 4095u
// run: insertBits_u32(0x01234567u, 0xfedcba98u, 0u, 0u) == 0x01234567u
// run: insertBits_u32(0x01234567u, 0xfedcba98u, 0u, 32u) == 0xfedcba98u
// run: insertBits_u32(0x01234567u, 0xfedcba98u, 0u, 1u) == 0x01234566u
// run: insertBits_u32(0x01234567u, 0xfedcba98u, 31u, 1u) == 0x01234567u
// run: insertBits_u32(0x01234567u, 0xfedcba98u, 4u, 8u) == 0x01234987u
// run: insertBits_u32(0x01234567u, 0xfedcba98u, 16u, 16u) == 0xba984567u
// run: insertBits_u32(0x01234567u, 0xfedcba98u, 28u, 9u) == 0x81234567u
// run: insertBits_u32(0x01234567u, 0xfedcba98u, 32u, 0u) == 0x01234567u
// run: insertBits_u32(0x01234567u, 0xfedcba98u, 32u, 5u) == 0x01234567u
// run: insertBits_u32(0x01234567u, 0xfedcba98u, 40u, 40u) == 0x01234567u
// run: insertBits_u32(0x01234567u, 0xfedcba98u, 0xffffffffu, 0xffffffffu) == 0x01234567u
// run: insertBits_u32(0x01234567u, 0xfedcba98u, 1u, 31u) == 0xfdb97531u
// run: insertBits_u32(0x01234567u, 0xfedcba98u, 5u, 0xffffffffu) == 0xdb975307u
// run: insertBits_u32(0x01234567u, 0xfedcba98u, 12u, 20u) == 0xcba98567u

fn extractBits_u32_vec3(e: vec3<u32>, offset: u32, count: u32) -> vec3<u32> { return extractBits(e, offset, count); }
// run: extractBits_u32_vec3(vec3<u32>(0xffff0000u, 0x12345678u, 0xc0000000u), 12u, 7u) == vec3<u32>(112u, 69u, 0u)

fn insertBits_u32_vec2(e: vec2<u32>, bits: vec2<u32>, offset: u32, count: u32) -> vec2<u32> { return insertBits(e, bits, offset, count); }
// run: insertBits_u32_vec2(vec2<u32>(0xffff0000u, 0x12345678u), vec2<u32>(2u, 0x80000000u), 1u, 31u) == vec2<u32>(4u, 0u)
