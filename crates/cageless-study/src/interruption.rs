//! Interruption of work in progress.

use cageless::simulation::Control;

use crate::error::StudyError;

/// `Break(())` if `interrupted`, else `Continue(())`.
pub fn break_if(interrupted: bool) -> Control {
    if interrupted {
        Control::Break(())
    } else {
        Control::Continue(())
    }
}

/// The finding; `None` if the progress ended the work, which is noted.
pub(crate) fn unless_interrupted<T>(
    found: Result<T, StudyError>,
    interrupted: &mut bool,
) -> Result<Option<T>, StudyError> {
    match found {
        Err(StudyError::Interrupted) => {
            *interrupted = true;
            Ok(None)
        }
        found => found.map(Some),
    }
}
