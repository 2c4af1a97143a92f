//! All tests of the pages, as one program.

mod attributes;
mod design_page;
mod drop;
mod figure_data;
mod pages;
mod reproduce_page;
mod run_data;
mod sheet;
mod slot;
mod static_page;
mod studio;
mod sweep_page;
mod synthetic;
