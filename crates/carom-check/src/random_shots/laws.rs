//! Random physics for a shot: rolling resistance in bands of speed, cushions whose restitution
//! depends on speed and whose friction depends on the angle, surfaces of balls, contacts that cling,
//! and every preset.

use std::fmt::Write as _;

use carom::edition;
use carom::physics::{BallBallModel, CushionModel, SlipFriction};

use super::builder::ShotBuilder;
use crate::random::Random;

/// The largest number of bands that is drawn: as many as the engine has room for.
const MOST_BANDS: usize = carom::physics::MAX_ROLLING_BANDS;

/// Contacts that cling are drawn from these first ones. More, and most would never take place.
const CLINGING: u32 = 12;

impl ShotBuilder {
    /// The same builder with a random `physics`, and in half of the shots with contacts that cling.
    pub(super) fn with_laws(mut self) -> Self {
        self.physics = Some(physics(&mut self.rng));
        if self.rng.chance(0.5) {
            self.cling = Some(cling(&mut self.rng));
        }
        self
    }
}

/// A preset, or one with other values of the cloth, of the cushions and of the balls.
fn physics(rng: &mut Random) -> String {
    let presets = edition::names(edition::PHYSICS);
    let base = presets[rng.below(presets.len())];
    if rng.chance(0.25) {
        return format!("\"{base}\"");
    }
    let mut text = format!("{{\"base\": \"{base}\"");
    if rng.chance(0.7) {
        let _ = write!(text, ", \"cloth\": {{\"rolling_friction\": {}}}", bands(rng));
    }
    if rng.chance(0.7) {
        let _ = write!(text, ", \"cushion\": {}", cushion(rng));
    }
    if rng.chance(0.7) {
        let _ = write!(text, ", \"ball_ball\": {}", ball_ball(rng));
    }
    text.push('}');
    text
}

fn one_of<T: Copy>(rng: &mut Random, all: &[T]) -> T {
    all[rng.below(all.len())]
}

/// Bands of speed; the coefficient may rise and fall from band to band.
fn bands(rng: &mut Random) -> String {
    let count = 1 + rng.below(MOST_BANDS);
    let mut end = 0.0;
    let mut text = String::from("[");
    for _ in 1..count {
        end += rng.log_uniform(1e-4, 1.0);
        let _ = write!(text, "{{\"up_to\": {end:?}, \"friction\": {:?}}}, ", coefficient(rng));
    }
    let _ = write!(text, "{{\"friction\": {:?}}}]", coefficient(rng));
    text
}

/// A coefficient of rolling resistance.
fn coefficient(rng: &mut Random) -> f64 {
    rng.log_uniform(1e-3, 5e-2)
}

/// Any model, with a fitted restitution between limits and a fitted friction.
fn cushion(rng: &mut Random) -> String {
    let model = one_of(rng, &CushionModel::ALL).name();
    let (lowest, highest) = (rng.between(0.0, 0.5), rng.between(0.5, 1.0));
    let a = rng.between(0.2, 1.3);
    let mut fit = [rng.between(-0.1, 0.1), rng.between(-0.02, 0.02)];
    // A fit that begins outside the limits must come back, or the file is refused.
    if a > highest {
        fit = fit.map(|k| -k.abs());
    } else if a < lowest {
        fit = fit.map(f64::abs);
    }
    let [b, c] = fit;
    format!(
        "{{\"model\": \"{model}\", \"restitution\": {{\"a\": {a:?}, \"b\": {b:?}, \"c\": {c:?}, \
         \"lowest\": {lowest:?}, \"highest\": {highest:?}}}, \"friction\": {{\"a\": {:?}, \"b\": \
         {:?}}}, \"frequency_ratio\": {:?}}}",
        rng.between(0.0, 0.6),
        rng.between(-0.3, 0.3),
        rng.between(1.05, 1.95)
    )
}

/// Any model, with a named surface, a fitted friction or a constant one.
fn ball_ball(rng: &mut Random) -> String {
    let model = one_of(rng, &BallBallModel::ALL).name();
    let restitution = rng.between(0.7, 1.0);
    let friction = match rng.below(3) {
        0 => format!("\"{}\"", one_of(rng, &SlipFriction::SURFACES).0),
        1 => format!(
            "{{\"a\": {:?}, \"b\": {:?}, \"c\": {:?}}}",
            rng.between(0.0, 0.1),
            rng.between(0.0, 0.2),
            rng.between(0.0, 2.0)
        ),
        _ => format!("{:?}", rng.between(0.0, 0.3)),
    };
    let ratio = rng.between(1.05, 1.95);
    format!(
        "{{\"model\": \"{model}\", \"restitution\": {restitution:?}, \"friction\": {friction}, \
         \"frequency_ratio\": {ratio:?}}}"
    )
}

/// Some of the first contacts, with the usual friction of a cling or a random one.
fn cling(rng: &mut Random) -> String {
    let contacts: Vec<String> =
        (0..CLINGING).filter(|_| rng.chance(0.3)).map(|k| k.to_string()).collect();
    let friction = match rng.below(2) {
        0 => String::new(),
        _ => format!(", \"friction\": {:?}", rng.between(0.0, 0.6)),
    };
    format!("{{\"contacts\": [{}]{friction}}}", contacts.join(", "))
}

#[cfg(test)]
mod tests {
    use super::super::{ShotFamily, shot_file};
    use super::{BallBallModel, CushionModel, SlipFriction};

    #[test]
    fn every_law_is_drawn() {
        let all: String = (0..500).map(|seed| shot_file(ShotFamily::Laws, seed)).collect();
        let words = ["up_to", "lowest", "highest", "cling", "pool-2026-11", "carom"];
        let (cushions, balls) = (CushionModel::ALL, BallBallModel::ALL);
        let models = cushions.iter().map(|m| m.name()).chain(balls.iter().map(|m| m.name()));
        let surfaces = SlipFriction::SURFACES.map(|(name, _)| name);
        for word in models.chain(words).chain(surfaces) {
            assert!(all.contains(&format!("\"{word}\"")), "{word}");
        }
    }
}
