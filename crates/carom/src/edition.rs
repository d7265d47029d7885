//! The names of presets. `pool` means the newest values, `pool-2026-11` the values of that edition.
//!
//! A table of names only; the values are in `table/presets.rs` and `physics/presets.rs`. To change the
//! values of a preset, add an [`Edition`] with the same name behind the present ones, and keep the old
//! values under the old dated name. Records hold dated names, so they always replay.

/// A preset at one date. Its values never change.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Edition {
    /// The name without a date.
    pub name: &'static str,
    /// The name with the year and month of its values.
    pub dated: &'static str,
    /// Of a table, the dated name of the physics that belongs to it; of physics, its own dated name.
    pub physics: &'static str,
}

/// The editions of the physics. Those of one name are in the order of their dates.
pub const PHYSICS: &[Edition] = &[
    physics("pool", "pool-2026-11"),
    physics("pool", "pool-2026-12"),
    physics("pool-new-cloth", "pool-new-cloth-2026-12"),
    physics("pool-worn-cloth", "pool-worn-cloth-2026-12"),
    physics("pool-clean-balls", "pool-clean-balls-2026-12"),
    physics("pool-dirty-balls", "pool-dirty-balls-2026-12"),
    physics("pool-gold-crown", "pool-gold-crown-2026-12"),
    physics("pool-valley", "pool-valley-2026-12"),
    physics("snooker", "snooker-2026-11"),
    physics("snooker", "snooker-2026-12"),
    physics("english", "english-2026-11"),
    physics("english", "english-2026-12"),
    physics("carom", "carom-2026-11"),
    physics("carom", "carom-2026-12"),
    physics("poolfiz", "poolfiz-2026-11"),
    physics("ideal", "ideal-2026-11"),
];

/// The editions of the tables. Those of one name are in the order of their dates.
pub const TABLES: &[Edition] = &[
    table("wpa-9ft", "wpa-9ft-2026-11", "pool-2026-11"),
    table("wpa-9ft", "wpa-9ft-2026-12", "pool-2026-12"),
    table("wpa-8ft", "wpa-8ft-2026-11", "pool-2026-11"),
    table("wpa-8ft", "wpa-8ft-2026-12", "pool-2026-12"),
    table("bar-7ft", "bar-7ft-2026-11", "pool-2026-11"),
    table("bar-7ft", "bar-7ft-2026-12", "pool-2026-12"),
    table("showood-7ft", "showood-7ft-2026-11", "pool-2026-11"),
    table("showood-7ft", "showood-7ft-2026-12", "pool-2026-12"),
    table("snooker-12ft", "snooker-12ft-2026-11", "snooker-2026-11"),
    table("snooker-12ft", "snooker-12ft-2026-12", "snooker-2026-12"),
    table("english-7ft", "english-7ft-2026-11", "english-2026-11"),
    table("english-7ft", "english-7ft-2026-12", "english-2026-12"),
    table("carom-10ft", "carom-10ft-2026-11", "carom-2026-11"),
    table("carom-10ft", "carom-10ft-2026-12", "carom-2026-12"),
    table("carom-9ft", "carom-9ft-2026-11", "carom-2026-11"),
    table("carom-9ft", "carom-9ft-2026-12", "carom-2026-12"),
    table("poolfiz", "poolfiz-2026-11", "poolfiz-2026-11"),
    table("chinese-9ft", "chinese-9ft-2026-12", "pool-2026-12"),
];

const fn physics(name: &'static str, dated: &'static str) -> Edition {
    Edition { name, dated, physics: dated }
}

const fn table(name: &'static str, dated: &'static str, physics: &'static str) -> Edition {
    Edition { name, dated, physics }
}

/// The edition of that dated name, or the newest one of that name without a date.
pub fn find<'a>(editions: &'a [Edition], name: &str) -> Option<&'a Edition> {
    editions.iter().rev().find(|edition| edition.dated == name || edition.name == name)
}

impl Edition {
    /// Whether this is the newest of `editions` with its name.
    pub fn is_newest_of(&self, editions: &[Self]) -> bool {
        find(editions, self.name) == Some(self)
    }

    /// The name without a date if this is the newest of `editions`, else the dated name. So a table
    /// or the physics of a record is equal to today's, if the values are.
    pub fn current_name(&self, editions: &[Self]) -> &'static str {
        if self.is_newest_of(editions) { self.name } else { self.dated }
    }
}

/// The `N` names without a date. Editions of one name stand together.
pub(crate) const fn undated<const N: usize>(editions: &[Edition]) -> [&'static str; N] {
    let mut names = [""; N];
    let (mut count, mut i) = (0, 0);
    while i < editions.len() {
        let name = editions[i].name;
        if count == 0 || !is_same(name, names[count - 1]) {
            names[count] = name;
            count += 1;
        }
        i += 1;
    }
    assert!(count == N, "the number of names");
    names
}

/// Whether two names are equal, for constants.
const fn is_same(a: &str, b: &str) -> bool {
    let (a, b) = (a.as_bytes(), b.as_bytes());
    let mut i = 0;
    while i < a.len() && i < b.len() && a[i] == b[i] {
        i += 1;
    }
    i == a.len() && i == b.len()
}

/// The names of a physics preset without a date, or else the dated name: [`Edition::current_name`].
/// `None` if there is no such preset.
pub fn current_physics_name(name: &str) -> Option<&'static str> {
    find(PHYSICS, name).map(|edition| edition.current_name(PHYSICS))
}

/// A name for each edition, once: the names without a date, then the dated names of older editions.
pub fn listed(editions: &[Edition]) -> alloc::vec::Vec<&'static str> {
    let of = |is_newest| {
        let kept = editions.iter().filter(move |e| e.is_newest_of(editions) == is_newest);
        kept.map(|edition| edition.current_name(editions))
    };
    of(true).chain(of(false)).collect()
}

/// The names without a date, and after them the dated names: what an error lists.
pub fn names(editions: &[Edition]) -> alloc::vec::Vec<&'static str> {
    let newest = editions.iter().filter(|edition| edition.is_newest_of(editions));
    let dated = editions.iter().map(|edition| edition.dated);
    newest.map(|edition| edition.name).chain(dated).collect()
}

#[cfg(test)]
mod tests {
    use super::{Edition, PHYSICS, TABLES, find, names, physics};

    const TWO: &[Edition] = &[
        physics("pool", "pool-2026-11"),
        physics("pool", "pool-2027-03"),
        physics("carom", "carom-2026-11"),
    ];

    #[test]
    fn a_name_without_a_date_is_the_newest_edition() {
        assert_eq!(find(TWO, "pool").unwrap().dated, "pool-2027-03");
        assert_eq!(find(TWO, "pool-2026-11").unwrap().dated, "pool-2026-11");
        assert_eq!(find(TWO, "pool-2026"), None);
    }

    #[test]
    fn only_an_old_edition_keeps_its_date() {
        assert_eq!(find(TWO, "pool-2026-11").unwrap().current_name(TWO), "pool-2026-11");
        assert_eq!(find(TWO, "pool-2027-03").unwrap().current_name(TWO), "pool");
    }

    #[test]
    fn every_edition_is_listed_once() {
        assert_eq!(super::listed(TWO), ["pool", "carom", "pool-2026-11"]);
    }

    #[test]
    fn the_list_of_names_has_each_name_once() {
        assert_eq!(names(TWO), ["pool", "carom", "pool-2026-11", "pool-2027-03", "carom-2026-11"]);
    }

    #[test]
    fn dated_names_are_the_name_and_a_year_and_a_month_in_order() {
        for editions in [PHYSICS, TABLES] {
            for (i, edition) in editions.iter().enumerate() {
                let date = edition.dated.strip_prefix(edition.name).unwrap();
                let (year, month) = date.strip_prefix('-').unwrap().split_once('-').unwrap();
                assert!(year.len() == 4 && year.parse::<u16>().unwrap() >= 2026, "{edition:?}");
                assert!(month.len() == 2, "{edition:?}");
                assert!((1..=12).contains(&month.parse::<u8>().unwrap()), "{edition:?}");
                let later = &editions[i + 1..];
                assert!(
                    later
                        .iter()
                        .all(|other| other.name != edition.name || other.dated > edition.dated)
                );
                assert!(find(PHYSICS, edition.physics).unwrap().dated == edition.physics);
            }
        }
    }
}
