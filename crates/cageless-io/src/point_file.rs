//! Files of points of a measuring machine.
//!
//! A line has the coordinates x, y and z of a point in mm, separated by commas, semicolons, tabs or
//! spaces; between semicolons a comma is a decimal sign. A first line of names says where `x_mm`,
//! `y_mm` and `z_mm` are, as in a table of `cageless export --format csv`; without one they are the
//! first three. Empty lines and those that begin with `#` are left out.

use std::path::Path;

use crate::case_file::unit::Unit;
use crate::text_file::{excerpt, read_text};

/// Larger files are of no measuring machine: this is some two million points.
const SIZE_MAX: u64 = 128 << 20;
/// Names of the coordinates.
const COORDINATES: [&str; 3] = ["x_mm", "y_mm", "z_mm"];

/// Points with the lines that they stand in.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Points {
    /// Coordinates, m.
    pub places_m: Vec<[f64; 3]>,
    /// Number of the line of each, from 1.
    pub lines: Vec<usize>,
}

/// Reads points.
///
/// # Errors
/// A message with file and line.
pub fn read_points(path: &Path) -> Result<Points, String> {
    let name = path.display();
    let text = read_text(path, "file of points", SIZE_MAX)
        .map_err(|problem| format!("{name}: {problem}"))?;
    let mut columns = [0, 1, 2];
    let (mut points, mut head) = (Points::default(), 0);
    let lines = text.lines().enumerate();
    let lines = lines.filter(|(_, line)| !line.trim().is_empty() && !line.starts_with('#'));
    for (nth, (index, line)) in lines.enumerate() {
        let cells = cells(line);
        if nth == 0 && !cells.iter().any(|cell| cell.parse::<f64>().is_ok()) {
            let column = |named: &str| {
                cells
                    .iter()
                    .position(|cell| cell.trim_matches('"') == named)
            };
            for (column_of, named) in columns.iter_mut().zip(COORDINATES) {
                *column_of = column(named).ok_or_else(|| {
                    format!(
                        "{name}:{}: has no column {named}; a head names x_mm, y_mm and z_mm",
                        index + 1
                    )
                })?;
            }
            head = cells.len();
            continue;
        }
        let number = |column: usize| {
            cells
                .get(column)?
                .parse()
                .ok()
                .filter(|v: &f64| v.is_finite())
        };
        let point = columns.map(number);
        // Twice as many cells as the head: each second comma is a decimal sign.
        let decimal_commas = cells.len() == 2 * head;
        let ([Some(x), Some(y), Some(z)], false) = (point, decimal_commas) else {
            return Err(format!(
                "{name}:{}: \"{}\" is not possible: it must be x, y and z in mm{}",
                index + 1,
                excerpt(line),
                match line.contains(',') {
                    true => "; a decimal sign is a point, or a comma between semicolons",
                    false => "",
                }
            ));
        };
        let place_m = [x, y, z].map(|mm| Unit::Millimetre.to_si(mm));
        points.places_m.push(place_m);
        points.lines.push(index + 1);
    }
    Ok(points)
}

/// The cells of a line.
fn cells(line: &str) -> Vec<String> {
    let parts: Vec<&str> = if line.contains(';') {
        return line
            .split(';')
            .map(|cell| cell.trim().replace(',', "."))
            .collect();
    } else if line.contains(',') {
        line.split(',').map(str::trim).collect()
    } else {
        line.split_whitespace().collect()
    };
    parts.into_iter().map(str::to_owned).collect()
}
