//! Conversion of a search result to display units, names and sentences.

use cageless::design::search::{
    Cause, Confirmed, Evaluation, Found, MapCell, Motion, ObjectiveScale, OperatingPoint, SpeedMap,
};
use cageless::design::span_angle_curve;
use cageless_io::case_file::CaseFile;

use super::narrative;
use super::rejections::rejections;
use super::result::{
    MapData, MotionNumbers, PlacementData, PointData, PointNumbers, PointVerdict, SearchData,
    StructureData,
};
use crate::error::StudyError;
use crate::{Provenance, provenance};

/// Points of the curve of Eq. (11).
const CURVE_POINTS: usize = 120;

/// Data of a search for reports.
pub fn search_data(
    file: &CaseFile,
    found: &Found,
    verdicts: Vec<PointVerdict>,
) -> Result<SearchData, StudyError> {
    let (case, request) = (file.case(), &found.request);
    let confirmed = |role: &str| found.confirmed.iter().find(|c| c.role == role);
    let mut data = SearchData {
        points: request.points.iter().map(point_data).collect(),
        critical_gap_min_fraction: request.critical_gap_min_fraction,
        starts: request.starts,
        seed: case.seed,
        recommended: confirmed("recommended").map(confirmed_data),
        recommended_verdicts: verdicts,
        own: confirmed("own").map(confirmed_data),
        own_from_usual_starts: confirmed("own").map(|c| structure_data(&c.evaluation)),
        recommended_from_usual_starts: found
            .recommended
            .map(|k| structure_data(&found.evaluations[k])),
        front: front(found),
        band: found.evaluations.iter().map(structure_data).collect(),
        rejections: rejections(found),
        placements: placements(found),
        maps: found.maps.iter().map(map_data).collect(),
        provenance: search_provenance(file, found),
        ..SearchData::default()
    };
    let curve = span_angle_curve(&case.bearing, CURVE_POINTS);
    for p in curve {
        if let Some(angle) = p.half_angle_rad {
            data.curve_axial_span_mm.push(p.axial_span_m * 1e3);
            data.curve_half_angle_deg.push(angle.to_degrees());
        }
    }
    data.findings = narrative::narrative(found, &data);
    Ok(data)
}

fn search_provenance(file: &CaseFile, found: &Found) -> Provenance {
    let point = found.request.points[0];
    let case = point.case(file.case(), file.case().raceways.clone());
    provenance(
        &case,
        "the first 16 of 32 orbits, except collisions and friction".to_owned(),
    )
}

fn point_data(point: &OperatingPoint) -> PointData {
    PointData {
        // Rounding away what the conversion to SI leaves.
        inner_speed_rpm: (point.inner_speed_rad_s * 60.0 / std::f64::consts::TAU * 1e6).round()
            / 1e6,
        radial_load_n: point.radial_load_n,
    }
}

fn degrees(angles: &[f64]) -> Vec<f64> {
    angles
        .iter()
        .map(|a| (a.to_degrees() * 1e6).round() / 1e6)
        .collect()
}

/// A structure with its numbers.
fn structure_data(e: &Evaluation) -> StructureData {
    let (status, reason, why) = match (&e.rejection, &e.objectives) {
        (Some(r), _) => (
            "rejected",
            Some(r.cause.name().to_owned()),
            r.cause.to_string(),
        ),
        (None, Some(_)) => ("accepted", None, String::new()),
        (None, None) => (
            "left out",
            None,
            "not run: the budget was spent on others".to_owned(),
        ),
    };
    let steady = e.forms.map(|f| f.steady_gap_rad);
    StructureData {
        axial_span_mm: (e.structure.axial_span_m * 1e9).round() / 1e6,
        half_angle_deg: degrees(&[e.structure.half_angle_rad])[0],
        centre_angles_deg: degrees(&e.structure.centres_rad),
        status: status.to_owned(),
        passes: (status != "left out").then_some(status == "accepted"),
        reason,
        why,
        on_front: e.on_front,
        beta0_deg: e.forms.map(|f| f.theoretical_gap_rad.to_degrees()),
        steady_gap_deg: steady.map(f64::to_degrees),
        points: (0..e.spacing.len())
            .map(|p| {
                let s = e.spacing[p];
                PointNumbers {
                    critical_gap_deg: s.map(|s| s.critical_gap_rad.to_degrees()),
                    margin_deg: s
                        .zip(steady)
                        .map(|(s, steady)| (steady - s.critical_gap_rad).to_degrees()),
                    slip_shortfall: s.map(|s| s.shortfall),
                    pressure_mpa: s.map(|s| s.stress_pa * 1e-6),
                    motion: e.motion[p]
                        .zip(steady)
                        .map(|(m, steady)| motion_data(&m, steady)),
                    ..PointNumbers::default()
                }
            })
            .collect(),
    }
}

/// Numbers of a motion.
fn motion_data(m: &Motion, steady_gap_rad: f64) -> MotionNumbers {
    MotionNumbers {
        collisions: m.collisions,
        collisions_late: m.collisions_late,
        double_collision_fraction: m.double_collision_fraction,
        impulse_mn_s: m.impulse_n_s * 1e3,
        spacing_scatter: m.gap_deviation_rad / steady_gap_rad,
        gap_min_deg: m.gap_min_rad.to_degrees(),
        sliding_m_s: m.sliding_m_s,
        speed_drop_fraction: m.speed_drop_fraction,
        force_deviation_n: m.force_deviation_n,
        friction_w: m.friction_w,
    }
}

fn confirmed_data(c: &Confirmed) -> StructureData {
    let mut data = structure_data(&c.evaluation);
    let steady = c.evaluation.forms.map_or(f64::NAN, |f| f.steady_gap_rad);
    for (numbers, s) in data.points.iter_mut().zip(&c.statistics) {
        numbers.motion = Some(motion_data(&s.mean, steady));
        numbers.errors = Some(motion_data(&s.error, steady));
    }
    data
}

/// The scale of the front.
fn scale(found: &Found) -> Option<ObjectiveScale> {
    ObjectiveScale::new(found.front().filter_map(|e| e.objectives.as_ref()))
}

/// Distance from the best in everything.
fn distance(scale: &Option<ObjectiveScale>, e: &Evaluation) -> f64 {
    match (scale, &e.objectives) {
        (Some(scale), Some(objectives)) => scale.distance(objectives),
        _ => f64::INFINITY,
    }
}

fn front(found: &Found) -> Vec<StructureData> {
    let scale = scale(found);
    let mut front: Vec<&Evaluation> = found.front().collect();
    front.sort_by(|a, b| distance(&scale, a).total_cmp(&distance(&scale, b)));
    front.into_iter().map(structure_data).collect()
}

fn placements(found: &Found) -> Vec<PlacementData> {
    let scale = scale(found);
    let places = found.request.placements.iter().enumerate();
    places
        .map(|(k, centres)| {
            let here: Vec<&Evaluation> = found
                .evaluations
                .iter()
                .filter(|e| e.placement == k)
                .collect();
            let accepted = here.iter().filter(|e| e.objectives.is_some());
            let best = accepted
                .clone()
                .min_by(|a, b| distance(&scale, a).total_cmp(&distance(&scale, b)));
            let worst_slip = |e: &&Evaluation| {
                let all: Option<Vec<f64>> =
                    e.spacing.iter().map(|s| s.map(|s| s.shortfall)).collect();
                all?.into_iter().reduce(f64::max)
            };
            PlacementData {
                centre_angles_deg: degrees(centres),
                structures: here.len(),
                accepted: accepted.count(),
                least_shortfall: here.iter().filter_map(worst_slip).reduce(f64::min),
                best: best.map(|e| structure_data(e)),
            }
        })
        .collect()
}

fn map_data(map: &SpeedMap) -> MapData {
    let columns = map.axial_span_m.len();
    fn grid<T>(map: &SpeedMap, columns: usize, of: impl Fn(&MapCell) -> T) -> Vec<Vec<T>> {
        map.cells
            .chunks(columns)
            .map(|row| row.iter().map(&of).collect())
            .collect()
    }
    MapData {
        point: point_data(&map.point),
        axial_span_mm: map.axial_span_m.iter().map(|s| s * 1e3).collect(),
        half_angle_deg: degrees(&map.half_angle_rad),
        critical_gap_deg: grid(map, columns, |c| {
            c.spacing.map(|s| s.critical_gap_rad.to_degrees())
        }),
        steady_gap_deg: grid(map, columns, |c| {
            c.forms.map(|f| f.steady_gap_rad.to_degrees())
        }),
        verdict: grid(map, columns, |c| {
            c.cause.as_ref().map_or("smooth", Cause::name).to_owned()
        }),
        passes: grid(map, columns, |c| c.cause.is_none()),
    }
}

#[cfg(test)]
mod tests;
