//! Random shots, as shot files: what players play, and what breaks engines.

mod builder;
mod cloth;
mod flight;

use builder::ShotBuilder;

use crate::random::Random;

/// Families of shots. Together they hold every hard case of ARCHITECTURE.md that can be drawn by
/// lot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ShotFamily {
    /// The cue ball and some others, anywhere, an ordinary strike.
    Pot,
    /// An eight-ball break with gaps of 0.1 mm, 1 µm or none.
    EightBallBreak,
    /// A nine-ball break, likewise.
    NineBallBreak,
    /// Balls frozen to rails and to each other.
    Frozen,
    /// Every ball moves already, at 1e-9 to 20 m/s with spins of 0 to 500 rad/s.
    Wild,
    /// Balls in a row along one line, some touching, rolled or struck at: Newton's cradle.
    Row,
    /// Struck with the butt raised by 0 to 80° at 0.2 to 20 m/s, up to the miscue limit, among free and
    /// frozen balls.
    Elevated,
    /// Some balls fly already, over cloth and rails, at 1e-3 to 20 m/s with spins of 0 to 500 rad/s.
    Flying,
    /// Balls fall on others, from a micrometre to a third of a metre above them.
    Dropped,
    /// A jump shot over a ball, near rails and other balls.
    Jump,
    /// A ball on the cloth or in the air comes hard into the jaws of a pocket.
    Jaws,
    /// Balls in the mouths of pockets, gently rolled over a lip, or hit.
    Mouths,
}

impl ShotFamily {
    /// All families.
    pub const ALL: [Self; 12] = [
        Self::Pot,
        Self::EightBallBreak,
        Self::NineBallBreak,
        Self::Frozen,
        Self::Wild,
        Self::Row,
        Self::Elevated,
        Self::Flying,
        Self::Dropped,
        Self::Jump,
        Self::Jaws,
        Self::Mouths,
    ];
}

/// The shot file of `scene` number `seed`.
pub fn shot_file(scene: ShotFamily, seed: u64) -> String {
    let layout = ShotBuilder::new(Random::new(seed ^ ((scene as u64 + 1) << 56)));
    match scene {
        ShotFamily::Pot => layout.pot(),
        ShotFamily::EightBallBreak => layout.triangle(5),
        ShotFamily::NineBallBreak => layout.triangle(3),
        ShotFamily::Frozen => layout.frozen(),
        ShotFamily::Wild => layout.wild(),
        ShotFamily::Row => layout.row(),
        ShotFamily::Elevated => layout.elevated(),
        ShotFamily::Flying => layout.flying(),
        ShotFamily::Dropped => layout.dropped(),
        ShotFamily::Jump => layout.jump(),
        ShotFamily::Jaws => layout.jaws(),
        ShotFamily::Mouths => layout.mouths(),
    }
}
