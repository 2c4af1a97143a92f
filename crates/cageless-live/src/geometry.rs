//! Geometry of a case, its closed forms and its static equilibrium, in the units of the workshop.

use std::f64::consts::TAU;

use cageless::Case;
use cageless::closed_forms::seats;
use cageless::equilibrium::{EquilibriumError, settle_controlled};
use cageless::raceway::Raceway;
use cageless::simulation::Control;
use cageless::surface::DrawnGroove;
use cageless_design::{Estimate, EstimateTerm};
use cageless_io::case_file::{CaseError, CaseFile};
use cageless_results::{DESIGN, Record, Results, Subject, static_record};
use serde_json::{Value, json};

use crate::motion::{DEGREES, rounded};
use crate::plain_film::plain_film;
use crate::refusal::Refusal;

/// Points along a raceway, from end to end and a fifth of θ beyond.
const ALONG: usize = 81;
/// Points across one side of the groove.
const ACROSS: usize = 15;
/// Points across one side of a groove with a slot, edges and walls included.
const ACROSS_SLOT: usize = 25;
const BEYOND: f64 = 1.2;

/// Document, dimensions, contact tracks, groove depths, closed forms and estimate of a case.
pub(crate) fn geometry(
    file: &CaseFile,
    control: &mut dyn FnMut(f64) -> Control,
) -> Result<Value, Refusal> {
    let case = file.case();
    let bearing = &case.bearing;
    let d = bearing.dimensions();
    let constant = constant(file).map_err(|error| error.to_string());
    let settled = match constant.map(|()| settled(file, control)) {
        Ok(Err(EquilibriumError::Interrupted)) => return Err(EquilibriumError::Interrupted.into()),
        Ok(settled) => settled.map_err(|error| error.to_string()),
        Err(refused) => Err(refused),
    };
    let estimate = settled.as_ref().ok().map(|(_, of)| shown(of));
    let design = Results::of(DESIGN, Subject::Design(case));
    let mut rows = json!({ "design": rows(&design), "static": [] });
    let statics = match &settled {
        Ok((record, _)) => {
            rows["static"] = self::rows(&record.results);
            json!(record)
        }
        // A bearing under a falling rotor has none.
        Err(_) if case.rotor.is_some() => json!({}),
        Err(error) => json!({ "error": error }),
    };
    Ok(json!({
        "document": file.document(),
        "defaults": file.defaults(),
        "title": file.particulars().title,
        "bearing": {
            "balls": bearing.balls(),
            "ball_radius_mm": bearing.ball_radius_m() * 1e3,
            "pitch_radius_mm": bearing.pitch_radius_m() * 1e3,
            "inner_radius_mm": d.inner_groove_bottom_radius_m * 1e3,
            "outer_radius_mm": d.outer_groove_bottom_radius_m * 1e3,
            "shoulder_radius_mm": d.outer_shoulder_radius_m * 1e3,
            "inner_curvature_mm": d.inner_groove_curvature_radius_m * 1e3,
            "outer_curvature_mm": d.outer_groove_curvature_radius_m * 1e3,
            "radial_internal_clearance_um": bearing.radial_internal_clearance_m() * 1e6,
        },
        "numbers": design,
        "rows": rows,
        "rolling_orbit_ms": case.rolling_orbit_s() * 1e3,
        "raceways": case.raceways.iter().map(|r| raceway(case, r)).collect::<Vec<_>>(),
        "static": statics,
        "estimate": estimate,
        "rotor": rotor(case),
        "space": space(case),
    }))
}

/// The terms of an estimate, and whether all are kept.
fn shown(estimate: &Estimate) -> Value {
    let terms: Vec<Value> = estimate.terms.iter().map(term).collect();
    json!({ "passes": estimate.passes(), "terms": terms })
}

fn term(term: &EstimateTerm) -> Value {
    json!({
        "name": term.name, "value": term.value, "limit": term.limit,
        "margin": term.margin(), "at_least": term.at_least, "meaning": term.meaning,
    })
}

/// The static equilibrium of a case and the estimate of its verdict, in space where it moves there.
fn settled(
    file: &CaseFile,
    control: &mut dyn FnMut(f64) -> Control,
) -> Result<(Record, Estimate), EquilibriumError> {
    let (case, mut ask) = (file.case(), || control(0.0));
    let solved = settle_controlled(case, &mut ask)?;
    let estimate = match case.has_elastic_flanks() {
        true => Estimate::elastic(case, &seats(case, &mut ask)?, Some(&solved.rest)),
        false => Estimate::new(case, &solved.rest),
    };
    let estimate = match plain_film(case, &mut ask)? {
        Some(film) => estimate.in_oil(case, &film),
        None => estimate,
    };
    Ok((static_record(case, file.particulars(), &solved), estimate))
}

/// Contact signs of the rows and shoulder angles, inner and outer, of a case that moves in space.
fn space(case: &Case) -> Option<Value> {
    let signs: Vec<f64> = (case.all_rows().iter())
        .map(|row| row.contact_sign)
        .collect();
    let angles = rounded(&case.bearing.shoulder_angles_rad(), DEGREES, 4);
    case.moves_in_space()
        .then(|| json!({ "signs": signs, "shoulders_deg": angles }))
}

/// The rotor of a case and the bore that it falls onto.
fn rotor(case: &Case) -> Option<Value> {
    let rotor = case.rotor.as_ref()?;
    let bore = case.bearing.inner_ring_bore()?;
    Some(json!({
        "bore_radius_mm": bore.radius_m * 1e3,
        "radial_clearance_um": rotor.radial_clearance_m * 1e6,
        "weight_n": rotor.mass_kg * case.operation.gravity_m_s2,
        "speed_rpm": rotor.speed_rad_s * 60.0 / TAU,
        "support": case.support.is_some(),
    }))
}

/// Flanks and depth of one raceway of the first row. Depth is the distance from
/// the plain groove, positive where material is taken away, over ψ and z from shoulder to shoulder.
fn raceway(case: &Case, raceway: &Raceway) -> Value {
    let bearing = &case.bearing;
    let d = raceway.dimensions();
    let plain_curvature_m = bearing.dimensions().outer_groove_curvature_radius_m;
    // Centre circle of the plain groove.
    let plain_centre_m = bearing.dimensions().outer_groove_bottom_radius_m - plain_curvature_m;
    let sign = case.all_rows()[0].contact_sign;
    let plain_z_m = -sign * bearing.groove_offset_m();
    let groove = DrawnGroove::new(bearing, Some(raceway), sign);
    let across_side = match groove.recess() {
        Some(_) => ACROSS_SLOT,
        None => ACROSS,
    };
    let (mut angle, mut radius) = (vec![], vec![]);
    let (mut flanks, mut tracks) = ([vec![], vec![]], [vec![], vec![]]);
    let (mut across, mut depth) = (vec![], vec![]);
    for k in 0..ALONG {
        let fraction = 2.0 * k as f64 / (ALONG - 1) as f64 - 1.0;
        let local = raceway.half_angle_rad() * BEYOND * fraction;
        let psi = d.centre_angle_rad + local;
        angle.push(local);
        radius.push(raceway.effective_radius_m(psi));
        let section = groove.meridian(psi);
        let (mut z_row, mut depth_row) = (vec![], vec![]);
        for (n, arc) in section.arcs.iter().enumerate() {
            let contact = arc.point(psi, arc.contact_angle_rad);
            flanks[n].push(arc.side.sign() * arc.contact_angle_rad);
            tracks[n].push(contact.position_m[2]);
        }
        for [x, y, z] in groove.points(psi, across_side) {
            let from_centre = (x.hypot(y) - plain_centre_m).hypot(z - plain_z_m);
            z_row.push(z);
            depth_row.push(from_centre - plain_curvature_m);
        }
        across.push(rounded(&z_row, 1e3, 3));
        depth.push(rounded(&depth_row, 1e6, 2));
    }
    let degrees = |angles: &[f64]| rounded(angles, DEGREES, 6);
    json!({
        "shape": raceway.form().shape.name(),
        "axial_span_mm": d.axial_span_m * 1e3,
        "half_angle_deg": raceway.half_angle_rad().to_degrees(),
        "centre_angle_deg": d.centre_angle_rad.to_degrees(),
        "angle_deg": degrees(&angle),
        "effective_radius_mm": rounded(&radius, 1e3, 6),
        "centre_mm": plain_z_m * 1e3,
        "flank_deg": flanks.each_ref().map(|angles| degrees(angles)),
        "track_mm": tracks.each_ref().map(|z| rounded(z, 1e3, 6)),
        "across_mm": across, "depth_um": depth,
    })
}

/// Label, value and unit of every result that has one, for readers.
fn rows(results: &Results) -> Value {
    results.rows().map(|row| json!(row)).collect()
}

/// The static equilibrium of a case.
pub(crate) fn equilibrium(
    file: &CaseFile,
    control: &mut dyn FnMut(f64) -> Control,
) -> Result<Value, Refusal> {
    constant(file)?;
    Ok(json!(settled(file, control)?.0))
}

/// Passes a case that has one equilibrium, not one for each time.
fn constant(file: &CaseFile) -> Result<(), CaseError> {
    file.checked(|case| case.check_constant_operation("a static equilibrium"))
}
