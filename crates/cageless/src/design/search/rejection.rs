//! Causes of rejection of a raceway design.

use super::axial::AxialSeparation;
use super::job::PairSeparation;
use super::perturbed_run::Motion;
use super::raceway_layout::ClosedForms;
use crate::contact::hertz::STRESS_LIMIT_PA;
use crate::design::{
    Criterion, DOUBLE_COLLISION_FRACTION, LAG_MIN_FRACTION, SLIP_SHORTFALL, SPEED_DROP_FRACTION,
    percent_beside,
};
use crate::error::InputError;
use crate::raceway::RacewayShape;

/// Least gap with which balls come back, over the critical gap, with about which they leave the raceway.
/// In the load zone it is 0.7 (at low speed) to 1; where a raceway lies so that its way out has
/// no load, a fifth.
pub(crate) const RETAINED_FRACTION: f64 = 0.5;

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
    /// Verdict of the raceway in the place of the case's own, with its reason.
    Verdict(String),
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
    /// Whether it is read from the motion from the bunched start alone.
    pub bunched: bool,
}

impl std::fmt::Display for Rejection {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let start = if self.bunched {
            " from a bunched start"
        } else {
            ""
        };
        write!(f, "{}{start}", self.cause)
    }
}

/// Kind of a cause.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CauseKind {
    /// Name in files.
    pub name: &'static str,
    /// What is wrong with the raceway.
    pub meaning: &'static str,
    /// What to change of a search in which it decides.
    pub remedy: &'static str,
}

/// Declares the kinds of causes.
macro_rules! kinds {
    ($($name:literal: $meaning:literal, $remedy:literal;)*) => {
        [$(CauseKind { name: $name, meaning: $meaning, remedy: $remedy }),*]
    };
}

impl Cause {
    /// All kinds, in the order in which they are tested.
    pub const KINDS: [CauseKind; 15] = kinds! {
        "eq-8": "wider than the groove (Zhao 2022, Eq. (8))",
            "smaller spans (search.axial_span_mm)";
        "eq-9": "too long for its width: the contact path leaves the groove or turns back (Zhao 2022, Eq. (9))",
            "smaller half angles (search.half_angle_deg)";
        "slot": "no room for a slot between its edges and its ends",
            "sharper edges (search.edge_radius_mm)";
        "overlap": "raceways overlap",
            "fewer raceways (search.raceways_max)";
        "insufficient-separation": "too shallow: balls leave too close together",
            "a smaller search.critical_gap_min_fraction, or wider ranges of search.axial_span_mm and \
             search.half_angle_deg";
        "slips": "balls slide too much to leave at the full distance",
            "a lower speed or a higher load, with which balls slide less";
        "excessive-separation": "too deep: balls are spaced too far, so that three meet",
            "a lower speed or a higher load, with which shallower raceways space the balls";
        "stress": "contact pressure above 4200 MPa (ISO 76)",
            "a lower load";
        "gross-sliding": "balls slide over the raceway and slow down too little",
            "a lower speed or a higher load, with which balls slide less";
        "loses-lag": "load, contact angle and sliding leave too little of the lag",
            "a lower speed, or less axial load";
        "gap-not-retained": "balls close up again before they are loaded",
            "places nearer to the load (search.centre_angle_deg)";
        "double-collision": "double collisions in too many passages",
            "a lower speed, or balls with more room (bearing.balls)";
        "axial-load": "too little of the lag is left under the largest axial load",
            "a smaller search.axial_load_max_n";
        "verdict": "fails its verdict from evenly spaced balls",
            "a lower speed or a higher load, with which balls slide less";
        "failed": "a run stopped",
            "another shape (search.shapes), or blended ends (raceway.blend_mm)";
    };

    /// Kind of this cause.
    pub fn kind(&self) -> &'static CauseKind {
        let at = match self {
            Self::Span => 0,
            Self::Path => 1,
            Self::Slot => 2,
            Self::Overlap => 3,
            Self::InsufficientSeparation { .. } => 4,
            Self::Slips(_) => 5,
            Self::ExcessiveSeparation(_) => 6,
            Self::Stress(_) => 7,
            Self::GrossSliding(_) => 8,
            Self::LosesLag(_) => 9,
            Self::GapNotRetained(_) => 10,
            Self::DoubleCollision(_) => 11,
            Self::AxialLoad(_) => 12,
            Self::Verdict(_) => 13,
            Self::Failed(_) => 14,
        };
        &Self::KINDS[at]
    }

    /// Name in files.
    pub fn name(&self) -> &'static str {
        self.kind().name
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
            Self::Span
            | Self::Path
            | Self::Slot
            | Self::Overlap
            | Self::Verdict(_)
            | Self::Failed(_) => f64::INFINITY,
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
        let separation = Criterion::separation(elastic, spacing.shortfall);
        let others = [
            Criterion::SteadyGap {
                value: spacing.critical_gap_rad / forms.steady_gap_rad,
                least: critical_gap_min_fraction,
            },
            Criterion::Pressure(spacing.stress_pa / STRESS_LIMIT_PA),
        ];
        separation
            .into_iter()
            .chain(others)
            .find_map(Self::of_criterion)
    }

    /// Cause of a rejection by a criterion of the verdict; `None` where it is met.
    fn of_criterion(criterion: Criterion) -> Option<Self> {
        let value = criterion.value();
        match criterion {
            _ if criterion.is_met() => None,
            _ if !criterion.is_known() => Criterion::missing(&[criterion]).map(Self::Failed),
            Criterion::Separation(_) => Some(Self::Slips(value)),
            Criterion::SteadyGap { .. } if criterion.at_least() => {
                Some(Self::InsufficientSeparation {
                    fraction: value,
                    measured: true,
                })
            }
            Criterion::SteadyGap { .. } => Some(Self::ExcessiveSeparation(value)),
            Criterion::Pressure(_) | Criterion::PeakPressure(_) => {
                Some(Self::Stress(value * STRESS_LIMIT_PA))
            }
            Criterion::Lag(_) => Some(Self::LosesLag(value)),
            Criterion::Deceleration(_) => Some(Self::GrossSliding(value)),
            Criterion::BothNeighbours(_) => Some(Self::DoubleCollision(value)),
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
        let slowing = Criterion::slowing(elastic, motion.speed_drop_fraction, motion.lag_fraction);
        let kept = motion.gap_min_rad / spacing.critical_gap_rad;
        Self::of_criterion(slowing)
            .or_else(|| (kept < RETAINED_FRACTION).then_some(Self::GapNotRetained(kept)))
            .or_else(|| {
                let twice = motion.double_collision_fraction;
                Self::of_criterion(Criterion::BothNeighbours(twice))
            })
    }
}

impl std::fmt::Display for Cause {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        // A value that misses its limit must not be printed as the limit.
        let beside = |x: &f64, limit: f64| percent_beside(*x, limit);
        match self {
            Self::Span | Self::Path | Self::Slot | Self::Overlap => {
                f.write_str(self.kind().meaning)
            }
            Self::InsufficientSeparation { fraction, measured } => write!(
                f,
                "too shallow: {} only {:.1} % of the steady-state gap",
                if *measured { "critical gap" } else { "β0" },
                100.0 * fraction
            ),
            Self::ExcessiveSeparation(fraction) => write!(
                f,
                "too deep: critical gap {} of the steady-state gap, so that three balls meet",
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
                "balls slide over the raceway: they slow down by {} of what rolling balls do \
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
                "balls close up again before they are loaded: they return with as little as {} of the \
                 critical gap ({:.0} % required)",
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
            Self::Verdict(headline) => write!(f, "with evenly spaced balls {headline}"),
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
        // What is not known is no pass.
        assert_eq!(of(f64::NAN, 0.02, 0.1), Some("failed"));
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
            (motion_of(0.7, 0.03, 0.0), 0.1, "they slow down by 70.0 %"),
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
        let names = [
            "insufficient-separation",
            "excessive-separation",
            "slips",
            "stress",
            "gross-sliding",
            "gap-not-retained",
            "double-collision",
        ];
        assert_eq!(rows.each_ref().map(|row| row.0.name()), names);
        for (cause, excess, text) in rows {
            assert!((cause.excess(0.5) - excess).abs() < 1e-12, "{cause:?}");
            assert!(cause.to_string().contains(text), "{cause}");
        }
        for (cause, name) in [
            (Cause::Span, "eq-8"),
            (Cause::Path, "eq-9"),
            (Cause::Slot, "slot"),
            (Cause::Overlap, "overlap"),
            (Cause::Verdict("does not work".to_owned()), "verdict"),
            (Cause::Failed("no".to_owned()), "failed"),
        ] {
            assert_eq!((cause.name(), cause.excess(0.5)), (name, f64::INFINITY));
        }
        let kept = [Cause::LosesLag(0.4), Cause::AxialLoad(0.4)];
        assert_eq!(kept.map(|cause| cause.name()), ["loses-lag", "axial-load"]);
    }
}
