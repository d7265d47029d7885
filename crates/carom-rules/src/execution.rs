//! The execution of an intended strike: the errors of the player's hand.

use carom::noise::StruckBall;
use carom::resolve::cue_ball::Strike;
use carom::shot::Cling;
use carom::{Error, ErrorKind, Noise, Shot};

use crate::play::through_degrees;
use crate::seat::Seat;

/// Halvings of the interval between a playable and an unplayable strike: the place of the limit is
/// then known to the last bit of a double.
const HALVINGS: u32 = 53;

/// A variant of the noise: the seed of a stream of errors, and the number of the shot in it.
#[derive(Clone, Copy, Debug)]
pub struct ErrorDraw {
    /// The seed of the stream.
    pub seed: u64,
    /// The number of the shot in the stream.
    pub index: u64,
}

/// The seeds of the errors of a frame's strikes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ErrorSeeds {
    /// One seed for the frame: the number of the variant is that of all shots played before.
    Frame(u64),
    /// A seed for each seat, as in a match: the number of the variant is that of the seat's own shots
    /// before. So the errors of a seat do not depend on what the other one does.
    Seats([u64; 2]),
}

impl ErrorSeeds {
    /// The variant for the next shot of `seat`, after these numbers of shots of the two seats.
    pub(crate) fn draw(self, seat: Seat, shots: [u32; 2]) -> ErrorDraw {
        match self {
            Self::Frame(seed) => ErrorDraw { seed, index: shots.map(u64::from).iter().sum() },
            Self::Seats(seeds) => ErrorDraw { seed: seeds[seat], index: shots[seat].into() },
        }
    }
}

/// The strike that comes out when a player with this `noise` intends that of `prepared`, and the
/// contacts that cling ([`carom::noise`]). A drawn strike for which the tip's efficiency is too low
/// is moved straight back towards the intended one, to the nearest strike that can be played.
///
/// # Errors
/// [`Error::Input`] if the shot has no strike.
pub fn execute(noise: &Noise, prepared: &Shot, draw: ErrorDraw) -> Result<(Strike, Cling), Error> {
    let (ball, meant) = prepared
        .strike()
        .ok_or_else(|| ErrorKind::NoStrike.at("strike", "the shot has no strike", "give it one"))?;
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

#[cfg(test)]
mod tests {
    use super::{ErrorDraw, execute};
    use carom::noise::StruckBall;
    use carom::resolve::cue_ball::Strike;
    use carom::{Noise, Shot};

    use crate::{Frame, Game, Options, Play};

    fn frame() -> Frame {
        Frame::new(Game::NineBall, Options::default(), None, None, 3).unwrap()
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
}
