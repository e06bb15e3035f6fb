// Forms that an optimiser is tempted by: equal operands, neutral and absorbing constants, powers of two.

fn unsigned_0(x: u32) -> u32 { return x - x; }
// run: unsigned_0(0u) == 0u
// run: unsigned_0(7u) == 0u
// run: unsigned_0(0x80000000u) == 0u
// run: unsigned_0(0xfffffffeu) == 0u
// run: unsigned_0(0x00010000u) == 0u

fn unsigned_1(x: u32) -> u32 { return x ^ x; }
// run: unsigned_1(0u) == 0u
// run: unsigned_1(7u) == 0u
// run: unsigned_1(0x80000000u) == 0u
// run: unsigned_1(0xfffffffeu) == 0u
// run: unsigned_1(0x00010000u) == 0u

fn unsigned_2(x: u32) -> u32 { return x & x; }
// run: unsigned_2(0u) == 0u
// run: unsigned_2(7u) == 7u
// run: unsigned_2(0x80000000u) == 0x80000000u
// run: unsigned_2(0xfffffffeu) == 0xfffffffeu
// run: unsigned_2(0x00010000u) == 0x00010000u

fn unsigned_3(x: u32) -> u32 { return x | x; }
// run: unsigned_3(0u) == 0u
// run: unsigned_3(7u) == 7u
// run: unsigned_3(0x80000000u) == 0x80000000u
// run: unsigned_3(0xfffffffeu) == 0xfffffffeu
// run: unsigned_3(0x00010000u) == 0x00010000u

fn unsigned_4(x: u32) -> u32 { return x + 0u; }
// run: unsigned_4(0u) == 0u
// run: unsigned_4(7u) == 7u
// run: unsigned_4(0x80000000u) == 0x80000000u
// run: unsigned_4(0xfffffffeu) == 0xfffffffeu
// run: unsigned_4(0x00010000u) == 0x00010000u

fn unsigned_5(x: u32) -> u32 { return x * 0u; }
// run: unsigned_5(0u) == 0u
// run: unsigned_5(7u) == 0u
// run: unsigned_5(0x80000000u) == 0u
// run: unsigned_5(0xfffffffeu) == 0u
// run: unsigned_5(0x00010000u) == 0u

fn unsigned_6(x: u32) -> u32 { return x * 1u; }
// run: unsigned_6(0u) == 0u
// run: unsigned_6(7u) == 7u
// run: unsigned_6(0x80000000u) == 0x80000000u
// run: unsigned_6(0xfffffffeu) == 0xfffffffeu
// run: unsigned_6(0x00010000u) == 0x00010000u

fn unsigned_7(x: u32) -> u32 { return x * 8u; }
// run: unsigned_7(0u) == 0u
// run: unsigned_7(7u) == 56u
// run: unsigned_7(0x80000000u) == 0u
// run: unsigned_7(0xfffffffeu) == 0xfffffff0u
// run: unsigned_7(0x00010000u) == 0x00080000u

fn unsigned_8(x: u32) -> u32 { return 8u * x; }
// run: unsigned_8(0u) == 0u
// run: unsigned_8(7u) == 56u
// run: unsigned_8(0x80000000u) == 0u
// run: unsigned_8(0xfffffffeu) == 0xfffffff0u
// run: unsigned_8(0x00010000u) == 0x00080000u

fn unsigned_9(x: u32) -> u32 { return x / 1u; }
// run: unsigned_9(0u) == 0u
// run: unsigned_9(1u) == 1u
// run: unsigned_9(2u) == 2u
// run: unsigned_9(7u) == 7u
// run: unsigned_9(100u) == 100u
// run: unsigned_9(0x7fffffffu) == 0x7fffffffu
// run: unsigned_9(0x80000000u) == 0x80000000u
// run: unsigned_9(0x80000001u) == 0x80000001u
// run: unsigned_9(0xffffffffu) == 0xffffffffu
// run: unsigned_9(0xfffffffeu) == 0xfffffffeu
// run: unsigned_9(0x12345678u) == 0x12345678u
// run: unsigned_9(0xaaaaaaaau) == 0xaaaaaaaau
// run: unsigned_9(0x00010000u) == 0x00010000u
// run: unsigned_9(65535u) == 65535u

fn unsigned_10(x: u32) -> u32 { return x / 16u; }
// run: unsigned_10(0u) == 0u
// run: unsigned_10(1u) == 0u
// run: unsigned_10(2u) == 0u
// run: unsigned_10(7u) == 0u
// run: unsigned_10(100u) == 6u
// run: unsigned_10(0x7fffffffu) == 0x07ffffffu
// run: unsigned_10(0x80000000u) == 0x08000000u
// run: unsigned_10(0x80000001u) == 0x08000000u
// run: unsigned_10(0xffffffffu) == 0x0fffffffu
// run: unsigned_10(0xfffffffeu) == 0x0fffffffu
// run: unsigned_10(0x12345678u) == 0x01234567u
// run: unsigned_10(0xaaaaaaaau) == 0x0aaaaaaau
// run: unsigned_10(0x00010000u) == 4096u
// run: unsigned_10(65535u) == 4095u

fn unsigned_11(x: u32) -> u32 { return x % 16u; }
// run: unsigned_11(0u) == 0u
// run: unsigned_11(1u) == 1u
// run: unsigned_11(2u) == 2u
// run: unsigned_11(7u) == 7u
// run: unsigned_11(100u) == 4u
// run: unsigned_11(0x7fffffffu) == 15u
// run: unsigned_11(0x80000000u) == 0u
// run: unsigned_11(0x80000001u) == 1u
// run: unsigned_11(0xffffffffu) == 15u
// run: unsigned_11(0xfffffffeu) == 14u
// run: unsigned_11(0x12345678u) == 8u
// run: unsigned_11(0xaaaaaaaau) == 10u
// run: unsigned_11(0x00010000u) == 0u
// run: unsigned_11(65535u) == 15u

fn unsigned_12(x: u32) -> u32 { return x / 7u; }
// run: unsigned_12(0u) == 0u
// run: unsigned_12(1u) == 0u
// run: unsigned_12(2u) == 0u
// run: unsigned_12(7u) == 1u
// run: unsigned_12(100u) == 14u
// run: unsigned_12(0x7fffffffu) == 0x12492492u
// run: unsigned_12(0x80000000u) == 0x12492492u
// run: unsigned_12(0x80000001u) == 0x12492492u
// run: unsigned_12(0xffffffffu) == 0x24924924u
// run: unsigned_12(0xfffffffeu) == 0x24924924u
// run: unsigned_12(0x12345678u) == 0x0299c335u
// run: unsigned_12(0xaaaaaaaau) == 0x18618618u
// run: unsigned_12(0x00010000u) == 9362u
// run: unsigned_12(65535u) == 9362u

fn unsigned_13(x: u32) -> u32 { return x % 7u; }
// run: unsigned_13(0u) == 0u
// run: unsigned_13(1u) == 1u
// run: unsigned_13(2u) == 2u
// run: unsigned_13(7u) == 0u
// run: unsigned_13(100u) == 2u
// run: unsigned_13(0x7fffffffu) == 1u
// run: unsigned_13(0x80000000u) == 2u
// run: unsigned_13(0x80000001u) == 3u
// run: unsigned_13(0xffffffffu) == 3u
// run: unsigned_13(0xfffffffeu) == 2u
// run: unsigned_13(0x12345678u) == 5u
// run: unsigned_13(0xaaaaaaaau) == 2u
// run: unsigned_13(0x00010000u) == 2u
// run: unsigned_13(65535u) == 1u

fn unsigned_14(x: u32) -> u32 { return 7u / x; }
// run: unsigned_14(0u) == 7u
// run: unsigned_14(1u) == 7u
// run: unsigned_14(2u) == 3u
// run: unsigned_14(7u) == 1u
// run: unsigned_14(100u) == 0u
// run: unsigned_14(0x7fffffffu) == 0u
// run: unsigned_14(0x80000000u) == 0u
// run: unsigned_14(0x80000001u) == 0u
// run: unsigned_14(0xffffffffu) == 0u
// run: unsigned_14(0xfffffffeu) == 0u
// run: unsigned_14(0x12345678u) == 0u
// run: unsigned_14(0xaaaaaaaau) == 0u
// run: unsigned_14(0x00010000u) == 0u
// run: unsigned_14(65535u) == 0u

fn unsigned_15(x: u32) -> u32 { return x / x; }
// run: unsigned_15(0u) == 0u
// run: unsigned_15(1u) == 1u
// run: unsigned_15(2u) == 1u
// run: unsigned_15(7u) == 1u
// run: unsigned_15(100u) == 1u
// run: unsigned_15(0x7fffffffu) == 1u
// run: unsigned_15(0x80000000u) == 1u
// run: unsigned_15(0x80000001u) == 1u
// run: unsigned_15(0xffffffffu) == 1u
// run: unsigned_15(0xfffffffeu) == 1u
// run: unsigned_15(0x12345678u) == 1u
// run: unsigned_15(0xaaaaaaaau) == 1u
// run: unsigned_15(0x00010000u) == 1u
// run: unsigned_15(65535u) == 1u

fn unsigned_16(x: u32) -> u32 { return x % x; }
// run: unsigned_16(0u) == 0u
// run: unsigned_16(1u) == 0u
// run: unsigned_16(2u) == 0u
// run: unsigned_16(7u) == 0u
// run: unsigned_16(100u) == 0u
// run: unsigned_16(0x7fffffffu) == 0u
// run: unsigned_16(0x80000000u) == 0u
// run: unsigned_16(0x80000001u) == 0u
// run: unsigned_16(0xffffffffu) == 0u
// run: unsigned_16(0xfffffffeu) == 0u
// run: unsigned_16(0x12345678u) == 0u
// run: unsigned_16(0xaaaaaaaau) == 0u
// run: unsigned_16(0x00010000u) == 0u
// run: unsigned_16(65535u) == 0u

fn unsigned_17(x: u32) -> u32 { return 0u - x; }
// run: unsigned_17(0u) == 0u
// run: unsigned_17(7u) == 0xfffffff9u
// run: unsigned_17(0x80000000u) == 0x80000000u
// run: unsigned_17(0xfffffffeu) == 2u
// run: unsigned_17(0x00010000u) == 0xffff0000u

fn unsigned_18(x: u32) -> u32 { return x & 0u; }
// run: unsigned_18(0u) == 0u
// run: unsigned_18(7u) == 0u
// run: unsigned_18(0x80000000u) == 0u
// run: unsigned_18(0xfffffffeu) == 0u
// run: unsigned_18(0x00010000u) == 0u

fn unsigned_19(x: u32) -> u32 { return x | 0xffffffffu; }
// run: unsigned_19(0u) == 0xffffffffu
// run: unsigned_19(7u) == 0xffffffffu
// run: unsigned_19(0x80000000u) == 0xffffffffu
// run: unsigned_19(0xfffffffeu) == 0xffffffffu
// run: unsigned_19(0x00010000u) == 0xffffffffu

fn unsigned_20(x: u32) -> u32 { return x ^ 0xffffffffu; }
// run: unsigned_20(0u) == 0xffffffffu
// run: unsigned_20(7u) == 0xfffffff8u
// run: unsigned_20(0x80000000u) == 0x7fffffffu
// run: unsigned_20(0xfffffffeu) == 1u
// run: unsigned_20(0x00010000u) == 0xfffeffffu

fn unsigned_21(x: u32) -> u32 { return ~(~x); }
// run: unsigned_21(0u) == 0u
// run: unsigned_21(7u) == 7u
// run: unsigned_21(0x80000000u) == 0x80000000u
// run: unsigned_21(0xfffffffeu) == 0xfffffffeu
// run: unsigned_21(0x00010000u) == 0x00010000u

fn unsigned_22(x: u32) -> u32 { return x << 0u; }
// run: unsigned_22(0u) == 0u
// run: unsigned_22(7u) == 7u
// run: unsigned_22(0x80000000u) == 0x80000000u
// run: unsigned_22(0xfffffffeu) == 0xfffffffeu
// run: unsigned_22(0x00010000u) == 0x00010000u

fn unsigned_23(x: u32) -> u32 { return (x << 3u) >> 3u; }
// run: unsigned_23(0u) == 0u
// run: unsigned_23(7u) == 7u
// run: unsigned_23(0x80000000u) == 0u
// run: unsigned_23(0xfffffffeu) == 0x1ffffffeu
// run: unsigned_23(0x00010000u) == 0x00010000u

fn unsigned_24(x: u32) -> u32 { return x + x; }
// run: unsigned_24(0u) == 0u
// run: unsigned_24(7u) == 14u
// run: unsigned_24(0x80000000u) == 0u
// run: unsigned_24(0xfffffffeu) == 0xfffffffcu
// run: unsigned_24(0x00010000u) == 0x00020000u

fn unsigned_25(x: u32) -> u32 { return (x + 1u) - 1u; }
// run: unsigned_25(0u) == 0u
// run: unsigned_25(7u) == 7u
// run: unsigned_25(0x80000000u) == 0x80000000u
// run: unsigned_25(0xfffffffeu) == 0xfffffffeu
// run: unsigned_25(0x00010000u) == 0x00010000u

fn unsigned_26(x: u32) -> u32 { return x * 3u + 5u; }
// run: unsigned_26(0u) == 5u
// run: unsigned_26(7u) == 26u
// run: unsigned_26(0x80000000u) == 0x80000005u
// run: unsigned_26(0xfffffffeu) == 0xffffffffu
// run: unsigned_26(0x00010000u) == 0x00030005u

fn unsigned_27(x: u32) -> u32 { return 5u - x * 3u; }
// run: unsigned_27(0u) == 5u
// run: unsigned_27(7u) == 0xfffffff0u
// run: unsigned_27(0x80000000u) == 0x80000005u
// run: unsigned_27(0xfffffffeu) == 11u
// run: unsigned_27(0x00010000u) == 0xfffd0005u

fn unsigned_28(x: u32) -> u32 { return min(x, x); }
// run: unsigned_28(0u) == 0u
// run: unsigned_28(7u) == 7u
// run: unsigned_28(0x80000000u) == 0x80000000u
// run: unsigned_28(0xfffffffeu) == 0xfffffffeu
// run: unsigned_28(0x00010000u) == 0x00010000u

fn unsigned_29(x: u32) -> u32 { return max(x, 0u); }
// run: unsigned_29(0u) == 0u
// run: unsigned_29(7u) == 7u
// run: unsigned_29(0x80000000u) == 0x80000000u
// run: unsigned_29(0xfffffffeu) == 0xfffffffeu
// run: unsigned_29(0x00010000u) == 0x00010000u

fn unsigned_30(x: u32) -> u32 { return (x ^ (x >> 16u)) * 0x45d9f3bu; }
// run: unsigned_30(0u) == 0u
// run: unsigned_30(7u) == 0x1e8f5a9du
// run: unsigned_30(0x80000000u) == 0x4f9d8000u
// run: unsigned_30(0xfffffffeu) == 0x65229f3bu
// run: unsigned_30(0x00010000u) == 0xa3989f3bu

fn unsigned_31(x: u32) -> u32 { return x % 0x80000000u; }
// run: unsigned_31(0u) == 0u
// run: unsigned_31(1u) == 1u
// run: unsigned_31(2u) == 2u
// run: unsigned_31(7u) == 7u
// run: unsigned_31(100u) == 100u
// run: unsigned_31(0x7fffffffu) == 0x7fffffffu
// run: unsigned_31(0x80000000u) == 0u
// run: unsigned_31(0x80000001u) == 1u
// run: unsigned_31(0xffffffffu) == 0x7fffffffu
// run: unsigned_31(0xfffffffeu) == 0x7ffffffeu
// run: unsigned_31(0x12345678u) == 0x12345678u
// run: unsigned_31(0xaaaaaaaau) == 0x2aaaaaaau
// run: unsigned_31(0x00010000u) == 0x00010000u
// run: unsigned_31(65535u) == 65535u

fn unsigned_32(x: u32) -> u32 { return x / 0xffffffffu; }
// run: unsigned_32(0u) == 0u
// run: unsigned_32(1u) == 0u
// run: unsigned_32(2u) == 0u
// run: unsigned_32(7u) == 0u
// run: unsigned_32(100u) == 0u
// run: unsigned_32(0x7fffffffu) == 0u
// run: unsigned_32(0x80000000u) == 0u
// run: unsigned_32(0x80000001u) == 0u
// run: unsigned_32(0xffffffffu) == 1u
// run: unsigned_32(0xfffffffeu) == 0u
// run: unsigned_32(0x12345678u) == 0u
// run: unsigned_32(0xaaaaaaaau) == 0u
// run: unsigned_32(0x00010000u) == 0u
// run: unsigned_32(65535u) == 0u

fn unsigned_33(x: u32) -> u32 { return x - (x / 10u) * 10u; }
// run: unsigned_33(0u) == 0u
// run: unsigned_33(1u) == 1u
// run: unsigned_33(2u) == 2u
// run: unsigned_33(7u) == 7u
// run: unsigned_33(100u) == 0u
// run: unsigned_33(0x7fffffffu) == 7u
// run: unsigned_33(0x80000000u) == 8u
// run: unsigned_33(0x80000001u) == 9u
// run: unsigned_33(0xffffffffu) == 5u
// run: unsigned_33(0xfffffffeu) == 4u
// run: unsigned_33(0x12345678u) == 6u
// run: unsigned_33(0xaaaaaaaau) == 0u
// run: unsigned_33(0x00010000u) == 6u
// run: unsigned_33(65535u) == 5u

fn signed_0(x: i32) -> i32 { return x / 4; }
// run: signed_0(0i) == 0i
// run: signed_0(1i) == 0i
// run: signed_0(-1i) == 0i
// run: signed_0(2i) == 0i
// run: signed_0(-2i) == 0i
// run: signed_0(7i) == 1i
// run: signed_0(-7i) == -1i
// run: signed_0(100i) == 25i
// run: signed_0(2147483647i) == 536870911i
// run: signed_0(-2147483648i) == -536870912i
// run: signed_0(-2147483647i) == -536870911i
// run: signed_0(305419896i) == 76354974i
// run: signed_0(-305419896i) == -76354974i
// run: signed_0(1431655765i) == 357913941i
// run: signed_0(65536i) == 16384i

fn signed_1(x: i32) -> i32 { return x % 4; }
// run: signed_1(0i) == 0i
// run: signed_1(1i) == 1i
// run: signed_1(-1i) == -1i
// run: signed_1(2i) == 2i
// run: signed_1(-2i) == -2i
// run: signed_1(7i) == 3i
// run: signed_1(-7i) == -3i
// run: signed_1(100i) == 0i
// run: signed_1(2147483647i) == 3i
// run: signed_1(-2147483648i) == 0i
// run: signed_1(-2147483647i) == -3i
// run: signed_1(305419896i) == 0i
// run: signed_1(-305419896i) == 0i
// run: signed_1(1431655765i) == 1i
// run: signed_1(65536i) == 0i

fn signed_2(x: i32) -> i32 { return x / -4; }
// run: signed_2(0i) == 0i
// run: signed_2(1i) == 0i
// run: signed_2(-1i) == 0i
// run: signed_2(2i) == 0i
// run: signed_2(-2i) == 0i
// run: signed_2(7i) == -1i
// run: signed_2(-7i) == 1i
// run: signed_2(100i) == -25i
// run: signed_2(2147483647i) == -536870911i
// run: signed_2(-2147483648i) == 536870912i
// run: signed_2(-2147483647i) == 536870911i
// run: signed_2(305419896i) == -76354974i
// run: signed_2(-305419896i) == 76354974i
// run: signed_2(1431655765i) == -357913941i
// run: signed_2(65536i) == -16384i

fn signed_3(x: i32) -> i32 { return x % -4; }
// run: signed_3(0i) == 0i
// run: signed_3(1i) == 1i
// run: signed_3(-1i) == -1i
// run: signed_3(2i) == 2i
// run: signed_3(-2i) == -2i
// run: signed_3(7i) == 3i
// run: signed_3(-7i) == -3i
// run: signed_3(100i) == 0i
// run: signed_3(2147483647i) == 3i
// run: signed_3(-2147483648i) == 0i
// run: signed_3(-2147483647i) == -3i
// run: signed_3(305419896i) == 0i
// run: signed_3(-305419896i) == 0i
// run: signed_3(1431655765i) == 1i
// run: signed_3(65536i) == 0i

fn signed_4(x: i32) -> i32 { return x / -1; }
// run: signed_4(0i) == 0i
// run: signed_4(1i) == -1i
// run: signed_4(-1i) == 1i
// run: signed_4(2i) == -2i
// run: signed_4(-2i) == 2i
// run: signed_4(7i) == -7i
// run: signed_4(-7i) == 7i
// run: signed_4(100i) == -100i
// run: signed_4(2147483647i) == -2147483647i
// run: signed_4(-2147483648i) == -2147483648i
// run: signed_4(-2147483647i) == 2147483647i
// run: signed_4(305419896i) == -305419896i
// run: signed_4(-305419896i) == 305419896i
// run: signed_4(1431655765i) == -1431655765i
// run: signed_4(65536i) == -65536i

fn signed_5(x: i32) -> i32 { return x % -1; }
// run: signed_5(0i) == 0i
// run: signed_5(1i) == 0i
// run: signed_5(-1i) == 0i
// run: signed_5(2i) == 0i
// run: signed_5(-2i) == 0i
// run: signed_5(7i) == 0i
// run: signed_5(-7i) == 0i
// run: signed_5(100i) == 0i
// run: signed_5(2147483647i) == 0i
// run: signed_5(-2147483648i) == 0i
// run: signed_5(-2147483647i) == 0i
// run: signed_5(305419896i) == 0i
// run: signed_5(-305419896i) == 0i
// run: signed_5(1431655765i) == 0i
// run: signed_5(65536i) == 0i

fn signed_6(x: i32) -> i32 { return x / 7; }
// run: signed_6(0i) == 0i
// run: signed_6(1i) == 0i
// run: signed_6(-1i) == 0i
// run: signed_6(2i) == 0i
// run: signed_6(-2i) == 0i
// run: signed_6(7i) == 1i
// run: signed_6(-7i) == -1i
// run: signed_6(100i) == 14i
// run: signed_6(2147483647i) == 306783378i
// run: signed_6(-2147483648i) == -306783378i
// run: signed_6(-2147483647i) == -306783378i
// run: signed_6(305419896i) == 43631413i
// run: signed_6(-305419896i) == -43631413i
// run: signed_6(1431655765i) == 204522252i
// run: signed_6(65536i) == 9362i

fn signed_7(x: i32) -> i32 { return x % 7; }
// run: signed_7(0i) == 0i
// run: signed_7(1i) == 1i
// run: signed_7(-1i) == -1i
// run: signed_7(2i) == 2i
// run: signed_7(-2i) == -2i
// run: signed_7(7i) == 0i
// run: signed_7(-7i) == 0i
// run: signed_7(100i) == 2i
// run: signed_7(2147483647i) == 1i
// run: signed_7(-2147483648i) == -2i
// run: signed_7(-2147483647i) == -1i
// run: signed_7(305419896i) == 5i
// run: signed_7(-305419896i) == -5i
// run: signed_7(1431655765i) == 1i
// run: signed_7(65536i) == 2i

fn signed_8(x: i32) -> i32 { return -x; }
// run: signed_8(0i) == 0i
// run: signed_8(1i) == -1i
// run: signed_8(-1i) == 1i
// run: signed_8(2i) == -2i
// run: signed_8(-2i) == 2i
// run: signed_8(7i) == -7i
// run: signed_8(-7i) == 7i
// run: signed_8(100i) == -100i
// run: signed_8(2147483647i) == -2147483647i
// run: signed_8(-2147483648i) == -2147483648i
// run: signed_8(-2147483647i) == 2147483647i
// run: signed_8(305419896i) == -305419896i
// run: signed_8(-305419896i) == 305419896i
// run: signed_8(1431655765i) == -1431655765i
// run: signed_8(65536i) == -65536i

fn signed_9(x: i32) -> i32 { return -(-x); }
// run: signed_9(0i) == 0i
// run: signed_9(1i) == 1i
// run: signed_9(-1i) == -1i
// run: signed_9(2i) == 2i
// run: signed_9(-2i) == -2i
// run: signed_9(7i) == 7i
// run: signed_9(-7i) == -7i
// run: signed_9(100i) == 100i
// run: signed_9(2147483647i) == 2147483647i
// run: signed_9(-2147483648i) == -2147483648i
// run: signed_9(-2147483647i) == -2147483647i
// run: signed_9(305419896i) == 305419896i
// run: signed_9(-305419896i) == -305419896i
// run: signed_9(1431655765i) == 1431655765i
// run: signed_9(65536i) == 65536i

fn signed_10(x: i32) -> i32 { return x * -1; }
// run: signed_10(0i) == 0i
// run: signed_10(1i) == -1i
// run: signed_10(-1i) == 1i
// run: signed_10(2i) == -2i
// run: signed_10(-2i) == 2i
// run: signed_10(7i) == -7i
// run: signed_10(-7i) == 7i
// run: signed_10(100i) == -100i
// run: signed_10(2147483647i) == -2147483647i
// run: signed_10(-2147483648i) == -2147483648i
// run: signed_10(-2147483647i) == 2147483647i
// run: signed_10(305419896i) == -305419896i
// run: signed_10(-305419896i) == 305419896i
// run: signed_10(1431655765i) == -1431655765i
// run: signed_10(65536i) == -65536i

fn signed_11(x: i32) -> i32 { return (-8) / x; }
// run: signed_11(0i) == -8i
// run: signed_11(1i) == -8i
// run: signed_11(-1i) == 8i
// run: signed_11(2i) == -4i
// run: signed_11(-2i) == 4i
// run: signed_11(7i) == -1i
// run: signed_11(-7i) == 1i
// run: signed_11(100i) == 0i
// run: signed_11(2147483647i) == 0i
// run: signed_11(-2147483648i) == 0i
// run: signed_11(-2147483647i) == 0i
// run: signed_11(305419896i) == 0i
// run: signed_11(-305419896i) == 0i
// run: signed_11(1431655765i) == 0i
// run: signed_11(65536i) == 0i

fn signed_12(x: i32) -> i32 { return x / x; }
// run: signed_12(0i) == 0i
// run: signed_12(1i) == 1i
// run: signed_12(-1i) == 1i
// run: signed_12(2i) == 1i
// run: signed_12(-2i) == 1i
// run: signed_12(7i) == 1i
// run: signed_12(-7i) == 1i
// run: signed_12(100i) == 1i
// run: signed_12(2147483647i) == 1i
// run: signed_12(-2147483648i) == 1i
// run: signed_12(-2147483647i) == 1i
// run: signed_12(305419896i) == 1i
// run: signed_12(-305419896i) == 1i
// run: signed_12(1431655765i) == 1i
// run: signed_12(65536i) == 1i

fn signed_13(x: i32) -> i32 { return x - x; }
// run: signed_13(0i) == 0i
// run: signed_13(1i) == 0i
// run: signed_13(-1i) == 0i
// run: signed_13(2i) == 0i
// run: signed_13(-2i) == 0i
// run: signed_13(7i) == 0i
// run: signed_13(-7i) == 0i
// run: signed_13(100i) == 0i
// run: signed_13(2147483647i) == 0i
// run: signed_13(-2147483648i) == 0i
// run: signed_13(-2147483647i) == 0i
// run: signed_13(305419896i) == 0i
// run: signed_13(-305419896i) == 0i
// run: signed_13(1431655765i) == 0i
// run: signed_13(65536i) == 0i

fn signed_14(x: i32) -> i32 { return x >> 1u; }
// run: signed_14(0i) == 0i
// run: signed_14(1i) == 0i
// run: signed_14(-1i) == -1i
// run: signed_14(2i) == 1i
// run: signed_14(-2i) == -1i
// run: signed_14(7i) == 3i
// run: signed_14(-7i) == -4i
// run: signed_14(100i) == 50i
// run: signed_14(2147483647i) == 1073741823i
// run: signed_14(-2147483648i) == -1073741824i
// run: signed_14(-2147483647i) == -1073741824i
// run: signed_14(305419896i) == 152709948i
// run: signed_14(-305419896i) == -152709948i
// run: signed_14(1431655765i) == 715827882i
// run: signed_14(65536i) == 32768i

fn signed_15(x: i32) -> i32 { return (x << 4u) >> 4u; }
// run: signed_15(0i) == 0i
// run: signed_15(1i) == 1i
// run: signed_15(-1i) == -1i
// run: signed_15(2i) == 2i
// run: signed_15(-2i) == -2i
// run: signed_15(7i) == 7i
// run: signed_15(-7i) == -7i
// run: signed_15(100i) == 100i
// run: signed_15(2147483647i) == -1i
// run: signed_15(-2147483648i) == 0i
// run: signed_15(-2147483647i) == 1i
// run: signed_15(305419896i) == 36984440i
// run: signed_15(-305419896i) == -36984440i
// run: signed_15(1431655765i) == 89478485i
// run: signed_15(65536i) == 65536i

fn signed_16(x: i32) -> i32 { return abs(-x); }
// run: signed_16(0i) == 0i
// run: signed_16(1i) == 1i
// run: signed_16(-1i) == 1i
// run: signed_16(2i) == 2i
// run: signed_16(-2i) == 2i
// run: signed_16(7i) == 7i
// run: signed_16(-7i) == 7i
// run: signed_16(100i) == 100i
// run: signed_16(2147483647i) == 2147483647i
// run: signed_16(-2147483648i) == -2147483648i
// run: signed_16(-2147483647i) == 2147483647i
// run: signed_16(305419896i) == 305419896i
// run: signed_16(-305419896i) == 305419896i
// run: signed_16(1431655765i) == 1431655765i
// run: signed_16(65536i) == 65536i

fn signed_17(x: i32) -> i32 { return x / i32(-2147483647 - 1); }
// run: signed_17(0i) == 0i
// run: signed_17(1i) == 0i
// run: signed_17(-1i) == 0i
// run: signed_17(2i) == 0i
// run: signed_17(-2i) == 0i
// run: signed_17(7i) == 0i
// run: signed_17(-7i) == 0i
// run: signed_17(100i) == 0i
// run: signed_17(2147483647i) == 0i
// run: signed_17(-2147483648i) == 1i
// run: signed_17(-2147483647i) == 0i
// run: signed_17(305419896i) == 0i
// run: signed_17(-305419896i) == 0i
// run: signed_17(1431655765i) == 0i
// run: signed_17(65536i) == 0i

fn signed_18(x: i32) -> i32 { return x % i32(-2147483647 - 1); }
// run: signed_18(0i) == 0i
// run: signed_18(1i) == 1i
// run: signed_18(-1i) == -1i
// run: signed_18(2i) == 2i
// run: signed_18(-2i) == -2i
// run: signed_18(7i) == 7i
// run: signed_18(-7i) == -7i
// run: signed_18(100i) == 100i
// run: signed_18(2147483647i) == 2147483647i
// run: signed_18(-2147483648i) == 0i
// run: signed_18(-2147483647i) == -2147483647i
// run: signed_18(305419896i) == 305419896i
// run: signed_18(-305419896i) == -305419896i
// run: signed_18(1431655765i) == 1431655765i
// run: signed_18(65536i) == 65536i
