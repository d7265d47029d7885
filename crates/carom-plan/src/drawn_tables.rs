//! A shot on tables of which each may be the true one.
//!
//! What is known about a table is a distribution of its numbers, and tables that are drawn from it
//! stand for it. Variant number k of a question is played on drawn table number k modulo their
//! count, with the errors that it has without drawn tables. So the mean over all variants is a
//! probability that includes what is not known about the table, and the interval counts the tables
//! as clusters ([`clustered`](crate::interval::clustered)).

use std::sync::Arc;

use carom::{Error, ErrorKind, Shot};

/// Largest number of drawn tables. Intervals of a thousand tables are 3 % wider than those of
/// infinitely many; the shots take some megabytes.
pub const MOST_TABLES: usize = 1000;

/// A shot on drawn tables; by default there are none, and the shot is played on its own.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DrawnTables(Arc<[Shot]>);

impl DrawnTables {
    /// The drawn tables of these shots, which differ from each other in table and physics; of their
    /// strikes only the struck ball is used. If all are alike, nothing about the table is unknown,
    /// and one stands for all.
    ///
    /// # Errors
    /// [`Error::Input`] unless there are 2 to [`MOST_TABLES`], with the same balls and pockets.
    pub fn new(mut shots: Vec<Shot>) -> Result<Self, Error> {
        if !(2..=MOST_TABLES).contains(&shots.len()) {
            let what = format!("{} drawn tables are out of range", shots.len());
            return Err(ErrorKind::OutOfRange.at(
                "draws",
                what,
                format!("give 2 to {MOST_TABLES}"),
            ));
        }
        if let Some(other) = (1..shots.len()).find(|k| !are_alike(&shots[0], &shots[*k])) {
            return Err(mismatch(other));
        }
        if shots.iter().all(|shot| *shot == shots[0]) {
            shots.truncate(1);
        }
        Ok(Self(shots.into()))
    }

    /// Rejects drawn tables for another shot than `shot`.
    ///
    /// # Errors
    /// [`Error::Input`] if balls or pockets differ.
    pub fn check(&self, shot: &Shot) -> Result<(), Error> {
        match self.0.first() {
            Some(drawn) if !are_alike(drawn, shot) => Err(mismatch(0)),
            _ => Ok(()),
        }
    }

    /// Number of tables on which variants are played: 1 if there is nothing unknown.
    pub fn count(&self) -> usize {
        self.0.len().max(1)
    }

    /// Index of the table of variant number `variant`.
    pub fn index(&self, variant: u64) -> usize {
        (variant % self.count() as u64) as usize
    }

    /// The shots on which the variants of `shot` are played in turn.
    pub(crate) fn shots<'a>(&'a self, shot: &'a Shot) -> &'a [Shot] {
        if self.0.is_empty() { std::slice::from_ref(shot) } else { &self.0 }
    }

    /// The same tables with every shot changed by `change`; None if one has no room for it.
    pub(crate) fn changed(&self, change: impl FnMut(&Shot) -> Option<Shot>) -> Option<Self> {
        self.0.iter().map(change).collect::<Option<Vec<_>>>().map(|shots| Self(shots.into()))
    }
}

/// Whether results of the two shots have the same rows and columns.
fn are_alike(a: &Shot, b: &Shot) -> bool {
    let balls = |shot: &Shot| shot.balls().iter().map(|ball| ball.id.clone()).collect::<Vec<_>>();
    let pockets = |shot: &Shot| shot.table().pockets.iter().map(|p| p.name).collect::<Vec<_>>();
    balls(a) == balls(b) && pockets(a) == pockets(b) && a.cue_ball() == b.cue_ball()
}

fn mismatch(index: usize) -> Error {
    let what = "it has other balls or pockets than the shot";
    ErrorKind::Mismatch.at(format!("draws[{index}]"), what, "draw the table of this shot")
}

#[cfg(test)]
mod tests {
    use carom::Shot;

    use super::{DrawnTables, MOST_TABLES};

    fn shot(table: &str, width: f64) -> Shot {
        let file = format!(
            r#"{{"format": "carom-shot/1", "table": {{"base": "{table}", "width": {width}}},
            "balls": [{{"id": "cue", "position": [0.5, 0.5]}}], "strike": {{"ball": "cue",
            "speed": 1.0, "azimuth": 0.0}}}}"#
        );
        Shot::from_json(&file).expect("a shot")
    }

    #[test]
    fn variants_take_turns_on_the_tables() {
        let shots: Vec<Shot> = [1.42, 1.43, 1.44].map(|width| shot("carom-10ft", width)).into();
        let tables = DrawnTables::new(shots.clone()).expect("tables");
        assert_eq!((tables.count(), tables.index(0), tables.index(5)), (3, 0, 2));
        assert_eq!(tables.shots(&shots[0]), &shots[..]);
    }

    #[test]
    fn tables_that_are_all_alike_are_one() {
        let tables = DrawnTables::new(vec![shot("carom-10ft", 1.42); 5]).expect("tables");
        assert_eq!((tables.count(), tables.index(4)), (1, 0));
    }

    #[test]
    fn rejects_one_table_too_many_and_tables_of_other_pockets() {
        let one = shot("carom-10ft", 1.42);
        for shots in [vec![one.clone()], vec![one.clone(); MOST_TABLES + 1]] {
            let error = DrawnTables::new(shots).expect_err("out of range").to_string();
            assert!(error.starts_with("draws: "), "{error}");
        }
        let pool = shot("wpa-9ft", 1.27);
        let mixed = DrawnTables::new(vec![one.clone(), pool.clone()]).expect_err("pockets");
        assert!(mixed.to_string().starts_with("draws[1]: "), "{mixed}");
        let tables = DrawnTables::new(vec![one.clone(), shot("carom-10ft", 1.43)]).expect("tables");
        assert!(tables.check(&one).is_ok() && tables.check(&pool).is_err());
    }
}
