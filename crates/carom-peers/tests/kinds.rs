//! The kinds of impacts and searches whose operations are counted.

use std::collections::BTreeSet;

use carom_peers::kinds::{self, INPUTS};

#[test]
fn every_kind_has_its_own_name_and_enough_inputs_and_runs() {
    let kinds = kinds::all();
    let names: BTreeSet<_> = kinds.iter().map(|kind| (kind.group, kind.name.clone())).collect();
    assert_eq!(names.len(), kinds.len(), "two kinds have one name");
    for kind in &kinds {
        // Balls on a rail's top are rare; networks have few inputs, because each takes long.
        assert!(kind.inputs >= INPUTS / 24, "{}, {}: {}", kind.group, kind.name, kind.inputs);
        kind.counted_pass();
    }
    let groups: BTreeSet<_> = kinds.iter().map(|kind| kind.group).collect();
    let expected = [
        "impact: ball and ball",
        "impact: ball and cushion",
        "impact: ball and edge",
        "impact: ball and slate",
        "impact: cue and ball",
        "impact: network",
        "motion",
        "search: ball in the air and table",
        "search: ball on a rail's top",
        "search: ball on the cloth and table",
        "search: two balls",
    ];
    assert_eq!(groups.into_iter().collect::<Vec<_>>(), expected);
}
