//! Bearing of a case.

use cageless::error::Allowed;
use cageless::{Bearing, BearingDimensions, InnerRingBore, InputError, Materials};

use crate::case_file::converter::Converter;
use crate::case_file::error::CaseError;
use crate::case_file::sections::bearing::{ALTERNATIVES, CONFORMITY};
use crate::case_file::spanned_toml::join;
use crate::case_file::unit::Unit::{Micrometre, Millimetre};
use crate::case_file::unit::{Side, decimal, round};

/// Damping of the inner ring's translation that the paper's bearing needs to settle, N s/m.
const INNER_RING_DAMPING_N_S_M: f64 = 2000.0;

/// Outer radius of the outer ring at most, and half its width, over the radius of its groove.
const OUTER_RADII_MAX: f64 = 10.0;

impl Converter<'_> {
    pub(in crate::case_file) fn bearing(&self) -> Result<Bearing, CaseError> {
        let dimensions = self.dimensions()?;
        let materials = Materials {
            ball: self.material_of("ball_material", self.document.ball_material.as_ref())?,
            ring: self.material_of("ring_material", self.document.ring_material.as_ref())?,
        };
        let interference_max_m = dimensions.interference_max_m(&materials);
        let bearing = Bearing::new(dimensions, materials)
            .map_err(|e| self.refused_interference(&e, interference_max_m))?;
        let bearing = match self.document.bearing.assembly {
            Some(assembly) => bearing.with_assembly(assembly),
            None => bearing,
        };
        self.scattered(self.bored(bearing)?)
    }

    /// Damping of the inner ring's translation, N s/m: as given, or what is usual.
    fn inner_ring_damping_n_s_m(&self) -> f64 {
        let usual = if self.document.rotor.is_some() {
            0.0
        } else {
            INNER_RING_DAMPING_N_S_M
        };
        self.document
            .bearing
            .inner_ring_damping_n_s_m
            .unwrap_or(usual)
    }

    /// Gives the inner ring its bore, if it is to catch a rotor.
    fn bored(&self, bearing: Bearing) -> Result<Bearing, CaseError> {
        let b = &self.document.bearing;
        let (inertia, radius) = (
            b.inner_ring_polar_inertia_kg_m2,
            b.inner_ring_bore_radius_mm,
        );
        if inertia.is_none() && radius.is_none() {
            return Ok(bearing);
        }
        let need = |name: &str, value: Option<f64>| match value {
            Some(value) => self.si(&join("bearing", name), value),
            None => Err(self.missing("bearing", name)),
        };
        let bore = InnerRingBore {
            polar_inertia_kg_m2: need("inner_ring_polar_inertia_kg_m2", inertia)?,
            radius_m: need("inner_ring_bore_radius_mm", radius)?,
        };
        bearing
            .with_inner_ring_bore(bore)
            .map_err(|e| self.refused(&e, None))
    }

    /// The dimensions, from the radii or from what stands in their place.
    fn dimensions(&self) -> Result<BearingDimensions, CaseError> {
        let b = &self.document.bearing;
        self.check_alternatives()?;
        let si = |name: &str, value: Option<f64>| {
            value
                .map(|v| self.si(&join("bearing", name), v))
                .transpose()
        };
        let need = |name: &str, value: Option<f64>| match si(name, value)? {
            Some(value) => Ok(value),
            None => Err(self.missing("bearing", name)),
        };
        let ball_radius_m = match si("ball_diameter_mm", b.ball_diameter_mm)? {
            Some(diameter) => diameter / 2.0,
            None => need("ball_radius_mm", b.ball_radius_mm)?,
        };
        let (inner, outer) =
            if b.pitch_diameter_mm.is_some() || b.radial_internal_clearance_um.is_some() {
                let pitch = need("pitch_diameter_mm", b.pitch_diameter_mm)?;
                let clearance = need(
                    "radial_internal_clearance_um",
                    b.radial_internal_clearance_um,
                )?;
                // Ri + Ro = Dpw and 2 (Ro - Ri - 2 Rw) = Gr.
                let half = ball_radius_m + clearance / 4.0;
                (pitch / 2.0 - half, pitch / 2.0 + half)
            } else {
                (
                    need(
                        "inner_groove_bottom_radius_mm",
                        b.inner_groove_bottom_radius_mm,
                    )?,
                    need(
                        "outer_groove_bottom_radius_mm",
                        b.outer_groove_bottom_radius_mm,
                    )?,
                )
            };
        let groove = |name, radius, conformity_name, conformity| {
            let given = si(conformity_name, conformity)?.unwrap_or(CONFORMITY);
            let by_conformity = given * (2.0 * ball_radius_m);
            if !Millimetre.of_si(by_conformity).is_finite() {
                let path = join("bearing", conformity_name);
                return Err(self.refuse(&path, &given.to_string(), "at most 1"));
            }
            Ok(si(name, radius)?.unwrap_or(by_conformity))
        };
        let mut dimensions = BearingDimensions {
            balls: b.balls,
            ball_radius_m,
            inner_groove_bottom_radius_m: inner,
            outer_groove_bottom_radius_m: outer,
            outer_shoulder_radius_m: 0.0,
            inner_groove_curvature_radius_m: groove(
                "inner_groove_curvature_radius_mm",
                b.inner_groove_curvature_radius_mm,
                "inner_conformity",
                b.inner_conformity,
            )?,
            outer_groove_curvature_radius_m: groove(
                "outer_groove_curvature_radius_mm",
                b.outer_groove_curvature_radius_mm,
                "outer_conformity",
                b.outer_conformity,
            )?,
            inner_ring_mass_kg: 0.0,
            inner_ring_damping_n_s_m: need(
                "inner_ring_damping_n_s_m",
                Some(self.inner_ring_damping_n_s_m()),
            )?,
        };
        let assumptions = b.assumptions(&dimensions);
        let assumed = |name: &str| {
            let key = join("bearing", name);
            let found = assumptions.iter().find(|a| a.key == key);
            found.map(|a| a.value)
        };
        let name = "outer_shoulder_radius_mm";
        dimensions.outer_shoulder_radius_m =
            need(name, b.outer_shoulder_radius_mm.or(assumed(name)))?;
        let name = "inner_ring_mass_kg";
        dimensions.inner_ring_mass_kg = need(name, b.inner_ring_mass_kg.or(assumed(name)))?;
        Ok(dimensions)
    }

    /// Error of the bearing; where its clearance is too far below zero, in terms of that key.
    fn refused_interference(&self, error: &InputError, most_m: f64) -> CaseError {
        let least_m = -2.0 * most_m;
        match (
            self.document.bearing.radial_internal_clearance_um,
            &error.allowed,
        ) {
            (Some(clearance), Allowed::AtMost(_, why))
                if error.field == "ball_radius_m" && Micrometre.to_si(clearance) < least_m =>
            {
                let key = "bearing.radial_internal_clearance_um";
                let allowed = format!("at least {} ({why})", Micrometre.show(least_m, Side::Lower));
                self.refuse(key, &clearance.to_string(), &allowed)
            }
            _ => self.refused(error, None),
        }
    }

    /// Refuses two keys that say the same.
    fn check_alternatives(&self) -> Result<(), CaseError> {
        let given = |name: &&&str| self.document.value(&join("bearing", name)).is_some();
        for (one, other) in ALTERNATIVES {
            if let (Some(one), Some(other)) = (one.iter().find(given), other.iter().find(given)) {
                let path = join("bearing", other);
                let value = self.places.written(&path).unwrap_or_default();
                let message = format!(
                    "{path} = {value} is not possible with bearing.{one}: both say the same, \
                     give one of them"
                );
                return Err(self.places.error(&path, message));
            }
        }
        Ok(())
    }

    /// The key that a value follows from and how, if `path` is not given itself.
    pub(in crate::case_file) fn origin_of(
        &self,
        path: &str,
    ) -> Option<(&'static str, &'static str)> {
        let b = &self.document.bearing;
        if self.document.value(path).is_some() {
            return None;
        }
        match path {
            "bearing.ball_radius_mm" => {
                Some(("bearing.ball_diameter_mm", "half of ball_diameter_mm"))
            }
            "bearing.inner_groove_bottom_radius_mm" | "bearing.outer_groove_bottom_radius_mm" => {
                b.pitch_diameter_mm?;
                let how = "from pitch_diameter_mm, ball diameter and clearance";
                Some(("bearing.pitch_diameter_mm", how))
            }
            "bearing.inner_groove_curvature_radius_mm" => Some((
                "bearing.inner_conformity",
                "inner_conformity times the ball diameter",
            )),
            "bearing.outer_groove_curvature_radius_mm" => Some((
                "bearing.outer_conformity",
                "outer_conformity times the ball diameter",
            )),
            "bearing.outer_shoulder_radius_mm" => Some((
                "bearing.outer_shoulder_radius_mm",
                "estimated, as the key is left out",
            )),
            "bearing.inner_ring_mass_kg" => Some((
                "bearing.inner_ring_mass_kg",
                "estimated, as the key is left out",
            )),
            _ => None,
        }
    }

    /// Keys that only `export` needs and any file may contain.
    pub(in crate::case_file) fn check_export_dimensions(
        &self,
        bearing: &Bearing,
    ) -> Result<(), CaseError> {
        let b = &self.document.bearing;
        let groove = Millimetre.of_si(bearing.dimensions().outer_groove_bottom_radius_m);
        if let Some(radius) = b.outer_ring_outer_radius_mm {
            self.si("bearing.outer_ring_outer_radius_mm", radius)?;
            let least = groove;
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
            let widest = 2.0 * OUTER_RADII_MAX * groove;
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
