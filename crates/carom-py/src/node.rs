//! Conversion of plain values: dicts, lists, strings, numbers.

use carom::ErrorKind;
use carom::format::Node;
use pyo3::prelude::*;
use pyo3::types::{
    PyBool, PyByteArray, PyBytes, PyDict, PyFloat, PyFrozenSet, PyInt, PyIterator, PyList,
    PyMapping, PySet, PyString,
};

use crate::exceptions::refuse;

/// Deepest nesting that is accepted. No format nests deeper; a list that contains itself would.
const DEEPEST: usize = 32;

/// A tree that becomes plain Python values.
pub(crate) struct PlainNode(pub(crate) Node);

impl<'py> IntoPyObject<'py> for PlainNode {
    type Target = PyAny;
    type Output = Bound<'py, PyAny>;
    type Error = PyErr;

    fn into_pyobject(self, py: Python<'py>) -> PyResult<Self::Output> {
        to_python(py, &self.0)
    }
}

/// A Python value as a tree.
pub(crate) fn from_python(value: &Bound<'_, PyAny>) -> PyResult<Node> {
    read(value, &mut String::new(), 0)
}

/// A value in the plain dicts, lists, strings and numbers that the engine reads.
#[pyfunction]
pub(crate) fn plain<'py>(value: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
    to_python(value.py(), &from_python(value)?)
}

fn read(value: &Bound<'_, PyAny>, place: &mut String, depth: usize) -> PyResult<Node> {
    if depth > DEEPEST {
        return Err(refuse(
            ErrorKind::Syntax,
            place,
            "nested too deeply",
            "write plain dicts, lists and numbers",
        ));
    }
    if value.is_none() {
        return Ok(Node::Null);
    }
    if let Ok(b) = value.cast::<PyBool>() {
        return Ok(Node::Bool(b.is_true()));
    }
    if let Ok(text) = value.cast::<PyString>() {
        return match text.to_str() {
            Ok(text) => Ok(Node::Text(text.into())),
            Err(_) => Err(refuse(
                ErrorKind::Syntax,
                place,
                "a text that is not Unicode",
                "write valid Unicode",
            )),
        };
    }
    if let Ok(x) = value.cast::<PyFloat>() {
        return Ok(Node::Number(x.value()));
    }
    if value.cast::<PyInt>().is_ok() {
        return Ok(match value.extract::<i64>() {
            Ok(i) => Node::Integer(i),
            Err(_) => Node::Number(value.extract::<f64>().unwrap_or(f64::INFINITY)),
        });
    }
    if let Ok(mapping) = value.cast::<PyMapping>() {
        return read_mapping(mapping, place, depth);
    }
    // Bytes are a sequence of numbers in Python, but hardly ever meant as one.
    if value.cast::<PyBytes>().is_ok() || value.cast::<PyByteArray>().is_ok() {
        return Err(refuse(ErrorKind::WrongType, place, "found bytes", "write a text, or numbers"));
    }
    // A set has no order, so it cannot hold coordinates.
    let ordered = value.cast::<PySet>().is_err() && value.cast::<PyFrozenSet>().is_err();
    if let (true, Ok(items)) = (ordered, value.try_iter()) {
        return read_items(items, place, depth);
    }
    // NumPy's truth values can be converted to numbers, but are not numbers.
    if ["bool", "bool_"].contains(&&*value.get_type().name()?.to_string_lossy()) {
        return Ok(Node::Bool(value.is_truthy()?));
    }
    // NumPy's scalars are not Python's numbers, but convert to them. An array without axes has both
    // methods, and its first one fails for a fraction.
    for method in ["__index__", "__float__"] {
        if let Ok(number) = value.call_method0(method) {
            return read(&number, place, depth + 1);
        }
    }
    let kind = value.get_type().name()?;
    Err(refuse(
        ErrorKind::WrongType,
        place,
        &format!("found a {kind}"),
        "write plain dicts, lists, strings and numbers",
    ))
}

fn read_mapping(
    mapping: &Bound<'_, PyMapping>,
    place: &mut String,
    depth: usize,
) -> PyResult<Node> {
    let mut fields = Vec::with_capacity(mapping.len()?);
    for item in mapping.items()?.iter() {
        let (key, value): (Bound<'_, PyAny>, Bound<'_, PyAny>) = item.extract()?;
        let Ok(key) = key.extract::<String>() else {
            let key = key.repr()?;
            return Err(refuse(
                ErrorKind::WrongType,
                place,
                &format!("the key {key} is not a string"),
                "write a string",
            ));
        };
        let before = place.len();
        if !place.is_empty() {
            place.push('.');
        }
        place.push_str(&key);
        fields.push((key, read(&value, place, depth + 1)?));
        place.truncate(before);
    }
    Ok(Node::Object(fields))
}

fn read_items(items: Bound<'_, PyIterator>, place: &mut String, depth: usize) -> PyResult<Node> {
    let mut list = Vec::new();
    for (i, item) in items.enumerate() {
        let before = place.len();
        place.push_str(&format!("[{i}]"));
        list.push(read(&item?, place, depth + 1)?);
        place.truncate(before);
    }
    Ok(Node::List(list))
}

/// A tree as Python's own types.
pub(crate) fn to_python<'py>(py: Python<'py>, node: &Node) -> PyResult<Bound<'py, PyAny>> {
    Ok(match node {
        Node::Null => py.None().into_bound(py),
        Node::Bool(b) => PyBool::new(py, *b).to_owned().into_any(),
        Node::Integer(i) => i.into_pyobject(py)?.into_any(),
        Node::Number(x) => PyFloat::new(py, *x).into_any(),
        Node::Text(text) => PyString::new(py, text).into_any(),
        Node::List(items) => {
            let list = PyList::empty(py);
            for item in items {
                list.append(to_python(py, item)?)?;
            }
            list.into_any()
        }
        Node::Object(fields) => {
            let dict = PyDict::new(py);
            for (key, value) in fields {
                dict.set_item(key, to_python(py, value)?)?;
            }
            dict.into_any()
        }
    })
}
