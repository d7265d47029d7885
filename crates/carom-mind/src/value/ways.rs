//! The ways of the object balls into the pockets, wherever the cue ball lies.
//!
//! A position is good if its balls can be potted one after the other. So a value looks at three
//! things: the pots from where the cue ball lies, the pots of the next ball from where the cue ball can
//! go then, and how easily each further ball goes into some pocket. All by geometry, without
//! simulated shots.

use carom::Noise;
use carom::math::{Vec2, log, sqrt};
use carom_rules::{BallIndex, Frame, MOST_BALLS, Turn};

use super::lanes::usual_tolerance;
use super::needs::{BallMask, only};
use crate::line::{THINNEST, chance_within, direction_error};
use crate::scene::{Scene, SceneBall, Window, ghost};

/// Most ways that are considered: six of 15 balls. Of the 21 balls of snooker that many are never open.
const MOST_WAYS: usize = 90;
/// First pots from which the next ball is looked for. A fourth one is hardly ever better.
const FIRST_POTS: usize = 3;
/// Distances that the cue ball runs after a pot, as shares of the table's width: a short roll, half the
/// width, and a little more than the width. They are for a cut of 90°; a fuller cut leaves the cue ball
/// less.
const RUNS: [f64; 3] = [0.15, 0.5, 1.1];
/// Directions of the cue ball after a pot: the tangent line of a stun shot, plus these shares of the line
/// of aim for stun, follow and draw.
const SPINS: [f64; 3] = [0.0, 0.6, -0.6];
/// Distance of a cue ball in hand behind the ball, ball radii: near, but with room for the cue.
const BEHIND: f64 = 4.0;
/// Limits of the chance of one ball in a product of chances: no ball is hopeless, and none is certain.
const RUN_CHANCES: [f64; 2] = [0.1, 0.99];

/// A way of a ball into a pocket.
#[derive(Clone, Copy, Debug, Default)]
struct Way {
    ball: BallIndex,
    /// Unit vector from the ball into the pocket.
    into: Vec2,
    /// Half of the width of the directions into the pocket, rad.
    half_width: f64,
    /// Where the cue ball's centre must be when it hits the ball, m.
    ghost: Vec2,
    /// Sum of the radii of the ball and the cue ball, m.
    reach: f64,
}

impl Way {
    /// Half of the width within which the direction of the cue ball must lie, rad, with the cue ball at
    /// `from`; 0 if the cut is too thin. Balls in the way of the cue ball are not considered.
    fn tolerance(&self, from: Vec2) -> f64 {
        let path = self.ghost - from;
        // The product of the length and the cosine of the cut angle.
        let (along, squared) = (path.dot(self.into), path.length_squared());
        if along <= 0.0 || along * along <= THINNEST * THINNEST * squared {
            // Balls that touch have no path between them.
            return if squared == 0.0 { self.half_width } else { 0.0 };
        }
        // The object ball turns by length / (reach cos) per angle of the cue ball, and by 1 at least.
        self.half_width * (self.reach * along / squared).min(1.0)
    }
}

/// All ways of a position that no other ball blocks. The cue ball is not in the way.
pub(crate) struct Ways<'a> {
    scene: Scene<'a>,
    cue: BallIndex,
    /// The cue ball's radius, m.
    radius: f64,
    ways: [Way; MOST_WAYS],
    count: usize,
}

/// A pot from a place of the cue ball.
#[derive(Clone, Copy, Debug)]
struct Pot<'w> {
    way: &'w Way,
    from: Vec2,
    tolerance: f64,
}

/// What the pots of a position promise.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Promise {
    /// The chance of the best pot; 0 if there is none.
    pub(crate) first: f64,
    /// The greatest chance of a pot and of one of the next ball, the cue ball where it is best for that.
    pub(crate) next: f64,
    /// The same with the mean over the places that the cue ball reaches.
    pub(crate) mean_next: f64,
    /// The ball that is potted first in [`Self::next`].
    pub(crate) ball: Option<BallIndex>,
}

/// How easily the balls of a set go into some pocket.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Ease {
    /// Number of balls.
    pub(crate) count: usize,
    /// The logarithm of the product of the chances of the balls' easiest pots.
    pub(crate) log_run: f64,
    /// The mean of these chances; 1 without balls.
    pub(crate) mean: f64,
    /// The least of them; 1 without balls.
    pub(crate) least: f64,
}

impl<'a> Ways<'a> {
    /// The ways of the balls of `frame`; the cue ball is that of `turn`.
    pub(crate) fn of(frame: &'a Frame, turn: &Turn) -> Self {
        let scene = Scene::new(frame);
        let cue = turn.cue;
        let radius = frame.layout().balls()[usize::from(cue)].ball.radius;
        let mut ways = Self { scene, cue, radius, ways: [Way::default(); MOST_WAYS], count: 0 };
        for ball in 0..scene.balls().len() {
            for pocket in 0..scene.table.pockets.len() {
                ways.add(scene.balls()[ball], pocket);
            }
        }
        ways
    }

    fn add(&mut self, ball: SceneBall, pocket: usize) {
        if ball.index == self.cue || self.count == MOST_WAYS {
            return;
        }
        let Some(window) = self.scene.window(ball.center, ball.radius, pocket) else { return };
        let except = [ball.index, self.cue];
        let reach = ball.radius + self.radius;
        let ghost = ghost(ball.center, window.way, reach);
        let target = ball.center + window.way * window.distance;
        if self.is_free(ghost, &except)
            && self.scene.is_clear(ball.center, target, ball.radius, &except)
        {
            let Window { way: into, half_width, .. } = window;
            self.ways[self.count] = Way { ball: ball.index, into, half_width, ghost, reach };
            self.count += 1;
        }
    }

    fn ways_of(&self, set: BallMask) -> impl Iterator<Item = &Way> {
        self.ways[..self.count].iter().filter(move |way| set & only(way.ball) != 0)
    }

    /// Whether the cue ball can lie at `place`, if the balls in `except` are not there.
    fn is_free(&self, place: Vec2, except: &[BallIndex]) -> bool {
        let half = self.scene.half_area(self.radius);
        place.x.abs() <= half.x
            && place.y.abs() <= half.y
            && self.scene.is_clear_place(place, self.radius, except)
    }

    /// The chance of each ball's easiest pot from a usual place of the cue ball, for a player with these
    /// errors; 0 for a ball that is blocked or not on the table.
    pub(crate) fn chances(&self, noise: &Noise) -> [f64; MOST_BALLS] {
        let error = direction_error(noise, self.radius);
        let width = self.scene.table.size.x;
        let mut widest = [0.0_f64; MOST_BALLS];
        for way in &self.ways[..self.count] {
            let half = &mut widest[usize::from(way.ball)];
            *half = half.max(way.half_width);
        }
        let chance = |half| chance_within(usual_tolerance(half, self.radius, width), error);
        widest.map(|half| if half > 0.0 { chance(half) } else { 0.0 })
    }

    /// The widest tolerance of a pot of `set` with the cue ball at `from`; 0 if there is none.
    /// `gone` is a ball that is off the table by then.
    fn widest(&self, set: BallMask, from: Vec2, gone: BallIndex) -> f64 {
        let mut widest = 0.0;
        for way in self.ways_of(set) {
            let tolerance = way.tolerance(from);
            let except = [self.cue, way.ball, gone];
            if tolerance > widest && self.scene.is_clear(from, way.ghost, self.radius, &except) {
                widest = tolerance;
            }
        }
        widest
    }

    /// What the pots of the balls `on` promise for a player with these errors. `next` gives the balls
    /// on after a ball; an empty set if the frame is won.
    pub(crate) fn promise(
        &self,
        turn: &Turn,
        on: BallMask,
        next: impl Fn(BallIndex) -> BallMask,
        noise: &Noise,
    ) -> Promise {
        let error = direction_error(noise, self.radius);
        let mut promise = Promise::default();
        for pot in self.first_pots(turn, on).iter().flatten() {
            let (ball, chance) = (pot.way.ball, chance_within(pot.tolerance, error));
            promise.first = promise.first.max(chance);
            let set = next(ball);
            let (best, mean) = if set == 0 { (1.0, 1.0) } else { self.after(pot, set, error) };
            if chance * best > promise.next {
                promise.next = chance * best;
                promise.ball = Some(ball);
            }
            promise.mean_next = promise.mean_next.max(chance * mean);
        }
        promise
    }

    /// The pots with the widest tolerances, the widest first, of which no ball blocks the cue ball.
    fn first_pots(&self, turn: &Turn, on: BallMask) -> [Option<Pot<'_>>; FIRST_POTS] {
        let mut pots: [Option<Pot<'_>>; FIRST_POTS] = [None; FIRST_POTS];
        let lies = self.scene.ball(self.cue).map(|cue| cue.center);
        for way in self.ways_of(on) {
            let from = if turn.hand.is_some() {
                let behind = way.ghost - way.into * ((BEHIND - 2.0) * self.radius);
                self.is_free(behind, &[self.cue]).then_some(behind)
            } else {
                lies
            };
            let Some(from) = from else { continue };
            let tolerance = way.tolerance(from);
            let is_wider =
                |kept: &Option<Pot<'_>>| tolerance > kept.map_or(0.0, |kept| kept.tolerance);
            let Some(place) = pots.iter().position(is_wider) else { continue };
            let except = [self.cue, way.ball];
            if self.scene.is_clear(from, way.ghost, self.radius, &except) {
                pots[place..].rotate_right(1);
                pots[place] = Some(Pot { way, from, tolerance });
            }
        }
        pots
    }

    /// The best and the mean chance of a pot of `set` after `pot`, over the places that the cue ball
    /// reaches.
    fn after(&self, pot: &Pot<'_>, set: BallMask, error: f64) -> (f64, f64) {
        let width = self.scene.table.size.x;
        let half = self.scene.half_area(self.radius);
        let path = pot.way.ghost - pot.from;
        let length = sqrt(path.length_squared());
        let aim = if length > 0.0 { path * (1.0 / length) } else { pot.way.into };
        let fullness = aim.dot(pot.way.into);
        let tangent = aim - pot.way.into * fullness;
        let (mut widest, mut sum) = (0.0_f64, 0.0);
        for spin in SPINS {
            let way = tangent + aim * (spin * fullness);
            for run in RUNS {
                let place = pot.way.ghost + way * (run * width);
                let place = Vec2::new(fold(place.x, half.x), fold(place.y, half.y));
                let tolerance = self.widest(set, place, pot.way.ball);
                if tolerance > 0.0 {
                    sum += chance_within(tolerance, error);
                }
                widest = widest.max(tolerance);
            }
        }
        let best = if widest > 0.0 { chance_within(widest, error) } else { 0.0 };
        (best, sum / (SPINS.len() * RUNS.len()) as f64)
    }
}

impl Ease {
    /// That of the balls of `set`, of which `chances` has the easiest pots ([`Ways::chances`]).
    pub(crate) fn of(set: BallMask, chances: &[f64; MOST_BALLS]) -> Self {
        let mut ease = Self { count: 0, log_run: 0.0, mean: 0.0, least: 1.0 };
        for (ball, chance) in (0..).zip(chances) {
            if set & only(ball) != 0 {
                ease.count += 1;
                ease.log_run += log_in_run(*chance);
                ease.mean += chance;
                ease.least = ease.least.min(*chance);
            }
        }
        ease.mean = if ease.count > 0 { ease.mean / ease.count as f64 } else { 1.0 };
        ease
    }
}

/// The logarithm of a ball's chance in a product.
pub(crate) fn log_in_run(chance: f64) -> f64 {
    let [least, most] = RUN_CHANCES;
    log(chance.clamp(least, most))
}

/// The coordinate of a ball that turns back at a cushion at ±`half`, at most once.
fn fold(x: f64, half: f64) -> f64 {
    if x > half {
        (2.0 * half - x).max(-half)
    } else if x < -half {
        (-2.0 * half - x).min(half)
    } else {
        x
    }
}

#[cfg(test)]
mod tests {
    use carom::Noise;
    use carom_rules::{Frame, Game, Options};

    use super::{Ease, Ways, fold};
    use crate::line::{Line, straight_to_pocket};
    use crate::scene::Scene;
    use crate::value::needs::{Needs, only};

    /// A frame of nine-ball with these balls, the first of them the cue ball.
    fn frame(places: &[(usize, [f64; 2])]) -> Frame {
        let mut frame = Frame::new(Game::NineBall, Options::default(), None, None, 0).unwrap();
        let mut all = vec![None; frame.layout().len()];
        places.iter().for_each(|(ball, place)| all[*ball] = Some(*place));
        frame.resume_at(&all, 0).unwrap();
        frame
    }

    #[test]
    fn tolerances_are_those_of_the_lines() {
        let frame = frame(&[(0, [0.5, 0.8]), (1, [0.35, 0.4]), (9, [0.9, 2.0])]);
        let (turn, scene) = (frame.turn().unwrap(), Scene::new(&frame));
        let (cue, one) = (scene.ball(0).unwrap(), scene.ball(1).unwrap());
        let lines = (0..6).filter_map(|pocket| straight_to_pocket(&scene, cue, one, pocket));
        let widest = lines.map(|line: Line| line.tolerance).fold(0.0, f64::max);
        let found = Ways::of(&frame, turn).widest(only(1), cue.center, 1);
        assert!(widest > 0.0 && (found / widest - 1.0).abs() < 1e-12, "{found} {widest}");
    }

    #[test]
    fn a_blocked_ball_has_no_chance_and_a_hanging_one_a_good_one() {
        // The 9 hangs in a corner. The 1 is frozen between two balls at the middle of a short rail.
        let places = [
            (0, [0.9, 1.5]),
            (1, [0.635, 0.03]),
            (2, [0.57, 0.03]),
            (3, [0.7, 0.03]),
            (9, [0.06, 2.48]),
        ];
        let frame = frame(&places);
        let ways = Ways::of(&frame, frame.turn().unwrap());
        let chances = ways.chances(&Noise::olympiad(1.0));
        assert!(chances[9] > 0.95, "{chances:?}");
        assert!(chances[1] < 0.05, "{chances:?}");
        assert_eq!(chances[4], 0.0);
        let ease = Ease::of(only(1) | only(9), &chances);
        assert_eq!((ease.count, ease.least), (2, chances[1].min(chances[9])));
        assert_eq!(Ease::of(0, &chances).mean, 1.0);
    }

    #[test]
    fn the_next_pot_counts_until_the_last_ball() {
        let noise = Noise::olympiad(1.0);
        let promise = |places: &[(usize, [f64; 2])]| {
            let frame = frame(places);
            let (turn, needs) = (frame.turn().unwrap(), Needs::of(&frame, frame.turn().unwrap()));
            let on = only(turn.on[0]);
            Ways::of(&frame, turn).promise(turn, on, |ball| needs.after(ball), &noise)
        };
        let last = promise(&[(0, [0.5, 0.5]), (9, [0.2, 0.2])]);
        assert_eq!((last.first, last.ball), (last.next, Some(9)));
        assert_eq!(last.next, last.mean_next);
        let two = promise(&[(0, [0.5, 0.5]), (8, [0.2, 0.2]), (9, [0.635, 2.4])]);
        assert!(two.first > two.next && two.next > two.mean_next, "{two:?}");
    }

    #[test]
    fn a_ball_turns_back_at_a_cushion() {
        assert_eq!([fold(0.5, 1.0), fold(1.25, 1.0), fold(-1.25, 1.0)], [0.5, 0.75, -0.75]);
        // No farther than across the table.
        assert_eq!(fold(9.0, 1.0), -1.0);
    }
}
