//! Families of shots on the cloth.

use carom::math::{cos, sin};

use super::builder::{DrawnBall, ShotBuilder};

impl ShotBuilder {
    pub(super) fn pot(mut self) -> String {
        let n = 2 + self.rng.below(15);
        self.scatter(n);
        let speed = self.rng.between(0.3, 6.0);
        let elevation = if self.rng.below(4) == 0 { self.rng.between(0.0, 60.0) } else { 0.0 };
        let azimuth = self.rng.between(0.0, 360.0);
        self.struck(speed, azimuth, elevation)
    }

    pub(super) fn triangle(mut self, rows: usize) -> String {
        let (_, w, l, r) = self.place;
        let gap = [1e-4, 1e-6, 0.0][self.rng.below(3)];
        let step = 2.0 * r + gap;
        let cue = [0.5 * w, 0.25 * l];
        self.balls.push(DrawnBall::resting(cue));
        let (full, rows) = if rows == 3 { (false, 5) } else { (true, rows) };
        for row in 0..rows {
            // A nine-ball rack is a diamond: 1, 2, 3, 2, 1.
            let in_row = if full { row + 1 } else { 3 - row.abs_diff(2) };
            for k in 0..in_row {
                let x = 0.5 * w + step * (k as f64 - 0.5 * (in_row as f64 - 1.0));
                let y = 0.75 * l + step * 0.5 * 3.0_f64.sqrt() * row as f64;
                let spread = 0.25 * gap;
                let jitter = [self.rng.between(-spread, spread), self.rng.between(-spread, spread)];
                self.balls.push(DrawnBall::resting([x + jitter[0], y + jitter[1]]));
            }
        }
        let centred = self.rng.below(4) == 0;
        let off = if centred { 0.0 } else { self.rng.between(-3.0, 3.0) };
        let speed = self.rng.between(3.0, 12.0);
        self.struck(speed, 90.0 + off, 0.0)
    }

    /// Some balls are frozen to a rail, some to another ball; the cue ball may be one of them.
    pub(super) fn frozen(mut self) -> String {
        let (_, w, l, r) = self.place;
        let n = 2 + self.rng.below(9);
        let mut tries = 0;
        while self.balls.len() < n && tries < 1000 {
            tries += 1;
            let [x, y] = self.anywhere();
            let p = match self.rng.below(3) {
                0 => self.on_rail([x, y]),
                1 if !self.balls.is_empty() => {
                    let other = self.rng.below(self.balls.len());
                    let [a, b] = self.balls[other].place;
                    let angle = self.rng.between(0.0, 6.3);
                    let d = 2.0 * r;
                    [a + d * cos(angle), b + d * sin(angle)]
                }
                _ => [x, y],
            };
            // Frozen pairs are 2R apart up to rounding, so `fits` would refuse them.
            let free = self.balls.iter().all(|ball| {
                let [a, b] = ball.place;
                let (dx, dy) = (p[0] - a, p[1] - b);
                dx * dx + dy * dy > 4.0 * r * r * (1.0 - 1e-12)
            });
            let margin = 0.9 * r;
            let inside = p[0] > margin && p[0] < w - margin && p[1] > margin && p[1] < l - margin;
            if free && inside && self.on_cloth(p) {
                self.balls.push(DrawnBall::resting(p));
            }
        }
        let speed = self.rng.between(0.1, 8.0);
        let azimuth = match self.rng.below(3) {
            0 => 90.0 * self.rng.below(4) as f64,
            _ => self.rng.between(0.0, 360.0),
        };
        let elevation = if self.rng.below(3) == 0 { self.rng.between(0.0, 70.0) } else { 0.0 };
        self.struck(speed, azimuth, elevation)
    }

    pub(super) fn wild(mut self) -> String {
        let n = 1 + self.rng.below(12);
        self.scatter(n);
        for k in 0..n {
            let speed = self.rng.log_uniform(1e-9, 20.0);
            let angle = self.rng.between(0.0, 6.3);
            let spin = if self.rng.below(4) == 0 { 0.0 } else { self.rng.between(0.0, 500.0) };
            let mut direction = [0.0; 3];
            for d in &mut direction {
                *d = self.rng.between(-1.0, 1.0) * spin / 1.8;
            }
            let [a, b, c] = direction;
            self.balls[k].motion = Some([speed * cos(angle), speed * sin(angle), 0.0, a, b, c]);
        }
        self.file(None)
    }

    pub(super) fn row(mut self) -> String {
        let (_, w, l, r) = self.place;
        let n = 3 + self.rng.below(4);
        let gap = [0.0, 0.0, 1e-6, 0.01][self.rng.below(4)];
        let off = [0.0, 0.0, 1e-3][self.rng.below(3)];
        let first = 0.35 * l;
        for k in 0..n {
            let y = first + (2.0 * r + gap) * k as f64;
            let x = 0.5 * w + off * self.rng.between(-1.0, 1.0);
            // Sideways offsets make the row longer, so balls do not overlap.
            self.balls.push(DrawnBall::resting([x, y]));
        }
        self.balls.insert(0, DrawnBall::resting([0.5 * w, 0.15 * l]));
        if self.rng.below(3) == 0 {
            // All balls roll in the same direction, at the same or at different speeds.
            for k in 0..self.balls.len() {
                let v = [1.0, 1.0, 0.5][self.rng.below(3)];
                self.balls[k].motion = Some([0.0, v, 0.0, -v / r, 0.0, 0.0]);
            }
            return self.file(None);
        }
        let speed = self.rng.between(0.2, 4.0);
        self.struck(speed, 90.0, 0.0)
    }
}
