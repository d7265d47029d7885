//! What every function does with its arguments, its errors and panics.

use std::ffi::{CStr, CString, c_char};
use std::panic::{AssertUnwindSafe, catch_unwind};

use carom::format::Node;
use carom::{Error, ErrorKind};

/// The call was refused: an argument or an input is wrong. The text of the error says what to do.
pub const CAROM_REFUSED: i32 = -1;
/// The shot reached its cap of events; the text of the error says what to do.
pub const CAROM_EVENT_CAP: i32 = -2;
/// A fault of carom. The call has no result; please report the text of the error.
pub const CAROM_FAULT: i32 = -3;

/// The value that stands for a failure.
pub(crate) trait Failure {
    fn failure(code: i32) -> Self;
}

impl Failure for i32 {
    fn failure(code: i32) -> Self {
        code
    }
}

impl Failure for u64 {
    fn failure(_: i32) -> Self {
        0
    }
}

impl Failure for f64 {
    fn failure(_: i32) -> Self {
        Self::NAN
    }
}

impl<T> Failure for Option<T> {
    fn failure(_: i32) -> Self {
        None
    }
}

impl<T> Failure for *const T {
    fn failure(_: i32) -> Self {
        std::ptr::null()
    }
}

impl<T> Failure for *mut T {
    fn failure(_: i32) -> Self {
        std::ptr::null_mut()
    }
}

impl Failure for () {
    fn failure(_: i32) {}
}

/// Where a function writes the text of its error.
pub(crate) struct ErrorText {
    text: *mut c_char,
    size: i32,
}

impl ErrorText {
    /// For a function that has no text of an error.
    pub(crate) const NONE: Self = Self { text: std::ptr::null_mut(), size: 0 };

    /// # Safety
    /// `text` is null, or `size` bytes from it on may be written during the call.
    pub(crate) const unsafe fn new(text: *mut c_char, size: i32) -> Self {
        Self { text, size }
    }

    /// Writes kind, place, fault and remedy of `refused`.
    pub(crate) fn note(&self, refused: &Error) {
        self.write(&format!("[{}] {refused}", refused.kind().name()));
    }

    /// Writes as much of `words` as there is room for, in whole characters, and a final zero.
    fn write(&self, words: &str) {
        let Some(room) = usize::try_from(self.size).ok().and_then(|size| size.checked_sub(1))
        else {
            return;
        };
        if self.text.is_null() {
            return;
        }
        let length = words.floor_char_boundary(room);
        // SAFETY: `new` was promised `size` bytes, and `length` is less.
        unsafe {
            std::ptr::copy_nonoverlapping(words.as_ptr(), self.text.cast::<u8>(), length);
            self.text.add(length).write(0);
        }
    }
}

/// The result of `work`. An error or a panic becomes the value that stands for a failure, with its
/// text in `error`; without one the text is empty.
pub(crate) fn enter<T: Failure>(error: &ErrorText, work: impl FnOnce() -> Result<T, Error>) -> T {
    error.write("");
    // Objects stay usable: a frame changes only when a move has succeeded, and the rest is immutable.
    match catch_unwind(AssertUnwindSafe(work)) {
        Ok(Ok(done)) => done,
        Ok(Err(refused)) => {
            error.note(&refused);
            let is_cap = matches!(refused, Error::TooManyEvents(_));
            T::failure(if is_cap { CAROM_EVENT_CAP } else { CAROM_REFUSED })
        }
        Err(panic) => {
            let words = panic.downcast_ref::<String>().map(String::as_str);
            let words = words.or_else(|| panic.downcast_ref::<&str>().copied()).unwrap_or("");
            error.write(&format!("[fault] a fault of carom: {words}; report it with this input"));
            // The payload may panic in its own drop.
            std::mem::forget(panic);
            T::failure(CAROM_FAULT)
        }
    }
}

/// The object behind a pointer.
pub(crate) fn given<T>(pointer: Option<T>, place: &str) -> Result<T, Error> {
    pointer.ok_or_else(|| missing(place))
}

fn missing(place: &str) -> Error {
    ErrorKind::Missing.at(place, "the pointer is null", "give an object")
}

/// The text at `pointer`; `None` for null.
///
/// # Safety
/// `pointer` is null or ends in a zero, and stays as it is for the call.
pub(crate) unsafe fn optional_text<'a>(
    pointer: *const c_char,
    place: &str,
) -> Result<Option<&'a str>, Error> {
    if pointer.is_null() {
        return Ok(None);
    }
    // SAFETY: the caller's promise.
    let text = unsafe { CStr::from_ptr(pointer) }.to_str();
    let refuse = |_| ErrorKind::Syntax.at(place, "the text is not UTF-8", "write UTF-8");
    text.map(Some).map_err(refuse)
}

/// The text at `pointer`.
///
/// # Safety
/// As [`optional_text`].
pub(crate) unsafe fn text<'a>(pointer: *const c_char, place: &str) -> Result<&'a str, Error> {
    // SAFETY: the caller's promise.
    unsafe { optional_text(pointer, place) }?.ok_or_else(|| missing(place))
}

/// The `length` values from `pointer` on; none of them if `length` is 0.
///
/// # Safety
/// `pointer` is null, or `length` values from it on stay as they are for the call.
pub(crate) unsafe fn slice<'a, T>(
    pointer: *const T,
    length: usize,
    place: &str,
) -> Result<&'a [T], Error> {
    if length == 0 {
        return Ok(&[]);
    }
    check_length::<T>(pointer, length, place)?;
    // SAFETY: the caller's promise; the pointer is aligned and not null, and the size fits.
    Ok(unsafe { std::slice::from_raw_parts(pointer, length) })
}

/// The same for values that are written.
///
/// # Safety
/// `pointer` is null, or `length` values from it on belong to this call alone.
pub(crate) unsafe fn slice_mut<'a, T>(
    pointer: *mut T,
    length: usize,
    place: &str,
) -> Result<&'a mut [T], Error> {
    if length == 0 {
        return Ok(&mut []);
    }
    check_length::<T>(pointer, length, place)?;
    // SAFETY: the caller's promise; the pointer is aligned and not null, and the size fits.
    Ok(unsafe { std::slice::from_raw_parts_mut(pointer, length) })
}

fn check_length<T>(pointer: *const T, length: usize, place: &str) -> Result<(), Error> {
    if pointer.is_null() {
        return Err(missing(place));
    }
    if !pointer.is_aligned() {
        let what = "the pointer is not aligned";
        return Err(ErrorKind::WrongType.at(place, what, "give an array of the documented type"));
    }
    let fits = length.checked_mul(size_of::<T>()).is_some_and(|size| isize::try_from(size).is_ok());
    if fits { Ok(()) } else { Err(too_long(place, length)) }
}

/// The error of a length that no array has.
pub(crate) fn too_long(place: &str, length: usize) -> Error {
    let what = format!("{length} values do not fit into memory");
    ErrorKind::OutOfRange.at(place, what, "give the length of the array")
}

/// A preset's name, or an object as JSON.
pub(crate) fn name_or_object(text: &str, place: &str) -> Result<Node, Error> {
    if text.trim_start().starts_with('{') {
        return Node::from_json(text).map_err(|error| error.inside(place));
    }
    Ok(text.into())
}

/// `text` with a final zero, for C to keep; `carom_text_free` takes it back.
pub(crate) fn to_c(text: String) -> Result<*mut c_char, Error> {
    Ok(c_text(text)?.into_raw())
}

/// `text` with a final zero.
pub(crate) fn c_text(text: String) -> Result<CString, Error> {
    CString::new(text).map_err(|_| {
        ErrorKind::Unsupported.at("text", "it has a zero byte, which C cannot hold", "remove it")
    })
}

/// The number of threads that C gives: 0 stands for one on each core.
pub(crate) fn runner(threads: i32) -> Result<carom::runner::Runner, Error> {
    let wanted = usize::try_from(threads).map_err(|_| {
        let what = format!("{threads} is out of range");
        ErrorKind::OutOfRange.at("threads", what, "write 0 for one on each core, or a number")
    })?;
    carom::runner::Runner::new((wanted > 0).then_some(wanted))
}

/// An index of C into a list of `length`.
pub(crate) fn index(index: i32, length: usize, place: &str) -> Result<usize, Error> {
    usize::try_from(index).ok().filter(|index| *index < length).ok_or_else(|| {
        let what = format!("there is no {place} {index}");
        ErrorKind::OutOfRange.at(place, what, format!("count the {length} from 0"))
    })
}

/// Whether a flag of C is set: any number but 0.
pub(crate) const fn flag(number: i32) -> bool {
    number != 0
}

#[cfg(test)]
mod tests {
    use super::{CAROM_FAULT, CAROM_REFUSED, ErrorText, enter, name_or_object};
    use carom::ErrorKind;
    use std::ffi::{CStr, c_char};

    /// A function as C calls it, with the panic that a fault of the engine would be.
    extern "C" fn faulty(error: *mut c_char, size: i32) -> i32 {
        // SAFETY: the test gives a buffer of this size.
        enter(&unsafe { ErrorText::new(error, size) }, || panic!("index {} of {}", 5, 3))
    }

    fn text(buffer: &[c_char]) -> &str {
        // SAFETY: the buffer was filled with zeros at first.
        unsafe { CStr::from_ptr(buffer.as_ptr()) }.to_str().unwrap()
    }

    #[test]
    fn no_panic_leaves_an_entry() {
        let call: extern "C" fn(*mut c_char, i32) -> i32 = faulty;
        let mut buffer = [0; 200];
        assert_eq!(call(buffer.as_mut_ptr(), 200), CAROM_FAULT);
        assert_eq!(
            text(&buffer),
            "[fault] a fault of carom: index 5 of 3; report it with this input"
        );
        assert_eq!(call(std::ptr::null_mut(), 0), CAROM_FAULT);
        let panics = || enter::<Option<Box<u8>>>(&ErrorText::NONE, || panic!("{}", "again"));
        assert_eq!(panics(), None);
    }

    #[test]
    fn an_error_has_kind_place_fault_and_remedy_and_is_cut_at_a_character() {
        let refuse = |error: &ErrorText| {
            enter::<i32>(error, || Err(ErrorKind::OutOfRange.at("höhe", "2 is wrong", "write 1")))
        };
        let mut buffer = [0; 64];
        // SAFETY: the buffer has these sizes.
        let [whole, cut, one] =
            [64, 17, 1].map(|size| unsafe { ErrorText::new(buffer.as_mut_ptr(), size) });
        assert_eq!(refuse(&whole), CAROM_REFUSED);
        assert_eq!(text(&buffer), "[out-of-range] höhe: 2 is wrong; write 1");
        refuse(&cut);
        assert_eq!(text(&buffer), "[out-of-range] h", "the next character has two bytes");
        refuse(&one);
        assert_eq!(text(&buffer), "");
        assert_eq!(refuse(&ErrorText::NONE), CAROM_REFUSED);
    }

    #[test]
    fn a_success_empties_the_text_of_the_error() {
        let mut buffer = [1; 4];
        // SAFETY: the buffer has this size.
        assert_eq!(enter(&unsafe { ErrorText::new(buffer.as_mut_ptr(), 4) }, || Ok(7)), 7);
        assert_eq!(text(&buffer), "");
    }

    #[test]
    fn an_object_is_told_from_a_name_by_its_brace() {
        assert!(name_or_object("pool", "physics").is_ok());
        assert!(name_or_object(" {\"base\": \"pool\"}", "physics").is_ok());
        assert!(name_or_object("{", "physics").is_err());
    }
}
