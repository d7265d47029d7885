//! The hash of a frame: two programs that play the same game compare it after each move.

use carom::format::with_dated_names;
use carom::hash::WordHasher;

use super::Frame;

impl Frame {
    /// 64 bits over everything that decides how the frame goes on: the game and its options, table,
    /// physics and policies, the exact bits of the balls' places, the request, scores and fouls, all
    /// that the rules keep (groups, the ball on, the table before a foul, progress towards a
    /// stalemate), the shots of each seat, and the seed of the racks to come. The same version of the
    /// engine gives the same value on every platform.
    pub fn hash(&self) -> u64 {
        let mut hasher = WordHasher::default();
        hasher.text(self.game.name());
        hasher.text(&with_dated_names(&self.base().to_node()).to_json_line());
        let mut bytes = Vec::new();
        self.write_to(&mut bytes);
        hasher.bytes(&bytes);
        hasher.value()
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use carom::format::Node;

    use crate::options::Options;
    use crate::request::{Choice, Request};
    use crate::{Frame, Region};
    use carom::rack::Game;

    /// What is changed, and the change.
    type Change = (&'static str, fn(&mut Frame));

    fn frame(game: Game) -> Frame {
        Frame::new(game, Options::default(), None, None, 7).expect("a frame")
    }

    #[test]
    fn the_same_frame_has_the_same_hash_and_every_game_another() {
        let mut seen = std::collections::BTreeSet::new();
        for game in Game::ALL {
            let first = frame(game);
            assert_eq!(first.hash(), frame(game).hash());
            assert_eq!(first.hash(), first.clone().hash());
            assert!(seen.insert(first.hash()), "{}", game.name());
        }
    }

    #[test]
    fn each_part_of_the_state_changes_the_hash() {
        let base = frame(Game::EightBall);
        let changes: [Change; 23] = [
            ("a place, by one bit", |f| {
                let [x, y] = f.layout().place(3).expect("on the table");
                f.put(3, Some([x.next_up(), y]));
            }),
            ("a ball that is down", |f| f.put(3, None)),
            ("two balls exchanged", |f| {
                let places = [3, 4].map(|ball| f.layout().place(ball));
                f.put(3, places[1]);
                f.put(4, places[0]);
            }),
            ("a score", |f| f.state.scores[1] = 1),
            ("the other score", |f| f.state.scores[0] = 1),
            ("a negative score", |f| f.state.scores[0] = -1),
            ("a foul", |f| f.state.fouls[1] = 1),
            ("the points", |f| f.state.options.points = 41),
            ("the miss", |f| f.state.options.miss = false),
            ("the patience", |f| f.state.options.patience = 99),
            ("the seed", |f| f.state.reseed(8)),
            ("the racks so far", |f| {
                f.state.next_seed();
            }),
            ("the shots", |f| f.shots = [1, 0]),
            ("the other seat's shots", |f| f.shots = [0, 1]),
            ("the cap", |f| *f = f.clone().with_max_events(5)),
            ("progress", |f| {
                let state = &f.state;
                f.stalemates.update(crate::GameFacts::of(f.game), state, 1);
            }),
            ("the state of the game", |f| {
                f.game_state = (crate::GameFacts::of(Game::StraightPool).state)()
            }),
            ("a choice", |f| {
                f.request = Request::choice(0, &[Choice::PlayOn, Choice::Rebreak], "one")
            }),
            ("other choices", |f| {
                f.request = Request::choice(0, &[Choice::PlayOn, Choice::PassBack], "one")
            }),
            ("another chooser", |f| {
                f.request = Request::choice(1, &[Choice::PlayOn, Choice::PassBack], "one")
            }),
            ("the end", |f| f.request = Request::won(0, "one")),
            ("another winner", |f| f.request = Request::won(1, "one")),
            ("ball in hand elsewhere", |f| {
                let Request::Shot(turn) = &mut f.request else { panic!("a shot") };
                turn.hand = Some(Region::Anywhere);
            }),
        ];
        let mut hashes = vec![("nothing", base.hash())];
        for (what, change) in changes {
            let mut changed = base.clone();
            change(&mut changed);
            let same = hashes.iter().find(|(_, hash)| *hash == changed.hash());
            assert_eq!(same, None, "{what}");
            hashes.push((what, changed.hash()));
        }
    }

    #[test]
    fn table_and_physics_change_the_hash() {
        let with = |table: Option<&str>, physics: Option<&str>| {
            let node = |text: &str| Node::from(text);
            let (table, physics) = (table.map(node), physics.map(node));
            Frame::new(Game::NineBall, Options::default(), table, physics, 7).expect("it").hash()
        };
        let usual = with(None, None);
        assert_eq!(usual, with(Some("wpa-9ft"), None));
        assert_eq!(usual, with(Some("wpa-9ft"), Some("pool")));
        assert_ne!(usual, with(None, Some("pool-new-cloth")));
        assert_ne!(usual, with(Some("wpa-8ft"), None));
        let mut other = frame(Game::NineBall);
        let policy = carom::shot::StrikePolicy::from_names("refuse", "refuse").expect("policies");
        let base = other.state.base.with_strike_policy(policy).expect("a shot without a strike");
        other.state.base = Arc::new(base);
        // The policies of a frame are those of each play.
        assert_eq!(other.hash(), usual);
    }
}
