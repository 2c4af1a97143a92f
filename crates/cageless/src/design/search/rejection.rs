//! Causes of rejection of a raceway design.

use super::axial::AxialSeparation;
use super::job::PairSeparation;
use super::perturbed_run::Motion;
use super::raceway_layout::ClosedForms;
use crate::contact::hertz::STRESS_LIMIT_PA;
use crate::design::{
    DOUBLE_COLLISION_FRACTION, LAG_MIN_FRACTION, SLIP_SHORTFALL, SPEED_DROP_FRACTION,
    percent_beside,
};
use crate::error::InputError;
use crate::raceway::RacewayShape;

/// Least gap with which balls come back, over the critical gap, with about which they leave the raceway.
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
    /// The edges leave no slot between them, or its ends take up more than 2θ.
    Slot,
    /// Overlap of two raceways.
    Overlap,
    /// Separation as a fraction of the mean ball spacing; the raceway is too shallow.
    InsufficientSeparation {
        /// The fraction.
        fraction: f64,
        /// Whether the critical gap was measured; else it is β0, which it is without slip.
        measured: bool,
    },
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
    /// Share of the lag that load, contact angle and sliding leave in space.
    LosesLag(f64),
    /// Share of the lag that is left under the largest axial load.
    AxialLoad(f64),
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
    pub const NAMES: [&'static str; 14] = [
        "eq-8",
        "eq-9",
        "slot",
        "overlap",
        "insufficient-separation",
        "slips",
        "excessive-separation",
        "stress",
        "gross-sliding",
        "loses-lag",
        "gap-not-retained",
        "double-collision",
        "axial-load",
        "failed",
    ];

    /// Name in files.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Span => "eq-8",
            Self::Path => "eq-9",
            Self::Slot => "slot",
            Self::Overlap => "overlap",
            Self::InsufficientSeparation { .. } => "insufficient-separation",
            Self::Slips(_) => "slips",
            Self::ExcessiveSeparation(_) => "excessive-separation",
            Self::Stress(_) => "stress",
            Self::GrossSliding(_) => "gross-sliding",
            Self::LosesLag(_) => "loses-lag",
            Self::GapNotRetained(_) => "gap-not-retained",
            Self::DoubleCollision(_) => "double-collision",
            Self::AxialLoad(_) => "axial-load",
            Self::Failed(_) => "failed",
        }
    }

    /// Excess over the limit, as a fraction; infinite where there is no numerical limit.
    pub fn excess(&self, critical_gap_min_fraction: f64) -> f64 {
        match self {
            Self::InsufficientSeparation { fraction, .. } => {
                1.0 - fraction / critical_gap_min_fraction
            }
            Self::ExcessiveSeparation(fraction) => fraction - 1.0,
            Self::Slips(shortfall) => shortfall - SLIP_SHORTFALL,
            Self::DoubleCollision(fraction) => fraction - DOUBLE_COLLISION_FRACTION,
            Self::Stress(pa) => pa / STRESS_LIMIT_PA - 1.0,
            Self::LosesLag(fraction) | Self::AxialLoad(fraction) => LAG_MIN_FRACTION - fraction,
            Self::GrossSliding(fraction) => SPEED_DROP_FRACTION - fraction,
            Self::GapNotRetained(fraction) => RETAINED_FRACTION - fraction,
            Self::Span | Self::Path | Self::Slot | Self::Overlap | Self::Failed(_) => f64::INFINITY,
        }
    }

    /// Cause for an error of the raceway geometry.
    pub(super) fn of_geometry(shape: RacewayShape, error: &InputError) -> Self {
        match error.field {
            "edge_radius_m" | "slot_depth_m" => Self::Slot,
            "half_angle_rad" if shape == RacewayShape::Slot => Self::Slot,
            "axial_span_m" | "raceway_contact_angle_rad" => Self::Span,
            "half_angle_rad" => Self::Path,
            "centre_angle_rad" => Self::Overlap,
            _ => Self::Failed(error.to_string()),
        }
    }

    /// Cause of rejection by closed forms alone: without slip the critical gap is β0.
    pub(super) fn of_closed_forms(
        forms: &ClosedForms,
        critical_gap_min_fraction: f64,
    ) -> Option<Self> {
        (forms.fraction() < critical_gap_min_fraction).then(|| Self::InsufficientSeparation {
            fraction: forms.fraction(),
            measured: false,
        })
    }

    /// Cause of rejection by critical gap and contact stress. On elastic flanks what sliding takes from β0 is no
    /// cause: spin on the flanks takes a part of it in every raceway, which a deeper one makes up for.
    pub(super) fn of_spacing(
        forms: &ClosedForms,
        spacing: &PairSeparation,
        critical_gap_min_fraction: f64,
        elastic: bool,
    ) -> Option<Self> {
        let fraction = spacing.critical_gap_rad / forms.steady_gap_rad;
        if spacing.shortfall > SLIP_SHORTFALL && !elastic {
            Some(Self::Slips(spacing.shortfall))
        } else if fraction > 1.0 {
            Some(Self::ExcessiveSeparation(fraction))
        } else if fraction < critical_gap_min_fraction {
            Some(Self::InsufficientSeparation {
                fraction,
                measured: true,
            })
        } else if spacing.stress_pa > STRESS_LIMIT_PA {
            Some(Self::Stress(spacing.stress_pa))
        } else {
            None
        }
    }

    /// Cause of rejection by what an axial load leaves of the lag at an operating point: in space, or by rolling as long
    /// as that is not known.
    pub(super) fn of_axial(axial: &AxialSeparation) -> Option<Self> {
        let fraction = axial.fraction().unwrap_or(axial.rolling_fraction);
        (fraction < LAG_MIN_FRACTION).then_some(Self::AxialLoad(fraction))
    }

    /// Cause of rejection by the motion of all balls.
    pub(super) fn of_motion(
        motion: &Motion,
        spacing: &PairSeparation,
        elastic: bool,
    ) -> Option<Self> {
        let kept = motion.gap_min_rad / spacing.critical_gap_rad;
        if elastic && motion.lag_fraction < LAG_MIN_FRACTION {
            Some(Self::LosesLag(motion.lag_fraction))
        } else if !elastic && motion.speed_drop_fraction < SPEED_DROP_FRACTION {
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
            Self::Slot => write!(
                f,
                "the edges leave no slot between them, or its ends alone take up 2θ"
            ),
            Self::Overlap => write!(f, "raceways overlap"),
            Self::InsufficientSeparation { fraction, measured } => write!(
                f,
                "{} only {:.1} % of the steady-state gap: raceway too shallow",
                if *measured { "critical gap" } else { "β0" },
                100.0 * fraction
            ),
            Self::ExcessiveSeparation(fraction) => write!(
                f,
                "critical gap {} of the steady-state gap: raceway too deep, evenly spaced balls collide",
                beside(fraction, 1.0)
            ),
            Self::Slips(shortfall) => write!(
                f,
                "sliding lowers the critical gap by {} of β0 ({:.0} % allowed)",
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
            Self::LosesLag(fraction) => write!(
                f,
                "balls keep {} of the lag of rolling on rigid flanks ({:.0} % required)",
                beside(fraction, LAG_MIN_FRACTION),
                100.0 * LAG_MIN_FRACTION
            ),
            Self::GapNotRetained(fraction) => write!(
                f,
                "gap lost before the load zone: balls return with as little as {} of the critical \
                 gap ({:.0} % required)",
                beside(fraction, RETAINED_FRACTION),
                100.0 * RETAINED_FRACTION
            ),
            Self::DoubleCollision(fraction) => write!(
                f,
                "double collisions in {} of the passages ({:.0} % allowed)",
                beside(fraction, DOUBLE_COLLISION_FRACTION),
                100.0 * DOUBLE_COLLISION_FRACTION
            ),
            Self::AxialLoad(fraction) => write!(
                f,
                "under the largest axial load {} of the lag is left ({:.0} % required)",
                beside(fraction, LAG_MIN_FRACTION),
                100.0 * LAG_MIN_FRACTION
            ),
            Self::Stress(pa) => write!(
                f,
                "contact pressure {:.0} MPa ({:.0} MPa allowed, ISO 76)",
                pa * 1e-6,
                STRESS_LIMIT_PA * 1e-6
            ),
            Self::Failed(reason) => write!(f, "{reason}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const STEADY: f64 = 0.04;
    const FORMS: ClosedForms = ClosedForms {
        theoretical_gap_rad: 0.036,
        steady_gap_rad: STEADY,
    };

    fn spacing(critical_gap_rad: f64, shortfall: f64, stress_pa: f64) -> PairSeparation {
        PairSeparation {
            critical_gap_rad,
            shortfall,
            stress_pa,
        }
    }

    fn motion(
        speed_drop_fraction: f64,
        gap_min_rad: f64,
        double_collision_fraction: f64,
    ) -> Motion {
        Motion {
            speed_drop_fraction,
            gap_min_rad,
            double_collision_fraction,
            ..Motion::default()
        }
    }

    /// Each requirement alone: kept at its limit, missed by the next number beyond it, with the
    /// value that missed it.
    #[test]
    fn each_requirement_is_kept_up_to_its_limit() {
        let name = |cause: Option<Cause>| cause.map(|cause| cause.name());
        let forms = |beta0| ClosedForms {
            theoretical_gap_rad: beta0,
            ..FORMS
        };
        let closed = |fraction: f64| name(Cause::of_closed_forms(&forms(fraction * STEADY), 0.5));
        assert_eq!(closed(0.5), None);
        assert_eq!(closed(0.5 - 1e-12), Some("insufficient-separation"));
        // Evenly spaced balls collide where β0 is above the steady gap: their motion shows that.
        assert_eq!(closed(1.3), None);

        let of = |critical, shortfall, stress| {
            name(Cause::of_spacing(
                &FORMS,
                &spacing(critical, shortfall, stress),
                0.5,
                false,
            ))
        };
        let usual = 0.9 * STEADY;
        assert_eq!(of(usual, 0.05, 1e9), None);
        assert_eq!(of(usual, 0.05f64.next_up(), 1e9), Some("slips"));
        assert_eq!(of(STEADY, 0.0, 1e9), None);
        assert_eq!(
            of(STEADY * (1.0 + 1e-12), 0.0, 1e9),
            Some("excessive-separation")
        );
        assert_eq!(of(0.5 * STEADY, 0.0, 1e9), None);
        let below = of(0.5 * STEADY * (1.0 - 1e-12), 0.0, 1e9);
        assert_eq!(below, Some("insufficient-separation"));
        assert_eq!(of(usual, 0.0, 4.2e9), None);
        assert_eq!(of(usual, 0.0, 4.2e9f64.next_up()), Some("stress"));
        // The first that is missed.
        assert_eq!(of(2.0 * STEADY, 0.1, 9e9), Some("slips"));
        assert_eq!(of(2.0 * STEADY, 0.0, 9e9), Some("excessive-separation"));

        let spacing = spacing(0.03125, 0.0, 1e9);
        let of = |drop, gap, double| {
            name(Cause::of_motion(
                &motion(drop, gap, double),
                &spacing,
                false,
            ))
        };
        assert_eq!(of(0.8, 0.02, 0.1), None);
        assert_eq!(of(0.8f64.next_down(), 0.02, 0.1), Some("gross-sliding"));
        assert_eq!(of(1.0, 0.015_625, 0.1), None);
        assert_eq!(
            of(1.0, 0.015_625f64.next_down(), 0.1),
            Some("gap-not-retained")
        );
        assert_eq!(of(1.0, 0.02, 0.25), None);
        assert_eq!(of(1.0, 0.02, 0.25f64.next_up()), Some("double-collision"));
        assert_eq!(of(0.1, 0.001, 0.9), Some("gross-sliding"));
        // In space the lag decides in place of the deceleration, and no share of β0.
        let kept = |lag_fraction: f64| {
            let motion = Motion {
                lag_fraction,
                ..motion(0.1, 0.02, 0.1)
            };
            name(Cause::of_motion(&motion, &spacing, true))
        };
        assert_eq!(kept(0.5), None);
        assert_eq!(kept(0.5f64.next_down()), Some("loses-lag"));
        let slid = super::tests::spacing(usual, 0.4, 1e9);
        assert_eq!(name(Cause::of_spacing(&FORMS, &slid, 0.5, true)), None);
        assert_eq!(of(1.0, 0.001, 0.9), Some("gap-not-retained"));
    }

    /// What a cause says, and by how much its limit is missed.
    #[test]
    fn causes_say_their_value_and_their_excess() {
        let spacing_of = |critical, shortfall, stress| {
            Cause::of_spacing(&FORMS, &spacing(critical, shortfall, stress), 0.5, false).unwrap()
        };
        let motion_of = |drop, gap, double| {
            Cause::of_motion(&motion(drop, gap, double), &spacing(0.03, 0.0, 1e9), false).unwrap()
        };
        let rows = [
            (
                spacing_of(0.016, 0.0, 0.0),
                0.2,
                "critical gap only 40.0 % of the steady-state gap",
            ),
            (
                spacing_of(0.05, 0.0, 0.0),
                0.25,
                "critical gap 125.0 % of the steady-state gap",
            ),
            (
                spacing_of(0.03, 0.08, 0.0),
                0.03,
                "by 8.0 % of β0 (5 % allowed)",
            ),
            (
                spacing_of(0.03, 0.0, 5.04e9),
                0.2,
                "contact pressure 5040 MPa (4200 MPa allowed",
            ),
            (
                motion_of(0.7, 0.03, 0.0),
                0.1,
                "achieved deceleration 70.0 %",
            ),
            (
                motion_of(1.0, 0.009, 0.0),
                0.2,
                "as little as 30.0 % of the critical gap (50 %",
            ),
            (
                motion_of(1.0, 0.03, 0.35),
                0.1,
                "double collisions in 35.0 % of the passages",
            ),
        ];
        for (cause, excess, text) in rows {
            assert!((cause.excess(0.5) - excess).abs() < 1e-12, "{cause:?}");
            assert!(cause.to_string().contains(text), "{cause}");
            assert!(Cause::NAMES.contains(&cause.name()));
        }
        for (cause, name) in [
            (Cause::Span, "eq-8"),
            (Cause::Path, "eq-9"),
            (Cause::Slot, "slot"),
            (Cause::Overlap, "overlap"),
            (Cause::Failed("no".to_owned()), "failed"),
        ] {
            assert_eq!((cause.name(), cause.excess(0.5)), (name, f64::INFINITY));
        }
    }
}
