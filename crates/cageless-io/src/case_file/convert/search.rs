//! Request of a search.

use cageless::{Case, Formulation, RacewayShape};
use cageless_design::search::{OperatingPoint, Request, placements};

use crate::case_file::converter::Converter;
use crate::case_file::error::CaseError;
use crate::case_file::named::SearchedShapes;
use crate::case_file::unit::Side;
use crate::case_file::unit::Unit::Degree;

/// Further maps at most.
const MAPS_MAX: usize = 8;

impl Converter<'_> {
    /// The request of `[search]`.
    pub(in crate::case_file) fn search(&self, case: &Case) -> Result<Request, CaseError> {
        let mut request = Request {
            seed: self.sections.solver.seed,
            ..Request::from_case(case)
        };
        let Some(search) = &self.sections.search else {
            return Ok(request);
        };
        let own = OperatingPoint::from_case(case);
        let speeds = search
            .inner_speed_rad_s
            .unwrap_or([own.inner_speed_rad_s; 2]);
        let loads = search.radial_load_n.unwrap_or([own.radial_load_n; 2]);
        let axial = search.axial_load_n.unwrap_or([own.axial_load_n; 2]);
        request.points = corners(speeds, loads, axial);
        let in_space = case.moves_in_space();
        let needs_space = "left out, or the case in space by model.motion = \"space\"";
        if search.axial_load_n.is_some() && !in_space {
            return Err(self.refuse("search.axial_load_n", needs_space));
        }
        if let Some(angles_rad) = &search.section_angle_rad {
            if !in_space {
                return Err(self.refuse("search.contact_angle_deg", needs_space));
            }
            let [_, shoulder_rad] = case.bearing.shoulder_angles_rad();
            if angles_rad
                .iter()
                .any(|angle_rad| angle_rad.abs() >= shoulder_rad)
            {
                let shoulder = Degree.show(shoulder_rad, Side::Lower);
                let allowed = format!("angles below {shoulder}, that of the outer shoulder");
                return Err(self.refuse("search.contact_angle_deg", &allowed));
            }
            request.section_angles_rad.clone_from(angles_rad);
        }
        if let Some(edge_radius_m) = search.edge_radius_m {
            let own = case.raceway_form();
            let allowed = match (in_space, search.shapes, own.shape) {
                (false, ..) => Some(needs_space),
                (_, SearchedShapes::Own, _) => {
                    Some("left out, or search.shapes = \"all\", which then tries slots as well")
                }
                (.., RacewayShape::Slot) if edge_radius_m != own.edge_radius_m => {
                    Some("raceway.edge_radius_mm, or left out: slots of the case keep their edges")
                }
                _ => None,
            };
            if let Some(allowed) = allowed {
                return Err(self.refuse("search.edge_radius_mm", allowed));
            }
        }
        request.axial_span_range_m = search.axial_span_m;
        request.half_angle_range_rad = search.half_angle_rad;
        let centres = search
            .centre_angle_rad
            .unwrap_or([request.placements[0][0]; 2]);
        request.placements = placements(centres, search.raceways_max);
        if search.shapes == SearchedShapes::All {
            if case.formulation == Formulation::Paper {
                return Err(self.refuse("search.shapes", "\"own\" in the formulation \"paper\""));
            }
            let own = case.raceway_form();
            let slot = search.edge_radius_m.map(|_| RacewayShape::Slot);
            let others = RacewayShape::by_dimensions().chain(slot);
            let others = others.filter(|shape| *shape != own.shape);
            let edge_radius_m = search.edge_radius_m.unwrap_or_default();
            let others = others.map(|shape| own.reshaped(shape, edge_radius_m));
            request.forms.extend(others);
        }
        if search.axial_load_max_n > 0.0 && case.formulation == Formulation::Paper {
            return Err(self.refuse("search.axial_load_max_n", "0 in the formulation \"paper\""));
        }
        if search.axial_load_max_n > 0.0 && in_space {
            return Err(self.refuse(
                "search.axial_load_max_n",
                "0 for a case in space, which has search.axial_load_n",
            ));
        }
        request.axial_load_max_n = search.axial_load_max_n;
        request.critical_gap_min_fraction = search.critical_gap_min_fraction;
        request.starts = search.initial_states;
        request.map_speeds_rad_s = search.map_speeds_rad_s.clone().unwrap_or_default();
        if request.map_speeds_rad_s.len() > MAPS_MAX {
            let allowed = format!("a list of at most {MAPS_MAX} speeds in rpm");
            return Err(self.refuse("search.map_speed_rpm", &allowed));
        }
        let least = request.budget_least();
        if search.runs_max < least {
            let allowed = format!(
                "{least} or more with search.initial_states = {}, operating points: {}, maps at further \
                 speeds: {}",
                request.starts,
                request.points.len(),
                request.map_speeds_rad_s.len()
            );
            return Err(self.refuse("search.runs_max", &allowed));
        }
        request.budget = search.runs_max;
        Ok(request)
    }
}

/// The ends of all ranges: slip is worst at the highest speed under the least load, stress
/// under the highest load at either speed.
fn corners(speeds: [f64; 2], loads: [f64; 2], axial: [f64; 2]) -> Vec<OperatingPoint> {
    let ends = |range: [f64; 2]| {
        let mut ends = range.to_vec();
        ends.dedup();
        ends
    };
    let mut points = vec![];
    for inner_speed_rad_s in ends(speeds) {
        for radial_load_n in ends(loads) {
            points.extend(ends(axial).into_iter().map(|axial_load_n| OperatingPoint {
                inner_speed_rad_s,
                radial_load_n,
                axial_load_n,
            }));
        }
    }
    points
}
