//! Which conditions a shot meets.

use carom::outcome::Touched;
use carom::{Error, ErrorKind, Shot};

use crate::area::DrillArea;
use crate::goal::DrillCondition;
use crate::lanes;
use crate::played::Played;

/// A shot that was played, with its cue ball.
pub(crate) struct Met<'a> {
    shot: &'a Shot,
    played: &'a Played,
    cue: usize,
}

impl<'a> Met<'a> {
    /// # Errors
    /// [`Error::Input`] if the shot has no cue ball.
    pub(crate) fn of(shot: &'a Shot, played: &'a Played) -> Result<Self, Error> {
        let cue = shot.cue_ball().ok_or_else(|| {
            let remedy = "give it one: it names the cue ball";
            ErrorKind::NoStrike.at("strike", "the shot has no strike", remedy)
        })?;
        Ok(Self { shot, played, cue })
    }

    /// Whether the cue ball fell or left the table.
    pub(crate) fn is_cue_ball_lost(&self) -> bool {
        self.played.is_gone(self.cue)
    }

    /// The index of the first condition that is not met. If a ball stopped outside its area, also how far, m.
    ///
    /// # Errors
    /// [`Error::Input`] if a condition names a ball that the shot lacks.
    pub(crate) fn first_unmet(
        &self,
        needs: &[DrillCondition],
    ) -> Result<Option<(usize, Option<f64>)>, Error> {
        for (index, need) in needs.iter().enumerate() {
            if !self.holds(need)? {
                let outside = match need {
                    DrillCondition::Stop(ball, area) => self.outside(ball.as_ref(), area)?,
                    _ => None,
                };
                return Ok(Some((index, outside)));
            }
        }
        Ok(None)
    }

    /// How far outside an area the cue ball stopped, m.
    pub(crate) fn cue_ball_outside(&self, area: &DrillArea) -> f64 {
        area.distance(self.shot.table(), self.played.places[self.cue])
    }

    /// The same of a ball, or else of the cue ball; none if it is not on the table.
    fn outside(&self, ball: Option<&String>, area: &DrillArea) -> Result<Option<f64>, Error> {
        let ball = ball.map_or(Ok(self.cue), |ball| self.index(ball))?;
        let distance = || area.distance(self.shot.table(), self.played.places[ball]);
        Ok((!self.played.is_gone(ball)).then(distance))
    }

    fn holds(&self, condition: &DrillCondition) -> Result<bool, Error> {
        let (Self { shot, played, cue }, outcome) = (self, &self.played.outcome);
        Ok(match condition {
            DrillCondition::Pot(ball, into) => {
                let ball = self.index(ball)? as u16;
                let is_it = |wanted| into.is_none_or(|into| into == wanted);
                outcome.pocketed.iter().any(|(fell, pocket)| *fell == ball && is_it(*pocket))
            }
            DrillCondition::PotAny => {
                outcome.pocketed.iter().any(|(fell, _)| usize::from(*fell) != *cue)
            }
            DrillCondition::First(ball) => outcome.first_contact == Some(self.index(ball)? as u16),
            DrillCondition::Kick(least) => {
                outcome.rails_before_first_contact().count() >= *least as usize
            }
            DrillCondition::Cushions(ball, least) => played.noses[self.index(ball)?] >= *least,
            DrillCondition::Carom(least) => self.caroms(*least),
            DrillCondition::Touch(balls) => {
                let touched = |ball: &String| self.index(ball).map(|ball| self.touches(ball));
                balls.iter().map(touched).collect::<Result<Vec<_>, _>>()?.iter().all(|met| *met)
            }
            DrillCondition::Avoid(ball) => !self.touches(self.index(ball)?),
            DrillCondition::Stop(ball, area) => self.outside(ball.as_ref(), area)? == Some(0.0),
            DrillCondition::Hidden(ball) => lanes::is_hidden(shot, played, *cue, self.index(ball)?),
            DrillCondition::Next(ball) => lanes::can_pot(shot, played, *cue, self.index(ball)?),
            DrillCondition::Apart([a, b], distance) => {
                lanes::are_apart(played, [self.index(a)?, self.index(b)?], *distance)
            }
            DrillCondition::Gather(distance) => lanes::are_gathered(played, *cue, *distance),
        })
    }

    fn touches(&self, ball: usize) -> bool {
        self.played.outcome.cue_ball_touched.contains(&Touched::Ball(ball as u16))
    }

    /// Whether the cue ball meets two balls, the second one after `least` cushions.
    fn caroms(&self, least: u32) -> bool {
        let (mut cushions, mut first) = (0, None);
        for touched in &self.played.outcome.cue_ball_touched {
            match (touched, first) {
                (Touched::Rail(_), _) => cushions += 1,
                (Touched::Ball(ball), None) => first = Some(*ball),
                (Touched::Ball(ball), Some(known)) if *ball != known => return cushions >= least,
                (Touched::Ball(_), Some(_)) => {}
            }
        }
        false
    }

    fn index(&self, id: &str) -> Result<usize, Error> {
        self.shot.ball_index(id).ok_or_else(|| {
            let what = format!("the shot has no ball \"{id}\"");
            ErrorKind::UnknownBall.at("goal", what, "name a ball of the shot").with("ball", id)
        })
    }
}
