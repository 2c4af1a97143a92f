//! All tests of the files, as one program.

mod advice;
mod arrangement;
mod bad_case_files;
mod bearing_input;
mod case_files;
mod common;
mod crossing;
mod damaged_files;
mod derived_files;
mod derived_files_for_editors;
mod designation;
mod edited;
mod film;
mod fit;
mod former_names;
mod fuzz_entries;
mod reference;
mod results;
mod rotor_input;
mod searched_shapes;
mod statics;
mod tables;
