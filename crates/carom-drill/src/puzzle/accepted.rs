//! The puzzles that were found good, by theme.

use super::theme::Theme;

/// Written by `scripts/puzzles.py`: a line for each theme with its name, and `number:rating` of its puzzles, the
/// rating in tens.
const LIST: &str = include_str!("accepted.txt");

/// A puzzle of the list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ListedPuzzle {
    /// Its theme.
    pub theme: Theme,
    /// Its number among those of the theme.
    pub number: u32,
    /// Its difficulty on the scale of the levels' ratings, rounded to ten.
    pub rating: u32,
}

impl ListedPuzzle {
    /// The puzzle's id.
    pub fn id(&self) -> String {
        format!("{}-{}", self.theme.name(), self.number)
    }
}

/// All puzzles that were found good, theme by theme, in the order of their numbers.
pub fn accepted() -> impl Iterator<Item = ListedPuzzle> {
    LIST.lines().flat_map(|line| {
        let mut words = line.split(' ');
        let theme = words.next().and_then(|name| Theme::read(name).ok());
        words.filter_map(move |word| {
            let (number, rating) = word.split_once(':')?;
            let rating = 10 * rating.parse::<u32>().ok()?;
            Some(ListedPuzzle { theme: theme?, number: number.parse().ok()?, rating })
        })
    })
}
