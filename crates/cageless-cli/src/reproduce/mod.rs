//! `cageless reproduce`.

use crate::args::Reproduce;
use crate::failure::Failure;
use crate::progress::StopFlag;

/// Regenerates the paper.
pub fn reproduce(_args: &Reproduce, _stop: &StopFlag) -> Result<(), Failure> {
    Ok(())
}
