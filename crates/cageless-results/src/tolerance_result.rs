//! Results of a tolerance analysis.

use cageless::Case;
use cageless_design::RacewayVerdict;
use cageless_design::tolerance::{Assessment, Tolerances};

use crate::table::{INFLUENCE, SAMPLES, TOLERANCE, VERDICT_COUNT};
use crate::{
    CountedVerdict, Deviation, Part, Particulars, Provenance, Record, Sampled, Shape, Subject,
    Tolerated, provenance,
};

/// Shape of the results of a tolerance analysis.
pub const TOLERANCE_SHAPE: Shape = Shape {
    sentences: &["warnings"],
    parts: &[
        (
            "influences",
            &Shape {
                sentences: &["verdicts"],
                ..Shape::of(INFLUENCE)
            },
        ),
        (
            "samples",
            &Shape {
                parts: &[("verdicts", &Shape::of(VERDICT_COUNT))],
                ..Shape::of(SAMPLES)
            },
        ),
    ],
    ..Shape::of(TOLERANCE)
};

/// Results of the bearing of a case within tolerances, its balls of a grade of ISO 3290-1 (0: equal
/// ones): the nominal bearing, the `influences` one at a time, and the `samples` by their `verdicts`.
pub fn tolerance_record(
    case: &Case,
    particulars: &Particulars,
    ball_grade: u32,
    tolerances: &Tolerances,
    assessment: &Assessment,
    warnings: Vec<String>,
) -> Record {
    let influences = assessment.influences.iter().map(|result| {
        let deviation = Deviation {
            case,
            tolerances,
            result,
        };
        let verdicts = result.verdicts.iter().map(|v| v.name().to_owned());
        Record::of(INFLUENCE, Subject::Influence(&deviation))
            .with_sentences("verdicts", verdicts.collect())
    });
    let samples = assessment.samples.as_ref().map(|samples| {
        // The others are listed where they came out.
        let usual = [
            RacewayVerdict::Smooth,
            RacewayVerdict::DoubleCollision,
            RacewayVerdict::Slips,
            RacewayVerdict::Infeasible,
        ];
        let listed = |at: &&(RacewayVerdict, usize)| usual.contains(&at.0) || at.1 > 0;
        let verdicts = samples.verdicts.iter().filter(listed).map(|(verdict, _)| {
            let outcomes = samples.outcomes.iter().filter(|o| o.verdict == *verdict);
            let counted = CountedVerdict {
                verdict: *verdict,
                outcomes: outcomes.collect(),
            };
            Record::of(VERDICT_COUNT, Subject::VerdictCount(&counted))
        });
        let seed = particulars.seed;
        let sampled = Sampled { samples, seed };
        Record::of(SAMPLES, Subject::Samples(&sampled))
            .with_part("verdicts", Part::Many(verdicts.collect()))
    });
    let tolerated = Tolerated {
        case,
        particulars,
        ball_grade,
        assessment,
    };
    Record::of(TOLERANCE, Subject::Tolerance(&tolerated))
        .with_sentences("warnings", warnings)
        .with_part("influences", Part::Many(influences.collect()))
        .with_part("samples", samples)
        .with_provenance(Provenance {
            discarded: "the first 16 orbits of each run".to_owned(),
            ..provenance(&particulars.title, case, String::new())
        })
}
