//! The example shots in `shots/`: each file is in the engine's own format, and each shot does what
//! its name says.

use std::path::{Path, PathBuf};

use carom::outcome::Touched;
use carom::rack::{Break, Game, break_shot};
use carom::{Shot, ShotFile, Trace};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shots")
}

fn text(name: &str) -> String {
    let path = folder().join(name).with_extension("json");
    std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

fn shot(name: &str) -> Shot {
    Shot::from_json(&text(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
}

fn played(name: &str) -> Trace {
    shot(name).simulate().unwrap_or_else(|e| panic!("{name}: {e}"))
}

/// Ids of the pocketed balls with their pockets, as `1 top-right`.
fn pocketed(trace: &Trace) -> Vec<String> {
    let balls = trace.shot().balls();
    let words = |(i, p): &(u16, carom::table::PocketName)| {
        format!("{} {}", balls[usize::from(*i)].id, p.name())
    };
    trace.outcome().pocketed.iter().map(words).collect()
}

/// Displacement of the cue ball from its first collision with a ball to rest, m, along its
/// direction before the collision.
fn cue_ball_travel_after_contact(trace: &Trace) -> f64 {
    let contact = trace.events().find(|e| e.kind == carom::trace::TraceEventKind::BallCollision);
    let at = contact.expect("a contact").before[0];
    let way = at.velocity.xy();
    (trace.last()[0].position - at.position).xy().dot(way) / way.length()
}

#[test]
fn every_example_is_written_as_the_engine_writes_it() {
    let mut count = 0;
    for entry in std::fs::read_dir(folder()).expect("the folder") {
        let path = entry.expect("an entry").path();
        if path.extension().is_none_or(|e| e != "json") {
            continue;
        }
        let text = std::fs::read_to_string(&path).expect("a file");
        let shot = ShotFile::from_json(&text).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
        assert_eq!(shot.to_json() + "\n", text, "{}", path.display());
        count += 1;
    }
    assert!(count >= 16, "{count} examples");
}

#[test]
fn the_breaks_are_the_racks_of_seed_1() {
    for (name, game) in [
        ("nine_ball_break", Game::NineBall),
        ("eight_ball_break", Game::EightBall),
        ("snooker_break", Game::Snooker),
    ] {
        let made = break_shot(&Break::new(game, 1)).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(text(name), made.to_json() + "\n", "{name}");
    }
}

#[test]
fn stop_follow_and_draw_pot_the_ball_and_leave_the_cue_ball_where_their_names_say() {
    for (name, range) in
        [("stop_shot", -0.02..0.02), ("follow_shot", 0.1..9.0), ("draw_shot", -9.0..-0.1)]
    {
        let trace = played(name);
        assert_eq!(pocketed(&trace)[0], "1 top-right", "{name}");
        let travel = cue_ball_travel_after_contact(&trace);
        assert!(range.contains(&travel), "{name}: {travel}");
    }
}

#[test]
fn the_half_ball_cut_drives_the_object_ball_at_about_thirty_degrees() {
    let trace = played("half_ball_cut");
    let hit = trace.events().find(|e| e.kind == carom::trace::TraceEventKind::BallCollision);
    let hit = hit.expect("a contact");
    let way = hit.before[0].velocity.xy();
    let sine = |v: carom::math::Vec2| way.cross(v) / (way.length() * v.length());
    let object = sine(hit.after[1].velocity.xy()).abs();
    // Half a ball: sin φ = 1/2; throw reduces it by a few degrees.
    assert!((0.4..0.5).contains(&object), "{object}");
}

#[test]
fn the_pots_pot_their_balls() {
    for (name, expected) in [
        ("bank_shot", "1 bottom-right"),
        ("side_pocket_cut", "1 right"),
        ("snooker_pot", "black top-right"),
    ] {
        let trace = played(name);
        assert_eq!(pocketed(&trace), [expected], "{name}");
        assert!(!trace.outcome().cue_ball_scratched(), "{name}");
    }
    let rails = played("bank_shot").outcome().rails_after_first_contact.clone();
    assert!(rails.iter().any(|(ball, _)| *ball == 1), "the object ball is banked");
}

#[test]
fn the_kick_goes_over_two_rails_to_the_ball_behind_the_eight() {
    let trace = played("kick_shot");
    assert_eq!(trace.outcome().first_contact, Some(2));
    assert_eq!(trace.outcome().rails_before_first_contact().count(), 2);
}

#[test]
fn the_masse_curves_around_the_eight() {
    let trace = played("masse");
    assert_eq!(trace.outcome().first_contact, Some(2), "the ball behind the 8");
    assert_eq!(trace.outcome().rails_before_first_contact().count(), 0);
}

#[test]
fn the_three_cushion_shot_scores() {
    let touched = played("three_cushion").outcome().cue_ball_touched.clone();
    let second = touched.iter().position(|t| *t == Touched::Ball(2)).expect("the second ball");
    let rails = |t: &&Touched| matches!(t, Touched::Rail(_));
    assert!(touched[..second].contains(&Touched::Ball(1)));
    assert!(touched[..second].iter().filter(rails).count() >= 3, "{touched:?}");
}

/// The cue ball is struck below its centre so that it arrives without spin: a rolling one would
/// keep pushing the row (`long_pushes` in carom-check).
#[test]
fn newtons_cradle_passes_nearly_the_whole_velocity_to_the_last_ball_as_hertzs_law_predicts() {
    let trace = played("newtons_cradle");
    let collisions =
        || trace.events().filter(|e| e.kind == carom::trace::TraceEventKind::BallCollision);
    let speed = collisions().next().expect("a contact").before[0].velocity.length();
    let last = u16::try_from(trace.shot().balls().len() - 1).expect("few balls");
    let reached = collisions()
        .filter_map(|e| Some(e.after[e.balls.iter().position(|b| *b == last)?]))
        .map(|s| s.velocity.length())
        .fold(0.0, f64::max);
    // Touching balls do not collide pair by pair: a few per cent stay behind (Hinch & Saint-Jean
    // 1999).
    assert!((0.98..0.995).contains(&(reached / speed)), "{reached} of {speed}");
    let first = collisions().next().expect("a contact");
    assert_eq!(first.balls.len(), trace.shot().balls().len(), "one impact of all");
    let speeds = |states: &[carom::BallState]| states.iter().map(|s| s.velocity.y).sum::<f64>();
    assert!((speeds(first.after) / speeds(first.before) - 1.0).abs() < 1e-12);
}
