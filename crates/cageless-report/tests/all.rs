//! All tests of the pages, as one program.

mod distant_copies;
mod drop;
mod pages;
mod studio;
mod synthetic;
