//! Plays random shots of all families on a CUDA device and on this machine, and compares the bits.
//!
//! `compare KERNEL.ptx [--count N] [--first SEED] [--device K]` plays N shots, 10 000 by default. It ends
//! with 1 if a bit differs. docs/gpu.md says how it is used without a card.

use std::process::ExitCode;
use std::sync::Arc;
use std::time::Instant;

use carom::Shot;
use carom::batch::{BatchResult, simulate_batch};
use carom::device::Device;
use carom::runner::Runner;
use carom_check::random_shots::{ShotFamily, shot_file};
use carom_cuda::CudaDevice;

/// Shots that are drawn and compared at a time.
const PART: u64 = 1 << 16;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let number = |key: &str, default: u64| {
        let at = arguments.iter().position(|argument| argument == key);
        at.and_then(|at| arguments.get(at + 1)?.parse().ok()).unwrap_or(default)
    };
    let Some(kernel) = arguments.first() else {
        eprintln!("give the kernel, such as target/cuda/carom.ptx");
        return ExitCode::from(2);
    };
    let (count, first) = (number("--count", 10_000), number("--first", 0));
    let opened = std::fs::read(kernel)
        .map_err(|error| format!("{kernel}: {error}"))
        .and_then(|ptx| open(number("--device", 0), &ptx));
    let device = match opened {
        Ok(device) => device,
        Err(error) => {
            eprintln!("{error}");
            return ExitCode::from(3);
        }
    };
    println!("device: {} {:?}", device.name(), device.occupancy());
    let differing = compare(device, count, first);
    if differing == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

fn open(ordinal: u64, ptx: &[u8]) -> Result<CudaDevice, String> {
    let ordinal = u32::try_from(ordinal).unwrap_or(u32::MAX);
    CudaDevice::open(ordinal, ptx).map_err(|error| error.to_string())
}

/// Prints what was compared. Returns the number of shots whose bits differ.
fn compare(device: CudaDevice, count: u64, first: u64) -> usize {
    let most = device.most_balls();
    let here = Runner::default();
    let there = Runner::default().on(Arc::new(device));
    let (mut played, mut differing, mut events, mut on_device) = (0, 0, 0_u64, 0.0);
    let mut hash = carom::hash::WordHasher::default();
    for start in (first..first + count).step_by(PART as usize) {
        let seeds = start..(first + count).min(start + PART);
        let chunks =
            seeds.step_by(64).map(|seed| seed..(first + count).min(start + PART).min(seed + 64));
        let shots = here.map(chunks, || (), |(), seeds| seeds.filter_map(draw).collect::<Vec<_>>());
        let shots: Vec<Shot> =
            shots.into_iter().flatten().filter(|shot| shot.balls().len() <= most).collect();
        let began = Instant::now();
        let results = simulate_batch(&shots, &there);
        on_device += began.elapsed().as_secs_f64();
        let expected = simulate_batch(&shots, &here);
        for (k, shot) in shots.iter().enumerate() {
            if row(&results, k) != row(&expected, k) {
                differing += 1;
                if differing <= 3 {
                    println!("differs: {}", shot.to_json());
                }
            }
            row(&expected, k).into_iter().for_each(|word| hash.word(word));
            events += expected.events[k] as u64;
        }
        played += shots.len();
    }
    println!(
        "{played} shots, {events} events, {differing} with other bits, hash {:016x}",
        hash.value()
    );
    println!("{on_device:.3} s in batches on the device, with the copies");
    differing
}

/// The shot with this number: its family is the number modulo their count.
fn draw(number: u64) -> Option<Shot> {
    let families = ShotFamily::ALL;
    let family = families[(number % families.len() as u64) as usize];
    Shot::from_json(&shot_file(family, number / families.len() as u64)).ok()
}

/// The bits of a row: positions, pockets, events, and whether it failed.
fn row(results: &BatchResult, k: usize) -> Vec<u64> {
    let places = k * results.balls..(k + 1) * results.balls;
    let positions = results.final_position[places.clone()].iter().flatten().map(|x| x.to_bits());
    let pockets = results.pocket[places].iter().map(|&pocket| pocket as u64);
    let failed = results.errors.iter().any(|(failed, _)| *failed == k);
    positions.chain(pockets).chain([results.events[k] as u64, u64::from(failed)]).collect()
}
