//! Saving a frame as bytes, and frames that others may see.

use super::{Frame, StalemateCounter};
use crate::games::GameState;
use crate::layout::BallIndex;
use crate::request::Request;
use crate::state::FrameState;
use crate::state_bytes::StateBytes;

impl Frame {
    /// Appends everything that [`Self::read_same`] needs to continue this frame with the same bits. The
    /// game, the table and the physics are not among it.
    pub fn write_to(&self, out: &mut Vec<u8>) {
        let Self { game: _, game_state, state, request, stalemates, shots } = self;
        state.write_to(out);
        game_state.write_to(out);
        request.write_to(out);
        stalemates.write_to(out);
        shots.write_to(out);
    }

    /// The frame that `bytes` begin with, of the same game with the same table and physics as this one;
    /// none if they hold no such frame. `bytes` then begin behind it.
    pub fn read_same(&self, bytes: &mut &[u8]) -> Option<Self> {
        let state = FrameState::read_same(&self.state, bytes)?;
        let game_state = GameState::read_same(&self.game_state, bytes)?;
        let request = Request::read_from(bytes)?;
        let stalemates = StalemateCounter::read_from(bytes)?;
        let shots = StateBytes::read_from(bytes)?;
        let is_ball = |ball: &BallIndex| usize::from(*ball) < state.layout.len();
        let is_whole = match &request {
            Request::Shot(turn) => is_ball(&turn.cue) && turn.on.iter().all(is_ball),
            Request::Choice { choices, .. } => !choices.is_empty(),
            Request::Over { .. } => true,
        };
        is_whole.then_some(Self { game: self.game, game_state, state, request, stalemates, shots })
    }

    /// The same frame without its seed, for a player: the racks to come are others than those of the
    /// frame itself.
    #[must_use]
    pub fn without_seed(&self) -> Self {
        let mut frame = self.clone();
        frame.reseed(0);
        frame
    }

    /// Replaces the seed of the racks to come.
    pub fn reseed(&mut self, seed: u64) {
        self.state.reseed(seed);
    }
}

#[cfg(test)]
mod tests {
    use carom::resolve::cue_ball::Strike;

    use crate::{Frame, FrameSimulator, Game, Options, Play, Request};

    /// Plays `shots` shots in different directions; every choice is answered by its first option.
    fn play_on(frame: &mut Frame, shots: u32) {
        let mut simulator = FrameSimulator::new();
        for k in 0..shots {
            while let Request::Choice { choices, .. } = frame.request() {
                let first = choices[0];
                frame.choose(first).expect("a choice");
            }
            let Some(turn) = frame.turn().copied() else { return };
            let azimuth = 1.5 + 0.7 * f64::from(k);
            let strike = Strike { speed: 5.0, azimuth, elevation: 0.1, side: 0.0, height: 0.0 };
            let size = frame.base().table().size;
            let places = [[0.5 * size.x, 0.19 * size.y], [0.46 * size.x, 0.1 * size.y], [0.1, 0.1]];
            let calls = [
                crate::Call::Nothing,
                crate::Call::Safety,
                crate::Call::On(turn.on.first().copied().unwrap_or(1)),
            ];
            for call in calls {
                let play = Play { call, ..Play::new(strike) };
                let places = places.map(Some).into_iter().chain([None]);
                let plays = places.map(|cue_ball| Play { cue_ball, ..play });
                let _ = plays.map(|play| frame.play_in(&mut simulator, &play)).find(Result::is_ok);
            }
        }
    }

    #[test]
    fn a_frame_of_every_game_continues_from_its_bytes_with_the_same_bits() {
        for game in Game::ALL {
            let options = Options { patience: 6, ..Options::default() };
            let mut frame = Frame::new(game, options, None, None, 5).expect("a frame");
            let template = Frame::new(game, Options::default(), None, None, 0).expect("a frame");
            for _ in 0..6 {
                let mut bytes = Vec::new();
                frame.write_to(&mut bytes);
                let mut rest = &bytes[..];
                let mut read = template.read_same(&mut rest).expect("a frame");
                assert!(rest.is_empty(), "{}", game.name());
                assert_eq!(format!("{read:?}"), format!("{frame:?}"), "{}", game.name());
                play_on(&mut read, 4);
                play_on(&mut frame, 4);
                assert_eq!(format!("{read:?}"), format!("{frame:?}"), "{}", game.name());
            }
        }
    }

    #[test]
    fn cut_or_changed_bytes_give_no_frame_or_one_that_can_be_used() {
        let frame = Frame::new(Game::Snooker, Options::default(), None, None, 5).expect("a frame");
        let mut whole = Vec::new();
        frame.write_to(&mut whole);
        for end in 0..whole.len() {
            assert!(frame.read_same(&mut &whole[..end]).is_none(), "{end}");
        }
        let mut refused = 0;
        for place in 0..whole.len() {
            let mut changed = whole.clone();
            changed[place] ^= 0xff;
            match frame.read_same(&mut &changed[..]) {
                Some(read) => drop(read.to_node()),
                None => refused += 1,
            }
        }
        assert!(refused > 20, "{refused}");
    }
}
