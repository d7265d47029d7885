//! Candidates: many variants of shots, each with its own physics, strike and start states.

use alloc::borrow::Cow;
use alloc::format;
use alloc::vec::Vec;

use crate::error::{Error, ErrorKind};
use crate::format::PhysicsNumber;
use crate::physics::Physics;
use crate::resolve::cue_ball::Strike;
use crate::shot::{Changes, Shot, StartState};

/// What the candidates have in place of what their shots have. A part that is `None` or empty stays
/// that of the shot.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Variation {
    /// Numbers of the physics that differ.
    pub numbers: Vec<PhysicsNumber>,
    /// Their values: one for each of `numbers`, candidate by candidate.
    pub values: Vec<f64>,
    /// A start state for each ball, candidate by candidate.
    pub states: Option<Vec<StartState>>,
    /// A strike on the shot's struck ball for each candidate.
    pub strikes: Option<Vec<Strike>>,
    /// Whether the elevation of each strike is the default, if that of the shot is the default.
    pub default_elevation: bool,
}

/// Variants of one or more shots. A candidate is checked as a shot file when it is used, and its error
/// does not concern the others.
#[derive(Clone, Debug)]
pub struct Candidates {
    shots: Vec<Shot>,
    /// Index of each candidate's shot.
    shot_of: Vec<u32>,
    variation: Variation,
    /// Balls of the largest shot.
    balls: usize,
}

impl Candidates {
    /// Candidate k is `shots[shot_of[k]]` with row k of `variation`.
    ///
    /// # Errors
    /// [`Error::Input`] if a part of `variation` has another length than the candidates need, if an
    /// index of `shot_of` has no shot, and if start states are given for shots whose numbers of balls
    /// differ.
    pub fn new(shots: Vec<Shot>, shot_of: Vec<u32>, variation: Variation) -> Result<Self, Error> {
        let count = shot_of.len();
        let balls = shots.iter().map(|shot| shot.balls().len()).max().unwrap_or(0);
        if let Some(k) = shot_of.iter().position(|&s| s as usize >= shots.len()) {
            let what = format!("there is no shot {}", shot_of[k]);
            let remedy = format!("count the {} shots from 0", shots.len());
            return Err(ErrorKind::OutOfRange.at(format!("shot_of[{k}]"), what, remedy));
        }
        if variation.states.is_some() && shots.iter().any(|shot| shot.balls().len() != balls) {
            let what = "start states for shots with different numbers of balls";
            let remedy = "make candidates of each of these shots by themselves";
            return Err(ErrorKind::WrongCount.at("states", what, remedy));
        }
        let wanted = variation.numbers.len() * count;
        check_length("values", variation.values.len(), wanted)?;
        if let Some(states) = &variation.states {
            check_length("states", states.len(), balls * count)?;
        }
        if let Some(strikes) = &variation.strikes {
            check_length("strikes", strikes.len(), count)?;
        }
        Ok(Self { shots, shot_of, variation, balls })
    }

    /// Candidates that are shots as they are.
    pub fn of_shots(shots: Vec<Shot>) -> Self {
        let shot_of = (0..shots.len() as u32).collect();
        let balls = shots.iter().map(|shot| shot.balls().len()).max().unwrap_or(0);
        Self { shots, shot_of, variation: Variation::default(), balls }
    }

    /// Candidates `first` up to but not including `end`, of the same shots.
    ///
    /// # Panics
    /// If there are fewer candidates.
    #[must_use]
    pub fn part(&self, first: usize, end: usize) -> Self {
        let Variation { numbers, values, states, strikes, default_elevation } = &self.variation;
        let states = states.as_ref().map(|s| s[first * self.balls..end * self.balls].to_vec());
        let variation = Variation {
            numbers: numbers.clone(),
            values: values[first * numbers.len()..end * numbers.len()].to_vec(),
            states,
            strikes: strikes.as_ref().map(|strikes| strikes[first..end].to_vec()),
            default_elevation: *default_elevation,
        };
        let shot_of = self.shot_of[first..end].to_vec();
        Self { shots: self.shots.clone(), shot_of, variation, balls: self.balls }
    }

    /// Number of candidates.
    pub fn len(&self) -> usize {
        self.shot_of.len()
    }

    /// Whether there is no candidate.
    pub fn is_empty(&self) -> bool {
        self.shot_of.is_empty()
    }

    /// The shots that the candidates are variants of.
    pub fn shots(&self) -> &[Shot] {
        &self.shots
    }

    /// Index, in [`Self::shots`], of the shot of candidate `k`.
    pub fn shot_of(&self, k: usize) -> usize {
        self.shot_of[k] as usize
    }

    /// Balls of the largest shot.
    pub const fn balls(&self) -> usize {
        self.balls
    }

    /// Candidate `k` as a shot. It simulates to the bits of the candidate.
    ///
    /// # Errors
    /// [`Error::Input`] for everything for which a shot file would be refused; numbers of the physics
    /// are at `physics.<key>`.
    ///
    /// # Panics
    /// If there is no candidate `k`.
    pub fn shot(&self, k: usize) -> Result<Cow<'_, Shot>, Error> {
        let shot = &self.shots[self.shot_of(k)];
        let Variation { numbers, values, states, strikes, default_elevation } = &self.variation;
        let strike = strikes.as_ref().map(|strikes| strikes[k]);
        if numbers.is_empty() && states.is_none() && strike.is_none() {
            return Ok(Cow::Borrowed(shot));
        }
        let row = &values[k * numbers.len()..(k + 1) * numbers.len()];
        let set = |physics: &mut Physics| {
            let pairs: Vec<_> = numbers.iter().copied().zip(row.iter().copied()).collect();
            physics.set_numbers(&pairs)
        };
        let changes = Changes {
            physics: (!numbers.is_empty()).then_some(set),
            states: states.as_ref().map(|s| &s[k * self.balls..(k + 1) * self.balls]),
            strike,
            default_elevation: strike.is_none() || *default_elevation,
        };
        shot.varied(changes).map(Cow::Owned)
    }
}

fn check_length(place: &str, found: usize, wanted: usize) -> Result<(), Error> {
    if found == wanted {
        return Ok(());
    }
    let what = format!("found {found} entries");
    let remedy = format!("give {wanted}, one for each candidate and each of its numbers or balls");
    Err(ErrorKind::WrongCount.at(place, what, remedy).with("count", found as f64))
}
