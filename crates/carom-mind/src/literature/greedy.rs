//! The greedy player: the easiest shot by geometry.
//!
//! Greenspan, Lam, Godard, Zaidi, Jordan, Leckie, Anderson & Dupuis, *Toward a competitive pool-
//! playing robot*, IEEE Computer 41(1), 2008, compare their player with a greedy one, which plays
//! the shot that is most probable and plans no position.

use carom::Error;
use carom::format::Reader;

use super::baseline::{Baseline, first_best};
use super::planner::{Attack, Method, Planner};
use super::pot_table::EVERY_KIND;
use super::shots::{Correction, Stroke, geometric};
use crate::player::Spent;
use crate::search::CuePlace;
use crate::workbench::Workbench;

/// How the greedy player aims.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum GreedyAim {
    /// At the ghost ball, corrected for squirt but not for throw. Bank and kick shots are aimed at
    /// mirror images.
    #[default]
    Geometric,
    /// By simulated shots that correct the geometric aim.
    Simulated,
}

/// Settings of [`Greedy`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GreedySettings {
    /// The cue's speed in every pot, m/s. Guess: the paper prints none; 2.2 m/s sends the cue ball
    /// about twice along a nine-foot table.
    pub speed: f64,
    /// How it aims. Guess: the paper does not print how the greedy player corrects its aim.
    pub aim: GreedyAim,
    /// A safety is preferred to a pot that is less probable than this, if the safety is worth more.
    /// Guess: the papers' greedy player attempts nearly everything.
    pub safety_below: f64,
}

impl Default for GreedySettings {
    fn default() -> Self {
        Self { speed: 2.2, aim: GreedyAim::Geometric, safety_below: 0.1 }
    }
}

impl GreedySettings {
    /// The settings of an object; see [`super::Literature::player_with`].
    pub(crate) fn read(object: &Reader<'_>) -> Result<Self, Error> {
        object.keys(&["aim"])?;
        let mut settings = Self::default();
        if let Some(value) = object.get("aim") {
            let known = ["geometric", "simulated"];
            settings.aim = match value.text(&known.join(" or "))? {
                "geometric" => GreedyAim::Geometric,
                "simulated" => GreedyAim::Simulated,
                other => return Err(value.unknown_word(other, "aim", &known)),
            };
        }
        Ok(settings)
    }
}

/// The greedy player.
pub type Greedy = Planner<GreedySettings>;

impl Method for GreedySettings {
    fn name(&self) -> String {
        "greedy".into()
    }

    fn safety_below(&self) -> f64 {
        self.safety_below
    }

    fn attack(&self, baseline: &Baseline<'_>, spent: &mut Spent) -> Result<Option<Attack>, Error> {
        let sight = baseline.sight();
        let mut lines = Vec::new();
        for CuePlace { prepared, .. } in baseline.places() {
            // By geometry alone: the table of measured probabilities is not used.
            let rated = sight.lines(prepared, &EVERY_KIND).into_iter();
            lines.extend(
                rated.map(|(line, _)| (prepared, line, line.chance(&sight.noise, sight.radius))),
            );
        }
        let Some((prepared, line, chance)) = first_best(lines, |(.., chance)| *chance) else {
            return Ok(None);
        };
        let plain = geometric(&sight, prepared, &line, self.speed);
        let plain = prepared.shot().resolve_strike(&plain.strike).is_ok().then_some(plain);
        let play = match self.aim {
            GreedyAim::Geometric => plain,
            GreedyAim::Simulated => {
                let mut bench = Workbench::new(baseline.situation.frame);
                let stroke = Stroke::plain(self.speed);
                let known = &mut Correction::default();
                let aimed = bench.aimed(&sight, prepared, &line, stroke, known)?;
                spent.simulations += bench.plays;
                aimed.or(plain)
            }
        };
        Ok(play.map(|play| Attack { play, chance }))
    }
}
