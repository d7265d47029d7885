//! A program that speaks the protocol, as a player of a match.

use std::time::{Duration, Instant};

use carom::error::InputError;
use carom::format::{Node, Reader};
use carom_mind::{Budget, Spent};

use super::channel::{ChannelFault, LONGEST_LINE, LineChannel};
use super::greeting::{self, Greeting};
use super::menu::{MOST_PLAYS, Menu};
use super::{messages, reply};
use crate::arena_frame::{ArenaFrame, Ask, REFUSALS};
use crate::clock::{ClockPeriod, ClockUnit};
use crate::match_player::{MatchPlayer, Response};
use crate::moves::EndReason;
use carom::{Error, ErrorKind};

/// The time that a program has until it is ready, s. It is off the clock: some languages take seconds
/// to start.
const START: Duration = Duration::from_secs(30);

/// The longest time of an answer if no clock of a frame limits it, s: a clock of decisions is a budget,
/// and a program that has stopped must not hold up the match. Ten minutes, as the clock of a frame.
const LONGEST_ANSWER: Duration = Duration::from_secs(600);

/// The time in which a program must read the end of a frame, s. It need not answer.
const GOODBYE: Duration = Duration::from_millis(200);

/// How a program is asked.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ProtocolSettings {
    /// The largest number of plays in the menu of a request; 0 for requests without a menu.
    pub menu: u32,
    /// Whether messages have a key, and a message comes before each request, that the protocol does not
    /// have, as those of a later version may. For checks of programs.
    pub unknown: bool,
}

impl ProtocolSettings {
    /// Checks the number of plays.
    ///
    /// # Errors
    /// [`Error::Input`] at `menu`.
    pub fn check(&self) -> Result<(), Error> {
        if self.menu <= MOST_PLAYS {
            return Ok(());
        }
        let what = format!("{} is out of range", self.menu);
        let remedy = format!("write a whole number from 0 to {MOST_PLAYS}");
        Err(ErrorKind::OutOfRange.at("menu", what, remedy))
    }
}

/// A program that speaks the protocol over a channel. It plays one frame, or several one after another.
pub struct ProtocolPlayer<L: LineChannel> {
    channel: L,
    menu: Menu,
    /// As in the settings.
    unknown: bool,
    /// Its `hello`; none before the first request.
    greeting: Option<Greeting>,
    /// The frame for which it is ready.
    frame: Option<u64>,
    /// Number of the last request.
    id: i64,
    /// Number of the request that its last refused line answered.
    refused: i64,
    /// Time of the last answer, s.
    seconds: f64,
    /// Whether it has failed, so that nothing more is sent.
    has_failed: bool,
}

/// What ends the exchange of a request without an answer.
enum Broken {
    Channel(ChannelFault),
    Lost(EndReason, String),
}

impl From<ChannelFault> for Broken {
    fn from(fault: ChannelFault) -> Self {
        Self::Channel(fault)
    }
}

impl<L: LineChannel> ProtocolPlayer<L> {
    /// The program at the other end of `channel`. Nothing is sent before the first request.
    ///
    /// # Errors
    /// As [`ProtocolSettings::check`].
    pub fn new(channel: L, settings: ProtocolSettings) -> Result<Self, Error> {
        settings.check()?;
        Ok(Self {
            channel,
            menu: Menu::new(settings.menu),
            unknown: settings.unknown,
            greeting: None,
            frame: None,
            id: 0,
            refused: 0,
            seconds: 0.0,
            has_failed: false,
        })
    }

    /// What the program has said of itself; `None` before its first request.
    pub const fn greeting(&self) -> Option<&Greeting> {
        self.greeting.as_ref()
    }

    /// The channel to the program.
    pub const fn channel(&self) -> &L {
        &self.channel
    }

    fn exchange(&mut self, ask: &Ask<'_>) -> Result<Response, Broken> {
        let is_asked_again = ask.refused.is_some() && self.id > 0;
        if !is_asked_again {
            self.get_ready(ask)?;
        }
        let line = match ask.refused.filter(|_| is_asked_again) {
            Some(fault) => messages::refused(Some(self.refused), fault),
            None => {
                self.id += 1;
                let filled = self.menu.fill(&ask.situation);
                // A position without a play has an empty menu.
                drop(filled);
                messages::request(ask, self.id, self.wishes(), &self.menu)
            }
        };
        self.refused = self.id;
        let deadline = Instant::now() + longest(ask);
        if self.unknown {
            self.write(Node::object([("type", "news".into())]), deadline)?;
        }
        self.write(line, deadline)?;
        let sent = Instant::now();
        let received = self.channel.receive(Some(deadline));
        self.seconds = sent.elapsed().as_secs_f64();
        let refusal = match received {
            Err(ChannelFault::NotUtf8) => reply::Refusal { id: self.id, fault: reply::not_utf8() },
            Err(other) => return Err(other.into()),
            Ok(line) if line.len() > LONGEST_LINE => return Err(ChannelFault::LongLine.into()),
            Ok(line) => match reply::read(&line, self.id, ask.situation.frame, &self.menu) {
                Ok(reply) => {
                    return Ok(match reply.info {
                        Some(info) => Response::Explained(reply.decision, info),
                        None => Response::Decision(reply.decision),
                    });
                }
                Err(refusal) => refusal,
            },
        };
        self.refused = refusal.id;
        Ok(Response::Unread(reply::fault_of(refusal.fault), Spent::default()))
    }

    /// Writes a message.
    fn write(&mut self, mut message: Node, deadline: Instant) -> Result<(), ChannelFault> {
        if self.unknown {
            message.set("key_of_a_later_version", Node::list([1.0]));
        }
        self.channel.send(&message.to_json_line(), Some(deadline))
    }

    fn wishes(&self) -> greeting::Wishes {
        self.greeting.as_ref().map_or_else(Default::default, |greeting| greeting.wishes)
    }

    /// Greets the program, and tells it what the frame is about.
    fn get_ready(&mut self, ask: &Ask<'_>) -> Result<(), Broken> {
        if self.frame == Some(ask.frame_number) {
            return Ok(());
        }
        let deadline = Instant::now() + START;
        if self.greeting.is_none() {
            self.write(messages::hello(), deadline)?;
            let game = ask.of.settings().game;
            let greeting = self.expect(deadline, |message| greeting::read(message, game))?;
            self.greeting = Some(greeting);
        }
        let message = messages::match_message(ask, &self.menu);
        self.write(message, deadline)?;
        self.expect(deadline, |message| greeting::expect(message, "ready"))?;
        self.frame = Some(ask.frame_number);
        Ok(())
    }

    /// The first line that `read` accepts. Others are refused, as many as a frame allows.
    fn expect<T>(
        &mut self,
        deadline: Instant,
        read: impl Fn(&Reader<'_>) -> Result<T, Error>,
    ) -> Result<T, Broken> {
        let mut refusals = 0;
        loop {
            let received = self.channel.receive(Some(deadline));
            let node = match received {
                Ok(line) => reply::message(&line),
                Err(ChannelFault::NotUtf8) => Err(reply::not_utf8()),
                Err(ChannelFault::TimeOver) => {
                    let why = format!("the program was not ready after {} s", START.as_secs());
                    return Err(Broken::Lost(EndReason::Stall, why));
                }
                Err(other) => return Err(other.into()),
            };
            let fault = match node.and_then(|node| read(&Reader::new(&node, ""))) {
                Ok(found) => return Ok(found),
                Err(error) => reply::fault_of(error),
            };
            refusals += 1;
            if refusals > REFUSALS {
                let InputError { place, what, .. } = fault;
                let why = format!("the program was not ready: {place}: {what}");
                return Err(Broken::Lost(EndReason::Stall, why));
            }
            self.write(messages::refused(None, &fault), deadline)?;
        }
    }
}

/// The longest time of an answer.
fn longest(ask: &Ask<'_>) -> Duration {
    match (ask.clock.unit, ask.left[ask.seat]) {
        (ClockUnit::Seconds, Some(left)) => Duration::from_secs_f64(left.clamp(0.0, 1e6)),
        (ClockUnit::Seconds, None) => {
            LONGEST_ANSWER.max(Duration::from_secs_f64(ask.budget.clamp(0.0, 1e6)))
        }
        (ClockUnit::Simulations, _) => LONGEST_ANSWER,
    }
}

impl<L: LineChannel> MatchPlayer for ProtocolPlayer<L> {
    fn respond(&mut self, ask: &Ask<'_>, _: &Budget<'_>) -> Response {
        self.seconds = 0.0;
        let broken = match self.exchange(ask) {
            Ok(response) => return response,
            Err(broken) => broken,
        };
        let (reason, why) = match broken {
            Broken::Lost(reason, why) => (reason, why),
            Broken::Channel(fault) => match fault.loss() {
                None => return Response::Stop,
                Some((EndReason::TimeOver, _)) if !has_frame_clock(ask) => {
                    let why = "the program did not answer";
                    (EndReason::Stall, why.into())
                }
                Some(loss) => loss,
            },
        };
        self.has_failed = true;
        Response::Failed(reason, why)
    }

    fn seconds(&self) -> Option<f64> {
        Some(self.seconds)
    }

    fn frame_over(&mut self, frame: &ArenaFrame) {
        if self.greeting.is_none() || self.has_failed {
            return;
        }
        if let Some(over) = messages::over(frame) {
            let deadline = Instant::now() + GOODBYE;
            self.has_failed = self.write(over, deadline).is_err();
        }
    }
}

/// Whether the clock of a frame counts the player's seconds.
fn has_frame_clock(ask: &Ask<'_>) -> bool {
    ask.clock.unit == ClockUnit::Seconds && ask.clock.period == ClockPeriod::Frame
}

impl<L: LineChannel> Drop for ProtocolPlayer<L> {
    fn drop(&mut self) {
        if self.greeting.is_some() && !self.has_failed {
            let deadline = Instant::now() + GOODBYE;
            // The program ends with its channel, whether it reads this or not.
            let _ = self.write(messages::bye(), deadline);
        }
    }
}
