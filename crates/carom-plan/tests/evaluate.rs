//! Evaluations count the results of the variants.

use carom::batch::{OFF_TABLE, draw_strikes, simulate_strikes};
use carom::noise::{Perception, StruckBall};
use carom::resolve::cue_ball::Strike;
use carom::runner::Runner;
use carom::{Noise, Shot};
use carom_plan::evaluate::VARIANTS_PER_ROUND;
use carom_plan::{ErrorModel, Evaluation, Progress, Question, Referee, Watched, evaluate};
use carom_rules::{Call, Frame, Game, Options, Play};

fn shot(name: &str) -> Shot {
    let file = format!("{}/../../shots/{name}.json", env!("CARGO_MANIFEST_DIR"));
    Shot::from_json(&std::fs::read_to_string(file).expect("a shot file")).expect("a shot")
}

fn model(variants: u64) -> ErrorModel {
    ErrorModel { seed: 7, variants, ..ErrorModel::default() }
}

fn question(variants: u64) -> Question<'static> {
    Question { model: model(variants), ..Question::default() }
}

fn question_of(model: ErrorModel) -> Question<'static> {
    Question { model, ..Question::default() }
}

fn answer(shot: &Shot, question: &Question<'_>) -> Evaluation {
    evaluate(shot, question, &Progress::default()).expect("an evaluation")
}

#[test]
fn counts_are_those_of_the_simulated_variants() {
    let shot = shot("half_ball_cut");
    let variants = 2500;
    let evaluation = answer(&shot, &question(variants));
    let strikes =
        draw_strikes(&shot, &Noise::olympiad(1.0), variants as usize, 7, 0).expect("drawn");
    let ends = simulate_strikes(&shot, &strikes, &Runner::default());
    assert_eq!(evaluation.counts.variants, variants);
    let mut fell = 0;
    for ball in 0..ends.balls {
        let column = || ends.pocket.iter().skip(ball).step_by(ends.balls);
        for pocket in 0..evaluation.counts.pockets {
            let count = column().filter(|&&p| p == pocket as i8).count() as u64;
            assert_eq!(evaluation.counts.falls_into(ball, pocket), count);
            fell += count;
        }
        let off = column().filter(|&&p| p == OFF_TABLE).count() as u64;
        assert_eq!(evaluation.counts.off_table[ball], off);
    }
    assert!(fell > 0, "a cut that is never potted tests nothing");
    assert_eq!(evaluation.counts.failed, ends.errors.len() as u64);
    let cue = evaluation.cue_ball;
    for (end, places) in evaluation.cue_ball_ends.iter().zip(ends.final_position.chunks(ends.balls))
    {
        assert!(end[0].is_nan() || *end == [places[cue][0], places[cue][1]]);
    }
}

#[test]
fn evaluations_are_the_same_for_any_number_of_threads() {
    let shot = shot("half_ball_cut");
    let alone = answer(&shot, &Question { threads: Some(1), ..question(1500) });
    for threads in [Some(3), None] {
        let together = answer(&shot, &Question { threads, ..question(1500) });
        assert_eq!(alone.counts.potted, together.counts.potted);
        assert_eq!(alone.ends[0].mean(), together.ends[0].mean());
        let bits = |e: &Evaluation| {
            e.cue_ball_ends.iter().flatten().map(|x| x.to_bits()).collect::<Vec<_>>()
        };
        assert_eq!(bits(&alone), bits(&together));
    }
}

#[test]
fn sampling_stops_when_the_interval_is_short_enough() {
    let shot = shot("half_ball_cut");
    let object = 1;
    let model = ErrorModel { half_width: Some(0.015), ..model(100_000) };
    let watched = Watched::Ball(object);
    let evaluation = answer(&shot, &Question { model, watched, ..Question::default() });
    let interval = evaluation.interval(|counts| counts.falls(object));
    assert!(interval.half_width() <= 0.015);
    assert!(evaluation.counts.variants < 100_000);
    // After one round less the interval was too long.
    let before = answer(&shot, &question(evaluation.counts.variants - VARIANTS_PER_ROUND));
    assert!(before.interval(|counts| counts.falls(object)).half_width() > 0.015);
}

#[test]
fn without_noise_every_variant_is_the_shot_itself() {
    let shot = shot("draw_shot");
    let evaluation =
        answer(&shot, &question_of(ErrorModel { noise: Noise::default(), ..model(10) }));
    let trace = shot.simulate().expect("a trace");
    let fell = trace.outcome().pocketed.len() as u64;
    assert_eq!(evaluation.counts.potted.iter().sum::<u64>(), 10 * fell);
}

#[test]
fn every_variant_of_a_strike_at_the_limit_of_the_tip_is_played() {
    let shot = shot("stop_shot");
    let strike = Strike { side: 0.51, height: 0.0, ..shot.strike().expect("a strike").1 };
    let shot = shot.with_strike(&strike).expect("a shot at the limit of the tip");
    let evaluation = answer(&shot, &question(400));
    assert_eq!((evaluation.counts.failed, evaluation.first_failure), (0, None));
}

#[test]
fn strikes_that_cannot_be_played_are_counted() {
    // A ball behind the cue ball, which a cue at this elevation just clears.
    let behind = Shot::from_json(
        r#"{"format": "carom-shot/1", "table": "wpa-9ft",
            "balls": [{"id": "cue", "position": [0.635, 1.0]}, {"id": "1", "position": [0.635, 0.9]}],
            "strike": {"ball": "cue", "speed": 2.0, "azimuth_deg": 90.0, "obstruction": "refuse"}}"#,
    )
    .expect("a shot at the default elevation");
    let (_, meant) = behind.strike().expect("a strike");
    let least = behind.least_elevation().expect("an elevation that is clear");
    assert!(least > 0.1, "a lower cue may be raised by the player: {least} rad");
    let edge = behind.with_strike(&Strike { elevation: least, ..meant }).expect("a clear cue");
    let evaluation = answer(&edge, &question(400));
    assert!((50..350).contains(&evaluation.counts.failed), "{}", evaluation.counts.failed);
    let failure = evaluation.first_failure.expect("an error").to_string();
    assert!(failure.contains("the cue would pass through"), "{failure}");
}

#[test]
fn a_referee_counts_legal_variants_and_kept_turns() {
    let frame = Frame::new(Game::NineBall, Options::default(), None, None, 3).expect("a frame");
    let size = frame.base().table().size;
    let strike = Strike {
        speed: 8.0,
        azimuth: core::f64::consts::FRAC_PI_2,
        elevation: 0.0,
        side: 0.0,
        height: 0.0,
    };
    let play = Play::new(strike).from([0.5 * size.x, 0.2 * size.y]);
    let shot = frame.shot(&play).expect("a break");
    let referee = Some(Referee { frame: &frame, call: Call::Nothing });
    let evaluation = answer(&shot, &Question { referee, ..question(200) });
    let (legal, kept) =
        (evaluation.counts.legal.expect("a count"), evaluation.counts.turn_kept.expect("a count"));
    assert!(legal > 100, "a hard break is mostly legal, {legal}");
    assert!(kept <= legal && kept > 0);

    let foreign = self::shot("stop_shot");
    let refused = evaluate(&foreign, &Question { referee, ..question(1) }, &Progress::default());
    assert!(refused.is_err());
}

#[test]
fn a_referee_does_not_change_the_counts() {
    let frame = Frame::new(Game::NineBall, Options::default(), None, None, 3).expect("a frame");
    let place = [0.5 * frame.base().table().size.x, 0.5];
    let strike = Strike { speed: 8.0, azimuth: 1.57, elevation: 0.02, side: 0.0, height: 0.1 };
    let shot = frame.shot(&Play::new(strike).from(place)).expect("a break");
    let perception = Perception::round(0.001);
    for perception in [Perception::default(), perception] {
        let asked = question_of(ErrorModel { perception, ..model(150) });
        let alone = answer(&shot, &asked);
        let referee = Some(Referee { frame: &frame, call: Call::Nothing });
        let ruled = answer(&shot, &Question { referee, ..asked.clone() });
        assert_eq!(alone.counts.potted, ruled.counts.potted);
        assert_eq!(alone.counts.off_table, ruled.counts.off_table);
        assert_eq!(alone.ends, ruled.ends);
        assert_eq!(
            (alone.counts.failed, &alone.first_failure),
            (ruled.counts.failed, &ruled.first_failure)
        );
        assert!(
            ruled.counts.potted.iter().sum::<u64>() > 0,
            "breaks that pot nothing test nothing"
        );
    }
}

#[test]
fn poor_perception_pots_less_even_with_exact_strikes() {
    let shot = shot("side_pocket_cut");
    let (object, variants) = (1, 2000);
    let fell = [0.0, 0.001, 0.004].map(|position| {
        let perception = Perception::round(position);
        let exact = ErrorModel { noise: Noise::default(), perception, ..model(variants) };
        answer(&shot, &question_of(exact)).counts.falls(object)
    });
    assert_eq!(fell[0], variants, "without any error it always falls");
    assert!(fell[0] > fell[1] && fell[1] > fell[2], "{fell:?}");
}

#[test]
fn every_variant_plays_its_strike_on_the_layout_of_the_same_index() {
    let shot = shot("frozen_combination");
    let perception = Perception::round(0.003);
    let noise = Noise::olympiad(1.0);
    let asked = question_of(ErrorModel {
        noise: noise.clone(),
        perception: perception.clone(),
        ..model(60)
    });
    let evaluation = answer(&shot, &asked);
    let (struck, meant) = shot.strike().expect("a strike");
    let ball = StruckBall::of(&shot, &shot.balls()[struck].ball);
    let mut fell = vec![0; shot.balls().len()];
    for k in 0..60 {
        let strike = noise.draw(&meant, &ball, 7, k);
        let seen = shot.with_balls(perception.places(&shot, 7, k), Some((struck, strike)));
        let Ok(trace) = seen.and_then(|seen| seen.simulate()) else { continue };
        for (ball, _) in &trace.outcome().pocketed {
            fell[usize::from(*ball)] += 1;
        }
    }
    assert!(fell.iter().sum::<u64>() > 0, "a combination that is never potted tests nothing");
    for (ball, count) in fell.into_iter().enumerate() {
        assert_eq!(evaluation.counts.falls(ball), count);
    }
    for threads in [1, 3] {
        let again = answer(&shot, &Question { threads: Some(threads), ..asked.clone() });
        assert_eq!(again.counts.potted, evaluation.counts.potted);
        assert_eq!(again.ends, evaluation.ends);
    }
}

#[test]
fn bad_questions_are_rejected_by_name() {
    let shot = shot("stop_shot");
    let refuse = |question: Question<'_>| {
        evaluate(&shot, &question, &Progress::default()).expect_err("nonsense").to_string()
    };
    assert!(refuse(question_of(ErrorModel { level: 1.0, ..model(1) })).starts_with("level: "));
    let perception = Perception::round(-0.001);
    assert!(
        refuse(question_of(ErrorModel { perception, ..model(1) }))
            .starts_with("perception.position: ")
    );
    let precision = |half_width, watched| Question {
        model: ErrorModel { half_width: Some(half_width), ..model(1) },
        watched,
        ..Question::default()
    };
    assert!(refuse(question(u64::MAX)).starts_with("n: "));
    assert!(refuse(precision(0.0, Watched::Scratch)).starts_with("precision: "));
    assert!(refuse(precision(0.1, Watched::Ball(99))).starts_with("watch: "));
    assert!(refuse(precision(0.1, Watched::Legal)).starts_with("watch: "));
}

#[test]
fn perceived_positions_have_the_given_spread_and_never_overlap() {
    let shot = shot("frozen_combination");
    let sight = Perception::round(0.002);
    let (mut sum, mut count) = (0.0, 0.0);
    for index in 0..300 {
        let seen = sight.draw(&shot, 3, index).expect("a valid shot, whatever is seen");
        assert_eq!(seen, sight.draw(&shot, 3, index).expect("the same"));
        // The first ball is drawn before any other has moved: only its neighbours can hold it.
        let off = seen.balls()[0].state.position - shot.balls()[0].state.position;
        sum += off.x * off.x + off.y * off.y;
        count += 2.0;
    }
    let sigma = carom::math::sqrt(sum / count);
    assert!((0.0017..0.0023).contains(&sigma), "{sigma}");
    let clear = Perception::default().draw(&shot, 3, 0).expect("a shot");
    assert_eq!(clear, shot);
    assert!(Perception::round(-1.0).draw(&shot, 3, 0).is_err());
}
