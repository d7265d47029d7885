//! The Python module `carom._core`: conversions, no logic. The public API is `python/carom`.

mod arena;
mod arena_check;
mod batch;
mod device;
mod drill;
mod env;
mod env_opponent;
mod error;
mod exceptions;
mod json;
mod maps;
mod match_player;
mod node;
mod options;
mod plan;
mod player;
mod program;
mod progress;
mod reference;
mod rolling;
mod rules;
mod shot;
mod study;
mod successors;
mod sweep;
mod trace;
mod tracks;

use pyo3::prelude::*;

/// Private; use `carom`.
#[pymodule]
mod _core {
    use pyo3::prelude::*;

    #[pymodule_export]
    use crate::arena::{
        OpenMatch, adjusted_share, normalised_elo, pair_interval, play_match, play_pair,
        player_entry, replay_match, test_state,
    };
    #[pymodule_export]
    use crate::arena_check::check_player;
    #[pymodule_export]
    use crate::batch::{
        check_noise, check_perception, draw_strikes, noise_moments, noise_presets, olympiad, see,
        simulate_batch, simulate_strikes, simulate_variants, variant,
    };
    #[pymodule_export]
    use crate::device::CudaDevice;
    #[pymodule_export]
    use crate::drill::{
        accepted_puzzles, judge_shot, make_puzzle, puzzle_themes, read_drill, read_puzzle,
    };
    #[pymodule_export]
    use crate::env::{VectorEnv, foul_words, meanings, tasks};
    #[pymodule_export]
    use crate::maps::{
        acceptance, bank_table, break_statistics, kick_table, position_map, pot_map,
    };
    #[pymodule_export]
    use crate::node::plain;
    #[pymodule_export]
    use crate::plan::{clustered, evaluate, solve, spread, stages, wilson};
    #[pymodule_export]
    use crate::player::{Player, players};
    #[pymodule_export]
    use crate::program::supervise;
    #[pymodule_export]
    use crate::reference::{
        break_presets, break_shot, build, default_options, error_kinds, game_facts, physics,
        repaired, schema, tables,
    };
    #[pymodule_export]
    use crate::rolling::rolling_bands;
    #[pymodule_export]
    use crate::rules::{Frame, check_record};
    #[pymodule_export]
    use crate::shot::{Shot, check_part};
    #[pymodule_export]
    use crate::study::{Study, judge};
    #[pymodule_export]
    use crate::successors::{pots, successors};
    #[pymodule_export]
    use crate::sweep::{
        check_keys, dated_value, play_rows, points, quantiles, read_json, read_number, read_whole,
        row_shot, unknown_word, wrong_type,
    };
    #[pymodule_export]
    use crate::trace::{Trace, simulate, simulate_to_cap};
    #[pymodule_export]
    use crate::tracks::{BallTracks, Candidates, sample_states, start_states, track_residuals};

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))?;
        module.add("TIP", carom::resolve::cue_ball::TIP)?;
        module.add("MOST_SAMPLES", carom::format::MOST_SAMPLES)?;
        module.add("MOST_EVENTS", carom::limits::MOST_EVENTS)
    }
}
