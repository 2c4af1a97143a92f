//! A drop with the files of its bearings.

use cageless::simulation::RotorDrop;
use cageless_io::case_file::CaseFile;
use cageless_results::Particulars;

/// A drop with the files of its bearings, which have the particulars of each.
#[derive(Debug, Clone)]
pub struct FiledDrop<'f> {
    /// The drop.
    pub drop: RotorDrop,
    /// The file of each bearing.
    pub files: &'f [CaseFile],
}

impl<'f> FiledDrop<'f> {
    /// Another drop into bearings with the same particulars.
    pub fn like(&self, drop: RotorDrop) -> FiledDrop<'f> {
        Self {
            drop,
            files: self.files,
        }
    }

    /// Particulars of each bearing.
    pub(crate) fn particulars(&self) -> impl Iterator<Item = &'f Particulars> {
        self.files.iter().map(CaseFile::particulars)
    }

    /// Seed of the draws: that of the first bearing.
    pub(crate) fn seed(&self) -> u64 {
        self.files[0].particulars().seed
    }
}
