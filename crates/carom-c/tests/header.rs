//! `include/carom.h` is what cbindgen writes from the source.

mod common;

use cbindgen::{Builder, Config, DocumentationStyle, Language, Style};
use common::{Declarations, compare_or_write, crate_folder};

/// The rules for every function, at the head of the header.
const HEAD: &str = "\
/*
 * carom: billiards, exact and deterministic. The C interface.
 * docs/game.md is the guide. Written by `make reference` from crates/carom-c; do not edit.
 *
 * Units. SI and radians: m, m/s, rad/s, kg, N s, s. The origin is the corner of the playing area at the
 * bottom left; x is along the table's width, y along its length, z up from the slate. A ball on the
 * cloth has z = its radius. Quaternions are x, y, z, w.
 *
 * Ownership. A pointer that a function returns is an object of the caller, to be freed once by the
 * function of its type, unless the function says that it belongs to another object. A pointer that a
 * function takes is only used during the call. Texts are UTF-8 and end in a zero. A null pointer
 * is refused like other wrong input, unless the function says what it stands for. Any other pointer must
 * point to what its type says.
 *
 * Threads. carom_table, carom_shot, carom_trace, carom_player and carom_stop may be used by any number
 * of threads at once. A carom_sim and a carom_frame belong to one thread at a time; threads may share
 * a frame that none changes. An object is freed when no thread uses it any more.
 *
 * Errors. A function that can refuse its input has the arguments error and error_size: a buffer of that
 * many bytes, or null and 0. It gets one sentence, cut to fit in whole characters:
 *     [kind] place: what is wrong; what would be right
 * The kind is a stable word (carom_error_kinds_json), the place a path in the input. After a success
 * the text is empty. Failure is a null pointer, a negative number, 0 for a hash and NaN for a time;
 * the number is CAROM_REFUSED, CAROM_EVENT_CAP or CAROM_FAULT. No panic of Rust leaves the library.
 *
 * Definitions. A struct ..._def with all bytes zero has default values; carom_default_..._def() returns
 * it. Flags are int32_t: 0 is no, any other number is yes.
 *
 * Bits. The same shot gives the same bits on every machine, in every language and for any number of
 * threads, with the same version of the engine.
 */";

fn config() -> Config {
    Config {
        language: Language::C,
        style: Style::Both,
        cpp_compat: true,
        include_guard: Some("CAROM_H".into()),
        header: Some(HEAD.into()),
        documentation_style: DocumentationStyle::C99,
        usize_is_size_t: true,
        no_includes: true,
        sys_includes: vec!["stddef.h".into(), "stdint.h".into()],
        line_length: 100,
        ..Config::default()
    }
}

#[test]
fn the_header_is_that_of_the_source() {
    let mut written = Vec::new();
    let builder = Builder::new().with_crate(crate_folder()).with_config(config());
    builder.generate().expect("the source has an interface").write(&mut written);
    let written = String::from_utf8(written).unwrap();
    compare_or_write(&crate_folder().join("include/carom.h"), &written);
}

/// The name and the body of each function of C in a source file.
fn functions(source: &str) -> impl Iterator<Item = (&str, &str)> {
    source.split("#[unsafe(no_mangle)]").skip(1).map(|function| {
        let (_, rest) = function.split_once(" fn ").expect("a function");
        let (name, body) = rest.split_once('(').expect("arguments");
        (name, body.split("\n}\n").next().unwrap_or_default())
    })
}

#[test]
fn every_function_runs_in_the_guard_that_no_panic_leaves() {
    let mut count = 0;
    for entry in std::fs::read_dir(crate_folder().join("src")).unwrap() {
        let source = std::fs::read_to_string(entry.unwrap().path()).unwrap();
        for (name, body) in functions(&source) {
            let is_guarded = body.contains("enter(");
            // Those that return a constant.
            let is_default = name.starts_with("carom_default_") && name.ends_with("_def");
            assert!(is_guarded != is_default, "{name}");
            count += 1;
        }
    }
    assert_eq!(count, Declarations::read().functions.len());
}

#[test]
fn every_function_has_its_rules_of_threads() {
    let header = std::fs::read_to_string(crate_folder().join("include/carom.h")).unwrap();
    for (function, _) in Declarations::read().functions {
        let at = header.find(&format!("{}(", function.name)).expect("the function");
        let comment = header[..at].rsplit("\n\n").next().unwrap_or_default();
        let refers = comment.contains("The rest is as in");
        assert!(comment.contains("Threads:") || refers, "{}: {comment}", function.name);
    }
}
