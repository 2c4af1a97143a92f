//! A rigid rotor in several bearings.

use super::normal::Lateral;
use super::{ClearancePlane, DMatrix, DVector, LinearRotor, RotorError, Unbalance};
use crate::limits::LIMITS;

/// A rigid rotor; axial places are measured from its mass centre.
#[derive(Debug, Clone, PartialEq)]
pub struct RigidRotor {
    /// m.
    pub mass_kg: f64,
    /// Ip, about the axis of rotation.
    pub polar_inertia_kg_m2: f64,
    /// It, about any axis across the axis of rotation through the mass centre.
    pub transverse_inertia_kg_m2: f64,
    /// Axial place of each touchdown bearing.
    pub bearing_axial_m: Vec<f64>,
    /// Unbalances.
    pub unbalances: Vec<Unbalance<f64>>,
    /// Clearances to the stator.
    pub clearances: Vec<ClearancePlane<f64>>,
}

impl RigidRotor {
    /// The rotor in normal coordinates.
    ///
    /// With the slopes (sx, sy) of the axis, the journal at axial place z is at (x + sx·z,
    /// y + sy·z). The spin has the angular momentum Ip·Ω·(sx, sy) across the axis, so that
    /// It·s̈x + Ip·(Ω·ṡy + Ω̇·sy) and It·s̈y − Ip·(Ω·ṡx + Ω̇·sx) are the moments that change sx and
    /// sy.
    ///
    /// # Errors
    /// A [`RotorError`] if a value is out of range or the bearings do not hold the rotor.
    pub fn linear(&self) -> Result<LinearRotor, RotorError> {
        self.check()?;
        let (m, it, ip) = (
            self.mass_kg,
            self.transverse_inertia_kg_m2,
            self.polar_inertia_kg_m2,
        );
        let place = |z: f64| DMatrix::from_row_slice(2, 4, &[1., 0., z, 0., 0., 1., 0., z]);
        let mut gyroscopic = DMatrix::zeros(4, 4);
        (gyroscopic[(2, 3)], gyroscopic[(3, 2)]) = (ip, -ip);
        let lateral = Lateral {
            mass: DMatrix::from_diagonal(&DVector::from_vec(vec![m, m, it, it])),
            damping: DMatrix::zeros(4, 4),
            stiffness: DMatrix::zeros(4, 4),
            spin_up: gyroscopic.clone(),
            gyroscopic,
            weight: DVector::from_vec(vec![0.0, m, 0.0, 0.0]),
            rotor_kg: m,
            journals: self.bearing_axial_m.iter().map(|z| place(*z)).collect(),
            shapes: None,
            unbalances: (self.unbalances.iter())
                .map(|u| u.at(place(u.place)))
                .collect(),
            planes: (self.clearances.iter())
                .map(|c| c.at(place(c.place)))
                .collect(),
            polar_inertia: ip,
        };
        lateral.normal()
    }

    fn check(&self) -> Result<(), RotorError> {
        for (name, limit, value) in [
            ("mass_kg", "rotor_mass_kg", self.mass_kg),
            (
                "polar_inertia_kg_m2",
                POLAR_INERTIA,
                self.polar_inertia_kg_m2,
            ),
            (
                "transverse_inertia_kg_m2",
                POLAR_INERTIA,
                self.transverse_inertia_kg_m2,
            ),
        ] {
            positive(name, value)?;
            within(name, limit, value)?;
        }
        // Ip = ∫(x² + y²)dm and 2·It = ∫(x² + y² + 2z²)dm: equal for a thin disc.
        let most = 2.0 * self.transverse_inertia_kg_m2;
        let ip = self.polar_inertia_kg_m2;
        let allowed =
            format!("at most {most}, twice transverse_inertia_kg_m2: no body exceeds a thin disc");
        let kept = ip <= most * (1.0 + ROUNDING);
        require("polar_inertia_kg_m2", ip, kept, allowed)?;
        let mut axial: Vec<f64> = self.bearing_axial_m.clone();
        axial.extend(self.unbalances.iter().map(|u| u.place));
        axial.extend(self.clearances.iter().map(|c| c.place));
        for place in axial.into_iter().filter(|z| z.is_finite()) {
            let allowed = format!("within {} mm of the mass centre", 1e3 * AXIAL_MAX_M);
            let kept = place.abs() <= AXIAL_MAX_M;
            require("axial_mm", 1e3 * place, kept, allowed)?;
        }
        let mut places = self.bearing_axial_m.clone();
        places.sort_by(f64::total_cmp);
        if places.is_empty() {
            return Err(RotorError::without_bearings());
        }
        for place in &places {
            finite("axial_m", *place)?;
        }
        if let Some(pair) = places.windows(2).find(|pair| pair[0] == pair[1]) {
            return Err(RotorError::Bearings(format!(
                "two bearings are at the same axial place, {} m: each needs its own",
                pair[0]
            )));
        }
        if places.len() > 2 {
            return Err(RotorError::Bearings(format!(
                "a rigid rotor in {} bearings: at most 2, or the load of each follows from its \
                 bending, which matrices describe",
                places.len()
            )));
        }
        for unbalance in &self.unbalances {
            for (name, value) in [
                ("axial_m", unbalance.place),
                ("moment_kg_m", unbalance.moment_kg_m),
                ("phase_rad", unbalance.phase_rad),
            ] {
                finite(name, value)?;
            }
        }
        for clearance in &self.clearances {
            finite("axial_m", clearance.place)?;
            positive("radial_m", clearance.clearance.radial_m)?;
        }
        Ok(())
    }
}

/// Field of the limits of moments of inertia.
pub(super) const POLAR_INERTIA: &str = "rotor_polar_inertia_kg_m2";
/// Largest distance of a plane from the mass centre: the longest turbine shafts are shorter.
const AXIAL_MAX_M: f64 = 100.0;
/// Share by which Ip may exceed 2·It of a thin disc, by rounding.
pub(crate) const ROUNDING: f64 = 1e-9;

/// Passes a value that keeps to what is `allowed`, which completes "must be".
fn require(
    name: &'static str,
    value: f64,
    kept: bool,
    allowed: impl Into<String>,
) -> Result<(), RotorError> {
    match kept {
        true => Ok(()),
        false => Err(RotorError::value(name, value, allowed)),
    }
}

/// A value within the limits of `field`.
pub(super) fn within(name: &'static str, field: &str, value: f64) -> Result<(), RotorError> {
    let limit = LIMITS.iter().find(|limit| limit.field == field);
    limit.map_or(Ok(()), |l| {
        let allowed = format!("from {:e} to {:e}: {}", l.least, l.most, l.reason);
        let kept = (l.least..=l.most).contains(&value);
        require(name, value, kept, allowed)
    })
}

/// A finite value above 0.
pub(super) fn positive(name: &'static str, value: f64) -> Result<(), RotorError> {
    require(name, value, value > 0.0 && value.is_finite(), "more than 0")
}

/// A finite value.
pub(super) fn finite(name: &'static str, value: f64) -> Result<(), RotorError> {
    require(name, value, value.is_finite(), "a finite number")
}
