//! plotly.js, which draws every figure: the one file that pages take of the crate `plotly`, without that crate and
//! what it depends on being compiled.
//!
//! Cargo has downloaded and checked the crate already, or does it now. `CAGELESS_PLOTLY` names another file to embed,
//! for builds without a network.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

/// Version of the crate.
const VERSION: &str = "0.14.1";
/// Place of the file in the crate.
const FILE: &str = "resource/plotly.min.js";

/// Copies the file to `out` and names it to the compiler.
pub fn embed(out: &Path) {
    println!("cargo:rerun-if-env-changed=CAGELESS_PLOTLY");
    let file = match env::var_os("CAGELESS_PLOTLY") {
        Some(path) => PathBuf::from(path),
        None => downloaded().or_else(download).unwrap_or_else(|| {
            panic!(
                "plotly.js is missing: `cargo info plotly@{VERSION}` downloads it; without a network set \
                 CAGELESS_PLOTLY to the path of a plotly.min.js of version 3"
            )
        }),
    };
    let copy = out.join("plotly.min.js");
    fs::copy(&file, &copy).unwrap_or_else(|e| panic!("{}: {e}", file.display()));
    println!("cargo:rustc-env=CAGELESS_PLOTLY_JS={}", copy.display());
}

/// The file in the sources that Cargo has unpacked.
fn downloaded() -> Option<PathBuf> {
    let home = env::var_os("CARGO_HOME").map(PathBuf::from);
    let home = home.or_else(|| Some(env::home_dir()?.join(".cargo")))?;
    let registries = fs::read_dir(home.join("registry/src")).ok()?;
    let crates = registries.flatten().map(|registry| registry.path());
    let files = crates.map(|registry| registry.join(format!("plotly-{VERSION}")).join(FILE));
    files.into_iter().find(|file| file.is_file())
}

/// The file of the crate after Cargo has downloaded it; documentation is made without a network and without figures.
fn download() -> Option<PathBuf> {
    if env::var_os("DOCS_RS").is_some() {
        let none = PathBuf::from(env::var_os("OUT_DIR")?).join("none.js");
        fs::write(&none, "").ok()?;
        return Some(none);
    }
    let mut cargo = Command::new(env::var_os("CARGO")?);
    cargo.args(["info", "--quiet", &format!("plotly@{VERSION}")]);
    // Away from the workspace, whose lock file names no such crate.
    cargo.current_dir(env::var_os("OUT_DIR")?);
    cargo.output().ok()?;
    downloaded()
}
