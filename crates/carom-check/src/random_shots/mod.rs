//! Random shots, as shot files: ordinary ones, and hard cases.

mod builder;
mod cloth;
mod flight;
mod laws;

use builder::ShotBuilder;

use crate::random::Random;

/// Families of random shots. Together they contain every hard case of ARCHITECTURE.md that can be
/// drawn at random.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ShotFamily {
    /// The cue ball and some others at random places, with an ordinary strike.
    Pot,
    /// An eight-ball break with gaps of 0.1 mm, 1 µm or none.
    EightBallBreak,
    /// A nine-ball break with the same gaps.
    NineBallBreak,
    /// Balls frozen to rails and to each other.
    Frozen,
    /// Every ball moves at the start, at 1e-9 to 20 m/s with spins of 0 to 500 rad/s.
    Wild,
    /// Balls in a row, some touching, that roll or are struck: Newton's cradle.
    Row,
    /// Strikes with an elevation of 0 to 80° at 0.2 to 20 m/s, with offsets up to the miscue limit,
    /// among free and frozen balls.
    Elevated,
    /// Some balls fly at the start, over cloth and rails, at 1e-3 to 20 m/s with spins of 0 to 500
    /// rad/s.
    Flying,
    /// Balls that fall on others from 1 µm to 0.3 m above them.
    Dropped,
    /// A jump shot over a ball, near rails and other balls.
    Jump,
    /// A fast ball on the cloth or in the air that enters the jaws of a pocket.
    Jaws,
    /// Balls in the mouths of pockets that roll slowly over a lip or are hit.
    Mouths,
    /// A shot of any other family with random physics: a preset, bands of rolling resistance, fitted
    /// cushions of every model, surfaces of balls, and contacts that cling.
    Laws,
}

impl ShotFamily {
    /// The families that draw where the balls are and how they move; the physics is that of the
    /// table.
    const LAYOUTS: [Self; 12] = [
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

    /// All families.
    pub const ALL: [Self; 13] = {
        let mut all = [Self::Laws; 13];
        let mut k = 0;
        while k < Self::LAYOUTS.len() {
            all[k] = Self::LAYOUTS[k];
            k += 1;
        }
        all
    };
}

/// The shot file number `seed` of a family.
pub fn shot_file(family: ShotFamily, seed: u64) -> String {
    draw(family, ShotBuilder::new(Random::new(seed ^ ((family as u64 + 1) << 56))))
}

fn draw(family: ShotFamily, builder: ShotBuilder) -> String {
    match family {
        ShotFamily::Pot => builder.pot(),
        ShotFamily::EightBallBreak => builder.triangle(5),
        ShotFamily::NineBallBreak => builder.triangle(3),
        ShotFamily::Frozen => builder.frozen(),
        ShotFamily::Wild => builder.wild(),
        ShotFamily::Row => builder.row(),
        ShotFamily::Elevated => builder.elevated(),
        ShotFamily::Flying => builder.flying(),
        ShotFamily::Dropped => builder.dropped(),
        ShotFamily::Jump => builder.jump(),
        ShotFamily::Jaws => builder.jaws(),
        ShotFamily::Mouths => builder.mouths(),
        ShotFamily::Laws => {
            let mut builder = builder.with_laws();
            let layouts = ShotFamily::LAYOUTS;
            let layout = layouts[builder.rng.below(layouts.len())];
            draw(layout, builder)
        }
    }
}
