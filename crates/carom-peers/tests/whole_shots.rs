//! A few whole shots with each finder in the event loop. `validation/leckie_greenspan_2006` stores
//! the counts of 100 000.

use carom_check::FaultKind;
use carom_peers::operations::{EVENT_KINDS, Operations};
use carom_peers::whole_shots::{Contestant, FaultCounts, RootRule, ShotSource};

/// Shots per finder. The shots, and so the counts below, are the same in each run.
const SHOTS: u64 = 500;

fn checked(method: &str, rule: RootRule, source: ShotSource) -> FaultCounts {
    let found = |c: &&Contestant| c.method == method && c.rule == rule;
    Contestant::ALL.iter().find(found).expect("a contestant").check(source, 0..SHOTS)
}

#[test]
fn the_engines_finder_gives_no_impossible_shot() {
    for source in [ShotSource::Ordinary, ShotSource::Frozen] {
        let counts = checked("carom", RootRule::FirstContact, source);
        assert_eq!(counts, FaultCounts { shots: SHOTS, ..FaultCounts::default() });
    }
}

#[test]
fn the_textbook_closed_form_lets_balls_pass_through_each_other() {
    let counts = checked("textbook closed form", RootRule::Approaching, ShotSource::Ordinary);
    let [_, micrometre, _] = counts.impossible();
    assert!(micrometre > 0 && counts.of_kind(1, FaultKind::Overlap) > 0, "{counts:?}");
}

#[test]
fn accurate_approaching_roots_give_ordinary_shots_without_visible_faults() {
    for method in ["companion matrix", "Algorithm 1010"] {
        let [_, micrometre, _] =
            checked(method, RootRule::Approaching, ShotSource::Ordinary).impossible();
        assert_eq!(micrometre, 0, "{method}");
    }
}

#[test]
fn accurate_roots_that_leave_out_the_start_miss_contacts_of_frozen_balls() {
    let without = checked("Algorithm 1010", RootRule::Approaching, ShotSource::Frozen);
    let with = checked("Algorithm 1010", RootRule::FromTheStart, ShotSource::Frozen);
    let [without, with] = [without, with].map(|counts| counts.impossible()[1]);
    assert!(without > 10 * (1 + with), "{without} without, {with} with");
}

#[test]
fn shots_checked_in_parts_have_the_faults_of_all_together() {
    let ferrari =
        |c: &&Contestant| c.method == "textbook closed form" && c.rule == RootRule::Approaching;
    let finder = Contestant::ALL.iter().find(ferrari).expect("a contestant");
    let parts = [0..150, 150..300].map(|part| finder.check(ShotSource::Ordinary, part));
    let whole = finder.check(ShotSource::Ordinary, 0..300);
    for (tolerance, impossible) in whole.impossible().into_iter().enumerate() {
        assert_eq!(parts.iter().map(|p| p.impossible()[tolerance]).sum::<u64>(), impossible);
    }
    assert!(whole.impossible()[0] > 0 && parts.iter().all(|p| p.shots == 150));
}

#[test]
fn the_engine_solves_few_of_the_papers_quartics() {
    let shot = include_str!("../../../shots/eight_ball_break.json");
    let shot = carom::Shot::from_json(shot).expect("a shot of the project");
    let counts = Operations::of(&shot).expect("a shot that ends");
    assert!(counts.solved < counts.looked_at && counts.looked_at < counts.pairs, "{counts:?}");
    assert!(10 * counts.of_the_engine() < counts.of_the_paper(), "{counts:?}");
}

#[test]
fn every_event_of_a_shot_has_one_kind() {
    let shot = include_str!("../../../shots/jump_shot.json");
    let shot = carom::Shot::from_json(shot).expect("a shot of the project");
    let counts = Operations::of(&shot).expect("a shot that ends");
    assert_eq!(counts.by_kind.iter().sum::<u64>(), counts.events, "{counts:?}");
    let place = |name| EVENT_KINDS.iter().position(|k| *k == name).expect("a kind");
    assert_eq!(counts.by_kind[place("cue strike")], 1);
    assert!(counts.by_kind[place("slate or lip")] > 0 && counts.searched_off_bed > 0, "{counts:?}");
}
