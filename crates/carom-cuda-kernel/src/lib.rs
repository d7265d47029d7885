//! The engine as a CUDA kernel: every thread plays whole shots, one after the other.
//!
//! The simulation is the source of the crate `carom`, unchanged. What is here makes slices of the
//! device's pointers and chooses the shots of a thread. `scripts/cuda_kernel.sh` builds PTX from it
//! (docs/gpu.md).
#![no_std]
#![feature(abi_ptx, stdarch_nvptx)]

use core::alloc::{GlobalAlloc, Layout};
use core::arch::nvptx;
use core::panic::PanicInfo;
use core::slice::{from_raw_parts, from_raw_parts_mut};

use carom::Physics;
use carom::device::{FlatBall, FlatEnd, FlatRow, FlatShot, FlatView};
use carom::limits::SMALL_CAPACITY;
use carom::math::Vec3;
use carom::simulate::Simulation;
use carom::table::TableGeometry;

/// The crate `carom` uses the heap to read files and to build tables, never during a shot.
struct NoHeap;

// SAFETY: it gives no memory.
unsafe impl GlobalAlloc for NoHeap {
    unsafe fn alloc(&self, _: Layout) -> *mut u8 {
        core::ptr::null_mut()
    }
    unsafe fn dealloc(&self, _: *mut u8, _: Layout) {}
}

#[global_allocator]
static HEAP: NoHeap = NoHeap;

#[panic_handler]
fn panic(_: &PanicInfo) -> ! {
    // SAFETY: it ends the kernel with an error.
    unsafe { nvptx::trap() }
}

/// The pointers and lengths of the arrays, in the device's memory. `carom-cuda` has the same struct.
#[repr(C)]
pub struct Arrays {
    tables: *const TableGeometry,
    physics: *const Physics,
    balls: *const FlatBall,
    shots: *const FlatShot,
    ends: *mut FlatEnd,
    positions: *mut Vec3,
    pockets: *mut i8,
    /// One for each thread. At first its bytes are 0, a value of every number, set and enum in it: what a
    /// simulation holds from the shot before has no effect on the next.
    simulations: *mut Simulation<SMALL_CAPACITY>,
    table_count: u64,
    physics_count: u64,
    ball_count: u64,
    shot_count: u64,
    /// Places for balls of each shot.
    width: u64,
}

/// The sizes of the types that machine and device share, in the order of `Arrays`; the host compares
/// them with its own.
#[unsafe(no_mangle)]
pub unsafe extern "ptx-kernel" fn carom_sizes(sizes: *mut [u64; 7]) {
    // SAFETY: the host gives room for seven numbers, and one thread runs.
    unsafe {
        *sizes = [
            size_of::<TableGeometry>() as u64,
            size_of::<Physics>() as u64,
            size_of::<FlatBall>() as u64,
            size_of::<FlatShot>() as u64,
            size_of::<FlatEnd>() as u64,
            size_of::<Arrays>() as u64,
            size_of::<Simulation<SMALL_CAPACITY>>() as u64,
        ];
    }
}

/// The number of this thread among all of the launch.
fn thread() -> usize {
    // SAFETY: they read registers that every thread has.
    unsafe {
        nvptx::_block_idx_x() as usize * nvptx::_block_dim_x() as usize
            + nvptx::_thread_idx_x() as usize
    }
}

/// Plays the shots: thread t of n plays the shots t, t + n, t + 2n and so on.
#[unsafe(no_mangle)]
pub unsafe extern "ptx-kernel" fn carom_play(arrays: *const Arrays) {
    // SAFETY: the host fills `arrays` with arrays of these lengths, and gives every thread of the launch
    // a simulation; different threads write different elements.
    unsafe {
        let arrays = &*arrays;
        let threads = nvptx::_grid_dim_x() as usize * nvptx::_block_dim_x() as usize;
        let (count, width) = (arrays.shot_count as usize, arrays.width as usize);
        let view = FlatView {
            tables: from_raw_parts(arrays.tables, arrays.table_count as usize),
            physics: from_raw_parts(arrays.physics, arrays.physics_count as usize),
            balls: from_raw_parts(arrays.balls, arrays.ball_count as usize),
            shots: from_raw_parts(arrays.shots, count),
        };
        let mut k = thread();
        let simulation = &mut *arrays.simulations.add(k);
        while k < count {
            let row = FlatRow {
                position: from_raw_parts_mut(arrays.positions.add(k * width), width),
                pocket: from_raw_parts_mut(arrays.pockets.add(k * width), width),
            };
            *arrays.ends.add(k) = view.play(k, simulation, row);
            k += threads;
        }
    }
}
