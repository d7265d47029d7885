//! The list of recommended plays: it has every play that promises more than one of its own, and has another aim.
//!
//! The plays of a list are chosen by the samples of the races, which are few where the budget is small, and sorted by
//! fresh samples. So a listed play may turn out to be worse than one that was left out.

use carom::Error;

use super::candidate::Candidate;
use super::race::Race;
use super::rounds::{Found, ShotSearch};

/// Whether two plays have the same aim.
fn have_one_aim(a: &Candidate, b: &Candidate) -> bool {
    a.aim() == b.aim()
}

/// The first of the plays from number `first` on that promises more than the worst of the `stated` before. Variants of
/// an aim that was tried do not count: they would take the place of other aims.
fn promising(candidates: &[Candidate], stated: usize, first: usize) -> Option<usize> {
    let worst = candidates[..stated].last()?.stated_win();
    let (known, rest) = candidates.split_at(first);
    let is_new = |candidate: &Candidate| !known.iter().any(|other| have_one_aim(candidate, other));
    rest.iter()
        .position(|candidate| candidate.mean() > worst && is_new(candidate))
        .map(|k| first + k)
}

impl Race<'_> {
    /// Orders the first `stated` of `candidates`, which have `fresh` samples each, and the others that promise more than
    /// one of these: they get fresh samples too. Returns the number of samples. In the end the first `stated` are the
    /// best ones.
    ///
    /// # Errors
    /// As [`carom_plan::Sampler::simulate_variant`].
    fn complete(
        &self,
        candidates: &mut [Candidate],
        stated: usize,
        fresh: u64,
    ) -> Result<u64, Error> {
        let (mut spent, mut first) = (0, stated);
        loop {
            candidates[..first].sort_by(|a, b| b.stated_win().total_cmp(&a.stated_win()));
            let Some(k) = promising(candidates, stated, first) else { return Ok(spent) };
            candidates[first..=k].rotate_right(1);
            spent += self.freshen(&mut candidates[first..=first], fresh)?;
            first += 1;
        }
    }
}

impl ShotSearch<'_> {
    /// The list of the plays that the rounds have found, the best first: at most as many as are stated, all of them with
    /// fresh samples.
    ///
    /// # Errors
    /// As [`Self::play_round`].
    pub(crate) fn listed(mut self) -> Result<Found, Error> {
        self.name_plays()?;
        let Found { mut candidates, mut spent } = self.found()?;
        let stated = candidates.iter().take_while(|candidate| !candidate.fresh.is_empty()).count();
        if let Some(best) = candidates.first() {
            let fresh = best.fresh.len() as u64;
            let prepared = self.prepared()?;
            spent.simulations += self.race(&prepared).complete(&mut candidates, stated, fresh)?;
        }
        Ok(Found { candidates, spent })
    }
}

#[cfg(test)]
mod tests {
    use carom::Noise;
    use carom_rules::{Frame, Game, Options};

    use super::*;
    use crate::player::{Budget, Situation};
    use crate::searcher::Searcher;

    /// Positions of eight-ball on an open table: the cue ball, three solids, the eight and two stripes.
    const OPEN: [[[f64; 2]; 7]; 3] = [
        [
            [0.62, 1.31],
            [0.21, 0.43],
            [1.02, 1.88],
            [0.71, 2.21],
            [0.33, 1.92],
            [0.94, 0.51],
            [0.5, 0.8],
        ],
        [
            [0.31, 0.82],
            [0.92, 0.33],
            [0.55, 1.71],
            [1.08, 1.35],
            [0.19, 2.28],
            [0.77, 1.02],
            [0.9, 2.2],
        ],
        [
            [0.97, 2.11],
            [0.44, 0.25],
            [0.64, 1.57],
            [0.16, 1.12],
            [1.12, 0.77],
            [0.28, 2.02],
            [0.7, 0.4],
        ],
    ];

    #[test]
    fn no_play_that_a_short_search_has_seen_promises_more_than_a_listed_one() {
        const STATED: usize = 4;
        let mut overtaken = 0;
        for places in OPEN {
            let mut frame =
                Frame::new(Game::EightBall, Options::default(), None, None, 0).expect("a frame");
            let mut all = vec![None; frame.layout().len()];
            for (ball, place) in [0, 1, 2, 3, 8, 9, 10].into_iter().zip(places) {
                all[ball] = Some(place);
            }
            frame.resume_at(&all, 0).expect("a position");
            let situation = Situation::new(&frame, Noise::olympiad(1.5), 1);
            for simulations in [300, 600, 1000] {
                let budget = Budget::simulations(simulations);
                let player = Searcher::default();
                let mut search = player.search(&situation, &budget, STATED).expect("a search");
                while search.play_round().expect("a round") {}
                let found = search.listed().expect("a list").candidates;
                let story = format!("{places:?} with {simulations} simulations");
                assert!(found.len() > STATED, "{story}");
                let (listed, others) = found.split_at(STATED);
                let worst = listed[STATED - 1].stated_win();
                assert!(listed.iter().all(|play| play.stated_win() >= worst), "{story}");
                for other in others {
                    let is_tried = !other.fresh.is_empty();
                    overtaken += usize::from(is_tried);
                    let tried = found.iter().filter(|play| !play.fresh.is_empty());
                    let is_variant =
                        !is_tried && tried.clone().any(|play| have_one_aim(play, other));
                    assert!(is_variant || other.stated_win() <= worst, "{story}: {other:?}");
                }
            }
        }
        assert!(overtaken > 0, "no list had a play that was worse than it promised");
    }
}
