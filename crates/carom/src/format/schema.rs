//! JSON Schemas (draft 2020-12) of the files that carom reads and writes.

/// `carom-shot/1`: the shot file.
pub const SHOT: &str = include_str!("../../schemas/carom-shot-1.json");

/// `carom-trace/1`: the recorded shot, as this version writes it.
pub const TRACE: &str = include_str!("../../schemas/carom-trace-1.json");
