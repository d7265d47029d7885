//! Samples of the frames that may follow a play.
//!
//! A search asks for many successors of a frame: with other strikes, with other errors of the same
//! strike, with other calls. A [`Sampler`] simulates each strike once and rules on it for any
//! number of calls. In steady state it allocates nothing, except for a new rack.
//!
//! ```
//! use carom::Noise;
//! use carom::noise::Errors;
//! use carom::resolve::cue_ball::Strike;
//! use carom_plan::{Prepared, Sampler};
//! use carom_rules::{Call, Frame, Options, Game};
//!
//! # fn main() -> Result<(), carom::Error> {
//! let frame = Frame::new(Game::NineBall, Options::default(), None, None, 7)?;
//! let prepared = Prepared::new(&frame, Some([0.635, 0.6]))?;
//! let meant = Strike { speed: 8.0, azimuth: 1.57, elevation: 0.0, side: 0.0, height: 0.0 };
//! let errors = Errors { noise: Noise::olympiad(1.0), seed: 5, ..Errors::default() };
//! let (mut sampler, mut successor) = (Sampler::new(), frame.clone());
//! let mut kept = 0;
//! for index in 0..20 {
//!     sampler.simulate_variant(&prepared, &meant, &errors, index)?;
//!     sampler.rule(&prepared, Call::Nothing, &mut successor)?;
//!     kept += u32::from(successor.player() == frame.player());
//! }
//! println!("the player shoots again in {kept} of 20 variants");
//! # Ok(())
//! # }
//! ```

use carom::event::Recorder;
use carom::noise::Errors;
use carom::outcome::Outcome;
use carom::resolve::cue_ball::Strike;
use carom::{BallState, Error, Shot};
use carom_rules::{Call, Frame, FrameSimulator, Prepared, Ruling};

/// Simulates strikes of prepared shots and their variants, and rules on them, in memory that is
/// used again. One thread needs one sampler.
#[derive(Clone, Debug, Default)]
pub struct Sampler {
    simulator: FrameSimulator,
    /// Room for a shot with displaced balls or with contacts that cling.
    variant: Option<Shot>,
}

impl Sampler {
    /// A sampler that has simulated nothing yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// Simulates `strike` once, exactly as it is given. The result stays here until the next
    /// simulation.
    ///
    /// # Errors
    /// [`Error::Input`] if the strike cannot be played, and [`Error::TooManyEvents`] if the shot
    /// reaches its cap on events.
    pub fn simulate(&mut self, prepared: &Prepared<'_>, strike: &Strike) -> Result<(), Error> {
        self.simulator.simulate(prepared, strike)
    }

    /// As [`Self::simulate`]; `recorder` gets every event too.
    ///
    /// # Errors
    /// As [`Self::simulate`].
    pub fn simulate_recorded(
        &mut self,
        prepared: &Prepared<'_>,
        strike: &Strike,
        recorder: &mut dyn Recorder,
    ) -> Result<(), Error> {
        self.simulator.simulate_recorded(prepared, strike, recorder)
    }

    /// Simulates variant `index` of the strike `meant` under `errors`: with the strike that is
    /// drawn ([`carom::Noise::draw`]), with the balls where they truly lie, and with the contacts
    /// that cling. `errors` must have passed [`Errors::check`].
    ///
    /// # Errors
    /// As [`Self::simulate`]. A drawn strike can be played if `meant` can, except where
    /// [`carom::noise`] says otherwise.
    pub fn simulate_variant(
        &mut self,
        prepared: &Prepared<'_>,
        meant: &Strike,
        errors: &Errors,
        index: u64,
    ) -> Result<(), Error> {
        let struck = prepared.struck_ball();
        let strike = errors.noise.draw(meant, &struck, errors.seed, index);
        self.simulate_executed(prepared, &strike, errors, index)
    }

    /// As [`Self::simulate_variant`], with the strike that is executed in place of the one that is
    /// drawn.
    ///
    /// # Errors
    /// As [`Self::simulate`].
    pub fn simulate_executed(
        &mut self,
        prepared: &Prepared<'_>,
        executed: &Strike,
        errors: &Errors,
        index: u64,
    ) -> Result<(), Error> {
        self.simulate_on(prepared, prepared.shot(), executed, errors, index)
    }

    /// As [`Self::simulate_executed`], on the table and with the physics of `shot`, which has the
    /// balls of `prepared` and its own places of them.
    ///
    /// # Errors
    /// As [`Self::simulate`].
    pub fn simulate_on(
        &mut self,
        prepared: &Prepared<'_>,
        shot: &Shot,
        executed: &Strike,
        errors: &Errors,
        index: u64,
    ) -> Result<(), Error> {
        if errors.are_of_the_strike() {
            return self.simulator.simulate_shot(prepared, shot, executed).map(drop);
        }
        let variant = self.variant.get_or_insert_with(|| shot.clone());
        errors.write_shot(shot, index, variant);
        self.simulator.simulate_shot(prepared, variant, executed).map(drop)
    }

    /// Rules on the last simulation, which was one of `prepared`, as if `call` had been announced.
    /// `successor` becomes the frame after the shot; its memory is used again. Can be called again
    /// with other calls.
    ///
    /// # Errors
    /// [`Error::Input`] if the call is missing or not allowed. `successor` is unchanged then.
    ///
    /// # Panics
    /// If the last simulation failed, or had other balls than `prepared`.
    pub fn rule(
        &self,
        prepared: &Prepared<'_>,
        call: Call,
        successor: &mut Frame,
    ) -> Result<Ruling, Error> {
        self.simulator.rule(prepared, call, successor)
    }

    /// The outcome of the last simulation. Balls are indices of the frame.
    pub const fn outcome(&self) -> &Outcome {
        self.simulator.outcome()
    }

    /// The final states of the last simulation (file coordinates), before any ball was spotted, in
    /// the order of [`Prepared::balls`]; empty if it failed.
    pub fn last(&self) -> &[BallState] {
        self.simulator.last()
    }
}
