//! The edges of a table in plan, in the order of docs/tables.md: rail by rail, counter-clockwise
//! from the left end of the bottom rail; then the straight parts of the liners, their round walls,
//! and the rails' tops. The origin is the centre of the playing area.

use carom::Table;
use carom::math::{Vec2, sqrt};

use super::edge::{EdgeKind, EdgeLine, RailEnd};
use super::figures::{Figures, PocketFigures};
use super::jaw::{JawPlace, JawPlan, jaw};

/// A rail.
#[derive(Clone, Debug)]
pub(crate) struct RailPlan {
    pub(crate) name: &'static str,
    /// Facing, points, nose, points, facing.
    pub(crate) edges: Vec<(EdgeKind, EdgeLine)>,
    /// Its ends at pockets.
    pub(crate) ends: Vec<RailEnd>,
}

/// A pocket.
#[derive(Clone, Debug)]
pub(crate) struct Hole {
    pub(crate) name: &'static str,
    /// Centre and radius of the hole in the slate, m.
    pub(crate) center: Vec2,
    pub(crate) radius: f64,
    /// Unit vector away from the table.
    pub(crate) axis: Vec2,
    /// The tips of the jaws, m.
    pub(crate) mouth: [Vec2; 2],
}

/// All edges of a table.
#[derive(Clone, Debug)]
pub(crate) struct TablePlan {
    /// Half the playing area, m.
    pub(crate) half: Vec2,
    /// Width of the rails, m.
    pub(crate) rail_width: f64,
    /// Height of the noses, m.
    pub(crate) height: f64,
    pub(crate) rails: Vec<RailPlan>,
    pub(crate) pockets: Vec<Hole>,
    /// Whether a ball is captured at the line between the tips.
    pub(crate) has_mouth_lines: bool,
    /// All edges with their rails' names, numbered as in results.
    pub(crate) parts: Vec<(&'static str, EdgeKind, EdgeLine)>,
    /// Dimensions that differ from the published ones.
    pub(crate) unlike: Vec<String>,
}

/// Number and place of the pockets: the signs of x and y; 0 in the middle.
const POCKETS: [(&str, f64, f64); 6] = [
    ("bottom-left", -1.0, -1.0),
    ("bottom-right", 1.0, -1.0),
    ("left", -1.0, 0.0),
    ("right", 1.0, 0.0),
    ("top-left", -1.0, 1.0),
    ("top-right", 1.0, 1.0),
];

/// The rails and the pockets at their ends, counter-clockwise.
const RAILS_BETWEEN_POCKETS: [(&str, [usize; 2]); 6] = [
    ("bottom", [0, 1]),
    ("right-lower", [1, 3]),
    ("right-upper", [3, 5]),
    ("top", [5, 4]),
    ("left-upper", [4, 2]),
    ("left-lower", [2, 0]),
];

impl TablePlan {
    /// The judge's plan of `table`.
    pub(crate) fn of(table: &Table) -> Self {
        Self::new(Figures::of(table).as_ref())
    }

    /// The table with these figures; unbounded cloth without figures.
    pub(crate) fn new(figures: Option<&Figures>) -> Self {
        let Some(figures) = figures else { return Self::unbounded() };
        let mut plan = Self {
            half: Vec2::new(0.5 * figures.width, 0.5 * figures.length),
            rail_width: figures.rail_width,
            height: figures.nose_height,
            has_mouth_lines: figures.has_mouth_lines,
            unlike: figures.unlike.clone(),
            ..Self::unbounded()
        };
        match &figures.pockets {
            None => plan.add_plain_rails(),
            Some(pockets) => plan.add_rails_with_pockets(pockets, figures.cushion_width),
        }
        let tops: Vec<_> = plan.rails.iter().map(|rail| rail.name).collect();
        plan.parts.extend(tops.iter().map(|&name| (name, EdgeKind::Top, EdgeLine::Flat)));
        plan
    }

    fn unbounded() -> Self {
        Self {
            half: Vec2::new(f64::INFINITY, f64::INFINITY),
            rail_width: f64::INFINITY,
            height: 0.0,
            rails: Vec::new(),
            pockets: Vec::new(),
            has_mouth_lines: false,
            parts: Vec::new(),
            unlike: Vec::new(),
        }
    }

    /// Origin of this plan in the frame of shot files, whose origin is the bottom left corner, m.
    pub(crate) fn center(&self) -> Vec2 {
        if self.half.x.is_finite() { self.half } else { Vec2::ZERO }
    }

    fn add_rail(&mut self, rail: RailPlan) {
        self.parts.extend(rail.edges.iter().map(|&(kind, line)| (rail.name, kind, line)));
        self.rails.push(rail);
    }

    fn add_plain_rails(&mut self) {
        let Vec2 { x, y } = self.half;
        let corners = [(-x, -y), (x, -y), (x, y), (-x, y)].map(|(x, y)| Vec2::new(x, y));
        for (k, name) in ["bottom", "right", "top", "left"].into_iter().enumerate() {
            let edges = vec![nose(corners[k], corners[(k + 1) % 4])];
            self.add_rail(RailPlan { name, edges, ends: Vec::new() });
        }
    }

    fn add_rails_with_pockets(&mut self, pockets: &[PocketFigures; 2], cushion_width: f64) {
        let middle = |k: usize| {
            let (_, x, y) = POCKETS[k];
            Vec2::new(x * self.half.x, y * self.half.y)
        };
        let of = |k: usize| if POCKETS[k].2 == 0.0 { &pockets[1] } else { &pockets[0] };
        let mut rails = Vec::new();
        let mut tips: [Vec<Vec2>; 6] = Default::default();
        for (name, [first, last]) in RAILS_BETWEEN_POCKETS {
            let line = middle(last) - middle(first);
            let along = line * (1.0 / line.length());
            let place = |pocket: usize, along: Vec2, behind: Vec2| {
                let at_corner = POCKETS[pocket].2 != 0.0;
                JawPlace { middle: middle(pocket), along, behind, at_corner, pocket }
            };
            let behind = -along.perp();
            let jaws = [
                jaw(of(first), cushion_width, &place(first, along, behind)),
                jaw(of(last), cushion_width, &place(last, -along, behind)),
            ];
            for plan in &jaws {
                tips[plan.end.pocket].push(plan.tip);
            }
            rails.push(rail(name, jaws));
        }
        for (k, (name, x, y)) in POCKETS.into_iter().enumerate() {
            let axis =
                if y == 0.0 { Vec2::new(x, 0.0) } else { Vec2::new(x, y) * (1.0 / sqrt(2.0)) };
            let mouth = [tips[k][0], tips[k][1]];
            let figures = of(k);
            let lip = (mouth[0] + mouth[1]) * 0.5 + axis * figures.shelf;
            let (center, radius) = (lip + axis * figures.hole_radius, figures.hole_radius);
            self.pockets.push(Hole { name, center, radius, axis, mouth });
        }
        for rail in rails {
            self.add_rail(rail);
        }
        if !self.has_mouth_lines {
            self.add_liners();
        }
    }

    fn add_liners(&mut self) {
        let (mut runs, mut walls) = (Vec::new(), Vec::new());
        for rail in &self.rails {
            for end in &rail.ends {
                let Hole { center, radius, axis, .. } = self.pockets[end.pocket];
                let Some(exit) = end.leaves(center, radius) else { continue };
                let run = EdgeLine::Straight { start: end.deep, end: exit, normal: end.normal };
                let from = (exit - center) * (1.0 / radius);
                runs.push((rail.name, EdgeKind::Liner, run));
                let wall = EdgeLine::Wall { center, radius, from, to: axis };
                walls.push((rail.name, EdgeKind::Liner, wall));
            }
        }
        self.parts.extend(runs.into_iter().chain(walls));
    }
}

/// The rail between two jaws.
fn rail(name: &'static str, [first, last]: [JawPlan; 2]) -> RailPlan {
    let mut edges = first.edges;
    edges.reverse();
    edges.push(nose(first.nose_end, last.nose_end));
    edges.extend(last.edges);
    RailPlan { name, edges, ends: vec![first.end, last.end] }
}

/// The straight nose from `start` counter-clockwise to `end`.
fn nose(start: Vec2, end: Vec2) -> (EdgeKind, EdgeLine) {
    let along = end - start;
    let normal = along.perp() * (1.0 / along.length());
    (EdgeKind::Nose, EdgeLine::Straight { start, end, normal })
}
