//! The lists of plays: their names, and which plays they have.

use carom::Noise;
use carom::outcome::Touched;
use carom_mind::line::LineKind;
use carom_mind::search::PlayKind;
use carom_mind::{Answer, Budget, Player, Recommendation, Searcher, Situation};
use carom_plan::{Prepared, Sampler};
use carom_rules::{Call, Frame, FrameSimulator, Game, Options, Play, Request};

/// Frames of each game whose lists are checked, the shots of each, and the simulations of a list.
const FRAMES: u64 = 2;
const SHOTS: u64 = 8;
const SIMULATIONS: u64 = 1500;

/// What a strike does without errors, as the engine tells it.
struct Done {
    frame: Frame,
    outcome: carom::outcome::Outcome,
    is_legal: bool,
}

fn done(frame: &Frame, play: &Play) -> Done {
    let prepared = Prepared::new(frame, play.cue_ball).expect("a position");
    let (mut sampler, mut after) = (Sampler::new(), frame.clone());
    sampler.simulate(&prepared, &play.strike).expect("a shot");
    let ruling = sampler.rule(&prepared, play.call, &mut after).expect("a ruling");
    Done { frame: after, outcome: sampler.outcome().clone(), is_legal: ruling.is_legal() }
}

/// Asserts that the kind, the pot and the legs of a listed play are those of its strike without errors.
fn assert_name_is_true(before: &Frame, listed: &Recommendation) {
    let Done { frame, outcome, is_legal } = done(before, &listed.play);
    let seat = before.player().expect("a turn");
    let keeps = is_legal && frame.keeps_turn(seat);
    let (kind, legs) = (listed.kind, &listed.legs);
    let story = format!("{} {listed:?}: {outcome:?}", before.game().name());
    match kind {
        PlayKind::Break | PlayKind::PushOut => return,
        PlayKind::Safety => {
            // Who practises alone keeps the turn whatever happens.
            let keeps = keeps && before.game() != Game::Practice;
            return assert!(!keeps && listed.pot.is_none(), "{story}");
        }
        PlayKind::Carom => {
            assert!(keeps && listed.pot.is_none(), "{story}");
            let route = listed.route.as_ref().expect("a route");
            assert_eq!(Some(route.pattern.first), outcome.first_contact, "{story}");
            let mut touched = outcome.cue_ball_touched.iter();
            let until_second = touched.position(|t| *t == Touched::Ball(route.second));
            assert!(until_second.is_some_and(|count| count > route.rails.len()), "{story}");
            return;
        }
        PlayKind::Pot(_) | PlayKind::Indirect => assert!(keeps, "{story}"),
    }
    let pot = listed.pot.expect("a pot");
    assert!(outcome.pocketed.contains(&pot), "{story}");
    if let Call::Pocket(ball, pocket) = listed.play.call {
        assert_eq!((ball, pocket), pot, "{story}");
    }
    let PlayKind::Pot(kind) = kind else { return assert!(legs.is_empty(), "{story}") };
    let before_contact = outcome.rails_before_first_contact().count();
    let touched_by_object =
        outcome.rails_after_first_contact.iter().filter(|(ball, _)| *ball == pot.0).count();
    assert_eq!(legs[0].1 as usize, before_contact, "{story}");
    assert_eq!(before_contact > 0, kind == LineKind::Kick, "{story}");
    assert_eq!(outcome.first_contact == Some(pot.0), kind != LineKind::Combination, "{story}");
    assert_eq!(outcome.first_contact, Some(legs[1].0), "{story}");
    assert_eq!(legs.last().map(|leg| leg.0), Some(pot.0), "{story}");
    let on_the_way = usize::from(legs[legs.len() - 1].1);
    assert_eq!(on_the_way > 0, kind == LineKind::Bank, "{story}");
    assert!(on_the_way <= touched_by_object, "{story}");
}

#[test]
fn the_caroms_of_a_list_have_a_pattern_each() {
    let mut frame =
        Frame::new(Game::ThreeCushion, Options::default(), None, None, 0).expect("a frame");
    frame
        .resume_at(&[Some([0.4, 0.6]), Some([1.1, 0.5]), Some([0.9, 2.2])], 0)
        .expect("a position");
    let situation = Situation::new(&frame, Noise::olympiad(2.0), 1);
    let analysis = Searcher::default().analyse(&situation, &Budget::simulations(8000), 6);
    let plays = analysis.expect("a list").plays;
    let patterns: Vec<_> =
        plays.iter().filter_map(|play| Some(play.route.as_ref()?.pattern)).collect();
    assert!(patterns.len() >= 3, "{patterns:?}");
    for (k, pattern) in patterns.iter().enumerate() {
        assert!(!patterns[..k].contains(pattern), "{patterns:?}");
    }
    // The game needs three cushions, and the route has them.
    for route in plays.iter().filter_map(|play| play.route.as_ref()) {
        assert!(route.rails.len() >= 3, "{route:?}");
    }
}

#[test]
fn the_name_of_a_listed_play_tells_what_its_strike_does_in_every_game() {
    let noise = Noise::olympiad(2.0);
    let mut simulator = FrameSimulator::new();
    let mut kinds = Vec::new();
    for game in Game::ALL {
        for seed in 0..FRAMES {
            let options = Options { points: 30, ..Options::default() };
            let mut frame = Frame::new(game, options, None, None, seed).expect("a frame");
            for index in 0..SHOTS {
                if !matches!(frame.request(), Request::Shot(_)) {
                    let situation = Situation::new(&frame, noise.clone(), index);
                    let budget = Budget::simulations(SIMULATIONS);
                    let decision = Searcher::default().decide(&situation, &budget);
                    match decision.expect("a decision").answer {
                        Answer::Choice(choice) => frame.choose(choice).expect("an offered choice"),
                        _ => break,
                    };
                    continue;
                }
                let situation = Situation::new(&frame, noise.clone(), index);
                let analysis = Searcher::default()
                    .analyse(&situation, &Budget::simulations(SIMULATIONS), 12)
                    .expect("an analysis");
                for listed in &analysis.plays {
                    assert_name_is_true(&frame, listed);
                    kinds.push(listed.kind);
                }
                let play = analysis.plays[0].play;
                let struck = Prepared::new(&frame, play.cue_ball).expect("a shot").struck_ball();
                let strike = noise.draw(&play.strike, &struck, 5, index);
                frame.play_in(&mut simulator, &Play { strike, ..play }).expect("a shot");
                if frame.is_over() {
                    break;
                }
            }
        }
    }
    for kind in [LineKind::Direct, LineKind::Bank, LineKind::Kick, LineKind::Combination] {
        assert!(kinds.contains(&PlayKind::Pot(kind)), "no {}", kind.name());
    }
    for kind in [PlayKind::Indirect, PlayKind::Safety, PlayKind::Carom] {
        assert!(kinds.contains(&kind), "no {}", kind.name());
    }
}

/// Positions of eight-ball on an open table: the cue ball, two solids, the eight and two stripes.
const OPEN: [[[f64; 2]; 6]; 4] = [
    [[0.62, 1.31], [0.21, 0.43], [1.02, 1.88], [0.71, 2.21], [0.33, 1.92], [0.94, 0.51]],
    [[0.31, 0.82], [0.92, 0.33], [0.55, 1.71], [1.08, 1.35], [0.19, 2.28], [0.77, 1.02]],
    [[0.97, 2.11], [0.44, 0.25], [0.64, 1.57], [0.16, 1.12], [1.12, 0.77], [0.28, 2.02]],
    [[0.24, 1.66], [1.05, 2.33], [0.83, 0.29], [0.52, 0.96], [0.58, 2.12], [1.14, 1.49]],
];

#[test]
fn a_short_list_omits_no_play_that_is_better_than_one_of_its_own() {
    const MARGIN: f64 = 0.1;
    for places in OPEN {
        let mut frame =
            Frame::new(Game::EightBall, Options::default(), None, None, 0).expect("a frame");
        let mut all = vec![None; frame.layout().len()];
        for (ball, place) in [0, 1, 2, 8, 9, 10].into_iter().zip(places) {
            all[ball] = Some(place);
        }
        frame.resume_at(&all, 0).expect("a position");
        let situation = Situation::new(&frame, Noise::olympiad(1.5), 1);
        let list = |simulations, count| {
            let budget = Budget::simulations(simulations);
            Searcher::default().analyse(&situation, &budget, count).expect("a list").plays
        };
        let (short, long) = (list(20_000, 5), list(20_000, 12));
        let worst = short.iter().map(|listed| listed.win).fold(1.0, f64::min);
        for listed in long.iter().filter(|listed| listed.win > worst + MARGIN) {
            let is_there = short.iter().any(|other| other.pot == listed.pot);
            let own: Vec<_> = short.iter().map(|p| (p.kind, p.pot, p.win)).collect();
            assert!(is_there, "{places:?} lacks {listed:?}; it has {own:?}");
        }
    }
}
