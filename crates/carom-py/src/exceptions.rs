//! The exceptions of `carom.errors`.

pyo3::import_exception!(carom.errors, CaromError);
pyo3::import_exception!(carom.errors, EndlessMotionError);
pyo3::import_exception!(carom.errors, EventCapError);
pyo3::import_exception!(carom.errors, InputError);
