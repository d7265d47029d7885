//! A sampler gives the frames that `Frame::play_displaced` gives, for every game, call and error.

mod support;

use carom::event::{Event, NullRecorder, Recorder};
use carom::noise::{Errors, Perception};
use carom::{Noise, Shot};
use carom_plan::{Prepared, Sampler};
use carom_rules::{BallIndex, Frame, FrameSimulator, Game, Play, Request, Ruling};

use support::{Dice, any_calls, positions};

/// Shots of random play of each game.
fn shots() -> usize {
    if cfg!(debug_assertions) { 60 } else { 600 }
}

/// The bits of all places.
fn places(frame: &Frame) -> Vec<Option<[u64; 2]>> {
    let all = 0..frame.layout().len() as BallIndex;
    all.map(|ball| frame.layout().place(ball).map(|place| place.map(f64::to_bits))).collect()
}

/// The frame after a play of `shot`, a variant of the shot that `before` asks for.
fn played(before: &Frame, play: &Play, shot: &Shot) -> Option<(Frame, Ruling)> {
    let mut frame = before.clone();
    let simulator = &mut FrameSimulator::new();
    let result = frame.play_displaced(simulator, play, shot, &mut NullRecorder);
    result.ok().map(|(ruling, ..)| (frame, ruling))
}

#[track_caller]
fn assert_same(successor: &Frame, ruling: &Ruling, expected: &(Frame, Ruling)) {
    assert_eq!(successor.to_node(), expected.0.to_node());
    assert_eq!(places(successor), places(&expected.0));
    assert_eq!(successor.request(), expected.0.request());
    assert_eq!(*ruling, expected.1);
}

#[test]
fn every_call_on_one_simulation_gives_the_successor_of_a_play_with_that_call() {
    for game in Game::ALL {
        let (mut sampler, mut dice) = (Sampler::new(), Dice::new(2));
        let mut ended = [0; 3];
        // The memory of a successor is used again, for positions of any kind.
        let mut successor = Frame::new(Game::Snooker, Default::default(), None, None, 1)
            .expect("the game's own table");
        for (frame, play) in positions(game, 40, shots()) {
            let prepared = Prepared::new(&frame, play.cue_ball).expect("a place with room");
            sampler.simulate(&prepared, &play.strike).expect("it can be played");
            let shot = frame.shot(&play).expect("it can be played");
            let turn = frame.turn().expect("a shot");
            for call in any_calls(&frame, turn, &mut dice) {
                let ruling = sampler.rule(&prepared, call, &mut successor).expect("it is allowed");
                let expected = played(&frame, &Play { call, ..play }, &shot).expect("as above");
                assert_same(&successor, &ruling, &expected);
                ended[match successor.request() {
                    Request::Shot(_) => 0,
                    Request::Choice { .. } => 1,
                    Request::Over { .. } => 2,
                }] += 1;
            }
        }
        assert!(ended[0] > 0 && ended[2] > 0, "{game:?}: {ended:?}");
    }
}

#[test]
fn a_successor_is_that_of_the_shot_that_the_frame_plays_itself() {
    for game in Game::ALL {
        let (mut sampler, mut successor) = (Sampler::new(), None);
        for (frame, play) in positions(game, 77, shots() / 4) {
            let strike = carom_rules::through_degrees(&play.strike);
            let prepared = Prepared::new(&frame, play.cue_ball).expect("a place with room");
            sampler.simulate(&prepared, &strike).expect("it can be played");
            let successor = successor.get_or_insert_with(|| frame.clone());
            let ruling = sampler.rule(&prepared, play.call, successor).expect("it is allowed");
            let mut same = frame.clone();
            let (expected, outcome) = same.play(&play).expect("it can be played");
            assert_same(successor, &ruling, &(same, expected));
            assert_eq!(*sampler.outcome(), outcome);
        }
    }
}

#[test]
fn a_variant_is_that_of_the_engine_with_its_strike_its_layout_and_its_cling() {
    let still = Noise::olympiad(1.0);
    let clinging = Noise { cling_probability: 0.2, ..Noise::olympiad(2.0) };
    let seen = Perception::round(0.003);
    for (noise, perception) in [
        (still, Perception::default()),
        (clinging.clone(), Perception::default()),
        (Noise::NONE, seen.clone()),
        (clinging, seen),
    ] {
        let errors = Errors { noise: noise.clone(), perception, seed: 9 };
        for game in Game::ALL {
            let mut sampler = Sampler::new();
            for (k, (frame, play)) in (0..).zip(positions(game, 5, shots() / 10)) {
                let prepared = Prepared::new(&frame, play.cue_ball).expect("a place with room");
                sampler.simulate_variant(&prepared, &play.strike, &errors, k).expect("by the law");
                let mut successor = frame.clone();
                let ruling =
                    sampler.rule(&prepared, play.call, &mut successor).expect("it is allowed");

                let shot = frame.shot(&play).expect("it can be played");
                let (struck, _) = shot.strike().expect("a strike");
                let strike = noise.draw(&play.strike, &prepared.struck_ball(), 9, k);
                let variant = errors.shot(&shot, Some((struck, strike)), k).expect("by the law");
                let expected = played(&frame, &Play { strike, ..play }, &variant);
                assert_same(&successor, &ruling, &expected.expect("as above"));
            }
        }
    }
}

/// Counts the events of a shot.
struct CountingRecorder(u32);

impl Recorder for CountingRecorder {
    fn record(&mut self, _: &Event<'_>) {
        self.0 += 1;
    }
}

#[test]
fn a_further_recorder_gets_every_event() {
    let mut sampler = Sampler::new();
    for (frame, play) in positions(Game::EightBall, 3, 10) {
        let prepared = Prepared::new(&frame, play.cue_ball).expect("a place with room");
        let mut count = CountingRecorder(0);
        sampler.simulate_recorded(&prepared, &play.strike, &mut count).expect("it can be played");
        assert_eq!(count.0, sampler.outcome().events);
        assert!(count.0 > 3, "a shot has at least a strike, a contact and an end");
    }
}

#[test]
fn what_cannot_be_ruled_is_refused_and_leaves_the_successor_alone() {
    let (frame, play) = positions(Game::NineBall, 3, 1).remove(0);
    let prepared = Prepared::new(&frame, play.cue_ball).expect("a place with room");
    let mut sampler = Sampler::new();
    let mut successor = frame.clone();
    sampler.simulate(&prepared, &play.strike).expect("it can be played");
    let refused = sampler.rule(&prepared, carom_rules::Call::Safety, &mut successor);
    assert!(refused.expect_err("no safety in nine-ball").to_string().starts_with("call: "));
    assert_eq!(successor.to_node(), frame.to_node());

    let far = carom::resolve::cue_ball::Strike { side: 0.7, ..play.strike };
    let error = sampler.simulate(&prepared, &far).expect_err("a miscue").to_string();
    let shot = frame.shot(&Play { strike: far, ..play }).expect_err("a miscue").to_string();
    assert_eq!(error, shot);
    assert!(sampler.last().is_empty());
    let beyond = Prepared::new(&frame, Some([0.3, 1.0])).expect_err("in front of the head string");
    assert!(beyond.to_string().starts_with("cue_ball: "), "{beyond}");
}
