//! The paper's cases in the library are those of `cases/`.

use std::path::Path;

use cageless::{Case, FrictionLaw, Profile};
use cageless_io::case_file::CaseFile;
use cageless_study::paper;

fn case_of_file(name: &str) -> Case {
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
    let file = CaseFile::read(&cases.join(format!("{name}.toml")), &[]);
    file.unwrap().case().clone()
}

#[test]
fn structures_are_those_of_the_case_files() {
    let reading = (Profile::Physical, FrictionLaw::Smooth);
    for (k, letter) in ('a'..='j').enumerate() {
        let case = paper::structure(k, reading, &[]).unwrap();
        assert_eq!(case, case_of_file(&format!("zhao-{letter}")));
    }
}

#[test]
fn the_experiment_is_that_of_the_case_files() {
    let [conventional, discrete] = paper::experiment().unwrap();
    assert_eq!(
        conventional,
        case_of_file("experiment-3000rpm-conventional")
    );
    assert_eq!(discrete, case_of_file("experiment-3000rpm"));
}
