//! The sheet with the views of an outer ring, its dimensions and tolerances.

use std::collections::BTreeMap;

use cageless::Raceway;
use cageless::surface::{OuterRing, Recess, Side};
use cageless_io::cad::{ExportError, outer_ring};
use cageless_io::case_file::CaseFile;
use cageless_study::measured::Limits;

use super::dimension::{angle_text, length_text, short};
use super::paper::{Anchor, FRAME_MM, NOTE_MM, Paper, Pen, TEXT_MM};
use super::views::{DrawnRing, Room, contacts};
use crate::length::mm;

/// A4 across, mm.
const A4: [f64; 2] = [297.0, 210.0];
/// Stations from the middle of a raceway to its end, shares of θ.
const STATIONS: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];
/// Raceways of different dimensions that the table has.
const KINDS: usize = 4;

/// The drawing of the outer ring of a case, as it is exported, with the tolerances of its raceways.
///
/// # Errors
/// The case lacks the outside of the ring, its ring is impossible, or it has several rows.
pub fn ring_drawing(file: &CaseFile, limits: &Limits) -> Result<Paper, ExportError> {
    let case = file.case();
    let ring = outer_ring(file)?;
    let drawn = DrawnRing {
        ring: &ring,
        bearing: &case.bearing,
        contact_sign: case.rows.first().map_or(1.0, |row| row.contact_sign),
    };
    let name = match file.particulars().title.as_str() {
        "" => "Outer ring".to_owned(),
        title => format!("Outer ring: {title}"),
    };
    let mut paper = Paper::new(&name, A4);
    let frame = A4.map(|mm| mm - FRAME_MM);
    paper.rectangle([FRAME_MM; 2], frame, Pen::Wide);
    let extent = |raceway: &Raceway| extent_text(raceway, limits);
    let front = Room {
        middle: [54.0, 72.0],
        size_mm: [72.0, 72.0],
    };
    drawn.front(&mut paper, front, &extent);
    let upper = |x: f64| Room {
        middle: [x, 48.0],
        size_mm: [82.0, 34.0],
    };
    if let Some(plain_rad) = drawn.plain_rad() {
        drawn.plain_section(&mut paper, upper(157.0), plain_rad);
    }
    if let Some(first) = ring.raceways().next() {
        let span = span_text(first, limits);
        drawn.raceway_section(&mut paper, upper(243.0), first, &span);
        let track = Room {
            middle: [206.0, 116.0],
            size_mm: [110.0, 26.0],
        };
        drawn.track(&mut paper, track, first, [&extent(first), &span]);
    }
    dimensions(&mut paper, &ring, limits);
    section(&mut paper, &ring);
    block(&mut paper, file, &name);
    Ok(paper)
}

/// Table of the raceways, those that differ in nothing but their place in one row.
fn dimensions(paper: &mut Paper, ring: &OuterRing, limits: &Limits) {
    let mut kinds: BTreeMap<Vec<String>, Vec<String>> = BTreeMap::new();
    for raceway in ring.raceways() {
        let place = angle_text(raceway.dimensions().centre_angle_rad);
        kinds
            .entry(of_kind(raceway, limits))
            .or_default()
            .push(place);
    }
    if kinds.is_empty() {
        return;
    }
    let heads = [
        "Shape",
        "Middle, from –Y",
        "Angle",
        "lC, mm",
        "Depth",
        "Ends",
    ];
    let mut rows = vec![heads.map(str::to_owned).to_vec()];
    let left_out = kinds.len().saturating_sub(KINDS);
    let tolerance = match limits.centre_angle_deg {
        Some(degrees) => format!(" ± {}°", short(degrees)),
        None => String::new(),
    };
    rows.extend(kinds.into_iter().take(KINDS).map(|(kind, places)| {
        let mut row = kind;
        let places = match places.as_slice() {
            [one, _, _, _, ..] => format!("{} × from {one}", places.len()),
            few => few.join(", "),
        };
        row.insert(1, places + &tolerance);
        row
    }));
    let top = A4[1] - FRAME_MM - 6.0 - 5.4 * rows.len() as f64;
    let left = FRAME_MM + 4.0;
    let title = match left_out {
        0 => "Discrete raceway".to_owned(),
        more => format!("Discrete raceways; {more} more by the case file"),
    };
    paper.text([left, top - 1.8], Anchor::Start, TEXT_MM, &title);
    paper.table([left, top], &[22.0, 29.0, 27.0, 27.0, 30.0, 29.0], &rows);
}

/// Shape, extent, span, depth tolerance and ends of a raceway, as cells of its row.
fn of_kind(raceway: &Raceway, limits: &Limits) -> Vec<String> {
    let flanks = match raceway.slot() {
        Some(_) => "edges",
        None => "profile",
    };
    let depth = format!("{flanks} ± {} µm", short(limits.groove_depth_um));
    let ends = match (raceway.slot(), raceway.blend_m()) {
        (Some(_), _) => "round".to_owned(),
        (None, 0.0) => "not blended".to_owned(),
        (None, blend_m) => format!("blend {} mm", length_text(blend_m)),
    };
    vec![
        raceway.form().shape.name().to_owned(),
        extent_text(raceway, limits),
        span_text(raceway, limits),
        depth,
        ends,
    ]
}

/// Section of the first raceway: contact points at stations from its middle to its end, or the dimensions of a slot.
fn section(paper: &mut Paper, ring: &OuterRing) {
    let Some(raceway) = ring.raceways().next() else {
        return;
    };
    let (title, rows) = match ring.recesses.first().filter(|_| raceway.slot().is_some()) {
        Some(slot) => ("Slot", of_slot(slot)),
        None => (
            "Groove of two arcs that meet in the apex, along the raceway",
            stations(ring, raceway),
        ),
    };
    let top = A4[1] - FRAME_MM - 54.0;
    let left = FRAME_MM + 4.0;
    paper.text([left, top - 1.8], Anchor::Start, TEXT_MM, title);
    let columns = rows[0].len() - 1;
    let widths: Vec<f64> = [54.0].into_iter().chain(vec![22.0; columns]).collect();
    paper.table([left, top], &widths, &rows);
}

fn stations(ring: &OuterRing, raceway: &Raceway) -> Vec<Vec<String>> {
    let centre = raceway.dimensions().centre_angle_rad;
    let heads = [
        "Angle from the middle",
        "z between contact points, mm",
        "Radius of the apex, mm",
    ];
    let mut rows = heads.map(|head| vec![head.to_owned()]);
    for share in STATIONS {
        // At the end itself the plain groove begins.
        let local = share * raceway.half_angle_rad() * (1.0 - 1e-12);
        let section = ring.meridian(centre + local);
        let [above, below] = contacts(&section).map(|point| point.z_m);
        let upper = section.arc(Side::Upper);
        rows[0].push(angle_text(local));
        rows[1].push(format!("{:.3}", mm(above - below)));
        let apex = upper.radius_at_m(upper.valley_rad());
        rows[2].push(format!("{:.4}", mm(apex)));
    }
    rows.into()
}

fn of_slot(slot: &Recess) -> Vec<Vec<String>> {
    let row = |name: &str, m: f64| vec![format!("{name}, mm"), length_text(m)];
    vec![
        row("Distance of the walls", slot.width_m),
        row("Floor below the plain groove", slot.depth_m),
        row("Radius of the edges", slot.edge_radius_m),
    ]
}

/// Notes and title.
fn block(paper: &mut Paper, file: &CaseFile, name: &str) {
    let case = file.case();
    let [width, height] = [101.0, 56.0];
    let [left, top] = [A4[0] - FRAME_MM - width, A4[1] - FRAME_MM - height];
    paper.rectangle([left, top], [left + width, top + height], Pen::Wide);
    let ball = length_text(2.0 * case.bearing.ball_radius_m());
    let notes = [
        "Lengths in mm. +Y up, the axis along Z, angles from –Y".to_owned(),
        "counter-clockwise, seen against Z.".to_owned(),
        format!("Contact points, lC apart: of a ball Ø {ball} in the groove."),
        "Depth: along the normal of the flanks, least at the ends.".to_owned(),
        "Surface: cageless export --format step.".to_owned(),
        "Roughness, edges and form: by the maker of the ring.".to_owned(),
    ];
    for (k, note) in notes.iter().enumerate() {
        let y = top + 5.5 + 4.6 * k as f64;
        paper.text([left + 2.5, y], Anchor::Start, NOTE_MM, note);
    }
    let line = top + 33.0;
    paper.line([[left, line], [left + width, line]], Pen::Narrow);
    paper.text([left + 2.5, line + 8.0], Anchor::Start, fitting(name), name);
    paper.text(
        [left + 2.5, line + 14.5],
        Anchor::Start,
        NOTE_MM,
        "ISO 128, first-angle projection",
    );
    paper.text(
        [left + 2.5, line + 20.0],
        Anchor::Start,
        NOTE_MM,
        concat!("Cageless ", env!("CARGO_PKG_VERSION")),
    );
}

/// Size of a name that fits into the block.
fn fitting(name: &str) -> f64 {
    let wide = super::paper::width_mm(name, 1.0);
    // Other typefaces are wider.
    (80.0 / wide).clamp(2.0, 5.0)
}

/// Angle of a raceway from end to end, with twice the tolerance of θ.
fn extent_text(raceway: &Raceway, limits: &Limits) -> String {
    let whole = angle_text(2.0 * raceway.half_angle_rad());
    format!("{whole} ± {}°", short(2.0 * limits.half_angle_deg))
}

fn span_text(raceway: &Raceway, limits: &Limits) -> String {
    let span = length_text(raceway.dimensions().axial_span_m);
    format!("{span} ± {}", short(limits.axial_span_um / 1000.0))
}
