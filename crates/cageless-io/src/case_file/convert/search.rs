//! Request of a search.

use cageless::Case;
use cageless::design::search::{OperatingPoint, Request, placements};

use crate::case_file::converter::Converter;
use crate::case_file::error::CaseError;
use crate::case_file::fields::RangeDocument;
use crate::case_file::keys;

/// Further maps at most.
const MAPS_MAX: usize = 8;

impl Converter<'_> {
    /// The request of `[search]`.
    pub(in crate::case_file) fn search(&self, case: &Case) -> Result<Request, CaseError> {
        let mut request = Request::from_case(case);
        let Some(search) = &self.document.search else {
            return Ok(request);
        };
        let positive = |v: f64| v > 0.0;
        let own = OperatingPoint::from_case(case);
        let speeds = self
            .range(
                "inner_speed_rpm",
                search.inner_speed_rpm,
                "more than 0 rpm",
                positive,
            )?
            .unwrap_or([own.inner_speed_rad_s; 2]);
        let loads = self
            .range("radial_load_n", search.radial_load_n, "0 N or more", |v| {
                v >= 0.0
            })?
            .unwrap_or([own.radial_load_n; 2]);
        request.points = corners(speeds, loads);
        request.axial_span_range_m = self.range(
            "axial_span_mm",
            search.axial_span_mm,
            "more than 0 mm",
            positive,
        )?;
        request.half_angle_range_rad = self.range(
            "half_angle_deg",
            search.half_angle_deg,
            "more than 0 and less than 90 deg",
            |v| v > 0.0 && v < 90.0,
        )?;
        let centres = self
            .range(
                "centre_angle_deg",
                search.centre_angle_deg,
                "between -180 and 180 deg",
                |v| (-180.0..=180.0).contains(&v),
            )?
            .unwrap_or([request.placements[0][0]; 2]);
        self.whole("raceways_max", search.raceways_max as u64)?;
        request.placements = placements(centres, search.raceways_max);
        let spread = search.critical_gap_min_fraction;
        if !(spread > 0.0 && spread < 1.0) {
            let allowed = "more than 0 and less than 1";
            return Err(self.refuse(
                "search.critical_gap_min_fraction",
                &spread.to_string(),
                allowed,
            ));
        }
        request.critical_gap_min_fraction = spread;
        self.whole("initial_states", search.initial_states)?;
        request.starts = search.initial_states;
        let further = search.map_speed_rpm.as_deref().unwrap_or_default();
        if further.len() > MAPS_MAX || further.iter().any(|v| !(v.is_finite() && *v > 0.0)) {
            let allowed = format!("a list of at most {MAPS_MAX} speeds in rpm, each more than 0");
            return Err(self.refuse("search.map_speed_rpm", &format!("{further:?}"), &allowed));
        }
        request.map_speeds_rad_s = further
            .iter()
            .map(|&v| self.si("search.map_speed_rpm", v))
            .collect::<Result<_, _>>()?;
        let least = request.budget_least();
        if search.runs_max < least {
            let allowed = format!(
                "{least} or more with search.initial_states = {}, operating points: {}, maps at further \
                 speeds: {}",
                request.starts,
                request.points.len(),
                request.map_speeds_rad_s.len()
            );
            return Err(self.refuse("search.runs_max", &search.runs_max.to_string(), &allowed));
        }
        request.budget = search.runs_max;
        Ok(request)
    }

    /// A range in SI units whose ends both must be `possible` in the unit of the file.
    fn range(
        &self,
        name: &str,
        given: Option<RangeDocument>,
        allowed: &str,
        possible: impl Fn(f64) -> bool,
    ) -> Result<Option<[f64; 2]>, CaseError> {
        let Some(RangeDocument { low, high }) = given else {
            return Ok(None);
        };
        let path = format!("search.{name}");
        for value in [low, high] {
            if !value.is_finite() || !possible(value) {
                let allowed = format!("{allowed}, one number or [lowest, highest]");
                return Err(self.refuse(&path, &value.to_string(), &allowed));
            }
        }
        Ok(Some([self.si(&path, low)?, self.si(&path, high)?]))
    }

    fn whole(&self, name: &str, value: u64) -> Result<(), CaseError> {
        let unit = keys::unit("search", name);
        if unit.has(value) {
            return Ok(());
        }
        let allowed = unit.whole_numbers();
        Err(self.refuse(&format!("search.{name}"), &value.to_string(), &allowed))
    }
}

/// The ends of both ranges: slip is worst at the highest speed under the least load, stress
/// under the highest load at either speed.
fn corners(speeds: [f64; 2], loads: [f64; 2]) -> Vec<OperatingPoint> {
    let ends = |[low, high]: [f64; 2]| {
        if low == high {
            vec![low]
        } else {
            vec![low, high]
        }
    };
    ends(speeds)
        .into_iter()
        .flat_map(|inner_speed_rad_s| {
            ends(loads)
                .into_iter()
                .map(move |radial_load_n| OperatingPoint {
                    inner_speed_rad_s,
                    radial_load_n,
                })
        })
        .collect()
}
