//! Frames that begin in the middle.

use carom::shot::PlacedBall;
use carom::{Error, MotionState, Shot};

use super::Frame;
use crate::games::{Options, Rules, snooker};
use crate::{BallIndex, Player};

/// With fewer object balls straight pool racks the others again (WPA 4.4).
const LEAST_IN_STRAIGHT_POOL: usize = 2;

impl Frame {
    /// A frame on the table and under the physics of `shot` that goes on, as [`Self::scatter`] has it, with the
    /// balls where the shot has them; player 0 shoots. Balls that the shot does not have are down.
    ///
    /// # Errors
    /// As [`Self::new`] and [`Self::scatter`], and [`Error::Input`] for balls that the game does not have, that
    /// have another mass or radius there, that move, or are in the air.
    pub fn of_shot(rules: Rules, options: Options, shot: &Shot) -> Result<Self, Error> {
        let file = shot.to_node();
        let (table, physics) = (file.get("table").cloned(), file.get("physics").cloned());
        let mut frame = Self::new(rules, options, table, physics, 0)?;
        let mut places = vec![None; frame.layout().len()];
        for (i, PlacedBall { id, ball, state }) in shot.balls().iter().enumerate() {
            let index = usize::from(frame.ball(id, &format!("balls[{i}].id"))?);
            let wrong = |what: &str, remedy| Err(Error::input(format!("balls[{i}]"), what, remedy));
            if *ball != frame.layout().pieces()[index].ball {
                return wrong("mass or radius are not the game's", "leave them out");
            }
            if state.motion != MotionState::Stationary {
                return wrong("it moves, and all is at rest when a shot is asked", "let it rest");
            }
            places[index] = Some([state.position.x, state.position.y]);
        }
        frame.scatter(&places, 0)?;
        Ok(frame)
    }

    /// Goes on with the balls at `places` (one for each ball of the layout, in the file's frame, m; none for
    /// a ball that is down), and `player` shoots next, from where the cue ball lies: to begin in the middle.
    /// It is as if nothing else had happened: scores and fouls stay as they are, in eight-ball the table is
    /// open, in snooker reds are on while there are any, then the colours in their order.
    ///
    /// # Errors
    /// [`Error::Input`] for another number of places than of balls, another player than 0 and 1, and for
    /// balls that are not there though the game would be over, or would have put them back: the 8, the 9,
    /// the 10 in their games; all but one in straight pool; in snooker the black, or colours that are not
    /// the next of their order or go before the last red; any in three-cushion. Whether balls overlap, the
    /// next shot says.
    pub fn scatter(&mut self, places: &[Option<[f64; 2]>], player: Player) -> Result<(), Error> {
        let wrong = |what: String, remedy: &str| Err(Error::input("places", what, remedy));
        if places.len() != self.state.layout.len() {
            let what = format!("{} for {} balls", places.len(), self.state.layout.len());
            return wrong(what, "give one for every ball");
        }
        if player > 1 {
            return Err(Error::input("player", format!("{player} does not play"), "write 0 or 1"));
        }
        if let Some(what) = missing(self.rules, places) {
            return wrong(what, "put them on the table");
        }
        for (ball, place) in (0..).zip(places) {
            self.state.layout.put(ball, *place);
        }
        self.progress.restart(&self.state);
        self.request = self.law.game_mut().middle(&self.state, player);
        Ok(())
    }
}

/// What cannot be down while the game goes on, if something of it is.
fn missing(rules: Rules, places: &[Option<[f64; 2]>]) -> Option<String> {
    let is_down = |ball: BallIndex| places[usize::from(ball)].is_none();
    if let Some(ball) = rules.deciding_ball() {
        return is_down(ball).then(|| format!("the {ball} is down"));
    }
    match rules {
        Rules::StraightPool => {
            let left = places[1..].iter().flatten().count();
            let few = left < LEAST_IN_STRAIGHT_POOL;
            few.then(|| format!("of the object balls only {left} are left"))
        }
        Rules::Snooker => {
            let red_left = snooker::REDS.into_iter().any(|red| !is_down(red));
            let next = snooker::COLORS.into_iter().find(|color| red_left || !is_down(*color));
            let next = next.unwrap_or(snooker::BLACK);
            let gone = (next..=snooker::BLACK).find(|color| is_down(*color))?;
            Some(format!("the colour of {} points is down", snooker::value(gone)))
        }
        Rules::ThreeCushion => {
            places.contains(&None).then(|| "a ball is not on the table".to_owned())
        }
        _ => None,
    }
}
