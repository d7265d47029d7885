//! The laws of a contact: stiffness, restitution, friction.

/// Force (N), compression (m) and radius (m) of two equal balls that are pressed together
/// (Alciatore, TP B.29: 2270 N compress two 2¼ in balls by 0.2 mm).
const PRESSED: (f64, f64, f64) = (2270.0, 0.2e-3, 1.125 * 0.0254);

/// A lossless contact lasts this many times its depth divided by its speed: 2∫dx/√(1 − x^(5/2))
/// from 0 to 1.
const TIME_PER_DEPTH: f64 = 2.943_27;

/// Up to this approach speed an impact is lossless, m/s; from twice this speed its law holds
/// (docs/guarantees.md, slow impacts).
const LOSSLESS_SPEED: f64 = 1e-3;

/// (2/7)·(5/4): tangential stiffness, divided by F/δ and by the square of the frequency ratio.
const GRIP: f64 = 2.0 / 7.0 * 1.25;

/// k of two balls, N/m^(3/2): it grows as √(R_a R_b/(R_a + R_b)).
pub fn ball_stiffness(radius_a: f64, radius_b: f64) -> f64 {
    let (force, depth, radius) = PRESSED;
    let curvature = radius_a * radius_b / (radius_a + radius_b);
    force / depth.powf(1.5) * (curvature / (0.5 * radius)).sqrt()
}

/// k of a contact of reduced mass `mass` (kg) that lasts `time` (s) at 1 m/s without losses.
pub fn stiffness_of_time(mass: f64, time: f64) -> f64 {
    1.25 * mass * (TIME_PER_DEPTH / time).powf(2.5)
}

/// Restitution a + bV + cV², limited to 0..=1, at the fastest approach V (m/s) so far.
#[derive(Clone, Copy, Debug)]
pub struct Restitution {
    /// At rest.
    pub a: f64,
    /// s/m.
    pub b: f64,
    /// s²/m².
    pub c: f64,
}

impl Restitution {
    /// The same restitution at every speed.
    pub const fn constant(e: f64) -> Self {
        Self { a: e, b: 0.0, c: 0.0 }
    }

    /// Whether e is 1 at every speed.
    pub fn is_lossless(&self) -> bool {
        self.a == 1.0 && self.b == 0.0 && self.c == 0.0
    }

    /// e at this speed; slow impacts are lossless.
    pub fn at(&self, speed: f64) -> f64 {
        let e = (self.a + speed * (self.b + speed * self.c)).clamp(0.0, 1.0);
        let full = (speed / LOSSLESS_SPEED - 1.0).clamp(0.0, 1.0);
        1.0 - (1.0 - e) * full
    }
}

/// Friction μ = a + b·exp(−c·s) at the fastest slip s (m/s) so far.
#[derive(Clone, Copy, Debug)]
pub struct Friction {
    /// At high speed.
    pub a: f64,
    /// What is added at rest.
    pub b: f64,
    /// s/m.
    pub c: f64,
}

impl Friction {
    /// The same friction at every slip.
    pub const fn constant(mu: f64) -> Self {
        Self { a: mu, b: 0.0, c: 0.0 }
    }

    /// μ at this slip.
    pub fn at(&self, slip: f64) -> f64 {
        if self.b == 0.0 { self.a } else { self.a + self.b * (-self.c * slip).exp() }
    }

    /// Whether there is no friction.
    pub fn is_none(&self) -> bool {
        self.a == 0.0 && self.b == 0.0
    }
}

/// Restitution and friction of a contact.
#[derive(Clone, Copy, Debug)]
pub struct Law {
    /// Along the normal.
    pub restitution: Restitution,
    /// Across it.
    pub friction: Friction,
    /// ω_t/ω_n of a compliant contact; `None` for a rigid one.
    pub frequency_ratio: Option<f64>,
}

impl Law {
    /// A rigid contact with constants.
    pub const fn rigid(restitution: f64, friction: f64) -> Self {
        Self {
            restitution: Restitution::constant(restitution),
            friction: Friction::constant(friction),
            frequency_ratio: None,
        }
    }

    /// A compliant contact with constants.
    pub const fn compliant(restitution: f64, friction: f64, frequency_ratio: f64) -> Self {
        Self { frequency_ratio: Some(frequency_ratio), ..Self::rigid(restitution, friction) }
    }

    /// Tangential stiffness divided by F/δ of the closing contact.
    pub fn grip(&self) -> f64 {
        self.frequency_ratio.map_or(0.0, |ratio| GRIP * ratio * ratio)
    }
}

/// A tip's restitution at the distance `offset` (ball radii) from the middle: e₀/√(1 + c·s²/(1 −
/// s²)).
pub fn tip_restitution(central: f64, off_centre_loss: f64, offset: f64) -> f64 {
    let s = offset * offset;
    central / (1.0 + off_centre_loss * s / (1.0 - s)).sqrt()
}

/// The angle of squirt, rad, at `side` ball radii (TP A.31); 0 if the cue's end has no mass.
pub fn squirt(ball_mass: f64, end_mass: f64, side: f64) -> f64 {
    if end_mass == 0.0 {
        return 0.0;
    }
    let inward = 1.0 - side * side;
    (2.5 * side * inward.sqrt() / (1.0 + ball_mass / end_mass + 2.5 * inward)).atan()
}
