//! Random shots that proptest can draw and shrink: some balls of a grid, each at rest or moving.

use carom::format::{Node, SHOT_FORMAT};
use carom::math::{Vec2, Vec3};
use carom::physics::BallBallModel;
use carom::{BallState, Error, MotionState, Shot};
use proptest::prelude::*;
use proptest::sample::{select, subsequence};

/// Places and half sides of the tables are multiples of this, m. Then the file coordinates and the
/// engine frame hold the same place exactly, and a mirrored shot has mirrored bits.
const GRID: f64 = 1.0 / (1u64 << 40) as f64;

/// Largest distance of a ball from the centre of its cell of 0.25 m, along each axis, m: any two
/// balls are at least a pool ball's diameter apart.
const JITTER: f64 = 0.09;

const CUSHION_MODELS: [&str; 4] = ["restitution", "han-2005", "mathavan-2010", "stronge"];

/// A table whose sides are short binary fractions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Ground {
    /// A pool table with pockets, 1.25 m by 2.5 m.
    Pool,
    /// Four cushions, 1.25 m by 1.25 m.
    Square,
    /// Unbounded cloth.
    Cloth,
}

/// A shot in the engine coordinates: x, y from the table's centre.
#[derive(Clone, Debug)]
pub(crate) struct Plan {
    pub(crate) ground: Ground,
    pub(crate) ball_ball: &'static str,
    pub(crate) cushion: &'static str,
    /// Changes to the physics besides the models: group, key and value.
    pub(crate) changes: Vec<(&'static str, &'static str, f64)>,
    /// Gravity, m/s².
    pub(crate) gravity: f64,
    pub(crate) balls: Vec<BallState>,
}

impl Plan {
    /// The shot. Balls in the air are at their height, the others on the cloth.
    pub(crate) fn shot(&self) -> Shot {
        self.read().unwrap_or_else(|e| panic!("{e}"))
    }

    /// The shot, if it is valid.
    pub(crate) fn read(&self) -> Result<Shot, Error> {
        let (table, center) = match self.ground {
            Ground::Pool => (
                Node::object([
                    ("base", "wpa-9ft".into()),
                    ("width", 1.25.into()),
                    ("length", 2.5.into()),
                ]),
                Vec2::new(0.625, 1.25),
            ),
            Ground::Square => (
                Node::object([("width", 1.25.into()), ("length", 1.25.into())]),
                Vec2::new(0.625, 0.625),
            ),
            Ground::Cloth => (Node::object([("cloth", "unbounded".into())]), Vec2::ZERO),
        };
        let ball = |(k, s): (usize, &BallState)| {
            let place = s.position.xy() + center;
            let mut position = vec![place.x, place.y];
            if s.motion == MotionState::Airborne {
                position.push(s.position.z);
            }
            let list = |v: Vec3| Node::list([v.x, v.y, v.z]);
            Node::object([
                ("id", k.to_string().as_str().into()),
                ("position", Node::list(position)),
                ("velocity", list(s.velocity)),
                ("angular_velocity", list(s.angular_velocity)),
            ])
        };
        let mut physics = Node::object([
            ("base", "pool".into()),
            ("gravity", self.gravity.into()),
            ("ball_ball", Node::object([("model", self.ball_ball.into())])),
            ("cushion", Node::object([("model", self.cushion.into())])),
        ]);
        for &(group, key, value) in &self.changes {
            let mut changed = physics.get(group).cloned().unwrap_or(Node::object([]));
            changed.set(key, value);
            physics.set(group, changed);
        }
        let file = Node::object([
            ("format", SHOT_FORMAT.into()),
            ("table", table),
            ("physics", physics),
            ("balls", Node::list(self.balls.iter().enumerate().map(ball))),
        ]);
        Shot::from_node(&file)
    }

    /// The same plan with every ball's state changed.
    pub(crate) fn map(&self, change: impl Fn(&BallState) -> BallState) -> Self {
        Self { balls: self.balls.iter().map(change).collect(), ..self.clone() }
    }
}

fn on_grid(x: f64) -> f64 {
    (x / GRID).round() * GRID
}

/// Faster and slower than anything in play, m/s, equally often in every decade.
fn speed() -> impl Strategy<Value = f64> {
    (-4.0..1.0).prop_map(|exponent: f64| carom::math::pow(10.0, exponent))
}

prop_compose! {
    fn moving()(
        speed in speed(), angle in 0.0..6.3, spin in prop::array::uniform3(-150.0..150.0),
    ) -> (Vec3, Vec3) {
        let (sin, cos) = carom::math::sin_cos(angle);
        let [a, b, c] = spin;
        (Vec3::new(speed * cos, speed * sin, 0.0), Vec3::new(a, b, c))
    }
}

/// A ball in the cell with the centre `x`, `y`: at rest, moving and spinning, or moving without
/// spin.
fn ball((x, y): (f64, f64)) -> impl Strategy<Value = BallState> {
    let motion = prop_oneof![
        Just((Vec3::ZERO, Vec3::ZERO)),
        moving(),
        moving().prop_map(|(velocity, _)| (velocity, Vec3::ZERO)),
    ];
    // Some balls fly, up to 0.33 m high.
    let flight = prop::option::weighted(0.2, (0.03..0.33, -3.0..3.0));
    (-JITTER..JITTER, -JITTER..JITTER, motion, flight).prop_map(move |(dx, dy, motion, flight)| {
        let (velocity, spin) = motion;
        let (z, rise, motion) = flight
            .map_or((0.0, 0.0, MotionState::Stationary), |(z, rise): (f64, f64)| {
                (z, rise, MotionState::Airborne)
            });
        BallState {
            position: Vec3::new(on_grid(x + dx), on_grid(y + dy), z),
            velocity: Vec3::new(velocity.x, velocity.y, rise),
            angular_velocity: spin,
            motion,
        }
    })
}

fn cells(columns: u8, rows: u8) -> Vec<(f64, f64)> {
    let middle = |k: u8, n: u8| 0.25 * (f64::from(k) - 0.5 * f64::from(n - 1));
    (0..rows)
        .flat_map(|j| (0..columns).map(move |i| (middle(i, columns), middle(j, rows))))
        .collect()
}

/// Shots of one to `most` balls on `ground`, with every model.
pub(crate) fn plan(ground: Ground, most: usize) -> impl Strategy<Value = Plan> {
    let cells = match ground {
        Ground::Pool => cells(4, 8),
        Ground::Square | Ground::Cloth => cells(4, 4),
    };
    let balls = subsequence(cells, 1..=most)
        .prop_flat_map(|cells| cells.into_iter().map(ball).collect::<Vec<_>>());
    (
        select(BallBallModel::ALL.map(BallBallModel::name).to_vec()),
        select(&CUSHION_MODELS[..]),
        balls,
    )
        .prop_map(move |(ball_ball, cushion, balls)| Plan {
            ground,
            ball_ball,
            cushion,
            changes: Vec::new(),
            gravity: 9.81,
            balls,
        })
}

/// Shots on every ground.
pub(crate) fn any_plan(most: usize) -> impl Strategy<Value = Plan> {
    prop_oneof![plan(Ground::Pool, most), plan(Ground::Square, most), plan(Ground::Cloth, most)]
}
