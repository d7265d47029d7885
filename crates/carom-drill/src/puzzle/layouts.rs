//! The layouts and goals of the themes.

use std::sync::Arc;

use carom::format::{Node, SHOT_FORMAT};
use carom::math::{Vec2, atan2, cos, degrees, sin};
use carom::resolve::cue_ball::Strike;
use carom::{Error, Shot, Simulator, Table};
use carom_plan::{PotLines, pot_aim};

use super::dice::Dice;
use super::task::{Search, Task, Tip};
use super::theme::Theme;
use crate::area::DrillArea;
use crate::goal::{DrillCondition, DrillGoal};
use crate::lanes;
use crate::played::Played;

/// Least distance of the centres of two balls and of a ball from a cushion, m: nothing touches.
const APART: f64 = 0.1;
const FROM_RAIL: f64 = 0.08;

/// Radius of the circle in which the cue ball stops, and its least distance from where the object ball lay, m.
const CIRCLE: f64 = 0.16;
const LEAST_WAY: f64 = 0.35;

/// The gap of two balls that a break-out drives apart, and how far they must lie apart after it, m.
const GAP: f64 = 0.002;
const DRIVEN: f64 = 0.3;

/// How near the balls of straight rail must lie to the cue ball after the point, m.
const GATHERED: f64 = 0.5;

/// Layouts that a number tries until one suits its theme; most numbers find one.
const LAYOUTS: u32 = 60;

/// Places of a second ball that are tried after the end of the first shot.
const PLACES: u32 = 30;

type Places = Vec<(&'static str, Vec2)>;

/// The table and the random numbers of a puzzle.
struct Maker<'a> {
    dice: Dice,
    table: Arc<Table>,
    /// Of a ball, m.
    radius: f64,
    simulator: &'a mut Simulator,
}

/// The puzzle of a number without its solution; none if the balls make no layout of the theme.
pub(super) fn task(
    theme: Theme,
    number: u32,
    simulator: &mut Simulator,
) -> Result<Option<Task>, Error> {
    let is_carom = matches!(theme, Theme::ThreeCushion | Theme::StraightRail | Theme::FourBall);
    let name = if is_carom { "carom-10ft" } else { "wpa-9ft" };
    // A ball of the table's usual size, in the middle of the smallest table.
    let ball = Node::object([("id", "cue".into()), ("position", Node::list([0.6, 1.2]))]);
    let alone = Shot::from_node(&Node::object([
        ("format", SHOT_FORMAT.into()),
        ("table", name.into()),
        ("balls", Node::List(vec![ball])),
    ]))?;
    let (table, radius) = (alone.table().clone(), alone.balls()[0].ball.radius);
    let mut maker = Maker { dice: Dice::of(theme, number), table, radius, simulator };
    for _ in 0..LAYOUTS {
        let found = maker.task(theme)?;
        if found.is_some() {
            return Ok(found);
        }
    }
    Ok(None)
}

impl Maker<'_> {
    fn task(&mut self, theme: Theme) -> Result<Option<Task>, Error> {
        match theme {
            Theme::Pot => self.pot(),
            Theme::Cut => self.cut(),
            Theme::Stun => self.zone(&[-0.15, -0.05], &[1.4, 1.8, 2.3, 3.0], [15.0, 50.0]),
            Theme::Follow => self.zone(&[0.3, 0.45], &[1.1, 1.5, 2.0, 2.6], [3.0, 40.0]),
            Theme::Draw => self.zone(&[-0.5, -0.35], &[1.5, 2.0, 2.6], [3.0, 35.0]),
            Theme::Position => self.position(),
            Theme::Bank => self.bank(),
            Theme::Kick => self.kick(),
            Theme::Combination => self.combination(),
            Theme::Carom => self.carom(),
            Theme::Safety => self.safety(),
            Theme::BreakOut => self.break_out(),
            Theme::ThreeCushion => self.three_cushion(),
            Theme::StraightRail => self.straight_rail(),
            Theme::FourBall => self.four_ball(),
        }
    }

    fn anywhere(&mut self) -> Vec2 {
        let size = self.table.size;
        let within = |dice: &mut Dice, most: f64| dice.between(FROM_RAIL, most - FROM_RAIL);
        Vec2::new(within(&mut self.dice, size.x), within(&mut self.dice, size.y))
    }

    /// Balls anywhere.
    fn scattered(&mut self, ids: &[&'static str]) -> Places {
        ids.iter().map(|id| (*id, self.anywhere())).collect()
    }

    /// A pocket's index and its centre in the file's coordinates, m.
    fn pocket(&mut self) -> (usize, Vec2) {
        let pocket = self.dice.pick(&[0, 1, 2, 3, 4, 5]);
        (pocket, self.table.pockets[pocket].center + self.table.center())
    }

    fn potted(&self, ball: &str, pocket: usize) -> DrillCondition {
        DrillCondition::Pot(ball.into(), Some(self.table.pockets[pocket].name))
    }

    /// The shot with these balls, aimed at the first object ball; none if two of them are nearer than
    /// `least`, m, or one is too near a cushion. Their places are rounded to a centimetre, or to a tenth of a
    /// millimetre if some are close together.
    fn shot(&self, mut places: Places, least: f64) -> Result<Option<Shot>, Error> {
        let steps = if least < APART { 10_000.0 } else { 100.0 };
        for (_, at) in &mut places {
            *at = Vec2::new(rounded(at.x, steps), rounded(at.y, steps));
        }
        let size = self.table.size;
        for (k, (_, at)) in places.iter().enumerate() {
            let to_rail = at.x.min(size.x - at.x).min(at.y).min(size.y - at.y);
            let near = |(_, other): &(&str, Vec2)| (*other - *at).length() < least;
            if to_rail < FROM_RAIL || places[..k].iter().any(near) {
                return Ok(None);
            }
        }
        let ball = |(id, at): &(&str, Vec2)| {
            Node::object([("id", (*id).into()), ("position", Node::list([at.x, at.y]))])
        };
        let way = places[1].1 - places[0].1;
        let azimuth = degrees(atan2(way.y, way.x));
        let strike = Node::object([
            ("ball", "cue".into()),
            ("speed", 1.6.into()),
            ("azimuth_deg", rounded(azimuth, 10.0).into()),
        ]);
        let table = self.table.name.clone().unwrap_or_default();
        Shot::from_node(&Node::object([
            ("format", SHOT_FORMAT.into()),
            ("table", table.into()),
            ("balls", Node::list(places.iter().map(ball))),
            ("strike", strike),
        ]))
        .map(Some)
    }

    fn pot(&mut self) -> Result<Option<Task>, Error> {
        let places = self.scattered(&["cue", "9", "2", "3", "5", "6"]);
        let Some(shot) = self.shot(places, APART)? else { return Ok(None) };
        let goal = DrillGoal::one(vec![DrillCondition::Pot("9".into(), None)]);
        let tips = Tip::grid(&[1.6, 2.4], &[0.0], &[0.0, -0.3, 0.3]);
        let pockets = (0..6).collect();
        let search = Search::Pot { ball: 1, pockets, tips, is_about_cue_ball: false };
        Ok(Some(Task { shot, goal, search }))
    }

    fn cut(&mut self) -> Result<Option<Task>, Error> {
        let (pocket, hole) = self.pocket();
        let places = self.scattered(&["cue", "9"]);
        if !has_cut(&places, hole, [40.0, 72.0]) {
            return Ok(None);
        }
        let Some(shot) = self.shot(places, APART)? else { return Ok(None) };
        let goal = DrillGoal::one(vec![self.potted("9", pocket)]);
        let tips = Tip::grid(&[1.6, 2.2, 3.0], &[0.0], &[0.0, -0.3, 0.3]);
        let search = Search::Pot { ball: 1, pockets: vec![pocket], tips, is_about_cue_ball: false };
        Ok(Some(Task { shot, goal, search }))
    }

    /// A pot with one of the heights and speeds, and a circle where the cue ball stops after it.
    fn zone(
        &mut self,
        heights: &[f64],
        speeds: &[f64],
        cuts: [f64; 2],
    ) -> Result<Option<Task>, Error> {
        let (pocket, hole) = self.pocket();
        let places = self.scattered(&["cue", "9", "5"]);
        if !has_cut(&places, hole, cuts) {
            return Ok(None);
        }
        let nine = places[1].1;
        let Some(shot) = self.shot(places, APART)? else { return Ok(None) };
        let (height, speed) = (self.dice.pick(heights), self.dice.pick(speeds));
        let side = self.dice.pick(&[0.0, 0.0, -0.3, 0.3]);
        let Some([x, y]) = self.end_of_pot(&shot, pocket, Tip { speed, side, height })? else {
            return Ok(None);
        };
        let center = Vec2::new(rounded(x, 100.0), rounded(y, 100.0));
        if (center - nine).length() < LEAST_WAY {
            return Ok(None);
        }
        let circle = DrillArea::Disc([center.x, center.y], CIRCLE);
        let goal =
            DrillGoal::one(vec![self.potted("9", pocket), DrillCondition::Stop(None, circle)]);
        let speeds = [0.85, 0.93, 1.0, 1.08, 1.17].map(|share| share * speed);
        let heights = [-0.12, 0.0, 0.12].map(|more| height + more);
        let mut tips = Tip::grid(&speeds, &[-0.3, 0.0, 0.3], &heights);
        tips.insert(0, Tip { speed, side, height });
        let search = Search::Pot { ball: 1, pockets: vec![pocket], tips, is_about_cue_ball: true };
        Ok(Some(Task { shot, goal, search }))
    }

    /// Where the cue ball stops after ball 1 was potted with a tip; none without such a pot.
    fn end_of_pot(
        &mut self,
        shot: &Shot,
        pocket: usize,
        tip: Tip,
    ) -> Result<Option<[f64; 2]>, Error> {
        let azimuth = shot.strike().map_or(0.0, |(_, strike)| strike.azimuth);
        let Tip { speed, side, height } = tip;
        let strike = Strike { speed, azimuth, elevation: 0.0, side, height };
        let Ok(aimed) = shot.with_default_elevation(&strike) else { return Ok(None) };
        let Some(aim) = pot_aim(&aimed, 1, pocket, PotLines::All)? else { return Ok(None) };
        if aim.loses_cue_ball || aim.route.kind() != "direct" {
            return Ok(None);
        }
        Ok(Some(Played::of(self.simulator, &aimed, Some(&aim.strike))?.places[0]))
    }

    /// A pot after which another ball can be potted: it is placed so that one tip leaves a shot at it.
    fn position(&mut self) -> Result<Option<Task>, Error> {
        let (pocket, hole) = self.pocket();
        let mut places = self.scattered(&["cue", "1", "5", "7"]);
        if !has_cut(&places, hole, [0.0, 55.0]) {
            return Ok(None);
        }
        let Some(shot) = self.shot(places.clone(), APART)? else { return Ok(None) };
        let tip = Tip {
            speed: self.dice.pick(&[1.2, 1.6, 2.1, 2.7]),
            side: self.dice.pick(&[0.0, 0.35, -0.35]),
            height: self.dice.pick(&[-0.45, -0.2, 0.3]),
        };
        let Some(end) = self.end_of_pot(&shot, pocket, tip)? else { return Ok(None) };
        let Some(two) = self.next_to(&places, end) else { return Ok(None) };
        places.insert(2, ("2", two));
        let Some(shot) = self.shot(places, APART)? else { return Ok(None) };
        let goal = DrillGoal::one(vec![self.potted("1", pocket), DrillCondition::Next("2".into())]);
        let mut tips =
            Tip::grid(&[1.2, 1.6, 2.1, 2.7], &[0.0, -0.35, 0.35], &[-0.45, -0.2, 0.0, 0.3]);
        tips.insert(0, tip);
        let search = Search::Pot { ball: 1, pockets: vec![pocket], tips, is_about_cue_ball: true };
        Ok(Some(Task { shot, goal, search }))
    }

    /// A place of a ball that can be potted from `end`, but not from where the cue ball lies now; none if none
    /// was found. The first object ball is gone by then.
    fn next_to(&mut self, places: &Places, end: [f64; 2]) -> Option<Vec2> {
        (0..PLACES).find_map(|_| {
            let two = self.anywhere();
            let can_pot = |cue: [f64; 2]| {
                let others = places[2..].iter().map(|(_, at)| [at.x, at.y]);
                let all = [cue, [two.x, two.y]].into_iter().chain(others).collect::<Vec<_>>();
                lanes::can_pot_from(&self.table, self.radius, &all)
            };
            (can_pot(end) && !can_pot([places[0].1.x, places[0].1.y])).then_some(two)
        })
    }

    fn bank(&mut self) -> Result<Option<Task>, Error> {
        let (pocket, _) = self.pocket();
        let places = self.scattered(&["cue", "9", "5"]);
        let Some(shot) = self.shot(places, APART)? else { return Ok(None) };
        let goal =
            DrillGoal::one(vec![self.potted("9", pocket), DrillCondition::Cushions("9".into(), 1)]);
        let tips = Tip::grid(&[1.6, 2.2, 3.0], &[0.0, -0.2, 0.2], &[0.0]);
        let search = Search::Pot { ball: 1, pockets: vec![pocket], tips, is_about_cue_ball: false };
        Ok(Some(Task { shot, goal, search }))
    }

    fn kick(&mut self) -> Result<Option<Task>, Error> {
        let mut places = self.scattered(&["cue", "9"]);
        let (cue, nine) = (places[0].1, places[1].1);
        let way = nine - cue;
        let aside = self.dice.between(-0.02, 0.02);
        let share = self.dice.between(0.3, 0.7);
        places.push(("5", cue + way * share + way.perp() * (aside / way.length())));
        places.extend(self.scattered(&["7", "3", "4"]));
        let Some(shot) = self.shot(places, APART)? else { return Ok(None) };
        if !is_hidden(&shot) {
            return Ok(None);
        }
        let cushions = self.dice.pick(&[1, 2]);
        let goal =
            DrillGoal::one(vec![DrillCondition::Kick(cushions), DrillCondition::First("9".into())]);
        let search = Search::Around {
            tips: Tip::grid(&[1.6, 2.4], &[0.0, -0.35, 0.35], &[0.0]),
            directions: 720,
        };
        Ok(Some(Task { shot, goal, search }))
    }

    /// The 9 near a pocket, the 1 behind it, and the cue ball behind both, nearly in a row.
    fn combination(&mut self) -> Result<Option<Task>, Error> {
        let (pocket, hole) = self.pocket();
        let nine = self.near(hole, [0.15, 0.8]);
        let one = self.behind(nine, hole, [0.13, 0.4], 0.05);
        let cue = self.behind(one, nine, [0.3, 1.0], 0.25);
        let Some(shot) = self.shot(vec![("cue", cue), ("1", one), ("9", nine)], APART)? else {
            return Ok(None);
        };
        let first = DrillCondition::First("1".into());
        let goal = DrillGoal::one(vec![first, self.potted("9", pocket)]);
        let tips = Tip::grid(&[1.6, 2.2, 3.0], &[0.0], &[0.0]);
        let search = Search::Pot { ball: 2, pockets: vec![pocket], tips, is_about_cue_ball: false };
        Ok(Some(Task { shot, goal, search }))
    }

    fn near(&mut self, to: Vec2, [least, most]: [f64; 2]) -> Vec2 {
        let angle = self.dice.between(0.0, core::f64::consts::TAU);
        let distance = self.dice.between(least, most);
        to + Vec2::new(cos(angle), sin(angle)) * distance
    }

    /// A place beyond `ball` as seen from `target`.
    fn behind(&mut self, ball: Vec2, target: Vec2, [least, most]: [f64; 2], aside: f64) -> Vec2 {
        let line = ball - target;
        let line = line * (1.0 / line.length());
        let distance = self.dice.between(least, most);
        let aside = self.dice.between(-aside, aside);
        ball + line * distance + line.perp() * aside
    }

    /// The cue ball goes off the 1 to the 9, which lies near a pocket.
    fn carom(&mut self) -> Result<Option<Task>, Error> {
        let (pocket, hole) = self.pocket();
        let nine = self.near(hole, [0.13, 0.3]);
        let places = vec![("cue", self.anywhere()), ("1", self.anywhere()), ("9", nine)];
        let Some(shot) = self.shot(places, APART)? else { return Ok(None) };
        let goal = DrillGoal::one(vec![
            DrillCondition::First("1".into()),
            DrillCondition::Touch(vec!["1".into(), "9".into()]),
            self.potted("9", pocket),
        ]);
        let tips = Tip::grid(&[1.3, 1.9, 2.6], &[0.0], &[-0.35, 0.0, 0.35]);
        Ok(Some(Task { shot, goal, search: Search::Aims { balls: vec![1], tips, aims: 121 } }))
    }

    fn safety(&mut self) -> Result<Option<Task>, Error> {
        let places = self.scattered(&["cue", "9", "4", "6", "7"]);
        let Some(shot) = self.shot(places, APART)? else { return Ok(None) };
        if is_hidden(&shot) {
            return Ok(None);
        }
        let nine = || "9".into();
        let goal =
            DrillGoal::one(vec![DrillCondition::First(nine()), DrillCondition::Hidden(nine())]);
        let tips = Tip::grid(&[0.6, 0.8, 1.1, 1.5, 2.0], &[0.0], &[-0.35, 0.0, 0.3]);
        Ok(Some(Task { shot, goal, search: Search::Aims { balls: vec![1], tips, aims: 61 } }))
    }

    /// A pot after which the cue ball drives two balls apart: one of them lies where a softer shot ends.
    fn break_out(&mut self) -> Result<Option<Task>, Error> {
        let (pocket, hole) = self.pocket();
        let mut places = self.scattered(&["cue", "1"]);
        if !has_cut(&places, hole, [5.0, 55.0]) {
            return Ok(None);
        }
        let Some(shot) = self.shot(places.clone(), APART)? else { return Ok(None) };
        let tip = Tip {
            speed: self.dice.pick(&[1.2, 1.5, 1.9]),
            side: self.dice.pick(&[0.0, 0.35, -0.35]),
            height: self.dice.pick(&[-0.45, -0.2, 0.3]),
        };
        let Some([x, y]) = self.end_of_pot(&shot, pocket, tip)? else { return Ok(None) };
        let angle = self.dice.between(0.0, core::f64::consts::TAU);
        let two = 2.0 * self.radius + GAP;
        places.push(("4", Vec2::new(x, y)));
        places.push(("6", Vec2::new(x, y) + Vec2::new(cos(angle), sin(angle)) * two));
        let Some(shot) = self.shot(places, two - 0.5 * GAP)? else { return Ok(None) };
        let pair = ["4".into(), "6".into()];
        let goal =
            DrillGoal::one(vec![self.potted("1", pocket), DrillCondition::Apart(pair, DRIVEN)]);
        let mut tips =
            Tip::grid(&[1.6, 2.1, 2.7, 3.4], &[0.0, -0.35, 0.35], &[-0.45, -0.2, 0.0, 0.3]);
        tips.insert(0, tip);
        let search = Search::Pot { ball: 1, pockets: vec![pocket], tips, is_about_cue_ball: true };
        Ok(Some(Task { shot, goal, search }))
    }

    fn three_cushion(&mut self) -> Result<Option<Task>, Error> {
        let places = self.scattered(&["cue", "red", "yellow"]);
        let Some(shot) = self.shot(places, APART)? else { return Ok(None) };
        let goal = DrillGoal::one(vec![DrillCondition::Carom(3)]);
        let search = Search::Around {
            tips: Tip::grid(&[2.6, 3.6], &[-0.4, 0.0, 0.4], &[0.0]),
            directions: 720,
        };
        Ok(Some(Task { shot, goal, search }))
    }

    fn straight_rail(&mut self) -> Result<Option<Task>, Error> {
        let red = self.anywhere();
        let places = vec![
            ("cue", self.near(red, [0.15, 0.7])),
            ("red", red),
            ("yellow", self.near(red, [0.15, 0.7])),
        ];
        let Some(shot) = self.shot(places, APART)? else { return Ok(None) };
        let goal = DrillGoal::one(vec![DrillCondition::Carom(0), DrillCondition::Gather(GATHERED)]);
        let tips = Tip::grid(&[0.7, 1.0, 1.4, 1.9, 2.6], &[0.0], &[-0.4, 0.0, 0.4]);
        Ok(Some(Task { shot, goal, search: Search::Aims { balls: vec![1, 2], tips, aims: 61 } }))
    }

    fn four_ball(&mut self) -> Result<Option<Task>, Error> {
        let places = self.scattered(&["cue", "red-1", "red-2", "yellow"]);
        let Some(shot) = self.shot(places, APART)? else { return Ok(None) };
        let reds = vec!["red-1".into(), "red-2".into()];
        let goal = DrillGoal::one(vec![
            DrillCondition::Touch(reds),
            DrillCondition::Avoid("yellow".into()),
        ]);
        let tips = Tip::grid(&[1.6, 2.4, 3.2], &[-0.3, 0.0, 0.3], &[-0.35, 0.0, 0.35]);
        Ok(Some(Task { shot, goal, search: Search::Aims { balls: vec![1, 2], tips, aims: 81 } }))
    }
}

/// A number rounded to one of `steps` per unit.
fn rounded(x: f64, steps: f64) -> f64 {
    (steps * x + 0.5).floor() / steps
}

/// Whether the cut of the first object ball into a hole lies between two angles, degrees.
fn has_cut(places: &Places, hole: Vec2, [least, most]: [f64; 2]) -> bool {
    let (to_ball, to_hole) = (places[1].1 - places[0].1, hole - places[1].1);
    let cut = degrees(atan2(to_ball.cross(to_hole).abs(), to_ball.dot(to_hole)));
    (least..=most).contains(&cut)
}

/// Whether the first object ball is hidden from the cue ball before the shot.
fn is_hidden(shot: &Shot) -> bool {
    let place = |ball: &carom::shot::PlacedBall| {
        let [x, y, _] = ball.state.position.to_array();
        [x, y]
    };
    let places = shot.balls().iter().map(place).collect();
    let rest = Played { outcome: carom::Outcome::default(), noses: Vec::new(), places };
    lanes::is_hidden(shot, &rest, 0, 1)
}
