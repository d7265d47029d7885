//! The frames that may follow a play under the errors of a player.

use core::ops::Range;

use carom::noise::Errors;
use carom::resolve::cue_ball::Strike;
use carom::runner::Runner;
use carom::{Error, ErrorKind};
use carom_rules::{Frame, Play, Prepared, Ruling};

use crate::sampler::Sampler;

/// Variants that one thread plays at a time: some tenths of a millisecond of work.
const CHUNK: u64 = 16;

/// A frame that may follow a play.
#[derive(Clone, Debug)]
pub struct Successor {
    /// The frame after the play.
    pub frame: Frame,
    /// The ruling.
    pub ruling: Ruling,
    /// The strike as it was executed.
    pub executed: Strike,
}

/// The frames that follow the `variants` of a play with drawn errors, in order. They are the variants of
/// [`crate::evaluate()`] with the same errors. The result does not depend on the number of threads.
///
/// # Errors
/// [`Error::Input`] if the frame does not allow the play, for errors out of range, and for a variant that
/// cannot be played; [`Error::TooManyEvents`] if a variant reaches its cap of events.
pub fn successors(
    frame: &Frame,
    play: &Play,
    errors: &Errors,
    variants: Range<u64>,
    runner: &Runner,
) -> Result<Vec<Successor>, Error> {
    errors.check()?;
    let prepared = Prepared::of_play(frame, play)?;
    let Some((_, meant)) = prepared.shot().strike() else {
        return Err(ErrorKind::NoStrike.at("strike", "the play has no strike", "give it one"));
    };
    let struck = prepared.struck_ball();
    let starts = variants.clone().step_by(CHUNK as usize);
    let played = runner.map(starts, Sampler::new, |sampler, start| {
        let chunk = start..(start + CHUNK).min(variants.end);
        chunk
            .map(|index| {
                let executed = errors.noise.draw(&meant, &struck, errors.seed, index);
                sampler.simulate_executed(&prepared, &executed, errors, index)?;
                let mut after = frame.clone();
                let ruling = sampler.rule(&prepared, play.call, &mut after)?;
                Ok(Successor { frame: after, ruling, executed })
            })
            .collect::<Result<Vec<_>, Error>>()
    });
    Ok(played.into_iter().collect::<Result<Vec<_>, _>>()?.concat())
}
