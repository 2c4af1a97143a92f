//! `[[limit]]`.

use crate::case_file::declaration::prelude::*;

section! {
    /// `[[limit]]`: a limit of a user on a result of a drop.
    impl cageless::touchdown::Limit {
        result => result: String = Required, Plain,
            "name of a number among the results of a drop or of drops in succession: rotor_force_max_n, ball_standstill_c, …", Absent;
        value => value: f64 = Required, Plain,
            "the most that it may be in magnitude, of a temperature with its sign, in the unit of the result; the least where more is better", Absent;
        source => source: String = Required, Plain,
            "whose limit it is: a specification, a maker", Absent;
    }
}
