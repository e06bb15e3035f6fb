//! Scalar f32: rounding, decomposition, transcendentals, conversions.
//!
//! Invariant: nothing here calls the platform's mathematics library for a function that IEEE 754 does not fix.

/// The NaN of this module: quiet, positive, no payload.
pub const NAN: f32 = f32::from_bits(0x7fc0_0000);

/// Rounds a binary64 result to f32, to nearest even; any NaN becomes [`NAN`].
fn narrow(x: f64) -> f32 {
    if x.is_nan() { NAN } else { x as f32 }
}

macro_rules! through_libm {
    ($($(#[$doc:meta])* $name:ident = $libm:ident;)*) => {$(
        $(#[$doc])*
        #[must_use]
        pub fn $name(x: f32) -> f32 {
            narrow(libm::$libm(f64::from(x)))
        }
    )*};
}

through_libm! {
    /// `sin`: all finite x, with exact argument reduction; ±∞ and NaN give [`NAN`].
    sin = sin;
    /// `cos`: all finite x, with exact argument reduction; ±∞ and NaN give [`NAN`].
    cos = cos;
    /// `tan`: all finite x, with exact argument reduction; ±∞ and NaN give [`NAN`].
    tan = tan;
    /// `asin`: |x| ≤ 1, else [`NAN`]; result in [−π/2, π/2].
    asin = asin;
    /// `acos`: |x| ≤ 1, else [`NAN`]; result in [0, π].
    acos = acos;
    /// `atan`: all x; ±∞ give ±π/2; NaN gives [`NAN`].
    atan = atan;
    /// `sinh`: all x; overflow gives ±∞; NaN gives [`NAN`].
    sinh = sinh;
    /// `cosh`: all x; overflow gives ∞; NaN gives [`NAN`].
    cosh = cosh;
    /// `tanh`: all x; result in [−1, 1]; NaN gives [`NAN`].
    tanh = tanh;
    /// `asinh`: all x; NaN gives [`NAN`].
    asinh = asinh;
    /// `acosh`: x ≥ 1, else [`NAN`].
    acosh = acosh;
    /// `atanh`: |x| ≤ 1, ±1 give ±∞; else [`NAN`].
    atanh = atanh;
    /// `exp`: all x; overflow gives ∞, underflow goes through the subnormals to 0; NaN gives [`NAN`].
    exp = exp;
    /// `exp2`: all x; exact where x is an integer; NaN gives [`NAN`].
    exp2 = exp2;
    /// `log`: x > 0; ±0 give −∞; x < 0 and NaN give [`NAN`].
    log = log;
    /// `log2`: x > 0, exact at powers of two; ±0 give −∞; x < 0 and NaN give [`NAN`].
    log2 = log2;
}

/// `atan2(y, x)`: the angle of (x, y) in [−π, π], with IEEE 754's cases for zeros and infinities; NaN gives [`NAN`].
#[must_use]
pub fn atan2(y: f32, x: f32) -> f32 {
    narrow(libm::atan2(f64::from(y), f64::from(x)))
}

/// `pow(x, y)`: x to the power of y with IEEE 754's cases (`pow(x, 0)` is 1); x < 0 with y not an integer gives
/// [`NAN`].
///
/// WGSL leaves x < 0 and `pow(0, 0)` open (it inherits `exp2(y * log2(x))`); IEEE 754 closes them.
#[must_use]
pub fn pow(x: f32, y: f32) -> f32 {
    narrow(libm::pow(f64::from(x), f64::from(y)))
}

/// `inverseSqrt(x)`: 1/√x correctly rounded for every x > 0; ±0 give ±∞; x < 0 and NaN give [`NAN`].
///
/// Both binary64 operations err by less than 2^−52 relative, and no 1/√x of an f32 lies that near to the middle of two
/// f32 (an exhaustive test over one period of mantissas shows it), so the last rounding decides correctly.
#[must_use]
pub fn inverse_sqrt(x: f32) -> f32 {
    narrow(1.0 / f64::from(x).sqrt())
}

/// `fma(x, y, z)`: x·y + z rounded once.
#[must_use]
pub fn fma(x: f32, y: f32, z: f32) -> f32 {
    libm::fmaf(x, y, z)
}

/// `x % y` of f32: `x - y * trunc(x / y)`, three roundings; not IEEE 754's remainder. y = 0 gives NaN.
#[must_use]
pub fn rem_f32(x: f32, y: f32) -> f32 {
    x - y * (x / y).trunc()
}

/// `floor(x)`, exact; keeps −0.
#[must_use]
pub fn floor(x: f32) -> f32 {
    x.floor()
}

/// `ceil(x)`, exact; (−1, 0) gives −0.
#[must_use]
pub fn ceil(x: f32) -> f32 {
    x.ceil()
}

/// `trunc(x)`, exact; keeps the sign of a zero result.
#[must_use]
pub fn trunc(x: f32) -> f32 {
    x.trunc()
}

/// `round(x)`: to the nearest integer, ties to even; keeps the sign of a zero result.
#[must_use]
pub fn round(x: f32) -> f32 {
    x.round_ties_even()
}

/// `fract(x)`: `x - floor(x)`, in [0, 1]: 1 for tiny negative x, where the difference rounds up. ±∞ give NaN.
#[must_use]
pub fn fract(x: f32) -> f32 {
    x - x.floor()
}

/// `sign(x)`: 1, −1, or +0 for ±0 and NaN.
#[must_use]
pub fn sign_f32(x: f32) -> f32 {
    if x > 0.0 {
        1.0
    } else if x < 0.0 {
        -1.0
    } else {
        0.0
    }
}

/// `min(x, y)`: WGSL's `select(x, y, y < x)`, so equal zeros give x; one NaN gives the other operand.
#[must_use]
pub fn min_f32(x: f32, y: f32) -> f32 {
    if y < x || x.is_nan() { y } else { x }
}

/// `max(x, y)`: WGSL's `select(x, y, x < y)`, so equal zeros give x; one NaN gives the other operand.
#[must_use]
pub fn max_f32(x: f32, y: f32) -> f32 {
    if x < y || x.is_nan() { y } else { x }
}

/// `clamp(x, low, high)`: `min(max(x, low), high)`, also where low > high; NaN x gives low.
#[must_use]
pub fn clamp_f32(x: f32, low: f32, high: f32) -> f32 {
    min_f32(max_f32(x, low), high)
}

/// `saturate(x)`: `clamp(x, 0, 1)`; NaN gives 0, −0 stays.
#[must_use]
pub fn saturate(x: f32) -> f32 {
    clamp_f32(x, 0.0, 1.0)
}

/// `step(edge, x)`: 1 if edge ≤ x, else 0; NaN gives 0.
#[must_use]
pub fn step(edge: f32, x: f32) -> f32 {
    if edge <= x { 1.0 } else { 0.0 }
}

/// `smoothstep(low, high, x)`: `t * t * (3 - 2 * t)` with `t = clamp((x - low) / (high - low), 0, 1)`, as written.
#[must_use]
pub fn smoothstep(low: f32, high: f32, x: f32) -> f32 {
    let t = clamp_f32((x - low) / (high - low), 0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// `mix(x, y, a)`: `x * (1 - a) + y * a`, four roundings.
#[must_use]
pub fn mix(x: f32, y: f32, a: f32) -> f32 {
    x * (1.0 - a) + y * a
}

/// `degrees(x)`: x times the f32 nearest to 180/π.
#[must_use]
pub fn degrees(x: f32) -> f32 {
    x * f32::from_bits(0x4265_2ee1)
}

/// `radians(x)`: x times the f32 nearest to π/180.
#[must_use]
pub fn radians(x: f32) -> f32 {
    x * f32::from_bits(0x3c8e_fa35)
}

/// `ldexp(x, e)`: x·2^e rounded once, for every e: overflow gives ±∞, underflow goes through the subnormals to ±0.
#[must_use]
pub fn ldexp(x: f32, e: i32) -> f32 {
    // Beyond ±300 every finite nonzero f32 has overflowed or vanished, and 2^±300 is a normal binary64.
    let bits = (1023 + i64::from(e.clamp(-300, 300))) as u64;
    narrow(f64::from(x) * f64::from_bits(bits << 52))
}

/// `frexp(x)`: (fraction, exponent) with x = fraction·2^exponent and |fraction| in [0.5, 1).
///
/// Subnormals are normalised; ±0, ±∞ and NaN give themselves and 0.
#[must_use]
pub fn frexp(x: f32) -> (f32, i32) {
    if x == 0.0 || !x.is_finite() {
        return (x, 0);
    }
    // Every finite f32 is a normal binary64.
    let bits = f64::from(x).to_bits();
    let exponent = (bits >> 52 & 0x7ff) as i32 - 1022;
    (f64::from_bits(bits & !(0x7ff << 52) | 1022 << 52) as f32, exponent)
}

/// `modf(x)`: (fract, whole) with whole = `trunc(x)` and fract = `x - trunc(x)`, exact; ±∞ give a NaN fract.
#[must_use]
pub fn modf(x: f32) -> (f32, f32) {
    (x - x.trunc(), x.trunc())
}

/// `i32(x)`: x clamped to [−2147483648, 2147483520], the f32 in range, then truncated; NaN gives 0.
#[must_use]
pub fn f32_to_i32(x: f32) -> i32 {
    x.min(2_147_483_520.0) as i32 * i32::from(!x.is_nan())
}

/// `u32(x)`: x clamped to [0, 4294967040], the f32 in range, then truncated; NaN gives 0.
#[must_use]
pub fn f32_to_u32(x: f32) -> u32 {
    x.min(4_294_967_040.0) as u32 * u32::from(!x.is_nan())
}

/// `f32(x)` of i32: to nearest even.
#[must_use]
pub fn i32_to_f32(x: i32) -> f32 {
    x as f32
}

/// `f32(x)` of u32: to nearest even.
#[must_use]
pub fn u32_to_f32(x: u32) -> f32 {
    x as f32
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bits(x: f32) -> u32 {
        x.to_bits()
    }

    #[test]
    fn transcendentals_of_known_points() {
        assert_eq!(bits(sin(1.0)), 0x3f57_6aa4);
        assert_eq!(bits(cos(1.0)), 0x3f0a_5140);
        assert_eq!(bits(tan(1.0)), 0x3fc7_5923);
        assert_eq!(bits(exp(1.0)), 0x402d_f854);
        assert_eq!(bits(log(2.0)), 0x3f31_7218);
        assert_eq!(bits(asin(1.0)), 0x3fc9_0fdb);
        assert_eq!(bits(acos(-1.0)), 0x4049_0fdb);
        assert_eq!(bits(atan2(-0.0, -1.0)), 0xc049_0fdb);
        assert_eq!(bits(atan2(1.0, 1.0)), 0x3f49_0fdb);
        assert_eq!(bits(sinh(1.0)), 0x3f96_6cfe);
        assert_eq!(bits(cosh(1.0)), 0x3fc5_83ab);
        assert_eq!(bits(tanh(1.0)), 0x3f42_f7d6);
        assert_eq!(exp2(-149.0), f32::from_bits(1));
        assert_eq!(exp2(128.0), f32::INFINITY);
        assert_eq!(log2(f32::from_bits(1)), -149.0);
        assert_eq!(pow(2.0, 0.5), std::f32::consts::SQRT_2);
        assert_eq!(pow(-2.0, 3.0), -8.0);
        assert_eq!(pow(0.0, 0.0), 1.0);
        assert_eq!(asinh(0.0), 0.0);
        assert_eq!(acosh(1.0), 0.0);
        assert_eq!(atanh(1.0), f32::INFINITY);
    }

    #[test]
    fn outside_the_domain_is_one_nan() {
        let all = [sin(f32::INFINITY), asin(1.5), acosh(0.5), log(-1.0), pow(-1.0, 0.5), inverse_sqrt(-1.0)];
        for x in all.into_iter().chain([exp(f32::from_bits(0xffff_ffff)), atanh(-2.0), log2(-0.5)]) {
            assert_eq!(bits(x), 0x7fc0_0000);
        }
        assert_eq!(log(-0.0), f32::NEG_INFINITY);
    }

    /// The exact order of y's upper neighbour midpoint and 1/√x, in integers: m²·x against 1.
    fn midpoint_squared_exceeds(y: f32, x: f32) -> bool {
        let parts = |v: f32| {
            let (f, e) = frexp(v);
            ((f64::from(f) * f64::from(1u32 << 24)) as u128, e - 24)
        };
        let ((my, ey), (mx, ex)) = (parts(y), parts(x));
        let product = (2 * my + 1).pow(2) * mx;
        let exponent = 2 * (ey - 1) + ex;
        assert!((-127..0).contains(&exponent));
        product > 1 << -exponent
    }

    #[test]
    fn inverse_sqrt_is_correctly_rounded_everywhere() {
        // Two binades are one period: scaling x by 4 halves the result exactly.
        for bits in 0x3f80_0000..0x4080_0000u32 {
            let x = f32::from_bits(bits);
            let y = inverse_sqrt(x);
            assert!(midpoint_squared_exceeds(y, x), "too small at {bits:#x}");
            assert!(!midpoint_squared_exceeds(y.next_down(), x), "too large at {bits:#x}");
        }
        assert_eq!(inverse_sqrt(f32::from_bits(1)), f32::from_bits(0x64b5_04f3));
        assert_eq!(inverse_sqrt(0.0), f32::INFINITY);
        assert_eq!(inverse_sqrt(-0.0), f32::NEG_INFINITY);
        assert_eq!(bits(inverse_sqrt(f32::INFINITY)), 0);
    }

    #[test]
    fn fused_is_not_two_roundings() {
        let x = 1.0 + f32::EPSILON;
        assert_eq!(fma(x, x, -1.0), 2.0 * f32::EPSILON + f32::EPSILON * f32::EPSILON);
        assert_eq!(x * x - 1.0, 2.0 * f32::EPSILON);
    }

    #[test]
    fn rounding_and_parts() {
        assert_eq!([round(0.5), round(1.5), round(2.5), round(-2.5)], [0.0, 2.0, 2.0, -2.0]);
        assert_eq!(bits(round(-0.25)), 0x8000_0000);
        assert_eq!(bits(fract(-1e-9)), bits(1.0));
        assert_eq!(fract(-1.25), 0.75);
        assert_eq!(modf(-1.25), (-0.25, -1.0));
        assert_eq!(bits(modf(-1.0).0), 0);
        assert_eq!(frexp(-6.0), (-0.75, 3));
        assert_eq!(frexp(f32::from_bits(1)), (0.5, -148));
        assert_eq!(frexp(f32::MAX), (1.0f32.next_down(), 128));
        assert_eq!(frexp(f32::INFINITY), (f32::INFINITY, 0));
        assert_eq!(ldexp(0.75, 3), 6.0);
        assert_eq!(ldexp(1.0, i32::MAX), f32::INFINITY);
        assert_eq!(bits(ldexp(-1.0, i32::MIN)), 0x8000_0000);
        assert_eq!(bits(ldexp(1.5, -149)), 2);
        assert_eq!(ldexp(f32::from_bits(1), 149), 1.0);
        assert_eq!(rem_f32(-5.5, 2.0), -1.5);
        assert_eq!(degrees(1.0), 57.295_78);
        assert_eq!(radians(180.0), std::f32::consts::PI);
    }

    #[test]
    fn order_of_zeros_and_nan() {
        assert_eq!([bits(min_f32(0.0, -0.0)), bits(min_f32(-0.0, 0.0))], [0, 0x8000_0000]);
        assert_eq!([bits(max_f32(0.0, -0.0)), bits(max_f32(-0.0, 0.0))], [0, 0x8000_0000]);
        assert_eq!([min_f32(NAN, 1.0), min_f32(1.0, NAN), max_f32(NAN, 1.0), max_f32(1.0, NAN)], [1.0; 4]);
        assert_eq!(clamp_f32(NAN, 2.0, 3.0), 2.0);
        assert_eq!(clamp_f32(5.0, 3.0, 2.0), 2.0);
        assert_eq!([sign_f32(-3.0), sign_f32(1e-45), sign_f32(NAN)], [-1.0, 1.0, 0.0]);
        assert_eq!([step(1.0, 1.0), step(1.0, 0.5), step(NAN, 0.5)], [1.0, 0.0, 0.0]);
        assert_eq!([saturate(NAN), saturate(7.0), saturate(-7.0)], [0.0, 1.0, 0.0]);
        assert_eq!([smoothstep(0.0, 2.0, 1.0), smoothstep(0.0, 2.0, 9.0)], [0.5, 1.0]);
        assert_eq!(mix(2.0, 4.0, 0.25), 2.5);
    }

    #[test]
    fn conversions_clamp_to_the_floats_in_range() {
        assert_eq!([f32_to_u32(1e20), f32_to_u32(f32::INFINITY)], [4_294_967_040; 2]);
        assert_eq!([f32_to_u32(-1.0), f32_to_u32(NAN), f32_to_u32(2.9)], [0, 0, 2]);
        assert_eq!([f32_to_i32(1e20), f32_to_i32(-1e20)], [2_147_483_520, i32::MIN]);
        assert_eq!([f32_to_i32(-2.9), f32_to_i32(NAN), f32_to_i32(-NAN)], [-2, 0, 0]);
        assert_eq!([i32_to_f32(16_777_217), i32_to_f32(-16_777_219)], [16_777_216.0, -16_777_220.0]);
        assert_eq!(u32_to_f32(u32::MAX), 4_294_967_296.0);
    }
}
