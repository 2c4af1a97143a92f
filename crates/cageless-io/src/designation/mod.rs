//! Deep groove and angular contact ball bearings by designation: boundary dimensions of ISO 15, balls, and a case file
//! that states where each number is from.

mod case_file;
mod internal_geometry;
mod suffix;

use crate::case_file::nearest;

pub use internal_geometry::{BallSource, InternalGeometry};
pub use suffix::{ClearanceGroup, Suffixes};

/// Designation, bore d, outside diameter D and width B of ISO 15, and number and diameter Dw of
/// the balls as NSK where they are known.
///
/// No standard fixes the balls. Number and diameter are those with which ISO 281 and ISO 76 give
/// the Cr, C0r and f0 of the maker's catalogue E1102f: whole numbers and stock sizes (1/64 inch or
/// mm) that fit all three. What no pair of them fits clearly is left out.
const TABLE: &str = include_str!("bearings.csv");

/// A designation, and the dimensions that ISO 15 gives it, mm.
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
    /// α of an angular contact bearing, degrees; 0 of a deep groove one.
    pub contact_angle_deg: f64,
    /// Meaning of the suffixes.
    pub suffixes: Suffixes,
    /// Number and diameter of the balls in the maker's deep groove bearing of this size with a cage.
    balls: Option<(usize, f64)>,
}

/// Bore diameter up to which ISO 5753-1 ends with C3.
const SMALL_BORE_MM: f64 = 6.0;

/// Suffixes of angular contact bearings and their contact angles, degrees.
const ANGLES: [(&str, f64); 3] = [("AC", 25.0), ("B", 40.0), ("C", 15.0)];

/// Series and bore code, contact angle in degrees of an angular contact bearing, and further suffixes of a designation.
fn parts(designation: &str) -> (String, f64, &str) {
    let text = designation.trim();
    // A stroke stands before a bore, 618/4 and 60/22, and before suffixes, 6205/C3.
    let bore_at = if text.starts_with("618") || text.starts_with("619") {
        3
    } else {
        2
    };
    let of_size = |(at, c): &(usize, char)| {
        let digit_follows = text[at + c.len_utf8()..].starts_with(|c: char| c.is_ascii_digit());
        c.is_ascii_digit() || (*c == '/' && *at == bore_at && digit_follows)
    };
    let end = text.char_indices().find(|at| !of_size(at));
    let (size, rest) = text.split_at(end.map_or(text.len(), |(at, _)| at));
    let suffix = rest.trim_start_matches(suffix::SEPARATORS);
    let angle = ANGLES
        .iter()
        .find(|(letters, _)| suffix.starts_with(letters));
    match (size.strip_prefix('7'), angle) {
        (Some(size), Some((letters, angle_deg))) => {
            (format!("6{size}"), *angle_deg, &suffix[letters.len()..])
        }
        _ => (size.to_owned(), 0.0, rest),
    }
}

/// Every designation of the table.
pub fn designations() -> impl Iterator<Item = BoundaryDimensions> {
    TABLE.lines().skip(1).filter_map(|line| {
        let mut fields = line.split(',');
        let designation = fields.next()?.to_owned();
        let [d, outside, width, balls, diameter] = std::array::from_fn(|_| fields.next());
        let number = |field: Option<&str>| field?.parse::<f64>().ok();
        Some(BoundaryDimensions {
            designation,
            bore_mm: number(d)?,
            outside_mm: number(outside)?,
            width_mm: number(width)?,
            contact_angle_deg: 0.0,
            suffixes: Suffixes::default(),
            balls: balls.and_then(|z| z.parse().ok()).zip(number(diameter)),
        })
    })
}

/// Looks up a designation. 618xx and 619xx are other spellings of 68xx and 69xx, 618/4 of 684; 70xx, 72xx, 73xx and 719xx
/// with the suffix of a contact angle have the boundary dimensions of 60xx, 62xx, 63xx and 619xx. Suffixes of makers follow.
///
/// # Errors
/// A message with what is allowed if the table does not have it.
pub fn find(designation: &str) -> Result<BoundaryDimensions, String> {
    let (of_size, contact_angle_deg, rest) = parts(designation);
    // A bore below 10 mm stands behind a stroke: 618/4.
    let short = match of_size.split_at_checked(3) {
        Some(("618", code)) if code.len() == 2 => format!("68{}", code.trim_start_matches('/')),
        Some(("619", code)) if code.len() == 2 => format!("69{}", code.trim_start_matches('/')),
        _ => of_size,
    };
    let all: Vec<_> = designations().collect();
    if let Some(found) = all.iter().find(|b| b.designation == short) {
        let suffixes = Suffixes::read(&rest.to_uppercase()).map_err(|unknown| {
            format!(
                "`{}` is not possible: the suffix `{unknown}` is not known; known are clearance groups (C2, C3, C4, C5), \
                 HC5 (hybrid), seals and shields (2RS1, 2Z, ZZ, LLU, DDU, …), cages (TN9, TVH, M) and P4 to P6",
                designation.trim()
            )
        })?;
        let found = BoundaryDimensions {
            designation: designation.trim().to_owned(),
            contact_angle_deg,
            suffixes,
            ..found.clone()
        };
        if found.clearance_limits_um().is_none() {
            return Err(format!(
                "`{}` is not possible: ISO 5753-1 has no group {} for bores of up to {SMALL_BORE_MM} mm",
                found.designation,
                found.suffixes.clearance_group.name()
            ));
        }
        return Ok(found);
    }
    let near = nearest(designation, all.iter().map(|b| b.designation.as_str()));
    let hint = match find_angular(designation) {
        true => format!("; did you mean {designation}C, {designation}AC or {designation}B?"),
        false => near.map_or(String::new(), |near| format!("; did you mean {near}?")),
    };
    Err(format!(
        "`{designation}` is not possible: it must be a deep groove ball bearing of the series 60, 62, \
         68 (618) or 69 (619) with a bore of up to 100 mm, of 63 from 10 mm or of 160 from 12 mm on, such as 6008, 608 \
         or 6205-2RS1/C3, or an angular contact ball bearing of the series 70, 72, 73 or 719 with that of its \
         contact angle: C (15°), AC (25°) or B (40°){hint}"
    ))
}

/// Whether a designation lacks but the suffix of an angular contact bearing.
fn find_angular(designation: &str) -> bool {
    designation.starts_with('7')
        && !designation.ends_with('C')
        && find(&format!("{designation}C")).is_ok()
}
