//! Breaks: many racks, each racked and struck a little differently.

use carom::batch::{self, BatchResult, OFF_TABLE};
use carom::rack::{Break, break_shot};
use carom::runner::Runner;
use carom::{Error, ErrorKind, Shot};
use carom_rules::GameFacts;

use crate::error_model::ErrorModel;
use crate::progress::Progress;

/// Racks between two checks of the precision. The last round may be shorter.
pub const RACKS_PER_ROUND: u64 = 1024;
/// Largest number of racks. A million snooker racks hold about 600 MB of final positions.
pub const MOST_RACKS: u64 = 1_000_000;

/// The results of many breaks.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BreakStatistics {
    /// The end of every break, with the balls in the order of the first rack.
    pub result: BatchResult,
    /// Number of breaks in which at least one object ball fell.
    pub any_potted: u64,
    /// Number of breaks in which at least one object ball fell and the cue ball did not.
    pub any_potted_without_scratch: u64,
    /// Number of breaks in which the cue ball fell.
    pub scratched: u64,
    /// Number of breaks in which a ball left the table.
    pub any_off_table: u64,
    /// Number of breaks in which each ball fell, in the order of `result`.
    pub ball_potted: Vec<u64>,
    /// Number of breaks in which at least one ball fell into each pocket.
    pub pocket_used: Vec<u64>,
}

impl BreakStatistics {
    fn new(balls: usize, pockets: usize) -> Self {
        Self {
            result: BatchResult { balls, ..BatchResult::default() },
            ball_potted: vec![0; balls],
            pocket_used: vec![0; pockets],
            ..Self::default()
        }
    }

    /// Adds the one row of `row`. The cue ball is its first ball.
    fn add(&mut self, row: BatchResult) {
        let pockets = &row.pocket;
        let scratched = pockets.first().is_some_and(|p| *p >= 0);
        let any_potted = pockets.iter().skip(1).any(|p| *p >= 0);
        self.any_potted += u64::from(any_potted);
        self.any_potted_without_scratch += u64::from(any_potted && !scratched);
        self.scratched += u64::from(scratched);
        self.any_off_table += u64::from(pockets.contains(&OFF_TABLE));
        for (count, pocket) in self.ball_potted.iter_mut().zip(pockets) {
            *count += u64::from(*pocket >= 0);
        }
        for (pocket, count) in self.pocket_used.iter_mut().enumerate() {
            *count += u64::from(pockets.contains(&(pocket as i8)));
        }
        let result = &mut self.result;
        result.errors.extend(row.errors.into_iter().map(|(_, error)| (result.shots, error)));
        result.shots += 1;
        result.final_position.extend(row.final_position);
        result.pocket.extend(row.pocket);
        result.events.extend(row.events);
    }

    /// The counts whose precision decides when to stop: all except the cue ball's entry in
    /// `ball_potted`, which equals `scratched`.
    fn counts(&self) -> impl Iterator<Item = u64> + '_ {
        let any = [self.any_potted, self.any_potted_without_scratch, self.scratched];
        let each = self.ball_potted.iter().skip(1).chain(&self.pocket_used).copied();
        any.into_iter().chain([self.any_off_table]).chain(each)
    }
}

/// Breaks up to `model.variants` racks. Row k is rack `opening.seed` + k, struck with error number k of
/// `model.seed`. Racks have their balls in various orders; the rows have them in the order of the first
/// rack. The precision is checked after every [`RACKS_PER_ROUND`] racks. If `progress` is stopped, the
/// result holds the rounds that were completed.
///
/// # Errors
/// [`Error::Input`] for what [`break_shot`] and [`ErrorModel::check`] reject, for more than
/// [`MOST_RACKS`], and for a pool or snooker game on a table without pockets.
pub fn breaks(
    opening: &Break<'_>,
    model: &ErrorModel,
    threads: Option<usize>,
    progress: &Progress,
) -> Result<BreakStatistics, Error> {
    model.check()?;
    if !(1..=MOST_RACKS).contains(&model.variants) {
        let what = format!("{} is out of range", model.variants);
        return Err(ErrorKind::OutOfRange.at("racks", what, format!("give 1 to {MOST_RACKS}")));
    }
    let columns = break_shot(opening)?;
    if columns.table().pockets.is_empty() && !GameFacts::of(opening.game).is_carom() {
        let what = format!("{} needs a table with pockets", opening.game.name());
        return Err(ErrorKind::Unsupported.at(
            "table",
            what,
            "choose a table for this game, or leave it out",
        ));
    }
    let runner = Runner::new(threads)?;
    let mut statistics = BreakStatistics::new(columns.balls().len(), columns.table().pockets.len());
    progress.begin(0, model.variants as usize);
    let mut first = 0;
    while first < model.variants && !progress.is_stopped() {
        let end = model.variants.min(first + RACKS_PER_ROUND);
        let rows = runner.map(
            first..end,
            || (),
            |(), k| {
                // An unfinished round is dropped as a whole.
                let row = (!progress.is_stopped()).then(|| one_break(opening, model, k, &columns));
                progress.add(1);
                row
            },
        );
        let Some(rows) = rows.into_iter().collect::<Option<Vec<_>>>() else { break };
        for row in rows {
            statistics.add(row?);
        }
        first = end;
        if model.is_precise(statistics.counts(), first) {
            break;
        }
    }
    Ok(statistics)
}

/// The break of rack number `k`, with its balls in the order of `columns`.
fn one_break(
    opening: &Break<'_>,
    model: &ErrorModel,
    k: u64,
    columns: &Shot,
) -> Result<BatchResult, Error> {
    let shot = break_shot(&Break { seed: opening.seed.wrapping_add(k), ..*opening })?;
    let strikes = batch::draw_strikes(&shot, &model.noise, 1, model.seed, k)?;
    let one = Runner::new(Some(1))?;
    let mut row = batch::simulate_variants(&shot, &strikes, &model.errors(), k, &one)?;
    let order: Vec<usize> =
        columns.balls().iter().filter_map(|ball| shot.ball_index(&ball.id)).collect();
    row.pocket = order.iter().map(|i| row.pocket[*i]).collect();
    row.final_position = order.iter().map(|i| row.final_position[*i]).collect();
    Ok(row)
}
