//! What the head of a page says of the balls and the operation of a case.

use cageless::{Case, Tilt};

use crate::text::significant;

/// Balls of a case: `2 rows of 13 balls`.
pub(crate) fn balls(case: &Case) -> String {
    let rows = match case.rows.len() {
        0 | 1 => String::new(),
        rows => format!("{rows} rows of "),
    };
    format!("{rows}{} balls", case.bearing.balls())
}

/// Speed and loads of a case: `6000 rpm, 800 N, axial load 300 N`; what is 0 but the radial load is left
/// out.
pub(crate) fn operation(case: &Case) -> String {
    let of = &case.operation;
    let number = |value: f64| significant(value, 6);
    let axes = |what: &str, unit: &str, [x, y]: [f64; 2]| {
        let given = [("x", x), ("y", y)].into_iter().filter(|(_, v)| *v != 0.0);
        let texts = given.map(|(axis, v)| format!(", {what} about {axis} {} {unit}", number(v)));
        texts.collect::<String>()
    };
    let axial = match of.space.axial_load_n {
        0.0 => String::new(),
        load => format!(", axial load {} N", number(load)),
    };
    let turned = match of.space.tilt {
        Tilt::Held { x_rad, y_rad } => axes("tilt", "mrad", [1e3 * x_rad, 1e3 * y_rad]),
        Tilt::Free {
            moment_x_n_m,
            moment_y_n_m,
        } => axes("moment", "N·m", [moment_x_n_m, moment_y_n_m]),
    };
    format!(
        "{} rpm, {} N{axial}{turned}",
        number(of.inner_speed_rad_s * 60.0 / std::f64::consts::TAU),
        number(of.radial_load_n)
    )
}
