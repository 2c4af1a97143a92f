//! What pages embed: [`plotly`], and the engine of pages that compute, `cageless-wasm`, compiled for WebAssembly, compressed, and
//! written to `$OUT_DIR/engine.rs` as a string, which is empty where it cannot be made.
//!
//! Optimised builds compile it, in a target folder of its own, if the target
//! `wasm32-unknown-unknown` is installed. `CAGELESS_ENGINE` names a compiled engine to embed
//! instead, in any profile.

mod plotly;

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

use base64::Engine as _;
use flate2::Compression;
use flate2::write::GzEncoder;

const TARGET: &str = "wasm32-unknown-unknown";
/// Remedy for a build without an engine, in a clone and in a package from a registry.
const REMEDY: &str = "`rustup target add wasm32-unknown-unknown`, and build with --release again";
const REMEDY_OF_A_PACKAGE: &str = "take the command from a release, or install it from a clone by `cargo install --path crates/cageless-cli`";
/// Small code for all but the physics: the engine is part of every page.
const SMALL: [&str; 5] = [
    "profile.release.codegen-units=1",
    r#"profile.release.package."*".opt-level="z""#,
    r#"profile.release.package.cageless-results.opt-level="z""#,
    r#"profile.release.package.cageless-io.opt-level="z""#,
    r#"profile.release.package.cageless-live.opt-level="s""#,
];
/// Crates that the engine is made of, beside this one.
const SOURCES: [&str; 5] = [
    "cageless",
    "cageless-results",
    "cageless-io",
    "cageless-live",
    "cageless-wasm",
];

fn main() {
    println!("cargo:rerun-if-env-changed=CAGELESS_ENGINE");
    println!("cargo:rerun-if-changed=build");
    let out = PathBuf::from(env::var_os("OUT_DIR").expect("cargo sets OUT_DIR"));
    plotly::embed(&out);
    let remedy = match engine_manifest().is_some_and(|manifest| manifest.is_file()) {
        true => REMEDY,
        false => REMEDY_OF_A_PACKAGE,
    };
    println!("cargo:rustc-env=CAGELESS_ENGINE_REMEDY={remedy}");
    let wasm = match env::var_os("CAGELESS_ENGINE") {
        Some(path) => {
            println!("cargo:rerun-if-changed={}", Path::new(&path).display());
            let read = fs::read(&path);
            Some(read.unwrap_or_else(|e| panic!("{}: {e}", Path::new(&path).display())))
        }
        None => compiled(&out),
    };
    let text = wasm.map_or(String::new(), |wasm| {
        let mut packed = GzEncoder::new(vec![], Compression::best());
        packed.write_all(&wasm).expect("memory takes everything");
        let packed = packed.finish().expect("memory takes everything");
        base64::engine::general_purpose::STANDARD.encode(packed)
    });
    fs::write(out.join("engine.rs"), format!("{text:?}")).expect("OUT_DIR can be written");
}

/// The crate of the engine, in a clone.
fn engine_manifest() -> Option<PathBuf> {
    let own = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR")?);
    Some(own.join("../cageless-wasm/Cargo.toml"))
}

/// Has cargo build again when a target is installed or removed, given the place of the libraries of one:
/// `lib/rustlib/TARGET/lib`.
fn watch_installed_targets(libraries: &Path) {
    // rustup's list of what is installed. To watch a file that is missing would be to build always.
    let list = libraries
        .ancestors()
        .nth(2)
        .map(|all| all.join("components"));
    if let Some(list) = list.filter(|list| list.is_file()) {
        println!("cargo:rerun-if-changed={}", list.display());
    }
}

/// Presence of the libraries of the target; `None` where the compiler does not say.
fn target_is_installed() -> Option<bool> {
    let rustc = env::var_os("RUSTC")?;
    let libraries = Command::new(rustc)
        .args(["--print", "target-libdir", "--target", TARGET])
        .output()
        .ok()?;
    let libraries = String::from_utf8_lossy(&libraries.stdout).trim().to_owned();
    watch_installed_targets(Path::new(&libraries));
    Some(!libraries.is_empty() && Path::new(&libraries).is_dir())
}

/// The command that builds the engine into the folder `target`.
fn build(manifest: &Path, target: &Path) -> Option<Command> {
    let mut cargo = Command::new(env::var_os("CARGO")?);
    cargo
        .args([
            "build",
            "--release",
            "--locked",
            "--target",
            TARGET,
            "--manifest-path",
        ])
        .arg(manifest)
        .arg("--target-dir")
        .arg(target)
        .args(SMALL.iter().flat_map(|setting| ["--config", setting]))
        .env("RUSTFLAGS", "-C target-feature=+simd128")
        .env("CARGO_PROFILE_RELEASE_DEBUG", "false")
        .env("CARGO_PROFILE_RELEASE_STRIP", "true");
    // Settings for the host and of wrappers such as clippy.
    for name in [
        "CARGO_ENCODED_RUSTFLAGS",
        "RUSTC_WORKSPACE_WRAPPER",
        "CARGO_TARGET_DIR",
        "CARGO_BUILD_TARGET",
    ] {
        cargo.env_remove(name);
    }
    Some(cargo)
}

/// The engine; `None`, with a warning, where it cannot be compiled.
fn compiled(out: &Path) -> Option<Vec<u8>> {
    // Engines that are not optimised are too slow to watch, and tests do not need them.
    if env::var("PROFILE").is_ok_and(|profile| profile != "release") {
        return None;
    }
    let crates = Path::new(&env::var_os("CARGO_MANIFEST_DIR")?).join("..");
    let manifest = engine_manifest()?;
    // A package from a registry stands alone.
    if !manifest.is_file() {
        return None;
    }
    for name in SOURCES {
        println!(
            "cargo:rerun-if-changed={}",
            crates.join(name).join("src").display()
        );
        println!(
            "cargo:rerun-if-changed={}",
            crates.join(name).join("Cargo.toml").display()
        );
    }
    if !target_is_installed()? {
        println!(
            "cargo:warning=pages get no engine of their own: `rustup target add {TARGET}` and build again to add it"
        );
        return None;
    }
    let target = out.join("engine");
    let made = build(&manifest, &target)?.output();
    let log = match &made {
        Ok(made) if made.status.success() => None,
        Ok(made) => Some(String::from_utf8_lossy(&made.stderr).into_owned()),
        Err(error) => Some(error.to_string()),
    };
    if let Some(log) = log {
        let last = log
            .lines()
            .rev()
            .find(|line| !line.trim().is_empty())
            .unwrap_or_default();
        println!("cargo:warning=pages get no engine of their own, it does not compile: {last}");
        return None;
    }
    fs::read(target.join(TARGET).join("release/cageless_wasm.wasm")).ok()
}
