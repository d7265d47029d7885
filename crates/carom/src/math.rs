//! The engine's arithmetic: IEEE + − × ÷ √ and the crate `libm`, nothing else.
//!
//! Every transcendental function of the engine comes from this module, so that the bits are the
//! same on every platform. `clippy.toml` forbids the standard library's functions.

use core::ops::{Add, AddAssign, Mul, Neg, Sub, SubAssign};

pub use libm::{acos, asin, atan, atan2, ceil, cos, exp, log, pow, sin, tan};

/// √x, correctly rounded (IEEE 754), so its bits are the same on every platform.
#[inline(always)]
pub fn sqrt(x: f64) -> f64 {
    #[cfg(feature = "std")]
    return x.sqrt();
    // The instruction of the device; the function of `libm` takes a hundred.
    #[cfg(target_arch = "nvptx64")]
    return core::f64::math::sqrt(x);
    #[cfg(not(any(feature = "std", target_arch = "nvptx64")))]
    return libm::sqrt(x);
}

/// Sine and cosine of `x` (rad).
#[inline]
pub fn sin_cos(x: f64) -> (f64, f64) {
    libm::sincos(x)
}

/// Whether this processor has AVX2.
pub(crate) fn has_wide_vectors() -> bool {
    #[cfg(all(feature = "std", target_arch = "x86_64"))]
    return std::is_x86_feature_detected!("avx2");
    #[cfg(not(all(feature = "std", target_arch = "x86_64")))]
    return false;
}

/// Radians to degrees. Where possible, the result is a number that [`radians`] converts
/// back to the same bits.
pub fn degrees(radians: f64) -> f64 {
    let near = radians * (180.0 / core::f64::consts::PI);
    let back = |d: &f64| self::radians(*d) == radians;
    [near, near.next_down(), near.next_up()].into_iter().find(back).unwrap_or(near)
}

/// Degrees to radians.
#[inline]
pub const fn radians(degrees: f64) -> f64 {
    degrees * (core::f64::consts::PI / 180.0)
}

/// A vector in the table plane.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct Vec2 {
    /// Along the table's width.
    pub x: f64,
    /// Along the table's length.
    pub y: f64,
}

/// A vector in space; z points up from the slate.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct Vec3 {
    /// Along the table's width.
    pub x: f64,
    /// Along the table's length.
    pub y: f64,
    /// Up from the slate.
    pub z: f64,
}

impl Vec2 {
    /// The zero vector.
    pub const ZERO: Self = Self { x: 0.0, y: 0.0 };

    /// A vector from its components.
    #[inline(always)]
    pub const fn new(x: f64, y: f64) -> Self {
        Self { x, y }
    }
    /// Scalar product.
    #[inline(always)]
    pub fn dot(self, o: Self) -> f64 {
        self.x * o.x + self.y * o.y
    }
    /// z component of the vector product.
    #[inline(always)]
    pub fn cross(self, o: Self) -> f64 {
        self.x * o.y - self.y * o.x
    }
    /// A quarter turn counter-clockwise (ẑ × self).
    #[inline(always)]
    pub fn perp(self) -> Self {
        Self::new(-self.y, self.x)
    }
    /// Squared length.
    #[inline(always)]
    pub fn length_squared(self) -> f64 {
        self.dot(self)
    }
    /// Length.
    #[inline(always)]
    pub fn length(self) -> f64 {
        sqrt(self.length_squared())
    }
    /// This vector in space, at height `z`.
    #[inline(always)]
    pub fn with_z(self, z: f64) -> Vec3 {
        Vec3::new(self.x, self.y, z)
    }
}

impl Vec3 {
    /// The zero vector.
    pub const ZERO: Self = Self { x: 0.0, y: 0.0, z: 0.0 };

    /// A vector from its components.
    #[inline(always)]
    pub const fn new(x: f64, y: f64, z: f64) -> Self {
        Self { x, y, z }
    }
    /// Scalar product.
    #[inline(always)]
    pub fn dot(self, o: Self) -> f64 {
        self.x * o.x + self.y * o.y + self.z * o.z
    }
    /// Vector product self × o.
    #[inline(always)]
    pub fn cross(self, o: Self) -> Self {
        Self::new(
            self.y * o.z - self.z * o.y,
            self.z * o.x - self.x * o.z,
            self.x * o.y - self.y * o.x,
        )
    }
    /// Squared length.
    #[inline(always)]
    pub fn length_squared(self) -> f64 {
        self.dot(self)
    }
    /// Length.
    #[inline(always)]
    pub fn length(self) -> f64 {
        sqrt(self.length_squared())
    }
    /// The components in the table plane.
    #[inline(always)]
    pub fn xy(self) -> Vec2 {
        Vec2::new(self.x, self.y)
    }
    /// Whether all components are finite.
    #[inline]
    pub fn is_finite(self) -> bool {
        self.x.is_finite() && self.y.is_finite() && self.z.is_finite()
    }
    /// The components in order.
    #[inline]
    pub const fn to_array(self) -> [f64; 3] {
        [self.x, self.y, self.z]
    }
}

impl From<[f64; 3]> for Vec3 {
    #[inline]
    fn from([x, y, z]: [f64; 3]) -> Self {
        Self { x, y, z }
    }
}

macro_rules! vector_operators {
    ($t:ty, $($c:ident),+) => {
        impl Add for $t {
            type Output = Self;
            #[inline(always)]
            fn add(self, o: Self) -> Self { Self { $($c: self.$c + o.$c),+ } }
        }
        impl Sub for $t {
            type Output = Self;
            #[inline(always)]
            fn sub(self, o: Self) -> Self { Self { $($c: self.$c - o.$c),+ } }
        }
        impl Neg for $t {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self { Self { $($c: -self.$c),+ } }
        }
        impl Mul<f64> for $t {
            type Output = Self;
            #[inline(always)]
            fn mul(self, k: f64) -> Self { Self { $($c: self.$c * k),+ } }
        }
        impl AddAssign for $t {
            #[inline(always)]
            fn add_assign(&mut self, o: Self) { $(self.$c += o.$c;)+ }
        }
        impl SubAssign for $t {
            #[inline(always)]
            fn sub_assign(&mut self, o: Self) { $(self.$c -= o.$c;)+ }
        }
    };
}
vector_operators!(Vec2, x, y);
vector_operators!(Vec3, x, y, z);
