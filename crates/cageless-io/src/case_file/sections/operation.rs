//! `[operation]`.

use crate::case_file::declaration::prelude::*;
use crate::case_file::fields::OverTime;

section! {
    /// `[operation]`: speed and load.
    struct OperationSection {
        inner_speed_rpm => inner_speed_rad_s: Option<OverTime> = Optional, RevolutionPerMinute,
            "speed of the inner ring, not 0, negative: clockwise, the bearing then seen from its other face; or [[time in s, speed], …], linear between; left out with a [rotor], else required",
            Shown("12000.0", "counter-clockwise (paper), or [[time in s, rpm], …]");
        radial_load_n => radial_load_n: Option<OverTime> = Optional, Si("N"),
            "Fr, load on the inner ring, downwards, or [[time in s, load], …], linear between; left out with a [rotor], else required",
            Shown("1500.0", "Fr, downwards (paper), or [[time in s, N], …]");
        gravity_m_s2 => gravity_m_s2: f64 = default(9.81), Si("m/s^2"); AtLeast(0.0),
            "g, downwards", Shown("9.81", "downwards");
        unbalance_g_mm => unbalance_kg_m: Option<f64> = Optional, GramMillimetre; AtLeast(0.0),
            "m·e, unbalance of what turns with the inner ring, from +X at t = 0; not with a [rotor]", Absent;
        axial_load_n => axial_load_n: Option<f64> = Optional, Si("N"),
            "Fa, load on the inner ring along the axis, +z; 0 unless given",
            Commented("150.0", "Fa, along +z: the balls move in space");
        moment_x_n_m => moment_x_n_m: Option<f64> = Optional, Si("N m"),
            "moment on the inner ring about x, which is then free to tilt", Absent;
        moment_y_n_m => moment_y_n_m: Option<f64> = Optional, Si("N m"),
            "moment on the inner ring about y, which is then free to tilt", Absent;
        shaft_transverse_inertia_kg_m2 => shaft_transverse_inertia_kg_m2: Option<f64> = Optional, Si("kg m^2"); Above(0.0),
            "moment of inertia of inner ring and shaft about a diameter through the middle of the ring, with which moments turn it in a run", Absent;
        shaft_polar_inertia_kg_m2 => shaft_polar_inertia_kg_m2: Option<f64> = Optional, Si("kg m^2"); Above(0.0),
            "moment of inertia of inner ring and shaft about their axis, of the gyroscopic moment in a run", Absent;
        tilt_x_mrad => tilt_x_rad: Option<f64> = Optional, Milliradian,
            "tilt of the inner ring about x that the shaft holds; 0 unless given or a moment is", Absent;
        tilt_y_mrad => tilt_y_rad: Option<f64> = Optional, Milliradian,
            "tilt of the inner ring about y that the shaft holds; 0 unless given or a moment is", Absent;
    }
}
