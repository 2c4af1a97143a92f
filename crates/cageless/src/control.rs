//! Requests of a caller to work in progress.

/// Request of the caller to work in progress: `Continue(())`, or `Break(())` to end it as soon as it can.
pub type Control = std::ops::ControlFlow<()>;
