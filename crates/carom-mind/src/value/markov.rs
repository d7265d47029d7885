//! The Markov chain over ball counts (Archibald, Altman & Shoham 2009 valued endings with a table
//! over the two players' ball counts).
//!
//! A player at the table with n balls left pots the next one with probability q and continues; else
//! the other player comes to the table. So the probability of winning is W(n, m) = q W(n − 1, m) +
//! (1 − q)(1 − W(m, n)) with W(0, m) = 1. The chain is solved in closed form for each pair (n, m),
//! (m, n). The first shot is valued by the best pot of the position instead of q.

use carom_rules::{Frame, Objective, Region, Scoring, Seat, Turn};

use super::{Lanes, Position, Reference, Value};
use crate::targets::balls_left;

/// Shares of the usual pot's chance in a run: of [`Markov::default`], and of [`Markov::slow`]. A
/// regression on both finds the share of a game. Estimated.
const IN_RUN: f64 = 0.93;
const IN_SLOW_RUN: f64 = 0.7;
/// Chance of a pot for the player who comes to the table after a safety, as a share of the usual
/// pot's. Estimated.
const AFTER_SAFETY: f64 = 0.45;
/// Points of snooker: standard deviation of the points that a shot on the table is still worth, as a
/// share of the points left. Estimated.
const SPREAD: f64 = 0.45;
/// Points of a visit in snooker for a player who pots every second ball. Estimated.
const PER_BALL: f64 = 3.5;
/// One more than the largest counts of eight-ball: seven balls and the eight.
const FEW: usize = 9;
/// The largest counts of the chain. Longer races are scaled down to this many points.
const MOST: usize = 40;

/// The value by the Markov chain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Markov {
    /// Share of the usual pot's chance that a player keeps in a run: positions are not always as
    /// good as the usual one.
    in_run: f64,
}

impl Default for Markov {
    fn default() -> Self {
        Self { in_run: IN_RUN }
    }
}

/// The chances of a shot for the two seats.
#[derive(Clone, Copy, Debug)]
struct Rates {
    /// Of a shot in a run.
    run: [f64; 2],
    /// Of a shot after the other player's safety.
    safe: [f64; 2],
}

impl Rates {
    /// Those of players with these chances of a usual pot.
    fn of(usual: [f64; 2], in_run: f64) -> Self {
        Self {
            run: usual.map(|chance| (in_run * chance).clamp(0.02, 0.98)),
            safe: usual.map(|chance| AFTER_SAFETY * chance),
        }
    }
}

impl Value for Markov {
    fn name(&self) -> &'static str {
        "markov"
    }

    fn of_shot(&self, position: &Position<'_>, turn: &Turn) -> f64 {
        let lanes = Lanes::of(position.frame, turn, &position.noise[turn.player]);
        self.shooter(position, turn, Reference::chances(position), lanes.chances[0])
    }
}

impl Markov {
    /// The chain of players who run fewer balls.
    pub(crate) const fn slow() -> Self {
        Self { in_run: IN_SLOW_RUN }
    }

    /// The probability that the player of `turn` wins. `usual` are the players' chances of a usual pot,
    /// and `best` is that of the best pot, which does not count for an opening shot and in carom games.
    pub(crate) fn shooter(
        &self,
        position: &Position<'_>,
        turn: &Turn,
        usual: [f64; 2],
        best: f64,
    ) -> f64 {
        let frame = position.frame;
        let (own, other) = (turn.player, 1 - turn.player);
        let rates = Rates::of(usual, self.in_run);
        let first = match turn.hand {
            _ if frame.facts().is_carom() || frame.is_opening() => rates.run[own],
            Some(region) if region != Region::Anywhere => best.min(rates.run[own]),
            _ => best,
        };
        let chain = Chain::of(frame, rates.run, own);
        let potted = chain.after_pot();
        let missed = 1.0 - chain.of_other();
        // Either a pot, or a safety that leaves the other player a difficult one.
        let pot = first * potted + (1.0 - first) * missed;
        let reply = rates.safe[other];
        let safety =
            1.0 - (reply * chain.after_pot_of_other() + (1.0 - reply) * (1.0 - chain.own()));
        pot.max(safety)
    }
}

/// The chain, seen from the player at the table.
struct Chain {
    kind: Kind,
    run: [f64; 2],
}

enum Kind {
    /// Balls left of the player at the table and of the other one.
    Counts(usize, usize),
    /// Balls that both players share.
    Shared(usize),
    /// Snooker: lead of the player at the table, and points left.
    Points { lead: f64, left: f64 },
}

impl Chain {
    fn of(frame: &Frame, run: [f64; 2], own: Seat) -> Self {
        let other = 1 - own;
        let facts = frame.facts();
        let kind = match facts.scoring {
            Scoring::LastBall if facts.objective == Objective::Groups => {
                Kind::Counts(balls_left(frame, own), balls_left(frame, other))
            }
            Scoring::LastBall => Kind::Shared(balls_left(frame, own)),
            Scoring::Target { .. } => {
                let points = frame.options().points;
                let need = |seat: Seat| (points - frame.scores()[seat]).max(1);
                let most = need(own).max(need(other)).max(1);
                let scale = |need: i32| {
                    let capped = MOST as i32;
                    let scaled = if most > capped { need * capped / most } else { need };
                    usize::try_from(scaled.max(1)).unwrap_or(1)
                };
                Kind::Counts(scale(need(own)), scale(need(other)))
            }
            Scoring::Points { .. } => {
                let lead = f64::from(frame.scores()[own] - frame.scores()[other]);
                let values = frame.layout().on_table().map(|ball| frame.value(ball));
                let left = values.map(|v| if v == 1 { 5 } else { v });
                Kind::Points { lead, left: f64::from(left.sum::<i32>()) }
            }
        };
        Self { kind, run: [run[own], run[other]] }
    }

    /// The player at the table wins, with an average first shot.
    fn own(&self) -> f64 {
        self.at(0, 0)
    }

    /// The other player wins if it comes to the table.
    fn of_other(&self) -> f64 {
        self.other_at(0, 0)
    }

    fn after_pot(&self) -> f64 {
        self.at(1, 0)
    }

    fn after_pot_of_other(&self) -> f64 {
        self.other_at(0, 1)
    }

    /// The player at the table wins, after `own` and `other` further balls of the two players.
    fn at(&self, own: usize, other: usize) -> f64 {
        match self.kind {
            Kind::Counts(n, m) => solve(n.saturating_sub(own), m.saturating_sub(other), self.run),
            Kind::Shared(n) => shared(n.saturating_sub(own + other), self.run),
            Kind::Points { lead, left } => {
                let scored = PER_BALL * (own as f64 - other as f64);
                points(lead + scored, left - PER_BALL * (own + other) as f64, self.run[0])
            }
        }
    }

    /// The other player wins when it comes to the table, after such balls.
    fn other_at(&self, own: usize, other: usize) -> f64 {
        let run = [self.run[1], self.run[0]];
        match self.kind {
            Kind::Counts(n, m) => solve(m.saturating_sub(other), n.saturating_sub(own), run),
            Kind::Shared(n) => shared(n.saturating_sub(own + other), run),
            Kind::Points { lead, left } => {
                let scored = PER_BALL * (other as f64 - own as f64);
                points(scored - lead, left - PER_BALL * (own + other) as f64, run[0])
            }
        }
    }
}

/// W(n, m) of the chain; the player at the table has the chance `run[0]` a shot.
fn solve(n: usize, m: usize, run: [f64; 2]) -> f64 {
    // Short rows for the counts of eight-ball, which are valued most often.
    if n.max(m) < FEW {
        return solve_within::<FEW>(n, m, run);
    }
    solve_within::<{ MOST + 1 }>(n.min(MOST), m.min(MOST), run)
}

/// [`solve`] for counts below `N`.
fn solve_within<const N: usize>(n: usize, m: usize, run: [f64; 2]) -> f64 {
    if n == 0 {
        return 1.0;
    }
    if m == 0 {
        return 0.0;
    }
    // own[k]: W(k, j) for the first player, with j balls left to the second, row by row in j.
    let [p, q] = run;
    let (mut own, mut next) = ([1.0; N], [1.0; N]);
    // other[k]: the second player at the table with j balls left, the first with k.
    let (mut other, mut next_other) = ([0.0; N], [0.0; N]);
    // Row j = 0: the second player has won.
    for k in 1..=n {
        own[k] = 0.0;
        other[k] = 1.0;
    }
    for _ in 1..=m {
        next[0] = 1.0;
        next_other[0] = 0.0;
        for k in 1..=n {
            // a = p a₁ + (1 − p)(1 − b), b = q b₁ + (1 − q)(1 − a).
            let a1 = next[k - 1];
            let b1 = other[k];
            let (s, t) = (1.0 - p, 1.0 - q);
            let a = (p * a1 + s * (1.0 - q * b1 - t)) / (1.0 - s * t);
            next[k] = a;
            next_other[k] = q * b1 + t * (1.0 - a);
        }
        own = next;
        other = next_other;
    }
    own[n]
}

/// The chain with shared balls: who pots the last one wins.
fn shared(n: usize, run: [f64; 2]) -> f64 {
    let [p, q] = run;
    let (mut a, mut b) = (1.0, 1.0);
    for _ in 0..n {
        // a: the first player at the table; b: the second.
        let (s, t) = (1.0 - p, 1.0 - q);
        let next = (p * a + s * (1.0 - q * b - t)) / (1.0 - s * t);
        b = q * b + t * (1.0 - next);
        a = next;
    }
    a
}

/// Snooker: the lead after what is left, about normally distributed.
fn points(lead: f64, left: f64, run: f64) -> f64 {
    let left = left.max(0.0);
    // The visit: a run of balls, ended by a miss.
    let visit = (PER_BALL * run / (1.0 - run)).min(0.6 * left);
    let spread = SPREAD * left + 1.0;
    0.5 * (1.0 + libm::erf((lead + visit) / (core::f64::consts::SQRT_2 * spread)))
}

#[cfg(test)]
mod tests {
    use super::{shared, solve};

    #[test]
    fn equal_players_have_equal_chances_when_nobody_ever_misses_or_pots() {
        assert!((solve(5, 5, [0.98; 2]) - 0.91).abs() < 0.03);
        // With hardly any pots the first shot is worth little.
        let even = solve(3, 3, [0.02; 2]);
        assert!((even - 0.5).abs() < 0.05, "{even}");
        assert!(shared(9, [0.5; 2]) > 0.49);
    }

    #[test]
    fn the_chain_satisfies_its_equation() {
        let (p, q) = (0.7, 0.6);
        for n in 1..8 {
            for m in 1..8 {
                let w = solve(n, m, [p, q]);
                let other = solve(m, n, [q, p]);
                let again = p * solve(n - 1, m, [p, q]) + (1.0 - p) * (1.0 - other);
                assert!((w - again).abs() < 1e-12, "{n} {m}: {w} {again}");
            }
        }
    }

    #[test]
    fn fewer_balls_and_better_players_win_more_often() {
        assert!(solve(2, 5, [0.7; 2]) > solve(5, 5, [0.7; 2]));
        assert!(solve(5, 5, [0.8, 0.7]) > solve(5, 5, [0.7, 0.7]));
        // With one shared ball the player at the table has the better chance.
        assert!(shared(1, [0.6; 2]) > 0.6);
    }
}
