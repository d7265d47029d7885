//! Programs that speak `carom-arena/1`, over a channel in memory.

mod common;

use std::collections::VecDeque;
use std::sync::{Arc, Mutex};
use std::time::Instant;

use carom::Noise;
use carom::format::Node;
use carom_arena::{
    ArenaFrame, Ask, ChannelFault, Clock, Disclosure, Effect, EndReason, LineChannel, Match,
    MatchPlayer, MatchSettings, ProtocolPlayer, ProtocolSettings, REFUSALS, Response, play_frame,
};
use carom_mind::{Answer, Budget, Player};
use carom_plan::Progress;
use carom_rules::{Call, Frame, FrameSimulator, Game, Play, Request};
use common::{RandomPlayer, SECRET, made, played, short};

/// What a program writes after each message that it reads.
type Program = dyn FnMut(&Node) -> Vec<Result<String, ChannelFault>> + Send;

/// A channel to a program in this process. If the program has written nothing, its time is over.
struct Memory {
    program: Box<Program>,
    written: VecDeque<Result<String, ChannelFault>>,
    sent: Arc<Mutex<Vec<Node>>>,
}

impl LineChannel for Memory {
    fn send(&mut self, line: &str, _: Option<Instant>) -> Result<(), ChannelFault> {
        assert!(!line.contains('\n'), "{line}");
        let message = Node::from_json(line).unwrap();
        self.written.extend((self.program)(&message));
        self.sent.lock().unwrap().push(message);
        Ok(())
    }

    fn receive(&mut self, _: Option<Instant>) -> Result<String, ChannelFault> {
        self.written.pop_front().unwrap_or(Err(ChannelFault::TimeOver))
    }
}

fn text<'a>(node: &'a Node, key: &str) -> &'a str {
    match node.get(key) {
        Some(Node::Text(text)) => text,
        other => panic!("{key}: {other:?}"),
    }
}

fn id(node: &Node) -> i64 {
    match node.get("id") {
        Some(Node::Integer(id)) => *id,
        other => panic!("id: {other:?}"),
    }
}

/// A program that greets, is ready, and answers requests and refusals with the lines of `answer`.
fn program(
    mut answer: impl FnMut(&Node) -> Vec<String> + Send + 'static,
) -> impl FnMut(&Node) -> Vec<Result<String, ChannelFault>> + Send {
    move |message| match text(message, "type") {
        "hello" => vec![Ok(r#"{"type": "hello", "name": "test", "version": "1"}"#.into())],
        "match" => vec![Ok(r#"{"type": "ready"}"#.into())],
        "request" | "refused" => answer(message).into_iter().map(Ok).collect(),
        _ => Vec::new(),
    }
}

/// A player at the other end of a channel in memory, and all that was sent to it.
fn speaking(
    program: impl FnMut(&Node) -> Vec<Result<String, ChannelFault>> + Send + 'static,
    menu: u32,
) -> (ProtocolPlayer<Memory>, Arc<Mutex<Vec<Node>>>) {
    let sent = Arc::new(Mutex::new(Vec::new()));
    let channel =
        Memory { program: Box::new(program), written: VecDeque::new(), sent: Arc::clone(&sent) };
    (
        ProtocolPlayer::new(channel, ProtocolSettings { menu, ..ProtocolSettings::default() })
            .unwrap(),
        sent,
    )
}

/// Any player of a test's match.
struct Seated(Box<dyn MatchPlayer>);

impl MatchPlayer for Seated {
    fn respond(&mut self, ask: &Ask<'_>, budget: &Budget<'_>) -> Response {
        self.0.respond(ask, budget)
    }

    fn seconds(&self) -> Option<f64> {
        self.0.seconds()
    }

    fn frame_over(&mut self, frame: &ArenaFrame) {
        self.0.frame_over(frame);
    }
}

/// Plays frame 0 of a match, with `player` at seat 0.
fn played_by(
    of: &Arc<Match>,
    player: impl MatchPlayer + 'static,
    other: impl MatchPlayer + 'static,
) -> ArenaFrame {
    let mut simulator = FrameSimulator::new();
    let mut frame = ArenaFrame::begin(of.clone(), 0, SECRET.pair_seeds(0), &mut simulator).unwrap();
    let mut players = [Seated(Box::new(player)), Seated(Box::new(other))];
    play_frame(&mut frame, &mut players, &mut simulator, &Progress::default()).unwrap();
    frame
}

fn random() -> Box<dyn Player> {
    Box::new(RandomPlayer)
}

/// The play as an answer to request `id`.
fn play_line(frame: &Frame, play: &Play, id: i64) -> String {
    let strike = &play.strike;
    let numbers = [
        ("speed", strike.speed),
        ("azimuth", strike.azimuth),
        ("elevation", strike.elevation),
        ("side", strike.side),
        ("height", strike.height),
    ];
    let mut node = Node::object([
        ("type", "play".into()),
        ("id", id.into()),
        ("strike", Node::object(numbers.map(|(key, value)| (key, value.into())))),
    ]);
    if let Some(place) = play.cue_ball {
        node.set("cue_ball", place);
    }
    let name = |ball: u16| frame.layout().balls()[usize::from(ball)].id.clone();
    let call = match play.call {
        Call::On(ball) => Some(vec![("kind", "on".to_owned()), ("ball", name(ball))]),
        Call::Pocket(ball, pocket) => Some(vec![
            ("kind", "pocket".to_owned()),
            ("ball", name(ball)),
            ("into", pocket.name().into()),
        ]),
        _ => None,
    };
    if let Some(call) = call {
        let call = call.into_iter().map(|(key, value)| (key.to_owned(), value.into()));
        node.set("call", Node::Object(call.collect()));
    }
    node.to_json_line()
}

/// A random player whose answers go through the protocol.
struct RandomProgram {
    player: ProtocolPlayer<Memory>,
    next: Arc<Mutex<String>>,
    sent: Arc<Mutex<Vec<Node>>>,
}

impl RandomProgram {
    fn new() -> Self {
        let next = Arc::new(Mutex::new(String::new()));
        let answer = Arc::clone(&next);
        let (player, sent) = speaking(
            program(move |message| {
                let id = id(message).to_string();
                vec![answer.lock().unwrap().replace("-77", &id)]
            }),
            0,
        );
        Self { player, next, sent }
    }
}

impl MatchPlayer for RandomProgram {
    fn respond(&mut self, ask: &Ask<'_>, budget: &Budget<'_>) -> Response {
        let decision = RandomPlayer.decide(&ask.situation, budget).unwrap();
        let line = match decision.answer {
            Answer::Play(play) => play_line(ask.situation.frame, &play, -77),
            Answer::Choice(choice) => {
                format!(r#"{{"type": "choose", "id": -77, "choice": "{}"}}"#, choice.name())
            }
            Answer::Concede => r#"{"type": "concede", "id": -77}"#.into(),
        };
        *self.next.lock().unwrap() = line;
        self.player.respond(ask, budget)
    }

    fn frame_over(&mut self, frame: &ArenaFrame) {
        self.player.frame_over(frame);
    }
}

#[test]
fn a_player_whose_answers_go_through_the_protocol_plays_the_same_frame_to_the_bit() {
    for game in Game::ALL {
        let of = made(short(game));
        let direct = played(&of, 0, [random(), random()]);
        let (one, other) = (RandomProgram::new(), RandomProgram::new());
        let spoken = played_by(&of, one, other);
        assert_eq!(direct.moves().len(), spoken.moves().len(), "{}", game.name());
        for (direct, spoken) in direct.moves().iter().zip(spoken.moves()) {
            assert_eq!((direct.seat, direct.answer), (spoken.seat, spoken.answer));
            assert_eq!(direct.effect, spoken.effect);
        }
        assert_eq!(direct.end(), spoken.end());
    }
}

#[test]
fn no_message_has_a_seed_or_what_the_other_player_intended() {
    for game in [Game::NineBall, Game::EightBall, Game::Snooker, Game::ThreeCushion] {
        let of = made(short(game));
        let programs = [RandomProgram::new(), RandomProgram::new()];
        let sent = programs.each_ref().map(|program| Arc::clone(&program.sent));
        let [one, other] = programs;
        let frame = played_by(&of, one, other);
        let seeds = frame.seeds();
        let words = [seeds.rack].into_iter().chain(seeds.errors).chain(seeds.sight);
        let words: Vec<u64> = words.chain(seeds.decisions).collect();
        let mut intended = 0;
        for (seat, sent) in sent.iter().enumerate() {
            let sent = sent.lock().unwrap();
            let all: String = sent.iter().map(Node::to_json_line).collect();
            assert!(!all.contains("seed") && !all.contains("secret"), "{}", game.name());
            for word in &words {
                let written = [word.to_string(), (*word as i64).to_string(), format!("{word:x}")];
                assert!(written.iter().all(|text| !all.contains(text)), "{word}");
            }
            for made in frame.moves().iter().filter(|made| made.seat != seat) {
                if let (Some(Answer::Play(play)), Effect::Played { .. }) =
                    (made.answer, &made.effect)
                {
                    let number = format!("{:?}", play.strike.azimuth);
                    assert!(!all.contains(&number), "{}: {number}", game.name());
                    intended += 1;
                }
            }
        }
        assert!(intended > 4, "{}: {intended} shots", game.name());
    }
}

#[test]
fn a_request_has_what_the_rules_ask_and_the_last_executed_strike() {
    let of = made(short(Game::NineBall));
    let (one, other) = (RandomProgram::new(), RandomProgram::new());
    let sent = Arc::clone(&one.sent);
    let frame = played_by(&of, one, other);
    let sent = sent.lock().unwrap();
    let types: Vec<&str> = sent.iter().map(|message| text(message, "type")).collect();
    assert_eq!(types[..3], ["hello", "match", "request"]);
    assert_eq!(types[types.len() - 2..], ["over", "bye"]);
    assert!(types[3..types.len() - 2].iter().all(|kind| *kind == "request"));
    let first = &sent[2];
    assert_eq!((id(first), text(first, "kind")), (1, "shot"));
    assert_eq!(first.get("last"), Some(&Node::Null));
    assert_eq!(text(first, "in_hand"), "behind-head-string");
    assert_eq!(text(first.get("region").unwrap(), "name"), "behind-head-string");
    let Some(Node::Object(balls)) = first.get("balls") else { panic!("{first:?}") };
    assert_eq!(balls.len(), 10);
    // Before every later request of seat 0 somebody has shot.
    let Effect::Played { execution, .. } = &frame.moves()[0].effect else { panic!("a break") };
    let second = sent[3].get("last").unwrap();
    let own = frame.moves()[1].seat == 0;
    let strike = second.get("strike").and_then(|strike| strike.get("azimuth")).unwrap();
    if own {
        assert_eq!(*strike, Node::Number(execution.strike.azimuth));
    }
    assert!(second.get("ruling").is_some_and(|ruling| ruling.get("legal").is_some()));
    let over = &sent[sent.len() - 2];
    assert_eq!(text(over, "reason"), frame.end().unwrap().reason.name());
}

#[test]
fn noise_is_told_only_as_far_as_it_is_disclosed() {
    for (disclosure, told) in [
        (Disclosure::Both, [true, true]),
        (Disclosure::Own, [true, false]),
        (Disclosure::Nothing, [false, false]),
    ] {
        let noise = [Noise::olympiad(1.0), Noise::olympiad(2.0)];
        let of = made(MatchSettings { disclosure, noise, ..short(Game::NineBall) });
        let conceding =
            program(|message| vec![format!(r#"{{"type": "concede", "id": {}}}"#, id(message))]);
        let (player, sent) = speaking(conceding, 0);
        played_by(&of, player, random());
        for message in &sent.lock().unwrap()[1..3] {
            let Some(Node::List(noise)) = message.get("noise") else { panic!("{message:?}") };
            let known: Vec<bool> = noise.iter().map(|noise| *noise != Node::Null).collect();
            assert_eq!(known, told, "{disclosure:?}");
        }
    }
}

/// The refusals that `lines` cause, each an answer to the first request.
fn refusals(lines: Vec<Result<String, ChannelFault>>) -> Vec<Node> {
    let of = made(short(Game::NineBall));
    let mut lines = VecDeque::from(lines);
    let (player, sent) = speaking(
        move |message| match text(message, "type") {
            "hello" => vec![Ok(r#"{"type": "hello"}"#.into())],
            "match" => vec![Ok(r#"{"type": "ready"}"#.into())],
            "request" | "refused" => match lines.pop_front() {
                Some(line) => vec![line],
                None => vec![Ok(r#"{"type": "concede", "id": 1}"#.into())],
            },
            _ => Vec::new(),
        },
        0,
    );
    let frame = played_by(&of, player, random());
    assert_eq!(frame.end().unwrap().reason, EndReason::Conceded);
    let sent = sent.lock().unwrap();
    sent.iter().filter(|message| text(message, "type") == "refused").cloned().collect()
}

#[test]
fn a_line_that_is_no_answer_is_refused_with_place_fault_and_remedy() {
    let strike = r#""strike": {"speed": 2.0, "azimuth": 1.5}"#;
    let in_hand = r#""cue_ball": [0.635, 0.5]"#;
    let play = |rest: &str| format!(r#"{{"type": "play", "id": 1, {rest}}}"#);
    for (line, place, fault) in [
        ("hello".to_owned(), "line", "not JSON"),
        (String::new(), "line", "not JSON"),
        ("{\"type\": \"play\"".into(), "line", "not JSON"),
        ("[1, 2]".into(), "line", "a list of 2"),
        ("[".repeat(100_000), "line", "recursion limit"),
        ("{\"a\":".repeat(100_000), "line", "recursion limit"),
        (r#"{"id": 1}"#.into(), "type", "missing"),
        (r#"{"type": "shoot", "id": 1}"#.into(), "type", "no answer \"shoot\""),
        (r#"{"type": "concede"}"#.into(), "id", "missing"),
        (r#"{"type": "concede", "id": "1"}"#.into(), "id", "the text"),
        (r#"{"type": "concede", "id": 1.5}"#.into(), "id", "not a whole number"),
        (r#"{"type": "choose", "id": 1, "choice": "fly"}"#.into(), "choice", "not a choice"),
        (r#"{"type": "choose", "id": 1, "choice": "play-on"}"#.into(), "choice", "does not ask"),
        (r#"{"type": "pick", "id": 1, "item": 1}"#.into(), "type", "no menu"),
        (play(in_hand), "strike", "missing"),
        (play(r#""strike": {"azimuth": 1.5}"#), "strike.speed", "missing"),
        (play(r#""strike": {"speed": 2.0}"#), "strike.azimuth_deg", "missing"),
        (play(r#""strike": {"speed": NaN, "azimuth": 1.5}"#), "strike.speed", "NaN"),
        (play(r#""strike": {"speed": 1e999, "azimuth": 1.5}"#), "strike.speed", "too large"),
        (
            play(&format!(r#""strike": {{"speed": 90, "azimuth": 1.5}}, {in_hand}"#)),
            "strike.speed",
            "out of range",
        ),
        (
            play(r#""strike": {"speed": 2, "azimuth": 1.5, "azimuth_deg": 90}"#),
            "strike.azimuth",
            "same angle",
        ),
        (
            play(&format!(r#"{strike}, "cue_ball": [0.6, 2.0]"#)),
            "cue_ball",
            "not behind the head string",
        ),
        (play(&format!(r#"{strike}, "cue_ball": 3"#)), "cue_ball", "the number 3"),
        (play(&format!(r#"{strike}, {in_hand}, "call": {{"kind": "safety"}}"#)), "call", "safety"),
        (
            play(&format!(
                r#"{strike}, {in_hand}, "call": {{"kind": "pocket", "ball": "99", "into": "left"}}"#
            )),
            "call.ball",
            "99",
        ),
        (
            format!(r#"{{"type": "concede", "id": 1, "info": "{}"}}"#, "x".repeat(70_000)),
            "info",
            "bytes",
        ),
    ] {
        let refused = refusals(vec![Ok(line.clone())]);
        assert_eq!(refused.len(), 1, "{line:.80}");
        let [found, what, remedy] = ["place", "what", "remedy"].map(|key| text(&refused[0], key));
        assert_eq!(found, place, "{line:.80}: {what}");
        assert!(what.contains(fault), "{line:.80}: {what}");
        assert!(!remedy.is_empty(), "{line:.80}");
        assert_eq!(id(&refused[0]), 1);
    }
    let refused = refusals(vec![Err(ChannelFault::NotUtf8)]);
    assert_eq!((text(&refused[0], "place"), id(&refused[0])), ("line", 1));
}

#[test]
fn an_answer_to_another_request_is_refused_with_the_number_that_it_had() {
    for other in [0, 2, -1, 7] {
        let refused = refusals(vec![Ok(format!(r#"{{"type": "concede", "id": {other}}}"#))]);
        assert_eq!((id(&refused[0]), text(&refused[0], "place")), (other, "id"));
        assert!(text(&refused[0], "remedy").contains("answer request 1"));
    }
}

#[test]
fn the_second_of_two_answers_is_refused_at_the_next_request_and_the_frame_goes_on() {
    let of = made(MatchSettings { noise: [Noise::NONE; 2], ..short(Game::NineBall) });
    let mut requests = 0;
    let (player, sent) = speaking(
        program(move |message| {
            if text(message, "type") == "refused" {
                // The answer to the present request is already on its way.
                return Vec::new();
            }
            requests += 1;
            let id = id(message);
            let answer = if requests > 1 {
                format!(r#"{{"type": "concede", "id": {id}}}"#)
            } else {
                let play = r#""strike": {"speed": 0.2, "azimuth": -1.5}, "cue_ball": [0.6, 0.5]"#;
                format!(r#"{{"type": "play", "id": {id}, {play}}}"#)
            };
            vec![answer; if requests > 1 { 1 } else { 2 }]
        }),
        0,
    );
    let frame = played_by(&of, player, random());
    assert_eq!(frame.end().unwrap().reason, EndReason::Conceded);
    let sent = sent.lock().unwrap();
    let refused: Vec<i64> =
        sent.iter().filter(|message| text(message, "type") == "refused").map(id).collect();
    assert_eq!(refused, [1]);
    assert!(frame.moves().iter().any(|made| matches!(made.effect, Effect::Refused(_))));
}

#[test]
fn unknown_keys_are_passed_over() {
    let of = made(short(Game::NineBall));
    let (player, _) = speaking(
        |message| match text(message, "type") {
            "hello" => {
                vec![Ok(r#"{"type": "hello", "colour": "red", "options": {"x": 1}}"#.into())]
            }
            "match" => vec![Ok(r#"{"type": "ready", "x": [1]}"#.into())],
            "request" => vec![Ok(r#"{"type": "play", "id": 1, "x": {"y": null}, "strike":
                {"speed": 3, "azimuth_deg": 90, "z": 1}, "cue_ball": [0.635, 0.5], "call": null}"#
                .replace('\n', " "))],
            _ => Vec::new(),
        },
        0,
    );
    let frame = played_by(&of, player, random());
    assert!(matches!(frame.moves()[0].effect, Effect::Played { .. }), "{:?}", frame.moves()[0]);
    // The second request was not answered.
    assert_eq!(frame.end().unwrap().reason, EndReason::Stall);
}

#[test]
fn a_record_keeps_what_a_program_says_of_its_answer() {
    let of = made(short(Game::NineBall));
    let (player, _) = speaking(
        program(|message| {
            let info = r#"{"win_chance": 0.25, "simulations": 12, "text": "no ball is in sight"}"#;
            vec![format!(r#"{{"type": "concede", "id": {}, "info": {info}}}"#, id(message))]
        }),
        0,
    );
    let frame = played_by(&of, player, random());
    let made = &frame.moves()[0];
    assert_eq!((made.win_chance, made.cost.spent.simulations), (Some(0.25), 12));
    assert_eq!(text(made.info.as_ref().unwrap(), "text"), "no ball is in sight");
}

#[test]
fn a_pick_plays_the_item_of_the_menu() {
    let settings = MatchSettings { clock: [Clock::default(); 2], ..short(Game::EightBall) };
    let of = made(settings);
    let mut requests = 0;
    let (player, sent) = speaking(
        program(move |message| {
            requests += 1;
            match (requests, message.get("menu")) {
                (1, _) => vec![r#"{"type": "pick", "id": 1, "item": 99}"#.into()],
                (2, _) => vec![r#"{"type": "pick", "id": 1, "item": 2}"#.into()],
                _ => vec![format!(r#"{{"type": "concede", "id": {}}}"#, id(message))],
            }
        }),
        3,
    );
    let frame = played_by(&of, player, random());
    let sent = sent.lock().unwrap();
    let Some(Node::List(menu)) = sent[2].get("menu") else { panic!("{:?}", sent[2]) };
    assert_eq!(menu.len(), 3);
    for item in menu {
        for key in ["win_chance", "kept", "foul"] {
            let Some(Node::Number(chance)) = item.get(key) else { panic!("{item:?}") };
            assert!((0.0..=1.0).contains(chance), "{key}: {chance}");
        }
    }
    assert_eq!((text(&sent[3], "type"), text(&sent[3], "place")), ("refused", "item"));
    let Some(Answer::Play(play)) = frame.moves()[1].answer else { panic!("a play") };
    let azimuth = menu[1].get("play").and_then(|play| play.get("strike")?.get("azimuth"));
    assert_eq!(azimuth, Some(&Node::Number(play.strike.azimuth)));
    // The search for the plays of the menu is off the clock.
    assert!(frame.moves()[1].cost.seconds < 0.01, "{:?}", frame.moves()[1].cost);
    let error = ProtocolSettings { menu: 21, ..ProtocolSettings::default() }
        .check()
        .unwrap_err()
        .to_string();
    assert!(error.starts_with("menu: 21"), "{error}");
}

#[test]
fn the_menu_of_a_choice_has_its_choices() {
    let of = made(short(Game::EightBall));
    // A break that drives no ball to a rail: the other player chooses.
    let soft = program(|message| {
        let play = r#""strike": {"speed": 0.5, "azimuth": -1.5}, "cue_ball": [0.6, 0.5]"#;
        let id = id(message);
        match text(message, "kind") {
            "shot" if id == 1 => vec![format!(r#"{{"type": "play", "id": {id}, {play}}}"#)],
            _ => vec![format!(r#"{{"type": "concede", "id": {id}}}"#)],
        }
    });
    let (one, _) = speaking(soft, 0);
    let picking = |message: &Node| {
        let id = id(message);
        match text(message, "kind") {
            "choice" => vec![format!(r#"{{"type": "pick", "id": {id}, "item": 1}}"#)],
            _ => vec![format!(r#"{{"type": "concede", "id": {id}}}"#)],
        }
    };
    let (other, sent) = speaking(program(picking), 4);
    let frame = played_by(&of, one, other);
    let sent = sent.lock().unwrap();
    let asked = sent.iter().find(|message| message.get("choices").is_some()).unwrap();
    let (Some(Node::List(choices)), Some(Node::List(menu))) =
        (asked.get("choices"), asked.get("menu"))
    else {
        panic!("{asked:?}")
    };
    let names: Vec<&str> = menu.iter().map(|item| text(item, "choice")).collect();
    assert_eq!(Node::list(names.iter().copied()), Node::List(choices.clone()));
    let chosen = frame.moves().iter().find_map(|made| match made.answer {
        Some(Answer::Choice(choice)) => Some(choice.name()),
        _ => None,
    });
    assert_eq!(chosen, Some(names[0]));
}

#[test]
fn a_program_that_wishes_text_and_schema_gets_them() {
    let of = made(short(Game::EightBall));
    let (player, sent) = speaking(
        |message| match text(message, "type") {
            "hello" => {
                vec![Ok(r#"{"type": "hello", "options": {"text": true, "schema": true}}"#.into())]
            }
            "match" => vec![Ok(r#"{"type": "ready"}"#.into())],
            "request" if id(message) == 1 => vec![Ok(r#"{"type": "play", "id": 1,
                "strike": {"speed": 9, "azimuth_deg": 90}, "cue_ball": [0.635, 0.5]}"#
                .replace('\n', " "))],
            "request" => vec![Ok(format!(r#"{{"type": "concede", "id": {}}}"#, id(message)))],
            _ => Vec::new(),
        },
        2,
    );
    played_by(&of, player, random());
    let sent = sent.lock().unwrap();
    let requests: Vec<&Node> =
        sent.iter().filter(|message| text(message, "type") == "request").collect();
    let words = text(requests[1], "text");
    for part in ["You are player 0.", "Game: eight-ball.", "Pockets:", "Last shot:", "1. ", "2. "] {
        assert!(words.contains(part), "{part}: {words}");
    }
    assert!(words.len() < 3000, "{}: {words}", words.len());
    assert!(requests[0].get("schema").is_some_and(|schema| schema.get("properties").is_some()));
}

#[test]
fn a_program_that_is_never_ready_loses_the_frame() {
    let concede = r#"{"type": "concede", "id": 1}"#;
    for (hello, reason, why) in [
        (vec![], EndReason::Stall, "was not ready after 30 s"),
        (vec![concede; 11], EndReason::Stall, "found \"concede\" before \"hello\""),
        (
            vec![r#"{"type": "hello", "protocol": "carom-arena/2"}"#; 11],
            EndReason::Stall,
            "protocol",
        ),
        (
            vec![r#"{"type": "hello", "games": ["snooker"]}"#; 11],
            EndReason::Stall,
            "does not play nine-ball",
        ),
    ] {
        let of = made(short(Game::NineBall));
        let (player, sent) = speaking(
            move |message| match text(message, "type") {
                "hello" => hello.iter().map(|line| Ok((*line).to_owned())).collect(),
                _ => Vec::new(),
            },
            0,
        );
        let frame = played_by(&of, player, random());
        let end = frame.end().unwrap();
        assert_eq!((end.reason, end.winner), (reason, Some(1)));
        assert!(end.why.contains(why), "{}", end.why);
        let types: Vec<String> =
            sent.lock().unwrap().iter().map(|m| text(m, "type").to_owned()).collect();
        assert!(!types.contains(&"bye".to_owned()), "a program that has failed gets no more");
    }
}

#[test]
fn a_failure_of_the_channel_loses_the_frame_with_its_reason() {
    for (fault, reason) in [
        (ChannelFault::TimeOver, EndReason::TimeOver),
        (ChannelFault::Stall, EndReason::Stall),
        (ChannelFault::Crash("it ended with status 3".into()), EndReason::Crash),
        (ChannelFault::Flood, EndReason::Flood),
        (ChannelFault::LongLine, EndReason::LongLine),
    ] {
        let clock = [Clock::default(); 2];
        let of = made(MatchSettings { clock, ..short(Game::NineBall) });
        let (written, wanted) = (fault.clone(), fault);
        let (player, _) = speaking(
            move |message| match text(message, "type") {
                "hello" => vec![Ok(r#"{"type": "hello"}"#.into())],
                "match" => vec![Ok(r#"{"type": "ready"}"#.into())],
                _ => vec![Err(written.clone())],
            },
            0,
        );
        let frame = played_by(&of, player, random());
        let end = frame.end().unwrap();
        assert_eq!((end.reason, end.winner), (reason, Some(1)), "{wanted:?}");
    }
}

#[test]
fn the_eleventh_refused_line_loses_the_frame_and_a_stop_ends_the_match_without_a_result() {
    let of = made(short(Game::NineBall));
    let (player, sent) = speaking(program(|_| vec!["{}".into()]), 0);
    let frame = played_by(&of, player, random());
    assert_eq!(frame.end().unwrap().reason, EndReason::Refusals);
    let refused = |node: &&Node| text(node, "type") == "refused";
    assert_eq!(sent.lock().unwrap().iter().filter(refused).count(), REFUSALS as usize);

    let (mut player, _) = speaking(
        |message| match text(message, "type") {
            "hello" => vec![Err(ChannelFault::Stopped)],
            _ => Vec::new(),
        },
        0,
    );
    let mut simulator = FrameSimulator::new();
    let frame = ArenaFrame::begin(of, 0, SECRET.pair_seeds(0), &mut simulator).unwrap();
    let carom_arena::NextStep::Ask(ask) = frame.next() else { panic!("a break") };
    assert!(matches!(ask.situation.frame.request(), Request::Shot(_)));
    assert_eq!(player.respond(&ask, &Budget::simulations(1)), Response::Stop);
}

/// What the page of the protocol leaves out.
const LEFT_OUT: &str = "…";

/// Whether a message is as the page has it.
fn is_as_shown(shown: &Node, real: &Node) -> bool {
    match (shown, real) {
        (Node::Text(text), _) if text == LEFT_OUT => true,
        (Node::Object(shown), Node::Object(real)) => {
            let same = |((a, one), (b, other)): (&(String, Node), &(String, Node))| {
                a == b && is_as_shown(one, other)
            };
            shown.len() == real.len() && shown.iter().zip(real).all(same)
        }
        (Node::List(shown), Node::List(real)) => {
            let same = |(one, other): (&Node, &Node)| is_as_shown(one, other);
            shown.len() == real.len() && shown.iter().zip(real).all(same)
        }
        _ => shown == real,
    }
}

#[test]
fn the_session_of_the_page_is_what_the_referee_and_the_program_say() {
    let page = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/arena-protocol.md");
    let page = std::fs::read_to_string(page).unwrap();
    let lines_of = |who: &str| -> Vec<String> {
        page.lines().filter_map(|line| line.strip_prefix(who)).map(str::to_owned).collect()
    };
    let (shown, mut answers) = (lines_of("referee: "), VecDeque::from(lines_of("program: ")));
    assert!(!shown.is_empty(), "the page has no session");
    let clock = [Clock::simulations(1000).per_frame(); 2];
    let of = made(MatchSettings { clock, ..short(Game::EightBall) });
    let breaking = program(|message| {
        let play = r#""strike": {"speed": 0.5, "azimuth": -1.5}, "cue_ball": [0.6, 0.5]"#;
        match id(message) {
            1 => vec![format!(r#"{{"type": "play", "id": 1, {play}}}"#)],
            id => vec![format!(r#"{{"type": "concede", "id": {id}}}"#)],
        }
    });
    let (one, _) = speaking(breaking, 0);
    let (other, sent) = speaking(
        move |message| match text(message, "type") {
            "over" | "bye" => Vec::new(),
            _ => answers.pop_front().into_iter().map(Ok).collect(),
        },
        0,
    );
    played_by(&of, one, other);
    let sent = sent.lock().unwrap();
    let all: Vec<String> = sent.iter().map(Node::to_json_line).collect();
    assert_eq!(shown.len(), sent.len(), "{}", all.join("\n"));
    for (shown, real) in shown.iter().zip(sent.iter()) {
        let shown = Node::from_json(shown).unwrap();
        assert!(is_as_shown(&shown, real), "{}", real.to_json_line());
    }
}
