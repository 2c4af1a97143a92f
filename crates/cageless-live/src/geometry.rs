//! Geometry of a case, its closed forms and its static equilibrium, in the units of the workshop.

use std::f64::consts::TAU;

use cageless::Case;
use cageless::design::Estimate;
use cageless::equilibrium;
use cageless::raceway::Raceway;
use cageless_io::case_file::CaseFile;
use cageless_results::{DESIGN, Results, Subject, static_record};
use serde_json::{Value, json};

use crate::refusal::Refusal;

/// Points along a raceway, from end to end and a fifth of θ beyond.
const ALONG: usize = 81;
/// Points across one side of the groove.
const ACROSS: usize = 15;
const BEYOND: f64 = 1.2;

/// Document, dimensions, contact tracks, groove depths, closed forms and estimate of a case.
pub(crate) fn geometry(file: &CaseFile) -> Result<Value, Refusal> {
    let case = file.case();
    let bearing = &case.bearing;
    let d = bearing.dimensions();
    let equilibrium = equilibrium::solve(case);
    let estimate = equilibrium
        .as_ref()
        .ok()
        .map(|e| Estimate::new(case, e))
        .map(|estimate| {
            let terms: Vec<Value> = estimate
                .terms()
                .iter()
                .map(|t| {
                    json!({
                        "name": t.name, "value": t.value, "limit": t.limit,
                        "margin": t.margin(), "at_least": t.at_least, "meaning": t.meaning,
                    })
                })
                .collect();
            json!({ "passes": estimate.passes(), "terms": terms })
        });
    let design = Results::of(DESIGN, Subject::Design(case));
    let mut rows = json!({ "design": rows(&design), "static": [] });
    let statics = match &equilibrium {
        Ok(e) => {
            let record = static_record(case, e);
            rows["static"] = self::rows(&record.results);
            json!(record)
        }
        // A bearing under a falling rotor has none.
        Err(_) if case.rotor.is_some() => json!({}),
        Err(error) => json!({ "error": error.to_string() }),
    };
    Ok(json!({
        "document": file.document(),
        "defaults": file.defaults(),
        "title": case.title,
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
    }))
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

/// Track and depth of one raceway. Depth is the distance from the plain groove, positive where
/// material is taken away, over ψ and z.
fn raceway(case: &Case, raceway: &Raceway) -> Value {
    let bearing = &case.bearing;
    let rw = bearing.ball_radius_m();
    let d = raceway.dimensions();
    let plain_curvature_m = bearing.dimensions().outer_groove_curvature_radius_m;
    // Centre circle of the plain groove.
    let plain_centre_m = bearing.dimensions().outer_groove_bottom_radius_m - plain_curvature_m;
    let (mut angle, mut radius, mut axial) = (vec![], vec![], vec![]);
    let (mut across, mut depth) = (vec![], vec![]);
    for k in 0..ALONG {
        let fraction = 2.0 * k as f64 / (ALONG - 1) as f64 - 1.0;
        let local = raceway.half_angle_rad() * BEYOND * fraction;
        let psi = d.centre_angle_rad + local;
        let r = raceway.effective_radius_m(psi);
        angle.push(local.to_degrees());
        radius.push(r * 1e3);
        axial.push((rw * rw - r * r).max(0.0).sqrt() * 1e3);
        let [from, to] = raceway.meridian_range_rad(psi, bearing);
        let (mut z_row, mut depth_row) = (vec![], vec![]);
        for j in 0..ACROSS {
            let eta = from + (to - from) * j as f64 / (ACROSS - 1) as f64;
            let [x, y, z] = raceway.surface(psi, eta).position_m;
            let from_centre = (x.hypot(y) - plain_centre_m).hypot(z);
            z_row.push((z * 1e6).round() / 1e3);
            depth_row.push(((from_centre - plain_curvature_m) * 1e8).round() / 1e2);
        }
        across.push(z_row);
        depth.push(depth_row);
    }
    json!({
        "shape": raceway.form().shape.name(),
        "axial_span_mm": d.axial_span_m * 1e3,
        "half_angle_deg": raceway.half_angle_rad().to_degrees(),
        "centre_angle_deg": d.centre_angle_rad.to_degrees(),
        "angle_deg": angle, "effective_radius_mm": radius, "track_mm": axial,
        "across_mm": across, "depth_um": depth,
    })
}

/// Label, value and unit of every result that has one, for readers.
fn rows(results: &Results) -> Value {
    results.rows().map(|row| json!(row)).collect()
}

/// The static equilibrium of a case.
pub(crate) fn equilibrium(case: &Case) -> Result<Value, Refusal> {
    Ok(json!(static_record(case, &equilibrium::solve(case)?)))
}
