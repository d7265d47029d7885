//! NVIDIA's driver: the functions of `libcuda` that are used here, loaded at run time.
#![allow(unsafe_code, reason = "a driver's functions in C")]

use std::ffi::{CStr, c_char, c_int, c_uchar, c_uint, c_void};
use std::ptr::{null, null_mut};
use std::sync::OnceLock;

use carom::{Error, ErrorKind};
use libloading::Library;

/// An address in the device's memory.
pub(crate) type Address = u64;
pub(crate) type Context = *mut c_void;
pub(crate) type Module = *mut c_void;
pub(crate) type Function = *mut c_void;

#[cfg(windows)]
const LIBRARY: &str = "nvcuda.dll";
#[cfg(not(windows))]
const LIBRARY: &str = "libcuda.so.1";

/// `CU_DEVICE_ATTRIBUTE_MULTIPROCESSOR_COUNT`.
pub(crate) const MULTIPROCESSORS: c_int = 16;
/// `CU_FUNC_ATTRIBUTE_LOCAL_SIZE_BYTES`.
pub(crate) const LOCAL_BYTES: c_int = 3;
/// `CU_FUNC_ATTRIBUTE_NUM_REGS`.
pub(crate) const REGISTERS: c_int = 4;

/// Declares the driver's functions that are used; all return an error's number.
macro_rules! functions {
    ($($name:ident = $symbol:literal ($($argument:ty),*);)+) => {
        /// The driver's functions.
        #[derive(Debug)]
        pub(crate) struct Driver {
            $(pub(crate) $name: unsafe extern "system" fn($($argument),*) -> c_int,)+
            _library: Library,
        }

        impl Driver {
            fn load() -> Result<Self, libloading::Error> {
                // SAFETY: the driver has no conditions for being loaded, and the types are those of
                // its header, cuda.h. The library stays loaded as long as the functions exist.
                unsafe {
                    let library = Library::new(LIBRARY)?;
                    Ok(Self { $($name: *library.get($symbol)?,)+ _library: library })
                }
            }
        }
    };
}

functions! {
    init = b"cuInit\0" (c_uint);
    error_string = b"cuGetErrorString\0" (c_int, *mut *const c_char);
    device_count = b"cuDeviceGetCount\0" (*mut c_int);
    device = b"cuDeviceGet\0" (*mut c_int, c_int);
    device_name = b"cuDeviceGetName\0" (*mut c_char, c_int, c_int);
    device_attribute = b"cuDeviceGetAttribute\0" (*mut c_int, c_int, c_int);
    retain_context = b"cuDevicePrimaryCtxRetain\0" (*mut Context, c_int);
    release_context = b"cuDevicePrimaryCtxRelease_v2\0" (c_int);
    use_context = b"cuCtxSetCurrent\0" (Context);
    synchronize = b"cuCtxSynchronize\0" ();
    load_module = b"cuModuleLoadData\0" (*mut Module, *const c_void);
    unload_module = b"cuModuleUnload\0" (Module);
    function = b"cuModuleGetFunction\0" (*mut Function, Module, *const c_char);
    function_attribute = b"cuFuncGetAttribute\0" (*mut c_int, c_int, Function);
    blocks_at_once = b"cuOccupancyMaxActiveBlocksPerMultiprocessor\0" (*mut c_int, Function, c_int, usize);
    allocate = b"cuMemAlloc_v2\0" (*mut Address, usize);
    free = b"cuMemFree_v2\0" (Address);
    fill = b"cuMemsetD8_v2\0" (Address, c_uchar, usize);
    to_device = b"cuMemcpyHtoD_v2\0" (Address, *const c_void, usize);
    from_device = b"cuMemcpyDtoH_v2\0" (*mut c_void, Address, usize);
    launch = b"cuLaunchKernel\0" (
        Function, c_uint, c_uint, c_uint, c_uint, c_uint, c_uint, c_uint, *mut c_void, *mut *mut c_void,
        *mut *mut c_void
    );
}

/// The driver, loaded and initialised once.
///
/// # Errors
/// [`Error::Input`] if this machine has no driver, or no device.
pub(crate) fn driver() -> Result<&'static Driver, Error> {
    static DRIVER: OnceLock<Result<Driver, String>> = OnceLock::new();
    let loaded = DRIVER.get_or_init(|| {
        let driver = Driver::load()
            .map_err(|error| format!("NVIDIA's driver could not be loaded ({})", reason(&error)))?;
        // SAFETY: 0 is the only value of the argument that cuda.h permits.
        match unsafe { (driver.init)(0) } {
            0 => Ok(driver),
            code => Err(format!("the driver finds no CUDA device ({})", driver.error(code))),
        }
    });
    loaded.as_ref().map_err(|what| {
        ErrorKind::Unsupported.at(
            "device",
            what.clone(),
            "use a machine with an NVIDIA card and its driver, or device \"cpu\"",
        )
    })
}

/// What the system says of a library that it could not load.
fn reason(error: &libloading::Error) -> String {
    std::error::Error::source(error).map_or_else(|| error.to_string(), ToString::to_string)
}

impl Driver {
    /// What an error's number means.
    fn error(&self, code: c_int) -> String {
        let mut text = null();
        // SAFETY: the driver writes a pointer to a text that is never freed, or leaves it null.
        let text = unsafe {
            (self.error_string)(code, &raw mut text);
            if text.is_null() { c"unknown" } else { CStr::from_ptr(text) }
        };
        format!("CUDA error {code}: {}", text.to_string_lossy())
    }

    /// The result of a call that tried to do `what`.
    pub(crate) fn check(&self, code: c_int, what: &str) -> Result<(), Error> {
        if code == 0 {
            return Ok(());
        }
        let remedy = match code {
            2 => "close other programs that use the device's memory, or use device \"cpu\"",
            _ => "see the driver's messages (dmesg, nvidia-smi), or use device \"cpu\"",
        };
        let what = format!("{what} failed ({})", self.error(code));
        Err(ErrorKind::System.at("device", what, remedy))
    }

    /// Starts `function` with one argument, on `blocks` of `threads` threads, and waits for its end.
    ///
    /// # Safety
    /// The function has one argument, an address, and is right to use what lies there.
    pub(crate) unsafe fn run(
        &self,
        function: Function,
        [blocks, threads]: [u32; 2],
        argument: Address,
    ) -> Result<(), Error> {
        let mut argument = argument;
        let mut arguments = [(&raw mut argument).cast::<c_void>()];
        // SAFETY: the argument lives until the call has returned, when the driver has copied it.
        unsafe {
            let code = (self.launch)(
                function,
                blocks,
                1,
                1,
                threads,
                1,
                1,
                0,
                null_mut(),
                arguments.as_mut_ptr(),
                null_mut(),
            );
            self.check(code, "the start of the kernel")?;
            self.check((self.synchronize)(), "the kernel")
        }
    }
}
