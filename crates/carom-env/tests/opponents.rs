//! Environments against built-in players, through their public interface.

use carom::Noise;
use carom_arena::BuiltInPlayer;
use carom_env::{Aim, Autoreset, Config, OPPONENT_SIMULATIONS, Opponent, Rewards, Task, VectorEnv};
use carom_rules::Game;

/// Random actions that are the same for the same seed.
fn actions(count: usize, seed: u64) -> Vec<f32> {
    let mut state = seed;
    let mut next = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (state >> 40) as f32 / (1_u32 << 23) as f32 - 1.0
    };
    (0..count).map(|_| next()).collect()
}

/// The settings of a game against `opponent` that begins with few balls, so that frames are short.
fn short(game: Game, opponent: &str) -> Config {
    let balls = match game {
        Game::ThreeCushion => None,
        Game::Snooker => Some([0, 0]),
        _ => Some([2, 2]),
    };
    let mut config = Config {
        opponent: Opponent::read(opponent).expect("an opponent"),
        noise: Noise::olympiad(1.0),
        aim: Aim::Relative,
        balls,
        ..Config::of(Task::Game(game))
    };
    (config.options.points, config.options.patience) = (2, 8);
    config
}

fn environments(game: Game, n: usize, seed: u64, config: Config) -> VectorEnv {
    let mut vector = VectorEnv::new(Task::Game(game), n, seed, config).expect("a game");
    let seeds: Vec<u64> = (seed..seed + n as u64).collect();
    vector.reset(Some(&seeds), None).expect("seeds for all");
    vector
}

/// The bits of all results of environment `index` of `n`, whose seed is always the same.
fn bits(n: usize, index: usize, opponent: &str, threads: usize) -> Vec<u64> {
    let config = Config { threads: Some(threads), ..short(Game::NineBall, opponent) };
    let mut vector = environments(Game::NineBall, n, 20 - index as u64, config);
    let mut bits = Vec::new();
    for step in 0..3 {
        let one = actions(vector.action_size(), step);
        let out = vector.step(&one.repeat(n)).expect("a step");
        let size = vector.observation_size();
        bits.extend(
            out.observations[index * size..][..size].iter().map(|x| u64::from(x.to_bits())),
        );
        bits.push(out.rewards[index].to_bits());
    }
    bits
}

#[test]
fn a_players_decisions_are_the_same_for_any_number_of_threads_and_of_environments() {
    for opponent in ["carom:30", "level-1:30", "greedy:30"] {
        let alone = bits(1, 0, opponent, 1);
        for threads in 1..=3 {
            assert_eq!(bits(5, 2, opponent, threads), alone, "{opponent}, {threads} threads");
        }
        assert_ne!(bits(1, 0, "random", 1), alone, "{opponent} is another player");
    }
}

#[test]
fn every_player_plays_a_whole_frame_of_every_game() {
    let games = [
        Game::EightBall,
        Game::NineBall,
        Game::TenBall,
        Game::StraightPool,
        Game::Snooker,
        Game::ThreeCushion,
    ];
    for (k, name) in BuiltInPlayer::names().enumerate() {
        // Two games for each player; together each game has several players.
        for game in [games[k % games.len()], games[(k + 2) % games.len()]] {
            let failure = -1000.0;
            let config = Config {
                rewards: Rewards { failure, ..Rewards::of(Task::Game(game)) },
                autoreset_mode: Autoreset::Disabled,
                ..short(game, &format!("{name}:20"))
            };
            let mut vector = environments(game, 1, 3, config);
            let mut ended = false;
            for step in 0..100 {
                let out = vector.step(&actions(vector.action_size(), step)).expect("a step");
                assert!(out.rewards[0] > 0.5 * failure, "{name}, {}: a failure", game.name());
                ended = out.terminated[0] || out.truncated[0];
                if ended {
                    break;
                }
                assert_eq!(out.players[0], 0, "{name}, {}", game.name());
            }
            assert!(ended, "{name}, {}", game.name());
        }
    }
}

#[test]
fn a_player_that_thinks_wins_more_than_one_that_plays_at_random() {
    let earned = |opponent: &str| {
        let mut vector = environments(Game::EightBall, 20, 0, short(Game::EightBall, opponent));
        let steps = (0..4).map(|step| {
            let out = vector.step(&actions(20 * vector.action_size(), step)).expect("a step");
            out.rewards.iter().sum::<f64>()
        });
        steps.sum::<f64>()
    };
    let (player, random) = (earned("carom:30"), earned("random"));
    assert!(player < random - 5.0, "{player} against a player, {random} against random actions");
}

#[test]
fn a_clone_continues_against_the_same_player() {
    let mut vector = environments(Game::NineBall, 2, 0, short(Game::NineBall, "carom:30"));
    let width = 2 * vector.action_size();
    vector.step(&actions(width, 1)).expect("a step");
    let mut tried = vector.clone();
    let out = tried.step(&actions(width, 2)).expect("a step");
    assert_eq!(vector.step(&actions(width, 2)).expect("a step"), out);
}

#[test]
fn a_player_without_a_number_has_the_default_number_of_simulated_shots() {
    let seen = |opponent: String| {
        let config = Config {
            balls: None,
            autoreset_mode: Autoreset::Disabled,
            ..short(Game::EightBall, &opponent)
        };
        let mut vector = environments(Game::EightBall, 2, 0, config);
        vector.step(&actions(2 * vector.action_size(), 1)).expect("a step").observations
    };
    assert_eq!(seen("carom".into()), seen(format!("carom:{OPPONENT_SIMULATIONS}")));
    assert_ne!(seen("carom".into()), seen("carom:600".into()));
}

#[test]
fn opponents_are_read_by_their_names() {
    for name in Opponent::names() {
        assert_eq!(Opponent::read(name).expect("an opponent").name(), name);
    }
    for name in ["carom:200", "level-2:50", "cue-card[level-two=off]:500"] {
        assert_eq!(Opponent::read(name).expect("a player").name(), name);
    }
}

#[test]
fn unknown_opponents_are_refused_with_their_place_and_a_remedy() {
    for (name, place, remedy) in [
        ("someone", "opponent: ", "write one of none, random, potter, carom, level-1"),
        ("", "opponent: ", "potter"),
        ("potter:200", "opponent: ", "carom:200"),
        ("Carom", "opponent: ", "carom"),
        ("carom:0", "opponent: ", "write a whole number from 1"),
        ("carom:many", "opponent: ", "write a whole number from 1"),
        ("carom[finalists=-1]", "opponent.finalists: ", "write"),
        ("carom[shift=false", "opponent: ", "write settings"),
        ("greedy:5000001", "opponent: ", "5000000"),
    ] {
        let error = Opponent::read(name).expect_err(name).to_string();
        assert!(error.starts_with(place) && error.contains(remedy), "{name}: {error}");
    }
}

#[test]
fn a_task_without_a_referee_has_no_player_as_its_opponent() {
    for task in [Task::Potting, Task::SumToThree] {
        let opponent = Opponent::read("level-2").expect("a level");
        let refused = VectorEnv::new(task, 1, 0, Config { opponent, ..Config::of(task) });
        assert!(
            refused.is_err_and(|error| error.to_string().starts_with("opponent: ")),
            "{}",
            task.name()
        );
    }
}
