// Rounding happens after every operation, in source order: nothing is fused, reassociated or simplified.

fn order_0(x: f32, y: f32, z: f32) -> f32 { return x * y + z; }
// run: order_0(1.0002441, 1.0002441, -1.0004883) == 0.0
// run: order_0(1e+08, 1.0, -1e+08) == 0.0
// run: order_0(0.1, 0.7, 0.3) == 0.37
// run: order_0(-0.0, 0.0, 0.0) == 0.0
// run: order_0(3e+38, 2.0, -3e+38) == bitcast<f32>(0x7f800000u)
// run: order_0(bitcast<f32>(0x00000003u), 0.5, bitcast<f32>(0x00000001u)) == bitcast<f32>(0x00000003u)
// run: order_0(bitcast<f32>(0x7f800000u), 1.0, 1.0) == bitcast<f32>(0x7f800000u)

fn order_1(x: f32, y: f32, z: f32) -> f32 { return z + x * y; }
// run: order_1(1.0002441, 1.0002441, -1.0004883) == 0.0
// run: order_1(1e+08, 1.0, -1e+08) == 0.0
// run: order_1(0.1, 0.7, 0.3) == 0.37
// run: order_1(-0.0, 0.0, 0.0) == 0.0
// run: order_1(3e+38, 2.0, -3e+38) == bitcast<f32>(0x7f800000u)
// run: order_1(bitcast<f32>(0x00000003u), 0.5, bitcast<f32>(0x00000001u)) == bitcast<f32>(0x00000003u)
// run: order_1(bitcast<f32>(0x7f800000u), 1.0, 1.0) == bitcast<f32>(0x7f800000u)

fn order_2(x: f32, y: f32, z: f32) -> f32 { return x * y - z; }
// run: order_2(1.0002441, 1.0002441, -1.0004883) == 2.0009766
// run: order_2(1e+08, 1.0, -1e+08) == 2e+08
// run: order_2(0.1, 0.7, 0.3) == -0.23000002
// run: order_2(-0.0, 0.0, 0.0) == -0.0
// run: order_2(3e+38, 2.0, -3e+38) == bitcast<f32>(0x7f800000u)
// run: order_2(bitcast<f32>(0x00000003u), 0.5, bitcast<f32>(0x00000001u)) == bitcast<f32>(0x00000001u)
// run: order_2(bitcast<f32>(0x7f800000u), 1.0, 1.0) == bitcast<f32>(0x7f800000u)

fn order_3(x: f32, y: f32, z: f32) -> f32 { return z - x * y; }
// run: order_3(1.0002441, 1.0002441, -1.0004883) == -2.0009766
// run: order_3(1e+08, 1.0, -1e+08) == -2e+08
// run: order_3(0.1, 0.7, 0.3) == 0.23000002
// run: order_3(-0.0, 0.0, 0.0) == 0.0
// run: order_3(3e+38, 2.0, -3e+38) == bitcast<f32>(0xff800000u)
// run: order_3(bitcast<f32>(0x00000003u), 0.5, bitcast<f32>(0x00000001u)) == bitcast<f32>(0x80000001u)
// run: order_3(bitcast<f32>(0x7f800000u), 1.0, 1.0) == bitcast<f32>(0xff800000u)

fn order_4(x: f32, y: f32, z: f32) -> f32 { return (x + y) + z; }
// run: order_4(1.0002441, 1.0002441, -1.0004883) == 1.0
// run: order_4(1e+08, 1.0, -1e+08) == 0.0
// run: order_4(0.1, 0.7, 0.3) == 1.1
// run: order_4(-0.0, 0.0, 0.0) == 0.0
// run: order_4(3e+38, 2.0, -3e+38) == 0.0
// run: order_4(bitcast<f32>(0x00000003u), 0.5, bitcast<f32>(0x00000001u)) == 0.5
// run: order_4(bitcast<f32>(0x7f800000u), 1.0, 1.0) == bitcast<f32>(0x7f800000u)

fn order_5(x: f32, y: f32, z: f32) -> f32 { return x + (y + z); }
// run: order_5(1.0002441, 1.0002441, -1.0004883) == 1.0
// run: order_5(1e+08, 1.0, -1e+08) == 0.0
// run: order_5(0.1, 0.7, 0.3) == 1.1
// run: order_5(-0.0, 0.0, 0.0) == 0.0
// run: order_5(3e+38, 2.0, -3e+38) == 0.0
// run: order_5(bitcast<f32>(0x00000003u), 0.5, bitcast<f32>(0x00000001u)) == 0.5
// run: order_5(bitcast<f32>(0x7f800000u), 1.0, 1.0) == bitcast<f32>(0x7f800000u)

fn order_6(x: f32, y: f32, z: f32) -> f32 { return (x + y) - x; }
// run: order_6(1.0002441, 1.0002441, -1.0004883) == 1.0002441
// run: order_6(1e+08, 1.0, -1e+08) == 0.0
// run: order_6(0.1, 0.7, 0.3) == 0.7
// run: order_6(-0.0, 0.0, 0.0) == 0.0
// run: order_6(3e+38, 2.0, -3e+38) == 0.0
// run: order_6(bitcast<f32>(0x00000003u), 0.5, bitcast<f32>(0x00000001u)) == 0.5
// run: order_6(bitcast<f32>(0x7f800000u), 1.0, 1.0) == nan

fn order_7(x: f32, y: f32, z: f32) -> f32 { return (x - y) + y; }
// run: order_7(1.0002441, 1.0002441, -1.0004883) == 1.0002441
// run: order_7(1e+08, 1.0, -1e+08) == 1e+08
// run: order_7(0.1, 0.7, 0.3) == 0.100000024
// run: order_7(-0.0, 0.0, 0.0) == 0.0
// run: order_7(3e+38, 2.0, -3e+38) == 3e+38
// run: order_7(bitcast<f32>(0x00000003u), 0.5, bitcast<f32>(0x00000001u)) == 0.0
// run: order_7(bitcast<f32>(0x7f800000u), 1.0, 1.0) == bitcast<f32>(0x7f800000u)

fn order_8(x: f32, y: f32, z: f32) -> f32 { return x * y / x; }
// run: order_8(1.0002441, 1.0002441, -1.0004883) == 1.0002441
// run: order_8(1e+08, 1.0, -1e+08) == 1.0
// run: order_8(0.1, 0.7, 0.3) == 0.7
// run: order_8(-0.0, 0.0, 0.0) == nan
// run: order_8(3e+38, 2.0, -3e+38) == bitcast<f32>(0x7f800000u)
// run: order_8(bitcast<f32>(0x00000003u), 0.5, bitcast<f32>(0x00000001u)) == 0.6666667
// run: order_8(bitcast<f32>(0x7f800000u), 1.0, 1.0) == nan

fn order_9(x: f32, y: f32, z: f32) -> f32 { return x / y * y; }
// run: order_9(1.0002441, 1.0002441, -1.0004883) == 1.0002441
// run: order_9(1e+08, 1.0, -1e+08) == 1e+08
// run: order_9(0.1, 0.7, 0.3) == 0.1
// run: order_9(3e+38, 2.0, -3e+38) == 3e+38
// run: order_9(bitcast<f32>(0x00000003u), 0.5, bitcast<f32>(0x00000001u)) == bitcast<f32>(0x00000003u)
// run: order_9(bitcast<f32>(0x7f800000u), 1.0, 1.0) == bitcast<f32>(0x7f800000u)

fn order_10(x: f32, y: f32, z: f32) -> f32 { return x * y * z; }
// run: order_10(1.0002441, 1.0002441, -1.0004883) == -1.0009768
// run: order_10(1e+08, 1.0, -1e+08) == -1e+16
// run: order_10(0.1, 0.7, 0.3) == 0.021000002
// run: order_10(-0.0, 0.0, 0.0) == -0.0
// run: order_10(3e+38, 2.0, -3e+38) == bitcast<f32>(0xff800000u)
// run: order_10(bitcast<f32>(0x00000003u), 0.5, bitcast<f32>(0x00000001u)) == 0.0
// run: order_10(bitcast<f32>(0x7f800000u), 1.0, 1.0) == bitcast<f32>(0x7f800000u)

fn order_11(x: f32, y: f32, z: f32) -> f32 { return x * (y * z); }
// run: order_11(1.0002441, 1.0002441, -1.0004883) == -1.0009769
// run: order_11(1e+08, 1.0, -1e+08) == -1e+16
// run: order_11(0.1, 0.7, 0.3) == 0.021000002
// run: order_11(-0.0, 0.0, 0.0) == -0.0
// run: order_11(3e+38, 2.0, -3e+38) == bitcast<f32>(0xff800000u)
// run: order_11(bitcast<f32>(0x00000003u), 0.5, bitcast<f32>(0x00000001u)) == 0.0
// run: order_11(bitcast<f32>(0x7f800000u), 1.0, 1.0) == bitcast<f32>(0x7f800000u)

fn order_12(x: f32, y: f32, z: f32) -> f32 { return x * y + x * z; }
// run: order_12(1.0002441, 1.0002441, -1.0004883) == -0.00024425983
// run: order_12(1e+08, 1.0, -1e+08) == -1e+16
// run: order_12(0.1, 0.7, 0.3) == 0.1
// run: order_12(-0.0, 0.0, 0.0) == -0.0
// run: order_12(3e+38, 2.0, -3e+38) == nan
// run: order_12(bitcast<f32>(0x00000003u), 0.5, bitcast<f32>(0x00000001u)) == bitcast<f32>(0x00000002u)
// run: order_12(bitcast<f32>(0x7f800000u), 1.0, 1.0) == bitcast<f32>(0x7f800000u)

fn order_13(x: f32, y: f32, z: f32) -> f32 { return x * (y + z); }
// run: order_13(1.0002441, 1.0002441, -1.0004883) == -0.00024420023
// run: order_13(1e+08, 1.0, -1e+08) == -1e+16
// run: order_13(0.1, 0.7, 0.3) == 0.1
// run: order_13(-0.0, 0.0, 0.0) == -0.0
// run: order_13(3e+38, 2.0, -3e+38) == bitcast<f32>(0xff800000u)
// run: order_13(bitcast<f32>(0x00000003u), 0.5, bitcast<f32>(0x00000001u)) == bitcast<f32>(0x00000002u)
// run: order_13(bitcast<f32>(0x7f800000u), 1.0, 1.0) == bitcast<f32>(0x7f800000u)

fn order_14(x: f32, y: f32, z: f32) -> f32 { return x - x; }
// run: order_14(1.0002441, 1.0002441, -1.0004883) == 0.0
// run: order_14(1e+08, 1.0, -1e+08) == 0.0
// run: order_14(0.1, 0.7, 0.3) == 0.0
// run: order_14(-0.0, 0.0, 0.0) == 0.0
// run: order_14(3e+38, 2.0, -3e+38) == 0.0
// run: order_14(bitcast<f32>(0x00000003u), 0.5, bitcast<f32>(0x00000001u)) == 0.0
// run: order_14(bitcast<f32>(0x7f800000u), 1.0, 1.0) == nan

fn order_15(x: f32, y: f32, z: f32) -> f32 { return x + 0.0; }
// run: order_15(1.0002441, 1.0002441, -1.0004883) == 1.0002441
// run: order_15(1e+08, 1.0, -1e+08) == 1e+08
// run: order_15(0.1, 0.7, 0.3) == 0.1
// run: order_15(-0.0, 0.0, 0.0) == 0.0
// run: order_15(3e+38, 2.0, -3e+38) == 3e+38
// run: order_15(bitcast<f32>(0x00000003u), 0.5, bitcast<f32>(0x00000001u)) == bitcast<f32>(0x00000003u)
// run: order_15(bitcast<f32>(0x7f800000u), 1.0, 1.0) == bitcast<f32>(0x7f800000u)

fn order_16(x: f32, y: f32, z: f32) -> f32 { return x - 0.0; }
// run: order_16(1.0002441, 1.0002441, -1.0004883) == 1.0002441
// run: order_16(1e+08, 1.0, -1e+08) == 1e+08
// run: order_16(0.1, 0.7, 0.3) == 0.1
// run: order_16(-0.0, 0.0, 0.0) == -0.0
// run: order_16(3e+38, 2.0, -3e+38) == 3e+38
// run: order_16(bitcast<f32>(0x00000003u), 0.5, bitcast<f32>(0x00000001u)) == bitcast<f32>(0x00000003u)
// run: order_16(bitcast<f32>(0x7f800000u), 1.0, 1.0) == bitcast<f32>(0x7f800000u)

fn order_17(x: f32, y: f32, z: f32) -> f32 { return 0.0 - x; }
// run: order_17(1.0002441, 1.0002441, -1.0004883) == -1.0002441
// run: order_17(1e+08, 1.0, -1e+08) == -1e+08
// run: order_17(0.1, 0.7, 0.3) == -0.1
// run: order_17(-0.0, 0.0, 0.0) == 0.0
// run: order_17(3e+38, 2.0, -3e+38) == -3e+38
// run: order_17(bitcast<f32>(0x00000003u), 0.5, bitcast<f32>(0x00000001u)) == bitcast<f32>(0x80000003u)
// run: order_17(bitcast<f32>(0x7f800000u), 1.0, 1.0) == bitcast<f32>(0xff800000u)

fn order_18(x: f32, y: f32, z: f32) -> f32 { return x * 0.0; }
// run: order_18(1.0002441, 1.0002441, -1.0004883) == 0.0
// run: order_18(1e+08, 1.0, -1e+08) == 0.0
// run: order_18(0.1, 0.7, 0.3) == 0.0
// run: order_18(-0.0, 0.0, 0.0) == -0.0
// run: order_18(3e+38, 2.0, -3e+38) == 0.0
// run: order_18(bitcast<f32>(0x00000003u), 0.5, bitcast<f32>(0x00000001u)) == 0.0
// run: order_18(bitcast<f32>(0x7f800000u), 1.0, 1.0) == nan

fn order_19(x: f32, y: f32, z: f32) -> f32 { return x * 1.0; }
// run: order_19(1.0002441, 1.0002441, -1.0004883) == 1.0002441
// run: order_19(1e+08, 1.0, -1e+08) == 1e+08
// run: order_19(0.1, 0.7, 0.3) == 0.1
// run: order_19(-0.0, 0.0, 0.0) == -0.0
// run: order_19(3e+38, 2.0, -3e+38) == 3e+38
// run: order_19(bitcast<f32>(0x00000003u), 0.5, bitcast<f32>(0x00000001u)) == bitcast<f32>(0x00000003u)
// run: order_19(bitcast<f32>(0x7f800000u), 1.0, 1.0) == bitcast<f32>(0x7f800000u)

fn order_20(x: f32, y: f32, z: f32) -> f32 { return x * -1.0; }
// run: order_20(1.0002441, 1.0002441, -1.0004883) == -1.0002441
// run: order_20(1e+08, 1.0, -1e+08) == -1e+08
// run: order_20(0.1, 0.7, 0.3) == -0.1
// run: order_20(-0.0, 0.0, 0.0) == 0.0
// run: order_20(3e+38, 2.0, -3e+38) == -3e+38
// run: order_20(bitcast<f32>(0x00000003u), 0.5, bitcast<f32>(0x00000001u)) == bitcast<f32>(0x80000003u)
// run: order_20(bitcast<f32>(0x7f800000u), 1.0, 1.0) == bitcast<f32>(0xff800000u)

fn order_21(x: f32, y: f32, z: f32) -> f32 { return x / x; }
// run: order_21(1.0002441, 1.0002441, -1.0004883) == 1.0
// run: order_21(1e+08, 1.0, -1e+08) == 1.0
// run: order_21(0.1, 0.7, 0.3) == 1.0
// run: order_21(-0.0, 0.0, 0.0) == nan
// run: order_21(3e+38, 2.0, -3e+38) == 1.0
// run: order_21(bitcast<f32>(0x00000003u), 0.5, bitcast<f32>(0x00000001u)) == 1.0
// run: order_21(bitcast<f32>(0x7f800000u), 1.0, 1.0) == nan

fn order_22(x: f32, y: f32, z: f32) -> f32 { return x / 2.0; }
// run: order_22(1.0002441, 1.0002441, -1.0004883) == 0.5001221
// run: order_22(1e+08, 1.0, -1e+08) == 5e+07
// run: order_22(0.1, 0.7, 0.3) == 0.05
// run: order_22(-0.0, 0.0, 0.0) == -0.0
// run: order_22(3e+38, 2.0, -3e+38) == 1.5e+38
// run: order_22(bitcast<f32>(0x00000003u), 0.5, bitcast<f32>(0x00000001u)) == bitcast<f32>(0x00000002u)
// run: order_22(bitcast<f32>(0x7f800000u), 1.0, 1.0) == bitcast<f32>(0x7f800000u)

fn order_23(x: f32, y: f32, z: f32) -> f32 { return x / 3.0; }
// run: order_23(1.0002441, 1.0002441, -1.0004883) == 0.3334147
// run: order_23(1e+08, 1.0, -1e+08) == 33333334.0
// run: order_23(0.1, 0.7, 0.3) == 0.033333335
// run: order_23(-0.0, 0.0, 0.0) == -0.0
// run: order_23(3e+38, 2.0, -3e+38) == 1e+38
// run: order_23(bitcast<f32>(0x00000003u), 0.5, bitcast<f32>(0x00000001u)) == bitcast<f32>(0x00000001u)
// run: order_23(bitcast<f32>(0x7f800000u), 1.0, 1.0) == bitcast<f32>(0x7f800000u)

fn order_24(x: f32, y: f32, z: f32) -> f32 { return 1.0 / x; }
// run: order_24(1.0002441, 1.0002441, -1.0004883) == 0.9997559
// run: order_24(1e+08, 1.0, -1e+08) == 1e-08
// run: order_24(0.1, 0.7, 0.3) == 1e+01
// run: order_24(-0.0, 0.0, 0.0) == bitcast<f32>(0xff800000u)
// run: order_24(3e+38, 2.0, -3e+38) == bitcast<f32>(0x00244bfau)
// run: order_24(bitcast<f32>(0x00000003u), 0.5, bitcast<f32>(0x00000001u)) == bitcast<f32>(0x7f800000u)
// run: order_24(bitcast<f32>(0x7f800000u), 1.0, 1.0) == 0.0

fn order_25(x: f32, y: f32, z: f32) -> f32 { return x + x; }
// run: order_25(1.0002441, 1.0002441, -1.0004883) == 2.0004883
// run: order_25(1e+08, 1.0, -1e+08) == 2e+08
// run: order_25(0.1, 0.7, 0.3) == 0.2
// run: order_25(-0.0, 0.0, 0.0) == -0.0
// run: order_25(3e+38, 2.0, -3e+38) == bitcast<f32>(0x7f800000u)
// run: order_25(bitcast<f32>(0x00000003u), 0.5, bitcast<f32>(0x00000001u)) == bitcast<f32>(0x00000006u)
// run: order_25(bitcast<f32>(0x7f800000u), 1.0, 1.0) == bitcast<f32>(0x7f800000u)

fn order_26(x: f32, y: f32, z: f32) -> f32 { return x * 2.0 + y; }
// run: order_26(1.0002441, 1.0002441, -1.0004883) == 3.0007324
// run: order_26(1e+08, 1.0, -1e+08) == 2e+08
// run: order_26(0.1, 0.7, 0.3) == 0.9
// run: order_26(-0.0, 0.0, 0.0) == 0.0
// run: order_26(3e+38, 2.0, -3e+38) == bitcast<f32>(0x7f800000u)
// run: order_26(bitcast<f32>(0x00000003u), 0.5, bitcast<f32>(0x00000001u)) == 0.5
// run: order_26(bitcast<f32>(0x7f800000u), 1.0, 1.0) == bitcast<f32>(0x7f800000u)

fn order_27(x: f32, y: f32, z: f32) -> f32 { return x * 3.0 + 0.1; }
// run: order_27(1.0002441, 1.0002441, -1.0004883) == 3.1007323
// run: order_27(1e+08, 1.0, -1e+08) == 3e+08
// run: order_27(0.1, 0.7, 0.3) == 0.4
// run: order_27(-0.0, 0.0, 0.0) == 0.1
// run: order_27(3e+38, 2.0, -3e+38) == bitcast<f32>(0x7f800000u)
// run: order_27(bitcast<f32>(0x00000003u), 0.5, bitcast<f32>(0x00000001u)) == 0.1
// run: order_27(bitcast<f32>(0x7f800000u), 1.0, 1.0) == bitcast<f32>(0x7f800000u)
