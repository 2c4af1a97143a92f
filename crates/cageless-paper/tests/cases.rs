//! The cases of the paper are those of the folder `cases/`.

use std::path::Path;

use cageless::{Case, Formulation, FrictionLaw};
use cageless_io::case_file::CaseFile;
use cageless_paper::{experiment, structure, structures_of};
fn case_of_file(name: &str) -> Case {
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
    let file = CaseFile::read(&cases.join(format!("{name}.toml")), &[]);
    file.unwrap().case().clone()
}

#[test]
fn structures_are_those_of_the_case_files() {
    let reading = (Formulation::Physical, FrictionLaw::Smooth);
    for (k, letter) in ('a'..='j').enumerate() {
        let case = structure(k, reading, &[]).unwrap();
        assert_eq!(case, case_of_file(&format!("zhao-{letter}")));
    }
}

#[test]
fn the_experiment_is_that_of_the_case_files() {
    let [conventional, discrete] = experiment().unwrap();
    assert_eq!(
        conventional,
        case_of_file("experiment-3000rpm-conventional")
    );
    assert_eq!(discrete, case_of_file("experiment-3000rpm"));
}

#[test]
fn the_structures_of_the_paper_are_those_of_its_bearing() {
    let reading = (Formulation::Physical, FrictionLaw::Smooth);
    let case = structure(3, reading, &[]).unwrap();
    let own = structures_of(&case.bearing).unwrap();
    assert_eq!(own.len(), 10);
    assert_eq!((own[3].letter.as_str(), own[3].half_angle_deg), ("d", 25.2));
    let other = structure(3, reading, &["bearing.balls=13".to_owned()]).unwrap();
    assert!(structures_of(&other.bearing).unwrap().is_empty());
}
