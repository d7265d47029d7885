//! `include/Carom.cs`, the interface for C#, is the header in another language.

mod common;

use std::fmt::Write;

use common::{Declarations, Variable, compare_or_write, crate_folder};

const HEAD: &str = "\
// carom for C#, by P/Invoke: Unity, Godot and .NET. carom.h has the documentation of each function, and
// docs/game.md the guide. Written by `make reference` from carom.h; do not edit. Compile with -unsafe.
//
// Structs are blittable. A pointer is an IntPtr; Carom.Text reads a text that the library owns, and
// Carom.Taken one that it gives away.

using System;
using System.Runtime.InteropServices;
using System.Text;
";

const HELPERS: &str = r#"
    /// <summary>The bytes of a text for a pointer argument, with a final zero.</summary>
    public static byte[] Bytes(string text)
    {
        return Encoding.UTF8.GetBytes(text + "\0");
    }

    /// <summary>A text that stays with the library, or the text of an error.</summary>
    public static string Text(IntPtr text)
    {
        int length = 0;
        while (text != IntPtr.Zero && Marshal.ReadByte(text, length) != 0)
        {
            ++length;
        }
        byte[] bytes = new byte[length];
        if (length > 0)
        {
            Marshal.Copy(text, bytes, 0, length);
        }
        return Encoding.UTF8.GetString(bytes);
    }

    /// <summary>A text that the library gives away; it is freed.</summary>
    public static string Taken(IntPtr text)
    {
        string taken = Text(text);
        carom_text_free(text);
        return taken;
    }
"#;

/// A word of C# that is a name in the header.
fn escaped(name: &str) -> String {
    const WORDS: [&str; 4] = ["out", "in", "ref", "params"];
    if WORDS.contains(&name) { format!("@{name}") } else { name.to_owned() }
}

fn value_type(of: &str) -> &str {
    match of {
        "int8_t" => "sbyte",
        "int32_t" => "int",
        "uint32_t" => "uint",
        "uint64_t" => "ulong",
        "size_t" => "UIntPtr",
        "double" | "void" => of,
        pointer if pointer.contains('*') => "IntPtr",
        other => other,
    }
}

/// A struct by reference, bytes and numbers as arrays, objects as IntPtr.
fn argument(of: &str, structs: &[&str]) -> String {
    let pointed = of.strip_suffix('*').map(str::trim_end);
    match pointed {
        Some("char") => "byte[]".into(),
        Some("double") => "double[]".into(),
        Some("int8_t") => "sbyte[]".into(),
        Some("int32_t") => "int[]".into(),
        // An array, or a struct that a call reads or writes.
        Some(name) if structs.contains(&name) => format!("{name}[]"),
        Some(object) if object.contains('*') => "IntPtr[]".into(),
        _ => value_type(of).into(),
    }
}

fn written(header: &Declarations) -> String {
    let mut out = HEAD.to_owned();
    let structs: Vec<&str> = header.structs.iter().map(|(name, _)| name.as_str()).collect();
    for (name, fields) in &header.structs {
        write!(out, "\n[StructLayout(LayoutKind.Sequential)]\npublic unsafe struct {name}\n{{\n")
            .unwrap();
        for Variable { of, name, length } in fields {
            let (of, name) = (value_type(of), escaped(name));
            match length {
                Some(length) => writeln!(out, "    public fixed {of} {name}[{length}];").unwrap(),
                None => writeln!(out, "    public {of} {name};").unwrap(),
            }
        }
        out += "}\n";
    }
    out += "\npublic static class Carom\n{\n    public const string Library = \"carom\";\n\n";
    for (name, value) in &header.constants {
        writeln!(out, "    public const int {name} = {value};").unwrap();
    }
    out += HELPERS;
    for (result, arguments) in &header.functions {
        let arguments: Vec<String> = arguments
            .iter()
            .map(|Variable { of, name, .. }| {
                let of = argument(of, &structs);
                let both = if of.ends_with("[]") { "[In, Out] " } else { "" };
                // One struct and one pointer are arrays of length 1; an IntPtr may be null.
                format!("{both}{of} {}", escaped(name))
            })
            .collect();
        let freed = result.name == "carom_text_free";
        let arguments = if freed { "IntPtr text".into() } else { arguments.join(", ") };
        let (of, name) = (value_type(&result.of), &result.name);
        write!(
            out,
            "\n    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]\n    public static \
             extern {of} {name}({arguments});\n"
        )
        .unwrap();
    }
    out + "}\n"
}

#[test]
fn the_interface_for_csharp_is_the_header_in_another_language() {
    let header = Declarations::read();
    assert!(header.structs.len() >= 15 && header.functions.len() >= 60, "{header:?}");
    compare_or_write(&crate_folder().join("include/Carom.cs"), &written(&header));
}
