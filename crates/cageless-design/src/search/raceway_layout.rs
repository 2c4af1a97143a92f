//! Raceway layouts and their closed forms, which need no simulation.

use cageless::Bearing;
use cageless::Case;
use cageless::InputError;
use cageless::closed_forms::{
    Eq11, gap_of_delay_rad, kinematic_gap_rad, kinematic_lag_rad, seats, steady_gap_rad,
    theoretical_gap_rad,
};
use cageless::equilibrium::EquilibriumError;
use cageless::integrator::IntegrationMethod;
use cageless::raceway::{Raceway, RacewayDimensions, RacewayForm};
use cageless::simulation::Control;

/// Equal discrete raceways of a form at given places.
#[derive(Debug, Clone, PartialEq)]
pub struct RacewayLayout {
    /// lC.
    pub axial_span_m: f64,
    /// θ.
    pub half_angle_rad: f64,
    /// Shape and blend.
    pub form: RacewayForm,
    /// αg by which the section is turned.
    pub section_angle_rad: f64,
    /// ψ of the middle of each raceway.
    pub centres_rad: Vec<f64>,
}

/// Largest differences of span and half angle of neighbours, relative.
const NEIGHBOURS: [f64; 2] = [0.02, 0.1];

impl RacewayLayout {
    /// Whether it is so close to another that what more starts say of that is likely to hold for it, too.
    pub(crate) fn is_near(&self, other: &Self) -> bool {
        let differences = [
            self.axial_span_m / other.axial_span_m - 1.0,
            self.half_angle_rad / other.half_angle_rad - 1.0,
        ];
        let mut pairs = differences.iter().zip(NEIGHBOURS);
        let alike = Self {
            axial_span_m: other.axial_span_m,
            half_angle_rad: other.half_angle_rad,
            ..self.clone()
        };
        alike == *other && pairs.all(|(difference, most)| difference.abs() <= most)
    }

    /// The raceways in a bearing.
    ///
    /// # Errors
    /// The [`InputError`] of [`Raceway::formed`] or of [`Raceway::with_section_angle`], or that two of them
    /// overlap.
    pub(crate) fn raceways(&self, bearing: &Bearing) -> Result<Vec<Raceway>, InputError> {
        let raceways = self
            .centres_rad
            .iter()
            .map(|&centre_angle_rad| {
                let dimensions = RacewayDimensions {
                    axial_span_m: self.axial_span_m,
                    half_angle_rad: self.half_angle_rad,
                    centre_angle_rad,
                };
                Raceway::formed(dimensions, self.form, bearing)?
                    .with_section_angle(self.section_angle_rad, bearing)
            })
            .collect::<Result<Vec<_>, _>>()?;
        cageless::raceway::apart(&raceways)?;
        Ok(raceways)
    }

    /// The structure of a case whose raceways are equal; `None` without raceways, or if they
    /// differ.
    pub(crate) fn from_case(case: &Case) -> Option<Self> {
        let (first, form) = (case.raceways.first()?.dimensions(), case.raceway_form());
        let section_angle_rad = case.raceways.first()?.section_angle_rad();
        let equal = case.raceways.iter().all(|r| {
            r.dimensions().axial_span_m == first.axial_span_m
                && r.half_angle_rad() == first.half_angle_rad
                && r.form() == form
                && r.section_angle_rad() == section_angle_rad
        });
        equal.then(|| Self {
            axial_span_m: first.axial_span_m,
            half_angle_rad: first.half_angle_rad,
            form,
            section_angle_rad,
            centres_rad: case
                .raceways
                .iter()
                .map(|r| r.dimensions().centre_angle_rad)
                .collect(),
        })
    }
}

/// Speed and loads.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OperatingPoint {
    /// ωi.
    pub inner_speed_rad_s: f64,
    /// Fr.
    pub radial_load_n: f64,
    /// Fa.
    pub axial_load_n: f64,
}

impl OperatingPoint {
    /// Operating point of a case.
    pub fn from_case(case: &Case) -> Self {
        Self {
            inner_speed_rad_s: case.operation.inner_speed_rad_s,
            radial_load_n: case.operation.radial_load_n,
            axial_load_n: case.operation.space.axial_load_n,
        }
    }

    /// `case` with these raceways at this point, integrated by leapfrog at its automatic
    /// step: the fastest method whose statistics are unbiased.
    pub fn case(&self, case: &Case, raceways: Vec<Raceway>) -> Case {
        let mut case = case.with_raceways(raceways);
        case.operation.inner_speed_rad_s = self.inner_speed_rad_s;
        case.operation.radial_load_n = self.radial_load_n;
        case.operation.space.axial_load_n = self.axial_load_n;
        case.set_method(IntegrationMethod::VelocityVerlet);
        case
    }

    /// Contact angle, towards the contact sign of the row, and deflection of the most loaded ball of each row on a
    /// plain outer ring at this point, in space.
    ///
    /// # Errors
    /// Those of [`seats`].
    pub(crate) fn row_seats(&self, case: &Case) -> Result<Vec<[f64; 2]>, EquilibriumError> {
        let plain = self.case(case, vec![]);
        let signs = plain.all_rows().into_iter().map(|row| row.contact_sign);
        let seats = seats(&plain, &mut || Control::Continue(()))?
            .into_iter()
            .zip(signs);
        Ok(seats
            .map(|([angle_rad, pressed_in_m], sign)| [sign * angle_rad, pressed_in_m])
            .collect())
    }
}

/// Closed-form results of the geometry, on elastic flanks also of the load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ClosedForms {
    /// β0 of Zhao 2022, Eq. (11), as published; on elastic flanks `kinematic_gap_rad`.
    pub theoretical_gap_rad: f64,
    /// Gap outside the raceways in steady flow, [`steady_gap_rad`].
    pub steady_gap_rad: f64,
    /// Lag of a ball by the film per orbit, part of that gap; 0 without a film.
    pub film_lag_rad: f64,
}

impl ClosedForms {
    /// Closed forms of equal raceways.
    pub(crate) fn new(bearing: &Bearing, raceways: &[Raceway]) -> Self {
        Self {
            theoretical_gap_rad: raceways.first().map_or(0.0, |raceway| {
                theoretical_gap_rad(bearing, raceway, Eq11::Published)
            }),
            steady_gap_rad: steady_gap_rad(bearing, raceways),
            film_lag_rad: 0.0,
        }
    }

    /// Closed forms of equal raceways with elastic flanks, with the contact angles and deflections that
    /// [`OperatingPoint::row_seats`] has for rows and operating points: the least of them. A row without load
    /// spreads nothing.
    pub(crate) fn elastic(bearing: &Bearing, raceways: &[Raceway], row_seats: &[[f64; 2]]) -> Self {
        let least = |of: &dyn Fn(f64, f64) -> f64| {
            let values = row_seats
                .iter()
                .map(|&[angle_rad, pressed_in_m]| match angle_rad {
                    angle if angle.is_nan() => 0.0,
                    angle => of(angle, pressed_in_m),
                });
            values.fold(f64::INFINITY, f64::min)
        };
        let gap = |angle, pressed_in| {
            let gaps = raceways.iter();
            let gaps = gaps.map(|r| kinematic_gap_rad(bearing, r, angle, pressed_in));
            gaps.fold(0.0, f64::max)
        };
        let delay = |angle, pressed_in| {
            let lags = raceways.iter();
            let lags = lags.map(|r| kinematic_lag_rad(bearing, r, angle, pressed_in));
            lags.sum()
        };
        Self {
            theoretical_gap_rad: least(&gap),
            steady_gap_rad: gap_of_delay_rad(bearing, least(&delay)),
            film_lag_rad: 0.0,
        }
    }

    /// With balls that lag by this an orbit by a film beside what the raceways make them.
    pub(super) fn lagging(self, bearing: &Bearing, lag_rad: f64) -> Self {
        Self {
            steady_gap_rad: self.steady_gap_rad + lag_rad / bearing.balls() as f64,
            film_lag_rad: lag_rad,
            ..self
        }
    }

    /// β0 over the steady gap.
    pub(crate) fn fraction(&self) -> f64 {
        self.theoretical_gap_rad / self.steady_gap_rad
    }
}
