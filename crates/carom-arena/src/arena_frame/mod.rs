//! One frame of a match, as a state machine without threads, files or clocks of its own.
//!
//! [`ArenaFrame::next`] gives the next request and its player. The caller lets that player think, measures what
//! it cost, and gives the answer to [`ArenaFrame::answer`], which draws the errors of the strike,
//! plays the shot, rules on it and updates clocks and result. The same answers with the same costs
//! give the same frame to the bit.

mod account;
mod last_shot;
mod place;

use std::sync::Arc;

use carom::error::InputError;
use carom::format::Node;
use carom::noise::Perception;
use carom::trace::TraceHashRecorder;
use carom::{Error, ErrorKind, Noise, Shot};
use carom_mind::{Answer, Decision, Situation};
use carom_rules::{
    Choice, ErrorDraw, Frame, FrameSimulator, Play, Request, Seat, execute, through_degrees,
};

use crate::clock::{Clock, ClockUnit, Cost};
use crate::luck::{Forecast, LuckMeter, ShotLuck};
use crate::moves::{ArenaMove, Effect, EndReason, Execution, FrameEnd};
use crate::secret::PairSeeds;
use crate::settings::{Disclosure, Match, MatchSettings, PlayerIndex};
use crate::sight::perceive;

pub use account::{Loss, REFUSALS, SeatAccount};
pub use last_shot::LastShot;

/// The state that each seat has in a frame.
#[derive(Clone, Copy, Debug)]
struct SeatState {
    /// Shots played so far.
    shots: u64,
    account: SeatAccount,
}

/// What a frame needs next.
#[derive(Clone, Debug)]
#[expect(clippy::large_enum_variant, reason = "it lives for one request; a box would allocate")]
pub enum NextStep<'f> {
    /// An answer of a player.
    Ask(Ask<'f>),
    /// Nothing: the frame is over.
    Over(&'f FrameEnd),
}

/// A request to a player.
#[derive(Clone, Debug)]
pub struct Ask<'f> {
    /// Number of the request in the frame, from 0. An answer to another one is out of date.
    pub id: u64,
    /// Number of the frame in the match, from 0. The referee reports failures with it.
    pub frame_number: u64,
    /// The seat that is asked.
    pub seat: Seat,
    /// The player at that seat.
    pub player: PlayerIndex,
    /// What the player may know.
    pub situation: Situation<'f>,
    /// What the player may spend on this decision, in the unit of its clock.
    pub budget: f64,
    /// The player's clock.
    pub clock: Clock,
    /// What is left on the clock of each seat; `None` for clocks of a decision.
    pub left: [Option<f64>; 2],
    /// Why the player's last answer to this request was refused.
    pub refused: Option<&'f InputError>,
    /// The match.
    pub of: &'f Match,
    /// The last shot of the frame, as everybody at the table has seen it.
    pub last: Option<LastShot<'f>>,
}

impl Ask<'_> {
    /// The largest number of simulated shots; no limit if the clock counts seconds.
    pub fn simulations(&self) -> u64 {
        match self.clock.unit {
            ClockUnit::Simulations => self.budget as u64,
            ClockUnit::Seconds => u64::MAX,
        }
    }

    /// The time after which no further round should begin, s; `None` if the clock counts simulated
    /// shots.
    pub fn seconds(&self) -> Option<f64> {
        (self.clock.unit == ClockUnit::Seconds).then_some(self.budget)
    }
}

/// One frame of a match.
#[derive(Clone, Debug)]
pub struct ArenaFrame {
    of: Arc<Match>,
    number: u64,
    players: [PlayerIndex; 2],
    seeds: PairSeeds,
    frame: Frame,
    /// The frame as the player who is asked sees it; `None` if it sees the balls exactly.
    seen: Option<Frame>,
    /// Whether the last shot or choice had the balls racked again.
    racked: bool,
    seats: [SeatState; 2],
    moves: Vec<ArenaMove>,
    end: Option<FrameEnd>,
}

impl ArenaFrame {
    /// Frame number `number` of a match, with the seeds of its pair. If the settings have a same
    /// break, it is played.
    ///
    /// # Errors
    /// None if the match was made without one.
    pub fn begin(
        of: Arc<Match>,
        number: u64,
        of_pair: PairSeeds,
        simulator: &mut FrameSimulator,
    ) -> Result<Self, Error> {
        let seeds = of.seeds(number, of_pair);
        let players = of.seats(number);
        let seat = |seat: Seat| {
            let account = SeatAccount::new(of.settings().clock[players[seat]]);
            SeatState { shots: 0, account }
        };
        let seats = [seat(0), seat(1)];
        let mut begun = Self {
            number,
            players,
            seeds,
            frame: of.start().with_seed(seeds.rack)?,
            of,
            seen: None,
            racked: true,
            seats,
            moves: Vec::new(),
            end: None,
        };
        begun.go_on(simulator)?;
        Ok(begun)
    }

    /// The match.
    pub fn of(&self) -> &Match {
        &self.of
    }

    /// The number of the frame in the match. Frames 2k and 2k + 1 are pair k.
    pub const fn number(&self) -> u64 {
        self.number
    }

    /// The player at each seat.
    pub const fn players(&self) -> [PlayerIndex; 2] {
        self.players
    }

    /// The seeds of the frame.
    pub const fn seeds(&self) -> &PairSeeds {
        &self.seeds
    }

    /// The true state of the game.
    pub const fn frame(&self) -> &Frame {
        &self.frame
    }

    /// The moves so far.
    pub fn moves(&self) -> &[ArenaMove] {
        &self.moves
    }

    /// The end; `None` while the frame goes on.
    pub const fn end(&self) -> Option<&FrameEnd> {
        self.end.as_ref()
    }

    /// The points of player 0: 1, ½ or 0; `None` while the frame goes on, and if it does not count.
    pub fn points(&self) -> Option<f64> {
        let of_seat_0 = self.end.as_ref()?.points()?;
        Some(if self.players[0] == 0 { of_seat_0 } else { 1.0 - of_seat_0 })
    }

    /// The luck of player 0 so far: the sum over all shots of what their errors have changed of its
    /// chance to win; `None` if it is not measured.
    pub fn luck(&self) -> Option<f64> {
        self.of.settings().luck?;
        let of_moves = self.moves.iter().filter_map(|arena_move| match &arena_move.effect {
            Effect::Played { luck: Some(luck), .. } => {
                let of_player_0 = self.players[arena_move.seat] == 0;
                Some(if of_player_0 { luck.luck() } else { -luck.luck() })
            }
            _ => None,
        });
        // The sum of nothing would be −0.
        Some(of_moves.fold(0.0, |sum, luck| sum + luck))
    }

    /// The next request and its player, or the end of the frame.
    pub fn next(&self) -> NextStep<'_> {
        let seat = match (&self.end, self.frame.player()) {
            (Some(end), _) => return NextStep::Over(end),
            (None, Some(seat)) => seat,
            (None, None) => unreachable!("a frame that is over has an end"),
        };
        let account = &self.seats[seat].account;
        let refused = match self.moves.last() {
            Some(ArenaMove { effect: Effect::Refused(error), .. }) => Some(error),
            _ => None,
        };
        NextStep::Ask(Ask {
            id: self.seats[0].account.asked() + self.seats[1].account.asked(),
            frame_number: self.number,
            seat,
            player: self.players[seat],
            situation: self.situation(seat),
            budget: account.budget(&self.frame, seat),
            clock: account.clock(),
            left: self.seats.map(|seat| seat.account.left()),
            refused,
            of: &self.of,
            last: LastShot::of(&self.moves),
        })
    }

    /// What `seat` may know.
    fn situation(&self, seat: Seat) -> Situation<'_> {
        let settings = self.of.settings();
        let told = |of: Seat| match settings.disclosure {
            Disclosure::Both => settings.noise[self.players[of]].clone(),
            Disclosure::Own if of == seat => settings.noise[self.players[of]].clone(),
            Disclosure::Own | Disclosure::Nothing => Noise::NONE,
        };
        let perception = match settings.disclosure {
            Disclosure::Nothing => Perception::default(),
            _ => settings.perception[self.players[seat]].clone(),
        };
        Situation {
            frame: self.seen.as_ref().unwrap_or(&self.frame),
            noise: [told(0), told(1)],
            perception,
            seed: self.seeds.decision(seat, self.seats[seat].account.asked()),
        }
    }

    /// Takes a player's decision, and the time that it took, s. Time is counted only by clocks of
    /// seconds; give 0 otherwise. Returns the move, which holds the refusal or the ruling.
    ///
    /// # Errors
    /// [`Error::Input`] if the frame is over.
    pub fn answer(
        &mut self,
        simulator: &mut FrameSimulator,
        decision: &Decision,
        seconds: f64,
    ) -> Result<&ArenaMove, Error> {
        self.answer_explained(simulator, decision, None, seconds)
    }

    /// As [`Self::answer`], with what the player says of its decision, for the record.
    ///
    /// # Errors
    /// As [`Self::answer`].
    pub fn answer_explained(
        &mut self,
        simulator: &mut FrameSimulator,
        decision: &Decision,
        info: Option<Node>,
        seconds: f64,
    ) -> Result<&ArenaMove, Error> {
        let seat = self.asked_seat()?;
        let cost = Cost { spent: decision.spent, seconds };
        let in_time = self.charge(seat, &cost);
        let effect = match decision.answer {
            _ if !in_time => Effect::Late,
            Answer::Play(play) => self.play(simulator, seat, &play)?,
            Answer::Choice(choice) => self.choose(choice),
            Answer::Concede => self.concede()?,
        };
        let (answer, win_chance) = (Some(decision.answer), decision.win_chance);
        let is_given = false;
        self.add(ArenaMove { seat, answer, is_given, win_chance, info, cost, effect }, simulator)
    }

    /// Refuses an answer that could not be read, such as a line that is not JSON. It counts as the
    /// other refused answers do, and its cost is charged.
    ///
    /// # Errors
    /// [`Error::Input`] if the frame is over.
    pub fn refuse(
        &mut self,
        simulator: &mut FrameSimulator,
        fault: InputError,
        cost: Cost,
    ) -> Result<&ArenaMove, Error> {
        let seat = self.asked_seat()?;
        let effect =
            if self.charge(seat, &cost) { self.refused(seat, fault) } else { Effect::Late };
        self.add(ArenaMove::without_answer(seat, cost, effect), simulator)
    }

    /// Ends the frame because the player who is asked gave no answer: its time is over, it ended,
    /// or it was stopped. The other player wins.
    ///
    /// # Errors
    /// [`Error::Input`] if the frame is over, and for a reason that is not one of these.
    pub fn forfeit(
        &mut self,
        reason: EndReason,
        why: &str,
        cost: Cost,
    ) -> Result<&ArenaMove, Error> {
        let seat = self.asked_seat()?;
        if !EndReason::FAILURES.contains(&reason) {
            let names = EndReason::FAILURES.map(EndReason::name).join(", ");
            let what = format!("\"{}\" is not a failure of a player", reason.name());
            return Err(ErrorKind::UnknownName.at("reason", what, format!("give one of {names}")));
        }
        self.charge(seat, &cost);
        let effect = Effect::Failed { reason, why: why.into() };
        self.end = Some(FrameEnd { winner: Some(1 - seat), reason, why: why.into() });
        self.moves.push(ArenaMove::without_answer(seat, cost, effect));
        Ok(&self.moves[self.moves.len() - 1])
    }

    fn asked_seat(&self) -> Result<Seat, Error> {
        match (&self.end, self.frame.player()) {
            (None, Some(seat)) => Ok(seat),
            _ => {
                Err(ErrorKind::FrameOver.at("answer", "the frame is over", "begin the next frame"))
            }
        }
    }

    /// Counts a request and its cost. False if the time of `seat` is over; the frame then ends.
    fn charge(&mut self, seat: Seat, cost: &Cost) -> bool {
        let loss = self.seats[seat].account.charge(cost);
        self.lose(seat, loss)
    }

    /// Counts a refused answer.
    fn refused(&mut self, seat: Seat, fault: InputError) -> Effect {
        let loss = self.seats[seat].account.refuse();
        self.lose(seat, loss);
        Effect::Refused(fault)
    }

    /// Ends the frame if there is a loss of `seat`. Whether the frame goes on.
    fn lose(&mut self, seat: Seat, loss: Option<Loss>) -> bool {
        let Some((reason, why)) = loss else { return true };
        self.end = Some(FrameEnd { winner: Some(1 - seat), reason, why });
        false
    }

    /// Checks the play, draws its errors and plays it.
    fn play(
        &mut self,
        simulator: &mut FrameSimulator,
        seat: Seat,
        play: &Play,
    ) -> Result<Effect, Error> {
        match self.accept(&fair(play)) {
            Ok((play_here, meant)) => self.strike(simulator, seat, &play_here, meant),
            Err(Error::Input(fault)) => Ok(self.refused(seat, *fault)),
            Err(other) => Err(other),
        }
    }

    /// The play on the true table, and its shot. The player is asked to answer for what it sees: a
    /// place of the cue ball that is free there is moved if another ball is truly in the way.
    fn accept(&self, play: &Play) -> Result<(Play, Shot), Error> {
        let mut here = *play;
        if let Some(seen) = &self.seen {
            seen.shot(play)?;
            here = place::clear_of_balls(&self.frame, play);
        }
        Ok((here, self.frame.shot(&here)?))
    }

    /// Plays a shot that the frame accepts, with the errors of `seat`. `meant` is the shot of `play`.
    fn strike(
        &mut self,
        simulator: &mut FrameSimulator,
        seat: Seat,
        play: &Play,
        meant: Shot,
    ) -> Result<Effect, Error> {
        let index = self.seats[seat].shots;
        let meter = self.luck_meter();
        let forecast = match &meter {
            Some(meter) => {
                let seed = self.seeds.fresh_errors(seat, index);
                meter.forecast(simulator, &self.frame, play, seed)?
            }
            None => None,
        };
        let noise = &self.of.settings().noise[self.players[seat]];
        let draw = ErrorDraw { seed: self.seeds.errors[seat], index };
        let (strike, cling) = execute(noise, &meant, draw)?;
        let meant = if cling.is_empty() { meant } else { meant.with_cling(cling) };
        let execution = Execution { strike, cue_ball: play.cue_ball, cling };
        let executed = meant.with_strike(&through_degrees(&strike))?;
        let played = Play { strike: through_degrees(&strike), ..*play };
        self.seats[seat].shots += 1;
        self.reseed();
        let mut recorder = TraceHashRecorder::new(&executed);
        match self.frame.play_displaced(simulator, &played, &executed, &mut recorder) {
            Ok((ruling, _)) => {
                let trace = recorder.finish(simulator.last());
                self.racked = ruling.racked;
                let luck = meter.zip(forecast).map(|(meter, Forecast { before, expected })| {
                    ShotLuck { before, expected, after: meter.value(&self.frame, seat) }
                });
                Ok(Effect::Played { execution, ruling, trace, luck })
            }
            Err(Error::TooManyEvents(error)) => {
                let why = format!("a shot reached its cap of {} events", error.cap);
                let reason = EndReason::EventCap;
                self.end = Some(FrameEnd { winner: None, reason, why });
                Ok(Effect::Capped { execution })
            }
            Err(other) => Err(other),
        }
    }

    /// What measures the luck of the shots, if the settings ask for it.
    fn luck_meter(&self) -> Option<LuckMeter> {
        let MatchSettings { luck, noise, .. } = self.of.settings();
        let of_seats = || self.players.map(|player| noise[player].clone());
        luck.map(|settings| LuckMeter { settings, noise: of_seats() })
    }

    /// Gives the racks and lots that follow from the next move a seed that does not follow from what
    /// the players have seen. The seed of a rack could be computed from its balls: PCG64, which places
    /// them, is no cipher.
    fn reseed(&mut self) {
        self.frame.reseed(self.seeds.later_rack(self.moves.len() as u64));
    }

    fn choose(&mut self, choice: Choice) -> Effect {
        self.reseed();
        match self.frame.choose(choice) {
            Ok(ruling) => {
                self.racked = ruling.racked;
                Effect::Chosen { ruling }
            }
            Err(Error::Input(fault)) => {
                let seat = self.frame.player().unwrap_or_default();
                self.refused(seat, *fault)
            }
            Err(_) => unreachable!("a choice simulates nothing"),
        }
    }

    fn concede(&mut self) -> Result<Effect, Error> {
        self.frame.concede()?;
        Ok(Effect::Conceded)
    }

    /// Adds a move, and goes on to the next request.
    fn add(
        &mut self,
        arena_move: ArenaMove,
        simulator: &mut FrameSimulator,
    ) -> Result<&ArenaMove, Error> {
        let index = self.moves.len();
        self.moves.push(arena_move);
        self.go_on(simulator)?;
        Ok(&self.moves[index])
    }

    /// Ends the frame if its game is over; plays the same break of the settings if the frame asks
    /// for a break; and looks at the table for the player who is asked next.
    fn go_on(&mut self, simulator: &mut FrameSimulator) -> Result<(), Error> {
        while self.end.is_none()
            && let Some(play) = self.given_break()
            && let Some(seat) = self.frame.player()
        {
            let given = fair(&play);
            let meant = self.frame.shot(&given)?;
            let effect = self.strike(simulator, seat, &given, meant)?;
            let answer = Some(Answer::Play(play));
            let (win_chance, info, cost) = (None, None, Cost::default());
            let is_given = true;
            self.moves.push(ArenaMove { seat, answer, is_given, win_chance, info, cost, effect });
        }
        if self.end.is_none() {
            self.end = self.end_by_rules();
        }
        self.seen = None;
        if self.end.is_none()
            && let Some(seat) = self.frame.player()
        {
            let perception = &self.of.settings().perception[self.players[seat]];
            let draw = ErrorDraw { seed: self.seeds.sight[seat], index: self.seats[seat].shots };
            self.seen = perceive(perception, &self.frame, draw)?;
        }
        Ok(())
    }

    /// The same break of the settings, if the frame asks for a break.
    fn given_break(&self) -> Option<Play> {
        let play = self.of.settings().same_break?;
        self.frame.turn()?;
        // In straight pool fourteen balls are racked in the middle of a frame, and in three-cushion
        // the last inning has a starting shot of its own.
        let repeats = !self.frame.facts().has_target();
        (self.frame.shots() == 0 || (repeats && self.racked)).then_some(play)
    }

    /// The end of a game that is over.
    fn end_by_rules(&self) -> Option<FrameEnd> {
        let Request::Over { winner, why } = *self.frame.request() else { return None };
        let conceded =
            matches!(self.moves.last(), Some(ArenaMove { effect: Effect::Conceded, .. }));
        let reason = match winner {
            Some(_) if conceded => EndReason::Conceded,
            Some(_) => EndReason::Won,
            None => EndReason::Drawn,
        };
        Some(FrameEnd { winner, reason, why: why.into() })
    }
}

/// Checks whether `frame` allows an answer of the player who is asked.
///
/// # Errors
/// [`Error::Input`] at the part of the answer that is not allowed.
pub fn check_answer(frame: &Frame, answer: &Answer) -> Result<(), Error> {
    match answer {
        Answer::Play(play) => frame.shot(&fair(play)).map(drop),
        Answer::Choice(choice) => frame.clone().choose(*choice).map(drop),
        Answer::Concede => Ok(()),
    }
}

/// `play` under the usual policies and without cling: a player chooses neither, and records have
/// neither.
fn fair(play: &Play) -> Play {
    Play { cue_ball: play.cue_ball, call: play.call, ..Play::new(play.strike) }
}
