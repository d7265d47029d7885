//! The errors with which a player sees the balls.

use carom::math::Vec3;
use carom::noise::Perception;
use carom::shot::PlacedBall;
use carom::{BallState, Error};
use carom_rules::{ErrorDraw, Frame};

/// `frame` as a player with this `perception` sees it; `None` if the player sees the balls exactly.
///
/// # Errors
/// [`Error::Input`] if the balls of the frame overlap.
pub(crate) fn perceive(
    perception: &Perception,
    frame: &Frame,
    draw: ErrorDraw,
) -> Result<Option<Frame>, Error> {
    if perception.is_exact() {
        return Ok(None);
    }
    let layout = frame.layout();
    let on_table: Vec<_> = layout.on_table().collect();
    let placed = on_table.iter().filter_map(|&ball| {
        let [x, y] = layout.place(ball)?;
        let own = &layout.balls()[usize::from(ball)];
        let position = Vec3::new(x, y, own.ball.radius);
        let state = BallState { position, ..BallState::default() };
        Some(PlacedBall { id: own.id.clone(), ball: own.ball, state })
    });
    let shot = frame.base().with_balls(placed.collect(), None)?;
    let seen = perception.places(&shot, draw.seed, draw.index);
    let mut places = vec![None; layout.len()];
    for (ball, seen) in on_table.into_iter().zip(seen) {
        places[usize::from(ball)] = Some([seen.state.position.x, seen.state.position.y]);
    }
    frame.seen_at(&places).map(Some)
}

#[cfg(test)]
mod tests {
    use super::perceive;
    use carom::noise::Perception;
    use carom_rules::{ErrorDraw, Frame, Game, Options};

    fn frame() -> Frame {
        Frame::new(Game::NineBall, Options::default(), None, None, 3).unwrap()
    }

    #[test]
    fn a_player_sees_the_balls_a_little_off_their_places() {
        let frame = frame();
        let sees = |position, index| {
            perceive(&Perception::round(position), &frame, ErrorDraw { seed: 2, index }).unwrap()
        };
        assert!(sees(0.0, 0).is_none());
        let [one, other] = [0, 1].map(|index| sees(0.001, index).unwrap());
        assert_eq!(one.request(), frame.request());
        assert_ne!(one.layout(), frame.layout());
        assert_ne!(one.layout(), other.layout());
        assert_eq!(one.layout(), sees(0.001, 0).unwrap().layout());
        for ball in frame.layout().on_table() {
            let [a, b] = [&frame, &one].map(|frame| frame.layout().place(ball).unwrap());
            assert!((0..2).all(|k| (a[k] - b[k]).abs() < 0.006));
        }
    }
}
