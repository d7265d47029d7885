//! A set of balls of one shot.

use crate::limits::MAX_BALLS;

/// Indices of balls, one bit each. An event changes few of the pairs; with sets the engine visits
/// only these.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct BallSet(u128);

impl Default for BallSet {
    fn default() -> Self {
        Self::EMPTY
    }
}

const _: () = assert!(MAX_BALLS <= u128::BITS as usize);

impl BallSet {
    pub(crate) const EMPTY: Self = Self(0);

    #[inline(always)]
    pub(super) fn of(balls: &[u16]) -> Self {
        balls.iter().fold(Self::EMPTY, |set, &ball| set.with(usize::from(ball)))
    }

    #[inline(always)]
    pub(crate) fn with(self, ball: usize) -> Self {
        Self(self.0 | 1 << ball)
    }

    #[inline(always)]
    pub(crate) fn contains(self, ball: usize) -> bool {
        self.0 >> ball & 1 == 1
    }

    #[inline(always)]
    pub(super) fn union(self, others: Self) -> Self {
        Self(self.0 | others.0)
    }

    #[inline(always)]
    pub(super) fn without(self, others: Self) -> Self {
        Self(self.0 & !others.0)
    }

    /// The balls, in ascending order.
    #[inline(always)]
    pub(super) fn balls(self) -> impl Iterator<Item = usize> {
        let mut left = self.0;
        core::iter::from_fn(move || {
            let first = left.trailing_zeros();
            // Clears the lowest bit; `checked_sub` ends the iteration at the empty set.
            left &= left.checked_sub(1)?;
            Some(first as usize)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::BallSet;

    #[test]
    fn a_set_lists_its_balls_in_ascending_order() {
        let set = BallSet::of(&[127, 3, 64, 0]);
        assert!(set.balls().eq([0, 3, 64, 127]));
        assert_eq!(BallSet::EMPTY.balls().next(), None);
    }

    #[test]
    fn union_joins_two_sets_and_without_takes_the_difference() {
        let (a, b) = (BallSet::of(&[1, 2]), BallSet::of(&[2, 100]));
        assert!(a.union(b).balls().eq([1, 2, 100]));
        assert!(b.contains(100) && !b.contains(1));
        assert!(a.without(b).balls().eq([1]));
        assert!(a.with(2).balls().eq([1, 2]));
    }
}
