//! Versions.

use std::ffi::c_char;

use carom::trace::ENGINE;

use crate::entry::{ErrorText, enter};

/// Version of this header: 10000 major + 100 minor + patch. A program compares it with
/// carom_version when it starts: the major and minor numbers must be equal.
pub const CAROM_VERSION: i32 = 100;

/// ENGINE with a final zero.
const ENGINE_TEXT: &str = concat!("carom ", env!("CARGO_PKG_VERSION"), "\0");
const _: () = assert!(ENGINE_TEXT.len() == ENGINE.len() + 1);

/// The version of the library that runs, in the form of CAROM_VERSION.
///
/// Threads: any.
#[unsafe(no_mangle)]
pub extern "C" fn carom_version() -> i32 {
    enter(&ErrorText::NONE, || Ok(CAROM_VERSION))
}

/// Name and version of the engine, as traces and records have them, such as "carom 0.1.0".
///
/// Ownership: the text belongs to the library and is never freed. Threads: any.
#[unsafe(no_mangle)]
pub extern "C" fn carom_engine() -> *const c_char {
    enter(&ErrorText::NONE, || Ok(ENGINE_TEXT.as_ptr().cast()))
}

#[cfg(test)]
mod tests {
    use super::CAROM_VERSION;

    #[test]
    fn the_number_is_that_of_the_package() {
        let parts = env!("CARGO_PKG_VERSION").split('.').map(|part| part.parse::<i32>().unwrap());
        assert_eq!(parts.fold(0, |sum, part| 100 * sum + part), CAROM_VERSION);
    }
}
