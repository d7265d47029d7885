//! The bytes of a saved state: a name, a version, the settings, the state itself, and a checksum.

use carom::{Error, ErrorKind};
use carom_rules::StateBytes;

use crate::config::Config;
use crate::task::Task;

/// The first bytes of every state.
const NAME: &[u8] = b"carom-environments";

/// Version of the format. It increases when a state of the same environments has other bytes.
const VERSION: u32 = 2;

/// The settings on which a state depends: their names and values in words.
pub(crate) fn settings(task: Task, n: usize, config: &Config) -> Vec<(String, String)> {
    let Config {
        noise,
        aim,
        speed,
        max_elevation,
        opponent,
        seat,
        balls,
        target_ball,
        setups,
        randomize,
        options,
        rewards,
        max_episode_steps,
        // These change no results.
        autoreset_mode: _,
        traces: _,
        threads: _,
    } = config;
    [
        ("engine", env!("CARGO_PKG_VERSION").to_owned()),
        ("task", task.name().to_owned()),
        ("num_envs", n.to_string()),
        ("noise", format!("{noise:?}")),
        ("aim", aim.name().to_owned()),
        ("speed", format!("{speed:?}")),
        ("max_elevation", format!("{max_elevation:?}")),
        ("opponent", opponent.name()),
        ("seat", seat.name().to_owned()),
        ("balls", format!("{balls:?}")),
        ("target_ball", target_ball.name().to_owned()),
        ("table", format!("{:?}", setups.iter().map(|setup| &setup.table).collect::<Vec<_>>())),
        ("physics", format!("{:?}", setups.iter().map(|setup| &setup.physics).collect::<Vec<_>>())),
        ("randomize", format!("{randomize:?}")),
        ("options", format!("{options:?}")),
        ("rewards", format!("{rewards:?}")),
        ("max_episode_steps", format!("{max_episode_steps:?}")),
    ]
    .map(|(name, value)| (name.to_owned(), value))
    .into()
}

/// A state with these settings.
pub(crate) fn pack(settings: &[(String, String)], body: &[u8]) -> Vec<u8> {
    let mut out = NAME.to_vec();
    VERSION.write_to(&mut out);
    (settings.len() as u32).write_to(&mut out);
    for text in settings.iter().flat_map(|(name, value)| [name, value]) {
        (text.len() as u32).write_to(&mut out);
        out.extend(text.as_bytes());
    }
    out.extend(body);
    checksum(&out).write_to(&mut out);
    out
}

/// The body of a state that was saved with `settings`.
///
/// # Errors
/// [`Error::Input`] at `state` for other bytes and for other settings.
pub(crate) fn unpack<'a>(
    settings: &[(String, String)],
    state: &'a [u8],
) -> Result<&'a [u8], Error> {
    let wrong = |kind: ErrorKind, what: String, remedy: &str| Err(kind.at("state", what, remedy));
    let Some(mut bytes) = state.strip_prefix(NAME) else {
        let what = "these bytes are not the state of environments".to_owned();
        return wrong(ErrorKind::Syntax, what, "give the bytes that get_state returned");
    };
    let version = u32::read_from(&mut bytes).ok_or_else(damaged)?;
    if version != VERSION {
        let what = format!("it has version {version} of the format, and this is version {VERSION}");
        return wrong(ErrorKind::Format, what, "read it with the version of carom that wrote it");
    }
    let (whole, mut sum) =
        state.split_last_chunk::<8>().map(|(a, b)| (a, &b[..])).ok_or_else(damaged)?;
    if Some(checksum(whole)) != u64::read_from(&mut sum) {
        return Err(damaged());
    }
    bytes = &bytes[..bytes.len() - 8];
    let found = read_settings(&mut bytes).ok_or_else(damaged)?;
    for (name, value) in settings {
        let other = found.iter().find(|(found, _)| found == name).map(|(_, value)| value.as_str());
        if other != Some(value) {
            let what = format!(
                "it was saved with {name} {}, and here it is {}",
                short(other.unwrap_or("unknown")),
                short(value)
            );
            return wrong(
                ErrorKind::Mismatch,
                what,
                "make the environments with the same task and settings",
            );
        }
    }
    Ok(bytes)
}

fn read_settings(bytes: &mut &[u8]) -> Option<Vec<(String, String)>> {
    let count = u32::read_from(bytes)?;
    let mut text = || {
        let length = u32::read_from(bytes)? as usize;
        let (own, rest) = bytes.split_at_checked(length)?;
        *bytes = rest;
        String::from_utf8(own.to_vec()).ok()
    };
    (0..count).map(|_| Some((text()?, text()?))).collect()
}

/// The error for bytes that are a state, but not a whole one.
pub(crate) fn damaged() -> Error {
    ErrorKind::Syntax.at("state", "its bytes are damaged", "give the bytes that get_state returned")
}

/// At most 80 characters of `text`.
fn short(text: &str) -> String {
    const LONGEST: usize = 80;
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}

/// FNV-1a with 64 bits (Fowler, Noll & Vo 1991).
fn checksum(bytes: &[u8]) -> u64 {
    let step = |sum: u64, byte: &u8| (sum ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01b3);
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, step)
}
