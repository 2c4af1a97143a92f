//! All tests of the pages, as one program.

mod drop;
mod pages;
mod studio;
mod synthetic;
