// What may be read: any bytes as a case file, a rotor file, matrices of a rotor, a plan, a journal or a
// table of results. Shared by the targets of `fuzz/` and by the tests of damaged files. Nothing may panic, and whatever is
// refused has a message that names the file.

use std::fs;
use std::path::Path;

use cageless_io::arrangement::BearingArrangement;
use cageless_io::case_file::CaseFile;
use cageless_io::journal::Journal;
use cageless_io::plan_file::PlanFile;
use cageless_io::results::TableReader;
use cageless_io::rotor_file::read_matrices;

/// Reads a case file; one that is accepted is the same case when its document is read again, and what
/// is recorded of a run of it is accepted, too.
#[allow(dead_code)] // a target reads one kind of file
pub fn case(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else {
        return;
    };
    match CaseFile::parse(text, "fuzz.toml", &[]) {
        Ok(file) => {
            assert!(file.case().check().is_ok());
            let again = CaseFile::from_document(file.document().clone(), "again").unwrap();
            assert_eq!(again.case(), file.case());
            CaseFile::from_document(file.document_as_run(), "as run").unwrap();
        }
        Err(error) => assert!(error.to_string().contains("fuzz.toml"), "{error}"),
    }
}

/// Puts a case with a rotor into `folder`, as `base.toml`.
#[allow(dead_code)]
pub fn prepare_rotor(folder: &Path) {
    let case = include_str!("../../../../cases/touchdown-d.toml");
    fs::write(folder.join("base.toml"), case).unwrap();
}

/// Reads a rotor file in `folder`, where its case is; one that is accepted is the same rotor when its
/// document is read again.
#[allow(dead_code)]
pub fn rotor(bytes: &[u8], folder: &Path) {
    let Ok(text) = std::str::from_utf8(bytes) else {
        return;
    };
    match BearingArrangement::parse(text, "fuzz.toml", folder, &[]) {
        Ok(file) => {
            let again = file.changed(&[]).unwrap();
            assert_eq!(again.to_toml().unwrap(), file.to_toml().unwrap());
        }
        Err(error) => assert!(!error.to_string().is_empty()),
    }
}

/// Reads the matrices of a rotor in `folder` and reduces the rotor to its first and last node.
#[allow(dead_code)]
pub fn matrices(bytes: &[u8], folder: &Path) {
    let path = folder.join("fuzz.json");
    fs::write(&path, bytes).unwrap();
    match read_matrices(&path) {
        Ok(matrices) => {
            let last = (matrices.mass.nrows() / 4).saturating_sub(1);
            let rotor = format!(
                "[rotor]\nmatrices = \"fuzz.json\"\nspeed_rpm = 9000.0\n[bearing.1]\ncase = \
                 \"base.toml\"\nnode = 0\n[bearing.2]\ncase = \"base.toml\"\nnode = {last}\n"
            );
            self::rotor(rotor.as_bytes(), folder);
        }
        Err(error) => assert!(error.to_string().contains("fuzz.json"), "{error}"),
    }
}

/// Reads a plan in `folder`, where its case is.
#[allow(dead_code)]
pub fn plan(bytes: &[u8], folder: &Path) {
    let Ok(text) = std::str::from_utf8(bytes) else {
        return;
    };
    match PlanFile::parse(text, "plan.toml", folder) {
        Ok(plan) => {
            let normal = plan.normal().unwrap();
            let again = PlanFile::parse(&normal, "normal.toml", folder).unwrap();
            assert_eq!(again.normal().unwrap(), normal);
        }
        Err(error) => assert!(!error.to_string().is_empty()),
    }
}

/// Opens a journal in `folder`; one that is accepted can be opened again with the same entries.
#[allow(dead_code)]
pub fn journal(bytes: &[u8], owner: &str, folder: &Path) {
    let path = folder.join("fuzz.journal");
    fs::write(&path, bytes).unwrap();
    match Journal::open(&path, owner) {
        Ok((journal, entries)) => {
            drop(journal);
            let (_journal, again) = Journal::open(&path, owner).unwrap();
            assert_eq!(again.len(), entries.len());
        }
        Err(error) => assert!(error.to_string().contains("fuzz.journal"), "{error}"),
    }
}

/// Reads a table of results in `folder` to its last row.
#[allow(dead_code)]
pub fn table(bytes: &[u8], folder: &Path) {
    let path = folder.join("fuzz.parquet");
    fs::write(&path, bytes).unwrap();
    let read = TableReader::open(&path).and_then(|reader| {
        let stated = reader.rows();
        let rows = reader.into_rows().collect::<Result<Vec<_>, _>>()?;
        assert_eq!(rows.len() as u64, stated);
        Ok(())
    });
    if let Err(error) = read {
        assert!(error.to_string().contains("fuzz.parquet"), "{error}");
    }
}
