//! Studies: their reader, the judge of their tasks, and the check of their shots.

use carom::format::{Node, Reader};
use carom::{ErrorKind, Shot, Trace};
use carom_drill::study::{STUDY_SCHEMA, Study, TaskVerdict, goal_from_node, judge};

/// A chapter with a shot, two shots of a tree, and a task.
const STUDY: &str = r#"{
  "format": "carom-study/1", "title": "Two shots", "author": "A. N.", "language": "en",
  "chapters": [{
    "title": "Straight", "text": "First line.\nSecond line.",
    "shot": {"format": "carom-shot/1", "table": "wpa-9ft",
      "balls": [{"id": "cue", "position": [0.635, 0.8]}, {"id": "1", "position": [0.635, 1.6]}],
      "marks": [{"kind": "label", "color": "red", "at": [0.5, 0.5], "text": "here"}]},
    "tree": [
      {"strike": {"ball": "cue", "speed": 1.5, "azimuth_deg": 90}, "comment": "Full."},
      {"after": 0, "strike": {"ball": "cue", "speed": 1, "azimuth_deg": 270}}],
    "task": {"goal": [{"kind": "first", "ball": "1"}],
      "solution": {"ball": "cue", "speed": 1.5, "azimuth_deg": 90}}
  }]
}"#;

/// The study with one text in place of another.
fn changed(from: &str, to: &str) -> Result<Study, String> {
    assert!(STUDY.contains(from), "{from}");
    Study::from_json(&STUDY.replacen(from, to, 1)).map_err(|error| error.to_string())
}

#[test]
fn a_study_is_read_and_checked() {
    let study = Study::from_json(STUDY).unwrap();
    assert_eq!((study.title.as_str(), study.chapters.len()), ("Two shots", 1));
    let chapter = &study.chapters[0];
    assert_eq!(chapter.text, "First line.\nSecond line.");
    assert_eq!(chapter.tree[1].after, Some(0));
    assert_eq!(chapter.shot.marks().len(), 1);
    let reports = study.check();
    // The position has no strike of its own.
    assert_eq!((reports[0].shots, reports[0].solution), (3, Some(TaskVerdict::Met)));
    assert!(reports[0].faults.is_empty());
    assert_eq!(study.to_node(), &Node::from_json(STUDY).unwrap());
}

#[test]
fn an_error_names_the_chapter_and_the_place() {
    for (from, to, place) in [
        ("carom-study/1", "carom-study/2", "format: "),
        ("\"title\": \"Two shots\"", "\"titel\": \"x\"", "titel: "),
        ("\"title\": \"Two shots\"", "\"title\": \"a\\nb\"", "title: "),
        ("\"en\"", "\"en us\"", "language: "),
        ("\"Straight\"", "\"\"", "chapters[0].title: "),
        ("Second line.", "\\u0000", "chapters[0].text: "),
        ("[0.635, 1.6]", "[9, 9]", "chapters[0].shot.balls[1].position: "),
        ("\"wpa-9ft\",", "\"wpa-9ft\", \"max_events\": 100001,", "chapters[0].shot.max_events: "),
        ("\"after\": 0", "\"after\": 1", "chapters[0].tree[1].after: "),
        ("{\"strike\"", "{\"after\": 0, \"strike\"", "chapters[0].tree[0].after: "),
        ("\"Full.\"", "5", "chapters[0].tree[0].comment: "),
        (
            "\"first\", \"ball\": \"1\"",
            "\"first\", \"ball\": \"7\"",
            "chapters[0].task.goal[0].ball: ",
        ),
        ("\"first\", \"ball\": \"1\"", "\"hit\"", "chapters[0].task.goal[0].kind: "),
        (
            "\"first\", \"ball\": \"1\"",
            "\"kick\", \"cushions\": 0",
            "chapters[0].task.goal[0].cushions: ",
        ),
        (
            "\"first\", \"ball\": \"1\"",
            "\"pot\", \"ball\": \"1\", \"pocket\": \"middle\"",
            "chapters[0].task.goal[0].pocket: ",
        ),
        (
            "\"first\", \"ball\": \"1\"",
            "\"stop\", \"area\": {\"center\": [0, 0], \"radius\": 0}",
            "chapters[0].task.goal[0].area.radius: ",
        ),
        (
            "\"solution\": {\"ball\": \"cue\"",
            "\"solution\": {\"ball\": \"7\"",
            "chapters[0].task.solution",
        ),
    ] {
        let error = changed(from, to).unwrap_err();
        assert!(error.starts_with(place), "{error}\n  expected {place}");
    }
    let error = Study::from_json("{\"format\": \"carom-shot/1\"}").unwrap_err().to_string();
    assert!(error.contains("the file is a shot"), "{error}");
}

#[test]
fn a_study_has_bounds() {
    let chapter = r#"{"title": "x", "shot": {"format": "carom-shot/1", "table": "wpa-9ft",
        "balls": [{"id": "cue", "position": [0.6, 0.6]}]}}"#;
    let of = |count: usize| {
        let chapters = vec![chapter; count].join(",");
        Study::from_json(&format!(
            r#"{{"format": "carom-study/1", "title": "x", "chapters": [{chapters}]}}"#
        ))
    };
    assert_eq!(of(200).unwrap().chapters.len(), 200);
    for count in [0, 201] {
        assert_eq!(of(count).unwrap_err().kind(), ErrorKind::WrongCount);
    }
    let long = changed("Second line.", &"x".repeat(4001)).unwrap_err();
    assert!(long.starts_with("chapters[0].text: found 4013 characters"), "{long}");
    let shots: Vec<String> = (0..501)
        .map(|k| {
            format!(r#"{{"strike": {{"ball": "cue", "speed": {}, "azimuth_deg": 0}}}}"#, k + 1)
        })
        .collect();
    let many = changed("\"tree\": [", &format!("\"tree\": [{},", shots.join(","))).unwrap_err();
    assert!(many.starts_with("chapters[0].tree: found a list of 503"), "{many}");
    let twice = r#"{"strike": {"ball": "cue", "speed": 1.5, "azimuth_deg": 90}},"#;
    let twice = changed("\"tree\": [", &format!("\"tree\": [{twice}")).unwrap_err();
    assert!(twice.starts_with("chapters[0].tree[1]: the same shot"), "{twice}");
    let huge = Study::from_json(&" ".repeat(4_000_001)).unwrap_err();
    assert_eq!(huge.kind(), ErrorKind::WrongCount);
    let deep = format!("{}1{}", "[".repeat(100_000), "]".repeat(100_000));
    assert_eq!(Study::from_json(&deep).unwrap_err().kind(), ErrorKind::Syntax);
}

#[test]
fn shots_that_cannot_be_played_and_wrong_solutions_are_reported_with_their_places() {
    let faults = |from: &str, to: &str| -> Vec<String> {
        changed(from, to).unwrap().check()[0].faults.iter().map(ToString::to_string).collect()
    };
    let gone = faults(
        "\"after\": 0, \"strike\": {\"ball\": \"cue\"",
        "\"after\": 0, \"strike\": {\"ball\": \"8\"",
    );
    assert!(gone[0].starts_with("chapters[0].tree[1].strike.ball: "), "{gone:?}");
    let wrong = faults("[{\"kind\": \"first\", \"ball\": \"1\"}]", "[{\"kind\": \"pot-any\"}]");
    assert!(
        wrong[0].starts_with("chapters[0].task.solution: it does not meet goal[0]"),
        "{wrong:?}"
    );
    let area = "[{\"kind\": \"stop\", \"ball\": \"1\", \"area\": {\"center\": [0.1, 0.1], \"radius\": 0.01}}]";
    let outside = faults("[{\"kind\": \"first\", \"ball\": \"1\"}]", area);
    assert!(outside[0].contains("m outside the area"), "{outside:?}");
    // The shot after one that cannot be played.
    let both =
        faults("\"speed\": 1.5, \"azimuth_deg\": 90}, \"comment\"", "\"speed\": 1e9}, \"comment\"");
    assert_eq!(both.len(), 2, "{both:?}");
    assert!(
        both[1].starts_with("chapters[0].tree[1].after: no shot can follow tree[0]"),
        "{both:?}"
    );
}

/// The trace of a shot on a table, and the verdicts on goals about it.
fn verdicts(table: &str, balls: &str, strike: &str, goals: &[(&str, bool)]) -> Trace {
    let file = format!(
        r#"{{"format": "carom-shot/1", "table": "{table}", "balls": {balls}, "strike": {strike}}}"#
    );
    let shot = Shot::from_node(&Node::from_json(&file).unwrap()).unwrap();
    let trace = shot.simulate().unwrap();
    for (goal, met) in goals {
        let node = Node::from_json(&format!("[{goal}]")).unwrap();
        let goal_read = goal_from_node(&Reader::new(&node, "goal"), &shot).unwrap();
        assert_eq!(
            judge(&trace, &goal_read).unwrap() == TaskVerdict::Met,
            *met,
            "{goal}: {:?}",
            trace.outcome()
        );
    }
    trace
}

#[test]
fn every_condition_is_met_and_missed() {
    let straight = r#"[{"id": "cue", "position": [1.0, 2.2]}, {"id": "1", "position": [1.1, 2.33]},
        {"id": "2", "position": [0.4, 0.4]}]"#;
    // To the top right corner, and the cue ball stays behind.
    verdicts(
        "wpa-9ft",
        straight,
        r#"{"ball": "cue", "speed": 1.6, "azimuth_deg": 51.5, "height": -0.2}"#,
        &[
            (r#"{"kind": "pot", "ball": "1"}"#, true),
            (r#"{"kind": "pot", "ball": "1", "pocket": "top-right"}"#, true),
            (r#"{"kind": "pot", "ball": "1", "pocket": "left"}"#, false),
            (r#"{"kind": "pot", "ball": "2"}"#, false),
            (r#"{"kind": "pot-any"}"#, true),
            (r#"{"kind": "first", "ball": "1"}"#, true),
            (r#"{"kind": "first", "ball": "2"}"#, false),
            (r#"{"kind": "carom", "cushions": 0}"#, false),
            (r#"{"kind": "kick", "cushions": 1}"#, false),
            (r#"{"kind": "stop", "area": {"center": [1.05, 2.28], "radius": 0.3}}"#, true),
            (r#"{"kind": "stop", "area": {"outline": [[0, 0], [0.2, 0], [0, 0.2]]}}"#, false),
            (
                r#"{"kind": "stop", "ball": "1", "area": {"center": [1.1, 2.33], "radius": 3}}"#,
                false,
            ),
            (
                r#"{"kind": "stop", "ball": "2", "area": {"center": [0.4, 0.4], "radius": 0.01}}"#,
                true,
            ),
            (r#"{"kind": "hidden", "ball": "2"}"#, false),
            (r#"{"kind": "hidden", "ball": "1"}"#, false),
        ],
    );
    // By the right cushion to the yellow, and on to nothing.
    verdicts(
        "carom-10ft",
        r#"[{"id": "white", "position": [0.4, 0.8]}, {"id": "yellow", "position": [1.0, 2.0]},
            {"id": "red", "position": [0.726, 1.98]}]"#,
        r#"{"ball": "white", "speed": 2.4, "azimuth_deg": 40, "height": 0.2}"#,
        &[
            (r#"{"kind": "kick", "cushions": 1}"#, true),
            (r#"{"kind": "kick", "cushions": 2}"#, false),
            (r#"{"kind": "carom", "cushions": 1}"#, true),
            (r#"{"kind": "carom", "cushions": 3}"#, false),
            (r#"{"kind": "cushions", "ball": "white", "cushions": 1}"#, true),
            (r#"{"kind": "cushions", "ball": "red", "cushions": 9}"#, false),
        ],
    );
    // The 8 stays between the cue ball and the 1.
    verdicts(
        "wpa-9ft",
        r#"[{"id": "cue", "position": [0.635, 0.4]}, {"id": "1", "position": [0.635, 2.0]},
            {"id": "8", "position": [0.635, 0.7]}]"#,
        r#"{"ball": "cue", "speed": 0.1, "azimuth_deg": 90}"#,
        &[
            (r#"{"kind": "hidden", "ball": "1"}"#, true),
            (r#"{"kind": "hidden", "ball": "8"}"#, false),
        ],
    );
}

#[test]
fn a_shot_that_loses_the_cue_ball_meets_no_goal() {
    let trace = verdicts(
        "wpa-9ft",
        r#"[{"id": "cue", "position": [1.0, 2.27]}]"#,
        r#"{"ball": "cue", "speed": 1.0, "azimuth_deg": 45}"#,
        &[(r#"{"kind": "cushions", "ball": "cue", "cushions": 1}"#, false)],
    );
    assert!(trace.outcome().cue_ball_scratched());
    let verdict = judge(&trace, &[]).unwrap();
    assert_eq!(verdict, TaskVerdict::CueBallLost);
    assert_eq!(verdict.to_node().get("fault"), Some(&Node::from("cue-ball-lost")));
}

#[test]
fn the_example_studies_solve_their_tasks() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../studies");
    let mut files = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|extension| extension != "json") {
            continue;
        }
        files += 1;
        let study = Study::from_json(&std::fs::read_to_string(&path).unwrap()).unwrap();
        assert_eq!(study.chapters.len(), 20, "{path:?}");
        for report in study.check() {
            assert_eq!(report.solution, Some(TaskVerdict::Met), "{path:?}: {}", report.title);
            assert!(report.faults.is_empty(), "{path:?}: {:?}", report.faults);
        }
    }
    assert_eq!(files, 3);
}

#[test]
fn the_schema_is_json() {
    let schema = Node::from_json(STUDY_SCHEMA).unwrap();
    assert_eq!(schema.get("title"), Some(&Node::from("carom-study/1")));
}
