//! The way of a cue ball in a game of carom: the balls and cushions that it touched, up to its second object ball.

use carom::Table;
use carom::outcome::{Outcome, Touched};
use carom::table::Rail;

use crate::layout::{BallIndex, FROZEN};

/// What a cue ball touched up to its second object ball, or to the end of the shot if it met fewer than two. A first
/// touch of a cushion to which it was frozen does not count (UMB, article 83).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CaromWay<'a> {
    /// Number of the touches before these that do not count.
    skipped: usize,
    touched: &'a [Touched],
    first: Option<BallIndex>,
    second: Option<BallIndex>,
}

impl<'a> CaromWay<'a> {
    /// The way of a cue ball with this radius, m, that lay at `place`, m, file coordinates, on `table`.
    pub fn new(outcome: &'a Outcome, table: &Table, place: [f64; 2], radius: f64) -> Self {
        let frozen_to = frozen_to(table, place, radius);
        let pressed =
            |t: &Touched| matches!(t, Touched::Rail(rail) if frozen_to.contains(&Some(*rail)));
        let all = &outcome.cue_ball_touched;
        let skipped = usize::from(all.first().is_some_and(pressed));
        Self { skipped, ..Self::of(&all[skipped..]) }
    }

    fn of(touched: &'a [Touched]) -> Self {
        let ball = |t: &Touched| match t {
            Touched::Ball(ball) => Some(*ball),
            Touched::Rail(_) => None,
        };
        let first = touched.iter().find_map(ball);
        let is_second = |t: &Touched| ball(t).is_some_and(|other| Some(other) != first);
        let end = touched.iter().position(is_second);
        Self {
            skipped: 0,
            touched: &touched[..end.unwrap_or(touched.len())],
            first,
            second: end.and_then(|k| ball(&touched[k])),
        }
    }

    /// The touches that count among those of the outcome: cushions, and balls up to the second one.
    pub fn counted(&self) -> core::ops::Range<usize> {
        let end = self.skipped + self.touched.len();
        self.skipped..end + usize::from(self.second.is_some())
    }

    /// The first object ball.
    pub const fn first(&self) -> Option<BallIndex> {
        self.first
    }

    /// The second one.
    pub const fn second(&self) -> Option<BallIndex> {
        self.second
    }

    /// The rails of the cushions before the second object ball, in order.
    pub fn rails(&self) -> impl Iterator<Item = Rail> + 'a {
        self.touched.iter().filter_map(|t| match t {
            Touched::Rail(rail) => Some(*rail),
            Touched::Ball(_) => None,
        })
    }

    /// Number of those that come before the first object ball.
    pub fn rails_first(&self) -> usize {
        self.touched.iter().take_while(|t| matches!(t, Touched::Rail(_))).count()
    }

    /// The count of a shot that needs `needed` cushions.
    pub(crate) fn count(&self, needed: usize) -> CaromCount {
        let number = |count: usize| u8::try_from(count).unwrap_or(u8::MAX);
        CaromCount {
            balls: u8::from(self.first.is_some()) + u8::from(self.second.is_some()),
            cushions: number(self.rails().count()),
            needed: number(needed),
            stayed: false,
        }
    }
}

/// What a referee of carom counts in a shot.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct CaromCount {
    /// Object balls that the cue ball touched: 2 for two and more.
    pub balls: u8,
    /// Cushions that it touched before the second of them, or in the whole shot if it touched fewer than two.
    pub cushions: u8,
    /// Cushions that the shot needs.
    pub needed: u8,
    /// Whether the balls stayed in a corner's zone, so that the carom does not count.
    pub stayed: bool,
}

impl CaromCount {
    /// Whether the cue ball touched two object balls, and enough cushions before the second of them.
    pub(crate) const fn is_carom(&self) -> bool {
        self.balls == 2 && self.cushions >= self.needed
    }
}

/// Some of the four rails of a table without pockets.
type RailSet = [Option<Rail>; 4];

/// The rails to which a ball is frozen.
fn frozen_to(table: &Table, [x, y]: [f64; 2], radius: f64) -> RailSet {
    let reach = table.reach(radius) + FROZEN;
    let near = [
        (x, Rail::Left),
        (table.size.x - x, Rail::Right),
        (y, Rail::Bottom),
        (table.size.y - y, Rail::Top),
    ];
    near.map(|(distance, rail)| (distance <= reach).then_some(rail))
}

#[cfg(test)]
mod tests {
    use super::*;

    const LEFT: Touched = Touched::Rail(Rail::Left);
    const TOP: Touched = Touched::Rail(Rail::Top);

    #[test]
    fn cushions_count_up_to_the_second_ball() {
        let touched = [LEFT, Touched::Ball(2), TOP, Touched::Ball(2), LEFT, Touched::Ball(1), TOP];
        let way = CaromWay::of(&touched);
        assert_eq!((way.first(), way.second(), way.rails_first()), (Some(2), Some(1), 1));
        assert_eq!(way.rails().collect::<Vec<_>>(), [Rail::Left, Rail::Top, Rail::Left]);
        let count = way.count(3);
        assert_eq!((count.balls, count.cushions, count.is_carom()), (2, 3, true));
        assert!(!way.count(4).is_carom());
    }

    #[test]
    fn without_a_second_ball_every_cushion_counts() {
        let count = CaromWay::of(&[TOP, Touched::Ball(1), LEFT, TOP]).count(0);
        assert_eq!((count.balls, count.cushions, count.is_carom()), (1, 3, false));
        assert_eq!(CaromWay::of(&[]).count(0).balls, 0);
    }
}
