//! Sums over many checked shots.

use std::fmt;

use crate::CheckRecorder;

/// Number of faulty shots whose files are kept.
const EXAMPLES: usize = 5;

/// Fraction of the fastest approach up to which touching balls may approach after a collision of
/// more than two balls; the engine's steps conserve the energy to about a tenth of it.
pub const LEFT_APPROACHING: f64 = 1e-3;

/// The result of checking many shots.
#[derive(Clone, Debug, Default)]
pub struct Tally {
    /// Shots simulated.
    pub shots: u64,
    /// Drawn layouts that are not valid shots: a ball in a jaw or over a hole.
    pub refused: u64,
    /// Shots with a fault.
    pub faulty: u64,
    /// Events of all shots.
    pub events: u64,
    /// Largest number of events of one shot, and its seed.
    pub longest: (u64, u64),
    /// Upper bound of all overlaps, m.
    pub deepest: f64,
    /// Largest |gap| at a contact of two balls, m.
    pub widest: f64,
    /// Shots in which a collision of more than two balls has left two touching balls approaching
    /// faster than [`LEFT_APPROACHING`] times the fastest approach before it.
    pub unfinished: u64,
    /// The largest such fraction, and the seed.
    pub worst_unfinished: (f64, u64),
    /// Some faulty shots: the seed, and the faults with the shot file.
    pub examples: Vec<(u64, String)>,
}

impl Tally {
    /// The tally of one shot.
    pub fn of(seed: u64, checker: &CheckRecorder<'_>, file: &str) -> Self {
        let faults: Vec<String> = checker.faults.iter().map(ToString::to_string).collect();
        Self {
            shots: 1,
            refused: 0,
            faulty: u64::from(!faults.is_empty()),
            events: checker.events,
            longest: (checker.events, seed),
            deepest: checker.deepest.max(0.0),
            widest: checker.gaps.iter().fold(0.0, |w: f64, g| w.max(g.abs())),
            unfinished: u64::from(checker.left_approaching > LEFT_APPROACHING),
            worst_unfinished: (checker.left_approaching, seed),
            examples: if faults.is_empty() {
                Vec::new()
            } else {
                vec![(seed, format!("{}\n{file}", faults.join("\n")))]
            },
        }
    }

    /// The tally of a layout that is not a valid shot.
    pub fn refused() -> Self {
        Self { refused: 1, ..Self::default() }
    }

    /// The sum of two tallies.
    #[must_use]
    pub fn with(mut self, other: Self) -> Self {
        self.shots += other.shots;
        self.refused += other.refused;
        self.faulty += other.faulty;
        self.events += other.events;
        self.longest = self.longest.max(other.longest);
        self.deepest = self.deepest.max(other.deepest);
        self.widest = self.widest.max(other.widest);
        self.unfinished += other.unfinished;
        if other.worst_unfinished.0 > self.worst_unfinished.0 {
            self.worst_unfinished = other.worst_unfinished;
        }
        self.examples.extend(other.examples);
        self.examples.truncate(EXAMPLES);
        self
    }
}

impl fmt::Display for Tally {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{} shots ({} layouts refused), {} events, at most {} (seed {}); no overlap deeper \
             than {:.1e} m, widest contact gap {:.1e} m; {} with balls that still approach \
             after a network, at up to {:.1e} of the fastest (seed {}); {} faulty",
            self.shots,
            self.refused,
            self.events,
            self.longest.0,
            self.longest.1,
            self.deepest,
            self.widest,
            self.unfinished,
            self.worst_unfinished.0,
            self.worst_unfinished.1,
            self.faulty
        )
    }
}
