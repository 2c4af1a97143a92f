//! Causes of rejection of a raceway design.

use super::job::PairSeparation;
use super::perturbed_run::Motion;
use super::raceway_layout::ClosedForms;
use crate::contact::hertz::STRESS_LIMIT_PA;
use crate::design::{
    DOUBLE_COLLISION_FRACTION, SLIP_SHORTFALL, SPEED_DROP_FRACTION, percent_beside,
};
use crate::error::InputError;

/// Least gap with which balls come back, over the critical gap, which the raceway guarantees.
/// In the load zone it is 0.7 (at low speed) to 1; where a raceway lies so that its way out has
/// no load, a fifth.
pub const RETAINED_FRACTION: f64 = 0.5;

/// Cause for which a raceway design is rejected.
#[derive(Debug, Clone, PartialEq)]
pub enum Cause {
    /// Zhao 2022, Eq. (8): the span is too large for the groove.
    Span,
    /// Zhao 2022, Eq. (9): the contact path leaves the groove or turns back.
    Path,
    /// Overlap of two raceways.
    Overlap,
    /// Separation as a fraction of the mean ball spacing; the raceway is too shallow.
    InsufficientSeparation(f64),
    /// Critical gap as a multiple of the mean ball spacing; the raceway is too deep.
    ExcessiveSeparation(f64),
    /// Loss of separation through sliding, as a fraction of β0.
    Slips(f64),
    /// Fraction of the passages with hits from both sides.
    DoubleCollision(f64),
    /// The balls reach this fraction of the theoretical drop of orbital speed: they slide over the
    /// raceway, and its critical gap means nothing.
    GrossSliding(f64),
    /// Gap on return to the raceway, as a fraction of the critical gap.
    GapNotRetained(f64),
    /// Contact pressure at the outer raceway, Pa.
    Stress(f64),
    /// Failure of a run, with its message.
    Failed(String),
}

/// Cause of a rejection and the operating point at which it occurs.
#[derive(Debug, Clone, PartialEq)]
pub struct Rejection {
    /// Cause of the rejection.
    pub cause: Cause,
    /// Index of the operating point; `None` if it is wrong at any.
    pub point: Option<usize>,
}

impl Cause {
    /// Names of all causes, in the order in which they are tested.
    pub const NAMES: [&'static str; 11] = [
        "eq-8",
        "eq-9",
        "overlap",
        "insufficient-separation",
        "slips",
        "excessive-separation",
        "stress",
        "gross-sliding",
        "gap-not-retained",
        "double-collision",
        "failed",
    ];

    /// Name in files.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Span => "eq-8",
            Self::Path => "eq-9",
            Self::Overlap => "overlap",
            Self::InsufficientSeparation(_) => "insufficient-separation",
            Self::Slips(_) => "slips",
            Self::ExcessiveSeparation(_) => "excessive-separation",
            Self::Stress(_) => "stress",
            Self::GrossSliding(_) => "gross-sliding",
            Self::GapNotRetained(_) => "gap-not-retained",
            Self::DoubleCollision(_) => "double-collision",
            Self::Failed(_) => "failed",
        }
    }

    /// Excess over the limit, as a fraction; infinite where there is no numerical limit.
    pub fn excess(&self, spread_min: f64) -> f64 {
        match self {
            Self::InsufficientSeparation(fraction) => 1.0 - fraction / spread_min,
            Self::ExcessiveSeparation(fraction) => fraction - 1.0,
            Self::Slips(shortfall) => shortfall - SLIP_SHORTFALL,
            Self::DoubleCollision(fraction) => fraction - DOUBLE_COLLISION_FRACTION,
            Self::Stress(pa) => pa / STRESS_LIMIT_PA - 1.0,
            Self::GrossSliding(fraction) => SPEED_DROP_FRACTION - fraction,
            Self::GapNotRetained(fraction) => RETAINED_FRACTION - fraction,
            Self::Span | Self::Path | Self::Overlap | Self::Failed(_) => f64::INFINITY,
        }
    }

    /// Cause for an error of the raceway geometry.
    pub(super) fn of_geometry(error: &InputError) -> Self {
        match error.field {
            "axial_span_m" => Self::Span,
            "half_angle_rad" => Self::Path,
            "centre_angle_rad" => Self::Overlap,
            _ => Self::Failed(error.to_string()),
        }
    }

    /// Cause of rejection by geometry alone: without slip the critical gap is β0.
    pub(super) fn of_closed_forms(forms: &ClosedForms, spread_min: f64) -> Option<Self> {
        (forms.fraction() < spread_min).then(|| Self::InsufficientSeparation(forms.fraction()))
    }

    /// Cause of rejection by critical gap and contact stress.
    pub(super) fn of_spacing(
        forms: &ClosedForms,
        spacing: &PairSeparation,
        spread_min: f64,
    ) -> Option<Self> {
        let fraction = spacing.critical_gap_rad / forms.steady_gap_rad;
        if spacing.shortfall > SLIP_SHORTFALL {
            Some(Self::Slips(spacing.shortfall))
        } else if fraction > 1.0 {
            Some(Self::ExcessiveSeparation(fraction))
        } else if fraction < spread_min {
            Some(Self::InsufficientSeparation(fraction))
        } else if spacing.stress_pa > STRESS_LIMIT_PA {
            Some(Self::Stress(spacing.stress_pa))
        } else {
            None
        }
    }

    /// Cause of rejection by the motion of all balls.
    pub(super) fn of_motion(motion: &Motion, spacing: &PairSeparation) -> Option<Self> {
        let kept = motion.gap_min_rad / spacing.critical_gap_rad;
        if motion.speed_drop_fraction < SPEED_DROP_FRACTION {
            Some(Self::GrossSliding(motion.speed_drop_fraction))
        } else if kept < RETAINED_FRACTION {
            Some(Self::GapNotRetained(kept))
        } else if motion.double_collision_fraction > DOUBLE_COLLISION_FRACTION {
            Some(Self::DoubleCollision(motion.double_collision_fraction))
        } else {
            None
        }
    }
}

impl std::fmt::Display for Cause {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        // A value that misses its limit must not be printed as the limit.
        let beside = |x: &f64, limit: f64| percent_beside(*x, limit);
        match self {
            Self::Span => write!(
                f,
                "the contact points leave the groove (Zhao 2022, Eq. (8))"
            ),
            Self::Path => write!(
                f,
                "the contact path leaves the groove or turns back (Zhao 2022, Eq. (9))"
            ),
            Self::Overlap => write!(f, "raceways overlap"),
            Self::InsufficientSeparation(fraction) => write!(
                f,
                "separation only {:.1} % of the mean ball spacing: raceway too shallow",
                100.0 * fraction
            ),
            Self::ExcessiveSeparation(fraction) => write!(
                f,
                "critical gap {} of the mean ball spacing: raceway too deep, evenly spaced balls collide",
                beside(fraction, 1.0)
            ),
            Self::Slips(shortfall) => write!(
                f,
                "loss of separation through sliding {} ({:.0} % allowed)",
                beside(shortfall, SLIP_SHORTFALL),
                100.0 * SLIP_SHORTFALL
            ),
            Self::GrossSliding(fraction) => write!(
                f,
                "gross sliding: achieved deceleration {} of the kinematic value \
                 ({:.0} % required)",
                beside(fraction, SPEED_DROP_FRACTION),
                100.0 * SPEED_DROP_FRACTION
            ),
            Self::GapNotRetained(fraction) => write!(
                f,
                "separation lost before the load zone: balls return with as little as {} of the critical \
                 gap ({:.0} % required)",
                beside(fraction, RETAINED_FRACTION),
                100.0 * RETAINED_FRACTION
            ),
            Self::DoubleCollision(fraction) => write!(
                f,
                "{} of the passages hit from both sides ({:.0} % allowed)",
                beside(fraction, DOUBLE_COLLISION_FRACTION),
                100.0 * DOUBLE_COLLISION_FRACTION
            ),
            Self::Stress(pa) => write!(
                f,
                "contact stress {:.2} GPa ({} GPa allowed, ISO 76)",
                pa * 1e-9,
                STRESS_LIMIT_PA * 1e-9
            ),
            Self::Failed(reason) => write!(f, "{reason}"),
        }
    }
}
