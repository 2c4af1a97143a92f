//! Interruption of work in progress.

use cageless::simulation::Control;

/// `Break(())` if `interrupted`, else `Continue(())`.
pub fn break_if(interrupted: bool) -> Control {
    if interrupted {
        Control::Break(())
    } else {
        Control::Continue(())
    }
}
