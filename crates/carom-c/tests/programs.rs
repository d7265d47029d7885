//! Programs in C, C++ and C# that use the library, compiled and run. `CAROM_SANITIZE` in the environment
//! compiles those in C and C++ with the address and undefined-behaviour sanitizers.
#![cfg(target_os = "linux")]

mod common;

use std::fmt::Write as _;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;

use carom::Shot;
use carom::rack::{Break, Game, break_shot};
use common::{Declarations, crate_folder};
use tempfile::TempDir;

/// What every warning of a compiler is: an error.
const STRICT: [&str; 4] = ["-Wall", "-Wextra", "-Werror", "-pedantic"];

/// The folder of the libraries that this test was built with.
fn libraries() -> PathBuf {
    let here = std::env::current_exe().unwrap();
    here.parent().expect("a folder").to_owned()
}

/// Runs a program to its end. None if the machine does not have it.
fn run(command: &mut Command) -> Option<String> {
    match command.output() {
        Ok(done) => {
            let said = String::from_utf8_lossy(&done.stderr);
            assert!(done.status.success(), "{command:?}: {}\n{said}", done.status);
            Some(String::from_utf8(done.stdout).unwrap())
        }
        Err(_) => {
            // A macro would print it only if the test failed.
            let program = command.get_program().to_string_lossy();
            let line = format!("\n{program} is missing: its programs are not tested\n");
            std::io::stderr().write_all(line.as_bytes()).unwrap();
            None
        }
    }
}

struct Programs {
    folder: TempDir,
}

impl Programs {
    fn new() -> Self {
        Self { folder: tempfile::tempdir().unwrap() }
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// Compiles a source with the static library. None without the compiler.
    fn compiled(&self, compiler: &str, standard: &str, source: &Path) -> Option<PathBuf> {
        let out = self.path(source.file_stem().expect("a name").to_str().expect("ASCII"));
        let mut command = Command::new(compiler);
        command.arg(standard).args(STRICT).arg("-I").arg(crate_folder().join("include"));
        if std::env::var_os("CAROM_SANITIZE").is_some() {
            command.args(["-g", "-fsanitize=address,undefined", "-fno-sanitize-recover=all"]);
        }
        command.arg(source).arg("-o").arg(&out).arg(libraries().join("libcarom_c.a"));
        command.args(["-lpthread", "-ldl", "-lm"]);
        run(&mut command).map(|_| out)
    }

    fn c(&self, source: &str) -> Option<PathBuf> {
        self.compiled("gcc", "-std=c11", &crate_folder().join(source))
    }
}

fn example_shots() -> Vec<PathBuf> {
    let folder = crate_folder().join("../../shots");
    let files = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let mut files: Vec<_> =
        files.filter(|file| file.extension().is_some_and(|e| e == "json")).collect();
    files.sort();
    files
}

/// The bits of a double as printf's %a writes them.
fn hexadecimal(x: f64) -> String {
    let bits = x.to_bits();
    let (exponent, fraction) = ((bits >> 52) as i32 - 1023, bits & ((1 << 52) - 1));
    let digits = format!("{fraction:013x}");
    let digits = digits.trim_end_matches('0');
    let dot = if digits.is_empty() { "" } else { "." };
    format!("0x1{dot}{digits}p{exponent:+}")
}

#[test]
fn every_example_shot_has_the_same_bits_in_c() {
    let programs = Programs::new();
    let Some(program) = programs.c("tests/c/hashes.c") else { return };
    let files = example_shots();
    assert!(files.len() > 20);
    let mut wanted = String::new();
    for file in &files {
        let shot = Shot::from_json(&std::fs::read_to_string(file).unwrap()).unwrap();
        let trace = shot.simulate().unwrap();
        let (events, hash) = (trace.events().len(), trace.hash());
        writeln!(wanted, "{events} {hash:016x} {}", hexadecimal(trace.duration())).unwrap();
    }
    assert_eq!(run(Command::new(program).args(files)), Some(wanted));
}

#[test]
fn a_program_in_c_uses_every_function_rightly_and_wrongly() {
    let programs = Programs::new();
    let source = "tests/c/interface.c";
    let text = std::fs::read_to_string(crate_folder().join(source)).unwrap();
    let others = std::fs::read_to_string(crate_folder().join("tests/c/hashes.c")).unwrap();
    for (function, _) in Declarations::read().functions {
        let call = format!("{}(", function.name);
        assert!(text.contains(&call) || others.contains(&call), "{} is not used", function.name);
    }
    let Some(program) = programs.c(source) else { return };
    assert_eq!(run(&mut Command::new(program)).as_deref(), Some("everything holds\n"));
}

#[test]
fn a_break_has_the_same_bits_in_cplusplus_and_in_csharp() {
    let shot = break_shot(&Break::new(Game::NineBall, 20)).unwrap();
    let trace = shot.simulate().unwrap();
    let hash = format!("{:016x}\n", trace.hash());
    let programs = Programs::new();
    let source = crate_folder().join("tests/c/plus.cpp");
    if let Some(program) = programs.compiled("g++", "-std=c++17", &source) {
        assert_eq!(run(&mut Command::new(program)), Some(hash.clone()));
    }
    let example = crate_folder().join("../../examples/csharp/Frames.cs");
    if let Some(said) = csharp(&programs, &example, &[]) {
        let frames = (trace.duration() * 60.0).floor() as usize + 1;
        let events = trace.events().filter(|e| e.time <= (frames - 1) as f64 / 60.0).count();
        assert!(said.starts_with(&format!("{frames} frames, {events} events, ")), "{said}");
        assert!(said.ends_with(&format!("hash {hash}")), "{said}");
    }
}

/// Compiles and runs a program in C# with Carom.cs, with Mono. None without it.
fn csharp(programs: &Programs, source: &Path, arguments: &[&str]) -> Option<String> {
    let out = programs.path("program.exe");
    let mut compiler = Command::new("mcs");
    compiler
        .args(["-unsafe", "-warnaserror", "-nowarn:0649"])
        .arg(format!("-out:{}", out.display()));
    run(compiler.arg(source).arg(crate_folder().join("include/Carom.cs")))?;
    let library = programs.path("libcarom.so");
    if !library.exists() {
        std::os::unix::fs::symlink(libraries().join("libcarom_c.so"), library).unwrap();
    }
    let mut mono = Command::new("mono");
    run(mono.arg(out).args(arguments).env("LD_LIBRARY_PATH", programs.folder.path()))
}

#[test]
fn structs_have_one_layout_in_c_and_csharp() {
    let programs = Programs::new();
    let structs = Declarations::read().structs;
    let mut source = String::from("#include <carom.h>\n#include <stdio.h>\nint main(void)\n{\n");
    for (name, fields) in &structs {
        writeln!(source, "printf(\"{name} %zu\\n\", sizeof({name}));").unwrap();
        for field in fields {
            let field = &field.name;
            writeln!(source, "printf(\"{name}.{field} %zu\\n\", offsetof({name}, {field}));")
                .unwrap();
        }
    }
    source += "return 0;\n}\n";
    let file = programs.path("layout.c");
    std::fs::write(&file, source).unwrap();
    let Some(program) = programs.compiled("gcc", "-std=c11", &file) else { return };
    let in_c = run(&mut Command::new(program)).unwrap();
    // The library's own view: a struct that C lays out in another way would fail here.
    assert!(in_c.contains(&format!("carom_state {}\n", size_of::<carom_c::state::carom_state>())));
    let names: Vec<&str> = structs.iter().map(|(name, _)| name.as_str()).collect();
    let layout = crate_folder().join("tests/c/Layout.cs");
    if let Some(in_csharp) = csharp(&programs, &layout, &names) {
        assert_eq!(in_csharp, in_c);
    }
}

#[test]
fn the_examples_run() {
    let programs = Programs::new();
    let example = |name: &str| programs.c(&format!("../../examples/c/{name}.c"));
    let Some(frames) = example("frames") else { return };
    for (file, sound) in [("masse.json", "sound cue"), ("side_pocket_cut.json", "sound pocket")] {
        let file = crate_folder().join("../../shots").join(file);
        let said = run(Command::new(&frames).arg(&file)).unwrap();
        let shot = Shot::from_json(&std::fs::read_to_string(file).unwrap()).unwrap();
        let trace = shot.simulate().unwrap();
        assert!(said.ends_with(&format!("hash {:016x}\n", trace.hash())), "{said}");
        assert!(said.contains(sound) && said.contains(" turned "), "{said}");
        let saved = programs.path("trace.json");
        std::fs::write(&saved, trace.to_json()).unwrap();
        let said = run(Command::new(example("replay").unwrap()).arg(saved)).unwrap();
        assert!(said.contains(": the same bits, "), "{said}");
    }
    let said = run(&mut Command::new(example("lockstep").unwrap())).unwrap();
    let ends: Vec<&str> = said.lines().map(|line| line.split_once(": ").unwrap().1).collect();
    assert!(ends.len() == 2 && ends[0] == ends[1] && ends[0].starts_with("winner "), "{said}");
    let saved = programs.path("game.json");
    let said = run(Command::new(example("save_and_load").unwrap()).arg(&saved)).unwrap();
    assert_eq!(said, "legal break, the same hash after loading\n");
    assert!(std::fs::read_to_string(saved).unwrap().contains("carom-frame/1"));
}

#[test]
fn pkg_config_and_cmake_find_the_installed_library() {
    let programs = Programs::new();
    let out = programs.path("installed");
    let root = crate_folder().join("../..");
    let script = root.join("scripts/c_library.sh");
    run(Command::new("bash").arg(script).arg(libraries()).arg(&out)).expect("bash");
    let example = root.join("examples/c/frames.c");
    let built = programs.path("frames");
    let flags = "cc -std=c11 \"$1\" $(pkg-config --cflags --libs carom) -lm -o \"$2\"";
    let mut shell = Command::new("sh");
    shell.args(["-c", flags, "sh"]).arg(&example).arg(&built);
    shell.env("PKG_CONFIG_PATH", out.join("lib/pkgconfig"));
    if run(Command::new("pkg-config").arg("--version")).is_some() {
        run(&mut shell).expect("a shell");
        let said = run(Command::new(&built).env("LD_LIBRARY_PATH", out.join("lib"))).unwrap();
        assert!(said.contains("frame 0:"), "{said}");
    }
    let project = programs.path("project");
    std::fs::create_dir(&project).unwrap();
    let listed = format!(
        "cmake_minimum_required(VERSION 3.16)\nproject(game C)\nfind_package(carom 0.1 CONFIG \
         REQUIRED)\nadd_executable(shared \"{0}\")\ntarget_link_libraries(shared carom::carom \
         m)\nadd_executable(static \"{0}\")\ntarget_link_libraries(static carom::static m)\n",
        example.display()
    );
    std::fs::write(project.join("CMakeLists.txt"), listed).unwrap();
    let mut cmake = Command::new("cmake");
    cmake.args(["-S", "."]).arg("-B").arg("build").current_dir(&project);
    if run(cmake.arg(format!("-DCMAKE_PREFIX_PATH={}", out.display()))).is_none() {
        return;
    }
    run(Command::new("cmake").args(["--build", "build"]).current_dir(&project)).unwrap();
    let [shared, with_static] = ["shared", "static"]
        .map(|name| run(&mut Command::new(project.join("build").join(name))).unwrap());
    assert!(shared == with_static && shared.contains("frame 0:"));
}

#[test]
fn an_example_for_a_reader_is_short() {
    for entry in std::fs::read_dir(crate_folder().join("../../examples/c")).unwrap() {
        let text = std::fs::read_to_string(entry.unwrap().path()).unwrap();
        assert!(text.lines().count() <= 150);
    }
}
