//! Contacts that cling.

/// Number of contacts of a shot that can cling, from the first. A break of fifteen balls has about a
/// hundred collisions of two balls; a limit keeps a shot free of allocations.
pub const MOST_CONTACTS: u32 = 256;

/// Contacts of two balls that cling in a shot (players also say kick or skid): chalk or dirt between
/// the balls raises their friction in this one collision.
///
/// Contacts are counted from 0 in the order of the shot. Every collision of exactly two balls
/// counts, also a slow one. Balls that are resolved together with a third one, or with the tip,
/// neither count nor cling.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Cling {
    /// A bit for each contact.
    contacts: [u64; MOST_CONTACTS as usize / 64],
    /// Coefficient of friction of these contacts; 0 if there are none.
    friction: f64,
}

impl Default for Cling {
    fn default() -> Self {
        Self::NONE
    }
}

impl Cling {
    /// No contact clings.
    pub const NONE: Self = Self { contacts: [0; MOST_CONTACTS as usize / 64], friction: 0.0 };

    /// These `contacts` cling, with this coefficient of `friction` at every slip speed. Contacts
    /// from [`MOST_CONTACTS`] on are left out.
    pub fn new(contacts: impl IntoIterator<Item = u32>, friction: f64) -> Self {
        let mut cling = Self::NONE;
        for contact in contacts.into_iter().filter(|&contact| contact < MOST_CONTACTS) {
            cling.contacts[(contact / 64) as usize] |= 1 << (contact % 64);
            cling.friction = friction;
        }
        cling
    }

    /// Whether no contact clings.
    pub fn is_empty(&self) -> bool {
        self.contacts.iter().all(|&contacts| contacts == 0)
    }

    /// Whether this contact clings.
    pub fn contains(&self, contact: u32) -> bool {
        contact < MOST_CONTACTS && self.contacts[(contact / 64) as usize] >> (contact % 64) & 1 == 1
    }

    /// The contacts that cling, ascending.
    pub fn contacts(&self) -> impl Iterator<Item = u32> + '_ {
        (0..MOST_CONTACTS).filter(|&contact| self.contains(contact))
    }

    /// The coefficient of friction of the contacts that cling; 0 if there are none.
    pub const fn friction(&self) -> f64 {
        self.friction
    }
}

#[cfg(test)]
mod tests {
    use super::{Cling, MOST_CONTACTS};

    #[test]
    fn a_cling_has_the_contacts_that_it_was_made_of() {
        let wanted = [0, 1, 63, 64, 200, 255];
        let cling = Cling::new(wanted.into_iter().rev().chain([MOST_CONTACTS, 1]), 0.2);
        assert!(cling.contacts().eq(wanted));
        assert!((0..2 * MOST_CONTACTS).all(|k| cling.contains(k) == wanted.contains(&k)));
        assert_eq!((cling.friction(), cling.is_empty()), (0.2, false));
    }

    #[test]
    fn clings_without_contacts_are_equal() {
        assert_eq!(Cling::new([], 0.2), Cling::NONE);
        assert_eq!(Cling::new([MOST_CONTACTS], 0.2), Cling::NONE);
        assert!(Cling::NONE.is_empty());
    }
}
