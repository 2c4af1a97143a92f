//! The cases of the paper are those of the folder `cases/`.

use std::path::Path;

use cageless::Case;
use cageless_io::case_file::CaseFile;
use cageless_paper::{Reading, experiment, structure, structures_of};

/// Compares a case with that of a file, the outside of the ring apart: no equation of the paper has it.
fn assert_is_of_file(mut case: Case, name: &str) {
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
    let file = CaseFile::read(&cases.join(format!("{name}.toml")), &[]).unwrap();
    let outside_m = file.case().bearing.outside_radius_m();
    case.bearing = case.bearing.with_boundary_radii(None, outside_m).unwrap();
    assert_eq!(case, *file.case());
}

#[test]
fn structures_are_those_of_the_case_files() {
    for (k, letter) in ('a'..='j').enumerate() {
        let case = structure(k, Reading::CONSISTENT, &[]).unwrap();
        assert_is_of_file(case, &format!("zhao-{letter}"));
    }
}

#[test]
fn the_experiment_is_that_of_the_case_files() {
    let [conventional, discrete] = experiment().unwrap();
    assert_is_of_file(
        conventional.case().clone(),
        "experiment-3000rpm-conventional",
    );
    assert_is_of_file(discrete.case().clone(), "experiment-3000rpm");
}

#[test]
fn the_structures_of_the_paper_are_those_of_its_bearing() {
    let case = structure(3, Reading::CONSISTENT, &[]).unwrap();
    let own = structures_of(&case.bearing).unwrap();
    assert_eq!(own.len(), 10);
    assert_eq!((own[3].letter.as_str(), own[3].half_angle_deg), ("d", 25.2));
    let other = structure(3, Reading::CONSISTENT, &["bearing.balls=13".to_owned()]).unwrap();
    assert!(structures_of(&other.bearing).unwrap().is_empty());
}
