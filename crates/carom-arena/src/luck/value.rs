//! The values by which luck is measured.

use carom::hash::WordHasher;
use carom_mind::value::{Logistic, Position, Value};
use carom_rules::{Seat, Turn};

/// The value of positions by which the luck of a shot is measured.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum LuckValue {
    /// The built-in value ([`Logistic`]), which is a Markov chain over what is left to score in the
    /// games without fitted weights.
    #[default]
    Logistic,
    /// A number that follows from the position by a hash, even if the frame is over. It says nothing
    /// about who wins: a check that the correction needs no true value.
    Noise,
}

impl LuckValue {
    /// Every value.
    pub const ALL: [Self; 2] = [Self::Logistic, Self::Noise];

    /// Its name in records.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Logistic => "logistic",
            Self::Noise => "noise",
        }
    }

    /// The value called `name`, if there is one.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|value| value.name() == name)
    }

    pub(super) const fn get(self) -> &'static dyn Value {
        match self {
            Self::Logistic => &Logistic,
            Self::Noise => &HashValue,
        }
    }
}

/// A value without a meaning.
struct HashValue;

impl Value for HashValue {
    fn name(&self) -> &'static str {
        LuckValue::Noise.name()
    }

    fn of_shot(&self, position: &Position<'_>, turn: &Turn) -> f64 {
        self.win_chance(position, turn.player)
    }

    fn win_chance(&self, position: &Position<'_>, seat: Seat) -> f64 {
        let mut bytes = Vec::new();
        position.frame.write_to(&mut bytes);
        let mut hasher = WordHasher::default();
        hasher.bytes(&bytes);
        // The upper half of each half of a hash is mixed best; 53 bits make a double.
        let of_seat_0 = (hasher.value() >> 11) as f64 / (1_u64 << 53) as f64;
        if seat == 0 { of_seat_0 } else { 1.0 - of_seat_0 }
    }
}
