//! `_core.CudaDevice`: a graphics card that plays batches.

use std::sync::Arc;

use pyo3::prelude::*;

use crate::error::to_exception;

/// A CUDA device with the kernel.
#[pyclass(frozen, module = "carom._core")]
pub(crate) struct CudaDevice(pub(crate) Arc<carom_cuda::CudaDevice>);

#[pymethods]
impl CudaDevice {
    /// Opens the device number `ordinal` with the kernel `ptx`.
    #[new]
    fn new(py: Python<'_>, ordinal: u32, ptx: &[u8]) -> PyResult<Self> {
        let opened = py.detach(|| carom_cuda::CudaDevice::open(ordinal, ptx));
        opened.map(|device| Self(Arc::new(device))).map_err(|error| to_exception(py, &error))
    }

    /// The device's name.
    #[getter]
    fn name(&self) -> &str {
        self.0.name()
    }

    /// Multiprocessors, threads of each at a time, registers and bytes of local memory of a thread.
    #[getter]
    fn occupancy(&self) -> (u32, u32, u32, u32) {
        let found = self.0.occupancy();
        (found.multiprocessors, found.threads, found.registers, found.local_bytes)
    }
}
