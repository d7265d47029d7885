//! The opening shots of all games on their own tables, judged.

use carom::rack::{Break, Game, break_shot};
use carom_check::CheckRecorder;

/// Racks of each game.
const RACKS: u64 = 4;

#[test]
fn the_opening_shots_of_all_games_have_no_faults() {
    for game in Game::ALL {
        for seed in 0..RACKS {
            let shot = break_shot(&Break::new(game, seed)).expect("the game's own table");
            let checker = CheckRecorder::run(&shot);
            assert!(checker.events > 0);
            assert!(checker.faults.is_empty(), "{}, {seed}: {:#?}", game.name(), checker.faults);
        }
    }
}
