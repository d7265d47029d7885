//! Whole shots with each finder in the event loop, a few; `validation/leckie_greenspan_2006` stores
//! the counts of 100 000.

use carom_peers::operations::Operations;
use carom_peers::whole_shots::{Contestant, FaultCounts, Reading, ShotSource};

/// Shots per finder. Every count below is of these very shots, so it is the same in each run.
const SHOTS: u64 = 500;

fn judged(method: &str, reading: Reading, family: ShotSource) -> FaultCounts {
    let found = |c: &&Contestant| c.method == method && c.reading == reading;
    Contestant::ALL.iter().find(found).expect("a contestant").judge(family, SHOTS)
}

#[test]
fn with_the_engines_finder_no_shot_is_impossible() {
    for family in [ShotSource::Ordinary, ShotSource::Frozen] {
        let verdicts = judged("carom", Reading::FirstContact, family);
        assert_eq!(verdicts, FaultCounts { shots: SHOTS, ..FaultCounts::default() });
    }
}

#[test]
fn the_textbook_closed_form_lets_balls_through_each_other() {
    let verdicts = judged("textbook closed form", Reading::Approaching, ShotSource::Ordinary);
    let [_, micrometre, _] = verdicts.impossible;
    assert!(micrometre > 0 && verdicts.overlap > 0, "{verdicts:?}");
}

#[test]
fn sound_roots_read_with_care_give_ordinary_shots_without_visible_faults() {
    for method in ["companion matrix", "Algorithm 1010"] {
        let [_, micrometre, _] =
            judged(method, Reading::Approaching, ShotSource::Ordinary).impossible;
        assert_eq!(micrometre, 0, "{method}");
    }
}

#[test]
fn sound_roots_read_without_the_start_lose_contacts_of_frozen_balls() {
    let without = judged("Algorithm 1010", Reading::Approaching, ShotSource::Frozen);
    let with = judged("Algorithm 1010", Reading::FromTheStart, ShotSource::Frozen);
    assert!(without.impossible[1] > 10 * (1 + with.impossible[1]), "{without:?}, {with:?}");
}

#[test]
fn the_engine_solves_few_of_the_quartics_that_the_paper_would() {
    let shot = include_str!("../../../shots/eight_ball_break.json");
    let shot = carom::Shot::from_json(shot).expect("a shot of the project");
    let counts = Operations::of(&shot).expect("a shot that ends");
    assert!(counts.solved < counts.looked_at && counts.looked_at < counts.pairs, "{counts:?}");
    assert!(10 * counts.of_the_engine() < counts.of_the_paper(), "{counts:?}");
}
