//! Texts that C owns.

use std::ffi::{CString, c_char};

use carom::edition;
use carom::format::Node;
use carom::noise::SKILLS;
use carom::rack::Game;
use carom_arena::BuiltInPlayer;

use crate::entry::{ErrorText, enter, to_c};

/// Frees a text that a function of carom gave to the caller; null is passed over.
///
/// Ownership: the text must not be used afterwards. Threads: any.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_text_free(text: *mut c_char) {
    enter(&ErrorText::NONE, || {
        if !text.is_null() {
            // SAFETY: the caller's promise: the text came from `CString::into_raw`.
            drop(unsafe { CString::from_raw(text) });
        }
        Ok(())
    });
}

/// The names of all presets, JSON: lists under the keys "tables", "physics", "games", "noises" and
/// "players".
///
/// Ownership: free the text with carom_text_free. Threads: any.
#[unsafe(no_mangle)]
pub extern "C" fn carom_presets_json() -> *mut c_char {
    enter(&ErrorText::NONE, || {
        let noises = SKILLS.iter().map(|skill| skill.0).chain(["olympiad"]);
        let node = Node::object([
            ("tables", Node::list(edition::listed(edition::TABLES))),
            ("physics", Node::list(edition::listed(edition::PHYSICS))),
            ("games", Node::list(Game::ALL.map(Game::name))),
            ("noises", Node::list(noises)),
            ("players", Node::list(BuiltInPlayer::names())),
        ]);
        to_c(node.to_json())
    })
}
