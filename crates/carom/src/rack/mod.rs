//! Racks: the positions of the balls before the break, by each game's rule book.
//!
//! A rack is a lattice of balls whose centres are one ball's diameter and a gap apart. Every ball
//! is then moved at random, up to half the gap, in any direction. So balls never overlap,
//! neighbours are a gap apart on average, and a gap of 0 gives an exactly frozen rack, whose bits
//! are mirror-symmetric. The random numbers are PCG64 (O'Neill 2014) from the seed alone: the same
//! seed gives the same rack in every process and on every platform.

mod break_preset;
mod break_shot;
mod game;
mod pattern;

use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

use rand_pcg::{Pcg64, rand_core::Rng};

pub use break_preset::{BreakPreset, CueBallPlace, break_presets};
pub use break_shot::{Break, break_shot, cue_ball_of_its_own};
pub use game::Game;

use game::{Order, Pattern};

use crate::Table;
use crate::error::{Error, ErrorKind};
use crate::math::{Vec2, sqrt};

/// Mean gap between neighbours of a rack set by hand with a triangle, m: a tenth of a millimetre,
/// the thickness of a sheet of paper. Estimated.
pub const USUAL_GAP: f64 = 1e-4;

/// Widest gap of a rack, m.
const WIDEST_GAP: f64 = 5e-3;

/// Gap between the pink and the first red, m: "as close to the pink as possible without touching
/// it" (rules of snooker, section 3). Estimated.
const PINK_GAP: f64 = 1e-3;

/// Distance of the cue ball from the middle of the head string in the starting position of carom,
/// m (UMB; from memory, not verified).
const CUE_BALL_OFFSET: f64 = 0.1825;

/// PCG's stream. Any constant would do; another one changes the rack of every seed.
const STREAM: u128 = 0x6361_726f_6d20_7261_636b;

/// A ball of a rack: its id, and its centre on the cloth in the file's coordinates, m.
pub type RackedBall = (String, [f64; 2]);

/// The balls of `game` on `table`, the cue ball first, before the break. All balls have `radius`
/// (m); `gap` (m) is the mean gap between neighbours, 0 for a frozen rack.
///
/// # Errors
/// [`Error::Input`] for unbounded cloth, a gap outside [0, 5 mm], or balls too large for the table.
pub fn rack(
    game: Game,
    table: &Table,
    radius: f64,
    seed: u64,
    gap: f64,
) -> Result<Vec<RackedBall>, Error> {
    let plan = RackPlan::new(table, radius, gap)?;
    let mut random = Pcg64::new(u128::from(seed), STREAM);
    let mut balls = Vec::new();
    match game.equipment().pattern {
        Pattern::Reds(rows) => plan.snooker(rows, &mut balls, &mut random),
        Pattern::Carom => plan.carom(&mut balls),
        Pattern::TwoReds => plan.two_reds(&mut balls),
        Pattern::Numbers(rows, order) => {
            balls.push((String::from("cue"), plan.cue_ball()));
            let numbers = pattern::numbers(rows.iter().sum(), order, &mut random);
            let places = plan.triangle(plan.apex(order), rows, &mut random);
            balls.extend(numbers.into_iter().map(|n| format!("{n}")).zip(places));
        }
    }
    Ok(balls)
}

/// Positions of the colours of snooker on `table`, from the yellow to the black (file's
/// coordinates, m): on the table's own spots, else where a snooker table has them, in proportion.
pub fn snooker_spots(table: &Table) -> [[f64; 2]; 6] {
    let [middle, baulk] = spot(table, "brown", 0.2);
    let [yellow, _] = spot(table, "yellow", 0.2);
    let d = if yellow > middle { yellow - middle } else { 0.15 * table.size.x };
    // A black spot without a pink one is that of English pool, at the place of snooker's pink.
    let black = marked(table, "black").filter(|_| marked(table, "pink").is_some());
    [
        [mirrored(middle, d), baulk],
        [mirrored(middle, -d), baulk],
        [middle, baulk],
        spot(table, "blue", 0.5),
        spot(table, "pink", 0.75),
        black.unwrap_or([middle, 10.0 / 11.0 * table.size.y]),
    ]
}

/// The spot of that name, or else the point at `fraction` of the length on the middle line.
fn spot(table: &Table, name: &str, fraction: f64) -> [f64; 2] {
    marked(table, name).unwrap_or([0.5 * table.size.x, fraction * table.size.y])
}

fn marked(table: &Table, name: &str) -> Option<[f64; 2]> {
    let description = table.description.as_ref()?;
    Some(description.markings.spots.iter().find(|s| s.name == name)?.position)
}

/// The table and the balls that are racked on it.
struct RackPlan<'a> {
    table: &'a Table,
    radius: f64,
    gap: f64,
}

impl<'a> RackPlan<'a> {
    fn new(table: &'a Table, radius: f64, gap: f64) -> Result<Self, Error> {
        if !table.size.x.is_finite() {
            return Err(ErrorKind::Unsupported.at(
                "table",
                "unbounded cloth has no spots to rack on",
                "choose a table with rails",
            ));
        }
        if !(0.0..=WIDEST_GAP).contains(&gap) {
            return Err(ErrorKind::OutOfRange.at(
                "gap",
                format!("{gap:?} m is out of range"),
                format!("write a number in [0, {WIDEST_GAP}] m"),
            ));
        }
        // Fifteen balls are five wide and about as long, in the quarter behind the foot spot.
        if !(radius > 0.0 && 20.0 * radius < table.size.x.min(table.size.y)) {
            return Err(ErrorKind::OutOfRange.at(
                "radius",
                format!("balls of radius {radius:?} m do not fit on the table"),
                "choose a radius of less than a twentieth of the table's sides",
            ));
        }
        Ok(Self { table, radius, gap })
    }

    fn head_string(&self) -> f64 {
        let marked = self.table.description.as_ref().and_then(|d| d.markings.head_string);
        marked.unwrap_or(0.25 * self.table.size.y)
    }

    /// Distance between neighbouring rows.
    fn row(&self) -> f64 {
        0.5 * sqrt(3.0) * (2.0 * self.radius + self.gap)
    }

    /// Behind the head string, in the middle.
    fn cue_ball(&self) -> [f64; 2] {
        [0.5 * self.table.size.x, self.head_string() - self.radius]
    }

    /// The apex is on the foot spot. On English tables the 8, two rows behind the apex, is on its
    /// spot (WEPF).
    fn apex(&self, order: Order) -> [f64; 2] {
        match (order, marked(self.table, "foot"), marked(self.table, "black")) {
            (Order::Eight, None, Some([x, y])) => [x, y - 2.0 * self.row()],
            _ => spot(self.table, "foot", 0.75),
        }
    }

    /// Positions of rows of balls, from left to right; the first row is at `apex`.
    fn triangle(&self, [x, y]: [f64; 2], rows: &[usize], random: &mut Pcg64) -> Vec<[f64; 2]> {
        let pitch = 2.0 * self.radius + self.gap;
        let mut places = Vec::new();
        for (r, &count) in rows.iter().enumerate() {
            for k in 0..count {
                let column = k as f64 - 0.5 * (count - 1) as f64;
                let shift = self.scatter(random);
                places.push([
                    mirrored(x, column * pitch) + shift.x,
                    y + r as f64 * self.row() + shift.y,
                ]);
            }
        }
        places
    }

    /// A random shift, uniform in a disc of half the gap.
    fn scatter(&self, random: &mut Pcg64) -> Vec2 {
        if self.gap == 0.0 {
            return Vec2::ZERO;
        }
        loop {
            let shift = Vec2::new(signed_unit(random), signed_unit(random));
            if shift.length_squared() <= 1.0 {
                return shift * (0.5 * self.gap);
            }
        }
    }

    fn snooker(&self, rows: &[usize], balls: &mut Vec<RackedBall>, random: &mut Pcg64) {
        let spots @ [yellow, _, [middle, baulk], _, [pink_x, pink], _] = snooker_spots(self.table);
        // In the D, between brown and yellow, as most players break.
        balls.push((String::from("cue"), [middle + 0.5 * (yellow[0] - middle), baulk]));
        let apex = [pink_x, pink + 2.0 * self.radius + PINK_GAP.max(self.gap)];
        let reds = self.triangle(apex, rows, random);
        balls.extend(reds.into_iter().enumerate().map(|(i, p)| (format!("red-{}", i + 1), p)));
        let names = ["yellow", "green", "brown", "blue", "pink", "black"].map(String::from);
        balls.extend(names.into_iter().zip(spots));
    }

    fn carom(&self, balls: &mut Vec<RackedBall>) {
        let [x, y] = spot(self.table, "head", 0.25);
        let offset = CUE_BALL_OFFSET.min(0.25 * self.table.size.x);
        balls.push((String::from("cue"), [mirrored(x, offset), y]));
        balls.push((String::from("yellow"), [x, y]));
        balls.push((String::from("red"), spot(self.table, "foot", 0.75)));
    }

    fn two_reds(&self, balls: &mut Vec<RackedBall>) {
        let [x, y] = spot(self.table, "head", 0.25);
        let offset = CUE_BALL_OFFSET.min(0.25 * self.table.size.x);
        balls.push((String::from("cue"), [mirrored(x, offset), y]));
        balls.push((String::from("yellow"), [mirrored(x, -offset), y]));
        balls.push((String::from("red-1"), [x, y]));
        balls.push((String::from("red-2"), spot(self.table, "foot", 0.75)));
    }
}

/// `middle + offset`, rounded so that the same call with `-offset` gives the exact mirror image.
fn mirrored(middle: f64, offset: f64) -> f64 {
    let exact = (middle + offset.abs()) - middle;
    middle + exact.copysign(offset)
}

/// Uniform in [−1, 1), in steps of 2⁻⁵².
fn signed_unit(random: &mut Pcg64) -> f64 {
    (random.next_u64() >> 11) as f64 * (1.0 / (1u64 << 52) as f64) - 1.0
}

/// Uniform in 0..`n` (Lemire 2019 without its rejection: for the few balls of a rack the bias is
/// below 10⁻¹⁸).
fn below(random: &mut Pcg64, n: usize) -> usize {
    ((u128::from(random.next_u64()) * n as u128) >> 64) as usize
}

/// Fisher & Yates' shuffle.
fn shuffle<T>(items: &mut [T], random: &mut Pcg64) {
    for i in (1..items.len()).rev() {
        items.swap(i, below(random, i + 1));
    }
}
