//! Memory of the device, freed when its owner is dropped.
#![allow(unsafe_code, reason = "memory of a device")]

use std::ffi::c_void;
use std::mem::size_of_val;

use carom::Error;

use crate::driver::{Address, Driver};

/// A piece of the device's memory. The device's context is current wherever one is made, used or dropped.
#[derive(Debug)]
pub(crate) struct Buffer {
    driver: &'static Driver,
    address: Address,
    bytes: usize,
}

impl Buffer {
    /// A piece of `bytes` bytes, which hold nothing yet.
    pub(crate) fn new(driver: &'static Driver, bytes: usize) -> Result<Self, Error> {
        let mut address = 0;
        // The driver refuses to allocate nothing.
        let bytes = bytes.max(1);
        // SAFETY: the driver writes the address of new memory.
        let code = unsafe { (driver.allocate)(&raw mut address, bytes) };
        driver.check(code, &format!("the allocation of {bytes} bytes"))?;
        Ok(Self { driver, address, bytes })
    }

    /// A piece of `bytes` bytes, all of which are 0.
    pub(crate) fn zeros(driver: &'static Driver, bytes: usize) -> Result<Self, Error> {
        let buffer = Self::new(driver, bytes)?;
        // SAFETY: the piece has this number of bytes.
        let code = unsafe { (driver.fill)(buffer.address, 0, buffer.bytes) };
        driver.check(code, "the filling of memory")?;
        Ok(buffer)
    }

    /// A piece that holds `values`.
    pub(crate) fn of<T>(driver: &'static Driver, values: &[T]) -> Result<Self, Error> {
        let bytes = size_of_val(values);
        let buffer = Self::new(driver, bytes)?;
        if bytes > 0 {
            // SAFETY: both places have this number of bytes.
            let code = unsafe { (driver.to_device)(buffer.address, values.as_ptr().cast(), bytes) };
            driver.check(code, "a copy to the device")?;
        }
        Ok(buffer)
    }

    /// Copies the first bytes of the piece into `values`.
    ///
    /// # Safety
    /// The device has written values of this type there.
    pub(crate) unsafe fn read<T>(&self, values: &mut [T]) -> Result<(), Error> {
        let bytes = size_of_val(values);
        assert!(bytes <= self.bytes, "{bytes} bytes of {}", self.bytes);
        if bytes == 0 {
            return Ok(());
        }
        // SAFETY: both places have this number of bytes, and the device has written such values.
        let code = unsafe {
            (self.driver.from_device)(values.as_mut_ptr().cast::<c_void>(), self.address, bytes)
        };
        self.driver.check(code, "a copy from the device")
    }

    pub(crate) const fn address(&self) -> Address {
        self.address
    }
}

impl Drop for Buffer {
    fn drop(&mut self) {
        // SAFETY: the address comes from the driver and is freed once. An error here follows another
        // one, which was reported.
        unsafe {
            (self.driver.free)(self.address);
        }
    }
}
