//! Lines: the ways in which a cue ball can send a ball into a pocket.
//!
//! A line is found by geometry alone (ghost balls and mirror images, as players aim). Its azimuth
//! is a first estimate, because throw, squirt and the cushions' losses change it; [`crate::aim`]
//! corrects it by simulation. Its chance is an estimate too, which orders the lines.

use core::f64::consts::SQRT_2;

use carom::math::{Vec2, atan2, sqrt};
use carom::table::PocketName;
use carom::{Noise, Table};
use carom_rules::BallIndex;

use crate::scene::{Scene, SceneBall, Window, ghost, towards};
use crate::targets::Targets;

/// Cosine of the largest cut angle of a line: 82°. Thinner cuts send the ball away with less than
/// a seventh of the speed.
pub(crate) const THINNEST: f64 = 0.139;
/// The width of a pocket as counted, over that of geometry: a ball that touches a jaw or a facing
/// often falls. Fitted once, as [`FALLS`], to 2700 plays of 60 frames of eight-ball at the
/// Olympiad's noise, with 1500 simulations a decision; each play was counted 90 times.
const REAL_WIDTH: f64 = 1.5;
/// Share of the balls on the way into a pocket that fall, without and with a cushion before: the
/// errors of speed and spin make others miss.
const FALLS: [f64; 2] = [0.98, 0.92];
/// Tangents of the angle between a cushion and a ball that leaves it, over that of the ball that
/// comes: of a mirror, and of a rolling ball that meets the cushion softly. The first one whose
/// way is free makes the line of a kick.
const REBOUNDS: [f64; 3] = [1.0, 0.7, 0.5];
/// The error of direction (rad) that no noise model counts: throw and swerve that vary with the
/// errors of speed and spin. A twentieth of a degree. Estimated.
const OWN_ERROR: f64 = 9e-4;
/// Change of the cue ball's direction (rad) per ball radius of side offset: squirt of a usual shaft
/// (TP A.31).
const SQUIRT: f64 = 0.075;

/// How the cue ball reaches the ball, and the ball the pocket.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum LineKind {
    /// Straight to the ball, and straight into the pocket.
    Direct,
    /// The object ball goes off a cushion.
    Bank,
    /// The cue ball goes off a cushion first.
    Kick,
    /// The first ball drives another into the pocket.
    Combination,
}

impl LineKind {
    /// The name that players give it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Direct => "direct",
            Self::Bank => "bank",
            Self::Kick => "kick",
            Self::Combination => "combination",
        }
    }
}

/// A part of a line: a ball moves, off a number of cushions, to a target.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineLeg {
    /// The ball that moves.
    pub ball: BallIndex,
    /// Number of cushions that it meets.
    pub cushions: u8,
    /// Where its centre must arrive, m, engine's coordinates.
    pub target: Vec2,
}

/// A way to send a ball into a pocket.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// How.
    pub kind: LineKind,
    /// The ball that the cue ball hits first.
    pub first: BallIndex,
    /// The ball that is to fall.
    pub object: BallIndex,
    /// Number of the pocket.
    pub pocket: usize,
    /// The paths of the balls, first that of the cue ball.
    legs: [LineLeg; 3],
    count: usize,
    /// Direction of the cue ball, rad, by geometry.
    pub azimuth: f64,
    /// Half of the width within which the azimuth must lie, rad, by geometry.
    pub tolerance: f64,
    /// Distance of the object ball's path from the pocket per azimuth, m per rad, by geometry.
    pub slope: f64,
    /// Cosine of the angle at which the first ball is cut.
    pub fullness: f64,
    /// Lengths of the paths of the cue ball and of the object balls, m.
    pub lengths: [f64; 2],
}

impl Line {
    /// The paths of the balls, first that of the cue ball.
    pub fn legs(&self) -> &[LineLeg] {
        &self.legs[..self.count]
    }

    /// The ball that is to fall, and the name of its pocket on `table`.
    pub(crate) fn pot(&self, table: &Table) -> (BallIndex, PocketName) {
        (self.object, table.pockets[self.pocket].name)
    }

    /// The estimated probability that the ball falls, for a player with these errors. `radius` is
    /// the cue ball's, m.
    pub fn chance(&self, noise: &Noise, radius: f64) -> f64 {
        let error = direction_error(noise, radius);
        let has_cushion = self.legs().iter().any(|leg| leg.cushions > 0);
        FALLS[usize::from(has_cushion)] * chance_within(self.tolerance, error)
    }

    /// The least speed (m/s) of the cue ball at the first contact with which the object ball
    /// reaches the pocket against a rolling deceleration `rolling` (m/s²), without losses at
    /// cushions.
    pub fn least_speed(&self, rolling: f64) -> f64 {
        // A ball that is hit while it does not roll keeps 5/7 of its speed when it rolls.
        const ROLLS: f64 = 5.0 / 7.0;
        sqrt(2.0 * rolling * self.lengths[1]) / (ROLLS * self.fullness.max(THINNEST))
    }
}

/// The probability that a ball falls if the cue ball's direction may be wrong by `tolerance` and
/// has the standard deviation `error` (rad).
pub(crate) fn chance_within(tolerance: f64, error: f64) -> f64 {
    libm::erf(REAL_WIDTH * tolerance / (SQRT_2 * error))
}

/// The standard deviation (rad) of the cue ball's direction for a player with these errors: that of
/// the cue, of squirt, and of what the noise does not count. `radius` is the cue ball's, m.
pub(crate) fn direction_error(noise: &Noise, radius: f64) -> f64 {
    // No error of a direction depends on the speed.
    let [_, azimuth, _, side, _] = noise.deviations(0.0);
    let side = SQUIRT * side / radius;
    // Right of centre, at a positive side, squirt turns to the left, as a positive azimuth does.
    let both = 2.0 * SQUIRT / radius * noise.covariance_at(0.0)[1][3];
    sqrt(
        (azimuth * azimuth + side * side + OWN_ERROR * OWN_ERROR + both).max(OWN_ERROR * OWN_ERROR),
    )
}

/// Adds every direct line to `lines`.
pub fn direct(scene: &Scene<'_>, targets: &Targets, lines: &mut Vec<Line>) {
    let Some(cue) = scene.ball(targets.cue) else { return };
    for object in objects(scene, targets).filter(|ball| targets.first.contains(&ball.index)) {
        for pocket in 0..scene.table.pockets.len() {
            lines.extend(straight_to_pocket(scene, cue, object, pocket));
        }
    }
}

/// The direct line that sends `object` into `pocket`; none if something is in the way.
pub fn straight_to_pocket(
    scene: &Scene<'_>,
    cue: SceneBall,
    object: SceneBall,
    pocket: usize,
) -> Option<Line> {
    let window = scene.window(object.center, object.radius, pocket)?;
    let contact = Contact::new(cue, object, window.way)?;
    let target = target(object.center, &window);
    let except = [cue.index, object.index];
    let is_clear = scene.is_clear(cue.center, contact.ghost, cue.radius, &except)
        && scene.is_clear(object.center, target, object.radius, &except);
    let goes = TwoLegs { contact, window, target, way: contact.way };
    is_clear.then(|| goes.line(LineKind::Direct, cue.index, object.index, pocket))
}

/// Adds the lines on which the object ball goes off one cushion.
pub fn banks(scene: &Scene<'_>, targets: &Targets, lines: &mut Vec<Line>) {
    let Some(cue) = scene.ball(targets.cue) else { return };
    for object in objects(scene, targets).filter(|ball| targets.first.contains(&ball.index)) {
        for pocket in 0..scene.table.pockets.len() {
            for side in SIDES {
                lines.extend(bank(scene, cue, object, pocket, side));
            }
        }
    }
}

fn bank(
    scene: &Scene<'_>,
    cue: SceneBall,
    object: SceneBall,
    pocket: usize,
    side: Side,
) -> Option<Line> {
    // The object ball's mirror image sees the pocket as the ball does after the cushion.
    let image = side.mirror(scene, object.center, object.radius);
    let window = scene.window(image, object.radius, pocket)?;
    let target = target(image, &window);
    let bounce = side.crossing(scene, image, target, object.radius)?;
    let (way, _) = towards(object.center, bounce)?;
    let contact = Contact::new(cue, object, way)?;
    let except = [cue.index, object.index];
    let is_clear = scene.is_clear(cue.center, contact.ghost, cue.radius, &except)
        && scene.is_clear(object.center, bounce, object.radius, &[object.index])
        && scene.is_clear(bounce, target, object.radius, &[object.index]);
    let goes = TwoLegs { contact, window, target, way: contact.way };
    is_clear.then(|| goes.line(LineKind::Bank, cue.index, object.index, pocket))
}

/// Adds the lines on which the cue ball goes off one cushion before it meets the object ball.
pub fn kicks(scene: &Scene<'_>, targets: &Targets, lines: &mut Vec<Line>) {
    let Some(cue) = scene.ball(targets.cue) else { return };
    for object in objects(scene, targets).filter(|ball| targets.first.contains(&ball.index)) {
        for pocket in 0..scene.table.pockets.len() {
            for side in SIDES {
                let kick = |rebound: &f64| kick(scene, cue, object, pocket, side, *rebound);
                lines.extend(REBOUNDS.iter().find_map(kick));
            }
        }
    }
}

fn kick(
    scene: &Scene<'_>,
    cue: SceneBall,
    object: SceneBall,
    pocket: usize,
    side: Side,
    rebound: f64,
) -> Option<Line> {
    let window = scene.window(object.center, object.radius, pocket)?;
    let target = target(object.center, &window);
    // Seen from behind the cushion the cue ball comes from nearer to it if it rebounds at a
    // flatter angle.
    let mirrored = side.mirror(scene, cue.center, cue.radius);
    let near = cue.center + (mirrored - cue.center) * (0.5 * (1.0 + rebound));
    let image = SceneBall { center: near, ..cue };
    let contact = Contact::new(image, object, window.way)?;
    let bounce = side.crossing(scene, image.center, contact.ghost, cue.radius)?;
    let except = [cue.index, object.index];
    let is_clear = scene.is_clear(cue.center, bounce, cue.radius, &[cue.index])
        && scene.is_clear(bounce, contact.ghost, cue.radius, &except)
        && scene.is_clear(object.center, target, object.radius, &except);
    let (way, _) = towards(cue.center, bounce)?;
    let goes = TwoLegs { contact, window, target, way };
    is_clear.then(|| goes.line(LineKind::Kick, cue.index, object.index, pocket))
}

/// Adds the lines on which the first ball drives another one into the pocket.
pub fn combinations(scene: &Scene<'_>, targets: &Targets, lines: &mut Vec<Line>) {
    let Some(cue) = scene.ball(targets.cue) else { return };
    for object in objects(scene, targets) {
        for pocket in 0..scene.table.pockets.len() {
            let Some(window) = scene.window(object.center, object.radius, pocket) else { continue };
            let others = scene.balls().iter().filter(|ball| targets.first.contains(&ball.index));
            for first in others.filter(|ball| ball.index != object.index) {
                lines.extend(combination(scene, cue, *first, object, pocket, &window));
            }
        }
    }
}

fn combination(
    scene: &Scene<'_>,
    cue: SceneBall,
    first: SceneBall,
    object: SceneBall,
    pocket: usize,
    window: &Window,
) -> Option<Line> {
    let target = target(object.center, window);
    let second = Contact::new(first, object, window.way)?;
    let contact = Contact::new(cue, first, second.way)?;
    let (c, f, o) = (cue.index, first.index, object.index);
    let is_clear = scene.is_clear(cue.center, contact.ghost, cue.radius, &[c, f])
        && scene.is_clear(first.center, second.ghost, first.radius, &[c, f, o])
        && scene.is_clear(object.center, target, object.radius, &[c, f, o]);
    let legs = [
        LineLeg { ball: c, cushions: 0, target: contact.ghost },
        LineLeg { ball: f, cushions: 0, target: second.ghost },
        LineLeg { ball: o, cushions: 0, target },
    ];
    let amplified = contact.turn() * second.turn();
    is_clear.then(|| Line {
        kind: LineKind::Combination,
        first: f,
        object: o,
        pocket,
        legs,
        count: 3,
        azimuth: atan2(contact.way.y, contact.way.x),
        tolerance: window.half_width / amplified,
        slope: -amplified * window.distance,
        fullness: contact.fullness * second.fullness,
        lengths: [contact.distance, second.distance + window.distance],
    })
}

/// The path of the cue ball to its contact, and of the object ball to the pocket.
struct TwoLegs {
    contact: Contact,
    window: Window,
    /// Where the object ball arrives, m.
    target: Vec2,
    /// The cue ball's first direction, a unit vector.
    way: Vec2,
}

impl TwoLegs {
    fn line(&self, kind: LineKind, cue: BallIndex, object: BallIndex, pocket: usize) -> Line {
        let Self { contact, window, target, way } = self;
        let before = u8::from(kind == LineKind::Kick);
        let after = u8::from(kind == LineKind::Bank);
        let own = LineLeg { ball: cue, cushions: before, target: contact.ghost };
        let other = LineLeg { ball: object, cushions: after, target: *target };
        let amplified = contact.turn();
        let slope = amplified * window.distance;
        Line {
            kind,
            first: object,
            object,
            pocket,
            legs: [own, other, other],
            count: 2,
            azimuth: atan2(way.y, way.x),
            tolerance: window.half_width / amplified,
            // A mirror reverses the sense of a turn.
            slope: if before + after > 0 { -slope } else { slope },
            fullness: contact.fullness,
            lengths: [contact.distance, window.distance],
        }
    }
}

fn objects<'a>(scene: &'a Scene<'_>, targets: &'a Targets) -> impl Iterator<Item = SceneBall> + 'a {
    scene.balls().iter().copied().filter(|ball| targets.objects.contains(&ball.index))
}

/// Where a ball at `from` arrives in the mouth: the point of the window's line next to its middle.
fn target(from: Vec2, window: &Window) -> Vec2 {
    from + window.way * window.distance
}

/// The contact with which a ball sends another one along a direction.
#[derive(Clone, Copy, Debug)]
struct Contact {
    /// Where the moving ball's centre must be, m.
    ghost: Vec2,
    /// Direction and length (m) of its path there.
    way: Vec2,
    distance: f64,
    /// Cosine of the cut angle.
    fullness: f64,
    /// Sum of the radii, m.
    reach: f64,
}

impl Contact {
    /// None if the cut would be thinner than [`THINNEST`].
    fn new(moving: SceneBall, object: SceneBall, way: Vec2) -> Option<Self> {
        let reach = moving.radius + object.radius;
        let place = ghost(object.center, way, reach);
        // Balls that touch have no path between them: the line of centres is the direction.
        let (towards, distance) = towards(moving.center, place).unwrap_or((way, 0.0));
        let fullness = towards.dot(way);
        (fullness > THINNEST).then_some(Self {
            ghost: place,
            way: towards,
            distance,
            fullness,
            reach,
        })
    }

    /// The angle by which the object ball turns per angle of the moving ball's direction.
    fn turn(&self) -> f64 {
        (self.distance / (self.reach * self.fullness)).max(1.0)
    }
}

/// A cushion line of the table.
#[derive(Clone, Copy, Debug)]
struct Side {
    /// Whether the line is at a constant x.
    across: bool,
    sign: f64,
}

const SIDES: [Side; 4] = [
    Side { across: true, sign: 1.0 },
    Side { across: true, sign: -1.0 },
    Side { across: false, sign: 1.0 },
    Side { across: false, sign: -1.0 },
];

impl Side {
    /// The line on which the centre of a ball of `radius` turns back, m.
    fn at(self, scene: &Scene<'_>, radius: f64) -> f64 {
        let half = scene.half_area(radius);
        self.sign * if self.across { half.x } else { half.y }
    }

    /// The mirror image of `point` behind the cushion.
    fn mirror(self, scene: &Scene<'_>, point: Vec2, radius: f64) -> Vec2 {
        let at = 2.0 * self.at(scene, radius);
        if self.across {
            Vec2::new(at - point.x, point.y)
        } else {
            Vec2::new(point.x, at - point.y)
        }
    }

    /// Where the straight line from `image`, behind the cushion, to `target` crosses it; none if
    /// it does not, or crosses it at a pocket.
    fn crossing(self, scene: &Scene<'_>, image: Vec2, target: Vec2, radius: f64) -> Option<Vec2> {
        let at = self.at(scene, radius);
        let of = |p: Vec2| if self.across { p.x } else { p.y };
        let share = (at - of(image)) / (of(target) - of(image));
        if !(share > 0.0 && share < 1.0) {
            return None;
        }
        let point = image + (target - image) * share;
        let half = scene.half_area(radius);
        let inside = if self.across { point.y.abs() < half.y } else { point.x.abs() < half.x };
        let at_pocket = scene.table.pockets.iter().any(|pocket| {
            let [a, b] = pocket.mouth;
            (point - (a + b) * 0.5).length_squared() < (b - a).length_squared()
        });
        (inside && !at_pocket).then_some(point)
    }
}

#[cfg(test)]
mod tests {
    use carom::Noise;
    use carom_rules::{Frame, Game, Options};

    use super::{Line, LineKind, banks, combinations, direct, kicks};
    use crate::scene::Scene;
    use crate::targets::Targets;

    /// A frame of nine-ball with these balls, the first of them the cue ball.
    fn frame(places: &[(usize, [f64; 2])]) -> Frame {
        let mut frame = Frame::new(Game::NineBall, Options::default(), None, None, 0).unwrap();
        let mut all = vec![None; frame.layout().len()];
        places.iter().for_each(|(ball, place)| all[*ball] = Some(*place));
        frame.resume_at(&all, 0).unwrap();
        frame
    }

    fn lines(frame: &Frame, find: fn(&Scene<'_>, &Targets, &mut Vec<Line>)) -> Vec<Line> {
        let targets = Targets::of(frame, frame.turn().unwrap());
        let mut lines = Vec::new();
        find(&Scene::new(frame), &targets, &mut lines);
        lines
    }

    const HANGING: [(usize, [f64; 2]); 3] = [(0, [0.4, 0.4]), (1, [0.2, 0.2]), (9, [0.9, 2.0])];

    #[test]
    fn a_straight_pot_has_a_direct_line_of_high_chance() {
        let frame = frame(&HANGING);
        let found = lines(&frame, direct);
        let best = found.iter().max_by(|a, b| a.tolerance.total_cmp(&b.tolerance)).unwrap();
        assert_eq!((best.kind, best.object, best.pocket), (LineKind::Direct, 1, 0));
        assert!(best.fullness > 0.999);
        assert!(best.chance(&Noise::olympiad(1.0), 0.028575) > 0.97);
        assert!(best.chance(&Noise::olympiad(60.0), 0.028575) < 0.7);
    }

    #[test]
    fn a_ball_in_the_way_blocks_the_line() {
        let mut places = HANGING.to_vec();
        places.push((5, [0.3, 0.3]));
        let found = lines(&frame(&places), direct);
        assert!(found.iter().all(|line| line.pocket != 0), "{found:?}");
    }

    #[test]
    fn banks_and_kicks_have_one_leg_with_a_cushion() {
        let frame = frame(&HANGING);
        let (banks, kicks) = (lines(&frame, banks), lines(&frame, kicks));
        assert!(!banks.is_empty() && !kicks.is_empty());
        assert!(banks.iter().all(|line| line.legs()[1].cushions == 1 && line.slope < 0.0));
        assert!(kicks.iter().all(|line| line.legs()[0].cushions == 1 && line.slope < 0.0));
    }

    #[test]
    fn the_nine_can_be_potted_by_a_combination_through_the_lowest_ball() {
        // The one lies behind the nine, straight to the corner.
        let frame = frame(&[(0, [0.6, 0.6]), (1, [0.4, 0.4]), (9, [0.25, 0.25])]);
        let found = lines(&frame, combinations);
        let nine = found.iter().find(|line| line.object == 9 && line.pocket == 0).unwrap();
        assert_eq!((nine.kind, nine.first, nine.legs().len()), (LineKind::Combination, 1, 3));
    }
}
