//! Formats of an exported ring.

use std::path::Path;

use serde::{Deserialize, Serialize};

cageless::named_enum! {
    /// Kinds of files.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
    #[serde(rename_all = "lowercase")]
    pub enum Format {
        /// One solid of B-splines, tori, cylinders and planes, AP214.
        Step = "step",
        /// Triangles, binary.
        Stl = "stl",
        /// Surface points, normals and contact track for a five-axis program.
        Csv = "csv",
    }
}

impl Format {
    /// The format of a file whose name ends in `.step`, `.stp`, `.stl` or `.csv`.
    pub fn from_path(path: &Path) -> Option<Self> {
        let ending = path.extension()?.to_str()?.to_ascii_lowercase();
        match ending.as_str() {
            "stp" => Some(Self::Step),
            ending => Self::ALL.into_iter().find(|f| f.name() == ending),
        }
    }
}
