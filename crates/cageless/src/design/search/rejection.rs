//! Why a structure is not acceptable.

use super::disturbed::Motion;
use super::job::Spacing;
use super::structure::ClosedForms;
use crate::contact::hertz::STRESS_LIMIT_PA;
use crate::design::{SLIP_SHORTFALL, SPEED_DROP_SHARE, TWICE_SHARE, percent_beside};
use crate::error::InputError;

/// Least gap with which balls come back, over the critical gap, which the raceway guarantees.
/// In the load zone it is 0.7 (at low speed) to 1; where a raceway lies so that its way out has
/// no load, a fifth.
pub const KEPT_SHARE: f64 = 0.5;

/// What is wrong with a structure.
#[derive(Debug, Clone, PartialEq)]
pub enum Cause {
    /// Zhao 2022, Eq. (8): the span is too large for the groove.
    Span,
    /// Zhao 2022, Eq. (9): the contact path leaves the groove or turns back.
    Path,
    /// Two raceways overlap.
    Overlap,
    /// The guaranteed gap is this share of the steady gap, too little to spread the balls.
    Shallow(f64),
    /// The critical gap is this multiple of the steady gap: evenly flowing balls collide.
    Crowded(f64),
    /// Slip takes this share from the critical gap.
    Slips(f64),
    /// This share of the passages is hit by both neighbours.
    DoubleCollision(f64),
    /// The balls reach this share of the theoretical drop of orbital speed: they slide over the
    /// raceway, and its critical gap means nothing.
    Slides(f64),
    /// Balls come back with this share of the gap that the raceway gave them.
    Lost(f64),
    /// This pressure at the outer raceway, Pa.
    Stress(f64),
    /// A run failed.
    Failed(String),
}

/// Why a structure is not acceptable, and where.
#[derive(Debug, Clone, PartialEq)]
pub struct Rejection {
    /// What is wrong.
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
        "shallow",
        "slips",
        "crowded",
        "stress",
        "slides",
        "lost",
        "double-collision",
        "failed",
    ];

    /// Name in files.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Span => "eq-8",
            Self::Path => "eq-9",
            Self::Overlap => "overlap",
            Self::Shallow(_) => "shallow",
            Self::Slips(_) => "slips",
            Self::Crowded(_) => "crowded",
            Self::Stress(_) => "stress",
            Self::Slides(_) => "slides",
            Self::Lost(_) => "lost",
            Self::DoubleCollision(_) => "double-collision",
            Self::Failed(_) => "failed",
        }
    }

    /// How far beyond its limit, as a share; infinite where there is no limit to compare with.
    pub fn excess(&self, spread_min: f64) -> f64 {
        match self {
            Self::Shallow(share) => 1.0 - share / spread_min,
            Self::Crowded(share) => share - 1.0,
            Self::Slips(shortfall) => shortfall - SLIP_SHORTFALL,
            Self::DoubleCollision(share) => share - TWICE_SHARE,
            Self::Stress(pa) => pa / STRESS_LIMIT_PA - 1.0,
            Self::Slides(share) => SPEED_DROP_SHARE - share,
            Self::Lost(share) => KEPT_SHARE - share,
            Self::Span | Self::Path | Self::Overlap | Self::Failed(_) => f64::INFINITY,
        }
    }

    /// From the error of laying out raceways.
    pub(super) fn of_geometry(error: &InputError) -> Self {
        match error.field {
            "axial_span_m" => Self::Span,
            "half_angle_rad" => Self::Path,
            "centre_angle_rad" => Self::Overlap,
            _ => Self::Failed(error.to_string()),
        }
    }

    /// What the geometry alone excludes: β0 is what the critical gap is without slip.
    pub(super) fn of_closed_forms(forms: &ClosedForms, spread_min: f64) -> Option<Self> {
        (forms.share() < spread_min).then(|| Self::Shallow(forms.share()))
    }

    /// What critical gap and stress exclude.
    pub(super) fn of_spacing(
        forms: &ClosedForms,
        spacing: &Spacing,
        spread_min: f64,
    ) -> Option<Self> {
        let share = spacing.critical_gap_rad / forms.steady_gap_rad;
        if spacing.shortfall > SLIP_SHORTFALL {
            Some(Self::Slips(spacing.shortfall))
        } else if share > 1.0 {
            Some(Self::Crowded(share))
        } else if share < spread_min {
            Some(Self::Shallow(share))
        } else if spacing.stress_pa > STRESS_LIMIT_PA {
            Some(Self::Stress(spacing.stress_pa))
        } else {
            None
        }
    }

    /// What the motion of all balls excludes.
    pub(super) fn of_motion(motion: &Motion, spacing: &Spacing) -> Option<Self> {
        let kept = motion.gap_min_rad / spacing.critical_gap_rad;
        if motion.speed_drop_share < SPEED_DROP_SHARE {
            Some(Self::Slides(motion.speed_drop_share))
        } else if kept < KEPT_SHARE {
            Some(Self::Lost(kept))
        } else if motion.twice_share > TWICE_SHARE {
            Some(Self::DoubleCollision(motion.twice_share))
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
            Self::Shallow(share) => write!(
                f,
                "guarantees only {:.1} % of the steady gap: hardly spreads the balls",
                100.0 * share
            ),
            Self::Crowded(share) => write!(
                f,
                "critical gap {} of the steady gap: even evenly flowing balls collide",
                beside(share, 1.0)
            ),
            Self::Slips(shortfall) => write!(
                f,
                "sliding takes {} of the separation ({:.0} % allowed)",
                beside(shortfall, SLIP_SHORTFALL),
                100.0 * SLIP_SHORTFALL
            ),
            Self::Slides(share) => write!(
                f,
                "the balls slide over it: {} of the theoretical drop of orbital speed \
                 ({:.0} % needed)",
                beside(share, SPEED_DROP_SHARE),
                100.0 * SPEED_DROP_SHARE
            ),
            Self::Lost(share) => write!(
                f,
                "the gap is lost again: balls come back with as little as {} of the critical \
                 gap ({:.0} % needed)",
                beside(share, KEPT_SHARE),
                100.0 * KEPT_SHARE
            ),
            Self::DoubleCollision(share) => write!(
                f,
                "{} of the passages hit by both neighbours ({:.0} % allowed)",
                beside(share, TWICE_SHARE),
                100.0 * TWICE_SHARE
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
