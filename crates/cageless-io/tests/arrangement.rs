//! Case files and rotor files as one kind of document: bearings with the rotor above them.

use std::path::{Path, PathBuf};

use cageless_io::arrangement::BearingArrangement;
use cageless_io::case_file::CaseValue;

const CLEARANCE: &str = "rotor.radial_clearance_um";

fn path(name: &str) -> PathBuf {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases")).join(name)
}

/// A rotor in one bearing and one in two.
fn files() -> [BearingArrangement; 2] {
    let read = |name| BearingArrangement::read(&path(name), &[]).unwrap();
    ["touchdown-d.toml", "rotors/two-bearings.toml"].map(read)
}

#[test]
fn a_key_of_one_bearing_changes_that_bearing_alone() {
    for file in files() {
        for k in 0..file.cases().len() {
            let key = file.key_in(k, CLEARANCE);
            let changed = file.changed(&[format!("{key}=190.0")]).unwrap();
            let found = |other: usize| changed.cases()[other].value(CLEARANCE);
            for other in 0..file.cases().len() {
                let given = CaseValue::Number(190.0);
                assert_eq!(
                    found(other) == Some(given),
                    other == k,
                    "{key}, bearing {other}"
                );
            }
            assert_eq!(changed.values(&key), [Some(CaseValue::Number(190.0))]);
            assert_eq!(changed.cases_of(&key), &changed.cases()[k..=k]);
            let dropped = changed.drop().unwrap().cases()[k].rotor.clone().unwrap();
            assert!((dropped.radial_clearance_m - 1.9e-4).abs() < 1e-12);
        }
        let all = file.changed(&[format!("{CLEARANCE}=190.0")]).unwrap();
        let expected = vec![Some(CaseValue::Number(190.0)); file.cases().len()];
        assert_eq!(all.values(CLEARANCE), expected);
        assert_eq!(all.cases_of(CLEARANCE).len(), file.cases().len());
    }
}

#[test]
fn a_document_reads_back_as_the_same_bearings_and_rotor() {
    for file in files() {
        let text = file.to_toml().unwrap();
        let again = BearingArrangement::parse(&text, "again", Path::new(""), &[]).unwrap();
        assert_eq!(again.drop(), file.drop());
        assert_eq!(again.rotor_file(), file.rotor_file());
        assert_eq!(again.to_value().unwrap(), file.to_value().unwrap());
        assert_eq!(again.case().is_some(), file.cases().len() == 1);
    }
}

/// The studio edits the text with its comments.
#[test]
fn a_case_file_keeps_its_text() {
    let text = std::fs::read_to_string(path("touchdown-d.toml")).unwrap();
    let [file, rotor] = files();
    assert_eq!(file.case().unwrap().toml(), Some(text.as_str()));
    assert!(rotor.case().is_none() && rotor.cases().iter().all(|case| case.toml().is_none()));
}
