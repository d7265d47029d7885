//! Environments through their public interface.

use carom::Noise;
use carom::format::Node;
use carom_env::{
    Aim, Autoreset, CUSHIONS, Config, FEATURES, MAX_ENVIRONMENTS, Opponent, Rewards, Setup,
    TargetBall, Task, VectorEnv,
};
use carom_rules::{Game, GameFacts};

/// Random actions that are the same for the same seed.
fn actions(count: usize, seed: u64) -> Vec<f32> {
    let mut state = seed;
    let mut next = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (state >> 40) as f32 / (1_u32 << 23) as f32 - 1.0
    };
    (0..count).map(|_| next()).collect()
}

fn environments(task: Task, n: usize, config: Config) -> VectorEnv {
    let mut vector = VectorEnv::new(task, n, 0, config).expect("a task");
    let seeds: Vec<u64> = (0..n as u64).collect();
    vector.reset(Some(&seeds), None).expect("seeds for all");
    vector
}

/// The bits of all results of some random steps.
fn bits(task: Task, n: usize, steps: u64, threads: usize) -> Vec<u64> {
    let config = Config { noise: Noise::olympiad(1.0), threads: Some(threads), ..Config::of(task) };
    let mut vector = environments(task, n, config);
    let mut bits = Vec::new();
    for step in 0..steps {
        let out = vector.step(&actions(n * vector.action_size(), step)).expect("a step");
        bits.extend(out.observations.iter().map(|x| u64::from(x.to_bits())));
        bits.extend(out.rewards.iter().map(|x| x.to_bits()));
        bits.extend(out.players.iter().map(|x| *x as u64));
    }
    bits
}

#[test]
fn results_are_the_same_bits_for_any_number_of_threads() {
    for task in Task::all() {
        assert_eq!(bits(task, 40, 3, 1), bits(task, 40, 3, 3), "{}", task.name());
    }
}

#[test]
fn observations_are_within_their_bounds_and_no_episode_ends_in_two_ways() {
    for task in Task::all() {
        for opponent in [Opponent::None, Opponent::Random, Opponent::Potter] {
            if task == Task::Potting && opponent != Opponent::None {
                continue;
            }
            let noise = Noise::olympiad(2.0);
            let mut config = Config { opponent, noise, ..Config::of(task) };
            config.options.patience = 10;
            let mut vector = environments(task, 6, config);
            let [low, high] = vector.observation_bounds();
            for step in 0..20 {
                let out = vector.step(&actions(6 * vector.action_size(), step)).expect("a step");
                for row in out.observations.chunks(vector.observation_size()) {
                    for ((x, low), high) in row.iter().zip(&low).zip(&high) {
                        assert!((low..=high).contains(&x), "{}: {x}", task.name());
                    }
                }
                assert!(out.rewards.iter().all(|reward| reward.is_finite()));
                assert!(out.players.iter().all(|player| *player >= 0), "reset in the same step");
                let both = out.terminated.iter().zip(&out.truncated).any(|(a, b)| *a && *b);
                assert!(!both, "an episode ends in one way");
            }
        }
    }
}

#[test]
fn full_hits_in_random_layouts_pot_between_1_and_20_per_cent() {
    let config = Config { aim: Aim::Relative, ..Config::of(Task::Potting) };
    let n = 2000;
    let mut vector = environments(Task::Potting, n, config);
    let full: Vec<f32> = (0..n).flat_map(|_| [0.0, 0.0, 0.0, 0.0, -1.0]).collect();
    let out = vector.step(&full).expect("a step");
    let made = out.rewards.iter().filter(|reward| **reward == 1.0).count();
    // A ball hit full continues straight; pockets cover a few per cent of all directions.
    assert!((n / 100..n / 5).contains(&made), "{made} of {n}");
    assert!(out.terminated.iter().all(|ended| *ended), "one shot");
}

#[test]
fn the_lowest_ball_is_harder_to_pot_than_any() {
    let made = |target_ball| {
        let config = Config { target_ball, balls: Some([5, 5]), ..Config::of(Task::Potting) };
        let n = 3000;
        let mut vector = environments(Task::Potting, n, config);
        let out = vector.step(&actions(n * vector.action_size(), 1)).expect("a step");
        out.rewards.iter().sum::<f64>()
    };
    assert!(made(TargetBall::Lowest) < 0.6 * made(TargetBall::Any));
}

#[test]
fn games_start_with_the_requested_number_of_random_balls() {
    for game in Game::ALL {
        let Some(start) = GameFacts::of(game).random_start else { continue };
        let racked = start.racked.map_or(0..0, |[first, last]| first..last + 1);
        let always: Vec<_> = start.always.iter().copied().chain(racked.clone()).collect();
        let balls = [start.count[0], start.count[1].min(start.count[0] + 8)];
        let task = Task::Game(game);
        let count = 300;
        let vector = environments(task, count, Config { balls: Some(balls), ..Config::of(task) });
        let mut seen = std::collections::BTreeSet::new();
        let mut places = std::collections::HashSet::new();
        for index in 0..count {
            let row = vector.observe(index, 0).expect("an environment");
            let (seen_balls, rest) = row.split_at(row.len() - FEATURES.len());
            let on_table: Vec<bool> = seen_balls.chunks(4).map(|ball| ball[2] == 1.0).collect();
            assert!(on_table[0], "the cue ball");
            assert!(always.iter().all(|ball| on_table[usize::from(*ball)]), "{}", task.name());
            // The cue ball is not in hand, and it is not an opening shot.
            assert_eq!([rest[0], rest[1], rest[2], rest[5]], [0.0; 4], "{}", task.name());
            places.insert([row[0].to_bits(), row[1].to_bits()]);
            seen.insert(on_table[1..].iter().filter(|on| **on).count() - racked.len());
        }
        let asked: Vec<usize> = (balls[0]..=balls[1]).collect();
        assert_eq!(seen.into_iter().collect::<Vec<_>>(), asked, "{}", task.name());
        assert_eq!(places.len(), count, "all layouts differ");
    }
}

#[test]
fn with_random_reds_the_colours_are_on_their_spots() {
    let task = Task::Game(Game::Snooker);
    let config = |balls| Config { balls, ..Config::of(task) };
    let colors = |balls| {
        let vector = environments(task, 1, config(balls));
        vector.observe(0, 0).expect("an environment")[4 * 16..4 * 22].to_vec()
    };
    let racked = colors(None);
    assert_eq!(colors(Some([3, 3])), racked);
    // Without reds the yellow is on.
    let on: Vec<f32> = colors(Some([0, 0])).chunks(4).map(|ball| ball[3]).collect();
    assert_eq!(on, [1.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
}

#[test]
fn the_cue_ball_in_hand_is_placed_at_the_place_of_the_action() {
    let task = Task::Game(Game::NineBall);
    let mut vector = environments(task, 1, Config::of(task));
    // A slow shot across the table: it changes x a little and y not at all.
    let action = [0.0, -1.0, 0.0, 0.0, -1.0, 0.4, 0.2];
    let out = vector.step(&action).expect("a step");
    let [x, y] = [out.observations[0], out.observations[1]];
    // Behind the head string: y from 0 to a quarter of the length.
    let wanted = [0.4, -1.0 + 0.5 * 0.6];
    assert!(x > wanted[0] && x < wanted[0] + 0.4, "{x}");
    assert!((y - wanted[1]).abs() < 1e-6, "{y}");
}

#[test]
fn an_observation_lists_the_viewers_own_group_first() {
    let task = Task::Game(Game::EightBall);
    let config = Config {
        balls: Some([9, 9]),
        aim: Aim::Relative,
        autoreset_mode: Autoreset::Disabled,
        ..Config::of(task)
    };
    let n = 300;
    let mut vector = environments(task, n, config);
    let out = vector.step(&actions(n * vector.action_size(), 4)).expect("a step");
    let mut closed = 0;
    for (index, row) in out.observations.chunks(vector.observation_size()).enumerate() {
        let on = |balls: core::ops::Range<usize>| balls.filter(|k| row[4 * k + 3] == 1.0).count();
        let open = on(1..8) > 0 && on(9..16) > 0;
        if out.players[index] < 0 || open {
            continue;
        }
        closed += 1;
        assert!(on(1..8) > 0 || on(8..9) == 1, "the own group or the eight is on");
        assert_eq!(on(9..16), 0, "no ball of the other group is on");
    }
    assert!(closed > 5, "only {closed} tables have groups");
}

#[test]
fn sum_to_three_scores_exactly_three_cushions() {
    // Along the long string at the object ball: the number of cushions depends on the speed.
    let n = 400;
    let mut vector = environments(Task::SumToThree, n, Config::of(Task::SumToThree));
    let shots: Vec<f32> =
        (0..n).flat_map(|i| [0.5, 2.0 * i as f32 / n as f32 - 1.0, 0.0, 0.0, -1.0]).collect();
    let out = vector.step(&shots).expect("a step");
    let scored = out.rewards.iter().filter(|reward| **reward == 1.0).count();
    assert_eq!(CUSHIONS, 3);
    assert!(scored > n / 50 && scored < n / 2, "{scored} of {n}");
    // The player who scores shoots again.
    for (reward, player) in out.rewards.iter().zip(&out.players) {
        assert_eq!(*player, i8::from(*reward == 0.0));
    }
}

#[test]
fn a_shot_that_never_ends_truncates_the_episode_with_a_penalty() {
    // On cloth without friction moving balls never stop.
    let physics = carom::format::Node::object([(
        "cloth",
        carom::format::Node::object([
            ("sliding_friction", 0.0.into()),
            ("rolling_friction", 0.0.into()),
        ]),
    )]);
    let config = Config {
        setups: vec![Setup { physics: Some(physics), table: Some("carom-10ft".into()) }],
        rewards: Rewards { failure: -3.0, ..Rewards::of(Task::SumToThree) },
        ..Config::of(Task::SumToThree)
    };
    let mut vector = environments(Task::SumToThree, 1, config);
    let out = vector.step(&[0.3, 0.5, 0.0, 0.0, -1.0]).expect("a step");
    assert_eq!((out.rewards[0], out.truncated[0], out.terminated[0]), (-3.0, true, false));
}

#[test]
fn a_clone_continues_independently_from_the_same_state() {
    for task in Task::all() {
        let config = Config { noise: Noise::olympiad(1.0), ..Config::of(task) };
        let mut vector = environments(task, 4, config);
        let width = 4 * vector.action_size();
        vector.step(&actions(width, 1)).expect("a step");
        let (mut tried, mut other) = (vector.clone(), vector.clone());
        let out = tried.step(&actions(width, 2)).expect("a step");
        assert_ne!(other.step(&actions(width, 3)).expect("a step"), out, "{}", task.name());
        assert_eq!(vector.step(&actions(width, 2)).expect("a step"), out, "{}", task.name());
    }
}

#[test]
fn an_episode_is_truncated_after_its_limit_of_steps() {
    let task = Task::Game(Game::ThreeCushion);
    let config = Config {
        max_episode_steps: Some(3),
        autoreset_mode: Autoreset::Disabled,
        ..Config::of(task)
    };
    let mut vector = environments(task, 2, config);
    let width = 2 * vector.action_size();
    for step in 1..=3 {
        let out = vector.step(&actions(width, step)).expect("a step");
        assert_eq!((out.truncated[0], out.terminated[0]), (step == 3, false));
    }
    assert_eq!(vector.player(0).expect("an environment"), None);
    let seen = vector.observe(0, 0).expect("an environment");
    let out = vector.step(&actions(width, 4)).expect("a step");
    assert!(out.truncated[0] && out.rewards[0] == 0.0 && out.players[0] == -1);
    assert_eq!(vector.observe(0, 0).expect("an environment"), seen);
    let refused =
        VectorEnv::new(task, 1, 0, Config { max_episode_steps: Some(0), ..Config::of(task) });
    assert!(refused.is_err_and(|error| error.to_string().starts_with("max_episode_steps")));
}

#[test]
fn settings_out_of_range_are_refused_with_their_place() {
    let refused = |task, config| match VectorEnv::new(task, 1, 0, config) {
        Ok(_) => String::new(),
        Err(error) => error.to_string(),
    };
    let potting = Config::of(Task::Potting);
    let pocketless = Config {
        setups: vec![Setup { table: Some("carom-10ft".into()), physics: None }],
        ..potting.clone()
    };
    assert!(refused(Task::Potting, pocketless).starts_with("table"));
    let heap = Config { balls: Some([1, 40]), ..potting };
    assert!(refused(Task::Potting, heap).starts_with("balls"));
    for (task, balls) in [
        (Task::SumToThree, [2, 2]),
        (Task::Game(Game::ThreeCushion), [1, 2]),
        (Task::Game(Game::StraightPool), [1, 5]),
        (Task::Game(Game::TenBall), [1, 11]),
        (Task::Game(Game::Snooker), [0, 16]),
    ] {
        let middle = Config { balls: Some(balls), ..Config::of(task) };
        assert!(refused(task, middle).starts_with("balls"), "{}", task.name());
    }
    let mut pointless = Config::of(Task::SumToThree);
    pointless.options.points = 0;
    assert!(refused(Task::SumToThree, pointless).starts_with("options.points"));
    let mut endless = Config::of(Task::Potting);
    endless.rewards.pot = f64::INFINITY;
    assert!(refused(Task::Potting, endless).starts_with("rewards.pot"));
    let idle = Config { threads: Some(0), ..Config::of(Task::Potting) };
    assert!(refused(Task::Potting, idle).starts_with("threads"));
    let mut vector = environments(Task::SumToThree, 2, Config::of(Task::SumToThree));
    assert!(vector.step(&[0.0; 3]).is_err());
    assert!(vector.reset(Some(&[1]), None).is_err());
    assert!(vector.observe(2, 0).is_err() && vector.observe(0, 2).is_err());
}

#[test]
fn a_number_of_environments_that_would_exhaust_the_memory_is_refused() {
    let config = Config::of(Task::Potting);
    for n in [MAX_ENVIRONMENTS + 1, usize::MAX] {
        let refused = VectorEnv::new(Task::Potting, n, 0, config.clone());
        assert!(refused.is_err_and(|error| error.to_string().starts_with("n: ")));
    }
}

#[test]
fn an_action_without_elevation_is_struck_at_the_default_elevation() {
    let stroke = |degrees: f64| {
        let cue = Node::object([("stroke_elevation_deg", degrees.into())]);
        Some(Node::object([("cue", cue)]))
    };
    let end = |max_elevation: f64, action: f32, physics: Option<Node>| {
        let setups = vec![Setup { table: None, physics }];
        let config = Config { max_elevation, setups, ..Config::of(Task::SumToThree) };
        let mut vector = environments(Task::SumToThree, 20, config);
        let mut all = actions(20 * vector.action_size(), 1);
        for one in all.chunks_mut(vector.action_size()) {
            one[4] = action;
        }
        vector.step(&all).expect("a step").observations.to_vec()
    };
    let default = end(0.5, -1.0, None);
    assert_eq!(default, end(0.5, 0.0, None));
    assert_eq!(default, end(0.0, 1.0, None), "it is the least elevation");
    assert_eq!(default, end(0.5, 0.0, stroke(3.0)));
    assert_ne!(default, end(0.5, 0.0, stroke(0.0)), "a level cue");
    assert_ne!(default, end(0.5, 0.5, None), "a raised cue");
}
