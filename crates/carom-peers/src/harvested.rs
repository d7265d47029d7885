//! Impacts and paths of random shots, as inputs for [`crate::kinds`].

use std::sync::Arc;

use carom::detect::ball_table::{self, keeps_clear};
use carom::detect::flight;
use carom::event::{Event, EventKind, Recorder};
use carom::math::Vec3;
use carom::motion::Path;
use carom::resolve::Body;
use carom::table::Part;
use carom::table::TableFeature;
use carom::{Ball, BallState, MotionState, Physics, Shot, Table};
use carom_check::random_shots::{ShotFamily, shot_file};
use carom_roots::Motion;

/// The families that together contain every kind.
const FAMILIES: [ShotFamily; 8] = [
    ShotFamily::Pot,
    ShotFamily::EightBallBreak,
    ShotFamily::Elevated,
    ShotFamily::Flying,
    ShotFamily::Jump,
    ShotFamily::Jaws,
    ShotFamily::Mouths,
    ShotFamily::Frozen,
];

/// Shots per family at most. A kind that is still short of inputs then has fewer.
const MOST_SHOTS: u64 = 400;

/// A path and the shot on whose table it runs.
#[derive(Clone, Debug)]
pub struct TablePath {
    shot: Arc<Shot>,
    /// The path.
    pub path: Path,
}

impl TablePath {
    /// Its table.
    pub fn table(&self) -> &Table {
        self.shot.table()
    }

    /// The path seen from above.
    pub fn in_plan(&self) -> Motion<2> {
        let Path { position: p, velocity: v, half_acceleration: h, .. } = &self.path;
        Motion { d: [p.x, p.y], v: [v.x, v.y], h: [h.x, h.y] }
    }

    /// The path in space.
    pub fn in_space(&self) -> Motion<3> {
        let Path { position: p, velocity: v, half_acceleration: h, .. } = &self.path;
        Motion { d: p.to_array(), v: v.to_array(), h: h.to_array() }
    }
}

/// A state in which a path starts.
#[derive(Clone, Debug)]
pub struct Start {
    /// The state.
    pub state: BallState,
    /// The ball.
    pub ball: Ball,
    /// The physics of its shot.
    pub physics: Arc<Physics>,
}

/// Inputs by kind, each list of at most the wanted length.
#[derive(Clone, Debug, Default)]
pub struct Harvest {
    wanted: usize,
    /// Impacts of two balls: the normal, and both balls.
    pub pairs: Vec<(Vec3, Body, Body)>,
    /// Impacts of balls on the cloth with cushions: the normal in space, and the ball.
    pub rails: Vec<(Vec3, Body)>,
    /// Bounces on the slate.
    pub bounces: Vec<Body>,
    /// States after events.
    pub starts: Vec<Start>,
    /// Paths on the cloth that are proved to stay clear of the rails.
    pub clear: Vec<TablePath>,
    /// Paths on the cloth that meet nothing, without that proof.
    pub nothing: Vec<TablePath>,
    /// Paths on the cloth to a straight nose.
    pub nose: Vec<TablePath>,
    /// Paths on the cloth to a point or a facing.
    pub jaw: Vec<TablePath>,
    /// Paths on the cloth into a pocket.
    pub pocket: Vec<TablePath>,
    /// Flights to the slate that stay far from the rails.
    pub slate: Vec<TablePath>,
    /// Flights to the slate near the rails.
    pub slate_near_rails: Vec<TablePath>,
    /// Flights to a part of a cushion.
    pub flight_cushion: Vec<TablePath>,
    /// Flights to the lip of a hole, or down in it.
    pub flight_hole: Vec<TablePath>,
    /// Flights over the border.
    pub flight_edge: Vec<TablePath>,
    /// Paths on a rail's top.
    pub rail_top: Vec<TablePath>,
}

impl Harvest {
    /// At most `wanted` inputs of each kind, from shots that are the same in each run.
    pub fn of_random_shots(wanted: usize) -> Self {
        let mut harvest = Self { wanted, ..Self::default() };
        for seed in 0..MOST_SHOTS {
            for family in FAMILIES {
                let Ok(shot) = Shot::from_json(&shot_file(family, seed)) else { continue };
                let shot = Arc::new(shot);
                let mut recorder = HarvestRecorder { harvest: &mut harvest, shot: &shot };
                // A shot that is stopped has given its inputs.
                let _ = carom::simulate(&shot, &mut recorder);
            }
        }
        harvest
    }

    fn take_path(&mut self, path: TablePath) {
        let (table, radius) = (path.table(), path.path.radius);
        let list = if path.path.motion == MotionState::Airborne {
            let motion = path.in_space();
            match flight::first_meeting(table, radius, &motion, path.path.duration) {
                Some((t, TableFeature::Slate)) => {
                    let half = table.size * 0.5;
                    let far = [0.0, t].map(|t| motion.at(t)).iter().all(|p| {
                        p[0].abs() < half.x - 3.0 * radius && p[1].abs() < half.y - 3.0 * radius
                    });
                    if far { &mut self.slate } else { &mut self.slate_near_rails }
                }
                Some((_, TableFeature::Cushion(_))) => &mut self.flight_cushion,
                Some((_, TableFeature::Lip(_) | TableFeature::Depth(_))) => &mut self.flight_hole,
                Some((_, TableFeature::Border)) => &mut self.flight_edge,
                _ => return,
            }
        } else if path.path.position.z != radius {
            &mut self.rail_top
        } else {
            let motion = path.in_plan();
            let found = ball_table::first_meeting(table, radius, &motion, path.path.duration);
            match found {
                None if keeps_clear(table, table.reach(radius), &motion, path.path.duration) => {
                    &mut self.clear
                }
                None => &mut self.nothing,
                Some((_, TableFeature::Cushion(k))) => match table.cushions[usize::from(k)].part {
                    Part::Nose => &mut self.nose,
                    _ => &mut self.jaw,
                },
                Some(_) => &mut self.pocket,
            }
        };
        if list.len() < self.wanted {
            list.push(path);
        }
    }

    fn take_start(&mut self, start: Start) {
        let same = self.starts.iter().filter(|s| s.state.motion == start.state.motion).count();
        if same < self.wanted {
            self.starts.push(start);
        }
    }
}

/// Takes the impacts and paths of a shot.
struct HarvestRecorder<'a> {
    harvest: &'a mut Harvest,
    shot: &'a Arc<Shot>,
}

impl Recorder for HarvestRecorder<'_> {
    fn record(&mut self, event: &Event<'_>) {
        let Self { harvest, shot } = self;
        let ball = |k: usize| shot.balls()[usize::from(event.balls[k])].ball;
        let body = |k: usize| Body::new(&ball(k), &event.before[k]);
        match (event.kind, event.before) {
            (EventKind::BallCollision, [a, b]) if harvest.pairs.len() < harvest.wanted => {
                let apart = b.position - a.position;
                let normal = apart * (1.0 / apart.length());
                harvest.pairs.push((normal, body(0), body(1)));
            }
            (EventKind::RailCollision(k), [s])
                if s.position.z == ball(0).radius && harvest.rails.len() < harvest.wanted =>
            {
                let feature = TableFeature::Cushion(k);
                let normal = shot.table().contact_normal(feature, s.position, ball(0).radius);
                harvest.rails.push((normal, body(0)));
            }
            (EventKind::SlateCollision, [_]) if harvest.bounces.len() < harvest.wanted => {
                harvest.bounces.push(body(0));
            }
            _ => {}
        }
        for (k, after) in event.after.iter().enumerate() {
            let physics = shot.physics();
            let path = Path::new(after, &ball(k), &physics.cloth, physics.gravity);
            harvest.take_start(Start {
                state: *after,
                ball: ball(k),
                physics: Arc::clone(physics),
            });
            if path.moves() {
                harvest.take_path(TablePath { shot: Arc::clone(shot), path });
            }
        }
    }
}
