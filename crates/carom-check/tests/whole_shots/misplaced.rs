//! Shots in which the checker once found an impossible event. In most of them the engine was wrong,
//! in some the checker.

use carom::Shot;
use carom_check::CheckRecorder;

/// A table of 1.25 m by 2.5 m with pockets, and one of 1.25 m by 1.25 m without.
const POOL: &str = r#"{"base": "wpa-9ft", "width": 1.25, "length": 2.5}"#;
const SQUARE: &str = r#"{"width": 1.25, "length": 1.25}"#;

/// Checks a shot of `balls` on `table` with its own physics, except for the model `cushion`.
fn assert_no_faults(table: &str, cushion: &str, balls: &str) {
    let file = format!(
        r#"{{"format": "carom-shot/1", "table": {table}, "balls": {balls},
            "physics": {{"cushion": {{"model": "{cushion}"}}}}}}"#
    );
    let shot = Shot::from_json(&file).unwrap_or_else(|e| panic!("{e}"));
    let checker = CheckRecorder::run(&shot);
    assert!(checker.events > 0);
    assert!(checker.faults.is_empty(), "{:#?}", checker.faults);
}

/// Seen: two balls fly over a rail; one leaves the table, and 0.9 ms later the other collides with
/// it. Expected: a ball off the table has no contacts. Cause: contacts were predicted with every
/// ball.
#[test]
fn a_ball_off_the_table_has_no_collisions() {
    assert_no_faults(
        SQUARE,
        "stronge",
        r#"[{"id": "a", "position": [0.4, 0.5, 0.27], "velocity": [1.3, 6, -3]},
            {"id": "b", "position": [0.4, 1.08, 0.3], "velocity": [3, 4, -2]}]"#,
    );
}

/// Seen: a ball collides with a pocketed ball. Expected and cause: as above.
#[test]
fn a_pocketed_ball_has_no_collisions() {
    assert_no_faults(
        POOL,
        "mathavan-2010",
        r#"[{"id": "a", "position": [1, 0.4], "velocity": [-4.4, 0.3, 0],
             "angular_velocity": [42, 78, -73]},
            {"id": "b", "position": [0.3, 0.8], "velocity": [5.7, 5, 0],
             "angular_velocity": [-101, 70, -74]}]"#,
    );
}

/// Seen: a ball falls almost vertically on the top of another, and the lower one then moves into
/// the slate at 0.2 mm/s. Expected: the slate stops that motion. Cause: the velocity on the cloth
/// was not kept horizontal.
#[test]
fn a_ball_pressed_from_above_slides_horizontally() {
    assert_no_faults(
        r#"{"cloth": "unbounded"}"#,
        "stronge",
        r#"[{"id": "a", "position": [0.19, -0.418, 0.206], "velocity": [0, 0, -0.96],
             "angular_velocity": [44, 68, 114]},
            {"id": "b", "position": [0.328, -0.409], "angular_velocity": [120, -89, -104]}]"#,
    );
}

/// Seen: a ball that falls along the liner of a hole moves on into it at 1 mm/s, until the limit of
/// events. Expected: it leaves the liner. Cause: the liner's inclined and its vertical part acted
/// one after the other.
#[test]
fn a_ball_that_falls_along_the_wall_of_a_hole_leaves_it() {
    assert_no_faults(
        POOL,
        "han-2005",
        r#"[{"id": "a", "position": [0.136, 0.171, 0.098], "velocity": [-0.43, -0.45, -1.1],
             "angular_velocity": [49, -94, 25]}]"#,
    );
    assert_no_faults(
        POOL,
        "restitution",
        r#"[{"id": "a", "position": [0.108, 1.379, 0.052], "velocity": [-0.27, -0.41, 1.84],
             "angular_velocity": [-96, -42, -114]}]"#,
    );
}

/// Seen: a collision of three balls, none of which touched another. Expected: the fourth ball,
/// which one of them had hit from directly above, is part of the event. Cause: the slate held that
/// ball, and balls that had not moved were left out.
#[test]
fn a_ball_hit_from_directly_above_is_part_of_the_event() {
    // Two columns side by side; the upper ball of the second one falls while that of the first is
    // nearly beside it.
    assert_no_faults(
        "\"showood-7ft\"",
        "stronge",
        r#"[{"id": "0", "position": [0.4608565636008476, 1.4312675522423928]},
            {"id": "1", "position": [0.41136321177451746, 1.4598425522424214]},
            {"id": "2", "position": [0.4113632117745174, 1.402692552242364]},
            {"id": "3", "position": [0.4113632117745174, 1.402692552242364, 0.08871493129048913]},
            {"id": "4", "position": [0.41136321177451746, 1.4598425522424214, 0.14594400477722352]}]"#,
    );
}

/// Seen: a ball rolls off a rail's top into a hole, reported as "where there is ground". The engine
/// was right: the checker put the edge 3 cm away, since rounding put the ball beside the line of
/// another edge.
#[test]
fn accepts_a_ball_that_rolls_off_a_top_where_two_edges_are_in_one_line() {
    assert_no_faults(
        "\"bar-7ft\"",
        "stronge",
        r#"[{"id": "0", "position": [0.7630514921022022, 0.427514002026946, 0.16144054169616612],
             "velocity": [0.21019734820668237, 0.44709783597315417, 6.225352528651119],
             "angular_velocity": [-90.9733928045176, 55.079274636368105, -30.52250990070095]},
            {"id": "1", "position": [0.25388703354634845, 0.6588825195329887]},
            {"id": "2", "position": [0.9147478049146769, 1.0920374533272244]}]"#,
    );
}

/// Seen: a ball rests at a lip with its centre 3 µm over the hole, and is raised to the slate by
/// 0.1 nm, which the checker reported as a jump and as a lack of support. Expected:
/// docs/guarantees.md allows both.
#[test]
fn accepts_a_ball_that_rests_slightly_beyond_a_lip() {
    assert_no_faults(
        "\"wpa-8ft\"",
        "stronge",
        r#"[{"id": "0", "position": [0.0017558557080810666, 1.1407080582133937],
             "velocity": [-0.14487324190972944, 0.057296709424699076, 0.0],
             "angular_velocity": [-2.0051341880909566, -5.069929725624828, 0.0]},
            {"id": "1", "position": [-0.012170670066300272, 1.198166737004359]}]"#,
    );
}

/// Seen: a ball exactly on top of another is treated as tilted to the other side, and pressed off
/// it. The checker allowed only half of the resulting impulse across the line of centres.
#[test]
fn accepts_a_ball_that_is_pressed_off_the_top_of_another() {
    assert_no_faults(
        "\"carom-9ft\"",
        "stronge",
        r#"[{"id": "0", "position": [0.8805432110409643, 0.7641792741923771]},
            {"id": "1", "position": [0.8272826487081681, 0.7949292741924079]},
            {"id": "2", "position": [0.8272826487081681, 0.7334292741923463]},
            {"id": "3", "position": [0.8450361694857669, 0.7641792741923771, 0.09240188147486277]},
            {"id": "4", "position": [0.8450361694857669, 0.7641792741923771, 0.2548831946835596]}]"#,
    );
}

/// Seen: a ball rolls on a rail's top back to its edge at 4 mm/s and stops there. The engine was
/// right: rolling friction holds such a slow ball on any edge. The checker allowed it only at the
/// lips of holes.
#[test]
fn accepts_a_ball_that_stops_on_the_edge_of_a_top() {
    assert_no_faults(
        "\"wpa-8ft\"",
        "stronge",
        r#"[{"id": "0", "position": [1.0628399618092603, 1.6467013179760484, 0.09867492139303582],
             "velocity": [1.2093450973450157, -3.410443631189193, 0.39559563213667887],
             "angular_velocity": [18.401457386263818, -27.737267080282688, -25.100173189834937]}]"#,
    );
}
