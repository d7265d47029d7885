//! Frames that start from given places of the balls.

use carom::rack::Game;
use carom::shot::PlacedBall;
use carom::{Error, ErrorKind, MotionState, Shot};

use super::Frame;
use crate::options::Options;
use crate::seat::Seat;

impl Frame {
    /// A frame on the table and with the physics of `shot` that continues, as with
    /// [`Self::resume_at`], from the shot's balls. Balls of the game that are missing from the shot
    /// are down.
    ///
    /// # Arguments
    /// `player` shoots next. `None` is the player whose cue ball the shot strikes, in games in which
    /// each player has one; otherwise player 0.
    ///
    /// # Errors
    /// As [`Self::new`] and [`Self::resume_at`]; [`Error::Input`] for a ball that the game does not
    /// have, with a mass or radius other than the game's, or that is not at rest.
    pub fn of_shot(
        game: Game,
        options: Options,
        shot: &Shot,
        player: Option<Seat>,
    ) -> Result<Self, Error> {
        let file = shot.to_node();
        let (table, physics) = (file.get("table").cloned(), file.get("physics").cloned());
        let mut frame = Self::new(game, options, table, physics, 0)?;
        let places = frame.places_of(shot)?;
        let player = player.unwrap_or_else(|| frame.owner_of_struck(shot));
        frame.resume_at(&places, player)?;
        Ok(frame)
    }

    /// The player whose cue ball `shot` strikes; player 0 where the players share one, and where no
    /// cue ball is struck.
    fn owner_of_struck(&self, shot: &Shot) -> Seat {
        let is_own = |id: &str| self.facts().own_cue_balls && self.layout().balls()[1].id == *id;
        let struck = shot.strike().map(|(ball, _)| shot.balls()[ball].id.as_str());
        struck.is_some_and(is_own).into()
    }

    /// The places of the balls of `shot`, for [`Self::resume_at`]. Balls that are missing from the shot
    /// are down.
    ///
    /// # Errors
    /// [`Error::Input`] for a ball that the game does not have, with a mass or radius other than the
    /// game's, or that is not at rest.
    pub fn places_of(&self, shot: &Shot) -> Result<Vec<Option<[f64; 2]>>, Error> {
        let mut places = vec![None; self.layout().len()];
        for (i, PlacedBall { id, ball, state }) in shot.balls().iter().enumerate() {
            let index = usize::from(self.ball(id, &format!("balls[{i}].id"))?);
            let wrong = |kind: ErrorKind, what: &str, remedy| {
                Err(kind.at(format!("balls[{i}]"), what, remedy))
            };
            if *ball != self.layout().balls()[index].ball {
                return wrong(
                    ErrorKind::Mismatch,
                    "its mass or radius is not the game's",
                    "leave them out",
                );
            }
            if state.motion != MotionState::Stationary {
                return wrong(
                    ErrorKind::Moving,
                    "it moves, but a frame asks for a shot only when all balls are at rest",
                    "leave out its velocity and angular velocity",
                );
            }
            places[index] = Some([state.position.x, state.position.y]);
        }
        Ok(places)
    }

    /// Continues the game with the balls at `places` (one entry for each ball of the layout, file
    /// frame, m; `None` for a ball that is down). `seat` shoots next, with the cue ball where it
    /// lies. Scores and fouls are kept. All else of the game's state is reset: in eight-ball the
    /// table is open; in snooker reds are on as long as there are any, then the colours in order.
    ///
    /// # Errors
    /// [`Error::Input`] for a wrong number of places, a seat other than 0 and 1, and for missing
    /// balls without which the game would be over or which it would have spotted: the 8, the 9 and
    /// the 10 in their games; all object balls but one in straight pool; in snooker the black, a
    /// colour that is not the next in order, or a colour while reds are left; any ball in
    /// three-cushion. Overlapping balls are reported by the next shot.
    pub fn resume_at(&mut self, places: &[Option<[f64; 2]>], seat: Seat) -> Result<(), Error> {
        let wrong =
            |kind: ErrorKind, what: String, remedy: &str| Err(kind.at("places", what, remedy));
        if places.len() != self.state.layout.len() {
            let what = format!("{} places for {} balls", places.len(), self.state.layout.len());
            return wrong(ErrorKind::WrongCount, what, "give one for every ball");
        }
        if places.iter().flatten().flatten().any(|x| !x.is_finite()) {
            return wrong(
                ErrorKind::OutOfRange,
                "a coordinate is not a finite number".into(),
                "write places in m",
            );
        }
        if seat > 1 {
            let what = format!("there is no player {seat}");
            return Err(ErrorKind::OutOfRange.at("player", what, "write 0 or 1"));
        }
        if let Some(what) = self.game_state.rules().missing(places) {
            return wrong(ErrorKind::Missing, what, "give the missing balls places on the table");
        }
        for (ball, place) in (0..).zip(places) {
            self.state.layout.put(ball, *place);
        }
        self.stalemates.restart(&self.state);
        self.request = self.game_state.rules_mut().resume(&self.state, seat);
        Ok(())
    }
}
