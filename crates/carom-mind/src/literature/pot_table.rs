//! The table of potting probabilities.
//!
//! PickPocket (Smith 2007) and Deep Green (Leckie & Greenspan 2006) look the probability of a shot
//! up in a table that was made by simulation. Theirs has the cut angle and the two distances as
//! its axes. **Guess:** ours has the cut and the *ease*, which is the half width of the directions
//! in which the cue ball pots the object ball, in standard deviations of the player's direction.
//! The ease contains both distances and the pocket's window, so two axes are enough. The papers do
//! not print their tables, so there is no table to copy.

use std::sync::{Arc, Mutex, PoisonError};

use carom::noise::Perception;
use carom::resolve::cue_ball::Strike;
use carom::{Error, Noise};
use carom_rules::{Call, Frame, Game, Options};
use core::f64::consts::SQRT_2;

use crate::aim::{AimStart, aim};
use crate::line::{Line, LineKind, direction_error, straight_to_pocket};
use crate::scene::Scene;
use carom::noise::Errors;
use carom_plan::{Prepared, Sampler};

/// Eases at which the table has values. At 6 an error of direction misses once in 5·10⁸ shots.
const EASES: [f64; 10] = [0.0, 0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0];
/// Cosines of the cut angle at which the table has values: 82°, 66°, 46°, 26° and 0°.
const FULLNESSES: [f64; 5] = [0.139, 0.4, 0.7, 0.9, 1.0];
/// Number of measured lines. The table's standard error is then about 0.03 where lines are
/// frequent. Guess: no paper gives the number of its simulations.
const LINES: u32 = 400;
/// Layouts that are tried for these lines, so that a table without pots cannot take for ever.
const LAYOUTS: u32 = 4 * LINES;
/// Drawn strikes of each line.
const VARIANTS: u64 = 4;
/// Weight of the geometric chance in each value, in drawn strikes. It fills cells without lines.
const PRIOR: f64 = 6.0;
/// Cue speeds of the measured shots, m/s: a soft, a usual and a firm stroke.
const SPEEDS: [f64; 3] = [1.2, 2.2, 3.6];
/// Seed of the drawn strikes. Tables of the same noise are equal in every decision.
const SEED: u64 = 0x0070_6F74;
/// Share of a chance that remains after a cushion. Guess: Smith (2007) estimates banks and kicks
/// by a table of their own, which is not printed.
const KEPT_AT_CUSHION: f64 = 0.7;
/// The additive recurrence of Roberts (2018) in four dimensions: powers of 1/φ₄, where φ₄ is the
/// real root of x⁵ = x + 1.
const STEPS: [f64; 4] =
    [0.856_674_883_854_5, 0.733_891_856_627_1, 0.628_706_721_077_8, 0.538_597_264_4];

/// Probabilities of pots for one table, one physics and one noise.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct PotTable {
    noise: Noise,
    values: [[f64; EASES.len()]; FULLNESSES.len()],
}

impl PotTable {
    /// Measures the table on the frame's table with its physics, for a player with these errors.
    ///
    /// # Errors
    /// As [`Sampler::simulate_variant`].
    pub(crate) fn measure(frame: &Frame, noise: Noise) -> Result<Self, Error> {
        let mut sums = Sums::default();
        let base = frame.base();
        let mut practice = practice(base)?;
        let half = Scene::new(frame).half_area(base.physics().ball.radius);
        let mut sampler = Sampler::new();
        let mut point = [0.5; 4];
        let mut measured = 0;
        for k in 0..LAYOUTS {
            if measured == LINES {
                break;
            }
            for (x, step) in point.iter_mut().zip(STEPS) {
                *x = (*x + step) % 1.0;
            }
            // Cue ball and object ball anywhere on the table, file coordinates.
            let middle = base.table().center();
            let place = |x: f64, y: f64| {
                Some([middle.x + (2.0 * x - 1.0) * half.x, middle.y + (2.0 * y - 1.0) * half.y])
            };
            let mut places = vec![None; practice.layout().len()];
            places[0] = place(point[0], point[1]);
            places[1] = place(point[2], point[3]);
            practice.resume_at(&places, 0)?;
            // Layouts with overlapping balls are left out.
            let Ok(prepared) = Prepared::new(&practice, None) else { continue };
            let used = measure_layout(&prepared, k, &noise, &mut sampler, &mut sums)?;
            measured += u32::from(used);
        }
        Ok(Self { noise, values: sums.values() })
    }

    /// The table of geometry alone, without measured lines.
    pub(crate) fn geometric(noise: Noise) -> Self {
        Self { noise, values: Sums::default().values() }
    }

    /// The probability that the ball of `line` falls; `radius` is the cue ball's, m.
    pub(crate) fn chance(&self, line: &Line, radius: f64) -> f64 {
        let cushions: u8 = line.legs().iter().map(|leg| leg.cushions).sum();
        let kept = (0..cushions).fold(1.0, |kept, _| kept * KEPT_AT_CUSHION);
        kept * self.of_direction(line.tolerance, line.fullness, radius)
    }

    /// The probability of a pot without cushions: `tolerance` is half of the width of the cue
    /// ball's directions, rad; `fullness` the cosine of the cut angle; `radius` the cue ball's, m.
    pub(crate) fn of_direction(&self, tolerance: f64, fullness: f64, radius: f64) -> f64 {
        let ease = tolerance / direction_error(&self.noise, radius);
        let (i, s) = cell(&FULLNESSES, fullness);
        let (j, t) = cell(&EASES, ease);
        let along = |row: &[f64; EASES.len()]| row[j] * (1.0 - t) + row[j + 1] * t;
        along(&self.values[i]) * (1.0 - s) + along(&self.values[i + 1]) * s
    }
}

/// Plays one line of a layout with drawn errors. Returns whether there was one.
fn measure_layout(
    prepared: &Prepared<'_>,
    k: u32,
    noise: &Noise,
    sampler: &mut Sampler,
    sums: &mut Sums,
) -> Result<bool, Error> {
    let scene = Scene::new(prepared.frame());
    let (Some(cue), Some(object)) = (scene.ball(0), scene.ball(1)) else { return Ok(false) };
    let pockets = scene.table.pockets.len();
    // Another pocket and another speed each time.
    let line = (0..pockets)
        .filter_map(|n| straight_to_pocket(&scene, cue, object, (n + k as usize) % pockets))
        .next();
    let Some(line) = line else { return Ok(false) };
    let speed = SPEEDS[k as usize % SPEEDS.len()];
    let start = Strike { speed, azimuth: line.azimuth, elevation: 0.0, side: 0.0, height: 0.0 };
    let start = Strike { elevation: prepared.shot().default_elevation(&start), ..start };
    let start = AimStart { strike: start, slope: line.slope };
    let aimed = aim(sampler, prepared, &line, start, &mut 0)?;
    let Some(aimed) = aimed.filter(|aimed| aimed.is_potted) else { return Ok(false) };
    let errors = Errors { noise: noise.clone(), perception: Perception::default(), seed: SEED };
    let pocket = scene.table.pockets[line.pocket].name;
    let mut successor = prepared.frame().clone();
    let mut hits = 0.0;
    for n in 0..VARIANTS {
        let index = u64::from(k) * VARIANTS + n;
        sampler.simulate_variant(prepared, &aimed.strike, &errors, index)?;
        sampler.rule(prepared, Call::Nothing, &mut successor)?;
        hits += f64::from(u8::from(sampler.outcome().pocketed.contains(&(1, pocket))));
    }
    let ease = line.tolerance / direction_error(noise, cue.radius);
    sums.add(line.fullness, ease, hits, VARIANTS as f64);
    Ok(true)
}

/// A frame of practice on the table and with the physics of `base`.
fn practice(base: &carom::Shot) -> Result<Frame, Error> {
    let file = base.to_node();
    let (table, physics) = (file.get("table").cloned(), file.get("physics").cloned());
    Frame::new(Game::Practice, Options::default(), table, physics, 0)
}

/// Hits and drawn strikes around each value of the table.
#[derive(Default)]
struct Sums {
    cells: [[[f64; 2]; EASES.len()]; FULLNESSES.len()],
}

impl Sums {
    /// Shares `hits` of `count` strikes among the four values around a line.
    fn add(&mut self, fullness: f64, ease: f64, hits: f64, count: f64) {
        let (i, s) = cell(&FULLNESSES, fullness);
        let (j, t) = cell(&EASES, ease);
        for (row, down) in [(i, 1.0 - s), (i + 1, s)] {
            for (column, along) in [(j, 1.0 - t), (j + 1, t)] {
                let [sum, weight] = &mut self.cells[row][column];
                *sum += down * along * hits;
                *weight += down * along * count;
            }
        }
    }

    fn values(&self) -> [[f64; EASES.len()]; FULLNESSES.len()] {
        self.cells.map(|row| {
            let mut values = [0.0; EASES.len()];
            for ((value, [hits, count]), ease) in values.iter_mut().zip(row).zip(EASES) {
                *value = (hits + PRIOR * libm::erf(ease / SQRT_2)) / (count + PRIOR);
            }
            values
        })
    }
}

/// The interval of `nodes` that holds `x`, and the share of the interval before `x`; the ends for
/// an `x` outside.
fn cell(nodes: &[f64], x: f64) -> (usize, f64) {
    let i = nodes[1..nodes.len() - 1].iter().take_while(|node| **node <= x).count();
    let share = (x - nodes[i]) / (nodes[i + 1] - nodes[i]);
    (i, share.clamp(0.0, 1.0))
}

/// A table, and the frame's table and physics for which it was measured.
type Entry = (String, Arc<PotTable>);

/// Tables that were measured before. Clones share them.
#[derive(Clone, Debug, Default)]
pub(crate) struct PotTables {
    entries: Arc<Mutex<Vec<Entry>>>,
}

impl PotTables {
    /// The table of the frame's table and physics for this noise. It is measured when it is first
    /// asked for; the measurement belongs to no decision, so it is not part of any budget.
    ///
    /// # Errors
    /// As [`PotTable::measure`].
    pub(crate) fn table(&self, frame: &Frame, noise: &Noise) -> Result<Arc<PotTable>, Error> {
        let file = frame.base().to_node();
        let setup = format!("{:?} {:?}", file.get("table"), file.get("physics"));
        let mut entries = self.entries.lock().unwrap_or_else(PoisonError::into_inner);
        let known = entries.iter().find(|(of, table)| *of == setup && table.noise == *noise);
        if let Some((_, table)) = known {
            return Ok(Arc::clone(table));
        }
        let table = Arc::new(PotTable::measure(frame, noise.clone())?);
        entries.push((setup, Arc::clone(&table)));
        Ok(table)
    }
}

/// The kinds of line in the order in which players look at them.
pub(crate) const EVERY_KIND: [LineKind; 4] =
    [LineKind::Direct, LineKind::Combination, LineKind::Bank, LineKind::Kick];

#[cfg(test)]
mod tests {
    use super::{PotTable, PotTables, cell};
    use carom::Noise;
    use carom_rules::{Frame, Game, Options};
    use std::sync::Arc;

    fn frame() -> Frame {
        Frame::new(Game::EightBall, Options::default(), None, None, 1).expect("a frame")
    }

    #[test]
    fn wide_windows_and_small_errors_make_pots_more_probable() {
        let usual = PotTable::measure(&frame(), Noise::olympiad(1.0)).expect("a table");
        let chance = |tolerance| usual.of_direction(tolerance, 0.8, 0.028_575);
        assert!(chance(0.001) < chance(0.004), "{} {}", chance(0.001), chance(0.004));
        assert!(chance(0.02) > 0.9, "{}", chance(0.02));
        let weak = PotTable::measure(&frame(), Noise::olympiad(3.0)).expect("a table");
        assert!(weak.of_direction(0.004, 0.8, 0.028_575) < chance(0.004));
    }

    #[test]
    fn a_table_is_measured_once_for_each_noise() {
        let tables = PotTables::default();
        let first = tables.table(&frame(), &Noise::olympiad(1.0)).expect("a table");
        let again = tables.clone().table(&frame(), &Noise::olympiad(1.0)).expect("a table");
        let other = tables.table(&frame(), &Noise::olympiad(2.0)).expect("a table");
        assert!(Arc::ptr_eq(&first, &again));
        assert!(!Arc::ptr_eq(&first, &other));
    }

    #[test]
    fn a_place_between_two_values_is_found_and_one_outside_is_clamped() {
        assert_eq!(cell(&[0.0, 1.0, 3.0], 2.0), (1, 0.5));
        assert_eq!(cell(&[0.0, 1.0, 3.0], -1.0), (0, 0.0));
        assert_eq!(cell(&[0.0, 1.0, 3.0], 9.0), (1, 1.0));
    }
}
