//! Lag of a structure under the largest axial load of a search.

use super::raceway_layout::OperatingPoint;
use crate::critical_gap::CriticalGapError;
use crate::{AxialPoint, axial_lag};
use cageless::Bearing;
use cageless::closed_forms::{kinematic_lag_rad, seats};
use cageless::equilibrium::EquilibriumError;
use cageless::integrator::IntegrationMethod;
use cageless::raceway::Raceway;
use cageless::simulation::Control;
use cageless::{Case, Motion};

/// Lag that the largest axial load leaves at an operating point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AxialSeparation {
    /// Share of the lag without axial load, by rolling at the contact angle of the load.
    pub rolling_fraction: f64,
    /// Lag of the balls in space without and under the axial load, rad; `None` of structures that do not
    /// come to be simulated under it.
    pub lags_rad: Option<[f64; 2]>,
}

impl AxialSeparation {
    /// By rolling, at each operating point; empty without an axial load.
    pub(super) fn by_rolling(
        bearing: &Bearing,
        raceway: &Raceway,
        seats: &[[f64; 2]],
    ) -> Vec<Self> {
        let at = |&[angle_rad, pressed_in_m]: &[f64; 2]| {
            let lag = |angle| kinematic_lag_rad(bearing, raceway, angle, pressed_in_m);
            Self {
                rolling_fraction: lag(angle_rad) / lag(0.0),
                lags_rad: None,
            }
        };
        seats.iter().map(at).collect()
    }

    /// Share of the lag in space without axial load.
    pub fn fraction(&self) -> Option<f64> {
        self.lags_rad.map(|[without, under]| under / without)
    }
}

/// Contact angle and deflection of the most loaded ball on a plain outer ring under an axial load, in static
/// equilibrium in space.
pub(super) fn seat(
    case: &Case,
    point: &OperatingPoint,
    axial_load_n: f64,
) -> Result<[f64; 2], EquilibriumError> {
    let plain = in_space(case, point, vec![], axial_load_n);
    let [angle_rad, pressed_in_m] = seats(&plain, &mut || Control::Continue(()))?[0];
    Ok([angle_rad.abs(), pressed_in_m])
}

/// Lag of evenly spaced balls in space under an axial load, rad; `None` if `control` ended the run.
pub(super) fn lag(
    case: &Case,
    point: &OperatingPoint,
    raceways: &[Raceway],
    axial_load_n: f64,
    control: &mut dyn FnMut(f64) -> Control,
) -> Option<Result<f64, String>> {
    let case = in_space(case, point, raceways.to_vec(), axial_load_n);
    let without = |error: String| format!("under an axial load of {axial_load_n} N: {error}");
    Some(
        match axial_lag(&case, AxialPoint::untilted(axial_load_n), control) {
            Ok(at) => at
                .lag
                .map(|found| found.lag_rad)
                .map_err(|reason| without(reason.to_string())),
            Err(CriticalGapError::Interrupted) => return None,
            Err(error) => Err(without(error.to_string())),
        },
    )
}

pub(super) fn in_space(
    case: &Case,
    point: &OperatingPoint,
    raceways: Vec<Raceway>,
    axial_load_n: f64,
) -> Case {
    let mut case = point.case(case, raceways);
    case.motion = Motion::Space;
    case.operation.space.axial_load_n = axial_load_n;
    case.set_method(IntegrationMethod::VelocityVerlet);
    case
}
