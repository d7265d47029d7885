//! Accuracy of the steps of `carom::resolve::network` on random clusters of balls.
use carom::math::{Vec3, cos, sin, sqrt};
use carom::physics::{BallBall, BallBallModel, Physics, SlipFriction};
use carom::resolve::Body;
use carom::resolve::network::{Impact, Stepping, Touch};

const MASS: f64 = 0.17;
const RADIUS: f64 = 0.028_575;

struct Draw(u64);
impl Draw {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }
    fn range(&mut self, a: f64, b: f64) -> f64 {
        a + (b - a) * self.next()
    }
}

fn cluster(seed: u64, model: BallBallModel, alike: bool) -> (BallBall, Vec<Body>, Vec<Touch>) {
    let mut d = Draw(seed);
    let size = std::env::var("SIZE").map_or(3 + (seed % 13) as usize, |s| s.parse().unwrap());
    let mut places: Vec<[f64; 3]> = vec![];
    let radius = |d: &mut Draw| if alike { RADIUS } else { d.range(0.022, 0.034) };
    let r0 = radius(&mut d);
    places.push([0.0, 0.0, r0]);
    while places.len() < size {
        let r = radius(&mut d);
        let k = (d.next() * places.len() as f64) as usize;
        let m = (d.next() * places.len() as f64) as usize;
        let [x, y, q] = places[k];
        let p = 2.0 * sqrt(q * r);
        let at = if d.next() < 0.5 && m != k {
            let [u, v, w] = places[m];
            let q2 = 2.0 * sqrt(w * r);
            let dist = sqrt((u - x) * (u - x) + (v - y) * (v - y));
            if dist > p + q2 {
                continue;
            }
            let along = (dist * dist + p * p - q2 * q2) / (2.0 * dist);
            let across = sqrt((p * p - along * along).max(0.0));
            let (c, s) = ((u - x) / dist, (v - y) / dist);
            [x + c * along - s * across, y + s * along + c * across, r]
        } else {
            let a = d.range(0.0, 6.283);
            [x + p * cos(a), y + p * sin(a), r]
        };
        let gap = |o: &[f64; 3]| {
            sqrt((o[0] - at[0]) * (o[0] - at[0]) + (o[1] - at[1]) * (o[1] - at[1]))
                - 2.0 * sqrt(o[2] * at[2])
        };
        if places.iter().all(|o| gap(o).abs() < 1e-9 || gap(o) > 2e-3) {
            places.push(at);
        }
    }
    let last = size - 1;
    let speed = carom::math::pow(10.0, d.range(0.0, 1.0));
    let mut bodies: Vec<Body> = places
        .iter()
        .map(|p| Body {
            velocity: Vec3::ZERO,
            angular_velocity: Vec3::ZERO,
            mass: if alike { MASS } else { MASS * carom::math::pow(p[2] / RADIUS, 3.0) },
            radius: p[2],
        })
        .collect();
    let mut touches = vec![];
    let mut head = 0.0;
    for a in 0..size {
        for b in a + 1..size {
            let v = Vec3::new(
                places[b][0] - places[a][0],
                places[b][1] - places[a][1],
                places[b][2] - places[a][2],
            );
            if v.length() < places[a][2] + places[b][2] + 1e-9 {
                touches.push(Touch {
                    a: a as u8,
                    b: b as u8,
                    normal: v * (1.0 / v.length()),
                    gap: 0.0,
                });
                if b == last {
                    head = carom::math::atan2(-v.y, -v.x);
                }
            }
        }
    }
    head += d.range(-1.1, 1.1);
    bodies[last].velocity = Vec3::new(speed * cos(head), speed * sin(head), 0.0);
    let mut spin = || d.range(-1.0, 1.0) * speed / RADIUS;
    bodies[last].angular_velocity = Vec3::new(spin(), spin(), spin());
    let friction = if seed % 2 == 0 || std::env::var("CONST").is_ok() {
        SlipFriction::constant(0.06)
    } else {
        SlipFriction { a: 0.01, b: 0.11, c: 1.1 }
    };
    let law = BallBall {
        model,
        restitution: std::env::var("E")
            .map_or([0.85, 0.95, 1.0][(seed / 2 % 3) as usize], |e| e.parse().unwrap()),
        friction: if model == BallBallModel::Elastic {
            SlipFriction::constant(0.0)
        } else {
            friction
        },
        frequency_ratio: d.range(1.3, 1.9),
        ..Physics::pool().ball_ball
    };
    (law, bodies, touches)
}

fn main() {
    if let Ok(s) = std::env::var("SHOW") {
        for m in [BallBallModel::Elastic, BallBallModel::Frictional, BallBallModel::Compliant]
            .into_iter()
            .take(std::env::var("M").map_or(3, |m| m.parse().unwrap()))
        {
            show(s.parse().unwrap(), m, std::env::var("A").is_ok());
        }
        return;
    }
    let n: u64 = std::env::args().nth(1).map_or(300, |s| s.parse().unwrap());
    let fine = Stepping { steps_per_contact: 800.0, ahead: 1.0 / 12.0, trend: 1.0 };
    let args: Vec<f64> = std::env::args().skip(2).map(|s| s.parse().unwrap()).collect();
    let (ahead, trend) =
        (args.first().copied().unwrap_or(0.065), args.get(1).copied().unwrap_or(1.25));
    for model in [BallBallModel::Elastic, BallBallModel::Frictional, BallBallModel::Compliant]
        .into_iter()
        .take(std::env::var("M").map_or(3, |m| m.parse().unwrap()))
    {
        for alike in [true, false] {
            for steps in std::env::var("STEPS").map_or(vec![11.0, 22.0, 44.0, 200.0], |s| {
                s.split(',').map(|x| x.parse().unwrap()).collect::<Vec<f64>>()
            }) {
                let s = Stepping { steps_per_contact: steps, ahead, trend };
                let mut errors: Vec<(f64, u64)> = (0..n)
                    .map(|seed| {
                        let (law, bodies, touches) = cluster(1000 + seed, model, alike);
                        let i = Impact { law: &law, touches: &touches, walls: &[], tip: None };
                        let (mut p, mut q) = (bodies.clone(), bodies);
                        i.resolve_in_steps(&mut p, &s);
                        i.resolve_in_steps(&mut q, &fine);
                        let fastest = q.iter().map(|b| b.velocity.length()).fold(0.0, f64::max);
                        let e = p
                            .iter()
                            .zip(&q)
                            .map(|(a, b)| (a.velocity - b.velocity).length())
                            .fold(0.0, f64::max);
                        (e / fastest, seed)
                    })
                    .collect();
                errors.sort_by(|a, b| a.0.total_cmp(&b.0));
                let at = |f: f64| errors[((errors.len() - 1) as f64 * f) as usize];
                println!(
                    "{model:?} alike {alike} steps {steps}: median {:.1e} 90% {:.1e} 99% {:.1e} worst {:.1e} ({})",
                    at(0.5).0,
                    at(0.9).0,
                    at(0.99).0,
                    at(1.0).0,
                    at(1.0).1
                );
            }
        }
    }
}
#[allow(dead_code)]
fn show(seed: u64, model: BallBallModel, alike: bool) {
    for steps in [11.0, 14.0, 22.0, 200.0, 800.0] {
        let (law, bodies, touches) = cluster(1000 + seed, model, alike);
        let i = Impact { law: &law, touches: &touches, walls: &[], tip: None };
        let mut p = bodies.clone();
        let r =
            i.resolve_in_steps(&mut p, &Stepping { steps_per_contact: steps, ahead: 1.0 / 12.0, trend: 1.0 });
        println!("{steps} {r:?} {:?} {}", bodies.last().unwrap().velocity, touches.len());
        for b in &p {
            print!(
                " [{:.5} {:.5} {:.5} | {:.5} {:.5} {:.5}]",
                b.velocity.x,
                b.velocity.y,
                b.velocity.z,
                b.angular_velocity.x * b.radius,
                b.angular_velocity.y * b.radius,
                b.angular_velocity.z * b.radius
            );
        }
        for t in &touches {
            print!(" {}-{}", t.a, t.b);
        }
        println!();
    }
}
