//! Benefit that a single run leaves open.

/// The open benefit of a raceway by its verdict, for readers; `None` where it does not work or is not judged.
pub fn open_benefit(passes: Option<bool>) -> Option<&'static str> {
    (passes == Some(true)).then_some(
        "not judged: a raceway that works slows single balls as intended; `cageless compare CASE --remedies` says \
         whether that helps",
    )
}
