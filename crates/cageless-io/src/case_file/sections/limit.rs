//! `[[limit]]`.

use cageless::touchdown::LimitSide;

use crate::case_file::declaration::prelude::*;

section! {
    /// `[[limit]]`: a limit of a user on a result.
    impl cageless::touchdown::Limit {
        result => result: String = Required, Plain,
            "name of a number among the results of static, run, design, compare or drop: l10_h, operating_clearance_um, rotor_force_max_n, …", Absent;
        value => value: f64 = Required, Plain,
            "the most that it may be in magnitude, of a temperature with its sign, in the unit of the result; the least where more is better", Absent;
        side => side: Option<LimitSide> = Optional, Plain,
            "which side of the value is allowed, with its sign; by the result unless given", Absent;
        source => source: String = Required, Plain,
            "whose limit it is: a specification, a maker", Absent;
    }
}
