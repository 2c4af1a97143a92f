#![no_main]

#[path = "../../crates/cageless-io/tests/fuzz_entries/mod.rs"]
mod fuzz_entries;

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    // Plans name a case beside them.
    let dir = tempfile::tempdir().unwrap();
    let case = cageless_io::case_file::template(false);
    std::fs::write(dir.path().join("base.toml"), case).unwrap();
    fuzz_entries::plan(bytes, dir.path());
});
