//! Which numbers an f32 operation may return under WGSL: intervals, computed in f64 and widened by what the
//! specification's accuracy table permits.
//!
//! The table's entries are bounds on one operation; "inherited from" entries are computed from the expression that they
//! name. A value that the specification leaves open (NaN, infinity, overflow, an argument outside a function's accurate
//! range) is [`Interval::ANY`]. Subnormal numbers may be flushed on the way in and out; rounding may go to either
//! neighbour, and sums and products of inexact terms may be reassociated or fused, which an interval of the real value
//! covers.

/// Numbers from `low` to `high`; both infinite where nothing is promised.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Interval {
    pub low: f64,
    pub high: f64,
}

const SMALLEST_NORMAL: f64 = f32::MIN_POSITIVE as f64;

/// Distance between neighbouring f32 at `x`.
fn ulp(x: f64) -> f64 {
    let magnitude = x.abs().max(SMALLEST_NORMAL);
    libm::exp2(f64::from(libm::ilogb(magnitude) - 23))
}

impl Interval {
    /// Nothing is promised.
    pub(crate) const ANY: Interval = Interval { low: f64::NEG_INFINITY, high: f64::INFINITY };

    /// One number.
    pub(crate) const fn exactly(x: f64) -> Self {
        Interval { low: x, high: x }
    }

    /// What an operation may read where memory holds these bits.
    pub(crate) fn of_bits(bits: u32) -> Self {
        let x = f32::from_bits(bits);
        match x.classify() {
            std::num::FpCategory::Nan | std::num::FpCategory::Infinite => Self::ANY,
            _ => Self::exactly(f64::from(x)).flushed(),
        }
    }

    fn between(a: f64, b: f64) -> Self {
        Interval { low: a.min(b), high: a.max(b) }
    }

    /// With zero, where it has a subnormal number.
    fn flushed(self) -> Self {
        let near = self.low < SMALLEST_NORMAL && self.high > -SMALLEST_NORMAL;
        if near { Interval { low: self.low.min(0.0), high: self.high.max(0.0) } } else { self }
    }

    /// Overflow is anything.
    fn bounded(self) -> Self {
        let fits = self.low >= f64::from(f32::MIN) && self.high <= f64::from(f32::MAX);
        if fits { self.flushed() } else { Self::ANY }
    }

    /// Off by so many units in the last place.
    pub(crate) fn ulps(self, n: f64) -> Self {
        Interval { low: self.low - n * ulp(self.low), high: self.high + n * ulp(self.high) }.bounded()
    }

    /// Off by so much.
    pub(crate) fn within(self, error: f64) -> Self {
        Interval { low: self.low - error, high: self.high + error }.bounded()
    }

    /// Rounded to either neighbour; not at all where f32 holds the result.
    pub(crate) fn rounded(self) -> Self {
        let held = |x: f64| f64::from(x as f32) == x;
        let low = if held(self.low) { self.low } else { self.low - ulp(self.low) };
        let high = if held(self.high) { self.high } else { self.high + ulp(self.high) };
        Interval { low, high }.bounded()
    }

    /// Whether nothing is promised.
    pub(crate) fn is_any(self) -> bool {
        self == Self::ANY
    }

    /// Whether a machine may give these bits.
    pub(crate) fn holds(self, bits: u32) -> bool {
        let x = f64::from(f32::from_bits(bits));
        self.is_any() || (self.low..=self.high).contains(&x)
    }

    /// Every number of either.
    pub(crate) fn or(self, other: Self) -> Self {
        Interval { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// The image under a function that grows (or falls) over the whole interval and is exact.
    pub(crate) fn monotone(self, f: impl Fn(f64) -> f64) -> Self {
        if self.is_any() { self } else { Self::between(f(self.low), f(self.high)).flushed() }
    }

    /// The same for two operands.
    pub(crate) fn monotone2(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        if self.is_any() || other.is_any() {
            return Self::ANY;
        }
        let corners =
            [f(self.low, other.low), f(self.low, other.high), f(self.high, other.low), f(self.high, other.high)];
        Interval {
            low: corners.into_iter().fold(f64::INFINITY, f64::min),
            high: corners.into_iter().fold(f64::NEG_INFINITY, f64::max),
        }
        .flushed()
    }

    pub(crate) fn negated(self) -> Self {
        Interval { low: -self.high, high: -self.low }
    }

    pub(crate) fn abs(self) -> Self {
        if self.low <= 0.0 && self.high >= 0.0 {
            Interval { low: 0.0, high: self.high.max(-self.low) }
        } else {
            self.monotone(f64::abs)
        }
    }

    pub(crate) fn plus(self, other: Self) -> Self {
        let sum = self.monotone2(other, |a, b| a + b);
        // Where f64 has rounded as well, the sum only looks as if f32 held it.
        let exact = |a: f64, b: f64| (a + b) - a == b && (a + b) - b == a;
        if sum.is_any() || exact(self.low, other.low) && exact(self.high, other.high) {
            sum.rounded()
        } else {
            sum.ulps(1.0)
        }
    }

    pub(crate) fn minus(self, other: Self) -> Self {
        self.plus(other.negated())
    }

    pub(crate) fn times(self, other: Self) -> Self {
        self.monotone2(other, |a, b| a * b).rounded()
    }

    /// 2.5 units, for divisors whose magnitude is in [2^-126, 2^126].
    pub(crate) fn over(self, other: Self) -> Self {
        let size = other.abs();
        if other.is_any() || size.low < SMALLEST_NORMAL || size.high > libm::exp2(126.0) {
            return Self::ANY;
        }
        self.monotone2(other, |a, b| a / b).ulps(2.5)
    }

    /// Clamped between two numbers.
    pub(crate) fn clamped(self, low: f64, high: f64) -> Self {
        Interval { low: self.low.clamp(low, high), high: self.high.clamp(low, high) }
    }

    /// `1 / sqrt(x)`, 2 units, for positive numbers.
    pub(crate) fn inverse_sqrt(self) -> Self {
        if self.low < SMALLEST_NORMAL { Self::ANY } else { self.monotone(|x| 1.0 / x.sqrt()).ulps(2.0) }
    }

    /// Inherited from `1 / inverseSqrt(x)`; zero stays zero on every machine that may be tested.
    pub(crate) fn sqrt(self) -> Self {
        match self {
            Interval { low: 0.0, high: 0.0 } => self,
            Interval { low, .. } if low <= 0.0 => {
                if self.high < SMALLEST_NORMAL && low == 0.0 {
                    self.monotone(f64::sqrt).ulps(5.0)
                } else {
                    Self::ANY
                }
            }
            _ => Self::exactly(1.0).over(self.inverse_sqrt()).or(self.monotone(f64::sqrt).rounded()),
        }
    }

    /// 3 + 2 |x| units.
    pub(crate) fn exp(self, f: impl Fn(f64) -> f64) -> Self {
        if self.is_any() { self } else { self.monotone(f).ulps(3.0 + 2.0 * self.abs().high) }
    }

    /// 3 units, or 2^-21 in [0.5, 2], for positive numbers.
    pub(crate) fn log(self, f: impl Fn(f64) -> f64) -> Self {
        if self.low < SMALLEST_NORMAL || self.is_any() {
            return Self::ANY;
        }
        let real = self.monotone(f);
        if self.high >= 0.5 && self.low <= 2.0 {
            real.within(libm::exp2(-21.0)).or(real.ulps(3.0))
        } else {
            real.ulps(3.0)
        }
    }

    /// Sine or cosine: 2^-11 in [-pi, pi].
    pub(crate) fn wave(self, f: impl Fn(f64) -> f64) -> Self {
        if self.abs().high > std::f64::consts::PI + 1e-6 {
            Self::ANY
        } else {
            self.monotone(f).within(libm::exp2(-11.0))
        }
    }

    /// 4096 units.
    pub(crate) fn arc(self, f: impl Fn(f64) -> f64) -> Self {
        if self.is_any() { self } else { self.monotone(f).ulps(4096.0) }
    }
}
