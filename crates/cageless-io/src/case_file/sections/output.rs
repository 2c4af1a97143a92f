//! `[output]`.

use crate::case_file::declaration::section;
use crate::case_file::key::Limit::Above;
use crate::case_file::key::Line::Shown;
use crate::case_file::key::default;
use crate::case_file::unit::Unit::Microsecond;

section! {
    /// `[output]`: what a run writes.
    impl cageless::Output {
        interval_us => interval_s: f64 = default(100.0), Microsecond; Above(0.0),
            "time between rows of the result", Shown("100.0", "time between rows of the result");
    }
}
