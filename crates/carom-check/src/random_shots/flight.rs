//! Families of shots off the cloth.

use carom::math::{Vec2, cos, sin, sqrt};
use carom::table::LIP_OVERHANG;

use super::builder::{DrawnBall, ShotBuilder};

/// The presets' miscue limit, in radii: μ/√(1 + μ²) with μ = 0.6, rounded down.
const MISCUE: f64 = 0.514_49;

/// Approximate gravity, m/s², to aim balls in the air.
const GRAVITY: f64 = 9.8;

impl ShotBuilder {
    /// A random vector of a length up to √3.
    fn direction(&mut self) -> [f64; 3] {
        [(); 3].map(|()| self.rng.between(-1.0, 1.0))
    }

    /// A spin of zero, or of up to 500 rad/s about any axis.
    fn spin(&mut self) -> [f64; 3] {
        let size = if self.rng.below(4) == 0 { 0.0 } else { self.rng.between(0.0, 288.0) };
        self.direction().map(|x| x * size)
    }

    fn moving(&mut self, [u, v, w]: [f64; 3]) -> Option<[f64; 6]> {
        let [a, b, c] = self.spin();
        Some([u, v, w, a, b, c])
    }

    /// The shot file, with a strike of the first ball with any offset up to the miscue limit.
    fn struck_anywhere(mut self, speed: f64, azimuth: f64, elevation: f64) -> String {
        let angle = self.rng.between(0.0, 6.3);
        let size = match self.rng.below(4) {
            0 => 0.0,
            1 => MISCUE,
            _ => self.rng.between(0.0, MISCUE),
        };
        self.file(Some(format!(
            "{{\"ball\": \"0\", \"speed\": {speed:?}, \"azimuth_deg\": {azimuth:?}, \
             \"elevation_deg\": {elevation:?}, \"side\": {:?}, \"height\": {:?}}}",
            size * cos(angle),
            size * sin(angle)
        )))
    }

    /// A random place, free or frozen to a ball or a rail.
    fn anywhere_or_frozen(&mut self) -> [f64; 2] {
        let r = self.place.3;
        let p = self.anywhere();
        match self.rng.below(4) {
            0 => self.on_rail(p),
            1 if !self.balls.is_empty() => {
                let other = self.rng.below(self.balls.len());
                let [a, b] = self.balls[other].place;
                let angle = self.rng.between(0.0, 6.3);
                // Slightly more than touching, so that `fits` accepts it.
                let d = 2.0 * r * (1.0 + 1e-9);
                [a + d * cos(angle), b + d * sin(angle)]
            }
            _ => p,
        }
    }

    pub(super) fn elevated(mut self) -> String {
        let n = 1 + self.rng.below(12);
        for _ in 0..1000 {
            let p = self.anywhere_or_frozen();
            if self.balls.len() < n && self.fits(p) && self.on_cloth(p) {
                self.balls.push(DrawnBall::resting(p));
            }
        }
        let speed = self.rng.log_uniform(0.2, 20.0);
        let (azimuth, elevation) = (self.rng.between(0.0, 360.0), self.rng.between(0.0, 80.0));
        self.struck_anywhere(speed, azimuth, elevation)
    }

    pub(super) fn flying(mut self) -> String {
        let (_, w, l, r) = self.place;
        let n = 1 + self.rng.below(8);
        self.scatter(n);
        let flying = 1 + self.rng.below(n);
        for k in 0..flying {
            let speed = self.rng.log_uniform(1e-3, 20.0);
            let velocity = self.direction().map(|x| x * speed / 1.8);
            let height = r + self.rng.log_uniform(1e-6, 0.5);
            // One in four starts over a rail.
            if self.rng.below(4) == 0 && height > 0.08 {
                let (x, y) = (self.rng.between(-0.12, w + 0.12), self.rng.between(-0.12, l + 0.12));
                self.balls[k].place = if self.rng.below(2) == 0 {
                    [if x > 0.5 * w { w + 0.05 } else { -0.05 }, y]
                } else {
                    [x, if y > 0.5 * l { l + 0.05 } else { -0.05 }]
                };
            }
            self.balls[k].height = Some(height);
            self.balls[k].motion = self.moving(velocity);
        }
        self.file(None)
    }

    pub(super) fn dropped(mut self) -> String {
        let (_, w, l, r) = self.place;
        let below = 1 + self.rng.below(4);
        let cluster = self.rng.below(2) == 0;
        let middle = [self.rng.between(0.2 * w, 0.8 * w), self.rng.between(0.2 * l, 0.8 * l)];
        if cluster {
            // Balls frozen to each other: a ball that falls between them touches several at once.
            for k in 0..below.min(3) {
                let angle = 2.094_395_102_393_195_3 * k as f64;
                let d = 2.0 * r / sqrt(3.0) * (1.0 + 1e-12);
                self.balls.push(DrawnBall::resting([
                    middle[0] + d * cos(angle),
                    middle[1] + d * sin(angle),
                ]));
            }
        } else {
            self.scatter(below);
        }
        let mut height = 3.0 * r;
        for _ in 0..1 + self.rng.below(3) {
            let under = self.rng.below(self.balls.len());
            let [a, b] = self.balls[under].place;
            let (angle, off) = (self.rng.between(0.0, 6.3), self.rng.between(0.0, 2.0 * r));
            let off = if self.rng.below(4) == 0 { 0.0 } else { off };
            let place = match self.rng.below(3) {
                0 if cluster => middle,
                _ => [a + off * cos(angle), b + off * sin(angle)],
            };
            height += self.rng.log_uniform(1e-6, 0.3);
            let mut ball = DrawnBall { height: Some(height), ..DrawnBall::resting(place) };
            if self.rng.below(2) == 0 {
                let velocity = self.direction();
                ball.motion = self.moving(velocity);
            }
            self.balls.push(ball);
            height += 2.0 * r;
        }
        self.file(None)
    }

    pub(super) fn jump(mut self) -> String {
        let (_, w, l, r) = self.place;
        // One ball in the path of the cue ball, and some behind it.
        let cue = self.anywhere();
        let azimuth = self.rng.between(0.0, std::f64::consts::TAU);
        let (dx, dy) = (cos(azimuth), sin(azimuth));
        self.balls.push(DrawnBall::resting(cue));
        for reach in [0.1, 0.3, 0.6] {
            let d = self.rng.between(0.7, 1.6) * reach + 2.0 * r;
            let aside = self.rng.between(-1.5, 1.5) * r;
            let p = [cue[0] + d * dx - aside * dy, cue[1] + d * dy + aside * dx];
            let p = [p[0].clamp(r, w - r), p[1].clamp(r, l - r)];
            if self.fits(p) {
                self.balls.push(DrawnBall::resting(p));
            }
        }
        let (speed, elevation) = (self.rng.between(1.0, 12.0), self.rng.between(25.0, 75.0));
        self.struck_anywhere(speed, azimuth.to_degrees(), elevation)
    }

    /// Centre and axis of a random pocket (file coordinates), and its radius.
    fn pocket(&mut self) -> Option<(Vec2, Vec2, f64)> {
        let table = self.table();
        if table.pockets.is_empty() {
            return None;
        }
        let pocket = table.pockets[self.rng.below(table.pockets.len())];
        Some((pocket.center + table.center(), pocket.axis, pocket.radius))
    }

    pub(super) fn jaws(mut self) -> String {
        let r = self.place.3;
        let Some((hole, axis, radius)) = self.pocket() else { return self.flying() };
        let (turn, across) = (self.rng.between(-1.3, 1.3), self.rng.between(-1.5, 1.5) * radius);
        // From a random place before the pocket to a random place in its mouth.
        let distance = radius + self.rng.between(2.0 * r, 0.6);
        let back = axis * -cos(turn) + axis.perp() * -sin(turn);
        let from = hole + back * distance;
        let to = hole + axis.perp() * across - axis * self.rng.between(-0.5, 1.5) * radius;
        let way = to - from;
        let speed = self.rng.log_uniform(0.3, 20.0);
        let velocity = way * (speed / way.length());
        let start = DrawnBall::resting([from.x, from.y]);
        let ball = if self.rng.below(2) == 0 {
            DrawnBall { motion: self.moving([velocity.x, velocity.y, 0.0]), ..start }
        } else {
            // Passes the pocket at any height up to three balls.
            let (high, aim) = (self.rng.between(r, 6.0 * r), self.rng.between(0.5 * r, 6.0 * r));
            let time = way.length() / speed;
            let rise = (aim - high) / time + 0.5 * GRAVITY * time;
            let motion = self.moving([velocity.x, velocity.y, rise.clamp(-8.0, 8.0)]);
            DrawnBall { height: Some(high), motion, ..start }
        };
        self.balls.push(ball);
        let n = 1 + self.rng.below(4);
        self.scatter(n);
        self.file(None)
    }

    pub(super) fn mouths(mut self) -> String {
        let r = self.place.3;
        let Some((hole, axis, radius)) = self.pocket() else { return self.dropped() };
        // In the mouth, 0 to 0.1 m before the lip. Some are beyond it, up to the distance at which
        // friction still holds them.
        let n = 1 + self.rng.below(2);
        for _ in 0..100 {
            let turn = self.rng.between(-0.8, 0.8);
            let back = axis * -cos(turn) + axis.perp() * -sin(turn);
            let off = match self.rng.below(8) {
                0 => 0.0,
                1 => -LIP_OVERHANG * r * self.rng.between(0.0, 1.0),
                _ => self.rng.log_uniform(1e-9, 0.1),
            };
            let p = hole + back * (radius + off);
            let apart = self.balls.iter().all(|ball| {
                let [a, b] = ball.place;
                (p - Vec2::new(a, b)).length() > 2.0 * r
            });
            let stands = self.table().place_check(p - self.table().center(), r).is_inside();
            if self.balls.len() < n && apart && stands {
                self.balls.push(DrawnBall::resting([p.x, p.y]));
            }
        }
        let target = self.balls.first().map_or([hole.x, hole.y], |ball| ball.place);
        let rolled = self.rng.below(3) == 0 && !self.balls.is_empty();
        if rolled {
            // The ball rolls slowly towards the hole.
            let way = hole - Vec2::new(target[0], target[1]);
            let speed = self.rng.log_uniform(1e-6, 2.0);
            let v = way * (speed / way.length());
            let spin = if self.rng.below(2) == 0 { 1.0 / r } else { 0.0 };
            self.balls[0].motion = Some([v.x, v.y, 0.0, -v.y * spin, v.x * spin, 0.0]);
            return self.file(None);
        }
        let before = self.balls.len();
        self.scatter(before + 1);
        let cue = self.balls[before].place;
        let way = [target[0] - cue[0], target[1] - cue[1]];
        let aside = self.rng.between(-2.0, 2.0) * r;
        let distance = sqrt(way[0] * way[0] + way[1] * way[1]);
        let angle = carom::math::atan2(way[1], way[0]) + carom::math::atan(aside / distance);
        self.balls.swap(0, before);
        let speed = self.rng.log_uniform(0.1, 15.0);
        let elevation = if self.rng.below(3) == 0 { self.rng.between(0.0, 60.0) } else { 0.0 };
        self.struck_anywhere(speed, angle.to_degrees(), elevation)
    }
}
