//! `[bearing]`.

use cageless::Bearing;
use cageless::bearing::BALLS_MIN;

use crate::case_file::CaseError;
use crate::case_file::convert::Converter;
use crate::case_file::declaration::Line::{Absent, Shown};
use crate::case_file::declaration::Presence::{Optional, Required};
use crate::case_file::declaration::section;
use crate::case_file::unit::Unit::{Micrometre, Millimetre, Si, Whole};
use crate::case_file::unit::{Side, decimal, round};

/// Outer radius of the outer ring at most, and half its width, over the radius of its groove.
const OUTER_RADII_MAX: f64 = 10.0;

section! {
    /// `[bearing]`: dimensions and masses of rings and balls.
    BearingDocument => BearingDimensions {
        balls => balls: usize = Required, Whole(BALLS_MIN as u64, None),
            "N, number of balls", Shown("14", "number of balls, 3 or more (paper)");
        ball_radius_mm => ball_radius_m: f64 = Required, Millimetre,
            "Rw, radius of a ball", Shown("4.7625", "Rw (paper)");
        inner_groove_bottom_radius_mm => inner_groove_bottom_radius_m: f64 = Required, Millimetre,
            "Ri, radius of the inner ring at the bottom of its groove",
            Shown("18.24", "Ri, where the balls run on the inner ring (paper)");
        outer_groove_bottom_radius_mm => outer_groove_bottom_radius_m: f64 = Required, Millimetre,
            "Ro, radius of the outer ring at the bottom of its groove",
            Shown("27.765", "Ro, where the balls run on the outer ring (paper);\n\
                Ro - Ri - 2 Rw >= 0 is half the radial internal\n\
                clearance Gr of ISO 5753-1");
        outer_shoulder_radius_mm => outer_shoulder_radius_m: f64 = Required, Millimetre,
            "Ros, shoulder bore radius of the outer ring",
            Shown("26.0", "Ros, shoulder bore radius of the outer ring (paper)");
        inner_groove_curvature_radius_mm => inner_groove_curvature_radius_m: f64 = Required, Millimetre,
            "radius of the inner groove in the meridian plane",
            Shown("4.953", "groove radius in the axial section, usually 1.02 to 1.08 Rw");
        outer_groove_curvature_radius_mm => outer_groove_curvature_radius_m: f64 = Required, Millimetre,
            "Re, radius of the outer groove in the meridian plane",
            Shown("4.953", "Re, the same for the outer ring");
        inner_ring_mass_kg => inner_ring_mass_kg: f64 = Required, Si("kg"),
            "mass of the inner ring and attached rotating parts",
            Shown("0.2", "inner ring and attached rotating parts");
        inner_ring_drag_n_s_m => inner_ring_drag_n_s_m: f64 = Required, Si("N s/m"),
            "C of Zhao 2022, Eq. (14), viscous damping of inner-ring translation",
            Shown("2000.0", "viscous damping of inner-ring translation (not drag\n\
                torque), usually 0 to 1e4");
        ball_radius_deviation_um -> ball_radius_deviation_m: Option<Vec<f64>> = Optional, Micrometre,
            "deviation of each ball's radius", Absent;
        outer_ring_outer_radius_mm: Option<f64> = Optional, Millimetre,
            "outer radius of the outer ring",
            Shown("31.0", "outer ring, only for the export to CAD");
        outer_ring_width_mm: Option<f64> = Optional, Millimetre,
            "width of the outer ring", Shown("16.0", "width, only for the export to CAD");
    }
}

impl Converter<'_> {
    pub(in crate::case_file) fn bearing(&self) -> Result<Bearing, CaseError> {
        let dimensions = self.document.bearing.to_si(self, "bearing")?;
        let material = self.document.material.to_si(self, "material")?;
        let bearing = Bearing::new(dimensions, material).map_err(|e| self.refused(&e, None))?;
        self.scattered(bearing)
    }

    /// Keys that only `export` needs and any file may contain.
    pub(in crate::case_file) fn check_export_dimensions(&self) -> Result<(), CaseError> {
        let b = &self.document.bearing;
        if let Some(radius) = b.outer_ring_outer_radius_mm {
            self.si("bearing.outer_ring_outer_radius_mm", radius)?;
            let least = b.outer_groove_bottom_radius_mm;
            let most = decimal(round(OUTER_RADII_MAX * least, Side::Upper));
            if radius <= least {
                return Err(self.refuse(
                    "bearing.outer_ring_outer_radius_mm",
                    &radius.to_string(),
                    &format!("more than {least} mm (the bottom of the groove)"),
                ));
            }
            if radius > OUTER_RADII_MAX * least {
                return Err(self.refuse(
                    "bearing.outer_ring_outer_radius_mm",
                    &radius.to_string(),
                    &format!("at most {most} mm (ten times the bottom of the groove)"),
                ));
            }
        }
        if let Some(width) = b.outer_ring_width_mm {
            self.si("bearing.outer_ring_width_mm", width)?;
            if width <= 0.0 {
                let key = "bearing.outer_ring_width_mm";
                return Err(self.refuse(key, &width.to_string(), "more than 0 mm"));
            }
            let widest = 2.0 * OUTER_RADII_MAX * b.outer_groove_bottom_radius_mm;
            if width > widest {
                let key = "bearing.outer_ring_width_mm";
                let most = decimal(round(widest, Side::Upper));
                let allowed = format!("at most {most} mm (ten times the diameter of the groove)");
                return Err(self.refuse(key, &width.to_string(), &allowed));
            }
        }
        Ok(())
    }

    /// Gives the balls their own radii.
    fn scattered(&self, bearing: Bearing) -> Result<Bearing, CaseError> {
        let b = &self.document.bearing;
        let Some(deviations) = &b.ball_radius_deviation_um else {
            return Ok(bearing);
        };
        let key = "bearing.ball_radius_deviation_um";
        if deviations.len() != b.balls {
            let allowed = format!("a list of {} numbers in um, one per ball", b.balls);
            return Err(self.refuse(key, &format!("a list of {}", deviations.len()), &allowed));
        }
        let deviations_m = deviations
            .iter()
            .map(|d| self.si(key, *d))
            .collect::<Result<_, _>>()?;
        bearing
            .with_ball_radius_deviations(deviations_m)
            .map_err(|e| self.refused(&e, None))
    }
}
