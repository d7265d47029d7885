//! Which balls the two players have to pot to win.

use carom_rules::games::eight_ball::{EIGHT, Group};
use carom_rules::games::snooker::On;
use carom_rules::{BallIndex, Frame, Objective, Seat, Turn};

/// A set of balls: bit k for ball k. A frame has at most 22 balls.
pub(crate) type BallMask = u32;

/// The set of one ball.
pub(crate) const fn only(ball: BallIndex) -> BallMask {
    1 << ball
}

/// The set of these balls.
pub(crate) fn set_of(balls: impl Iterator<Item = BallIndex>) -> BallMask {
    balls.fold(0, |set, ball| set | only(ball))
}

/// The balls that the players have to pot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Needs {
    /// The object balls on the table.
    all: BallMask,
    /// The balls of each seat before the last one. On an open table of eight-ball the solids and the
    /// stripes; in games with shared balls all balls.
    groups: [BallMask; 2],
    /// The eight of eight-ball.
    last: BallMask,
    order: Order,
}

/// In which order the balls are potted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Order {
    /// In that of their numbers.
    Numbers,
    /// The balls of the player's group in any order, then the eight. `None` is an open table.
    Group(Option<Seat>),
    /// Snooker: a red, then a colour of the player's choice, which is spotted again; at last the colours in
    /// ascending order. With the reds on the table.
    RedsAndColors(On, BallMask),
    /// Any.
    Free,
}

impl Needs {
    /// What the players of `frame` need, whose request is `turn`.
    pub(crate) fn of(frame: &Frame, turn: &Turn) -> Self {
        let all = set_of(frame.layout().on_table().filter(|ball| *ball != turn.cue));
        let shared = |order: Order| Self { all, groups: [all; 2], last: 0, order };
        match frame.facts().objective {
            Objective::LowestFirst => return shared(Order::Numbers),
            Objective::RedsAndColors => {
                let reds = set_of(frame.layout().on_table().filter(|b| frame.value(*b) == 1));
                return shared(Order::RedsAndColors(frame.kind_on().unwrap_or_default(), reds));
            }
            Objective::AnyBall | Objective::Caroms { .. } => return shared(Order::Free),
            Objective::Groups => {}
        }
        let of_group =
            |group: Group| set_of((1..=15).filter(|b| Group::of(*b) == Some(group))) & all;
        let groups = match frame.group(0) {
            None | Some(Group::Solids) => [Group::Solids, Group::Stripes],
            Some(Group::Stripes) => [Group::Stripes, Group::Solids],
        };
        let owner = frame.group(turn.player).map(|_| turn.player);
        let order = Order::Group(owner);
        Self { all, groups: groups.map(of_group), last: only(EIGHT) & all, order }
    }

    /// Whether the groups of eight-ball are still open.
    pub(crate) fn is_open(&self) -> bool {
        self.order == Order::Group(None)
    }

    /// The balls of `seat`, with the last one. On an open table `seat` is the number of a group.
    pub(crate) const fn balls(&self, seat: Seat) -> BallMask {
        self.groups[seat] | self.last
    }

    /// The eight of eight-ball; empty in other games.
    pub(crate) const fn last(&self) -> BallMask {
        self.last
    }

    /// The balls on for the same player after `ball` is potted.
    pub(crate) fn after(&self, ball: BallIndex) -> BallMask {
        let left = self.all & !only(ball);
        let group = match self.order {
            // The lowest bit.
            Order::Numbers => return left & left.wrapping_neg(),
            Order::Free => return left,
            Order::RedsAndColors(on, reds) => {
                let colors = self.all & !reds;
                let is_red = reds & only(ball) != 0;
                return match on {
                    _ if is_red => colors,
                    // The colour is spotted again.
                    On::Color if reds != 0 => reds,
                    On::Color => colors & colors.wrapping_neg(),
                    _ => {
                        let rest = colors & !only(ball);
                        rest & rest.wrapping_neg()
                    }
                };
            }
            Order::Group(Some(seat)) => self.groups[seat],
            Order::Group(None) => {
                let [solids, stripes] = self.groups;
                if solids & only(ball) != 0 { solids } else { stripes }
            }
        };
        let rest = group & !only(ball);
        if rest != 0 { rest } else { self.last & !only(ball) }
    }
}

#[cfg(test)]
mod tests {
    use carom_rules::{Frame, Game, Options};

    use super::{Needs, only, set_of};

    /// What is needed in a frame with these balls beside the cue ball. The first pot of eight-ball has
    /// not been made, so the table is open.
    fn needs(game: Game, balls: &[u16]) -> Needs {
        let mut frame = Frame::new(game, Options::default(), None, None, 0).unwrap();
        let mut places = vec![None; frame.layout().len()];
        places[0] = Some([0.3, 0.3]);
        for ball in balls {
            places[usize::from(*ball)] = Some([0.6, 0.2 + 0.1 * f64::from(*ball)]);
        }
        frame.resume_at(&places, 0).unwrap();
        Needs::of(&frame, frame.turn().unwrap())
    }

    #[test]
    fn the_group_of_the_first_pot_is_needed_next_and_then_the_eight() {
        let needs = needs(Game::EightBall, &[1, 2, 8, 9]);
        assert!(needs.is_open());
        assert_eq!(needs.after(1), only(2));
        assert_eq!(needs.after(9), only(8));
        assert_eq!(needs.after(8), set_of([9].into_iter()));
        assert_eq!(
            [0, 1].map(|seat| needs.balls(seat)),
            [set_of([1, 2, 8].into_iter()), set_of([8, 9].into_iter())]
        );
    }

    #[test]
    fn a_color_follows_a_red_in_snooker_and_at_last_they_fall_in_their_order() {
        let colors = set_of(16..=21);
        let reds_left = needs(Game::Snooker, &[1, 2, 16, 17, 18, 19, 20, 21]);
        assert_eq!(reds_left.after(1), colors);
        let none_left = needs(Game::Snooker, &[16, 17, 18, 19, 20, 21]);
        assert_eq!(none_left.after(16), only(17));
        assert_eq!(needs(Game::Snooker, &[21]).after(21), 0);
    }

    #[test]
    fn the_lowest_ball_is_next_in_nine_ball_and_nothing_after_the_nine() {
        let needs = needs(Game::NineBall, &[3, 7, 9]);
        assert_eq!(needs.after(3), only(7));
        assert_eq!(self::needs(Game::NineBall, &[9]).after(9), 0);
    }
}
