//! What a play is worth, for the example that compares plays.

use carom::Error;
use carom::noise::Errors;
use carom_mind::value::{Logistic, Position, Value};
use carom_plan::{Prepared, Sampler};
use carom_rules::{Play, Seat};

/// The mean value for `seat` of what `play` leaves with the first `count` of these errors, and the share of
/// them with which the player who shoots keeps the turn or wins.
pub(crate) fn judge(
    sampler: &mut Sampler,
    position: &Position<'_>,
    play: &Play,
    (errors, count): (&Errors, u64),
    seat: Seat,
) -> Result<(f64, f64), Error> {
    let Position { frame, noise } = *position;
    let mut successor = frame.clone();
    let prepared = Prepared::new(frame, play.cue_ball)?;
    let (mut sum, mut kept) = (0.0, 0_u64);
    for index in 0..count {
        sampler.simulate_variant(&prepared, &play.strike, errors, index)?;
        sampler.rule(&prepared, play.call, &mut successor)?;
        sum += Logistic.win_chance(&Position { frame: &successor, noise }, seat);
        kept += u64::from(frame.player().is_some_and(|seat| successor.keeps_turn(seat)));
    }
    Ok((sum / count as f64, kept as f64 / count as f64))
}
