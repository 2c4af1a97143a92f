//! Formats of an exported ring.

use std::path::Path;

use serde::{Deserialize, Serialize};

/// Kinds of files.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Format {
    /// One solid of B-splines, tori, cylinders and planes, AP214.
    Step,
    /// Triangles, binary.
    Stl,
    /// Surface points, normals and contact track for a five-axis program.
    Csv,
}

impl Format {
    /// All.
    pub const ALL: [Self; 3] = [Self::Step, Self::Stl, Self::Csv];

    /// `step`, `stl` or `csv`, which is the ending of the file as well.
    pub fn name(self) -> &'static str {
        match self {
            Self::Step => "step",
            Self::Stl => "stl",
            Self::Csv => "csv",
        }
    }

    /// The format of a file whose name ends in `.step`, `.stp`, `.stl` or `.csv`.
    pub fn from_path(path: &Path) -> Option<Self> {
        let ending = path.extension()?.to_str()?.to_ascii_lowercase();
        match ending.as_str() {
            "stp" => Some(Self::Step),
            ending => Self::ALL.into_iter().find(|f| f.name() == ending),
        }
    }
}
