//! Writes the JavaScript and TypeScript face of a WebAssembly file. usage: carom-wasm-bindgen WASM FOLDER

use std::error::Error;

use wasm_bindgen_cli_support::Bindgen;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args_os().skip(1);
    let (Some(wasm), Some(folder)) = (arguments.next(), arguments.next()) else {
        return Err("usage: carom-wasm-bindgen WASM FOLDER".into());
    };
    let mut bindgen = Bindgen::new();
    bindgen
        .input_path(wasm)
        .web(true)?
        .omit_default_module_path(true)
        .remove_name_section(true)
        .typescript(true);
    bindgen.generate(folder)?;
    Ok(())
}
