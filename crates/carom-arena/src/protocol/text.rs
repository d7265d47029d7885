//! A request in words, for a language model: all that it needs, compact, with units.

use core::fmt::Write;

use carom::math::degrees;
use carom_rules::Seat;

use super::menu::Menu;
use crate::arena_frame::{Ask, LastShot};
use crate::clock::ClockUnit;

/// The request as text: the seat, the last shot, the frame in words, the clock, and the menu.
pub(super) fn describe(ask: &Ask<'_>, menu: &Menu) -> String {
    let frame = ask.situation.frame;
    let mut text = format!("You are player {}.\n{}\n", ask.seat, frame.describe());
    if let Some(last) = &ask.last {
        let _ = writeln!(text, "{}", last_line(ask, last));
    }
    let _ = writeln!(text, "{}", clock_line(ask));
    if menu.is_wanted() {
        text += "Answers to pick from, with the chances of each:\n";
        for line in menu.lines() {
            let _ = writeln!(text, "{line}");
        }
    }
    text
}

fn last_line(ask: &Ask<'_>, last: &LastShot<'_>) -> String {
    let frame = ask.situation.frame;
    let strike = &last.execution.strike;
    let mut line = format!(
        "Last shot: {} struck at {:.2} m/s, azimuth {:.1}°",
        whose(ask, last.seat),
        strike.speed,
        degrees(strike.azimuth).rem_euclid(360.0)
    );
    let ruling = last.ruling;
    if ruling.is_legal() {
        line += "; it was legal.";
    } else {
        let fouls: Vec<&str> = ruling.fouls.iter().map(|foul| foul.words()).collect();
        let _ = write!(line, "; it was a foul: {}.", fouls.join("; "));
    }
    if ruling.points != [0, 0] {
        let [one, other] = ruling.points;
        let _ = write!(line, " Points: {one} to {other}.");
    }
    if !ruling.spotted.is_empty() {
        let balls = frame.layout().balls();
        let ids = ruling.spotted.iter().map(|ball| balls[usize::from(*ball)].id.as_str());
        let _ = write!(line, " Spotted: {}.", ids.collect::<Vec<_>>().join(", "));
    }
    if let Some(choice) = last.choice {
        let _ = write!(line, " Then the choice was: {}.", choice.words());
    }
    line
}

fn whose(ask: &Ask<'_>, seat: Seat) -> &'static str {
    if seat == ask.seat { "you" } else { "the other player" }
}

fn clock_line(ask: &Ask<'_>) -> String {
    let unit = match ask.clock.unit {
        ClockUnit::Seconds => "s",
        ClockUnit::Simulations => "simulated shots",
    };
    match ask.left[ask.seat] {
        Some(left) => format!("Your clock: {left:.1} {unit} left in this frame."),
        None => format!("Your clock: {} {unit} for this answer.", ask.clock.amount),
    }
}
