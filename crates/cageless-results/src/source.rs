//! Sources of results.

use cageless::BallAdvance;
use cageless::RacewayForm;
use cageless::closed_forms::{ContactAngleEstimate, CurvePoint};
use cageless::equilibrium::space::SpatialEquilibrium;
use cageless::equilibrium::{Equilibrium, settle};
use cageless::film::FilmAtRest;
use cageless::passage::PassageTally;
use cageless::raceway::MeasuredFlanks;
use cageless::rating::{LubricatedRating, Rating};
use cageless::simulation::{PlaneDisplacement, RotorOutcome, RunOutcome};
use cageless::steady::SteadySummary;
use cageless::summary::Summary;
use cageless::surface::{Conformity, MeasuredRing, MeasuredSlot, MeasuredValue, PointDeviation};
use cageless::touchdown::{DropSummary, PARTS};
use cageless::verification::{Distance, Verification};
use cageless::{Case, Raceway};
use cageless_design::search::{Evaluation, Excluded, Found, Motion, OperatingPoint, SpeedMap};
use cageless_design::tolerance::{Assessment, InfluenceResult, Outcome, Samples, Tolerances};
use cageless_design::{
    AxialLag, Judgement, PassageStatistics, RacewayJudgement, RacewayVerdict, Recommendation,
    RunVerdict,
};

use crate::cell::Cell;
use crate::drop_judgement::DropJudgement;
use crate::judged::{JudgedResult, VerifiedDrop};
use crate::particulars::Particulars;

/// A static equilibrium.
pub struct Solved<'a> {
    /// The case.
    pub case: &'a Case,
    /// Particulars of the case.
    pub particulars: &'a Particulars,
    /// Equilibrium of the case.
    pub equilibrium: &'a Equilibrium,
    /// Ratings of the bearing in it.
    pub rating: Rating,
    /// Ratings with the lubricant, where there is one and the inner ring turns.
    pub lubricated: Option<LubricatedRating>,
    /// Equilibrium in space; `None` in the plane.
    pub space: Option<&'a SpatialEquilibrium>,
    /// Orbital speeds of its balls, where the inner ring drives them.
    pub advance: Option<BallAdvance>,
    /// Films of its contacts.
    pub film: Option<FilmAtRest>,
    /// Mean of the regularisation speeds of its contacts, m/s, where creep gives them.
    pub regularisation_speed_mean_m_s: Option<f64>,
    /// L10r at the least and the largest clearance in operation, in million revolutions, where it has a range and
    /// a bearing with such a clearance a life.
    pub l10r_of_range_mrev: [Option<f64>; 2],
}

impl<'a> Solved<'a> {
    /// The equilibrium of `case` ([`cageless::equilibrium::settle`]) with its ratings.
    pub fn new(
        case: &'a Case,
        particulars: &'a Particulars,
        settled: &'a SpatialEquilibrium,
    ) -> Self {
        let space = case.moves_in_space().then_some(settled);
        let rating = match space {
            Some(space) => Rating::in_space(case, space),
            None => Rating::new(case, &settled.rest),
        };
        let lubrication = particulars.lubrication.as_ref();
        Self {
            case,
            particulars,
            equilibrium: &settled.rest,
            lubricated: lubrication.and_then(|own| LubricatedRating::new(case, &rating, own)),
            rating,
            space,
            advance: BallAdvance::new(case, settled),
            film: FilmAtRest::new(case, settled),
            regularisation_speed_mean_m_s: case.regularisation_speed_mean_m_s(settled),
            l10r_of_range_mrev: match particulars.fit.and_then(|fit| fit.range) {
                Some(range) => range.probable_m.map(|m| l10r_at_clearance_mrev(case, m)),
                None => [None; 2],
            },
        }
    }
}

/// L10r of a case with another clearance in operation, in million revolutions.
fn l10r_at_clearance_mrev(case: &Case, clearance_m: f64) -> Option<f64> {
    let case = case.with_operating_clearance(clearance_m).ok()?;
    let settled = settle(&case).ok()?;
    match case.moves_in_space() {
        true => Rating::in_space(&case, &settled).l10r_mrev,
        false => Rating::new(&case, &settled.rest).l10r_mrev,
    }
}

/// The raceways of a case with their verdict.
pub struct Judged<'a> {
    /// The case.
    pub case: &'a Case,
    /// Verdict on its raceways.
    pub judgement: &'a Judgement,
}

/// One of the raceways of a case with its verdict.
pub struct JudgedRaceway<'a> {
    /// The case.
    pub case: &'a Case,
    /// The raceway.
    pub raceway: &'a Raceway,
    /// Verdict on it.
    pub judgement: &'a RacewayJudgement,
}

/// A run that has ended.
pub struct Finished<'a> {
    /// The case.
    pub case: &'a Case,
    /// How it ended.
    pub outcome: &'a RunOutcome,
    /// Statistics after the transient, if it got so far.
    pub summary: Option<&'a Summary>,
    /// Passages after the transient.
    pub passages: &'a PassageTally,
    /// Verdict on these.
    pub verdict: &'a RunVerdict,
    /// Time that the computation took, s; NaN if unknown.
    pub wall_s: f64,
}

/// A drop that has ended.
pub struct FinishedDrop<'a> {
    /// The case.
    pub case: &'a Case,
    /// Particulars of the case.
    pub particulars: &'a Particulars,
    /// Results of the drop, from t = 0 to the end of the run.
    pub summary: &'a DropSummary,
    /// How it ended.
    pub outcome: &'a RunOutcome,
    /// Verdict on it.
    pub judgement: DropJudgement,
}

/// One of several drops one after the other, onto one bearing.
pub struct SuccessiveDrop<'a> {
    /// Number of the drop, from 1.
    pub number: usize,
    /// Bearing of the rotor, from 0.
    pub bearing: usize,
    /// The case, with the clearances of this drop.
    pub case: &'a Case,
    /// Particulars of the case, with the temperatures of this drop.
    pub particulars: &'a Particulars,
    /// Heat of all interfaces in the drop, J.
    pub heat_j: f64,
    /// Time from its end to the standstill of the rotor, s; `None` without an estimate.
    pub spin_down_s: Option<f64>,
    /// Heat of this bearing in that time, J.
    pub spin_down_heat_j: Option<f64>,
    /// The rotor with its planes.
    pub rotor: &'a RotorOutcome,
    /// Temperatures of inner ring, balls and outer ring after that, °C; `None` without heat capacities.
    pub standstill_c: Option<[f64; PARTS]>,
    /// Verdict on it.
    pub judgement: DropJudgement,
}

/// A raceway that is fitted to points of its surface.
#[derive(Debug, Clone, Copy)]
pub struct FittedRaceway {
    /// Distances of the points.
    pub deviation: PointDeviation,
    /// Depth error of the middle, along the normals, m.
    pub depth_error_m: f64,
}

/// A ring that is fitted to points of its surface.
pub struct FittedRing<'a> {
    /// The fit.
    pub ring: &'a MeasuredRing,
    /// Number of points in the file.
    pub points: usize,
    /// Lines of the outliers.
    pub outlier_lines: Vec<usize>,
    /// Whether its dimensions keep to their tolerances; `None` if that is not decided.
    pub passes: Option<bool>,
    /// Verdict with its reason.
    pub headline: String,
}

/// A dimension of a measured ring.
#[derive(Debug, Clone, Copy)]
pub struct Dimension {
    /// Name of the dimension.
    pub name: &'static str,
    /// Unit of the dimension.
    pub unit: &'static str,
    /// The value measured.
    pub measured: MeasuredValue,
    /// The value on the drawing.
    pub drawn: f64,
    /// Tolerance to either side, where it has one.
    pub tolerance: Option<f64>,
}

impl Dimension {
    /// Whether it keeps to its tolerance, where it has one.
    pub fn conformity(&self) -> Option<Conformity> {
        let error = self.measured.plus(-self.drawn);
        self.tolerance
            .map(|tolerance| Conformity::of(error, tolerance))
    }
}

/// A bearing within tolerances.
pub struct Tolerated<'a> {
    /// The case.
    pub case: &'a Case,
    /// Particulars of the case.
    pub particulars: &'a Particulars,
    /// Grade of the balls by ISO 3290-1, 0 for equal ones.
    pub ball_grade: u32,
    /// Judgement of the bearings that deviate.
    pub assessment: &'a Assessment,
}

/// One influence that deviates alone.
pub struct Deviation<'a> {
    /// The case.
    pub case: &'a Case,
    /// Tolerances of the influences.
    pub tolerances: &'a Tolerances,
    /// Result of the influence.
    pub result: &'a InfluenceResult,
}

/// Bearings in which everything deviates.
pub struct Sampled<'a> {
    /// The bearings.
    pub samples: &'a Samples,
    /// Seed of their deviations.
    pub seed: u64,
}

/// Bearings with the same verdict.
pub struct CountedVerdict<'a> {
    /// The verdict.
    pub verdict: RacewayVerdict,
    /// The bearings.
    pub outcomes: Vec<&'a Outcome>,
}

/// A search for a raceway.
pub struct Searched<'a> {
    /// The case.
    pub case: &'a Case,
    /// Seed of its uneven starts.
    pub seed: u64,
    /// Result of the search.
    pub found: &'a Found,
    /// lC, m, and θ, rad, of the curve of Eq. (11).
    pub curve: Vec<(f64, f64)>,
}

/// A structure at one of the operating points.
pub struct AtPoint<'a> {
    /// The structure.
    pub evaluation: &'a Evaluation,
    /// Number of the point, from 0.
    pub point: usize,
}

/// Angular positions of raceways with the structures there.
pub struct SearchedPlacement<'a> {
    /// ψ of the middles, rad.
    pub centres_rad: &'a [f64],
    /// Shape and blend.
    pub form: &'a RacewayForm,
    /// αg by which the sections are turned, rad.
    pub section_angle_rad: f64,
    /// The structures.
    pub evaluations: Vec<&'a Evaluation>,
}

macro_rules! sources {
    ($($name:ident($any:ty, $one:ty) $meaning:literal,)*) => {
        /// Function that gives a quantity, by what it is computed from.
        #[derive(Debug, Clone, Copy)]
        pub(crate) enum Source {
            $($name(fn(&$any) -> Cell),)*
        }

        /// Subject of the computation of results.
        #[derive(Clone, Copy)]
        pub enum Subject<'a> {
            $(#[doc = $meaning] $name(&'a $one),)*
        }

        impl Source {
            /// Value of the quantity; `None` where it is computed from something else.
            pub(crate) fn value(self, subject: Subject<'_>) -> Option<Cell> {
                match (self, subject) {
                    $((Self::$name(of), Subject::$name(subject)) => Some(of(subject)),)*
                    _ => None,
                }
            }
        }
    };
}

sources! {
    Static(Solved<'_>, Solved<'a>) "A static equilibrium.",
    Design(Case, Case) "A case, by closed forms.",
    ContactAngle(Option<ContactAngleEstimate>, Option<ContactAngleEstimate>) "What a contact angle leaves of a raceway.",
    Profile(MeasuredFlanks, MeasuredFlanks) "The profile of a measured raceway.",
    Points(FittedRaceway, FittedRaceway) "A raceway fitted to points of its surface.",
    Slot(MeasuredSlot, MeasuredSlot) "A slot fitted to points of its edges.",
    Ring(FittedRing<'_>, FittedRing<'a>) "A ring fitted to points of its surface.",
    Dimension(Dimension, Dimension) "A dimension of it.",
    Axial([AxialLag], [AxialLag]) "Lags under axial load and tilt.",
    Curve([CurvePoint], [CurvePoint]) "The lC–θ curve of Zhao 2022, Fig. 5.",
    Verdict(Judged<'_>, Judged<'a>) "The raceways of a case with their verdict.",
    Raceway(JudgedRaceway<'_>, JudgedRaceway<'a>) "One of these raceways.",
    Passages(PassageStatistics, PassageStatistics) "Passages of a verdict.",
    Recommendation(Recommendation, Recommendation) "A raceway near the curve of Eq. (11).",
    Run(Finished<'_>, Finished<'a>) "A run.",
    Drop(FinishedDrop<'_>, FinishedDrop<'a>) "A drop onto one bearing.",
    Tolerance(Tolerated<'_>, Tolerated<'a>) "A bearing within tolerances.",
    Influence(Deviation<'_>, Deviation<'a>) "One influence that deviates alone.",
    Samples(Sampled<'_>, Sampled<'a>) "Bearings in which everything deviates.",
    VerdictCount(CountedVerdict<'_>, CountedVerdict<'a>) "Those of them with one verdict.",
    Search(Searched<'_>, Searched<'a>) "A search for a raceway.",
    Point(OperatingPoint, OperatingPoint) "One of its operating points.",
    Structure(Evaluation, Evaluation) "One of its structures.",
    StructureAt(AtPoint<'_>, AtPoint<'a>) "A structure at an operating point.",
    Motion((Motion, f64), (Motion, f64)) "A motion of all balls, and the steady-state gap, rad.",
    Rejection(Excluded, Excluded) "A requirement and the number of structures it excludes.",
    Placement(SearchedPlacement<'_>, SearchedPlacement<'a>) "Angular positions that are tried.",
    Map(SpeedMap, SpeedMap) "Critical gaps and verdicts over lC and θ.",
    Paper((String, [f64; 2]), (String, [f64; 2])) "Letter, lC (mm) and θ (°) of a structure of the paper.",
    Steady(SteadySummary, SteadySummary) "Contacts and forces of steady operation.",
    Vibration(f64, f64) "RMS of the acceleration of the housing, m/s².",
    Verified(Verification, Verification) "The verification of a run.",
    DropVerified(VerifiedDrop, VerifiedDrop) "The verification of a drop in one bearing.",
    Judged(JudgedResult, JudgedResult) "The judgement of one of its results.",
    RotorVerified([f64; 2], [f64; 2]) "Energy balance errors of the rotor of a drop and at half the step.",
    Distance([Distance], [Distance]) "Distances of replicas from the run.",
    Si(f64, f64) "A value in SI.",
    Plane(PlaneDisplacement, PlaneDisplacement) "A plane of a rotor with a clearance to the stator.",
    Succession(SuccessiveDrop<'_>, SuccessiveDrop<'a>) "One of several drops one after the other.",
    RotorDrop(RotorOutcome, RotorOutcome) "The rotor of a drop.",
}
