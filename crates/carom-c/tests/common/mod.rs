//! The declarations of the header.

#![allow(dead_code, reason = "each test uses its part")]

use std::path::{Path, PathBuf};

/// A variable of C: its type without `const` and `struct`, its name, and its length if it is an array.
#[derive(Debug)]
pub(crate) struct Variable {
    pub(crate) of: String,
    pub(crate) name: String,
    pub(crate) length: Option<String>,
}

/// What the header declares.
#[derive(Debug, Default)]
pub(crate) struct Declarations {
    /// Names and values.
    pub(crate) constants: Vec<(String, String)>,
    /// Names and fields of structs with fields.
    pub(crate) structs: Vec<(String, Vec<Variable>)>,
    /// Results, with names of the functions, and their arguments.
    pub(crate) functions: Vec<(Variable, Vec<Variable>)>,
}

pub(crate) fn crate_folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).to_owned()
}

/// Compares a file with what it should contain; with `CAROM_WRITE` in the environment, writes it.
pub(crate) fn compare_or_write(file: &Path, wanted: &str) {
    if std::env::var_os("CAROM_WRITE").is_some() {
        std::fs::write(file, wanted).unwrap();
    }
    let stored = std::fs::read_to_string(file).unwrap_or_default();
    assert!(stored == wanted, "{} is not that of the source; run make reference", file.display());
}

impl Declarations {
    pub(crate) fn read() -> Self {
        let text = std::fs::read_to_string(crate_folder().join("include/carom.h")).unwrap();
        let mut found = Self::default();
        let mut code = String::new();
        let text = text.split_once("*/").expect("the head").1;
        for line in text.lines() {
            let line = line.split("//").next().unwrap_or_default().trim();
            if let Some(constant) = line.strip_prefix("#define CAROM_") {
                if let Some((name, value)) = constant.split_once(' ') {
                    found.constants.push((format!("CAROM_{name}"), value.to_owned()));
                }
            } else if !line.starts_with('#') && !line.starts_with("extern \"C\"") && line != "}" {
                code.push_str(line);
                code.push(' ');
            }
        }
        found.read_code(&code);
        found
    }

    fn read_code(&mut self, mut code: &str) {
        while let Some(end) = code.find(';') {
            let is_struct = code[..end].contains('{');
            let end = if is_struct { code.find('}').expect("an end") } else { end };
            let declaration = code[..end].trim();
            if is_struct {
                let (head, fields) = declaration.split_once('{').expect("fields");
                let name = head.trim().trim_start_matches("typedef struct").trim().to_owned();
                let fields = fields.split(';').filter(|field| !field.trim().is_empty());
                self.structs.push((name, fields.map(variable).collect()));
                code = &code[end + code[end..].find(';').expect("the end") + 1..];
                continue;
            }
            if let Some((head, arguments)) = declaration.split_once('(') {
                let arguments = arguments.trim_end_matches(')');
                let arguments = arguments.split(',').filter(|argument| argument.trim() != "void");
                self.functions.push((variable(head), arguments.map(variable).collect()));
            }
            code = &code[end + 1..];
        }
    }
}

/// Reads `const struct carom_shot *shot`, `double position[3]` or `double (*out)[2]`.
fn variable(text: &str) -> Variable {
    let (text, length) = match text.split_once('[') {
        Some((text, length)) => (text, Some(length.trim_end().trim_end_matches(']').to_owned())),
        None => (text, None),
    };
    // The pointer to an array is one to its first number.
    let (text, length) = if text.contains("(*") {
        (text.replace(['(', ')'], ""), None)
    } else {
        (text.into(), length)
    };
    let text = text.replace('*', " * ");
    let mut words: Vec<&str> =
        text.split_whitespace().filter(|word| !["const", "struct"].contains(word)).collect();
    let name = words.pop().expect("a name").to_owned();
    Variable { of: words.join(" "), name, length }
}
