//! The case file of a bearing by its own dimensions, and the operation of a new case.

use crate::case_file::{CaseError, CaseFile};

/// Balls of a bearing on their pitch circle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BallSet {
    /// Z.
    pub balls: u64,
    /// Dw, mm.
    pub ball_diameter_mm: f64,
    /// Dpw, mm.
    pub pitch_diameter_mm: f64,
}

/// Dimensions that make a bearing; the rest takes defaults.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OwnBearing {
    /// Balls.
    pub ball_set: BallSet,
    /// Gr, µm.
    pub clearance_um: f64,
}

/// Speed and loads of a new case, in place of those that are assumed.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct NewOperation {
    /// Speed of the inner ring, rpm.
    pub speed_rpm: Option<f64>,
    /// Fr, N.
    pub radial_load_n: Option<f64>,
    /// Fa, N.
    pub axial_load_n: Option<f64>,
}

impl BallSet {
    /// Sections of a new case after those of its dimensions: balls, rows if it has any, raceway, operation, contact,
    /// and what is left to its reader.
    pub(crate) fn sections(&self, hybrid: bool, rows: &str) -> String {
        let Self {
            balls,
            ball_diameter_mm: ball,
            pitch_diameter_mm: pitch,
        } = *self;
        let ball_material = match hybrid {
            true => {
                "[ball_material]                                # hybrid bearing, suffix HC5\npreset = \"Si3N4\"\n"
            }
            false => {
                "# [ball_material]                              # hybrid bearing: ceramic balls in steel rings\n# preset = \"Si3N4\"\n"
            }
        };
        // Two digits are enough for what is to be replaced.
        let round = |value: f64| format!("{value:.1e}").parse().unwrap_or(value);
        let speed: f64 = round(3e5 / pitch);
        let load: f64 = round(0.05 * 12.0 * balls as f64 * ball * ball);
        format!(
            "\
{ball_material}
{rows}\
# A conventional outer ring. `cageless design` proposes a discrete raceway for [raceway], and
# `cageless design --search` looks for the best one.
# [raceway]
# axial_span_mm =
# half_angle_deg =

[operation]
inner_speed_rpm = {speed:<28} # (assumed) n·Dpw of 300,000 mm/min
radial_load_n = {load:<30} # (assumed) about 4 % of the static load rating

[contact]
friction_coefficient = 0.007                   # (assumed) lubricated (Zhao 2022); dry steel has 0.1 to 0.3

{OPTIONAL_SECTIONS}"
        )
    }
}

impl OwnBearing {
    /// A commented case file.
    pub fn case_file(&self) -> String {
        let BallSet {
            balls,
            ball_diameter_mm: ball,
            pitch_diameter_mm: pitch,
        } = self.ball_set;
        format!(
            "\
# A bearing by its dimensions. Replace what is marked (assumed). Everything that is left out takes a
# default: `cageless check` lists them with their values.
schema = 1
title = \"{balls} balls of {ball} mm on {pitch} mm\"

[bearing]
balls = {balls}
ball_diameter_mm = {ball:<27} # Dw
pitch_diameter_mm = {pitch:<26} # Dpw
radial_internal_clearance_um = {clearance:<15} # Gr
inner_conformity = 0.52                        # (assumed) groove radius over Dw
outer_conformity = 0.52                        # (assumed)

{sections}",
            clearance = self.clearance_um,
            // Without a designation nothing gives the diameters of the seats.
            sections = self.ball_set.sections(false, "").replacen(
                "# shaft",
                "# bore_diameter_mm =\n# outside_diameter_mm =\n# shaft",
                1
            )
        )
    }

    /// The case file with an operation, read once.
    ///
    /// # Errors
    /// The [`CaseError`] of dimensions or an operation that cannot be.
    pub fn checked(&self, operation: &NewOperation) -> Result<String, CaseError> {
        let text = operation.entered(&self.case_file());
        CaseFile::parse(&text, "new case", &[])?;
        Ok(text)
    }
}

/// Sections that a new case leaves to its reader.
const OPTIONAL_SECTIONS: &str = "\
# [fit]                                        # fits and temperatures make the clearance in operation
# shaft = \"k5\"
# housing = \"H7\"
# inner_ring_temperature_c = 60.0
# outer_ring_temperature_c = 55.0

# [lubrication]                                # modified life, minimum load and SKF's friction in `static`
# viscosity_mm2_s = 20.0                       # left out with [film]
# contamination_factor = 0.5

# [film]                                       # oil film, which resists rolling and spaces balls
# supply = \"flooded\"                           # or \"two-drops\", or 0.1: nearly dry, greased
# oil = \"iso-vg-32\"
# temperature_c = 70.0                         # of the inlet: that of the rings
";

impl NewOperation {
    /// A case file with these values in its section of the operation.
    pub fn entered(&self, text: &str) -> String {
        let given = |key: &str, value: f64| format!("{key} = {value}");
        let mut lines: Vec<String> = vec![];
        for line in text.lines() {
            let key = line.split_once(" = ").map_or("", |(key, _)| key);
            let value = match key {
                "inner_speed_rpm" => self.speed_rpm,
                "radial_load_n" => self.radial_load_n,
                _ => None,
            };
            lines.push(value.map_or(line.to_owned(), |value| given(key, value)));
            if key == "radial_load_n" {
                lines.extend(self.axial_load_n.map(|value| given("axial_load_n", value)));
            }
        }
        lines.join("\n") + "\n"
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const OWN: OwnBearing = OwnBearing {
        ball_set: BallSet {
            balls: 12,
            ball_diameter_mm: 8.0,
            pitch_diameter_mm: 32.0,
        },
        clearance_um: 10.0,
    };
    const OPERATION: NewOperation = NewOperation {
        speed_rpm: Some(8000.0),
        radial_load_n: Some(3000.0),
        axial_load_n: Some(-400.0),
    };

    #[test]
    fn a_new_case_is_the_bearing_in_its_operation() {
        let text = OWN.checked(&OPERATION).unwrap();
        let file = CaseFile::parse(&text, "new", &[]).unwrap();
        let (bearing, operation) = (&file.case().bearing, &file.case().operation);
        assert_eq!(bearing.balls(), 12);
        assert!((bearing.ball_radius_m() - 4e-3).abs() < 1e-15);
        assert!((bearing.pitch_radius_m() - 16e-3).abs() < 1e-15);
        assert!((bearing.radial_internal_clearance_m() - 10e-6).abs() < 1e-12);
        let speed_rpm = operation.inner_speed_rad_s * 30.0 / std::f64::consts::PI;
        assert!((speed_rpm - 8000.0).abs() < 1e-9);
        assert_eq!(
            (operation.radial_load_n, operation.space.axial_load_n),
            (3000.0, -400.0)
        );
    }

    /// The commented-out sections of a new case are valid once their diameters are filled in.
    #[test]
    fn optional_sections_are_sections() {
        let text = OWN.checked(&NewOperation::default()).unwrap();
        let (head, sections) = text.split_at(text.find("# [fit]").unwrap());
        let sections = sections.lines().map(|line| {
            let line = line.strip_prefix("# ").unwrap_or(line);
            let line = line.replace("bore_diameter_mm =", "bore_diameter_mm = 20.0");
            line.replace("outside_diameter_mm =", "outside_diameter_mm = 44.0") + "\n"
        });
        let text = head.to_owned() + &sections.collect::<String>();
        // The oil of the film is that of the ratings.
        let text = text.replace("viscosity_mm2_s", "# viscosity_mm2_s");
        let file = CaseFile::parse(&text, "new", &[]).unwrap();
        let own = file.particulars();
        assert!(own.fit.is_some() && own.lubrication.is_some());
        assert!(file.case().film.is_some(), "{text}");
    }

    #[test]
    fn balls_that_do_not_fit_are_refused() {
        let ball_set = BallSet {
            balls: 13,
            ..OWN.ball_set
        };
        let many = OwnBearing { ball_set, ..OWN };
        let error = many.checked(&OPERATION).unwrap_err().to_string();
        assert!(error.contains("balls"), "{error}");
    }
}
