//! Random shots, as shot files: what players play, and what breaks engines.

use std::fmt::Write as _;

use carom::math::{cos, sin};

/// Families of shots. Together they hold every hard case of ARCHITECTURE.md that can be drawn by
/// lot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scene {
    /// The cue ball and some others, anywhere, an ordinary strike.
    Pot,
    /// An eight-ball break with gaps of 0.1 mm, 1 µm or none.
    EightBallBreak,
    /// A nine-ball break, likewise.
    NineBallBreak,
    /// Balls frozen to rails and to each other.
    Frozen,
    /// Every ball moves already, at 1e-9 to 20 m/s with spins of 0 to 500 rad/s.
    Wild,
    /// Balls in a row along one line, some touching, rolled or struck at: Newton's cradle.
    Row,
}

impl Scene {
    /// All families.
    pub const ALL: [Self; 6] =
        [Self::Pot, Self::EightBallBreak, Self::NineBallBreak, Self::Frozen, Self::Wild, Self::Row];
}

/// SplitMix64 (Steele, Lea & Flood 2014): one multiplication chain per number, the same
/// everywhere.
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// A stream of its own for every seed.
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }
    /// Uniform in [a, b).
    pub fn uniform(&mut self, a: f64, b: f64) -> f64 {
        a + (b - a) * ((self.next() >> 11) as f64 * (0.5 / (1u64 << 52) as f64))
    }
    /// Uniform in 0..n.
    pub fn below(&mut self, n: usize) -> usize {
        (self.next() % n as u64) as usize
    }
    /// Log-uniform in [a, b).
    fn log_uniform(&mut self, a: f64, b: f64) -> f64 {
        let x = self.uniform(0.0, 1.0);
        a * carom::math::pow(b / a, x)
    }
}

/// A table to play on: preset, width, length, radius of its balls, all m.
type Place = (&'static str, f64, f64, f64);

/// The presets that scenes use; sizes are those of the rule books.
const PLACES: [Place; 8] = [
    ("wpa-9ft", 1.27, 2.54, 0.028_575),
    ("wpa-8ft", 1.1684, 2.3368, 0.028_575),
    ("bar-7ft", 0.9652, 1.9304, 0.028_575),
    ("showood-7ft", 0.9906, 1.9812, 0.028_575),
    ("snooker-12ft", 1.778, 3.569, 0.026_25),
    ("english-7ft", 0.9144, 1.8288, 0.0254),
    ("carom-10ft", 1.42, 2.84, 0.030_75),
    ("carom-9ft", 1.27, 2.54, 0.030_75),
];

/// The shot file of `scene` number `seed`.
pub fn shot_file(scene: Scene, seed: u64) -> String {
    let mut rng = Random::new(seed ^ ((scene as u64 + 1) << 56));
    let place = PLACES[rng.below(PLACES.len())];
    let layout = Layout { place, balls: Vec::new(), rng };
    match scene {
        Scene::Pot => layout.pot(),
        Scene::EightBallBreak => layout.triangle(5),
        Scene::NineBallBreak => layout.triangle(3),
        Scene::Frozen => layout.frozen(),
        Scene::Wild => layout.wild(),
        Scene::Row => layout.row(),
    }
}

struct Layout {
    place: Place,
    balls: Vec<([f64; 2], Option<[f64; 6]>)>,
    rng: Random,
}

impl Layout {
    fn fits(&self, [x, y]: [f64; 2]) -> bool {
        let (_, w, l, r) = self.place;
        let inside = x >= r && x <= w - r && y >= r && y <= l - r;
        inside
            && self.balls.iter().all(|([a, b], _)| {
                let (dx, dy) = (x - a, y - b);
                dx * dx + dy * dy > 4.0 * r * r * (1.0 + 1e-9)
            })
    }

    fn anywhere(&mut self) -> [f64; 2] {
        let (_, w, l, r) = self.place;
        [self.rng.uniform(r, w - r), self.rng.uniform(r, l - r)]
    }

    fn scatter(&mut self, n: usize) {
        while self.balls.len() < n {
            let p = self.anywhere();
            if self.fits(p) {
                self.balls.push((p, None));
            }
        }
    }

    fn pot(mut self) -> String {
        let n = 2 + self.rng.below(15);
        self.scatter(n);
        let speed = self.rng.uniform(0.3, 6.0);
        let elevation = if self.rng.below(4) == 0 { self.rng.uniform(0.0, 60.0) } else { 0.0 };
        let azimuth = self.rng.uniform(0.0, 360.0);
        self.struck(speed, azimuth, elevation)
    }

    fn triangle(mut self, rows: usize) -> String {
        let (_, w, l, r) = self.place;
        let gap = [1e-4, 1e-6, 0.0][self.rng.below(3)];
        let step = 2.0 * r + gap;
        let cue = [0.5 * w, 0.25 * l];
        self.balls.push((cue, None));
        let (full, rows) = if rows == 3 { (false, 5) } else { (true, rows) };
        for row in 0..rows {
            // A nine-ball rack is a diamond: 1, 2, 3, 2, 1.
            let in_row = if full { row + 1 } else { 3 - row.abs_diff(2) };
            for k in 0..in_row {
                let x = 0.5 * w + step * (k as f64 - 0.5 * (in_row as f64 - 1.0));
                let y = 0.75 * l + step * 0.5 * 3.0_f64.sqrt() * row as f64;
                let spread = 0.25 * gap;
                let jitter = [self.rng.uniform(-spread, spread), self.rng.uniform(-spread, spread)];
                self.balls.push(([x + jitter[0], y + jitter[1]], None));
            }
        }
        let centred = self.rng.below(4) == 0;
        let off = if centred { 0.0 } else { self.rng.uniform(-3.0, 3.0) };
        let speed = self.rng.uniform(3.0, 12.0);
        self.struck(speed, 90.0 + off, 0.0)
    }

    /// Some balls frozen to a rail, some to another ball; the cue ball may be one of them.
    fn frozen(mut self) -> String {
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
                    let ([a, b], _) = self.balls[other];
                    let angle = self.rng.uniform(0.0, 6.3);
                    let d = 2.0 * r;
                    [a + d * cos(angle), b + d * sin(angle)]
                }
                _ => [x, y],
            };
            // Frozen pairs are 2R apart up to rounding, which the test for free places refuses.
            let free = self.balls.iter().all(|([a, b], _)| {
                let (dx, dy) = (p[0] - a, p[1] - b);
                dx * dx + dy * dy > 4.0 * r * r * (1.0 - 1e-12)
            });
            let margin = 0.9 * r;
            let inside = p[0] > margin && p[0] < w - margin && p[1] > margin && p[1] < l - margin;
            let clear = p[0] >= r || p[0] <= w - r;
            if free && inside && clear && self.on_cloth(p) {
                self.balls.push((p, None));
            }
        }
        let speed = self.rng.uniform(0.1, 8.0);
        let azimuth = match self.rng.below(3) {
            0 => 90.0 * self.rng.below(4) as f64,
            _ => self.rng.uniform(0.0, 360.0),
        };
        let elevation = if self.rng.below(3) == 0 { self.rng.uniform(0.0, 70.0) } else { 0.0 };
        self.struck(speed, azimuth, elevation)
    }

    /// Whether a centre is no nearer to a nose line than a frozen ball's.
    fn on_cloth(&self, [x, y]: [f64; 2]) -> bool {
        let (_, w, l, _) = self.place;
        let reach = self.reach() * (1.0 - 1e-12);
        x >= reach && x <= w - reach && y >= reach && y <= l - reach
    }

    /// Distance of a frozen ball's centre from the nose line.
    fn reach(&self) -> f64 {
        let table = carom::Table::preset(self.place.0).expect("a preset");
        let r = self.place.3;
        let rise = table.cushion_height - r;
        (r * r - rise * rise).sqrt()
    }

    /// Moves a place onto the middle part of a rail, clear of the pockets.
    fn on_rail(&mut self, [x, y]: [f64; 2]) -> [f64; 2] {
        let (_, w, l, _) = self.place;
        let reach = self.reach();
        let (x_mid, y_mid) = (w * (0.25 + 0.5 * x / w), l * (0.15 + 0.2 * y / l));
        match self.rng.below(4) {
            0 => [reach, y_mid],
            1 => [w - reach, y_mid],
            2 => [x_mid, reach],
            _ => [x_mid, l - reach],
        }
    }

    fn wild(mut self) -> String {
        let n = 1 + self.rng.below(12);
        self.scatter(n);
        for k in 0..n {
            let speed = self.rng.log_uniform(1e-9, 20.0);
            let angle = self.rng.uniform(0.0, 6.3);
            let spin = if self.rng.below(4) == 0 { 0.0 } else { self.rng.uniform(0.0, 500.0) };
            let mut direction = [0.0; 3];
            for d in &mut direction {
                *d = self.rng.uniform(-1.0, 1.0) * spin / 1.8;
            }
            let [a, b, c] = direction;
            self.balls[k].1 = Some([speed * cos(angle), speed * sin(angle), 0.0, a, b, c]);
        }
        self.file(None)
    }

    fn row(mut self) -> String {
        let (_, w, l, r) = self.place;
        let n = 3 + self.rng.below(4);
        let gap = [0.0, 0.0, 1e-6, 0.01][self.rng.below(4)];
        let off = [0.0, 0.0, 1e-3][self.rng.below(3)];
        let first = 0.35 * l;
        for k in 0..n {
            let y = first + (2.0 * r + gap) * k as f64;
            let x = 0.5 * w + off * self.rng.uniform(-1.0, 1.0);
            // With sideways offsets the row is longer, never shorter.
            self.balls.push(([x, y], None));
        }
        self.balls.insert(0, ([0.5 * w, 0.15 * l], None));
        if self.rng.below(3) == 0 {
            // All roll the same way, at the same or at different speeds.
            for k in 0..self.balls.len() {
                let v = [1.0, 1.0, 0.5][self.rng.below(3)];
                self.balls[k].1 = Some([0.0, v, 0.0, -v / r, 0.0, 0.0]);
            }
            return self.file(None);
        }
        let speed = self.rng.uniform(0.2, 4.0);
        self.struck(speed, 90.0, 0.0)
    }

    fn struck(mut self, speed: f64, azimuth_deg: f64, elevation_deg: f64) -> String {
        let angle = self.rng.uniform(0.0, 6.3);
        let size = if self.rng.below(4) == 0 { 0.0 } else { self.rng.uniform(0.0, 0.5) };
        let (side, height) = (size * cos(angle), size * sin(angle));
        self.file(Some(format!(
            "{{\"ball\": \"0\", \"speed\": {speed:?}, \"azimuth_deg\": {azimuth_deg:?}, \
             \"elevation_deg\": {elevation_deg:?}, \"side\": {side:?}, \"height\": {height:?}}}"
        )))
    }

    fn file(self, strike: Option<String>) -> String {
        let mut text = format!(
            "{{\"format\": \"carom-shot/1\", \"table\": \"{}\", \"balls\": [",
            self.place.0
        );
        let r = self.place.3;
        for (k, ([x, y], motion)) in self.balls.iter().enumerate() {
            let comma = if k == 0 { "" } else { ", " };
            let _ = write!(
                text,
                "{comma}{{\"id\": \"{k}\", \"position\": [{x:?}, {y:?}], \"radius\": {r:?}"
            );
            if let Some([u, v, w, a, b, c]) = motion {
                let _ = write!(
                    text,
                    ", \"velocity\": [{u:?}, {v:?}, {w:?}], \"angular_velocity\": [{a:?}, {b:?}, {c:?}]"
                );
            }
            text.push('}');
        }
        text.push(']');
        if let Some(strike) = strike {
            let _ = write!(text, ", \"strike\": {strike}");
        }
        text.push('}');
        text
    }
}
