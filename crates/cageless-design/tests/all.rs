//! Tests of the library from outside, as a user of the crate sees it, as one program; `inside/` is compiled with the
//! library and tests what is not public.

#[path = "../../cageless/tests/common/mod.rs"]
mod common;
mod creep;
mod critical_gap;
mod refused;
