//! A frame in words and numbers, from which a person or a language model can play.

use core::fmt::Write;

use crate::frame::Frame;
use crate::layout::BallIndex;
use crate::request::{Calls, Request, Turn};

impl Frame {
    /// The frame as text: the game and its score, the table, the place of every ball, and what the
    /// present request allows. Coordinates are those of files, m, to a tenth of a millimetre;
    /// [`Frame::to_node`] has all digits.
    pub fn describe(&self) -> String {
        let mut text = String::new();
        for line in [self.heading(), self.state_line(), self.table_lines(), self.ball_line()] {
            if !line.is_empty() {
                text += &line;
                text.push('\n');
            }
        }
        text += &self.request_lines();
        text
    }

    fn heading(&self) -> String {
        let [one, other] = self.scores();
        let [first, second] = self.fouls_in_a_row();
        let mut line = format!("Game: {}. Score: {one} to {other}.", self.game().name());
        if (first, second) != (0, 0) {
            let _ = write!(line, " Fouls in a row: player 0 {first}, player 1 {second}.");
        }
        line
    }

    /// What only this game has, and the points that win.
    fn state_line(&self) -> String {
        let own = self.game_state().rules().describe(self.layout());
        let target = self.facts().has_target();
        let target = target.then(|| format!("{} points win.", self.options().points));
        let parts = [own, target].into_iter().flatten();
        parts.collect::<Vec<_>>().join(" ")
    }

    fn table_lines(&self) -> String {
        let table = self.base().table();
        let (width, length) = (table.size.x, table.size.y);
        let mut text = format!(
            "Table: x from 0 to {width:.4} m (left to right), y from 0 to {length:.4} m (bottom to \
             top). Azimuths are counter-clockwise from +x. A ball's radius: {:.4} m.",
            self.base().physics().ball.radius
        );
        if !table.pockets.is_empty() {
            let pockets = table.pockets.iter().map(|pocket| {
                let center = [pocket.center.x + 0.5 * width, pocket.center.y + 0.5 * length];
                format!("{} {}", pocket.name.name(), place(center))
            });
            let _ = write!(text, "\nPockets: {}.", pockets.collect::<Vec<_>>().join(", "));
        }
        text
    }

    fn ball_line(&self) -> String {
        let balls = self.layout().on_table().filter_map(|ball| {
            Some(format!("{} {}", self.id(ball), place(self.layout().place(ball)?)))
        });
        format!("Balls: {}.", balls.collect::<Vec<_>>().join(", "))
    }

    fn request_lines(&self) -> String {
        match self.request() {
            Request::Over { winner: Some(seat), why } => {
                format!("The frame is over: player {seat} has won; {why}.")
            }
            Request::Over { winner: None, why } => {
                format!("The frame is over without a winner; {why}.")
            }
            Request::Choice { player, choices, why } => {
                let mut text = format!("Player {player} chooses ({why}):");
                for choice in choices.iter() {
                    let _ = write!(text, "\n- {}: {}", choice.name(), choice.words());
                }
                text
            }
            Request::Shot(turn) => self.turn_lines(turn),
        }
    }

    fn turn_lines(&self, turn: &Turn) -> String {
        let cue = self.id(turn.cue);
        let mut text = format!("Player {} shoots", turn.player);
        if self.is_opening() {
            text += " the opening shot";
        }
        match turn.hand {
            None => {
                let _ = write!(text, " with {cue}, where it lies.");
            }
            Some(region) => {
                let limits = region.limits(self.base().table());
                let words = region.words();
                let _ = write!(text, " with {cue} in hand {words}; its centre may be put {limits}");
                text.push('.');
            }
        }
        if turn.on.is_empty() {
            text += "\nAny ball may be hit first.";
        } else {
            let _ = write!(text, "\nTo be hit first: {}.", self.one_of(&turn.on));
        }
        let _ = write!(text, "\nCall: {}.", call_words(&turn.calls));
        text
    }

    fn one_of(&self, balls: &[BallIndex]) -> String {
        let ids: Vec<&str> = balls.iter().map(|ball| self.id(*ball)).collect();
        match &ids[..] {
            [one] => (*one).to_owned(),
            _ => format!("one of {}", ids.join(", ")),
        }
    }
}

fn place([x, y]: [f64; 2]) -> String {
    format!("({x:.4}, {y:.4})")
}

fn call_words(calls: &Calls) -> String {
    let mut kinds = Vec::new();
    if calls.pocket {
        kinds.push("a ball and its pocket");
    }
    if calls.safety {
        kinds.push("a safety");
    }
    if calls.push_out {
        kinds.push("a push-out");
    }
    if calls.nominate {
        kinds.push("the ball that is nominated, one of those to be hit first");
    }
    match (kinds.is_empty(), calls.required || calls.nominate) {
        (true, _) => "nothing is called".into(),
        (false, true) => format!("{}; required", kinds.join(", or ")),
        (false, false) => format!("{}; it may be left out", kinds.join(", or ")),
    }
}
