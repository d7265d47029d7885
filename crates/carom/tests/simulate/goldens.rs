//! Every example shot gives the same bits as ever, in whatever build this is.

use std::fs;
use std::path::Path;

use carom::Shot;

#[test]
fn every_example_shot_has_the_event_count_and_the_hash_of_its_golden() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let goldens = fs::read_to_string(root.join("goldens/shots.txt")).expect("goldens/shots.txt");
    assert!(goldens.lines().count() >= 10);
    for line in goldens.lines() {
        let name = line.split(' ').next().expect("a name");
        let file = fs::read_to_string(root.join(format!("shots/{name}.json"))).expect(name);
        let shot = Shot::from_json(&file).expect(name);
        let trace = shot.simulate().expect(name);
        let ours = format!("{name} {} {:016x}", trace.events().len(), trace.hash());
        assert_eq!(ours, line, "see goldens/README.md");
    }
}
