//! Players of the arena as opponents, such as external programs. Every environment has one of its own,
//! which has a clock and a number of refused answers as in a match.

use std::sync::Arc;

use carom::runner::Runner;
use carom::{Error, ErrorKind};
use carom_arena::{
    Ask, Breaker, Clock, Cost, Loss, Match, MatchPlayer, MatchSettings, PlayerEntry, Response,
    SeatAccount, ask_player, check_answer,
};
use carom_mind::Situation;
use carom_rules::Frame;

use crate::environment::Reply;
use crate::vector::{Asked, VectorEnv};

/// Largest number of environments with players of the arena. A program is two processes in each of
/// them, so a mistyped number would use up the machine's.
pub const MOST_ARENA_OPPONENTS: usize = 256;

/// Makes a player for one episode.
pub type MakePlayer = Arc<dyn Fn() -> Box<dyn MatchPlayer> + Send + Sync>;

/// Whether the players are to stop. It is asked many times a second while they think.
pub type IsStopped = Arc<dyn Fn() -> bool + Send + Sync>;

/// The players of a vector of environments, at most one for each. A player is made at its first request
/// in an episode, and dropped with the episode.
pub struct ArenaOpponents {
    make: MakePlayer,
    clock: Clock,
    is_stopped: IsStopped,
    runner: Runner,
    /// By the number of the environment.
    seated: Vec<Option<SeatedPlayer>>,
}

/// A player in an episode.
struct SeatedPlayer {
    /// The episode: `starts` of its environment.
    starts: u64,
    player: Box<dyn MatchPlayer>,
    /// The frame as messages describe it.
    of: Match,
    account: SeatAccount,
}

impl ArenaOpponents {
    /// Opponents for `envs`. `make` makes a player, which has `clock` in every episode.
    ///
    /// # Errors
    /// [`Error::Input`] at `opponent` for more environments than [`MOST_ARENA_OPPONENTS`], and at
    /// `clock`.
    pub fn new(
        envs: &VectorEnv,
        make: MakePlayer,
        clock: Clock,
        is_stopped: IsStopped,
    ) -> Result<Self, Error> {
        let n = envs.len();
        if n > MOST_ARENA_OPPONENTS {
            let what = format!("a program has processes of its own in each of {n} environments");
            let remedy = format!("ask for at most {MOST_ARENA_OPPONENTS} environments");
            return Err(ErrorKind::OutOfRange.at("opponent", what, remedy));
        }
        clock.check()?;
        let runner = Runner::new(envs.config().threads)?;
        let seated = (0..n).map(|_| None).collect();
        Ok(Self { make, clock, is_stopped, runner, seated })
    }

    /// The answers to all requests, for [`VectorEnv::step_against`]. Players of several environments are
    /// asked at the same time.
    ///
    /// # Errors
    /// [`Error::Input`] at `opponent` if the players were stopped.
    pub fn replies(&mut self, asked: &[Asked<'_>]) -> Result<Vec<Reply>, Error> {
        let Self { make, clock, is_stopped, runner, seated } = self;
        let items: Vec<_> = asked.iter().map(|one| (one, seated[one.index].take())).collect();
        let found = runner.map(
            items,
            || (),
            |(), (asked, seated)| {
                let same = seated.filter(|seated| seated.starts == asked.environment.starts);
                let mut seated = match same {
                    Some(seated) => seated,
                    None => SeatedPlayer::new(asked, make(), *clock)?,
                };
                let reply = seated.reply(asked, &**is_stopped)?;
                let plays_on = !matches!(reply, Reply::Lost(_));
                Ok((reply, plays_on.then_some(seated)))
            },
        );
        let found = found.into_iter().collect::<Result<Vec<_>, Error>>()?;
        let keep = |(asked, (reply, player)): (&Asked<'_>, (Reply, Option<SeatedPlayer>))| {
            seated[asked.index] = player;
            reply
        };
        Ok(asked.iter().zip(found).map(keep).collect())
    }

    /// Ends the players whose episodes are over.
    pub fn end_over(&mut self, envs: &VectorEnv) {
        let ended = self.seated.iter_mut().enumerate().filter_map(|(index, seated)| {
            seated.take_if(|seated| envs.episode_in_progress(index) != Some(seated.starts))
        });
        // A program that does not end by itself takes up to half a second.
        self.runner.map(ended.collect::<Vec<_>>(), || (), |(), seated| drop(seated));
    }

    /// Ends all players. New ones are made if they are asked again.
    pub fn end_all(&mut self) {
        let ended: Vec<_> = self.seated.iter_mut().map(Option::take).collect();
        self.runner.map(ended, || (), |(), seated| drop(seated));
    }
}

impl SeatedPlayer {
    fn new(asked: &Asked<'_>, player: Box<dyn MatchPlayer>, clock: Clock) -> Result<Self, Error> {
        let frame = frame_of(asked)?;
        let setup = frame.base().to_node();
        let settings = MatchSettings {
            options: *frame.options(),
            table: setup.get("table").cloned(),
            physics: setup.get("physics").cloned(),
            noise: noises(asked),
            clock: [clock; 2],
            // So the seats have the numbers of the players in every frame.
            breaker: Breaker::Always(0),
            ..MatchSettings::new(frame.game())
        };
        let of = Match::new(settings, ["seat 0", "seat 1"].map(PlayerEntry::new))?;
        let starts = asked.environment.starts;
        Ok(Self { starts, player, of, account: SeatAccount::new(clock) })
    }

    /// The answer to a request, or why the player loses the frame.
    fn reply(
        &mut self,
        asked: &Asked<'_>,
        is_stopped: &(dyn Fn() -> bool + Sync),
    ) -> Result<Reply, Error> {
        let (frame, seat, noise) = (frame_of(asked)?, asked.seat(), noises(asked));
        let (own, seed) = (noise[seat].clone(), asked.environment.decision_seed());
        let situation = Situation { noise, ..Situation::new(frame, own, seed) };
        let mut refused = None;
        loop {
            let Self { of, account, .. } = self;
            // The agent has no clock, so that none of it is used up.
            let mut left = [0, 1].map(|_| SeatAccount::new(account.clock()).left());
            left[seat] = account.left();
            let ask = Ask {
                id: account.asked(),
                frame_number: asked.environment.number,
                seat,
                player: seat,
                situation: situation.clone(),
                budget: account.budget(frame, seat),
                clock: account.clock(),
                left,
                refused: refused.as_ref(),
                of,
                last: asked.environment.episode.last_shot(),
            };
            let (response, seconds) = ask_player(&mut *self.player, &ask, is_stopped)?;
            let (answer, spent) = match response {
                Response::Decision(decision) | Response::Explained(decision, _) => {
                    (Ok(decision.answer), decision.spent)
                }
                Response::Unread(fault, spent) => (Err(fault), spent),
                Response::Failed(reason, why) => return Ok(lost((reason, why))),
                Response::Stop => return Err(stopped()),
            };
            if is_stopped() {
                return Err(stopped());
            }
            if let Some(loss) = self.account.charge(&Cost { spent, seconds }) {
                return Ok(lost(loss));
            }
            let checked = answer.map(|answer| check_answer(frame, &answer).map(|()| answer));
            refused = match checked {
                Ok(Ok(answer)) => return Ok(Reply::Answer(answer)),
                Ok(Err(Error::Input(fault))) => Some(*fault),
                Ok(Err(other)) => return Err(other),
                Err(fault) => Some(fault),
            };
            if let Some(loss) = self.account.refuse() {
                return Ok(lost(loss));
            }
        }
    }
}

fn frame_of<'a>(asked: &Asked<'a>) -> Result<&'a Frame, Error> {
    let nothing = || ErrorKind::WrongState.at("opponent", "there is no frame", "choose a game");
    asked.frame().ok_or_else(nothing)
}

/// The noise of the strikes of each seat.
fn noises(asked: &Asked<'_>) -> [carom::Noise; 2] {
    let [mut own, mut other] = asked.noise();
    if asked.seat() == 1 {
        core::mem::swap(&mut own, &mut other);
    }
    [own, other]
}

fn lost((reason, why): Loss) -> Reply {
    Reply::Lost(format!("{}: {why}", reason.name()))
}

fn stopped() -> Error {
    ErrorKind::WrongState.at("opponent", "it was stopped", "reset the environments")
}
