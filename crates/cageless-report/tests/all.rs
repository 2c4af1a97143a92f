//! All tests of the pages, as one program.

mod drop;
mod pages;
mod run_data;
mod studio;
mod synthetic;
