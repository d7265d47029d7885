//! The greedy player: the easiest shot by geometry.
//!
//! Greenspan, Lam, Godard, Zaidi, Jordan, Leckie, Anderson & Dupuis, *Toward a competitive pool-
//! playing robot*, IEEE Computer 41(1), 2008, compare their player with a greedy one, which plays the
//! shot that is most probable and plans no position.

use carom::Error;
use carom::format::Reader;

use super::best_shots::COUNTED;
use super::desk::{Attack, Desk, Method, decide, first_best};
use super::pot_table::{EVERY_KIND, PotTables};
use super::shots::{Correction, Stroke, Workbench, geometric};
use crate::player::{Budget, Decision, Player, Situation, Spent};

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
#[derive(Clone, Debug, Default)]
pub struct Greedy {
    settings: GreedySettings,
    tables: PotTables,
}

impl Greedy {
    /// A player with these settings.
    pub fn new(settings: GreedySettings) -> Self {
        Self::with_tables(settings, PotTables::default())
    }

    pub(crate) const fn with_tables(settings: GreedySettings, tables: PotTables) -> Self {
        Self { settings, tables }
    }
}

impl Player for Greedy {
    fn name(&self) -> &'static str {
        "greedy"
    }

    fn decide(
        &mut self,
        situation: &Situation<'_>,
        budget: &Budget<'_>,
    ) -> Result<Decision, Error> {
        decide(self, situation, budget)
    }
}

impl Method for Greedy {
    fn tables(&self) -> &PotTables {
        &self.tables
    }

    /// Only the best shot counts.
    fn weights(&self) -> [f64; COUNTED] {
        [1.0, 0.0, 0.0]
    }

    fn safety_below(&self) -> f64 {
        self.settings.safety_below
    }

    fn attack(&self, desk: &Desk<'_>, spent: &mut Spent) -> Result<Option<Attack>, Error> {
        let sight = desk.sight();
        let mut lines = Vec::new();
        for (place, prepared) in desk.prepared.iter().enumerate() {
            // By geometry alone: the table of measured probabilities is not used.
            let rated = sight.lines(prepared, &EVERY_KIND).into_iter();
            lines.extend(
                rated.map(|(line, _)| (place, line, line.chance(&sight.noise, sight.radius))),
            );
        }
        let Some((place, line, chance)) = first_best(lines, |(.., chance)| *chance) else {
            return Ok(None);
        };
        let prepared = &desk.prepared[place];
        let plain = geometric(&sight, prepared, &line, self.settings.speed);
        let plain = prepared.shot().resolve_strike(&plain.strike).is_ok().then_some(plain);
        let play = match self.settings.aim {
            GreedyAim::Geometric => plain,
            GreedyAim::Simulated => {
                let mut bench = Workbench::new(desk.situation.frame);
                let stroke = Stroke::plain(self.settings.speed);
                let known = &mut Correction::default();
                let aimed = bench.aimed(&sight, prepared, (&line, stroke), known)?;
                spent.simulations += bench.plays;
                aimed.or(plain)
            }
        };
        Ok(play.map(|play| Attack { play, chance }))
    }
}
