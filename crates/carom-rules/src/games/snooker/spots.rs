//! Where colours come back (WPBSA, section 3, rule 7).

use carom::Table;
use carom::rack::snooker_spots;

use super::{COLORS, YELLOW};
use crate::BallIndex;
use crate::frame::State;

/// Spots those of the colours `balls`, which are off the table. Each goes to its own spot; those whose spot
/// is occupied, the highest first, to the highest spot that is free; if none is, as near to their own as
/// possible, towards the top cushion. They touch no ball.
pub(super) fn put_back(state: &mut State, balls: impl IntoIterator<Item = BallIndex>) {
    let table = state.base.table().clone();
    let State { layout, ruling, .. } = state;
    let mut homeless = Vec::new();
    for ball in balls {
        let own = spot_of(&table, ball);
        layout.put(ball, None);
        if layout.is_free(ball, own) {
            layout.put(ball, Some(own));
        } else {
            homeless.push(ball);
        }
        if !ruling.spotted.contains(&ball) {
            ruling.spotted.push(ball);
        }
    }
    homeless.sort_unstable();
    for ball in homeless.into_iter().rev() {
        let spots = COLORS.rev().map(|color| spot_of(&table, color));
        match spots.into_iter().find(|spot| layout.is_free(ball, *spot)) {
            Some(place) => layout.put(ball, Some(place)),
            None => layout.spot(ball, spot_of(&table, ball), &table, |_| true),
        }
    }
}

fn spot_of(table: &Table, color: BallIndex) -> [f64; 2] {
    snooker_spots(table)[usize::from(color - YELLOW)]
}
