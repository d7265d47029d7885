//! The balls of a frame as lines of aim see them: circles on a plane, and the pockets' mouths.
//!
//! All positions are in the engine's coordinates: the origin is the table's centre.

use carom::Table;
use carom::math::{Vec2, asin, sqrt};
use carom_plan::Prepared;
use carom_rules::{BallIndex, Frame, FrameLayout, MOST_BALLS};

/// Share of a ball's radius by which its centre must pass a pocket's jaw. A ball that touches the
/// jaw a little still falls; with the whole radius thin windows would be missed.
const CLEARANCE_AT_JAW: f64 = 0.85;
/// A corridor is free if every ball is at least this much outside it, m: half a millimetre, about
/// the error of an aim by geometry.
const SPARE: f64 = 5e-4;

/// A ball on the table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SceneBall {
    /// Its index in the frame.
    pub index: BallIndex,
    /// Its centre, m.
    pub center: Vec2,
    /// Its radius, m.
    pub radius: f64,
}

/// The balls on a table, and the table.
#[derive(Clone, Copy, Debug)]
pub struct Scene<'a> {
    /// The table.
    pub table: &'a Table,
    balls: [SceneBall; MOST_BALLS],
    count: usize,
}

/// The directions in which a ball can enter a pocket.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Window {
    /// Unit vector from the ball to the middle of the window.
    pub way: Vec2,
    /// Half of the window's width, rad.
    pub half_width: f64,
    /// Distance from the ball to the middle of the mouth, m.
    pub distance: f64,
}

impl<'a> Scene<'a> {
    /// The balls of `frame` where they lie.
    pub fn new(frame: &'a Frame) -> Self {
        Self::of_layout(frame.layout(), frame.base().table())
    }

    /// The balls of a prepared shot, with a cue ball in hand where it was placed.
    pub fn of(prepared: &'a Prepared<'_>) -> Self {
        Self::of_layout(prepared.before(), prepared.frame().base().table())
    }

    fn of_layout(layout: &FrameLayout, table: &'a Table) -> Self {
        let middle = table.center();
        let none = SceneBall { index: 0, center: Vec2::ZERO, radius: 0.0 };
        let mut scene = Self { table, balls: [none; MOST_BALLS], count: 0 };
        for (index, ball) in (0..).zip(layout.balls()) {
            let Some([x, y]) = layout.place(index) else { continue };
            let center = Vec2::new(x, y) - middle;
            scene.balls[scene.count] = SceneBall { index, center, radius: ball.ball.radius };
            scene.count += 1;
        }
        scene
    }

    /// The balls on the table, in the order of their indices.
    pub fn balls(&self) -> &[SceneBall] {
        &self.balls[..self.count]
    }

    /// The ball with this index, if it is on the table.
    pub fn ball(&self, index: BallIndex) -> Option<SceneBall> {
        self.balls().iter().copied().find(|ball| ball.index == index)
    }

    /// Whether a ball of `radius` can move from `from` to `to` (m) without touching a ball other
    /// than those in `except`.
    pub fn is_clear(&self, from: Vec2, to: Vec2, radius: f64, except: &[BallIndex]) -> bool {
        let way = to - from;
        let length = way.length();
        if length == 0.0 {
            return self.is_clear_place(from, radius, except);
        }
        let unit = way * (1.0 / length);
        self.balls().iter().all(|ball| {
            let reach = radius + ball.radius + SPARE;
            let offset = ball.center - from;
            let beside = unit.cross(offset);
            if beside.abs() >= reach || except.contains(&ball.index) {
                return true;
            }
            let along = unit.dot(offset).clamp(0.0, length);
            (offset - unit * along).length_squared() >= reach * reach
        })
    }

    /// The directions in which a ball of `radius` at `from` (m) can enter pocket number `pocket`;
    /// none if its jaws leave no room.
    pub fn window(&self, from: Vec2, radius: f64, pocket: usize) -> Option<Window> {
        let pocket = &self.table.pockets[pocket];
        let [a, b] = pocket.mouth;
        let middle = (a + b) * 0.5;
        let to_middle = middle - from;
        let distance = to_middle.length();
        // A ball in the mouth falls if it is hit towards the hole.
        let to_hole = pocket.center - from;
        let length = to_hole.length();
        if distance < radius || length < pocket.radius {
            let way = if length > 0.0 { to_hole * (1.0 / length) } else { pocket.axis };
            return Some(Window { way, half_width: core::f64::consts::FRAC_PI_4, distance });
        }
        // From behind the plane of the mouth a pocket cannot be entered.
        if to_middle.dot(pocket.axis) <= 0.0 {
            return None;
        }
        // The jaw to the right of the line of sight limits the window on the right.
        let (right, left) = if to_middle.cross(a - from) < 0.0 { (a, b) } else { (b, a) };
        let clearance = CLEARANCE_AT_JAW * radius;
        let least = way_past(right - from, clearance);
        let most = way_past(left - from, -clearance);
        if least.cross(most) <= 0.0 {
            return None;
        }
        let (sum, chord) = (least + most, most - least);
        let way = sum * (1.0 / sqrt(sum.length_squared()));
        let half_width = asin((0.5 * sqrt(chord.length_squared())).min(1.0));
        Some(Window { way, half_width, distance })
    }

    /// Whether a ball of `radius` can lie at `place` (m) without touching a ball other than those
    /// in `except`.
    pub fn is_clear_place(&self, place: Vec2, radius: f64, except: &[BallIndex]) -> bool {
        self.balls().iter().all(|ball| {
            let reach = radius + ball.radius + SPARE;
            (ball.center - place).length_squared() >= reach * reach || except.contains(&ball.index)
        })
    }

    /// The nearest distance of a ball's centre to the nose lines, m: half the playing area, less
    /// the ball's reach, along x and y.
    pub fn half_area(&self, radius: f64) -> Vec2 {
        let reach = self.table.reach(radius);
        Vec2::new(0.5 * self.table.size.x - reach, 0.5 * self.table.size.y - reach)
    }
}

/// The direction, a unit vector, of a line that passes the point `jaw` at `clearance` (m) on its
/// left; on its right, if the clearance is negative.
fn way_past(jaw: Vec2, clearance: f64) -> Vec2 {
    let inverse = 1.0 / sqrt(jaw.length_squared());
    let unit = jaw * inverse;
    // The sine of the angle between the line and the jaw.
    let sin = (clearance * inverse).clamp(-1.0, 1.0);
    unit * sqrt(1.0 - sin * sin) + unit.perp() * sin
}

/// The ghost ball: where the centre of a ball must be to send a ball at `object` along the unit
/// vector `way`, if the radii add up to `reach` (m).
pub fn ghost(object: Vec2, way: Vec2, reach: f64) -> Vec2 {
    object - way * reach
}

/// Unit vector from `from` to `to`, and the distance (m); none if they coincide.
pub fn towards(from: Vec2, to: Vec2) -> Option<(Vec2, f64)> {
    let way = to - from;
    let length = sqrt(way.length_squared());
    (length > 0.0).then(|| (way * (1.0 / length), length))
}

#[cfg(test)]
mod tests {
    use carom::math::{Vec2, degrees};
    use carom_rules::{Frame, Game, Options};

    use super::Scene;

    #[test]
    fn the_window_of_a_corner_is_widest_on_its_axis_and_narrows_with_distance() {
        let frame = Frame::new(Game::EightBall, Options::default(), None, None, 0).unwrap();
        let scene = Scene::new(&frame);
        let pocket = &scene.table.pockets[0];
        let [a, b] = pocket.mouth;
        let (middle, radius) = ((a + b) * 0.5, 0.028575);
        let from = |distance: f64, degrees: f64| {
            let (sin, cos) = carom::math::sin_cos(carom::math::radians(degrees));
            let back = pocket.axis * -distance;
            scene.window(middle + back * cos + back.perp() * sin, radius, 0)
        };
        let near = from(0.4, 0.0).unwrap();
        let far = from(0.8, 0.0).unwrap();
        let aside = from(0.4, 35.0).unwrap();
        assert!(near.half_width > far.half_width && near.half_width > aside.half_width);
        assert!((near.way - pocket.axis).length() < 1e-9);
        assert!((1.0..6.0).contains(&degrees(near.half_width)), "{near:?}");
        assert_eq!(from(0.4, 100.0), None);
    }

    #[test]
    fn a_corridor_is_clear_up_to_the_touch_of_a_ball() {
        let mut frame = Frame::new(Game::NineBall, Options::default(), None, None, 0).unwrap();
        let mut places = vec![None; frame.layout().len()];
        places[0] = Some([0.3, 0.3]);
        places[9] = Some([0.6, 1.0]);
        frame.resume_at(&places, 0).unwrap();
        let scene = Scene::new(&frame);
        let nine = scene.ball(9).unwrap().center;
        let way = |beside: f64| {
            let x = nine.x + beside;
            scene.is_clear(Vec2::new(x, -1.0), Vec2::new(x, 1.0), 0.028575, &[0])
        };
        assert!(way(0.0578) && way(-0.0578));
        assert!(!way(0.0570) && !way(0.0));
        // A path that ends before the ball is clear.
        assert!(scene.is_clear(
            Vec2::new(nine.x, -1.0),
            Vec2::new(nine.x, nine.y - 0.06),
            0.028575,
            &[0]
        ));
    }
}
