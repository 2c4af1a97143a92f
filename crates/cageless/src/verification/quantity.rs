//! Results that a verification classifies.

use crate::case::Case;
use crate::kinematics::rolling_rotation_rad_s;

/// Scalar result of a run; a mean, a number or an extreme of the part after its transient, or a value at the end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// Contacts between balls that began.
    Collisions,
    /// Smallest gap, rad.
    GapMin,
    /// Largest gap, rad.
    GapMax,
    /// Mean displacement of the inner ring, m.
    RingXMean,
    /// Mean displacement of the inner ring, m.
    RingYMean,
    /// Largest slip at a loaded raceway contact, m/s.
    SlipMax,
    /// Standard deviation of the ring displacement over time, m.
    RingXDeviation,
    /// Standard deviation of the ring displacement over time, m.
    RingYDeviation,
    /// Mean orbital speed over balls and time, rad/s.
    OrbitSpeedMean,
    /// Mean absolute spin over balls and time, rad/s.
    SpinMean,
    /// Largest force at the inner raceway, N.
    InnerForceMax,
    /// Largest force at the outer raceway, N.
    OuterForceMax,
    /// Mean power loss, W.
    PowerLoss,
    /// Mean torque of the drive, N·m; of a constant speed alone.
    FrictionTorque,
    /// Mean lag of a ball per pass of a discrete raceway, rad.
    LagPerPass,
    /// Displacement of the ring at the end, m.
    RingXEnd,
    /// Displacement of the ring at the end, m.
    RingYEnd,
    /// ψ of ball 1 at the end, continuous, rad.
    LeadBallAngleEnd,
}

/// Scale of forces, power and torque over their value: they are converged within a hundredth.
const VALUES: f64 = 10.0;

impl Quantity {
    /// All quantities, in the order of their discriminants.
    pub(crate) const ALL: [Self; 18] = [
        Self::Collisions,
        Self::GapMin,
        Self::GapMax,
        Self::RingXMean,
        Self::RingYMean,
        Self::SlipMax,
        Self::RingXDeviation,
        Self::RingYDeviation,
        Self::OrbitSpeedMean,
        Self::SpinMean,
        Self::InnerForceMax,
        Self::OuterForceMax,
        Self::PowerLoss,
        Self::FrictionTorque,
        Self::LagPerPass,
        Self::RingXEnd,
        Self::RingYEnd,
        Self::LeadBallAngleEnd,
    ];

    /// Whether the quantity is a value at one instant.
    pub(crate) fn is_point(self) -> bool {
        matches!(
            self,
            Self::RingXEnd | Self::RingYEnd | Self::LeadBallAngleEnd
        )
    }

    /// Scale of the quantity in its unit; `value` is the result itself.
    ///
    /// Displacements of the ring have the scale of the trajectories' distance, 10 µm; angles the
    /// nominal gap, at least 0.1°; speeds those of rolling. Collisions, the largest slip and
    /// deviations are their own scale, at least by 1, the slip scale of the
    /// friction law and 0.1 µm. Forces, power and torque are ten times their own size.
    pub(crate) fn scale(self, case: &Case, value: f64) -> f64 {
        const PLACE_M: f64 = 1e-5;
        let bearing = &case.bearing;
        let radius = bearing.ball_radius_m();
        let orbit = case.rolling_orbit_speed_rad_s();
        match self {
            Self::Collisions => value.abs().max(1.0),
            Self::InnerForceMax | Self::OuterForceMax | Self::PowerLoss | Self::FrictionTorque => {
                VALUES * value.abs()
            }
            Self::GapMin | Self::GapMax | Self::LagPerPass | Self::LeadBallAngleEnd => {
                bearing.nominal_gap_rad().max(0.1_f64.to_radians())
            }
            Self::RingXMean | Self::RingYMean | Self::RingXEnd | Self::RingYEnd => PLACE_M,
            Self::SlipMax => value
                .abs()
                .max(case.contact.friction.regularisation_speed_m_s),
            Self::RingXDeviation | Self::RingYDeviation => value.abs().max(0.01 * PLACE_M),
            Self::OrbitSpeedMean => orbit,
            Self::SpinMean => rolling_rotation_rad_s(bearing, orbit, radius).abs(),
        }
    }
}
