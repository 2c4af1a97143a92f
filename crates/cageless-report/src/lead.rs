//! Balls and operation of a case, for the head of a page.

use cageless::{Case, Tilt};

use crate::text::significant;

/// Bearing and operation: `14 balls of 9.525 mm, pitch diameter 46.005 mm; 12000 rpm, 1500 N.`
pub(crate) fn bearing(case: &Case) -> String {
    let of = &case.bearing;
    let diameters = [of.ball_radius_m(), of.pitch_radius_m()];
    let [ball, pitch] = diameters.map(|radius_m| significant(2e3 * radius_m, 6));
    let (balls, operation) = (balls(case), operation(case));
    format!("{balls} of {ball} mm, pitch diameter {pitch} mm; {operation}.")
}

/// Balls of a case: `2 rows of 13 balls`.
pub(crate) fn balls(case: &Case) -> String {
    let rows = match case.rows.len() {
        0 | 1 => String::new(),
        rows => format!("{rows} rows of "),
    };
    format!("{rows}{} balls", case.bearing.balls())
}

/// Speed and loads of a case: `6000 rpm, 800 N, axial load 300 N`, over time `0 to 6000 rpm`; what is 0 but the radial
/// load is left out.
pub(crate) fn operation(case: &Case) -> String {
    let of = &case.operation;
    let number = |value: f64| significant(value, 6);
    let axes = |what: &str, unit: &str, x: f64, y: f64| {
        let given = [("x", x), ("y", y)].into_iter().filter(|(_, v)| *v != 0.0);
        let texts = given.map(|(axis, v)| format!(", {what} about {axis} {} {unit}", number(v)));
        texts.collect::<String>()
    };
    let axial = match of.space.axial_load_n {
        0.0 => String::new(),
        load => format!(", axial load {} N", number(load)),
    };
    let turned = match of.space.tilt {
        Tilt::Held { x_rad, y_rad } => axes("tilt", "mrad", 1e3 * x_rad, 1e3 * y_rad),
        Tilt::Free {
            moment_x_n_m,
            moment_y_n_m,
        } => axes("moment", "N·m", moment_x_n_m, moment_y_n_m),
    };
    let range = |low: f64, high: f64| match low == high {
        true => number(high),
        false => format!("{} to {}", number(low), number(high)),
    };
    let rpm = |speed: f64| speed * 60.0 / std::f64::consts::TAU;
    let [slowest, fastest] = case.inner_speed_range_rad_s().map(rpm);
    let [least, most] = case.radial_load_range_n();
    format!(
        "{} rpm, {} N{axial}{turned}",
        range(slowest, fastest),
        range(least, most)
    )
}

#[cfg(test)]
mod tests {
    use cageless_io::case_file::{CaseFile, template};

    /// A speed or load over time has its range in the run, whatever its table has after that.
    #[test]
    fn an_operation_over_time_is_a_range() {
        for (set, expected) in [
            ("operation.radial_load_n=1500", "12000 rpm, 1500 N"),
            (
                "operation.inner_speed_rpm=[[0.0, 0.0], [0.01, 12000.0], [9.0, 99.0]]",
                "0 to 12000 rpm, 1500 N",
            ),
            (
                "operation.radial_load_n=[[0.0, 300.0], [0.04, 700.0]]",
                "12000 rpm, 300 to 500 N",
            ),
        ] {
            let changes = [set, "solver.duration_s=0.02"].map(str::to_owned);
            let file = CaseFile::parse(&template(false), "case.toml", &changes).unwrap();
            assert_eq!(super::operation(file.case()), expected);
        }
    }
}
