//! Spotting colours (WPBSA, section 3, rule 7).

use carom::rack::snooker_spots;

use super::balls::Balls;
use crate::layout::{BallIndex, BallList};
use crate::state::FrameState;

/// Spots the colours `balls`, which are off the table, in ascending order. Each goes to its own spot if that is free.
/// The others follow, the highest first, each to the highest free spot; if no spot is free, as near
/// to its own spot as possible on the line to the top cushion. A spotted ball touches no other
/// ball.
pub(super) fn put_back(state: &mut FrameState, balls: &[BallIndex]) {
    let FrameState { base, layout, ruling, .. } = state;
    let (table, all) = (base.table(), Balls::of(layout));
    let spot_of = |color: BallIndex| snooker_spots(table)[usize::from(color - all.yellow)];
    let mut displaced = BallList::new();
    for &ball in balls {
        let own = spot_of(ball);
        layout.put(ball, None);
        if layout.is_free(ball, own) {
            layout.put(ball, Some(own));
        } else {
            displaced.push(ball);
        }
        if !ruling.spotted.contains(&ball) {
            ruling.spotted.push(ball);
        }
    }
    // Both callers list the colours in ascending order.
    for &ball in displaced.iter().rev() {
        match all.colors().rev().map(spot_of).find(|spot| layout.is_free(ball, *spot)) {
            Some(place) => layout.put(ball, Some(place)),
            None => layout.spot(ball, spot_of(ball), table, |_| true),
        }
    }
}
