//! Deep groove ball bearings by designation: boundary dimensions of ISO 15, and a case file that
//! assumes the inside, which no standard fixes.

use std::f64::consts::PI;

use crate::case_file::keys;

/// Designation of series and bore, and the dimensions that ISO 15 gives them, mm.
#[derive(Debug, Clone, PartialEq)]
pub struct BoundaryDimensions {
    /// Series and bore code, `6008` say.
    pub designation: String,
    /// d, bore diameter.
    pub bore_mm: f64,
    /// D, outside diameter.
    pub outside_mm: f64,
    /// B, width.
    pub width_mm: f64,
}

/// Bore diameters of the bore codes 00 to 20, mm.
const BORES: [u16; 21] = [
    10, 12, 15, 17, 20, 25, 30, 35, 40, 45, 50, 55, 60, 65, 70, 75, 80, 85, 90, 95, 100,
];

/// Series with outside diameter and width of the bore codes 00 to 20, mm (ISO 15).
#[rustfmt::skip]
const SERIES: [(&str, [(u16, u16); 21]); 5] = [
    ("60", [(26, 8), (28, 8), (32, 9), (35, 10), (42, 12), (47, 12), (55, 13), (62, 14), (68, 15),
        (75, 16), (80, 16), (90, 18), (95, 18), (100, 18), (110, 20), (115, 20), (125, 22),
        (130, 22), (140, 24), (145, 24), (150, 24)]),
    ("62", [(30, 9), (32, 10), (35, 11), (40, 12), (47, 14), (52, 15), (62, 16), (72, 17), (80, 18),
        (85, 19), (90, 20), (100, 21), (110, 22), (120, 23), (125, 24), (130, 25), (140, 26),
        (150, 28), (160, 30), (170, 32), (180, 34)]),
    ("63", [(35, 11), (37, 12), (42, 13), (47, 14), (52, 15), (62, 17), (72, 19), (80, 21), (90, 23),
        (100, 25), (110, 27), (120, 29), (130, 31), (140, 33), (150, 35), (160, 37), (170, 39),
        (180, 41), (190, 43), (200, 45), (215, 47)]),
    ("618", [(19, 5), (21, 5), (24, 5), (26, 5), (32, 7), (37, 7), (42, 7), (47, 7), (52, 7),
        (58, 7), (65, 7), (72, 9), (78, 10), (85, 10), (90, 10), (95, 10), (100, 10), (110, 13),
        (115, 13), (120, 13), (125, 13)]),
    ("619", [(22, 6), (24, 6), (28, 7), (30, 7), (37, 9), (42, 9), (47, 9), (55, 10), (62, 12),
        (68, 12), (72, 12), (80, 13), (85, 13), (90, 13), (100, 16), (105, 16), (110, 16),
        (120, 18), (125, 18), (130, 18), (140, 20)]),
];

/// Radial internal clearance of deep groove ball bearings, group Normal of ISO 5753-1: bores up to
/// this diameter in mm have from the second to the third number in µm.
const CLEARANCE_UM: [(u16, u16, u16); 9] = [
    (10, 2, 13),
    (18, 3, 18),
    (24, 5, 20),
    (30, 5, 20),
    (40, 6, 20),
    (50, 6, 23),
    (65, 8, 28),
    (80, 10, 30),
    (100, 12, 36),
];

/// Every designation of the table.
pub fn designations() -> impl Iterator<Item = BoundaryDimensions> {
    SERIES.into_iter().flat_map(|(series, sizes)| {
        let bores = BORES.into_iter().enumerate();
        bores
            .zip(sizes)
            .map(move |((code, bore), (outside, width))| BoundaryDimensions {
                designation: format!("{series}{code:02}"),
                bore_mm: bore.into(),
                outside_mm: outside.into(),
                width_mm: width.into(),
            })
    })
}

/// Looks up a designation.
///
/// # Errors
/// A message with what is allowed if the table does not have it.
pub fn find(designation: &str) -> Result<BoundaryDimensions, String> {
    let all: Vec<_> = designations().collect();
    if let Some(found) = all.iter().find(|b| b.designation == designation) {
        return Ok(found.clone());
    }
    let near = keys::nearest(designation, all.iter().map(|b| b.designation.as_str()));
    let hint = near.map_or(String::new(), |near| format!("; did you mean {near}?"));
    Err(format!(
        "`{designation}` is not possible: it must be a series of deep groove ball bearings (60, 62, \
         63, 618, 619) with a bore code from 00 to 20, such as 6008, without suffixes{hint}"
    ))
}

/// The assumed inside of a bearing.
#[derive(Debug, Clone, PartialEq)]
pub struct Inside {
    /// Dw.
    pub ball_diameter_mm: f64,
    /// Dpw.
    pub pitch_diameter_mm: f64,
    /// N.
    pub balls: usize,
    /// Gr.
    pub clearance_um: f64,
}

/// Ball diameter over the difference of outside and bore diameter.
const BALL_SHARE: f64 = 0.29;
/// Balls come in steps of 1/64 inch, mm.
const BALL_STEP_MM: f64 = 25.4 / 64.0;
/// Angle that balls fill which enter between eccentric rings (Conrad).
const FILLING_ANGLE: f64 = 195.0 / 180.0 * PI;

impl BoundaryDimensions {
    /// The inside that catalogues of deep groove ball bearings come close to; with
    /// `full_complement`, as many balls as the pitch circle holds, else as many as enter between
    /// eccentric rings.
    pub fn inside(&self, full_complement: bool) -> Inside {
        let section = self.outside_mm - self.bore_mm;
        let steps = (BALL_SHARE * section / BALL_STEP_MM).round().max(1.0);
        let ball_diameter_mm = steps * BALL_STEP_MM;
        let pitch_diameter_mm = (self.outside_mm + self.bore_mm) / 2.0;
        let ball_angle = 2.0 * (ball_diameter_mm / pitch_diameter_mm).asin();
        let balls = if full_complement {
            2.0 * PI / ball_angle
        } else {
            1.0 + FILLING_ANGLE / ball_angle
        };
        let group = CLEARANCE_UM
            .iter()
            .find(|(bore, ..)| self.bore_mm <= f64::from(*bore));
        let (_, least, most) = group.copied().unwrap_or_default();
        Inside {
            ball_diameter_mm,
            pitch_diameter_mm,
            balls: balls.floor() as usize,
            clearance_um: f64::from(least + most) / 2.0,
        }
    }

    /// A case file with every assumption in a comment.
    pub fn case_file(&self, full_complement: bool) -> String {
        let Inside {
            ball_diameter_mm: ball,
            pitch_diameter_mm: pitch,
            balls,
            clearance_um,
        } = self.inside(full_complement);
        let (name, d, big, width) = (
            &self.designation,
            self.bore_mm,
            self.outside_mm,
            self.width_mm,
        );
        let filling = if full_complement {
            "full complement: as many as the pitch circle holds"
        } else {
            "as many as enter between eccentric rings (195° filled)"
        };
        let kind = if full_complement {
            "full complement"
        } else {
            "cageless"
        };
        // Two digits are enough for what is to be replaced.
        let round = |value: f64| {
            let digit = 10f64.powf(value.log10().floor() - 1.0);
            (value / digit).round() * digit
        };
        let speed = round(3e5 / pitch);
        let load = round(0.05 * 12.0 * balls as f64 * ball * ball);
        format!(
            "\
# {name}, {kind}: boundary dimensions d {d} mm, D {big} mm, B {width} mm (ISO 15).
# No standard fixes the inside of a bearing. What is marked (assumed) comes close to catalogue
# bearings of this size; measure yours or ask its maker, and replace it. Everything that is left
# out takes a default: `cageless check` lists them with their values.
schema = 1
title = \"{name}, {kind}\"

[bearing]
balls = {balls:<38} # (assumed) {filling}
ball_diameter_mm = {ball:<27} # (assumed) Dw, 0.29 (D - d) in steps of 1/64 inch
pitch_diameter_mm = {pitch:<26} # (assumed) Dpw = (D + d)/2
radial_internal_clearance_um = {clearance_um:<15} # (assumed) Gr, middle of group Normal of ISO 5753-1
inner_conformity = 0.52                        # (assumed) groove radius over Dw
outer_conformity = 0.52                        # (assumed)
outer_ring_outer_radius_mm = {outer:<17} # D/2, for the export to CAD
outer_ring_width_mm = {width:<24} # B

# [ball_material]                              # hybrid bearing: ceramic balls in steel rings
# preset = \"Si3N4\"

# A conventional outer ring. `cageless design` proposes a discrete raceway for [raceway], and
# `cageless design --search` looks for the best one.
# [raceway]
# axial_span_mm =
# half_angle_deg =

[operation]
inner_speed_rpm = {speed:<28} # (assumed) n·Dpw of 300,000 mm/min
radial_load_n = {load:<30} # (assumed) about 5 % of the static load rating
",
            outer = big / 2.0,
        )
    }
}
