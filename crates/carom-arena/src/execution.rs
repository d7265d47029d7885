//! The execution of an intended strike: the errors of the player's hand.

use carom::math::Vec3;
use carom::noise::{Perception, StruckBall};
use carom::resolve::cue_ball::Strike;
use carom::shot::{Cling, PlacedBall};
use carom::{BallState, Error, Noise, Shot};
use carom_rules::{Frame, through_degrees};

/// Halvings of the interval between a playable and an unplayable strike: the place of the limit is
/// then known to the last bit of a double.
const HALVINGS: u32 = 53;

/// A variant of the noise: the seed of a stream of errors, and the number of the shot in it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ErrorDraw {
    pub(crate) seed: u64,
    pub(crate) index: u64,
}

/// The strike that comes out when a player with this `noise` intends that of `prepared`, and the
/// contacts that cling ([`carom::noise`]). A drawn strike for which the tip's efficiency is too low
/// is moved straight back towards the intended one, to the nearest strike that can be played.
///
/// # Errors
/// [`Error::Input`] if the shot has no strike.
pub(crate) fn execute(
    noise: &Noise,
    prepared: &Shot,
    draw: ErrorDraw,
) -> Result<(Strike, Cling), Error> {
    let (ball, meant) = prepared
        .strike()
        .ok_or_else(|| Error::input("strike", "the shot has no strike", "give it one"))?;
    let cling = noise.draw_cling(draw.seed, draw.index);
    let struck = StruckBall::of(prepared, &prepared.balls()[ball].ball);
    let drawn = noise.draw(&meant, &struck, draw.seed, draw.index);
    let playable = |strike: &Strike| prepared.resolve_strike(&through_degrees(strike)).is_ok();
    if playable(&drawn) {
        return Ok((drawn, cling));
    }
    let [mut inside, mut outside] = [0.0, 1.0];
    for _ in 0..HALVINGS {
        let middle = 0.5 * (inside + outside);
        if playable(&between(&meant, &drawn, middle)) {
            inside = middle;
        } else {
            outside = middle;
        }
    }
    Ok((between(&meant, &drawn, inside), cling))
}

/// The strike at `fraction` of the way from `from` to `to`.
fn between(from: &Strike, to: &Strike, fraction: f64) -> Strike {
    let at = |a: f64, b: f64| a + fraction * (b - a);
    Strike {
        speed: at(from.speed, to.speed),
        azimuth: at(from.azimuth, to.azimuth),
        elevation: at(from.elevation, to.elevation),
        side: at(from.side, to.side),
        height: at(from.height, to.height),
    }
}

/// `frame` as a player with this `perception` sees it; `None` if the player sees the balls exactly.
///
/// # Errors
/// [`Error::Input`] if the balls of the frame overlap.
pub(crate) fn perceive(
    perception: &Perception,
    frame: &Frame,
    draw: ErrorDraw,
) -> Result<Option<Frame>, Error> {
    if perception.position == 0.0 {
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
    use super::{ErrorDraw, execute, perceive};
    use carom::noise::{Perception, StruckBall};
    use carom::resolve::cue_ball::Strike;
    use carom::{Noise, Shot};
    use carom_rules::{Frame, Options, Play, Rules};

    fn frame() -> Frame {
        Frame::new(Rules::NineBall, Options::default(), None, None, 3).unwrap()
    }

    fn prepared(strike: Strike) -> Shot {
        frame().shot(&Play::new(strike).from([0.635, 0.5])).unwrap()
    }

    const CENTRE: Strike =
        Strike { speed: 3.0, azimuth: 1.5, elevation: 0.1, side: 0.0, height: 0.0 };

    #[test]
    fn a_playable_draw_is_the_variant_of_the_noise() {
        let shot = prepared(CENTRE);
        let noise = Noise::olympiad(1.0);
        let meant = shot.strike().unwrap().1;
        let struck = StruckBall::of(&shot, &shot.balls()[0].ball);
        for index in 0..20 {
            let (executed, cling) = execute(&noise, &shot, ErrorDraw { seed: 5, index }).unwrap();
            assert_eq!(executed, noise.draw(&meant, &struck, 5, index));
            assert!(cling.is_empty());
        }
    }

    #[test]
    fn a_draw_beyond_the_miscue_limit_is_moved_back_to_it() {
        let limit = prepared(CENTRE).miscue_limit();
        let shot = prepared(Strike { side: 0.98 * limit, ..CENTRE });
        let noise = Noise { side_m: 0.005, ..Noise::NONE };
        let moved = (0..40)
            .map(|index| execute(&noise, &shot, ErrorDraw { seed: 1, index }).unwrap().0)
            .inspect(|strike| assert!(shot.resolve_strike(strike).is_ok(), "{strike:?}"))
            .filter(|strike| (strike.side - 0.999 * limit).abs() < 1e-9)
            .count();
        assert!((10..=30).contains(&moved), "about half of the draws: {moved}");
    }

    #[test]
    fn a_speed_below_zero_is_moved_back_to_a_slow_strike() {
        let shot = prepared(Strike { speed: 0.2, ..CENTRE });
        let noise = Noise { speed: 1.0, ..Noise::NONE };
        for index in 0..40 {
            let (strike, _) = execute(&noise, &shot, ErrorDraw { seed: 1, index }).unwrap();
            assert!(shot.resolve_strike(&strike).is_ok(), "{strike:?}");
        }
    }

    #[test]
    fn a_player_sees_the_balls_a_little_off_their_places() {
        let frame = frame();
        let sees = |position, index| {
            perceive(&Perception { position }, &frame, ErrorDraw { seed: 2, index }).unwrap()
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
