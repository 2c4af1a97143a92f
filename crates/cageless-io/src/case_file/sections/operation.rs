//! `[operation]`.

use crate::case_file::declaration::section;
use crate::case_file::fields::OverTime;
use crate::case_file::key::Limit::AtLeast;
use crate::case_file::key::Line::Shown;
use crate::case_file::key::Presence::Optional;
use crate::case_file::key::default;
use crate::case_file::unit::Unit::{RevolutionPerMinute, Si};

section! {
    /// `[operation]`: speed and load.
    struct OperationSection {
        inner_speed_rpm => inner_speed_rad_s: Option<OverTime> = Optional, RevolutionPerMinute,
            "speed of the inner ring, negative: clockwise, the bearing then seen from its other face; or [[time in s, speed], …], linear between; left out with a [rotor], else required",
            Shown("12000.0", "counter-clockwise (paper), or [[time in s, rpm], …]");
        radial_load_n => radial_load_n: Option<OverTime> = Optional, Si("N"),
            "Fr, load on the inner ring, downwards, or [[time in s, load], …], linear between; left out with a [rotor], else required",
            Shown("1500.0", "Fr, downwards (paper), or [[time in s, N], …]");
        gravity_m_s2 => gravity_m_s2: f64 = default(9.81), Si("m/s^2"); AtLeast(0.0),
            "g, downwards", Shown("9.81", "downwards");
    }
}
