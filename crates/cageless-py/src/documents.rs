//! Case files and rotor files.

use std::path::PathBuf;

use cageless::dynamics::InstructionSet;
use cageless_cli::Failure;
use cageless_io::arrangement::BearingArrangement;
use cageless_io::case_file::{self, CaseFile};
use cageless_study::measured::{Limits, measured};
use pyo3::prelude::*;

use crate::errors::{Found, input, of_values, other};
use crate::rotor::LinearRotor;

/// A case file or a rotor file that was read and checked.
#[pyclass(frozen, module = "cageless._cageless")]
pub struct File(pub BearingArrangement);

/// A commented case file.
#[pyfunction]
pub fn template(conventional: bool) -> String {
    case_file::template(conventional)
}

/// The case file of a bearing of ISO 15.
#[pyfunction]
pub fn designated(designation: &str, full_complement: bool) -> Found<String> {
    let found = cageless_io::designation::find(designation).map_err(input)?;
    Ok(found.case_file(full_complement))
}

/// Vector instructions that runs use on this machine.
#[pyfunction]
pub fn instruction_set() -> &'static str {
    InstructionSet::chosen().name()
}

fn case(file: CaseFile) -> File {
    File(file.into())
}

/// A file of a rotor above several bearings, or one of a case.
fn of_kind(of_rotor: bool, name: &str, file: BearingArrangement) -> Found<File> {
    match (of_rotor, file.rotor_file()) {
        (true, None) => Err(input(format!(
            "{name}: is a case, not a rotor with its [[bearing]]"
        ))),
        (false, Some(_)) => Err(input(format!(
            "{name}: is a rotor with its [[bearing]], not a case"
        ))),
        _ => Ok(File(file)),
    }
}

impl File {
    /// The case, the first of several.
    pub fn case(&self) -> &CaseFile {
        &self.0.cases()[0]
    }
}

#[pymethods]
impl File {
    /// Reads a case file, or a rotor file; `changes` are `section.key=value`.
    #[staticmethod]
    fn read(of_rotor: bool, path: PathBuf, changes: Vec<String>) -> Found<Self> {
        of_kind(
            of_rotor,
            &path.display().to_string(),
            BearingArrangement::read(&path, &changes)?,
        )
    }

    /// Reads the text of such a file, which messages call `name`; paths in it are relative to `folder`.
    #[staticmethod]
    fn parse(
        of_rotor: bool,
        text: &str,
        name: &str,
        folder: PathBuf,
        changes: Vec<String>,
    ) -> Found<Self> {
        of_kind(
            of_rotor,
            name,
            BearingArrangement::parse(text, name, &folder, &changes)?,
        )
    }

    /// Takes the text of a case that was made of values, of whose lines its user knows nothing.
    #[staticmethod]
    fn of_values(text: &str) -> Found<Self> {
        let file = CaseFile::parse(text, "case", &[]);
        Ok(case(file.map_err(of_values)?))
    }

    /// A rotor above the bearings of `cases`.
    #[staticmethod]
    fn of_rotor(
        of: &LinearRotor,
        cases: Vec<PyRef<'_, Self>>,
        title: &str,
        speed_rpm: f64,
        drive_torque_n_m: f64,
    ) -> Found<Self> {
        let cases: Vec<_> = cases.iter().map(|file| file.case().clone()).collect();
        let of = &of.description;
        Ok(File(BearingArrangement::new(
            title,
            of,
            speed_rpm,
            drive_torque_n_m,
            &cases,
        )?))
    }

    /// The file with changes, each `section.key=value`.
    fn changed(&self, changes: Vec<String>) -> Found<Self> {
        self.0.changed(&changes).map(Self).map_err(of_values)
    }

    /// The case with its raceways as measured, from the points of a file, and the numbers as JSON; tolerances to either
    /// side of depth and span, µm, half angle and position, degrees.
    fn measured(&self, points: PathBuf, tolerances: [Option<f64>; 4]) -> Found<(Self, String)> {
        let [depth, span, half_angle, centre_angle_deg] = tolerances;
        let usual = Limits::default();
        let limits = Limits {
            groove_depth_um: depth.unwrap_or(usual.groove_depth_um),
            axial_span_um: span.unwrap_or(usual.axial_span_um),
            half_angle_deg: half_angle.unwrap_or(usual.half_angle_deg),
            centre_angle_deg,
        };
        let found = measured(self.case(), "case", &points, &limits)?;
        if let Some(missing) = found.missing {
            return Err(Failure::Unphysical(missing).into());
        }
        Ok((case(found.file), serde_json::to_string(&found.record)?))
    }

    /// The file with every default filled in; a rotor file with its cases and matrices.
    fn to_toml(&self) -> Found<String> {
        Ok(self.0.to_toml()?)
    }

    /// The document as JSON, of a case `as_run` with derived values.
    fn document(&self, as_run: bool) -> Found<String> {
        Ok(match self.0.case() {
            Some(file) if as_run => serde_json::to_string(&file.document_as_run())?,
            Some(file) => serde_json::to_string(file.document())?,
            None => serde_json::to_string(&self.0.to_value()?)?,
        })
    }

    /// Keys of the case that took their default.
    fn defaults(&self) -> Vec<String> {
        self.case().defaults().to_vec()
    }

    /// Gr in µm, ε and the nominal gap in degrees.
    fn derived(&self) -> [f64; 3] {
        let bearing = &self.case().case().bearing;
        [
            bearing.radial_internal_clearance_m() * 1e6,
            bearing.ball_angle_rad().to_degrees(),
            bearing.nominal_gap_rad().to_degrees(),
        ]
    }

    /// The rotor above several bearings, if it is the file of one.
    fn rotor(&self) -> Found<Option<LinearRotor>> {
        let file = self.0.rotor_file();
        file.map(|file| LinearRotor::of(file.rotor.clone()))
            .transpose()
    }

    /// The case of each bearing.
    fn cases(&self) -> Found<Vec<Self>> {
        let Some(file) = self.0.rotor_file() else {
            return Err(other("a case has no further cases"));
        };
        let document = file.cases.iter().zip(1..);
        let of = document.map(|(document, k)| {
            CaseFile::from_document(document.clone(), &format!("bearing {k}"))
        });
        of.map(|file| Ok(case(file.map_err(of_values)?))).collect()
    }
}
