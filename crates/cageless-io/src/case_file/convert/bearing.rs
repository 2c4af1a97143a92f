//! Bearing of a case.

use cageless::Allowed;
use cageless::{
    Bearing, BearingDimensions, Fit, InnerRingBore, InputError, Materials, OperatingClearance,
};
use cageless::{CONFORMITY, INNER_RING_DAMPING_N_S_M};

use crate::case_file::converter::{Converter, refused_in};
use crate::case_file::error::CaseError;
use crate::case_file::sections::alternatives_in;
use crate::case_file::sections::bearing::assumptions;
use crate::case_file::spanned_toml::join;
use crate::case_file::unit::Side;
use crate::case_file::unit::Unit::{Micrometre, Millimetre};

/// Outer radius of the outer ring at most, and half its width, over the radius of its groove.
const OUTER_RADII_MAX: f64 = 10.0;

/// Difference of two diameters that are one, as a fraction.
const SAME: f64 = 1e-6;

/// Radii of the bottoms of both grooves.
struct GrooveBottoms {
    inner_m: f64,
    outer_m: f64,
}

impl Converter<'_> {
    /// The bearing, with the clearance in operation, and what fits and temperatures made of it.
    pub(in crate::case_file) fn bearing(
        &self,
    ) -> Result<(Bearing, Option<OperatingClearance>), CaseError> {
        let b = &self.sections.bearing;
        let materials = Materials {
            ball: self.material_of("ball_material", self.sections.ball_material.as_ref())?,
            ring: self.material_of("ring_material", self.sections.ring_material.as_ref())?,
        };
        let (dimensions, fit) = self.dimensions(&materials)?;
        let interference_max_m = dimensions.interference_max_m(&materials);
        let mut bearing = Bearing::new(dimensions, materials)
            .map_err(|e| self.refused_interference(&e, interference_max_m, fit))?;
        let refused = |e| self.refused(&e, None);
        if let Some(angle) = b.contact_angle_rad {
            let enlargement_m = fit.map_or(0.0, |fit| fit.change_m());
            let angular = bearing.with_contact_angle(angle, enlargement_m);
            bearing = angular.map_err(refused)?;
        }
        if let Some(assembly) = b.assembly {
            bearing = bearing.with_assembly(assembly);
        }
        let fits = self.sections.fit.as_ref();
        let half = |diameter: Option<f64>| diameter.map(|diameter| diameter / 2.0);
        let bore_m = half(fits.and_then(|fit| fit.bore_diameter_m));
        let bore_m = b.inner_ring_bore_radius_m.or(bore_m);
        let outside_m = half(fits.and_then(|fit| fit.outside_diameter_m));
        let outside_m = b.outer_ring_outer_radius_m.or(outside_m);
        bearing = bearing
            .with_boundary_radii(bore_m, outside_m)
            .map_err(refused)?;
        // The bore that is to catch a rotor.
        let (inertia, radius) = (b.inner_ring_polar_inertia_kg_m2, bore_m);
        if inertia.is_some() || radius.is_some() && self.sections.rotor.is_some() {
            let bore = InnerRingBore {
                polar_inertia_kg_m2: self.need("inner_ring_polar_inertia_kg_m2", inertia)?,
                radius_m: self.need("inner_ring_bore_radius_mm", radius)?,
            };
            bearing = bearing.with_inner_ring_bore(bore).map_err(refused)?;
        }
        let Some(deviations_m) = &b.ball_radius_deviation_m else {
            return Ok((bearing, fit));
        };
        if deviations_m.len() != b.balls {
            let allowed = format!("a list of {} numbers in µm, one per ball", b.balls);
            return Err(self.refuse("bearing.ball_radius_deviation_um", &allowed));
        }
        bearing
            .with_ball_radius_deviations(deviations_m.clone())
            .map(|bearing| (bearing, fit))
            .map_err(refused)
    }

    fn need(&self, name: &str, value: Option<f64>) -> Result<f64, CaseError> {
        value.ok_or_else(|| self.missing("bearing", name))
    }

    /// The dimensions in operation, from the radii or from what stands in their place.
    fn dimensions(
        &self,
        materials: &Materials,
    ) -> Result<(BearingDimensions, Option<OperatingClearance>), CaseError> {
        let b = &self.sections.bearing;
        self.check_alternatives("bearing")?;
        let ball_radius_m = match b.ball_diameter_m {
            Some(diameter) => diameter / 2.0,
            None => self.need("ball_radius_mm", b.ball_radius_m)?,
        };
        let bottoms = self.groove_bottoms(ball_radius_m)?;
        let groove = |radius_m: Option<f64>, key: &str, conformity: Option<f64>| {
            let by_conformity_m = self.by_conformity_m(key, conformity, ball_radius_m)?;
            Ok::<_, CaseError>(radius_m.unwrap_or(by_conformity_m))
        };
        let under_rotor = self.sections.rotor.is_some();
        let usual_damping = if under_rotor {
            0.0
        } else {
            INNER_RING_DAMPING_N_S_M
        };
        let mut dimensions = BearingDimensions {
            balls: b.balls,
            ball_radius_m,
            inner_groove_bottom_radius_m: bottoms.inner_m,
            outer_groove_bottom_radius_m: bottoms.outer_m,
            outer_shoulder_radius_m: 0.0,
            inner_shoulder_radius_m: b.inner_shoulder_radius_m,
            inner_groove_curvature_radius_m: groove(
                b.inner_groove_curvature_radius_m,
                "bearing.inner_conformity",
                b.inner_conformity,
            )?,
            outer_groove_curvature_radius_m: groove(
                b.outer_groove_curvature_radius_m,
                "bearing.outer_conformity",
                b.outer_conformity,
            )?,
            inner_ring_mass_kg: 0.0,
            inner_ring_damping_n_s_m: b.inner_ring_damping_n_s_m.unwrap_or(usual_damping),
        };
        let fit = self.mounted()?;
        if let (Some(_), Some(angle)) = (&fit, b.contact_angle_rad) {
            dimensions.open_to(angle, 0.0);
        }
        // The inner ring of a drop is at rest when the rotor meets it.
        let speed_rad_s = match fit.is_some() && !under_rotor {
            true => self.operation()?.largest_inner_speed_rad_s(),
            false => 0.0,
        };
        let fit = fit
            .map(|fit| fit.operating_clearance(&dimensions, materials, speed_rad_s))
            .transpose()
            .map_err(|e| self.refused_fit(&e))?;
        if let Some(fit) = &fit {
            dimensions.inner_groove_bottom_radius_m -= 0.5 * fit.change_m();
        }
        self.complete(&mut dimensions)?;
        Ok((dimensions, fit))
    }

    /// The radius of curvature of a groove by its conformity, or the usual one.
    fn by_conformity_m(
        &self,
        key: &str,
        conformity: Option<f64>,
        ball_radius_m: f64,
    ) -> Result<f64, CaseError> {
        let radius_m = conformity.unwrap_or(CONFORMITY) * (2.0 * ball_radius_m);
        match Millimetre.of_si(radius_m).is_finite() {
            true => Ok(radius_m),
            false => Err(self.refuse(key, "at most 1")),
        }
    }

    /// The radii of the groove bottoms, given or by pitch diameter and clearance.
    fn groove_bottoms(&self, ball_radius_m: f64) -> Result<GrooveBottoms, CaseError> {
        let b = &self.sections.bearing;
        if b.pitch_diameter_m.is_some() || b.radial_internal_clearance_m.is_some() {
            let pitch = self.need("pitch_diameter_mm", b.pitch_diameter_m)?;
            let clearance = b.radial_internal_clearance_m;
            let clearance = self.need("radial_internal_clearance_um", clearance)?;
            // Ri + Ro = Dpw and 2 (Ro - Ri - 2 Rw) = Gr.
            let half = ball_radius_m + clearance / 4.0;
            return Ok(GrooveBottoms {
                inner_m: pitch / 2.0 - half,
                outer_m: pitch / 2.0 + half,
            });
        }
        let inner = b.inner_groove_bottom_radius_m;
        let outer = b.outer_groove_bottom_radius_m;
        Ok(GrooveBottoms {
            inner_m: self.need("inner_groove_bottom_radius_mm", inner)?,
            outer_m: self.need("outer_groove_bottom_radius_mm", outer)?,
        })
    }

    /// Sets the radius of the outer shoulder and the mass of the inner ring, given or assumed from the rest.
    fn complete(&self, dimensions: &mut BearingDimensions) -> Result<(), CaseError> {
        let b = &self.sections.bearing;
        let assumptions = assumptions(&self.document.tree, dimensions);
        let assumed = |name: &str| {
            let key = join("bearing", name);
            let found = assumptions.iter().find(|a| a.key == key);
            found.map(|a| a.value)
        };
        let shoulder = "outer_shoulder_radius_mm";
        dimensions.outer_shoulder_radius_m = match b.outer_shoulder_radius_m {
            Some(radius_m) => radius_m,
            None => Millimetre.to_si(self.need(shoulder, assumed(shoulder))?),
        };
        let mass = "inner_ring_mass_kg";
        dimensions.inner_ring_mass_kg =
            self.need(mass, b.inner_ring_mass_kg.or_else(|| assumed(mass)))?;
        Ok(())
    }

    /// The fit, with the diameters that the bearing has.
    fn mounted(&self) -> Result<Option<Fit>, CaseError> {
        let Some(mut fit) = self.fit() else {
            return Ok(None);
        };
        self.check_alternatives("fit")?;
        let b = &self.sections.bearing;
        for (diameter_m, name, radius_m, own) in [
            (
                &mut fit.bore_diameter_m,
                "bore_diameter_mm",
                b.inner_ring_bore_radius_m,
                "inner_ring_bore_radius_mm",
            ),
            (
                &mut fit.outside_diameter_m,
                "outside_diameter_mm",
                b.outer_ring_outer_radius_m,
                "outer_ring_outer_radius_mm",
            ),
        ] {
            let Some(of_bearing_m) = radius_m.map(|radius| 2.0 * radius) else {
                continue;
            };
            let given_m = *diameter_m.get_or_insert(of_bearing_m);
            if (given_m - of_bearing_m).abs() > SAME * of_bearing_m {
                let twice = Millimetre.show(of_bearing_m, Side::Lower);
                let allowed = format!("{twice}, twice bearing.{own}, or left out");
                return Err(self.refuse(&join("fit", name), &allowed));
            }
        }
        Ok(Some(fit))
    }

    /// Error of the bearing; where its clearance is too far below zero, in terms of that key.
    fn refused_interference(
        &self,
        error: &InputError,
        most_m: f64,
        fit: Option<OperatingClearance>,
    ) -> CaseError {
        let least_m = -2.0 * most_m;
        if let Some(fit) = fit.filter(|fit| fit.initial_m >= least_m && fit.operating_m() < least_m)
        {
            let [operating, least] = [fit.operating_m(), least_m].map(|m| Micrometre.of_si(m));
            let message = format!(
                "[fit] leaves a radial internal clearance of {operating:.2} µm in operation: it must \
                 be at least {least:.2} µm, beyond which the contacts are no longer elastic"
            );
            return self.document.tree.error("fit", message);
        }
        match (
            self.sections.bearing.radial_internal_clearance_m,
            &error.allowed,
        ) {
            (Some(clearance_m), Allowed::AtMost(_, why))
                if error.field == "ball_radius_m" && clearance_m < least_m =>
            {
                let key = "bearing.radial_internal_clearance_um";
                let allowed = format!("at least {} ({why})", Micrometre.show(least_m, Side::Lower));
                self.refuse(key, &allowed)
            }
            _ => self.refused(error, None),
        }
    }

    /// Error of fits and temperatures; of all together where none alone is at fault.
    fn refused_fit(&self, error: &InputError) -> CaseError {
        if error.field != "fit" {
            return refused_in(self.document, Some("fit"), error, None);
        }
        let change = Micrometre.of_si(error.value);
        let message = format!(
            "[fit] enlarges the clearance by {change:.0} µm: it must be {}",
            error.allowed
        );
        self.document.tree.error("fit", message)
    }

    /// Refuses two keys that say the same.
    fn check_alternatives(&self, section: &str) -> Result<(), CaseError> {
        let given = |name: &&&str| self.document.has(&join(section, name));
        for (one, other) in alternatives_in(section) {
            if let (Some(one), Some(other)) = (one.iter().find(given), other.iter().find(given)) {
                let path = join(section, other);
                let tree = &self.document.tree;
                let value = tree.given(&path).map_or("", |node| &node.place.written);
                let message = format!(
                    "{path} = {value} is not possible with {section}.{one}: both say the same, \
                     give one of them"
                );
                return Err(tree.error(&path, message));
            }
        }
        Ok(())
    }

    /// Keys that only `export` needs and any file may contain.
    pub(in crate::case_file) fn check_export_dimensions(
        &self,
        bearing: &Bearing,
    ) -> Result<(), CaseError> {
        let b = &self.sections.bearing;
        let groove_m = bearing.dimensions().outer_groove_bottom_radius_m;
        let most_m = OUTER_RADII_MAX * groove_m;
        let above = Allowed::Above(groove_m, "the bottom of the groove");
        let radius = Allowed::AtMost(most_m, "ten times the bottom of the groove");
        let width = Allowed::AtMost(2.0 * most_m, "ten times the diameter of the groove");
        let (field, value, allowed) = match (b.outer_ring_outer_radius_m, b.outer_ring_width_m) {
            (Some(m), _) if m <= groove_m => ("outer_ring_outer_radius_m", m, above),
            (Some(m), _) if m > most_m => ("outer_ring_outer_radius_m", m, radius),
            (_, Some(m)) if m > 2.0 * most_m => ("outer_ring_width_m", m, width),
            _ => return Ok(()),
        };
        let error = InputError {
            field,
            value,
            allowed,
        };
        Err(self.refused(&error, None))
    }
}
