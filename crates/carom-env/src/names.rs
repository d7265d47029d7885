//! Reading the names of options.

use carom::{Error, ErrorKind};

/// The value of `all` that is called `name`, for the argument `place`.
pub(crate) fn named<T: Copy>(
    all: &[T],
    name_of: impl Fn(T) -> &'static str,
    place: &str,
    name: &str,
) -> Result<T, Error> {
    all.iter().copied().find(|value| name_of(*value) == name).ok_or_else(|| {
        let names: Vec<&str> = all.iter().map(|value| name_of(*value)).collect();
        ErrorKind::UnknownName
            .at(
                place,
                format!("there is no \"{name}\""),
                format!("write one of {}", names.join(", ")),
            )
            .with("name", name)
    })
}
