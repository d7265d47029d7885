//! Grids whose cells are computed on many threads.

use carom::runner::Runner;
use carom::{Error, ErrorKind};

use crate::progress::Progress;

/// Largest number of cells of one grid. Ten million cells of a map hold some 300 MB, and even with
/// the shortest simulations of 5 µs they take a minute on one core. A larger number is usually a
/// mistake, and a failed allocation would abort the process.
pub const MAX_CELLS: usize = 10_000_000;

/// Rejects axes whose lengths multiply to more than [`MAX_CELLS`].
///
/// # Errors
/// [`Error::Input`] at `place`, which names the axes.
pub fn check_cells(place: &str, axes: &[usize]) -> Result<usize, Error> {
    let cells = axes.iter().try_fold(1_usize, |cells, length| cells.checked_mul(*length));
    match cells {
        Some(cells) if cells <= MAX_CELLS => Ok(cells),
        _ => {
            let lengths: Vec<String> = axes.iter().map(usize::to_string).collect();
            let what = format!("{} are too many cells", lengths.join(" × "));
            Err(ErrorKind::WrongCount.at(place, what, format!("give at most {MAX_CELLS} in all")))
        }
    }
}

/// The results of `answer` for the cells 0 to `cells` − 1; None for cells that were not reached
/// before `progress` was stopped. Each thread has a worker of its own.
pub(crate) fn each_cell<W, T: Send>(
    cells: usize,
    threads: Option<usize>,
    progress: &Progress,
    make_worker: impl Fn() -> W + Sync + Send,
    answer: impl Fn(&mut W, usize) -> T + Sync + Send,
) -> Result<Vec<Option<T>>, Error> {
    let runner = Runner::new(threads)?;
    progress.begin(0, cells);
    Ok(runner.map(0..cells, make_worker, |worker, cell| {
        if progress.is_stopped() {
            return None;
        }
        let found = answer(worker, cell);
        progress.add(1);
        Some(found)
    }))
}

#[cfg(test)]
mod tests {
    use super::{MAX_CELLS, check_cells};

    #[test]
    fn a_grid_of_too_many_cells_is_rejected_with_its_size_and_the_limit() {
        assert_eq!(check_cells("speed, side", &[100, 100]).ok(), Some(10_000));
        for axes in [&[10_000, 100_000][..], &[usize::MAX, 2]] {
            let text = check_cells("speed, side", axes).expect_err("too many").to_string();
            assert!(text.starts_with("speed, side: "), "{text}");
            assert!(text.contains(&MAX_CELLS.to_string()), "{text}");
        }
    }
}
