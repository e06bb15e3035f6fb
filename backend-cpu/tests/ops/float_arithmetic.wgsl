// Sum, difference, product and quotient: IEEE 754 binary32, to nearest even, subnormals kept.

fn add(x: f32, y: f32) -> f32 { return x + y; }
// run: add(0.0, 0.0) == 0.0
// run: add(0.0, 0.1) == 0.1
// run: add(0.0, 1.677722e+07) == 1.677722e+07
// run: add(0.0, bitcast<f32>(0x00800000u)) == bitcast<f32>(0x00800000u)
// run: add(0.0, bitcast<f32>(0x7fc00000u)) == nan
// run: add(0.0, -7.25) == -7.25
// run: add(-0.0, -0.0) == -0.0
// run: add(-0.0, -1.0) == -1.0
// run: add(-0.0, 16777216.0) == 16777216.0
// run: add(-0.0, bitcast<f32>(0x007fffffu)) == bitcast<f32>(0x007fffffu)
// run: add(-0.0, bitcast<f32>(0xff800000u)) == bitcast<f32>(0xff800000u)
// run: add(-0.0, 1e+20) == 1e+20
// run: add(1.0, 1.0) == 2.0
// run: add(1.0, 3.0) == 4.0
// run: add(1.0, bitcast<f32>(0x00000001u)) == 1.0
// run: add(1.0, bitcast<f32>(0x7f800000u)) == bitcast<f32>(0x7f800000u)
// run: add(1.0, 0.99999994) == 2.0
// run: add(-1.0, -0.0) == -1.0
// run: add(-1.0, -1.0) == -2.0
// run: add(-1.0, -0.3) == -1.3
// run: add(-1.0, bitcast<f32>(0x006ce3eeu)) == -1.0
// run: add(-1.0, 3.4028235e+38) == 3.4028235e+38
// run: add(-1.0, 1.0000001) == 1.1920929e-07
// run: add(0.1, 0.0) == 0.1
// run: add(0.1, 0.1) == 0.2
// run: add(0.1, 1.677722e+07) == 1.677722e+07
// run: add(0.1, bitcast<f32>(0x00800000u)) == 0.1
// run: add(0.1, bitcast<f32>(0x7fc00000u)) == nan
// run: add(0.1, -7.25) == -7.15
// run: add(-0.3, -1.0) == -1.3
// run: add(-0.3, -0.3) == -0.6
// run: add(-0.3, 16777216.0) == 16777216.0
// run: add(-0.3, bitcast<f32>(0x007fffffu)) == -0.3
// run: add(-0.3, bitcast<f32>(0xff800000u)) == bitcast<f32>(0xff800000u)
// run: add(-0.3, 1e+20) == 1e+20
// run: add(3.0, 1.0) == 4.0
// run: add(3.0, 3.0) == 6.0
// run: add(3.0, bitcast<f32>(0x00000001u)) == 3.0
// run: add(3.0, bitcast<f32>(0x7f800000u)) == bitcast<f32>(0x7f800000u)
// run: add(3.0, 0.99999994) == 4.0
// run: add(16777216.0, -0.0) == 16777216.0
// run: add(16777216.0, -0.3) == 16777216.0
// run: add(16777216.0, 16777216.0) == 33554432.0
// run: add(16777216.0, bitcast<f32>(0x006ce3eeu)) == 16777216.0
// run: add(16777216.0, 3.4028235e+38) == 3.4028235e+38
// run: add(16777216.0, 1.0000001) == 16777218.0
// run: add(1.677722e+07, 0.0) == 1.677722e+07
// run: add(1.677722e+07, 0.1) == 1.677722e+07
// run: add(1.677722e+07, 1.677722e+07) == 3.355444e+07
// run: add(1.677722e+07, bitcast<f32>(0x00800000u)) == 1.677722e+07
// run: add(1.677722e+07, bitcast<f32>(0x7fc00000u)) == nan
// run: add(1.677722e+07, -7.25) == 16777213.0
// run: add(bitcast<f32>(0x006ce3eeu), -1.0) == -1.0
// run: add(bitcast<f32>(0x006ce3eeu), 16777216.0) == 16777216.0
// run: add(bitcast<f32>(0x006ce3eeu), bitcast<f32>(0x006ce3eeu)) == bitcast<f32>(0x00d9c7dcu)
// run: add(bitcast<f32>(0x006ce3eeu), bitcast<f32>(0x007fffffu)) == bitcast<f32>(0x00ece3edu)
// run: add(bitcast<f32>(0x006ce3eeu), bitcast<f32>(0xff800000u)) == bitcast<f32>(0xff800000u)
// run: add(bitcast<f32>(0x006ce3eeu), 1e+20) == 1e+20
// run: add(bitcast<f32>(0x00000001u), 1.0) == 1.0
// run: add(bitcast<f32>(0x00000001u), 3.0) == 3.0
// run: add(bitcast<f32>(0x00000001u), bitcast<f32>(0x00000001u)) == bitcast<f32>(0x00000002u)
// run: add(bitcast<f32>(0x00000001u), bitcast<f32>(0x7f800000u)) == bitcast<f32>(0x7f800000u)
// run: add(bitcast<f32>(0x00000001u), 0.99999994) == 0.99999994
// run: add(bitcast<f32>(0x007fffffu), -0.0) == bitcast<f32>(0x007fffffu)
// run: add(bitcast<f32>(0x007fffffu), -0.3) == -0.3
// run: add(bitcast<f32>(0x007fffffu), bitcast<f32>(0x006ce3eeu)) == bitcast<f32>(0x00ece3edu)
// run: add(bitcast<f32>(0x007fffffu), bitcast<f32>(0x007fffffu)) == bitcast<f32>(0x00fffffeu)
// run: add(bitcast<f32>(0x007fffffu), 3.4028235e+38) == 3.4028235e+38
// run: add(bitcast<f32>(0x007fffffu), 1.0000001) == 1.0000001
// run: add(bitcast<f32>(0x00800000u), 0.0) == bitcast<f32>(0x00800000u)
// run: add(bitcast<f32>(0x00800000u), 0.1) == 0.1
// run: add(bitcast<f32>(0x00800000u), 1.677722e+07) == 1.677722e+07
// run: add(bitcast<f32>(0x00800000u), bitcast<f32>(0x00800000u)) == bitcast<f32>(0x01000000u)
// run: add(bitcast<f32>(0x00800000u), bitcast<f32>(0x7fc00000u)) == nan
// run: add(bitcast<f32>(0x00800000u), -7.25) == -7.25
// run: add(3.4028235e+38, -1.0) == 3.4028235e+38
// run: add(3.4028235e+38, 16777216.0) == 3.4028235e+38
// run: add(3.4028235e+38, bitcast<f32>(0x007fffffu)) == 3.4028235e+38
// run: add(3.4028235e+38, 3.4028235e+38) == bitcast<f32>(0x7f800000u)
// run: add(3.4028235e+38, bitcast<f32>(0xff800000u)) == bitcast<f32>(0xff800000u)
// run: add(3.4028235e+38, 1e+20) == 3.4028235e+38
// run: add(bitcast<f32>(0x7f800000u), 1.0) == bitcast<f32>(0x7f800000u)
// run: add(bitcast<f32>(0x7f800000u), 3.0) == bitcast<f32>(0x7f800000u)
// run: add(bitcast<f32>(0x7f800000u), bitcast<f32>(0x00000001u)) == bitcast<f32>(0x7f800000u)
// run: add(bitcast<f32>(0x7f800000u), bitcast<f32>(0x7f800000u)) == bitcast<f32>(0x7f800000u)
// run: add(bitcast<f32>(0x7f800000u), 0.99999994) == bitcast<f32>(0x7f800000u)
// run: add(bitcast<f32>(0xff800000u), -0.0) == bitcast<f32>(0xff800000u)
// run: add(bitcast<f32>(0xff800000u), -0.3) == bitcast<f32>(0xff800000u)
// run: add(bitcast<f32>(0xff800000u), bitcast<f32>(0x006ce3eeu)) == bitcast<f32>(0xff800000u)
// run: add(bitcast<f32>(0xff800000u), 3.4028235e+38) == bitcast<f32>(0xff800000u)
// run: add(bitcast<f32>(0xff800000u), bitcast<f32>(0xff800000u)) == bitcast<f32>(0xff800000u)
// run: add(bitcast<f32>(0xff800000u), 1.0000001) == bitcast<f32>(0xff800000u)
// run: add(bitcast<f32>(0x7fc00000u), 0.0) == nan
// run: add(bitcast<f32>(0x7fc00000u), 0.1) == nan
// run: add(bitcast<f32>(0x7fc00000u), 1.677722e+07) == nan
// run: add(bitcast<f32>(0x7fc00000u), bitcast<f32>(0x00800000u)) == nan
// run: add(bitcast<f32>(0x7fc00000u), bitcast<f32>(0x7fc00000u)) == nan
// run: add(bitcast<f32>(0x7fc00000u), -7.25) == nan
// run: add(1.0000001, -1.0) == 1.1920929e-07
// run: add(1.0000001, 16777216.0) == 16777218.0
// run: add(1.0000001, bitcast<f32>(0x007fffffu)) == 1.0000001
// run: add(1.0000001, bitcast<f32>(0xff800000u)) == bitcast<f32>(0xff800000u)
// run: add(1.0000001, 1.0000001) == 2.0000002
// run: add(1.0000001, 1e+20) == 1e+20
// run: add(0.99999994, 1.0) == 2.0
// run: add(0.99999994, 3.0) == 4.0
// run: add(0.99999994, bitcast<f32>(0x00000001u)) == 0.99999994
// run: add(0.99999994, bitcast<f32>(0x7f800000u)) == bitcast<f32>(0x7f800000u)
// run: add(0.99999994, 0.99999994) == 1.9999999
// run: add(1e+20, -0.0) == 1e+20
// run: add(1e+20, -0.3) == 1e+20
// run: add(1e+20, bitcast<f32>(0x006ce3eeu)) == 1e+20
// run: add(1e+20, 3.4028235e+38) == 3.4028235e+38
// run: add(1e+20, 1.0000001) == 1e+20
// run: add(1e+20, 1e+20) == 2e+20
// run: add(-7.25, 0.0) == -7.25
// run: add(-7.25, 0.1) == -7.15
// run: add(-7.25, 1.677722e+07) == 16777213.0
// run: add(-7.25, bitcast<f32>(0x00800000u)) == -7.25
// run: add(-7.25, bitcast<f32>(0x7fc00000u)) == nan
// run: add(-7.25, -7.25) == -14.5

fn add_vec2(x: vec2<f32>, y: vec2<f32>) -> vec2<f32> { return x + y; }
// run: add_vec2(vec2<f32>(1.0, -1.0), vec2<f32>(0.1, -0.3)) == vec2<f32>(1.1, -1.3)
// run: add_vec2(vec2<f32>(3.0, 16777216.0), vec2<f32>(16777216.0, 1.677722e+07)) == vec2<f32>(1.677722e+07, 33554436.0)
// run: add_vec2(vec2<f32>(bitcast<f32>(0x00000001u), bitcast<f32>(0x007fffffu)), vec2<f32>(bitcast<f32>(0x00000001u), bitcast<f32>(0x007fffffu))) == vec2<f32>(bitcast<f32>(0x00000002u), bitcast<f32>(0x00fffffeu))

fn add_vec3(x: vec3<f32>, y: vec3<f32>) -> vec3<f32> { return x + y; }
// run: add_vec3(vec3<f32>(1.0, -1.0, 0.1), vec3<f32>(0.1, -0.3, 3.0)) == vec3<f32>(1.1, -1.3, 3.1)
// run: add_vec3(vec3<f32>(3.0, 16777216.0, 1.677722e+07), vec3<f32>(16777216.0, 1.677722e+07, bitcast<f32>(0x006ce3eeu))) == vec3<f32>(1.677722e+07, 33554436.0, 1.677722e+07)
// run: add_vec3(vec3<f32>(bitcast<f32>(0x00000001u), bitcast<f32>(0x007fffffu), bitcast<f32>(0x00800000u)), vec3<f32>(bitcast<f32>(0x00000001u), bitcast<f32>(0x007fffffu), bitcast<f32>(0x00800000u))) == vec3<f32>(bitcast<f32>(0x00000002u), bitcast<f32>(0x00fffffeu), bitcast<f32>(0x01000000u))

fn add_vec4(x: vec4<f32>, y: vec4<f32>) -> vec4<f32> { return x + y; }
// run: add_vec4(vec4<f32>(1.0, -1.0, 0.1, -0.3), vec4<f32>(0.1, -0.3, 3.0, 16777216.0)) == vec4<f32>(1.1, -1.3, 3.1, 16777216.0)
// run: add_vec4(vec4<f32>(3.0, 16777216.0, 1.677722e+07, bitcast<f32>(0x006ce3eeu)), vec4<f32>(16777216.0, 1.677722e+07, bitcast<f32>(0x006ce3eeu), bitcast<f32>(0x00000001u))) == vec4<f32>(1.677722e+07, 33554436.0, 1.677722e+07, bitcast<f32>(0x006ce3efu))
// run: add_vec4(vec4<f32>(bitcast<f32>(0x00000001u), bitcast<f32>(0x007fffffu), bitcast<f32>(0x00800000u), 3.4028235e+38), vec4<f32>(bitcast<f32>(0x00000001u), bitcast<f32>(0x007fffffu), bitcast<f32>(0x00800000u), 3.4028235e+38)) == vec4<f32>(bitcast<f32>(0x00000002u), bitcast<f32>(0x00fffffeu), bitcast<f32>(0x01000000u), bitcast<f32>(0x7f800000u))

fn add_scalar(x: vec3<f32>, y: f32) -> vec3<f32> { return x + y; }
// run: add_scalar(vec3<f32>(-1.0, 0.1, -0.3), 3.0) == vec3<f32>(2.0, 3.1, 2.7)

fn scalar_add(x: f32, y: vec3<f32>) -> vec3<f32> { return x + y; }
// run: scalar_add(3.0, vec3<f32>(-1.0, 0.1, -0.3)) == vec3<f32>(2.0, 3.1, 2.7)

fn sub(x: f32, y: f32) -> f32 { return x - y; }
// run: sub(0.0, 0.0) == 0.0
// run: sub(0.0, 0.1) == -0.1
// run: sub(0.0, 1.677722e+07) == -1.677722e+07
// run: sub(0.0, bitcast<f32>(0x00800000u)) == bitcast<f32>(0x80800000u)
// run: sub(0.0, bitcast<f32>(0x7fc00000u)) == nan
// run: sub(0.0, -7.25) == 7.25
// run: sub(-0.0, -0.0) == 0.0
// run: sub(-0.0, -1.0) == 1.0
// run: sub(-0.0, 16777216.0) == -16777216.0
// run: sub(-0.0, bitcast<f32>(0x007fffffu)) == bitcast<f32>(0x807fffffu)
// run: sub(-0.0, bitcast<f32>(0xff800000u)) == bitcast<f32>(0x7f800000u)
// run: sub(-0.0, 1e+20) == -1e+20
// run: sub(1.0, 1.0) == 0.0
// run: sub(1.0, 3.0) == -2.0
// run: sub(1.0, bitcast<f32>(0x00000001u)) == 1.0
// run: sub(1.0, bitcast<f32>(0x7f800000u)) == bitcast<f32>(0xff800000u)
// run: sub(1.0, 0.99999994) == 5.9604645e-08
// run: sub(-1.0, -0.0) == -1.0
// run: sub(-1.0, -1.0) == 0.0
// run: sub(-1.0, -0.3) == -0.7
// run: sub(-1.0, bitcast<f32>(0x006ce3eeu)) == -1.0
// run: sub(-1.0, 3.4028235e+38) == -3.4028235e+38
// run: sub(-1.0, 1.0000001) == -2.0
// run: sub(0.1, 0.0) == 0.1
// run: sub(0.1, 0.1) == 0.0
// run: sub(0.1, 1.677722e+07) == -1.677722e+07
// run: sub(0.1, bitcast<f32>(0x00800000u)) == 0.1
// run: sub(0.1, bitcast<f32>(0x7fc00000u)) == nan
// run: sub(0.1, -7.25) == 7.35
// run: sub(-0.3, -1.0) == 0.7
// run: sub(-0.3, -0.3) == 0.0
// run: sub(-0.3, 16777216.0) == -16777216.0
// run: sub(-0.3, bitcast<f32>(0x007fffffu)) == -0.3
// run: sub(-0.3, bitcast<f32>(0xff800000u)) == bitcast<f32>(0x7f800000u)
// run: sub(-0.3, 1e+20) == -1e+20
// run: sub(3.0, 1.0) == 2.0
// run: sub(3.0, 3.0) == 0.0
// run: sub(3.0, bitcast<f32>(0x00000001u)) == 3.0
// run: sub(3.0, bitcast<f32>(0x7f800000u)) == bitcast<f32>(0xff800000u)
// run: sub(3.0, 0.99999994) == 2.0
// run: sub(16777216.0, -0.0) == 16777216.0
// run: sub(16777216.0, -0.3) == 16777216.0
// run: sub(16777216.0, 16777216.0) == 0.0
// run: sub(16777216.0, bitcast<f32>(0x006ce3eeu)) == 16777216.0
// run: sub(16777216.0, 3.4028235e+38) == -3.4028235e+38
// run: sub(16777216.0, 1.0000001) == 16777215.0
// run: sub(1.677722e+07, 0.0) == 1.677722e+07
// run: sub(1.677722e+07, 0.1) == 1.677722e+07
// run: sub(1.677722e+07, 1.677722e+07) == 0.0
// run: sub(1.677722e+07, bitcast<f32>(0x00800000u)) == 1.677722e+07
// run: sub(1.677722e+07, bitcast<f32>(0x7fc00000u)) == nan
// run: sub(1.677722e+07, -7.25) == 16777228.0
// run: sub(bitcast<f32>(0x006ce3eeu), -1.0) == 1.0
// run: sub(bitcast<f32>(0x006ce3eeu), 16777216.0) == -16777216.0
// run: sub(bitcast<f32>(0x006ce3eeu), bitcast<f32>(0x006ce3eeu)) == 0.0
// run: sub(bitcast<f32>(0x006ce3eeu), bitcast<f32>(0x007fffffu)) == bitcast<f32>(0x80131c11u)
// run: sub(bitcast<f32>(0x006ce3eeu), bitcast<f32>(0xff800000u)) == bitcast<f32>(0x7f800000u)
// run: sub(bitcast<f32>(0x006ce3eeu), 1e+20) == -1e+20
// run: sub(bitcast<f32>(0x00000001u), 1.0) == -1.0
// run: sub(bitcast<f32>(0x00000001u), 3.0) == -3.0
// run: sub(bitcast<f32>(0x00000001u), bitcast<f32>(0x00000001u)) == 0.0
// run: sub(bitcast<f32>(0x00000001u), bitcast<f32>(0x7f800000u)) == bitcast<f32>(0xff800000u)
// run: sub(bitcast<f32>(0x00000001u), 0.99999994) == -0.99999994
// run: sub(bitcast<f32>(0x007fffffu), -0.0) == bitcast<f32>(0x007fffffu)
// run: sub(bitcast<f32>(0x007fffffu), -0.3) == 0.3
// run: sub(bitcast<f32>(0x007fffffu), bitcast<f32>(0x006ce3eeu)) == bitcast<f32>(0x00131c11u)
// run: sub(bitcast<f32>(0x007fffffu), bitcast<f32>(0x007fffffu)) == 0.0
// run: sub(bitcast<f32>(0x007fffffu), 3.4028235e+38) == -3.4028235e+38
// run: sub(bitcast<f32>(0x007fffffu), 1.0000001) == -1.0000001
// run: sub(bitcast<f32>(0x00800000u), 0.0) == bitcast<f32>(0x00800000u)
// run: sub(bitcast<f32>(0x00800000u), 0.1) == -0.1
// run: sub(bitcast<f32>(0x00800000u), 1.677722e+07) == -1.677722e+07
// run: sub(bitcast<f32>(0x00800000u), bitcast<f32>(0x00800000u)) == 0.0
// run: sub(bitcast<f32>(0x00800000u), bitcast<f32>(0x7fc00000u)) == nan
// run: sub(bitcast<f32>(0x00800000u), -7.25) == 7.25
// run: sub(3.4028235e+38, -1.0) == 3.4028235e+38
// run: sub(3.4028235e+38, 16777216.0) == 3.4028235e+38
// run: sub(3.4028235e+38, bitcast<f32>(0x007fffffu)) == 3.4028235e+38
// run: sub(3.4028235e+38, 3.4028235e+38) == 0.0
// run: sub(3.4028235e+38, bitcast<f32>(0xff800000u)) == bitcast<f32>(0x7f800000u)
// run: sub(3.4028235e+38, 1e+20) == 3.4028235e+38
// run: sub(bitcast<f32>(0x7f800000u), 1.0) == bitcast<f32>(0x7f800000u)
// run: sub(bitcast<f32>(0x7f800000u), 3.0) == bitcast<f32>(0x7f800000u)
// run: sub(bitcast<f32>(0x7f800000u), bitcast<f32>(0x00000001u)) == bitcast<f32>(0x7f800000u)
// run: sub(bitcast<f32>(0x7f800000u), bitcast<f32>(0x7f800000u)) == nan
// run: sub(bitcast<f32>(0x7f800000u), 0.99999994) == bitcast<f32>(0x7f800000u)
// run: sub(bitcast<f32>(0xff800000u), -0.0) == bitcast<f32>(0xff800000u)
// run: sub(bitcast<f32>(0xff800000u), -0.3) == bitcast<f32>(0xff800000u)
// run: sub(bitcast<f32>(0xff800000u), bitcast<f32>(0x006ce3eeu)) == bitcast<f32>(0xff800000u)
// run: sub(bitcast<f32>(0xff800000u), 3.4028235e+38) == bitcast<f32>(0xff800000u)
// run: sub(bitcast<f32>(0xff800000u), bitcast<f32>(0xff800000u)) == nan
// run: sub(bitcast<f32>(0xff800000u), 1.0000001) == bitcast<f32>(0xff800000u)
// run: sub(bitcast<f32>(0x7fc00000u), 0.0) == nan
// run: sub(bitcast<f32>(0x7fc00000u), 0.1) == nan
// run: sub(bitcast<f32>(0x7fc00000u), 1.677722e+07) == nan
// run: sub(bitcast<f32>(0x7fc00000u), bitcast<f32>(0x00800000u)) == nan
// run: sub(bitcast<f32>(0x7fc00000u), bitcast<f32>(0x7fc00000u)) == nan
// run: sub(bitcast<f32>(0x7fc00000u), -7.25) == nan
// run: sub(1.0000001, -1.0) == 2.0
// run: sub(1.0000001, 16777216.0) == -16777215.0
// run: sub(1.0000001, bitcast<f32>(0x007fffffu)) == 1.0000001
// run: sub(1.0000001, bitcast<f32>(0xff800000u)) == bitcast<f32>(0x7f800000u)
// run: sub(1.0000001, 1.0000001) == 0.0
// run: sub(1.0000001, 1e+20) == -1e+20
// run: sub(0.99999994, 1.0) == -5.9604645e-08
// run: sub(0.99999994, 3.0) == -2.0
// run: sub(0.99999994, bitcast<f32>(0x00000001u)) == 0.99999994
// run: sub(0.99999994, bitcast<f32>(0x7f800000u)) == bitcast<f32>(0xff800000u)
// run: sub(0.99999994, 0.99999994) == 0.0
// run: sub(1e+20, -0.0) == 1e+20
// run: sub(1e+20, -0.3) == 1e+20
// run: sub(1e+20, bitcast<f32>(0x006ce3eeu)) == 1e+20
// run: sub(1e+20, 3.4028235e+38) == -3.4028235e+38
// run: sub(1e+20, 1.0000001) == 1e+20
// run: sub(1e+20, 1e+20) == 0.0
// run: sub(-7.25, 0.0) == -7.25
// run: sub(-7.25, 0.1) == -7.35
// run: sub(-7.25, 1.677722e+07) == -16777228.0
// run: sub(-7.25, bitcast<f32>(0x00800000u)) == -7.25
// run: sub(-7.25, bitcast<f32>(0x7fc00000u)) == nan
// run: sub(-7.25, -7.25) == 0.0

fn sub_vec2(x: vec2<f32>, y: vec2<f32>) -> vec2<f32> { return x - y; }
// run: sub_vec2(vec2<f32>(1.0, -1.0), vec2<f32>(0.1, -0.3)) == vec2<f32>(0.9, -0.7)
// run: sub_vec2(vec2<f32>(3.0, 16777216.0), vec2<f32>(16777216.0, 1.677722e+07)) == vec2<f32>(-16777213.0, -4.0)
// run: sub_vec2(vec2<f32>(bitcast<f32>(0x00000001u), bitcast<f32>(0x007fffffu)), vec2<f32>(bitcast<f32>(0x00000001u), bitcast<f32>(0x007fffffu))) == vec2<f32>(0.0, 0.0)

fn sub_vec3(x: vec3<f32>, y: vec3<f32>) -> vec3<f32> { return x - y; }
// run: sub_vec3(vec3<f32>(1.0, -1.0, 0.1), vec3<f32>(0.1, -0.3, 3.0)) == vec3<f32>(0.9, -0.7, -2.9)
// run: sub_vec3(vec3<f32>(3.0, 16777216.0, 1.677722e+07), vec3<f32>(16777216.0, 1.677722e+07, bitcast<f32>(0x006ce3eeu))) == vec3<f32>(-16777213.0, -4.0, 1.677722e+07)
// run: sub_vec3(vec3<f32>(bitcast<f32>(0x00000001u), bitcast<f32>(0x007fffffu), bitcast<f32>(0x00800000u)), vec3<f32>(bitcast<f32>(0x00000001u), bitcast<f32>(0x007fffffu), bitcast<f32>(0x00800000u))) == vec3<f32>(0.0, 0.0, 0.0)

fn sub_vec4(x: vec4<f32>, y: vec4<f32>) -> vec4<f32> { return x - y; }
// run: sub_vec4(vec4<f32>(1.0, -1.0, 0.1, -0.3), vec4<f32>(0.1, -0.3, 3.0, 16777216.0)) == vec4<f32>(0.9, -0.7, -2.9, -16777216.0)
// run: sub_vec4(vec4<f32>(3.0, 16777216.0, 1.677722e+07, bitcast<f32>(0x006ce3eeu)), vec4<f32>(16777216.0, 1.677722e+07, bitcast<f32>(0x006ce3eeu), bitcast<f32>(0x00000001u))) == vec4<f32>(-16777213.0, -4.0, 1.677722e+07, bitcast<f32>(0x006ce3edu))
// run: sub_vec4(vec4<f32>(bitcast<f32>(0x00000001u), bitcast<f32>(0x007fffffu), bitcast<f32>(0x00800000u), 3.4028235e+38), vec4<f32>(bitcast<f32>(0x00000001u), bitcast<f32>(0x007fffffu), bitcast<f32>(0x00800000u), 3.4028235e+38)) == vec4<f32>(0.0, 0.0, 0.0, 0.0)

fn sub_scalar(x: vec3<f32>, y: f32) -> vec3<f32> { return x - y; }
// run: sub_scalar(vec3<f32>(-1.0, 0.1, -0.3), 3.0) == vec3<f32>(-4.0, -2.9, -3.3)

fn scalar_sub(x: f32, y: vec3<f32>) -> vec3<f32> { return x - y; }
// run: scalar_sub(3.0, vec3<f32>(-1.0, 0.1, -0.3)) == vec3<f32>(4.0, 2.9, 3.3)

fn mul(x: f32, y: f32) -> f32 { return x * y; }
// run: mul(0.0, 0.0) == 0.0
// run: mul(0.0, 0.1) == 0.0
// run: mul(0.0, 1.677722e+07) == 0.0
// run: mul(0.0, bitcast<f32>(0x00800000u)) == 0.0
// run: mul(0.0, bitcast<f32>(0x7fc00000u)) == nan
// run: mul(0.0, -7.25) == -0.0
// run: mul(-0.0, -0.0) == 0.0
// run: mul(-0.0, -1.0) == 0.0
// run: mul(-0.0, 16777216.0) == -0.0
// run: mul(-0.0, bitcast<f32>(0x007fffffu)) == -0.0
// run: mul(-0.0, bitcast<f32>(0xff800000u)) == nan
// run: mul(-0.0, 1e+20) == -0.0
// run: mul(1.0, 1.0) == 1.0
// run: mul(1.0, 3.0) == 3.0
// run: mul(1.0, bitcast<f32>(0x00000001u)) == bitcast<f32>(0x00000001u)
// run: mul(1.0, bitcast<f32>(0x7f800000u)) == bitcast<f32>(0x7f800000u)
// run: mul(1.0, 0.99999994) == 0.99999994
// run: mul(-1.0, -0.0) == 0.0
// run: mul(-1.0, -1.0) == 1.0
// run: mul(-1.0, -0.3) == 0.3
// run: mul(-1.0, bitcast<f32>(0x006ce3eeu)) == bitcast<f32>(0x806ce3eeu)
// run: mul(-1.0, 3.4028235e+38) == -3.4028235e+38
// run: mul(-1.0, 1.0000001) == -1.0000001
// run: mul(0.1, 0.0) == 0.0
// run: mul(0.1, 0.1) == 0.010000001
// run: mul(0.1, 1.677722e+07) == 1677722.0
// run: mul(0.1, bitcast<f32>(0x00800000u)) == bitcast<f32>(0x000ccccdu)
// run: mul(0.1, bitcast<f32>(0x7fc00000u)) == nan
// run: mul(0.1, -7.25) == -0.725
// run: mul(-0.3, -1.0) == 0.3
// run: mul(-0.3, -0.3) == 0.09
// run: mul(-0.3, 16777216.0) == -5033165.0
// run: mul(-0.3, bitcast<f32>(0x007fffffu)) == bitcast<f32>(0x80266666u)
// run: mul(-0.3, bitcast<f32>(0xff800000u)) == bitcast<f32>(0x7f800000u)
// run: mul(-0.3, 1e+20) == -3e+19
// run: mul(3.0, 1.0) == 3.0
// run: mul(3.0, 3.0) == 9.0
// run: mul(3.0, bitcast<f32>(0x00000001u)) == bitcast<f32>(0x00000003u)
// run: mul(3.0, bitcast<f32>(0x7f800000u)) == bitcast<f32>(0x7f800000u)
// run: mul(3.0, 0.99999994) == 2.9999998
// run: mul(16777216.0, -0.0) == -0.0
// run: mul(16777216.0, -0.3) == -5033165.0
// run: mul(16777216.0, 16777216.0) == 2.8147498e+14
// run: mul(16777216.0, bitcast<f32>(0x006ce3eeu)) == 1.6777215e-31
// run: mul(16777216.0, 3.4028235e+38) == bitcast<f32>(0x7f800000u)
// run: mul(16777216.0, 1.0000001) == 16777218.0
// run: mul(1.677722e+07, 0.0) == 0.0
// run: mul(1.677722e+07, 0.1) == 1677722.0
// run: mul(1.677722e+07, 1.677722e+07) == 2.814751e+14
// run: mul(1.677722e+07, bitcast<f32>(0x00800000u)) == 1.9721527e-31
// run: mul(1.677722e+07, bitcast<f32>(0x7fc00000u)) == nan
// run: mul(1.677722e+07, -7.25) == -1.2163485e+08
// run: mul(bitcast<f32>(0x006ce3eeu), -1.0) == bitcast<f32>(0x806ce3eeu)
// run: mul(bitcast<f32>(0x006ce3eeu), 16777216.0) == 1.6777215e-31
// run: mul(bitcast<f32>(0x006ce3eeu), bitcast<f32>(0x006ce3eeu)) == 0.0
// run: mul(bitcast<f32>(0x006ce3eeu), bitcast<f32>(0x007fffffu)) == 0.0
// run: mul(bitcast<f32>(0x006ce3eeu), bitcast<f32>(0xff800000u)) == bitcast<f32>(0xff800000u)
// run: mul(bitcast<f32>(0x006ce3eeu), 1e+20) == 9.999999e-19
// run: mul(bitcast<f32>(0x00000001u), 1.0) == bitcast<f32>(0x00000001u)
// run: mul(bitcast<f32>(0x00000001u), 3.0) == bitcast<f32>(0x00000003u)
// run: mul(bitcast<f32>(0x00000001u), bitcast<f32>(0x00000001u)) == 0.0
// run: mul(bitcast<f32>(0x00000001u), bitcast<f32>(0x7f800000u)) == bitcast<f32>(0x7f800000u)
// run: mul(bitcast<f32>(0x00000001u), 0.99999994) == bitcast<f32>(0x00000001u)
// run: mul(bitcast<f32>(0x007fffffu), -0.0) == -0.0
// run: mul(bitcast<f32>(0x007fffffu), -0.3) == bitcast<f32>(0x80266666u)
// run: mul(bitcast<f32>(0x007fffffu), bitcast<f32>(0x006ce3eeu)) == 0.0
// run: mul(bitcast<f32>(0x007fffffu), bitcast<f32>(0x007fffffu)) == 0.0
// run: mul(bitcast<f32>(0x007fffffu), 3.4028235e+38) == 3.9999993
// run: mul(bitcast<f32>(0x007fffffu), 1.0000001) == bitcast<f32>(0x00800000u)
// run: mul(bitcast<f32>(0x00800000u), 0.0) == 0.0
// run: mul(bitcast<f32>(0x00800000u), 0.1) == bitcast<f32>(0x000ccccdu)
// run: mul(bitcast<f32>(0x00800000u), 1.677722e+07) == 1.9721527e-31
// run: mul(bitcast<f32>(0x00800000u), bitcast<f32>(0x00800000u)) == 0.0
// run: mul(bitcast<f32>(0x00800000u), bitcast<f32>(0x7fc00000u)) == nan
// run: mul(bitcast<f32>(0x00800000u), -7.25) == bitcast<f32>(0x81e80000u)
// run: mul(3.4028235e+38, -1.0) == -3.4028235e+38
// run: mul(3.4028235e+38, 16777216.0) == bitcast<f32>(0x7f800000u)
// run: mul(3.4028235e+38, bitcast<f32>(0x007fffffu)) == 3.9999993
// run: mul(3.4028235e+38, 3.4028235e+38) == bitcast<f32>(0x7f800000u)
// run: mul(3.4028235e+38, bitcast<f32>(0xff800000u)) == bitcast<f32>(0xff800000u)
// run: mul(3.4028235e+38, 1e+20) == bitcast<f32>(0x7f800000u)
// run: mul(bitcast<f32>(0x7f800000u), 1.0) == bitcast<f32>(0x7f800000u)
// run: mul(bitcast<f32>(0x7f800000u), 3.0) == bitcast<f32>(0x7f800000u)
// run: mul(bitcast<f32>(0x7f800000u), bitcast<f32>(0x00000001u)) == bitcast<f32>(0x7f800000u)
// run: mul(bitcast<f32>(0x7f800000u), bitcast<f32>(0x7f800000u)) == bitcast<f32>(0x7f800000u)
// run: mul(bitcast<f32>(0x7f800000u), 0.99999994) == bitcast<f32>(0x7f800000u)
// run: mul(bitcast<f32>(0xff800000u), -0.0) == nan
// run: mul(bitcast<f32>(0xff800000u), -0.3) == bitcast<f32>(0x7f800000u)
// run: mul(bitcast<f32>(0xff800000u), bitcast<f32>(0x006ce3eeu)) == bitcast<f32>(0xff800000u)
// run: mul(bitcast<f32>(0xff800000u), 3.4028235e+38) == bitcast<f32>(0xff800000u)
// run: mul(bitcast<f32>(0xff800000u), bitcast<f32>(0xff800000u)) == bitcast<f32>(0x7f800000u)
// run: mul(bitcast<f32>(0xff800000u), 1.0000001) == bitcast<f32>(0xff800000u)
// run: mul(bitcast<f32>(0x7fc00000u), 0.0) == nan
// run: mul(bitcast<f32>(0x7fc00000u), 0.1) == nan
// run: mul(bitcast<f32>(0x7fc00000u), 1.677722e+07) == nan
// run: mul(bitcast<f32>(0x7fc00000u), bitcast<f32>(0x00800000u)) == nan
// run: mul(bitcast<f32>(0x7fc00000u), bitcast<f32>(0x7fc00000u)) == nan
// run: mul(bitcast<f32>(0x7fc00000u), -7.25) == nan
// run: mul(1.0000001, -1.0) == -1.0000001
// run: mul(1.0000001, 16777216.0) == 16777218.0
// run: mul(1.0000001, bitcast<f32>(0x007fffffu)) == bitcast<f32>(0x00800000u)
// run: mul(1.0000001, bitcast<f32>(0xff800000u)) == bitcast<f32>(0xff800000u)
// run: mul(1.0000001, 1.0000001) == 1.0000002
// run: mul(1.0000001, 1e+20) == 1.0000001e+20
// run: mul(0.99999994, 1.0) == 0.99999994
// run: mul(0.99999994, 3.0) == 2.9999998
// run: mul(0.99999994, bitcast<f32>(0x00000001u)) == bitcast<f32>(0x00000001u)
// run: mul(0.99999994, bitcast<f32>(0x7f800000u)) == bitcast<f32>(0x7f800000u)
// run: mul(0.99999994, 0.99999994) == 0.9999999
// run: mul(1e+20, -0.0) == -0.0
// run: mul(1e+20, -0.3) == -3e+19
// run: mul(1e+20, bitcast<f32>(0x006ce3eeu)) == 9.999999e-19
// run: mul(1e+20, 3.4028235e+38) == bitcast<f32>(0x7f800000u)
// run: mul(1e+20, 1.0000001) == 1.0000001e+20
// run: mul(1e+20, 1e+20) == bitcast<f32>(0x7f800000u)
// run: mul(-7.25, 0.0) == -0.0
// run: mul(-7.25, 0.1) == -0.725
// run: mul(-7.25, 1.677722e+07) == -1.2163485e+08
// run: mul(-7.25, bitcast<f32>(0x00800000u)) == bitcast<f32>(0x81e80000u)
// run: mul(-7.25, bitcast<f32>(0x7fc00000u)) == nan
// run: mul(-7.25, -7.25) == 52.5625

fn mul_vec2(x: vec2<f32>, y: vec2<f32>) -> vec2<f32> { return x * y; }
// run: mul_vec2(vec2<f32>(1.0, -1.0), vec2<f32>(0.1, -0.3)) == vec2<f32>(0.1, 0.3)
// run: mul_vec2(vec2<f32>(3.0, 16777216.0), vec2<f32>(16777216.0, 1.677722e+07)) == vec2<f32>(5.033165e+07, 2.8147504e+14)
// run: mul_vec2(vec2<f32>(bitcast<f32>(0x00000001u), bitcast<f32>(0x007fffffu)), vec2<f32>(bitcast<f32>(0x00000001u), bitcast<f32>(0x007fffffu))) == vec2<f32>(0.0, 0.0)

fn mul_vec3(x: vec3<f32>, y: vec3<f32>) -> vec3<f32> { return x * y; }
// run: mul_vec3(vec3<f32>(1.0, -1.0, 0.1), vec3<f32>(0.1, -0.3, 3.0)) == vec3<f32>(0.1, 0.3, 0.3)
// run: mul_vec3(vec3<f32>(3.0, 16777216.0, 1.677722e+07), vec3<f32>(16777216.0, 1.677722e+07, bitcast<f32>(0x006ce3eeu))) == vec3<f32>(5.033165e+07, 2.8147504e+14, 1.6777218e-31)
// run: mul_vec3(vec3<f32>(bitcast<f32>(0x00000001u), bitcast<f32>(0x007fffffu), bitcast<f32>(0x00800000u)), vec3<f32>(bitcast<f32>(0x00000001u), bitcast<f32>(0x007fffffu), bitcast<f32>(0x00800000u))) == vec3<f32>(0.0, 0.0, 0.0)

fn mul_vec4(x: vec4<f32>, y: vec4<f32>) -> vec4<f32> { return x * y; }
// run: mul_vec4(vec4<f32>(1.0, -1.0, 0.1, -0.3), vec4<f32>(0.1, -0.3, 3.0, 16777216.0)) == vec4<f32>(0.1, 0.3, 0.3, -5033165.0)
// run: mul_vec4(vec4<f32>(3.0, 16777216.0, 1.677722e+07, bitcast<f32>(0x006ce3eeu)), vec4<f32>(16777216.0, 1.677722e+07, bitcast<f32>(0x006ce3eeu), bitcast<f32>(0x00000001u))) == vec4<f32>(5.033165e+07, 2.8147504e+14, 1.6777218e-31, 0.0)
// run: mul_vec4(vec4<f32>(bitcast<f32>(0x00000001u), bitcast<f32>(0x007fffffu), bitcast<f32>(0x00800000u), 3.4028235e+38), vec4<f32>(bitcast<f32>(0x00000001u), bitcast<f32>(0x007fffffu), bitcast<f32>(0x00800000u), 3.4028235e+38)) == vec4<f32>(0.0, 0.0, 0.0, bitcast<f32>(0x7f800000u))

fn mul_scalar(x: vec3<f32>, y: f32) -> vec3<f32> { return x * y; }
// run: mul_scalar(vec3<f32>(-1.0, 0.1, -0.3), 3.0) == vec3<f32>(-3.0, 0.3, -0.90000004)

fn scalar_mul(x: f32, y: vec3<f32>) -> vec3<f32> { return x * y; }
// run: scalar_mul(3.0, vec3<f32>(-1.0, 0.1, -0.3)) == vec3<f32>(-3.0, 0.3, -0.90000004)

fn div(x: f32, y: f32) -> f32 { return x / y; }
// run: div(0.0, 0.0) == nan
// run: div(0.0, 0.1) == 0.0
// run: div(0.0, 1.677722e+07) == 0.0
// run: div(0.0, bitcast<f32>(0x00800000u)) == 0.0
// run: div(0.0, bitcast<f32>(0x7fc00000u)) == nan
// run: div(0.0, -7.25) == -0.0
// run: div(-0.0, -0.0) == nan
// run: div(-0.0, -1.0) == 0.0
// run: div(-0.0, 16777216.0) == -0.0
// run: div(-0.0, bitcast<f32>(0x007fffffu)) == -0.0
// run: div(-0.0, bitcast<f32>(0xff800000u)) == 0.0
// run: div(-0.0, 1e+20) == -0.0
// run: div(1.0, 1.0) == 1.0
// run: div(1.0, 3.0) == 0.33333334
// run: div(1.0, bitcast<f32>(0x00000001u)) == bitcast<f32>(0x7f800000u)
// run: div(1.0, bitcast<f32>(0x7f800000u)) == 0.0
// run: div(1.0, 0.99999994) == 1.0000001
// run: div(-1.0, -0.0) == bitcast<f32>(0x7f800000u)
// run: div(-1.0, -1.0) == 1.0
// run: div(-1.0, -0.3) == 3.3333333
// run: div(-1.0, bitcast<f32>(0x006ce3eeu)) == -1.0000001e+38
// run: div(-1.0, 3.4028235e+38) == bitcast<f32>(0x80200000u)
// run: div(-1.0, 1.0000001) == -0.9999999
// run: div(0.1, 0.0) == bitcast<f32>(0x7f800000u)
// run: div(0.1, 0.1) == 1.0
// run: div(0.1, 1.677722e+07) == 5.9604632e-09
// run: div(0.1, bitcast<f32>(0x00800000u)) == 8.507059e+36
// run: div(0.1, bitcast<f32>(0x7fc00000u)) == nan
// run: div(0.1, -7.25) == -0.013793103
// run: div(-0.3, -1.0) == 0.3
// run: div(-0.3, -0.3) == 1.0
// run: div(-0.3, 16777216.0) == -1.7881394e-08
// run: div(-0.3, bitcast<f32>(0x007fffffu)) == -2.552118e+37
// run: div(-0.3, bitcast<f32>(0xff800000u)) == 0.0
// run: div(-0.3, 1e+20) == -3.0000001e-21
// run: div(3.0, 1.0) == 3.0
// run: div(3.0, 3.0) == 1.0
// run: div(3.0, bitcast<f32>(0x00000001u)) == bitcast<f32>(0x7f800000u)
// run: div(3.0, bitcast<f32>(0x7f800000u)) == 0.0
// run: div(3.0, 0.99999994) == 3.0000002
// run: div(16777216.0, -0.0) == bitcast<f32>(0xff800000u)
// run: div(16777216.0, -0.3) == -55924052.0
// run: div(16777216.0, 16777216.0) == 1.0
// run: div(16777216.0, bitcast<f32>(0x006ce3eeu)) == bitcast<f32>(0x7f800000u)
// run: div(16777216.0, 3.4028235e+38) == 4.930381e-32
// run: div(16777216.0, 1.0000001) == 16777214.0
// run: div(1.677722e+07, 0.0) == bitcast<f32>(0x7f800000u)
// run: div(1.677722e+07, 0.1) == 1.677722e+08
// run: div(1.677722e+07, 1.677722e+07) == 1.0
// run: div(1.677722e+07, bitcast<f32>(0x00800000u)) == bitcast<f32>(0x7f800000u)
// run: div(1.677722e+07, bitcast<f32>(0x7fc00000u)) == nan
// run: div(1.677722e+07, -7.25) == -2314099.2
// run: div(bitcast<f32>(0x006ce3eeu), -1.0) == bitcast<f32>(0x806ce3eeu)
// run: div(bitcast<f32>(0x006ce3eeu), 16777216.0) == 0.0
// run: div(bitcast<f32>(0x006ce3eeu), bitcast<f32>(0x006ce3eeu)) == 1.0
// run: div(bitcast<f32>(0x006ce3eeu), bitcast<f32>(0x007fffffu)) == 0.850706
// run: div(bitcast<f32>(0x006ce3eeu), bitcast<f32>(0xff800000u)) == -0.0
// run: div(bitcast<f32>(0x006ce3eeu), 1e+20) == 0.0
// run: div(bitcast<f32>(0x00000001u), 1.0) == bitcast<f32>(0x00000001u)
// run: div(bitcast<f32>(0x00000001u), 3.0) == 0.0
// run: div(bitcast<f32>(0x00000001u), bitcast<f32>(0x00000001u)) == 1.0
// run: div(bitcast<f32>(0x00000001u), bitcast<f32>(0x7f800000u)) == 0.0
// run: div(bitcast<f32>(0x00000001u), 0.99999994) == bitcast<f32>(0x00000001u)
// run: div(bitcast<f32>(0x007fffffu), -0.0) == bitcast<f32>(0xff800000u)
// run: div(bitcast<f32>(0x007fffffu), -0.3) == bitcast<f32>(0x81555553u)
// run: div(bitcast<f32>(0x007fffffu), bitcast<f32>(0x006ce3eeu)) == 1.1754943
// run: div(bitcast<f32>(0x007fffffu), bitcast<f32>(0x007fffffu)) == 1.0
// run: div(bitcast<f32>(0x007fffffu), 3.4028235e+38) == 0.0
// run: div(bitcast<f32>(0x007fffffu), 1.0000001) == bitcast<f32>(0x007ffffeu)
// run: div(bitcast<f32>(0x00800000u), 0.0) == bitcast<f32>(0x7f800000u)
// run: div(bitcast<f32>(0x00800000u), 0.1) == 1.1754944e-37
// run: div(bitcast<f32>(0x00800000u), 1.677722e+07) == 0.0
// run: div(bitcast<f32>(0x00800000u), bitcast<f32>(0x00800000u)) == 1.0
// run: div(bitcast<f32>(0x00800000u), bitcast<f32>(0x7fc00000u)) == nan
// run: div(bitcast<f32>(0x00800000u), -7.25) == bitcast<f32>(0x8011a7b9u)
// run: div(3.4028235e+38, -1.0) == -3.4028235e+38
// run: div(3.4028235e+38, 16777216.0) == 2.0282408e+31
// run: div(3.4028235e+38, bitcast<f32>(0x007fffffu)) == bitcast<f32>(0x7f800000u)
// run: div(3.4028235e+38, 3.4028235e+38) == 1.0
// run: div(3.4028235e+38, bitcast<f32>(0xff800000u)) == -0.0
// run: div(3.4028235e+38, 1e+20) == 3.4028233e+18
// run: div(bitcast<f32>(0x7f800000u), 1.0) == bitcast<f32>(0x7f800000u)
// run: div(bitcast<f32>(0x7f800000u), 3.0) == bitcast<f32>(0x7f800000u)
// run: div(bitcast<f32>(0x7f800000u), bitcast<f32>(0x00000001u)) == bitcast<f32>(0x7f800000u)
// run: div(bitcast<f32>(0x7f800000u), bitcast<f32>(0x7f800000u)) == nan
// run: div(bitcast<f32>(0x7f800000u), 0.99999994) == bitcast<f32>(0x7f800000u)
// run: div(bitcast<f32>(0xff800000u), -0.0) == bitcast<f32>(0x7f800000u)
// run: div(bitcast<f32>(0xff800000u), -0.3) == bitcast<f32>(0x7f800000u)
// run: div(bitcast<f32>(0xff800000u), bitcast<f32>(0x006ce3eeu)) == bitcast<f32>(0xff800000u)
// run: div(bitcast<f32>(0xff800000u), 3.4028235e+38) == bitcast<f32>(0xff800000u)
// run: div(bitcast<f32>(0xff800000u), bitcast<f32>(0xff800000u)) == nan
// run: div(bitcast<f32>(0xff800000u), 1.0000001) == bitcast<f32>(0xff800000u)
// run: div(bitcast<f32>(0x7fc00000u), 0.0) == nan
// run: div(bitcast<f32>(0x7fc00000u), 0.1) == nan
// run: div(bitcast<f32>(0x7fc00000u), 1.677722e+07) == nan
// run: div(bitcast<f32>(0x7fc00000u), bitcast<f32>(0x00800000u)) == nan
// run: div(bitcast<f32>(0x7fc00000u), bitcast<f32>(0x7fc00000u)) == nan
// run: div(bitcast<f32>(0x7fc00000u), -7.25) == nan
// run: div(1.0000001, -1.0) == -1.0000001
// run: div(1.0000001, 16777216.0) == 5.960465e-08
// run: div(1.0000001, bitcast<f32>(0x007fffffu)) == 8.507061e+37
// run: div(1.0000001, bitcast<f32>(0xff800000u)) == -0.0
// run: div(1.0000001, 1.0000001) == 1.0
// run: div(1.0000001, 1e+20) == 1.0000001e-20
// run: div(0.99999994, 1.0) == 0.99999994
// run: div(0.99999994, 3.0) == 0.3333333
// run: div(0.99999994, bitcast<f32>(0x00000001u)) == bitcast<f32>(0x7f800000u)
// run: div(0.99999994, bitcast<f32>(0x7f800000u)) == 0.0
// run: div(0.99999994, 0.99999994) == 1.0
// run: div(1e+20, -0.0) == bitcast<f32>(0xff800000u)
// run: div(1e+20, -0.3) == -3.3333333e+20
// run: div(1e+20, bitcast<f32>(0x006ce3eeu)) == bitcast<f32>(0x7f800000u)
// run: div(1e+20, 3.4028235e+38) == 2.9387362e-19
// run: div(1e+20, 1.0000001) == 9.999999e+19
// run: div(1e+20, 1e+20) == 1.0
// run: div(-7.25, 0.0) == bitcast<f32>(0xff800000u)
// run: div(-7.25, 0.1) == -72.5
// run: div(-7.25, 1.677722e+07) == -4.3213356e-07
// run: div(-7.25, bitcast<f32>(0x00800000u)) == bitcast<f32>(0xff800000u)
// run: div(-7.25, bitcast<f32>(0x7fc00000u)) == nan
// run: div(-7.25, -7.25) == 1.0

fn div_vec2(x: vec2<f32>, y: vec2<f32>) -> vec2<f32> { return x / y; }
// run: div_vec2(vec2<f32>(1.0, -1.0), vec2<f32>(0.1, -0.3)) == vec2<f32>(1e+01, 3.3333333)
// run: div_vec2(vec2<f32>(3.0, 16777216.0), vec2<f32>(16777216.0, 1.677722e+07)) == vec2<f32>(1.7881393e-07, 0.99999976)
// run: div_vec2(vec2<f32>(bitcast<f32>(0x00000001u), bitcast<f32>(0x007fffffu)), vec2<f32>(bitcast<f32>(0x00000001u), bitcast<f32>(0x007fffffu))) == vec2<f32>(1.0, 1.0)

fn div_vec3(x: vec3<f32>, y: vec3<f32>) -> vec3<f32> { return x / y; }
// run: div_vec3(vec3<f32>(1.0, -1.0, 0.1), vec3<f32>(0.1, -0.3, 3.0)) == vec3<f32>(1e+01, 3.3333333, 0.033333335)
// run: div_vec3(vec3<f32>(3.0, 16777216.0, 1.677722e+07), vec3<f32>(16777216.0, 1.677722e+07, bitcast<f32>(0x006ce3eeu))) == vec3<f32>(1.7881393e-07, 0.99999976, bitcast<f32>(0x7f800000u))
// run: div_vec3(vec3<f32>(bitcast<f32>(0x00000001u), bitcast<f32>(0x007fffffu), bitcast<f32>(0x00800000u)), vec3<f32>(bitcast<f32>(0x00000001u), bitcast<f32>(0x007fffffu), bitcast<f32>(0x00800000u))) == vec3<f32>(1.0, 1.0, 1.0)

fn div_vec4(x: vec4<f32>, y: vec4<f32>) -> vec4<f32> { return x / y; }
// run: div_vec4(vec4<f32>(1.0, -1.0, 0.1, -0.3), vec4<f32>(0.1, -0.3, 3.0, 16777216.0)) == vec4<f32>(1e+01, 3.3333333, 0.033333335, -1.7881394e-08)
// run: div_vec4(vec4<f32>(3.0, 16777216.0, 1.677722e+07, bitcast<f32>(0x006ce3eeu)), vec4<f32>(16777216.0, 1.677722e+07, bitcast<f32>(0x006ce3eeu), bitcast<f32>(0x00000001u))) == vec4<f32>(1.7881393e-07, 0.99999976, bitcast<f32>(0x7f800000u), 7136238.0)
// run: div_vec4(vec4<f32>(bitcast<f32>(0x00000001u), bitcast<f32>(0x007fffffu), bitcast<f32>(0x00800000u), 3.4028235e+38), vec4<f32>(bitcast<f32>(0x00000001u), bitcast<f32>(0x007fffffu), bitcast<f32>(0x00800000u), 3.4028235e+38)) == vec4<f32>(1.0, 1.0, 1.0, 1.0)

fn div_scalar(x: vec3<f32>, y: f32) -> vec3<f32> { return x / y; }
// run: div_scalar(vec3<f32>(-1.0, 0.1, -0.3), 3.0) == vec3<f32>(-0.33333334, 0.033333335, -0.1)

fn scalar_div(x: f32, y: vec3<f32>) -> vec3<f32> { return x / y; }
// run: scalar_div(3.0, vec3<f32>(-1.0, 0.1, -0.3)) == vec3<f32>(-3.0, 3e+01, -1e+01)

fn negate(x: f32) -> f32 { return -x; }
// run: negate(0.0) == -0.0
// run: negate(-0.0) == 0.0
// run: negate(1.0) == -1.0
// run: negate(-1.0) == 1.0
// run: negate(0.1) == -0.1
// run: negate(-0.3) == 0.3
// run: negate(3.0) == -3.0
// run: negate(16777216.0) == -16777216.0
// run: negate(1.677722e+07) == -1.677722e+07
// run: negate(bitcast<f32>(0x006ce3eeu)) == bitcast<f32>(0x806ce3eeu)
// run: negate(bitcast<f32>(0x00000001u)) == bitcast<f32>(0x80000001u)
// run: negate(bitcast<f32>(0x007fffffu)) == bitcast<f32>(0x807fffffu)
// run: negate(bitcast<f32>(0x00800000u)) == bitcast<f32>(0x80800000u)
// run: negate(3.4028235e+38) == -3.4028235e+38
// run: negate(bitcast<f32>(0x7f800000u)) == bitcast<f32>(0xff800000u)
// run: negate(bitcast<f32>(0xff800000u)) == bitcast<f32>(0x7f800000u)
// run: negate(1.0000001) == -1.0000001
// run: negate(0.99999994) == -0.99999994
// run: negate(1e+20) == -1e+20
// run: negate(-7.25) == 7.25

fn negate_vec2(x: vec2<f32>) -> vec2<f32> { return -x; }
// run: negate_vec2(vec2<f32>(0.0, -3.0)) == vec2<f32>(-0.0, 3.0)

fn rem(x: f32, y: f32) -> f32 { return x % y; }
// run: rem(1.0, 1.0) == 0.0
// run: rem(1.0, -2.0) == 1.0
// run: rem(1.0, 0.1) == 0.0
// run: rem(1.0, 3.0) == 1.0
// run: rem(1.0, 1e+20) == 1.0
// run: rem(-1.0, 1.0) == 0.0
// run: rem(-1.0, -2.0) == -1.0
// run: rem(-1.0, 0.1) == 0.0
// run: rem(-1.0, 3.0) == -1.0
// run: rem(-1.0, 1e+20) == -1.0
// run: rem(0.1, 1.0) == 0.1
// run: rem(0.1, -2.0) == 0.1
// run: rem(0.1, 0.1) == 0.0
// run: rem(0.1, 3.0) == 0.1
// run: rem(0.1, 1e+20) == 0.1
// run: rem(-0.3, 1.0) == -0.3
// run: rem(-0.3, -2.0) == -0.3
// run: rem(-0.3, 0.1) == 0.0
// run: rem(-0.3, 3.0) == -0.3
// run: rem(-0.3, 1e+20) == -0.3
// run: rem(3.0, 1.0) == 0.0
// run: rem(3.0, -2.0) == 1.0
// run: rem(3.0, 0.1) == 0.0
// run: rem(3.0, 3.0) == 0.0
// run: rem(3.0, 1e+20) == 3.0
// run: rem(16777216.0, 1.0) == 0.0
// run: rem(16777216.0, -2.0) == 0.0
// run: rem(16777216.0, 0.1) == 0.0
// run: rem(16777216.0, 3.0) == 1.0
// run: rem(16777216.0, 1e+20) == 16777216.0
// run: rem(1.677722e+07, 1.0) == 0.0
// run: rem(1.677722e+07, -2.0) == 0.0
// run: rem(1.677722e+07, 0.1) == 0.0
// run: rem(1.677722e+07, 3.0) == 2.0
// run: rem(1.677722e+07, 1e+20) == 1.677722e+07
// run: rem(-7.25, 1.0) == -0.25
// run: rem(-7.25, -2.0) == -1.25
// run: rem(-7.25, 0.1) == -0.049999714
// run: rem(-7.25, 3.0) == -1.25
// run: rem(-7.25, 1e+20) == -7.25
// run: rem(5.5, 1.0) == 0.5
// run: rem(5.5, -2.0) == 1.5
// run: rem(5.5, 0.1) == 0.0
// run: rem(5.5, 3.0) == 2.5
// run: rem(5.5, 1e+20) == 5.5
// run: rem(-5.5, 1.0) == -0.5
// run: rem(-5.5, -2.0) == -1.5
// run: rem(-5.5, 0.1) == 0.0
// run: rem(-5.5, 3.0) == -2.5
// run: rem(-5.5, 1e+20) == -5.5
// run: rem(1e+20, 1.0) == 0.0
// run: rem(1e+20, -2.0) == 0.0
// run: rem(1e+20, 0.1) == 0.0
// run: rem(1e+20, 3.0) == 0.0
// run: rem(1e+20, 1e+20) == 0.0
// run: rem(1.0, 0.0) == nan

fn rem_vec2(x: vec2<f32>, y: vec2<f32>) -> vec2<f32> { return x % y; }
// run: rem_vec2(vec2<f32>(5.5, -5.5), vec2<f32>(2.0, 2.0)) == vec2<f32>(1.5, -1.5)
