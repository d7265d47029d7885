//! Lists of a few values without a heap: a frame with them is copied without allocating.

use core::fmt;
use core::ops::Deref;

/// A list of at most `N` values. It reads as a slice.
#[derive(Clone, Copy)]
pub struct ShortList<T, const N: usize> {
    len: u8,
    values: [T; N],
}

impl<T: Copy + Default, const N: usize> ShortList<T, N> {
    /// An empty list.
    pub fn new() -> Self {
        const { assert!(N <= u8::MAX as usize) };
        Self { len: 0, values: [T::default(); N] }
    }

    /// Adds `value` at the end.
    ///
    /// # Panics
    /// If the list is full.
    pub fn push(&mut self, value: T) {
        self.values[usize::from(self.len)] = value;
        self.len += 1;
    }

    /// Removes all values.
    pub fn clear(&mut self) {
        self.len = 0;
    }
}

impl<T: Copy + Default, const N: usize> Default for ShortList<T, N> {
    fn default() -> Self {
        Self::new()
    }
}

impl<T, const N: usize> Deref for ShortList<T, N> {
    type Target = [T];

    fn deref(&self) -> &[T] {
        &self.values[..usize::from(self.len)]
    }
}

impl<T: Copy + Default, const N: usize> Extend<T> for ShortList<T, N> {
    fn extend<I: IntoIterator<Item = T>>(&mut self, values: I) {
        values.into_iter().for_each(|value| self.push(value));
    }
}

impl<T: Copy + Default, const N: usize> FromIterator<T> for ShortList<T, N> {
    fn from_iter<I: IntoIterator<Item = T>>(values: I) -> Self {
        let mut list = Self::new();
        list.extend(values);
        list
    }
}

impl<T: Copy + Default, const N: usize> From<&[T]> for ShortList<T, N> {
    fn from(values: &[T]) -> Self {
        values.iter().copied().collect()
    }
}

impl<'a, T, const N: usize> IntoIterator for &'a ShortList<T, N> {
    type Item = &'a T;
    type IntoIter = core::slice::Iter<'a, T>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

impl<T: PartialEq, const N: usize> PartialEq for ShortList<T, N> {
    fn eq(&self, other: &Self) -> bool {
        **self == **other
    }
}

impl<T: Eq, const N: usize> Eq for ShortList<T, N> {}

impl<T: PartialEq, const N: usize, const M: usize> PartialEq<[T; M]> for ShortList<T, N> {
    fn eq(&self, other: &[T; M]) -> bool {
        **self == other[..]
    }
}

impl<T: fmt::Debug, const N: usize> fmt::Debug for ShortList<T, N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        (**self).fmt(f)
    }
}

#[cfg(test)]
mod tests {
    use super::ShortList;

    type Three = ShortList<u16, 3>;

    #[test]
    fn a_list_holds_what_was_added_in_order() {
        let mut list: Three = [4, 2].into_iter().collect();
        list.push(9);
        assert_eq!(list, [4, 2, 9]);
        assert_eq!((list.len(), list[1], list.contains(&9)), (3, 2, true));
        assert_eq!(format!("{list:?}"), "[4, 2, 9]");
        list.clear();
        assert!(list.is_empty());
    }

    #[test]
    fn values_beyond_the_end_do_not_count_in_comparisons() {
        let mut used = Three::from(&[7, 8][..]);
        used.clear();
        used.push(1);
        assert_eq!(used, Three::from(&[1][..]));
        assert_ne!(used, [1, 8]);
    }

    #[test]
    #[should_panic(expected = "index out of bounds")]
    fn a_full_list_takes_no_more() {
        let _: Three = (0..4).collect();
    }
}
