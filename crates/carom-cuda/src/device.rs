//! A CUDA device with the kernel.
#![allow(unsafe_code, reason = "a driver's functions in C")]

use std::ffi::{CStr, CString, c_char, c_int};
use std::mem::size_of;
use std::ptr::null_mut;
use std::sync::{Mutex, PoisonError};

use carom::device::{Device, FlatBall, FlatEnd, FlatEnds, FlatShot, FlatShots};
use carom::limits::SMALL_CAPACITY;
use carom::simulate::Simulation;
use carom::table::TableGeometry;
use carom::{Error, ErrorKind, Physics};

use crate::driver::{
    Address, Context, Driver, Function, LOCAL_BYTES, MULTIPROCESSORS, Module, REGISTERS, driver,
};
use crate::memory::Buffer;
use crate::proof::{same_bits, wrong_kernel};

/// Threads of a block. The kernel takes all registers that a thread can have, so that a multiprocessor
/// holds about 256 threads; small blocks fill it evenly.
const THREADS: u32 = 64;

/// Shots of one call of the kernel. Each takes about 3 kB of the device's memory and as much of the
/// machine's. Fewer, and the threads of a large device would have too few shots each to end at about the
/// same time.
const SHOTS: usize = 1 << 17;

/// The argument of the kernel; `carom-cuda-kernel` has the same struct.
#[repr(C)]
struct Arrays {
    tables: Address,
    physics: Address,
    balls: Address,
    shots: Address,
    ends: Address,
    positions: Address,
    pockets: Address,
    simulations: Address,
    table_count: u64,
    physics_count: u64,
    ball_count: u64,
    shot_count: u64,
    width: u64,
}

/// The types that machine and device share, with their sizes here.
const SIZES: [(&str, usize); 7] = [
    ("TableGeometry", size_of::<TableGeometry>()),
    ("Physics", size_of::<Physics>()),
    ("FlatBall", size_of::<FlatBall>()),
    ("FlatShot", size_of::<FlatShot>()),
    ("FlatEnd", size_of::<FlatEnd>()),
    ("Arrays", size_of::<Arrays>()),
    // It stays on the device, whose compiler may lay it out in another way.
    ("Simulation", 0),
];

/// A CUDA device that plays shots. It plays one call at a time; other threads wait.
#[derive(Debug)]
pub struct CudaDevice {
    driver: &'static Driver,
    name: String,
    handle: c_int,
    context: Context,
    module: Module,
    play: Function,
    occupancy: Occupancy,
    /// The state of the shot of each thread.
    simulations: Mutex<Option<Buffer>>,
}

/// How the kernel uses a device.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Occupancy {
    /// Number of multiprocessors.
    pub multiprocessors: u32,
    /// Threads of the kernel that one of them holds at a time.
    pub threads: u32,
    /// Registers of a thread.
    pub registers: u32,
    /// Local memory of a thread, bytes.
    pub local_bytes: u32,
}

// SAFETY: the driver's handles may be used by every thread. Each call makes the context current first,
// and the mutex allows one call at a time.
unsafe impl Send for CudaDevice {}
// SAFETY: as above.
unsafe impl Sync for CudaDevice {}

impl CudaDevice {
    /// Opens the device number `ordinal`, counted from 0, and compiles the kernel `ptx` for it. Some shots
    /// are played on the device and on this machine; their bits must be the same.
    ///
    /// # Errors
    /// [`Error::Input`] at `device` without a driver or such a device, and if the kernel does not fit to
    /// the device or to this version of the engine.
    pub fn open(ordinal: u32, ptx: &[u8]) -> Result<Self, Error> {
        let driver = driver()?;
        let device = Self::start(driver, ordinal, ptx)?;
        same_bits(&device)?;
        Ok(device)
    }

    fn start(driver: &'static Driver, ordinal: u32, ptx: &[u8]) -> Result<Self, Error> {
        let handle = handle(driver, ordinal)?;
        let ptx = CString::new(ptx).map_err(|_| wrong_kernel("it is not a text"))?;
        let (mut context, mut module, mut play) = (null_mut(), null_mut(), null_mut());
        // SAFETY: the driver writes a handle into each of these places, or returns an error. The text of
        // the kernel ends with a zero, and so do the names.
        unsafe {
            driver.check(
                (driver.retain_context)(&raw mut context, handle),
                "the start of the device",
            )?;
            let mut device = Self {
                driver,
                name: name(driver, handle),
                handle,
                context,
                module,
                play,
                occupancy: Occupancy {
                    multiprocessors: 1,
                    threads: 0,
                    registers: 0,
                    local_bytes: 0,
                },
                simulations: Mutex::new(None),
            };
            device.make_current()?;
            let code = (driver.load_module)(&raw mut module, ptx.as_ptr().cast());
            driver.check(code, "the compilation of the kernel for this device")?;
            device.module = module;
            let code = (driver.function)(&raw mut play, module, c"carom_play".as_ptr());
            driver.check(code, "the search for the kernel's entry")?;
            device.play = play;
            let simulation = device.compare_sizes()?;
            device.occupancy = device.measure()?;
            let bytes = simulation * device.threads_at_once() as usize;
            device.simulations = Mutex::new(Some(Buffer::zeros(driver, bytes)?));
            Ok(device)
        }
    }

    /// The device's name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// How the kernel uses the device.
    pub const fn occupancy(&self) -> Occupancy {
        self.occupancy
    }

    fn threads_at_once(&self) -> u32 {
        self.occupancy.multiprocessors * self.occupancy.threads
    }

    fn make_current(&self) -> Result<(), Error> {
        // SAFETY: the context is the device's, retained until `self` is dropped.
        let code = unsafe { (self.driver.use_context)(self.context) };
        self.driver.check(code, "the use of the device")
    }

    /// Compares the sizes of shared types with those of the kernel. Returns that of a simulation.
    fn compare_sizes(&self) -> Result<usize, Error> {
        let mut function = null_mut();
        let mut sizes = [0_u64; SIZES.len()];
        // SAFETY: `carom_sizes` writes this number of sizes at its argument, with one thread.
        unsafe {
            let code =
                (self.driver.function)(&raw mut function, self.module, c"carom_sizes".as_ptr());
            self.driver.check(code, "the search for the kernel's entry")?;
            let buffer = Buffer::of(self.driver, &sizes)?;
            self.driver.run(function, [1, 1], buffer.address())?;
            buffer.read(&mut sizes)?;
        }
        for (&(name, here), there) in SIZES.iter().zip(sizes) {
            if here != 0 && there != here as u64 {
                let what = format!("its {name} has {there} bytes, the engine's {here}");
                return Err(wrong_kernel(&what));
            }
        }
        Ok(sizes[SIZES.len() - 1] as usize)
    }

    fn measure(&self) -> Result<Occupancy, Error> {
        let driver = self.driver;
        let number = |get: &dyn Fn(*mut c_int) -> c_int| {
            let mut number = 0;
            driver.check(get(&raw mut number), "a question about the device")?;
            Ok::<u32, Error>(u32::try_from(number).unwrap_or(0))
        };
        // SAFETY: the driver writes a number at each pointer.
        unsafe {
            let blocks = number(&|to| (driver.blocks_at_once)(to, self.play, THREADS as c_int, 0))?;
            Ok(Occupancy {
                multiprocessors: number(&|to| {
                    (driver.device_attribute)(to, MULTIPROCESSORS, self.handle)
                })?
                .max(1),
                threads: blocks.max(1) * THREADS,
                registers: number(&|to| (driver.function_attribute)(to, REGISTERS, self.play))?,
                local_bytes: number(&|to| (driver.function_attribute)(to, LOCAL_BYTES, self.play))?,
            })
        }
    }
}

impl Device for CudaDevice {
    fn most_balls(&self) -> usize {
        Simulation::<SMALL_CAPACITY>::CAPACITY
    }

    fn most_shots(&self) -> usize {
        SHOTS
    }

    fn play(&self, shots: &FlatShots) -> Result<FlatEnds, Error> {
        let mut ends = FlatEnds::of(shots);
        let count = shots.shots.len();
        if count == 0 {
            return Ok(ends);
        }
        let simulations = self.simulations.lock().unwrap_or_else(PoisonError::into_inner);
        let Some(simulations) = &*simulations else { return Ok(ends) };
        self.make_current()?;
        let driver = self.driver;
        let (tables, physics) =
            (Buffer::of(driver, &shots.tables)?, Buffer::of(driver, &shots.physics)?);
        let (balls, flat) = (Buffer::of(driver, &shots.balls)?, Buffer::of(driver, &shots.shots)?);
        let (end, position) = (Buffer::of(driver, &ends.end)?, Buffer::of(driver, &ends.position)?);
        let pocket = Buffer::of(driver, &ends.pocket)?;
        let arrays = Arrays {
            tables: tables.address(),
            physics: physics.address(),
            balls: balls.address(),
            shots: flat.address(),
            ends: end.address(),
            positions: position.address(),
            pockets: pocket.address(),
            simulations: simulations.address(),
            table_count: shots.tables.len() as u64,
            physics_count: shots.physics.len() as u64,
            ball_count: shots.balls.len() as u64,
            shot_count: count as u64,
            width: shots.width as u64,
        };
        let argument = Buffer::of(driver, &[arrays])?;
        let threads = self.threads_at_once().min(u32::try_from(count).unwrap_or(u32::MAX));
        // SAFETY: the arrays have the lengths that the argument says, with types of the sizes that the
        // kernel has; there is a simulation for each thread. The kernel writes numbers only, so that
        // every bit pattern is a value.
        unsafe {
            driver.run(self.play, [threads.div_ceil(THREADS), THREADS], argument.address())?;
            end.read(&mut ends.end)?;
            position.read(&mut ends.position)?;
            pocket.read(&mut ends.pocket)?;
        }
        Ok(ends)
    }
}

impl Drop for CudaDevice {
    fn drop(&mut self) {
        // The context must be current to free what it holds.
        if self.make_current().is_ok() {
            *self.simulations.get_mut().unwrap_or_else(PoisonError::into_inner) = None;
            if !self.module.is_null() {
                // SAFETY: the module is the device's own and is not used after this.
                unsafe {
                    (self.driver.unload_module)(self.module);
                }
            }
        }
        // SAFETY: it was retained once.
        unsafe {
            (self.driver.release_context)(self.handle);
        }
    }
}

/// The driver's number of the device `ordinal`.
fn handle(driver: &Driver, ordinal: u32) -> Result<c_int, Error> {
    let (mut count, mut handle) = (0, 0);
    // SAFETY: the driver writes a number at each pointer.
    unsafe {
        driver.check((driver.device_count)(&raw mut count), "the count of devices")?;
        let index = c_int::try_from(ordinal).unwrap_or(c_int::MAX);
        if index >= count {
            let what = format!("there is no CUDA device {ordinal}");
            let remedy = format!("count the {count} devices from 0, or use device \"cpu\"");
            return Err(ErrorKind::Unsupported.at("device", what, remedy));
        }
        driver.check((driver.device)(&raw mut handle, index), "the choice of the device")?;
    }
    Ok(handle)
}

fn name(driver: &Driver, handle: c_int) -> String {
    let mut text: [c_char; 256] = [0; 256];
    // SAFETY: the driver writes at most this number of bytes, and a zero at their end.
    unsafe {
        if (driver.device_name)(text.as_mut_ptr(), text.len() as c_int, handle) != 0 {
            return String::from("unknown");
        }
        CStr::from_ptr(text.as_ptr()).to_string_lossy().into_owned()
    }
}
