//! The proof that a device computes as this machine does, made when it is opened: some shots are played
//! on both. It finds a kernel of another version of the engine, and a compiler that fuses operations.

use carom::batch::simulate_batch;
use carom::device::{Device, FlatShots};
use carom::runner::Runner;
use carom::{Error, ErrorKind, Shot};

/// Shots in which most of the engine's code runs: breaks, jumps and a masse, cushions, a pocket's jaws.
const SHOTS: [&str; 6] = [
    include_str!("../shots/eight_ball_break.json"),
    include_str!("../shots/masse.json"),
    include_str!("../shots/jump_shot.json"),
    include_str!("../shots/rattle.json"),
    include_str!("../shots/three_cushion.json"),
    include_str!("../shots/speed_bands.json"),
];

/// Compares the bits of these shots.
///
/// # Errors
/// [`Error::Input`] at `device` if a bit differs, or if the device fails.
pub(crate) fn same_bits(device: &dyn Device) -> Result<(), Error> {
    let shots = SHOTS.map(Shot::from_json).into_iter().collect::<Result<Vec<_>, _>>()?;
    let mut flat = FlatShots::default();
    shots.iter().for_each(|shot| flat.push(shot, shot.strike()));
    let ends = device.play(&flat)?;
    let here = simulate_batch(&shots, &Runner::new(Some(1))?);
    for (k, shot) in shots.iter().enumerate() {
        let count = shot.balls().len();
        let (from, to) = (k * ends.width, k * here.balls);
        let there = ends.position[from..][..count].iter().map(|p| p.to_array().map(f64::to_bits));
        let equal =
            here.final_position[to..][..count].iter().map(|p| p.map(f64::to_bits)).eq(there)
                && here.pocket[to..][..count] == ends.pocket[from..][..count]
                && here.events[k] as u32 == ends.end[k].events;
        if !equal {
            return Err(wrong_kernel("a shot on the device has other bits"));
        }
    }
    Ok(())
}

/// The kernel cannot be used; `what` is the reason.
pub(crate) fn wrong_kernel(what: &str) -> Error {
    ErrorKind::Unsupported.at(
        "device",
        format!("the kernel does not fit to this engine: {what}"),
        "build it again from the same sources (make kernel), or use device \"cpu\"",
    )
}
