//! `[output]`.

use crate::case_file::declaration::prelude::*;

section! {
    /// `[output]`: what a run writes.
    struct OutputSection {
        interval_us => interval_s: f64 = default(100.0), Microsecond; Above(0.0),
            "time between rows of the result", Shown("100.0", "time between rows of the result");
    }
}
