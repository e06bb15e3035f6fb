// Packing and unpacking, over the formulas of the specification; packed dot products.

fn test_pack4x8snorm(e: vec4<f32>) -> u32 { return pack4x8snorm(e); }
// run: test_pack4x8snorm(vec4<f32>(0.0, 1.0, -1.0, 0.5)) == 0x40817f00u
// run: test_pack4x8snorm(vec4<f32>(0.1, -0.1, 0.0039215, 0.9999)) == 0x7f00f30du
// run: test_pack4x8snorm(vec4<f32>(5.0, -5.0, bitcast<f32>(0x7fc00000u), -0.5)) == 0xc181817fu
// run: test_pack4x8snorm(vec4<f32>(0.0019607842, 0.0019607844, 0.003921569, 0.5)) == 0x40000000u
// run: test_pack4x8snorm(vec4<f32>(0.25, 0.75, -0.25, -0.75)) == 0xa1e05f20u
// run: test_pack4x8snorm(vec4<f32>(bitcast<f32>(0x7f800000u), bitcast<f32>(0xff800000u), bitcast<f32>(0x00000001u), -0.0)) == 33151u

fn test_pack4x8unorm(e: vec4<f32>) -> u32 { return pack4x8unorm(e); }
// run: test_pack4x8unorm(vec4<f32>(0.0, 1.0, -1.0, 0.5)) == 0x8000ff00u
// run: test_pack4x8unorm(vec4<f32>(0.1, -0.1, 0.0039215, 0.9999)) == 0xff01001au
// run: test_pack4x8unorm(vec4<f32>(5.0, -5.0, bitcast<f32>(0x7fc00000u), -0.5)) == 255u
// run: test_pack4x8unorm(vec4<f32>(0.0019607842, 0.0019607844, 0.003921569, 0.5)) == 0x80010100u
// run: test_pack4x8unorm(vec4<f32>(0.25, 0.75, -0.25, -0.75)) == 48960u
// run: test_pack4x8unorm(vec4<f32>(bitcast<f32>(0x7f800000u), bitcast<f32>(0xff800000u), bitcast<f32>(0x00000001u), -0.0)) == 255u

fn test_pack2x16snorm(e: vec2<f32>) -> u32 { return pack2x16snorm(e); }
// run: test_pack2x16snorm(vec2<f32>(0.0, 1.0)) == 0x7fff0000u
// run: test_pack2x16snorm(vec2<f32>(-1.0, 0.5)) == 0x40008001u
// run: test_pack2x16snorm(vec2<f32>(0.1, -0.1)) == 0xf3330ccdu
// run: test_pack2x16snorm(vec2<f32>(0.0039215, 0.9999)) == 0x7ffc0080u
// run: test_pack2x16snorm(vec2<f32>(5.0, -5.0)) == 0x80017fffu
// run: test_pack2x16snorm(vec2<f32>(bitcast<f32>(0x7fc00000u), -0.5)) == 0xc0018001u
// run: test_pack2x16snorm(vec2<f32>(0.0019607842, 0.0019607844)) == 0x00400040u
// run: test_pack2x16snorm(vec2<f32>(0.003921569, 0.5)) == 0x40000080u
// run: test_pack2x16snorm(vec2<f32>(0.25, 0.75)) == 0x5fff2000u
// run: test_pack2x16snorm(vec2<f32>(-0.25, -0.75)) == 0xa001e000u
// run: test_pack2x16snorm(vec2<f32>(bitcast<f32>(0x7f800000u), bitcast<f32>(0xff800000u))) == 0x80017fffu
// run: test_pack2x16snorm(vec2<f32>(bitcast<f32>(0x00000001u), -0.0)) == 0u

fn test_pack2x16unorm(e: vec2<f32>) -> u32 { return pack2x16unorm(e); }
// run: test_pack2x16unorm(vec2<f32>(0.0, 1.0)) == 0xffff0000u
// run: test_pack2x16unorm(vec2<f32>(-1.0, 0.5)) == 0x80000000u
// run: test_pack2x16unorm(vec2<f32>(0.1, -0.1)) == 6554u
// run: test_pack2x16unorm(vec2<f32>(0.0039215, 0.9999)) == 0xfff80101u
// run: test_pack2x16unorm(vec2<f32>(5.0, -5.0)) == 65535u
// run: test_pack2x16unorm(vec2<f32>(bitcast<f32>(0x7fc00000u), -0.5)) == 0u
// run: test_pack2x16unorm(vec2<f32>(0.0019607842, 0.0019607844)) == 0x00810080u
// run: test_pack2x16unorm(vec2<f32>(0.003921569, 0.5)) == 0x80000101u
// run: test_pack2x16unorm(vec2<f32>(0.25, 0.75)) == 0xbfff4000u
// run: test_pack2x16unorm(vec2<f32>(-0.25, -0.75)) == 0u
// run: test_pack2x16unorm(vec2<f32>(bitcast<f32>(0x7f800000u), bitcast<f32>(0xff800000u))) == 65535u
// run: test_pack2x16unorm(vec2<f32>(bitcast<f32>(0x00000001u), -0.0)) == 0u

fn test_pack2x16float(e: vec2<f32>) -> u32 { return pack2x16float(e); }
// run: test_pack2x16float(vec2<f32>(1.0, -2.0)) == 0xc0003c00u
// run: test_pack2x16float(vec2<f32>(0.1, 0.33333334)) == 0x35552e66u
// run: test_pack2x16float(vec2<f32>(65504.0, 6.552e+04)) == 0x7c007bffu
// run: test_pack2x16float(vec2<f32>(1e-08, 6e-08)) == 0x00010000u
// run: test_pack2x16float(vec2<f32>(-0.0, bitcast<f32>(0x7f800000u))) == 0x7c008000u
// run: test_pack2x16float(vec2<f32>(1.0004883, 1.0014648)) == 0x3c023c00u
// run: test_pack2x16float(vec2<f32>(-6.1e-05, 6.1020255e-05)) == 0x040083ffu

fn test_unpack4x8snorm(x: u32) -> vec4<f32> { return unpack4x8snorm(x); }
// run: test_unpack4x8snorm(0u) == vec4<f32>(0.0, 0.0, 0.0, 0.0)
// run: test_unpack4x8snorm(0xffffffffu) == vec4<f32>(-0.007874016, -0.007874016, -0.007874016, -0.007874016)
// run: test_unpack4x8snorm(0x80007fffu) == vec4<f32>(-0.007874016, 1.0, 0.0, -1.0)
// run: test_unpack4x8snorm(0x12345678u) == vec4<f32>(0.9448819, 0.6771653, 0.40944883, 0.14173229)
// run: test_unpack4x8snorm(0x81818181u) == vec4<f32>(-1.0, -1.0, -1.0, -1.0)
// run: test_unpack4x8snorm(0x7f80ff01u) == vec4<f32>(0.007874016, -0.007874016, -1.0, 1.0)
// run: test_unpack4x8snorm(0x3c00bc00u) == vec4<f32>(0.0, -0.53543305, 0.0, 0.47244096)
// run: test_unpack4x8snorm(0x0001fc00u) == vec4<f32>(0.0, -0.031496063, 0.007874016, 0.0)
// run: test_unpack4x8snorm(0x83ff7bffu) == vec4<f32>(-0.007874016, 0.96850395, -0.007874016, -0.984252)

fn test_unpack4x8unorm(x: u32) -> vec4<f32> { return unpack4x8unorm(x); }
// run: test_unpack4x8unorm(0u) == vec4<f32>(0.0, 0.0, 0.0, 0.0)
// run: test_unpack4x8unorm(0xffffffffu) == vec4<f32>(1.0, 1.0, 1.0, 1.0)
// run: test_unpack4x8unorm(0x80007fffu) == vec4<f32>(1.0, 0.49803922, 0.0, 0.5019608)
// run: test_unpack4x8unorm(0x12345678u) == vec4<f32>(0.47058824, 0.3372549, 0.20392157, 0.07058824)
// run: test_unpack4x8unorm(0x81818181u) == vec4<f32>(0.5058824, 0.5058824, 0.5058824, 0.5058824)
// run: test_unpack4x8unorm(0x7f80ff01u) == vec4<f32>(0.003921569, 1.0, 0.5019608, 0.49803922)
// run: test_unpack4x8unorm(0x3c00bc00u) == vec4<f32>(0.0, 0.7372549, 0.0, 0.23529412)
// run: test_unpack4x8unorm(0x0001fc00u) == vec4<f32>(0.0, 0.9882353, 0.003921569, 0.0)
// run: test_unpack4x8unorm(0x83ff7bffu) == vec4<f32>(1.0, 0.48235294, 1.0, 0.5137255)

fn test_unpack2x16snorm(x: u32) -> vec2<f32> { return unpack2x16snorm(x); }
// run: test_unpack2x16snorm(0u) == vec2<f32>(0.0, 0.0)
// run: test_unpack2x16snorm(0xffffffffu) == vec2<f32>(-3.051851e-05, -3.051851e-05)
// run: test_unpack2x16snorm(0x80007fffu) == vec2<f32>(1.0, -1.0)
// run: test_unpack2x16snorm(0x12345678u) == vec2<f32>(0.67555773, 0.14221625)
// run: test_unpack2x16snorm(0x81818181u) == vec2<f32>(-0.9882809, -0.9882809)
// run: test_unpack2x16snorm(0x7f80ff01u) == vec2<f32>(-0.00778222, 0.99612415)
// run: test_unpack2x16snorm(0x3c00bc00u) == vec2<f32>(-0.5312662, 0.4687643)
// run: test_unpack2x16snorm(0x0001fc00u) == vec2<f32>(-0.031250954, 3.051851e-05)
// run: test_unpack2x16snorm(0x83ff7bffu) == vec2<f32>(0.96874905, -0.9688101)

fn test_unpack2x16unorm(x: u32) -> vec2<f32> { return unpack2x16unorm(x); }
// run: test_unpack2x16unorm(0u) == vec2<f32>(0.0, 0.0)
// run: test_unpack2x16unorm(0xffffffffu) == vec2<f32>(1.0, 1.0)
// run: test_unpack2x16unorm(0x80007fffu) == vec2<f32>(0.49999237, 0.5000076)
// run: test_unpack2x16unorm(0x12345678u) == vec2<f32>(0.3377737, 0.071107045)
// run: test_unpack2x16unorm(0x81818181u) == vec2<f32>(0.5058824, 0.5058824)
// run: test_unpack2x16unorm(0x7f80ff01u) == vec2<f32>(0.9961242, 0.49805447)
// run: test_unpack2x16unorm(0x3c00bc00u) == vec2<f32>(0.7343862, 0.23437858)
// run: test_unpack2x16unorm(0x0001fc00u) == vec2<f32>(0.98439, 1.5259022e-05)
// run: test_unpack2x16unorm(0x83ff7bffu) == vec2<f32>(0.48436713, 0.5156176)

fn test_unpack2x16float(x: u32) -> vec2<f32> { return unpack2x16float(x); }
// run: test_unpack2x16float(0u) == vec2<f32>(0.0, 0.0)
// run: test_unpack2x16float(0x12345678u) == vec2<f32>(103.5, 0.0007572174)
// run: test_unpack2x16float(0x81818181u) == vec2<f32>(-2.2947788e-05, -2.2947788e-05)
// run: test_unpack2x16float(0x7f80ff01u) == vec2<f32>(nan, nan)
// run: test_unpack2x16float(0x3c00bc00u) == vec2<f32>(-1.0, 1.0)
// run: test_unpack2x16float(0x0001fc00u) == vec2<f32>(bitcast<f32>(0xff800000u), 5.9604645e-08)
// run: test_unpack2x16float(0x83ff7bffu) == vec2<f32>(65504.0, -6.097555e-05)

fn test_unpack4xI8(x: u32) -> vec4<i32> { return unpack4xI8(x); }

fn test_unpack4xU8(x: u32) -> vec4<u32> { return unpack4xU8(x); }
// run: test_unpack4xI8(0u) == vec4<i32>(0i, 0i, 0i, 0i)
// run: test_unpack4xU8(0u) == vec4<u32>(0u, 0u, 0u, 0u)
// run: test_unpack4xI8(0xffffffffu) == vec4<i32>(-1i, -1i, -1i, -1i)
// run: test_unpack4xU8(0xffffffffu) == vec4<u32>(255u, 255u, 255u, 255u)
// run: test_unpack4xI8(0x80007fffu) == vec4<i32>(-1i, 127i, 0i, -128i)
// run: test_unpack4xU8(0x80007fffu) == vec4<u32>(255u, 127u, 0u, 128u)
// run: test_unpack4xI8(0x12345678u) == vec4<i32>(120i, 86i, 52i, 18i)
// run: test_unpack4xU8(0x12345678u) == vec4<u32>(120u, 86u, 52u, 18u)
// run: test_unpack4xI8(0x81818181u) == vec4<i32>(-127i, -127i, -127i, -127i)
// run: test_unpack4xU8(0x81818181u) == vec4<u32>(129u, 129u, 129u, 129u)
// run: test_unpack4xI8(0x7f80ff01u) == vec4<i32>(1i, -1i, -128i, 127i)
// run: test_unpack4xU8(0x7f80ff01u) == vec4<u32>(1u, 255u, 128u, 127u)
// run: test_unpack4xI8(0x3c00bc00u) == vec4<i32>(0i, -68i, 0i, 60i)
// run: test_unpack4xU8(0x3c00bc00u) == vec4<u32>(0u, 188u, 0u, 60u)
// run: test_unpack4xI8(0x0001fc00u) == vec4<i32>(0i, -4i, 1i, 0i)
// run: test_unpack4xU8(0x0001fc00u) == vec4<u32>(0u, 252u, 1u, 0u)
// run: test_unpack4xI8(0x83ff7bffu) == vec4<i32>(-1i, 123i, -1i, -125i)
// run: test_unpack4xU8(0x83ff7bffu) == vec4<u32>(255u, 123u, 255u, 131u)

fn test_pack4xI8(x: vec4<i32>) -> u32 { return pack4xI8(x); }
// run: test_pack4xI8(vec4<i32>(0i, 1i, -1i, 2i)) == 0x02ff0100u
// run: test_pack4xI8(vec4<i32>(2i, -2i, 7i, -7i)) == 0xf907fe02u
// run: test_pack4xI8(vec4<i32>(-7i, 100i, 2147483647i, -2147483648i)) == 0x00ff64f9u
// run: test_pack4xI8(vec4<i32>(-2147483648i, -2147483647i, 305419896i, -305419896i)) == 0x88780100u
// run: test_pack4xI8(vec4<i32>(-129i, 128i, 127i, -128i)) == 0x807f807fu

fn test_pack4xI8Clamp(x: vec4<i32>) -> u32 { return pack4xI8Clamp(x); }
// run: test_pack4xI8Clamp(vec4<i32>(0i, 1i, -1i, 2i)) == 0x02ff0100u
// run: test_pack4xI8Clamp(vec4<i32>(2i, -2i, 7i, -7i)) == 0xf907fe02u
// run: test_pack4xI8Clamp(vec4<i32>(-7i, 100i, 2147483647i, -2147483648i)) == 0x807f64f9u
// run: test_pack4xI8Clamp(vec4<i32>(-2147483648i, -2147483647i, 305419896i, -305419896i)) == 0x807f8080u
// run: test_pack4xI8Clamp(vec4<i32>(-129i, 128i, 127i, -128i)) == 0x807f7f80u

fn test_pack4xU8(x: vec4<u32>) -> u32 { return pack4xU8(x); }
// run: test_pack4xU8(vec4<u32>(0u, 1u, 2u, 7u)) == 0x07020100u
// run: test_pack4xU8(vec4<u32>(7u, 100u, 0x7fffffffu, 0x80000000u)) == 0x00ff6407u
// run: test_pack4xU8(vec4<u32>(0x80000000u, 0x80000001u, 0xffffffffu, 0xfffffffeu)) == 0xfeff0100u
// run: test_pack4xU8(vec4<u32>(0xfffffffeu, 0x12345678u, 0xaaaaaaaau, 0x00010000u)) == 0x00aa78feu
// run: test_pack4xU8(vec4<u32>(254u, 255u, 256u, 257u)) == 0x0100fffeu

fn test_pack4xU8Clamp(x: vec4<u32>) -> u32 { return pack4xU8Clamp(x); }
// run: test_pack4xU8Clamp(vec4<u32>(0u, 1u, 2u, 7u)) == 0x07020100u
// run: test_pack4xU8Clamp(vec4<u32>(7u, 100u, 0x7fffffffu, 0x80000000u)) == 0xffff6407u
// run: test_pack4xU8Clamp(vec4<u32>(0x80000000u, 0x80000001u, 0xffffffffu, 0xfffffffeu)) == 0xffffffffu
// run: test_pack4xU8Clamp(vec4<u32>(0xfffffffeu, 0x12345678u, 0xaaaaaaaau, 0x00010000u)) == 0xffffffffu
// run: test_pack4xU8Clamp(vec4<u32>(254u, 255u, 256u, 257u)) == 0xfffffffeu

fn test_dot4I8Packed(x: u32, y: u32) -> i32 { return dot4I8Packed(x, y); }

fn test_dot4U8Packed(x: u32, y: u32) -> u32 { return dot4U8Packed(x, y); }
// run: test_dot4I8Packed(0u, 0u) == 0i
// run: test_dot4U8Packed(0u, 0u) == 0u
// run: test_dot4I8Packed(0u, 0x80007fffu) == 0i
// run: test_dot4U8Packed(0u, 0x80007fffu) == 0u
// run: test_dot4I8Packed(0u, 0x81818181u) == 0i
// run: test_dot4U8Packed(0u, 0x81818181u) == 0u
// run: test_dot4I8Packed(0u, 0x3c00bc00u) == 0i
// run: test_dot4U8Packed(0u, 0x3c00bc00u) == 0u
// run: test_dot4I8Packed(0u, 0x83ff7bffu) == 0i
// run: test_dot4U8Packed(0u, 0x83ff7bffu) == 0u
// run: test_dot4I8Packed(0xffffffffu, 0u) == 0i
// run: test_dot4U8Packed(0xffffffffu, 0u) == 0u
// run: test_dot4I8Packed(0xffffffffu, 0x80007fffu) == 2i
// run: test_dot4U8Packed(0xffffffffu, 0x80007fffu) == 0x0001fc02u
// run: test_dot4I8Packed(0xffffffffu, 0x81818181u) == 508i
// run: test_dot4U8Packed(0xffffffffu, 0x81818181u) == 0x000201fcu
// run: test_dot4I8Packed(0xffffffffu, 0x3c00bc00u) == 8i
// run: test_dot4U8Packed(0xffffffffu, 0x3c00bc00u) == 63240u
// run: test_dot4I8Packed(0xffffffffu, 0x83ff7bffu) == 4i
// run: test_dot4U8Packed(0xffffffffu, 0x83ff7bffu) == 0x0002f904u
// run: test_dot4I8Packed(0x80007fffu, 0u) == 0i
// run: test_dot4U8Packed(0x80007fffu, 0u) == 0u
// run: test_dot4I8Packed(0x80007fffu, 0x80007fffu) == 32514i
// run: test_dot4U8Packed(0x80007fffu, 0x80007fffu) == 0x00017d02u
// run: test_dot4I8Packed(0x80007fffu, 0x81818181u) == 254i
// run: test_dot4U8Packed(0x80007fffu, 0x81818181u) == 0x000100feu
// run: test_dot4I8Packed(0x80007fffu, 0x3c00bc00u) == -16316i
// run: test_dot4U8Packed(0x80007fffu, 0x3c00bc00u) == 31556u
// run: test_dot4I8Packed(0x80007fffu, 0x83ff7bffu) == 31622i
// run: test_dot4U8Packed(0x80007fffu, 0x83ff7bffu) == 0x00017c86u
// run: test_dot4I8Packed(0x12345678u, 0u) == 0i
// run: test_dot4U8Packed(0x12345678u, 0u) == 0u
// run: test_dot4I8Packed(0x12345678u, 0x80007fffu) == 8498i
// run: test_dot4U8Packed(0x12345678u, 0x80007fffu) == 43826u
// run: test_dot4I8Packed(0x12345678u, 0x81818181u) == -35052i
// run: test_dot4U8Packed(0x12345678u, 0x81818181u) == 35604u
// run: test_dot4I8Packed(0x12345678u, 0x3c00bc00u) == -4768i
// run: test_dot4U8Packed(0x12345678u, 0x3c00bc00u) == 17248u
// run: test_dot4I8Packed(0x12345678u, 0x83ff7bffu) == 8156i
// run: test_dot4U8Packed(0x12345678u, 0x83ff7bffu) == 56796u
// run: test_dot4I8Packed(0x81818181u, 0u) == 0i
// run: test_dot4U8Packed(0x81818181u, 0u) == 0u
// run: test_dot4I8Packed(0x81818181u, 0x80007fffu) == 254i
// run: test_dot4U8Packed(0x81818181u, 0x80007fffu) == 0x000100feu
// run: test_dot4I8Packed(0x81818181u, 0x81818181u) == 64516i
// run: test_dot4U8Packed(0x81818181u, 0x81818181u) == 0x00010404u
// run: test_dot4I8Packed(0x81818181u, 0x3c00bc00u) == 1016i
// run: test_dot4U8Packed(0x81818181u, 0x3c00bc00u) == 31992u
// run: test_dot4I8Packed(0x81818181u, 0x83ff7bffu) == 508i
// run: test_dot4U8Packed(0x81818181u, 0x83ff7bffu) == 0x000180fcu
// run: test_dot4I8Packed(0x7f80ff01u, 0u) == 0i
// run: test_dot4U8Packed(0x7f80ff01u, 0u) == 0u
// run: test_dot4I8Packed(0x7f80ff01u, 0x80007fffu) == -16384i
// run: test_dot4U8Packed(0x7f80ff01u, 0x80007fffu) == 48896u
// run: test_dot4I8Packed(0x7f80ff01u, 0x81818181u) == 127i
// run: test_dot4U8Packed(0x7f80ff01u, 0x81818181u) == 0x0001017fu
// run: test_dot4I8Packed(0x7f80ff01u, 0x3c00bc00u) == 7688i
// run: test_dot4U8Packed(0x7f80ff01u, 0x3c00bc00u) == 55560u
// run: test_dot4I8Packed(0x7f80ff01u, 0x83ff7bffu) == -15871i
// run: test_dot4U8Packed(0x7f80ff01u, 0x83ff7bffu) == 0x00013c01u
// run: test_dot4I8Packed(0x3c00bc00u, 0u) == 0i
// run: test_dot4U8Packed(0x3c00bc00u, 0u) == 0u
// run: test_dot4I8Packed(0x3c00bc00u, 0x80007fffu) == -16316i
// run: test_dot4U8Packed(0x3c00bc00u, 0x80007fffu) == 31556u
// run: test_dot4I8Packed(0x3c00bc00u, 0x81818181u) == 1016i
// run: test_dot4U8Packed(0x3c00bc00u, 0x81818181u) == 31992u
// run: test_dot4I8Packed(0x3c00bc00u, 0x3c00bc00u) == 8224i
// run: test_dot4U8Packed(0x3c00bc00u, 0x3c00bc00u) == 38944u
// run: test_dot4I8Packed(0x3c00bc00u, 0x83ff7bffu) == -15864i
// run: test_dot4U8Packed(0x3c00bc00u, 0x83ff7bffu) == 30984u
// run: test_dot4I8Packed(0x0001fc00u, 0u) == 0i
// run: test_dot4U8Packed(0x0001fc00u, 0u) == 0u
// run: test_dot4I8Packed(0x0001fc00u, 0x80007fffu) == -508i
// run: test_dot4U8Packed(0x0001fc00u, 0x80007fffu) == 32004u
// run: test_dot4I8Packed(0x0001fc00u, 0x81818181u) == 381i
// run: test_dot4U8Packed(0x0001fc00u, 0x81818181u) == 32637u
// run: test_dot4I8Packed(0x0001fc00u, 0x3c00bc00u) == 272i
// run: test_dot4U8Packed(0x0001fc00u, 0x3c00bc00u) == 47376u
// run: test_dot4I8Packed(0x0001fc00u, 0x83ff7bffu) == -493i
// run: test_dot4U8Packed(0x0001fc00u, 0x83ff7bffu) == 31251u
// run: test_dot4I8Packed(0x83ff7bffu, 0u) == 0i
// run: test_dot4U8Packed(0x83ff7bffu, 0u) == 0u
// run: test_dot4I8Packed(0x83ff7bffu, 0x80007fffu) == 31622i
// run: test_dot4U8Packed(0x83ff7bffu, 0x80007fffu) == 0x00017c86u
// run: test_dot4I8Packed(0x83ff7bffu, 0x81818181u) == 508i
// run: test_dot4U8Packed(0x83ff7bffu, 0x81818181u) == 0x000180fcu
// run: test_dot4I8Packed(0x83ff7bffu, 0x3c00bc00u) == -15864i
// run: test_dot4U8Packed(0x83ff7bffu, 0x3c00bc00u) == 30984u
// run: test_dot4I8Packed(0x83ff7bffu, 0x83ff7bffu) == 30756i
// run: test_dot4U8Packed(0x83ff7bffu, 0x83ff7bffu) == 0x00027a24u
