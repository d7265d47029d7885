//! The groups of eight-ball: solids and stripes.

use crate::layout::BallIndex;

/// The seven balls that a player must pocket before the eight.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Group {
    /// 1 to 7.
    Solids,
    /// 9 to 15.
    Stripes,
}

impl Group {
    /// The group of `ball`; `None` for the eight and the cue ball.
    pub const fn of(ball: BallIndex) -> Option<Self> {
        match ball {
            1..=7 => Some(Self::Solids),
            9..=15 => Some(Self::Stripes),
            _ => None,
        }
    }

    pub(crate) fn balls(self) -> impl Iterator<Item = BallIndex> {
        match self {
            Self::Solids => 1..=7,
            Self::Stripes => 9..=15,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Group;

    #[test]
    fn each_group_has_seven_balls() {
        for group in [Group::Solids, Group::Stripes] {
            assert_eq!(group.balls().count(), 7);
            assert!(group.balls().all(|ball| Group::of(ball) == Some(group)));
        }
    }
}
