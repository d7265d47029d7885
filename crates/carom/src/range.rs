//! The numbers that a parameter accepts.

use alloc::format;
use alloc::string::String;

use crate::error::{Error, ErrorKind};

/// No number in a shot is larger than this, whatever its unit. It keeps every product that the
/// engine forms far from overflow; a kilometre, a tonne and a year all fit.
pub(crate) const LARGEST: f64 = 1e9;

/// The smallest value of a mass, radius, length or gravity that must be positive. It keeps every
/// quotient that the engine forms far from overflow; a microgram and a nanometre fit.
pub(crate) const SMALLEST: f64 = 1e-9;

/// A parameter smaller than this, whatever its unit, is read as 0, because its square could
/// underflow and a quotient by it could overflow. −0 is read as 0 too, because 1/−0 is not 1/0.
pub(crate) const VANISHING: f64 = 1e-150;

/// A parameter as a file is read: 0 in place of one that vanishes.
pub(crate) const fn or_zero(x: f64) -> f64 {
    if x.abs() < VANISHING { 0.0 } else { x }
}

/// The numbers that a key accepts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Range {
    low: f64,
    high: f64,
    low_open: bool,
    high_open: bool,
    /// Unit, with a leading space, or empty.
    unit: &'static str,
}

impl Range {
    /// [−`LARGEST`, `LARGEST`].
    pub(crate) const fn any(unit: &'static str) -> Self {
        Self { low: -LARGEST, high: LARGEST, low_open: false, high_open: false, unit }
    }
    /// [low, high].
    pub(crate) const fn closed(low: f64, high: f64, unit: &'static str) -> Self {
        Self { low, high, low_open: false, high_open: false, unit }
    }
    /// [low, high).
    pub(crate) const fn half_open(low: f64, high: f64, unit: &'static str) -> Self {
        Self { low, high, low_open: false, high_open: true, unit }
    }
    /// (low, high].
    pub(crate) const fn above(low: f64, high: f64, unit: &'static str) -> Self {
        Self { low, high, low_open: true, high_open: false, unit }
    }
    /// [`SMALLEST`, `LARGEST`].
    pub(crate) const fn positive(unit: &'static str) -> Self {
        Self::closed(SMALLEST, LARGEST, unit)
    }
    /// [0, `LARGEST`].
    pub(crate) const fn not_negative(unit: &'static str) -> Self {
        Self::closed(0.0, LARGEST, unit)
    }

    /// [−high, high], for an error whose σ is in this range.
    pub(crate) const fn either_sign(self) -> Self {
        Self { low: -self.high, ..self }
    }
    /// [0, high²], for a variance whose σ is in this range; its unit is left out.
    pub(crate) const fn squared(self) -> Self {
        Self { high: self.high * self.high, unit: "", ..self }
    }

    /// The unit; empty for a number without one.
    pub(crate) fn unit(&self) -> &'static str {
        self.unit.trim_start()
    }

    /// The limits by their keywords in a JSON Schema.
    pub(crate) const fn limits(&self) -> [(&'static str, f64); 2] {
        let low = if self.low_open { "exclusiveMinimum" } else { "minimum" };
        let high = if self.high_open { "exclusiveMaximum" } else { "maximum" };
        [(low, self.low), (high, self.high)]
    }

    /// The same range with another name of the unit.
    pub(crate) const fn in_unit(self, unit: &'static str) -> Self {
        Self { unit, ..self }
    }

    /// Whether `x` is in the range.
    #[inline]
    pub(crate) fn contains(&self, x: f64) -> bool {
        let above = if self.low_open { x > self.low } else { x >= self.low };
        let below = if self.high_open { x < self.high } else { x <= self.high };
        above && below
    }

    /// Refuses the number `x` at `place` if it is out of range or not finite.
    #[inline]
    pub(crate) fn check(&self, place: impl FnOnce() -> String, x: f64) -> Result<(), Error> {
        if self.contains(x) { Ok(()) } else { Err(self.refusal(place(), x)) }
    }

    #[cold]
    fn refusal(&self, place: String, x: f64) -> Error {
        let what = if x.is_finite() {
            format!("{x:?} is out of range")
        } else {
            format!("{} is not a number that a shot can use", describe_number(x))
        };
        ErrorKind::OutOfRange
            .at(place, what, format!("write {}", self.describe()))
            .with("value", x)
            .with("low", self.low)
            .with("high", self.high)
            .with("open", self.open_ends())
            .with("unit", self.unit.split_whitespace().next().unwrap_or_default())
    }

    /// Whether the range is for numbers that the engine computed, such as the states of a trace. It
    /// then has no upper limit, so that every such number can be read back.
    pub(crate) const fn is_result(&self) -> bool {
        self.high == f64::MAX
    }

    /// Which ends do not belong to the range: `low`, `high`, `both` or `none`.
    const fn open_ends(&self) -> &'static str {
        match (self.low_open, self.high_open) {
            (true, true) => "both",
            (true, false) => "low",
            (false, true) => "high",
            (false, false) => "none",
        }
    }

    pub(crate) fn describe(&self) -> String {
        let unit = self.unit;
        if self.is_result() {
            let sign = if self.low == 0.0 { " ≥ 0" } else { "" };
            return format!("a finite number{sign}{unit}");
        }
        if self.low == SMALLEST && self.high == LARGEST {
            let unit = if unit.is_empty() { String::new() } else { format!(", in{unit}") };
            return format!("a number greater than 0{unit} (from {SMALLEST:e} to {LARGEST:e})");
        }
        let open = if self.low_open { '(' } else { '[' };
        let close = if self.high_open { ')' } else { ']' };
        if self.low == 0.0 && self.high == LARGEST {
            let sign = if self.low_open { '>' } else { '≥' };
            return format!("a number {sign} 0{unit} (at most {LARGEST:e})");
        }
        if self.low == -LARGEST && self.high == LARGEST {
            return format!("a finite number (at most {LARGEST:e}{unit} in size)");
        }
        format!("a number in {open}{}, {}{close}{unit}", self.low, self.high)
    }
}

/// A number in words.
pub(crate) fn describe_number(x: f64) -> String {
    if x.is_nan() {
        "NaN".into()
    } else if x.is_infinite() {
        "an infinite number".into()
    } else {
        format!("the number {x:?}")
    }
}
