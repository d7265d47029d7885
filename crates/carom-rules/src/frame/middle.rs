//! Frames that begin in the middle.

use carom::Error;

use super::Frame;
use crate::games::{Rules, snooker};
use crate::{BallIndex, Player};

/// With fewer object balls straight pool racks the others again (WPA 4.4).
const LEAST_IN_STRAIGHT_POOL: usize = 2;

impl Frame {
    /// Goes on with the balls at `places` (one for each ball of the layout, in the file's frame, m; none for
    /// a ball that is down), and `player` shoots next, from where the cue ball lies: to begin in the middle.
    /// It is as if nothing else had happened: scores and fouls stay as they are, in eight-ball the table is
    /// open, in snooker reds are on while there are any, then the colours in their order.
    ///
    /// # Errors
    /// [`Error::Input`] for another number of places than of balls, and for balls that are not there
    /// though the game would be over, or would have put them back: the 8, the 9, the 10 in their games;
    /// all but one in straight pool; in snooker the black, or colours that are not the next of their order
    /// or go before the last red; any in three-cushion. Whether balls overlap, the next shot says.
    pub fn scatter(&mut self, places: &[Option<[f64; 2]>], player: Player) -> Result<(), Error> {
        let wrong = |what: String, remedy: &str| Err(Error::input("places", what, remedy));
        if places.len() != self.state.layout.len() {
            let what = format!("{} for {} balls", places.len(), self.state.layout.len());
            return wrong(what, "give one for every ball");
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
