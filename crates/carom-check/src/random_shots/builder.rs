//! Builds a random shot file: a random table, and random balls on it.

use std::fmt::Write as _;
use std::sync::LazyLock;

use carom::Table;
use carom::math::{cos, sin};

use crate::random::Random;

/// A table: its preset, width, length and radius of the balls, m.
type TableSize = (&'static str, f64, f64, f64);

/// The presets that are drawn, with the sizes of the rule books.
const PLACES: [TableSize; 8] = [
    ("wpa-9ft", 1.27, 2.54, 0.028_575),
    ("wpa-8ft", 1.1684, 2.3368, 0.028_575),
    ("bar-7ft", 0.9652, 1.9304, 0.028_575),
    ("showood-7ft", 0.9906, 1.9812, 0.028_575),
    ("snooker-12ft", 1.778, 3.569, 0.026_25),
    ("english-7ft", 0.9144, 1.8288, 0.0254),
    ("carom-10ft", 1.42, 2.84, 0.030_75),
    ("carom-9ft", 1.27, 2.54, 0.030_75),
];

/// The tables of `PLACES`. To build one costs as much as to judge half a shot.
static TABLES: LazyLock<[Table; PLACES.len()]> =
    LazyLock::new(|| PLACES.map(|(name, ..)| Table::preset(name).expect("a preset")));

/// A ball of a random shot.
#[derive(Clone, Copy)]
pub(super) struct DrawnBall {
    pub(super) place: [f64; 2],
    /// Height of the centre, m; `None` for a ball on the cloth.
    pub(super) height: Option<f64>,
    /// Velocity, m/s, and angular velocity, rad/s.
    pub(super) motion: Option<[f64; 6]>,
}

impl DrawnBall {
    pub(super) fn resting(place: [f64; 2]) -> Self {
        Self { place, height: None, motion: None }
    }
}

/// A random shot under construction.
pub(super) struct ShotBuilder {
    pub(super) place: TableSize,
    pub(super) balls: Vec<DrawnBall>,
    pub(super) rng: Random,
    /// The keys `physics` and `cling` of the file; `None` leaves them out.
    pub(super) physics: Option<String>,
    pub(super) cling: Option<String>,
}

impl ShotBuilder {
    /// A random table without balls.
    pub(super) fn new(mut rng: Random) -> Self {
        let place = PLACES[rng.below(PLACES.len())];
        Self { place, balls: Vec::new(), rng, physics: None, cling: None }
    }

    pub(super) fn fits(&self, [x, y]: [f64; 2]) -> bool {
        let (_, w, l, r) = self.place;
        let inside = x >= r && x <= w - r && y >= r && y <= l - r;
        inside
            && self.balls.iter().all(|ball| {
                let [a, b] = ball.place;
                let (dx, dy) = (x - a, y - b);
                dx * dx + dy * dy > 4.0 * r * r * (1.0 + 1e-9)
            })
    }

    pub(super) fn anywhere(&mut self) -> [f64; 2] {
        let (_, w, l, r) = self.place;
        [self.rng.between(r, w - r), self.rng.between(r, l - r)]
    }

    pub(super) fn scatter(&mut self, n: usize) {
        while self.balls.len() < n {
            let p = self.anywhere();
            if self.fits(p) {
                self.balls.push(DrawnBall::resting(p));
            }
        }
    }

    /// Whether a ball at this place is no nearer to a nose line than a frozen ball.
    pub(super) fn on_cloth(&self, [x, y]: [f64; 2]) -> bool {
        let (_, w, l, _) = self.place;
        let reach = self.reach() * (1.0 - 1e-12);
        x >= reach && x <= w - reach && y >= reach && y <= l - reach
    }

    pub(super) fn table(&self) -> &'static Table {
        let at = PLACES.iter().position(|(name, ..)| *name == self.place.0);
        &TABLES[at.expect("one of the places")]
    }

    /// Distance of a frozen ball's centre from the nose line.
    pub(super) fn reach(&self) -> f64 {
        let r = self.place.3;
        let rise = self.table().cushion_height - r;
        (r * r - rise * rise).sqrt()
    }

    /// Maps a place to a place frozen to the middle part of a random rail, clear of the pockets.
    pub(super) fn on_rail(&mut self, [x, y]: [f64; 2]) -> [f64; 2] {
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

    pub(super) fn struck(mut self, speed: f64, azimuth_deg: f64, elevation_deg: f64) -> String {
        let angle = self.rng.between(0.0, 6.3);
        let size = if self.rng.below(4) == 0 { 0.0 } else { self.rng.between(0.0, 0.5) };
        let (side, height) = (size * cos(angle), size * sin(angle));
        self.file(Some(format!(
            "{{\"ball\": \"0\", \"speed\": {speed:?}, \"azimuth_deg\": {azimuth_deg:?}, \
             \"elevation_deg\": {elevation_deg:?}, \"side\": {side:?}, \"height\": {height:?}}}"
        )))
    }

    pub(super) fn file(self, strike: Option<String>) -> String {
        let mut text = format!("{{\"format\": \"carom-shot/1\", \"table\": \"{}\"", self.place.0);
        for (key, value) in [("physics", &self.physics), ("cling", &self.cling)] {
            if let Some(value) = value {
                let _ = write!(text, ", \"{key}\": {value}");
            }
        }
        text.push_str(", \"balls\": [");
        let r = self.place.3;
        for (k, ball) in self.balls.iter().enumerate() {
            let comma = if k == 0 { "" } else { ", " };
            let [x, y] = ball.place;
            let z = ball.height.map_or(String::new(), |z| format!(", {z:?}"));
            let _ = write!(
                text,
                "{comma}{{\"id\": \"{k}\", \"position\": [{x:?}, {y:?}{z}], \"radius\": {r:?}"
            );
            if let Some([u, v, w, a, b, c]) = ball.motion {
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
