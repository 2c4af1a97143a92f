//! Causes of rejection of a raceway design.

use std::ops::RangeInclusive;

use super::axial::AxialSeparation;
use super::job::PairSeparation;
use super::perturbed_run::Motion;
use super::raceway_layout::ClosedForms;
use crate::{
    AXIAL_LAG, BOTH_NEIGHBOURS, CauseKind, Criterion, OF_SEARCH, PRESSURE_AT_REST, RETAINED_GAP,
    STEADY_GAP, THEORETICAL_GAP,
};
use cageless::InputError;
use cageless::contact::STRESS_LIMIT_PA;
use cageless::raceway::RacewayShape;

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
    /// A requirement on the motion of the balls that is not met.
    Missed(Criterion),
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

/// Kinds of causes in the geometry.
static OF_GEOMETRY: [CauseKind; 4] = [
    CauseKind {
        name: "eq-8",
        meaning: "wider than the groove (Zhao 2022, Eq. (8))",
        remedy: "smaller spans (search.axial_span_mm)",
    },
    CauseKind {
        name: "eq-9",
        meaning: "too long for its width: the contact path leaves the groove or turns back (Zhao 2022, Eq. (9))",
        remedy: "smaller half angles (search.half_angle_deg)",
    },
    CauseKind {
        name: "slot",
        meaning: "no room for a slot between its edges and its ends",
        remedy: "sharper edges (search.edge_radius_mm)",
    },
    CauseKind {
        name: "overlap",
        meaning: "raceways overlap",
        remedy: "fewer raceways (search.raceways_max)",
    },
];

/// Kind of a verdict that a raceway fails.
static OF_VERDICT: CauseKind = CauseKind {
    name: "verdict",
    meaning: "fails its verdict from evenly spaced balls",
    remedy: "a lower speed or a higher load, with which balls slide less",
};

/// Kind of a run that stopped.
static OF_FAILURE: CauseKind = CauseKind {
    name: "failed",
    meaning: "a run stopped",
    remedy: "another shape (search.shapes), or blended ends (raceway.blend_mm)",
};

impl Cause {
    /// All kinds, in the order in which they are tested.
    pub fn kinds() -> impl Iterator<Item = &'static CauseKind> {
        let criteria = OF_SEARCH.iter().flat_map(|required| required.causes());
        let last = [&OF_VERDICT, &OF_FAILURE];
        OF_GEOMETRY.iter().chain(criteria).chain(last)
    }

    /// Kind of this cause.
    pub fn kind(&self) -> &'static CauseKind {
        match self {
            Self::Span => &OF_GEOMETRY[0],
            Self::Path => &OF_GEOMETRY[1],
            Self::Slot => &OF_GEOMETRY[2],
            Self::Overlap => &OF_GEOMETRY[3],
            Self::Missed(criterion) => criterion.cause().unwrap_or(&OF_FAILURE),
            Self::Verdict(_) => &OF_VERDICT,
            Self::Failed(_) => &OF_FAILURE,
        }
    }

    /// Name in files.
    pub fn name(&self) -> &'static str {
        self.kind().name
    }

    /// Excess over the limit, as a fraction; infinite where there is no numerical limit.
    pub(crate) fn excess(&self) -> f64 {
        match self {
            Self::Missed(criterion) => -criterion.margin(),
            _ => f64::INFINITY,
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
        let gap = THEORETICAL_GAP.of(forms.fraction());
        Self::of_criterion(gap.with_least(critical_gap_min_fraction))
    }

    /// Cause of rejection by critical gap and contact stress. On elastic flanks what sliding takes from β0 is no
    /// cause: spin on the flanks takes a part of it in every raceway, which a deeper one makes up for.
    pub(super) fn of_spacing(
        forms: &ClosedForms,
        spacing: &PairSeparation,
        gap_range: &RangeInclusive<f64>,
        elastic: bool,
    ) -> Option<Self> {
        let gap = STEADY_GAP.of(spacing.critical_gap_rad / forms.steady_gap_rad);
        let others = [
            (gap.with_least(*gap_range.start())).with_most(*gap_range.end()),
            PRESSURE_AT_REST.of(spacing.stress_pa / STRESS_LIMIT_PA),
        ];
        Criterion::separation(elastic, spacing.shortfall)
            .into_iter()
            .chain(others)
            .find_map(Self::of_criterion)
    }

    /// Cause of a rejection by a criterion of the verdict; `None` where it is met.
    fn of_criterion(criterion: Criterion) -> Option<Self> {
        match criterion.is_met() {
            true => None,
            false if criterion.is_known() => Some(Self::Missed(criterion)),
            false => Criterion::missing(&[criterion]).map(Self::Failed),
        }
    }

    /// Cause of rejection by what an axial load leaves of the lag at an operating point: in space, or by rolling as long
    /// as that is not known.
    pub(super) fn of_axial(axial: &AxialSeparation) -> Option<Self> {
        let fraction = axial.fraction().unwrap_or(axial.rolling_fraction);
        Self::of_criterion(AXIAL_LAG.of(fraction))
    }

    /// Cause of rejection by the motion of all balls.
    pub(super) fn of_motion(
        motion: &Motion,
        spacing: &PairSeparation,
        elastic: bool,
    ) -> Option<Self> {
        [
            Criterion::slowing(elastic, motion.speed_drop_fraction, motion.lag_fraction),
            RETAINED_GAP.of(motion.gap_min_rad / spacing.critical_gap_rad),
            BOTH_NEIGHBOURS.of(motion.double_collision_fraction),
        ]
        .into_iter()
        .find_map(Self::of_criterion)
    }
}

impl std::fmt::Display for Cause {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Span | Self::Path | Self::Slot | Self::Overlap => {
                f.write_str(self.kind().meaning)
            }
            Self::Missed(criterion) => write!(f, "{criterion}"),
            Self::Verdict(headline) => write!(f, "with evenly spaced balls {headline}"),
            Self::Failed(reason) => f.write_str(reason),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::LAG;

    const STEADY: f64 = 0.04;
    const FORMS: ClosedForms = ClosedForms {
        theoretical_gap_rad: 0.036,
        steady_gap_rad: STEADY,
        film_lag_rad: 0.0,
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

    fn name(cause: Option<Cause>) -> Option<&'static str> {
        cause.map(|cause| cause.name())
    }

    /// Each requirement alone: kept at its limit, missed by the next number beyond it, with the
    /// value that missed it.
    #[test]
    fn the_theoretical_gap_is_kept_up_to_its_limit() {
        let forms = |beta0| ClosedForms {
            theoretical_gap_rad: beta0,
            ..FORMS
        };
        let closed = |fraction: f64| name(Cause::of_closed_forms(&forms(fraction * STEADY), 0.5));
        assert_eq!(closed(0.5), None);
        assert_eq!(closed(0.5 - 1e-12), Some("insufficient-separation"));
        // Evenly spaced balls collide where β0 is above the steady gap: their motion shows that.
        assert_eq!(closed(1.3), None);
    }

    #[test]
    fn each_requirement_of_a_pair_is_kept_up_to_its_limit() {
        let of = |critical, shortfall, stress| {
            name(Cause::of_spacing(
                &FORMS,
                &spacing(critical, shortfall, stress),
                &(0.5..=1.0),
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
        // In space what sliding takes is no cause.
        let slid = spacing(usual, 0.4, 1e9);
        assert_eq!(
            name(Cause::of_spacing(&FORMS, &slid, &(0.5..=1.0), true)),
            None
        );
    }

    #[test]
    fn each_requirement_of_all_balls_is_kept_up_to_its_limit() {
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
        assert_eq!(of(1.0, 0.001, 0.9), Some("gap-not-retained"));
        // What is not known is no pass.
        assert_eq!(of(f64::NAN, 0.02, 0.1), Some("failed"));
    }

    /// Name of a cause, by how much its limit is missed, and what it says.
    fn says(cause: Option<Cause>, name: &str, excess: f64, text: &str) {
        let cause = cause.unwrap();
        assert_eq!(cause.name(), name);
        assert!((cause.excess() - excess).abs() < 1e-12, "{cause:?}");
        assert!(cause.to_string().contains(text), "{cause}");
    }

    #[test]
    fn causes_of_a_pair_say_their_value_and_their_excess() {
        let of = |critical, shortfall, stress| {
            let spacing = spacing(critical, shortfall, stress);
            Cause::of_spacing(&FORMS, &spacing, &(0.5..=1.0), false)
        };
        let below = "the critical gap is 40.0 % of the steady-state gap (50 to 100 % needed";
        says(of(0.016, 0.0, 0.0), "insufficient-separation", 0.1, below);
        let above = "the critical gap is 125.0 % of the steady-state gap";
        says(of(0.05, 0.0, 0.0), "excessive-separation", 0.25, above);
        let slid = "by 8.0 % of β0 (limit 5 %";
        says(of(0.03, 0.08, 0.0), "slips", 0.03, slid);
        let pressed = "5040 MPa (limit 4200 MPa of ISO 76";
        says(of(0.03, 0.0, 5.04e9), "stress", 0.2, pressed);
    }

    #[test]
    fn causes_of_all_balls_say_their_value_and_their_excess() {
        let of = |drop, gap, double| {
            Cause::of_motion(&motion(drop, gap, double), &spacing(0.03, 0.0, 1e9), false)
        };
        let slowed = "balls reach 70.0 %";
        says(of(0.7, 0.03, 0.0), "gross-sliding", 0.1, slowed);
        let lost = "with 30.0 % of the critical gap (50 %";
        says(of(1.0, 0.009, 0.0), "gap-not-retained", 0.2, lost);
        let hit = "35.0 % of the passages have a double collision";
        says(of(1.0, 0.03, 0.35), "double-collision", 0.1, hit);
    }

    #[test]
    fn causes_without_a_limit_have_no_measure() {
        for (cause, name) in [
            (Cause::Span, "eq-8"),
            (Cause::Path, "eq-9"),
            (Cause::Slot, "slot"),
            (Cause::Overlap, "overlap"),
            (Cause::Verdict("does not work".to_owned()), "verdict"),
            (Cause::Failed("no".to_owned()), "failed"),
        ] {
            assert_eq!((cause.name(), cause.excess()), (name, f64::INFINITY));
        }
        let kept = [Cause::Missed(LAG.of(0.4)), Cause::Missed(AXIAL_LAG.of(0.4))];
        assert_eq!(kept.map(|cause| cause.name()), ["loses-lag", "axial-load"]);
    }
}
