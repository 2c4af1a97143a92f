//! All tests of the pages, as one program.

mod distant_copies;
mod drop;
mod pages;
mod run_data;
mod studio;
mod synthetic;
