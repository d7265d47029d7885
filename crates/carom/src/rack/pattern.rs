//! The order of the balls in a rack of pool. Places are numbered from the apex, row by row, from
//! left to right.

use alloc::vec::Vec;

use rand_pcg::Pcg64;

use super::game::Order;
use super::{below, shuffle};

/// Middle of the third row: the centre of the diamond and of every triangle.
const CENTER: usize = 4;
/// Back corners of a triangle of fifteen.
const CORNERS: [usize; 2] = [10, 14];
/// The last solid; the 8 is neither solid nor stripe.
const LAST_SOLID: u8 = 7;
const EIGHT: u8 = 8;

/// The numbers of `count` balls in the order of their places.
pub(super) fn numbers(count: usize, order: Order, random: &mut Pcg64) -> Vec<u8> {
    let last = count as u8;
    let mut numbers: Vec<u8> = (1..=last).collect();
    shuffle(&mut numbers, random);
    match order {
        Order::Any => {}
        Order::OneAndLast => {
            swap_into(&mut numbers, 1, 0);
            swap_into(&mut numbers, last, CENTER);
        }
        Order::Eight => eight_ball(&mut numbers, random),
    }
    numbers
}

/// WPA: the 8 in the middle, a solid in one back corner and a stripe in the other, the others in
/// any order.
fn eight_ball(order: &mut [u8], random: &mut Pcg64) {
    swap_into(order, EIGHT, CENTER);
    let solid_left = below(random, 2) == 0;
    for (corner, solid) in CORNERS.into_iter().zip([solid_left, !solid_left]) {
        let fits = |n: u8| n != EIGHT && (n <= LAST_SOLID) == solid;
        let candidates: Vec<usize> = (0..order.len()).filter(|&i| fits(order[i])).collect();
        // A random one of the balls that fit, so that every number is equally likely everywhere. It
        // is never the ball of the other corner, which is of the other kind.
        order.swap(corner, candidates[below(random, candidates.len())]);
    }
}

/// Swaps ball `n` with the ball at `place`, if the rack has ball `n`.
fn swap_into(order: &mut [u8], n: u8, place: usize) {
    if let Some(at) = order.iter().position(|&m| m == n) {
        order.swap(at, place);
    }
}
