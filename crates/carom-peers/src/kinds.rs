//! Every kind of impact and search of the engine, each with inputs, so that the operations of one
//! can be counted.
//!
//! Most inputs are harvested from random shots: the balls of impacts as the event loop hands them
//! to the models, and the paths that it searches. All models of one impact get the same inputs. The
//! networks, and the contacts that are rare, have inputs made for them. `black_box` hides every input
//! and law from the compiler, so that it cannot compute a part once for all inputs.
//!
//! `benches/operation_kinds.py` runs every kind under valgrind's callgrind and counts the additions,
//! subtractions, multiplications, divisions and square roots of the compiled program.

use std::hint::black_box;

use carom::detect::ball_table;
use carom::detect::{flight, rail_top};
use carom::math::{Vec2, Vec3};
use carom::motion::Path;
use carom::physics::{BallBall, BallBallModel, Cushion, CushionModel};
use carom::resolve::cue_ball::{self, Strike};
use carom::resolve::network::{
    self, NetworkImpact, NetworkScratch, Touch, WallTouch, stiffness_of_time,
};
use carom::resolve::{Body, ball_ball, ball_cushion, ball_edge, ball_slate};
use carom::{Ball, MotionState, Physics};
use carom_roots::{Row, first_contact};

use crate::families::{Case, uniform_pair};
use crate::finder::Finder;
use crate::flight_families::FlightFamily;
use crate::harvest::{break_pairs, pot_pairs};
use crate::harvested::{Harvest, TablePath};
use crate::random::{Random, RandomMotion};

/// Inputs per kind.
pub const INPUTS: usize = 240;

/// A kind of impact or search, with its inputs.
pub struct Kind {
    /// What it belongs to, such as `ball and ball`.
    pub group: &'static str,
    /// Its name within the group.
    pub name: String,
    /// Number of inputs.
    pub inputs: usize,
    job: Box<dyn Fn()>,
}

impl Kind {
    fn over<T: 'static>(
        group: &'static str,
        name: &str,
        inputs: Vec<T>,
        one: impl Fn(&T) + 'static,
    ) -> Self {
        let count = inputs.len();
        let job = Box::new(move || inputs.iter().for_each(&one));
        Self { group, name: name.to_owned(), inputs: count, job }
    }

    /// Does every input once.
    // callgrind counts within this function only.
    #[inline(never)]
    pub fn counted_pass(&self) {
        (self.job)();
    }
}

/// All kinds.
pub fn all() -> Vec<Kind> {
    let harvest = Harvest::of_random_shots(INPUTS);
    let mut kinds = pairs_of_balls();
    kinds.extend(searches(&harvest));
    kinds.extend(paths(&harvest));
    kinds.extend(ball_impacts(&harvest));
    kinds.extend(table_impacts(&harvest));
    kinds.extend(networks());
    kinds.extend(strikes());
    kinds.retain(|kind| kind.inputs > 0);
    kinds
}

/// Searches for the contact of two balls.
fn pairs_of_balls() -> Vec<Kind> {
    let group = "search: two balls";
    let random = || Random::new(7);
    let mut draw = random();
    let rows: Vec<Row<4>> = (0..INPUTS).map(|_| row(&mut draw)).collect();
    let mut kinds = vec![Kind::over(group, "proofs for a row of four pairs", rows, |row| {
        black_box(black_box(row).open());
    })];
    for (name, pairs) in
        [("mid-game", pot_pairs(1, INPUTS)), ("eight-ball break", break_pairs(1, INPUTS))]
    {
        for finder in [Finder::Carom, Finder::Ferrari, Finder::Companion, Finder::Algorithm1010] {
            let label = format!("{}, {name}", finder.name());
            kinds.push(Kind::over(group, &label, pairs.clone(), move |case| {
                let Case { motion, distance, horizon, .. } = black_box(case);
                black_box(finder.first_contact(motion, *distance, *horizon));
            }));
        }
    }
    let mut draw = random();
    let flights: Vec<Case<3>> =
        (0..INPUTS).map(|_| FlightFamily::Aimed.sample(&mut draw)).collect();
    kinds.push(Kind::over(group, "carom-roots, one of them in the air", flights, |case| {
        let Case { motion, distance, horizon, .. } = black_box(case);
        black_box(first_contact(motion, *distance, *horizon));
    }));
    kinds
}

/// Four random pairs on a table.
fn row(random: &mut Random) -> Row<4> {
    let pairs: [Case; 4] = std::array::from_fn(|_| uniform_pair(random));
    let each = |value: fn(&Case) -> f64| std::array::from_fn(|k| value(&pairs[k]));
    Row {
        dx: each(|c| c.motion.d[0]),
        dy: each(|c| c.motion.d[1]),
        vx: each(|c| c.motion.v[0]),
        vy: each(|c| c.motion.v[1]),
        hx: each(|c| c.motion.h[0]),
        hy: each(|c| c.motion.h[1]),
        distance: each(|c| c.distance),
        horizon: each(|c| c.horizon),
    }
}

/// Searches for what a ball meets on the table, by what it meets.
fn searches(harvest: &Harvest) -> Vec<Kind> {
    let on_cloth = |name: &str, paths: &[TablePath]| {
        Kind::over("search: ball on the cloth and table", name, paths.to_vec(), |p| {
            let p = black_box(p);
            let path = p.in_plan();
            black_box(ball_table::first_meeting(p.table(), p.path.radius, &path, p.path.duration));
        })
    };
    let in_flight = |name: &str, paths: &[TablePath]| {
        Kind::over("search: ball in the air and table", name, paths.to_vec(), |p| {
            let p = black_box(p);
            let path = p.in_space();
            black_box(flight::first_meeting(p.table(), p.path.radius, &path, p.path.duration));
        })
    };
    vec![
        on_cloth("proof that it stays clear", &harvest.clear),
        on_cloth("no contact, without this proof", &harvest.nothing),
        on_cloth("straight nose", &harvest.nose),
        on_cloth("jaw: point or facing", &harvest.jaw),
        on_cloth("pocket: lip or mouth line", &harvest.pocket),
        in_flight("slate, far from the rails", &harvest.slate),
        in_flight("slate, near the rails", &harvest.slate_near_rails),
        in_flight("cushion: nose, point, facing, liner or top", &harvest.flight_cushion),
        in_flight("lip of a hole, or its depth", &harvest.flight_hole),
        in_flight("border of the rails", &harvest.flight_edge),
        Kind::over(
            "search: ball on a rail's top",
            "edge of the top",
            harvest.rail_top.clone(),
            |p| {
                let p = black_box(p);
                let path = p.in_plan();
                black_box(rail_top::first_loss_of_support(p.table(), &path, p.path.duration));
            },
        ),
    ]
}

/// New paths, advances and transitions.
fn paths(harvest: &Harvest) -> Vec<Kind> {
    let group = "motion";
    let mut kinds = Vec::new();
    for motion in
        [MotionState::Sliding, MotionState::Rolling, MotionState::Spinning, MotionState::Airborne]
    {
        let starts: Vec<_> =
            harvest.starts.iter().filter(|s| s.state.motion == motion).cloned().collect();
        let label = |what: &str| format!("{what}: {}", motion.name());
        kinds.push(Kind::over(group, &label("path from a state"), starts.clone(), |s| {
            let s = black_box(s);
            black_box(Path::new(&s.state, &s.ball, &s.physics.cloth, s.physics.gravity));
        }));
        let paths: Vec<(Path, f64)> = starts
            .iter()
            .map(|s| Path::new(&s.state, &s.ball, &s.physics.cloth, s.physics.gravity))
            .map(|p| (p, if p.duration.is_finite() { 0.4 * p.duration } else { 0.1 }))
            .collect();
        kinds.push(Kind::over(group, &label("advance to a time"), paths, |(path, t)| {
            black_box(black_box(path).at(*t));
        }));
        if motion == MotionState::Airborne {
            continue; // A flight ends by a contact.
        }
        kinds.push(Kind::over(group, &label("transition"), starts, |s| {
            let s = black_box(s);
            let (cloth, gravity) = (&s.physics.cloth, s.physics.gravity);
            let path = Path::new(&s.state, &s.ball, cloth, gravity);
            black_box(path.at(path.duration));
            black_box(Path::new(&path.successor(), &s.ball, cloth, gravity));
        }));
    }
    kinds
}

/// Impacts of two balls, by model.
fn ball_impacts(harvest: &Harvest) -> Vec<Kind> {
    let pool = Physics::pool();
    let mut kinds: Vec<Kind> = BallBallModel::ALL
        .into_iter()
        .map(|model| {
            let name = model.name();
            let (law, cloth) = (BallBall { model, ..pool.ball_ball }, pool.cloth);
            Kind::over("impact: ball and ball", name, harvest.pairs.clone(), move |(n, a, b)| {
                let (mut a, mut b) = (*black_box(a), *black_box(b));
                ball_ball::resolve(black_box(&law), black_box(&cloth), *n, &mut a, &mut b);
                black_box((a, b));
            })
        })
        .collect();
    let e = pool.ball_ball.restitution;
    let dropped = dropped_balls(pool.ball);
    kinds.push(Kind::over("impact: ball and ball", "held by the slate", dropped, move |b| {
        let [(normal, mut flyer), (_, mut held)] = *black_box(b);
        ball_ball::held::resolve(black_box(e), normal, &mut flyer, &mut held);
        black_box((flyer, held));
    }));
    kinds
}

/// A ball that comes down on another, and that other; each with the normal.
fn dropped_balls(ball: Ball) -> Vec<[(Vec3, Body); 2]> {
    let mut random = Random::new(11);
    (0..INPUTS)
        .map(|_| {
            let [x, y] = random.direction();
            let lean = random.between(0.05, 0.9);
            let normal = Vec3::new(lean * x, lean * y, -(1.0 - lean * lean).sqrt());
            let velocity = Vec3::new(0.1 * y, 0.1 * x, -random.between(0.01, 0.5));
            let flyer = body(ball, velocity, Vec3::new(5.0, -3.0, 8.0));
            [(normal, flyer), (normal, body(ball, Vec3::ZERO, Vec3::ZERO))]
        })
        .collect()
}

fn body(ball: Ball, velocity: Vec3, angular_velocity: Vec3) -> Body {
    Body { velocity, angular_velocity, mass: ball.mass, radius: ball.radius }
}

/// Impacts on the table: cushions by model, slate, edges of pockets and tops.
fn table_impacts(harvest: &Harvest) -> Vec<Kind> {
    let pool = Physics::pool();
    let mut kinds: Vec<Kind> = CushionModel::ALL
        .into_iter()
        .map(|model| {
            let name = model.name();
            let (law, cloth) = (Cushion { model, ..pool.cushion }, pool.cloth);
            let balls = harvest.rails.clone();
            Kind::over("impact: ball and cushion", name, balls, move |(normal, ball)| {
                let mut ball = *black_box(ball);
                ball_cushion::resolve(black_box(&law), black_box(&cloth), *normal, true, &mut ball);
                black_box(ball);
            })
        })
        .collect();
    let (slate, facing, gravity) = (pool.slate, pool.facing, pool.gravity);
    kinds.push(Kind::over("impact: ball and slate", "bounce", harvest.bounces.clone(), move |b| {
        let mut ball = *black_box(b);
        ball_slate::bounce(black_box(&slate), &mut ball);
        black_box(ball);
    }));
    kinds.push(Kind::over(
        "impact: ball and slate",
        "lying ball after another impact",
        harvest.bounces.iter().zip(0..).map(|(ball, k)| lying(ball, k)).collect(),
        move |b| {
            let mut ball = *black_box(b);
            ball_slate::settle(black_box(&slate), black_box(gravity), &mut ball);
            black_box(ball);
        },
    ));
    kinds.push(Kind::over(
        "impact: ball and edge",
        "lip of a pocket",
        on_lips(pool.ball),
        move |(edge, ball)| {
            let mut ball = *black_box(ball);
            ball_edge::resolve(black_box(&facing), black_box(gravity), edge, &mut ball);
            black_box(ball);
        },
    ));
    kinds
}

/// A ball on the slate that an impact has just driven down or lifted: some bounce, some hop, most
/// stay down.
fn lying(ball: &Body, k: usize) -> Body {
    let up = 0.01 * (k % 12) as f64 - 0.08;
    Body { velocity: Vec3::new(ball.velocity.x, ball.velocity.y, up), ..*ball }
}

/// Balls on the lip of a corner pocket with a radius of 57 mm, rolling or sliding over it.
fn on_lips(ball: Ball) -> Vec<(ball_edge::Edge, Body)> {
    let mut random = Random::new(13);
    (0..INPUTS)
        .map(|_| {
            let [x, y] = random.direction();
            let tilt = random.between(0.0, 0.8);
            let (sin, cos) = tilt.sin_cos();
            let edge = ball_edge::Edge {
                normal: Vec3::new(sin * x, sin * y, -cos),
                along: Vec2::new(-y, x),
                bend: 1.0 / 0.057,
                turn: 1.0 / ball.radius,
            };
            let speed = random.between(0.01, 0.5);
            let velocity = Vec3::new(-x * speed, -y * speed, -0.1 * speed);
            let spin = Vec3::new(y * speed, -x * speed, 0.0) * (1.0 / ball.radius);
            (edge, body(ball, velocity, spin))
        })
        .collect()
}

/// Numbers of balls in the frozen racks that the cue ball hits: rows of a triangle.
const RACKS: [usize; 4] = [3, 6, 10, 15];

/// Networks by number of balls: a ball hits a row of two, or a frozen rack.
fn networks() -> Vec<Kind> {
    let pool = Physics::pool();
    let ball = pool.ball;
    let mut racks = vec![(3, vec![Vec2::ZERO, Vec2::new(0.0, 2.0), Vec2::new(0.0, 4.0)])];
    for balls in RACKS {
        let mut centers = vec![Vec2::new(0.0, -2.0)];
        let rows = (1..).take_while(|r| r * (r + 1) / 2 <= balls);
        for row in rows {
            for k in 0..row {
                let x = 2.0 * k as f64 - (row - 1) as f64;
                centers.push(Vec2::new(x, 3.0_f64.sqrt() * (row - 1) as f64));
            }
        }
        racks.push((balls + 1, centers));
    }
    racks
        .into_iter()
        .map(|(count, centers)| {
            let touches = touching(&centers);
            // Few inputs: an impact of a rack takes a million instructions.
            let inputs: Vec<Vec<Body>> = (0..INPUTS / 24)
                .map(|k| {
                    let speed = 1.0 + 0.7 * k as f64;
                    let at_rest = body(ball, Vec3::ZERO, Vec3::ZERO);
                    let mut bodies = vec![at_rest; count];
                    bodies[0].velocity = Vec3::new(0.02 * speed, speed, 0.0);
                    bodies
                })
                .collect();
            let law = pool.ball_ball;
            let name = format!("{count} balls, {} contacts", touches.len());
            Kind::over("impact: network", &name, inputs, move |bodies| {
                let mut bodies = black_box(bodies).clone();
                black_box(network::resolve(black_box(&law), &mut bodies, &touches));
                black_box(bodies);
            })
        })
        .collect()
}

/// The contacts of balls with these centres, in ball radii.
fn touching(centers: &[Vec2]) -> Vec<Touch> {
    let mut touches = Vec::new();
    for a in 0..centers.len() {
        for b in a + 1..centers.len() {
            let apart = centers[b] - centers[a];
            if apart.length() < 2.0 + 1e-9 {
                let normal = (apart * (1.0 / apart.length())).with_z(0.0);
                touches.push(Touch { a: a as u8, b: b as u8, normal, gap: 0.0 });
            }
        }
    }
    touches
}

/// Strikes: of a free ball, and as a network with the slate and with frozen balls.
fn strikes() -> Vec<Kind> {
    let pool = Physics::pool();
    let inputs: Vec<Strike> = (0..INPUTS)
        .map(|k| Strike {
            speed: 0.5 + 0.02 * k as f64,
            azimuth: 0.05 * k as f64,
            elevation: 0.05 + 0.005 * k as f64,
            side: 0.04 * (k % 11) as f64 - 0.2,
            height: 0.04 * (k % 13) as f64 - 0.24,
        })
        .collect();
    let (cue, ball) = (pool.cue, pool.ball);
    let mut kinds = vec![Kind::over("impact: cue and ball", "tip alone", inputs.clone(), {
        move |strike| {
            black_box(
                cue_ball::resolve(black_box(&cue), black_box(&ball), black_box(strike)).is_ok(),
            );
        }
    })];
    for frozen in 0..3 {
        let few = inputs.iter().step_by(8).copied().collect();
        let name = match frozen {
            0 => "network: tip and slate".to_owned(),
            1 => "network: tip, slate and one frozen ball".to_owned(),
            n => format!("network: tip, slate and {n} frozen balls"),
        };
        let physics = pool.clone();
        kinds.push(Kind::over("impact: cue and ball", &name, few, move |strike| {
            black_box(struck_in_network(black_box(&physics), black_box(strike), frozen));
        }));
    }
    kinds
}

/// A raised strike of a ball on the slate that `frozen` balls ahead touch.
fn struck_in_network(physics: &Physics, strike: &Strike, frozen: usize) -> Option<Vec<Body>> {
    let Physics { ball, slate, contact_times, ball_ball, cue, .. } = physics;
    let mut bodies = vec![body(*ball, Vec3::ZERO, Vec3::ZERO); 1 + frozen];
    let touches: Vec<Touch> = (0..frozen)
        .map(|k| {
            let angle = strike.azimuth + 0.6 - 1.1 * k as f64;
            let normal = Vec3::new(angle.cos(), angle.sin(), 0.0);
            Touch { a: 0, b: 1 + k as u8, normal, gap: 0.0 }
        })
        .collect();
    let wall = WallTouch {
        ball: 0,
        normal: Vec3::new(0.0, 0.0, -1.0),
        stiffness: stiffness_of_time(ball.mass, contact_times.slate),
        restitution: slate.restitution,
        friction: slate.friction,
        frequency_ratio: None,
    };
    let tip = cue_ball::tip_touch(cue, ball, strike, contact_times.tip, 0).ok()?;
    let impact =
        NetworkImpact { law: ball_ball, touches: &touches, walls: &[wall], tip: Some(tip) };
    impact.resolve(&mut bodies, &mut NetworkScratch::default())?;
    Some(bodies)
}
