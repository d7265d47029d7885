//! The kinds of listed plays.
//!
//! A search moves the strikes of plays, and it tries hits anywhere. So a play that was found as a safety may
//! pot a ball in the end, and a pot that was found without a line may lie on a direct one.

use carom::Error;
use carom::math::sin_cos;
use carom::table::PocketName;
use carom_rules::{BallIndex, Rules};

use super::candidate::{Candidate, PlayKind};
use super::explore::Explorer;
use crate::line::{Line, LineKind};
use carom_plan::Prepared;

/// Sine of the largest angle between the object ball's path and a direct line on which it falls: 8°. Throw
/// turns a path by up to about 5°.
const THROWN: f64 = 0.14;

impl Explorer<'_> {
    /// Gives a safety or a pot without a line the kind of what its strike does without errors. `lines` are
    /// those from the play's position.
    ///
    /// # Errors
    /// As [`Explorer::ruled`].
    pub(crate) fn name(
        &mut self,
        candidate: &mut Candidate,
        prepared: &Prepared<'_>,
        lines: &[Line],
    ) -> Result<(), Error> {
        if !matches!(candidate.kind, PlayKind::Safety | PlayKind::Indirect) {
            return Ok(());
        }
        self.plays += 1;
        if self.sampler.simulate(prepared, &candidate.play.strike).is_err() {
            return Ok(());
        }
        let (_, is_legal) = self.ruled(prepared, candidate.play.call)?;
        if !is_legal || !self.successor.keeps_turn(self.seat()) {
            return Ok(());
        }
        if self.situation.frame.rules() == Rules::ThreeCushion {
            candidate.kind = PlayKind::Carom;
            return Ok(());
        }
        let Some(pot) = candidate.pot.or_else(|| self.potted()) else { return Ok(()) };
        let line = self.direct_line(pot, candidate.play.strike.azimuth, prepared, lines);
        candidate.kind = line.map_or(PlayKind::Indirect, |line| PlayKind::Pot(line.kind));
        (candidate.pot, candidate.line) = (Some(pot), line);
        Ok(())
    }

    /// The direct line on which the last simulation potted a ball; none if it was potted in another way.
    fn direct_line(
        &self,
        pot: (BallIndex, PocketName),
        azimuth: f64,
        prepared: &Prepared<'_>,
        lines: &[Line],
    ) -> Option<Line> {
        let outcome = self.sampler.outcome();
        let hits_it_first = outcome.first_contact == Some(pot.0)
            && outcome.rails_before_first_contact().next().is_none();
        let is_followed = |line: &&Line| {
            let off = sin_cos(azimuth - line.azimuth).0 * line.slope;
            line.kind == LineKind::Direct
                && line.pot(prepared.shot().table()) == pot
                && off.abs() < THROWN * line.lengths[1]
        };
        lines.iter().find(is_followed).copied().filter(|_| hits_it_first)
    }
}
