#![no_main]

#[path = "../../crates/cageless-io/tests/fuzz_entries/mod.rs"]
mod fuzz_entries;

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let dir = tempfile::tempdir().unwrap();
    fuzz_entries::prepare_rotor(dir.path());
    fuzz_entries::matrices(bytes, dir.path());
});
