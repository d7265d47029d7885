//! The place of a cue ball in hand on the true table.

use carom::math::Vec2;
use carom_rules::{Frame, Play};

/// Gap between a cue ball that was moved and the ball that was in its way, m: 0.2 mm, two sheets of
/// paper. Rules count balls with a gap of up to 0.1 mm as touching.
const GAP: f64 = 2e-4;

/// `play` with the cue ball, if it is in hand, moved away from balls that are in its way: straight
/// away from each of them, as far as needed. A player who sees the balls with errors may put the
/// cue ball where there is truly no room.
pub(super) fn clear_of_balls(frame: &Frame, play: &Play) -> Play {
    let (Some([x, y]), Some(turn)) = (play.cue_ball, frame.turn()) else { return *play };
    let layout = frame.layout();
    let radius = layout.balls()[usize::from(turn.cue)].ball.radius;
    let mut place = Vec2::new(x, y);
    for ball in layout.on_table().filter(|ball| *ball != turn.cue) {
        let Some([x, y]) = layout.place(ball) else { continue };
        let reach = radius + layout.balls()[usize::from(ball)].ball.radius;
        let away = place - Vec2::new(x, y);
        let distance = away.length();
        if distance <= reach && distance > 0.0 {
            place = Vec2::new(x, y) + away * ((reach + GAP) / distance);
        }
    }
    Play { cue_ball: Some([place.x, place.y]), ..*play }
}
