//! A match in its folder, while its pairs are played.

use std::path::{Path, PathBuf};

use carom::{Error, ErrorKind};

use crate::error::ArenaError;
use crate::ledger::{Ledger, RECORD};
use crate::pair::{MatchPlan, PlayedPair};
use crate::record::MatchHeader;
use crate::score::MatchScore;
use crate::secret::Secret;
use crate::sequential::{SequentialTest, TestState};

/// What a match has come to.
#[derive(Clone, Debug)]
pub struct MatchReport {
    /// The record, if the match is finished.
    pub record: Option<PathBuf>,
    /// The score of the first pairs that were played without a gap; of all if it is finished.
    pub score: MatchScore,
    /// The state of the test after these pairs.
    pub test: Option<TestState>,
    /// Number of these pairs.
    pub pairs: u64,
    /// SHA-256 of the secret.
    pub secret_sha256: String,
}

/// A match that is being played: it gives out the numbers of pairs, which may be played anywhere, and
/// writes those that come back to its folder. The folder is locked meanwhile.
pub struct OpenMatch {
    plan: MatchPlan,
    folder: PathBuf,
    secret: Secret,
    ledger: Ledger,
    score: MatchScore,
    test: Option<TestState>,
    /// Number of pairs in the score.
    counted: u64,
    /// Number of pairs of the match, once it is known that no more are needed.
    end: Option<u64>,
    /// The next pair to give out.
    next: u64,
}

impl OpenMatch {
    /// Begins the match of `plan` in `folder`, or continues it.
    ///
    /// # Errors
    /// [`ArenaError::Input`] for a plan out of range, and for a folder with another match or a damaged
    /// file; [`ArenaError::File`] if a file cannot be read or written.
    pub fn open(plan: &MatchPlan, folder: &Path) -> Result<Self, ArenaError> {
        if plan.pairs == 0 || plan.pairs > MOST_PAIRS {
            let what = format!("{} is out of range", plan.pairs);
            let remedy = format!("write a whole number from 1 to {MOST_PAIRS}");
            return Err(ErrorKind::OutOfRange.at("pairs", what, remedy).into());
        }
        plan.test.as_ref().map_or(Ok(()), SequentialTest::check)?;
        let secret = match (plan.secret, Ledger::secret_in(folder)?) {
            (Some(secret), _) | (None, Some(secret)) => secret,
            (None, None) => new_secret()?,
        };
        let header = MatchHeader::new(plan.of.clone(), plan.pairs, plan.test, secret.sha256());
        let ledger = Ledger::open(folder, secret, &header.to_node())?;
        let mut open = Self {
            plan: plan.clone(),
            folder: folder.into(),
            secret,
            ledger,
            score: MatchScore::default(),
            test: None,
            counted: 0,
            end: None,
            next: 0,
        };
        open.count();
        Ok(open)
    }

    /// The secret with which the pairs are played.
    pub const fn secret(&self) -> &Secret {
        &self.secret
    }

    /// Number of pairs that were played.
    pub fn played(&self) -> u64 {
        self.ledger.len()
    }

    /// The number of the next pair to play; `None` if no more are needed. Every number is given out
    /// once.
    pub fn next_pair(&mut self) -> Option<u64> {
        while self.end.is_none() && self.next < self.plan.pairs {
            let pair = self.next;
            self.next += 1;
            if self.ledger.points(pair).is_none() {
                return Some(pair);
            }
        }
        None
    }

    /// Writes a pair that was played to the folder.
    ///
    /// # Errors
    /// [`ArenaError::File`] if the file cannot be written.
    pub fn add(&mut self, pair: &PlayedPair) -> Result<(), ArenaError> {
        self.ledger.add(pair)?;
        self.count();
        Ok(())
    }

    /// Counts the pairs that follow the counted ones without a gap. The test looks at the pairs in
    /// their order, so its end does not depend on which pair was finished first.
    fn count(&mut self) {
        let of_record = self.ledger.finished().map(|pairs| pairs.len() as u64);
        let most = of_record.unwrap_or(self.plan.pairs);
        while self.end.is_none() {
            if let Some(test) = &self.plan.test {
                let state = test.state(&self.score.pairs);
                self.test = Some(state);
                if state.accepted.is_some() {
                    self.end = Some(self.counted);
                    break;
                }
            }
            if self.counted == most {
                self.end = Some(most);
                break;
            }
            let Some(points) = self.ledger.points(self.counted) else { break };
            self.score.add(&points);
            self.counted += 1;
        }
    }

    /// What the match has come to. If no more pairs are needed, its record is written.
    ///
    /// # Errors
    /// [`ArenaError::File`] if a file cannot be written.
    pub fn close(mut self) -> Result<MatchReport, ArenaError> {
        if let Some(end) = self.end {
            self.ledger.finish(end)?;
        }
        Ok(MatchReport {
            record: self.end.map(|_| self.folder.join(RECORD)),
            score: self.score,
            test: self.test,
            pairs: self.counted,
            secret_sha256: self.secret.sha256(),
        })
    }
}

/// Largest number of pairs: a thousand times the largest published match.
const MOST_PAIRS: u64 = 1_000_000;

#[cfg(feature = "os-secret")]
fn new_secret() -> Result<Secret, Error> {
    Secret::from_os()
}

#[cfg(not(feature = "os-secret"))]
fn new_secret() -> Result<Secret, Error> {
    Err(ErrorKind::Missing.at("secret", "it is missing", "give one; this build cannot draw one"))
}
