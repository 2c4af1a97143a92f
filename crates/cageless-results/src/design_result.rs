//! Results of a design.

use cageless::Case;
use cageless::design::{
    AxialLag, ContactAngleEstimate, Judgement, Recommendation, seats, span_angle_curve,
};
use cageless::equilibrium::{settle, solve};

use crate::table::{CURVE, RECOMMENDATION};
use crate::{
    AXIAL, CONTACT_ANGLE, DESIGN, Judged, JudgedRaceway, PASSAGES, PROFILE, Part, RACEWAY, Record,
    Results, Subject, VERDICT,
};

/// Points of the lC–θ curve.
const CURVE_POINTS: usize = 60;

/// Results of the verdict on the raceways of a case: closed forms, verdict, `reasons`, `warnings`,
/// `passages`, each of the `raceways`, a `recommendation` near the curve of Eq. (11), and that `curve`.
pub fn design_record(
    case: &Case,
    judgement: &Judgement,
    recommendation: Option<&Recommendation>,
) -> Record {
    let passages = |statistics: Option<_>| -> Part {
        let results = |s| Record::of(PASSAGES, Subject::Passages(s));
        statistics.map(results).into()
    };
    let raceways = case.raceways.iter().zip(&judgement.raceways);
    let raceways = raceways.map(|(raceway, judgement)| {
        let one = JudgedRaceway {
            case,
            raceway,
            judgement,
        };
        Record::of(RACEWAY, Subject::Raceway(&one))
            .with_part("passages", passages(judgement.passages.as_ref()))
    });
    let recommendation = recommendation.map(|r| {
        Record::of(RECOMMENDATION, Subject::Recommendation(r))
            .with_sentences("reasons", r.judgement.reasons.clone())
    });
    let curve = span_angle_curve(&case.bearing, case.raceway_form(), CURVE_POINTS);
    let curve = Record::of(CURVE, Subject::Curve(&curve));
    let judged = Judged { case, judgement };
    let verdict = Results::of(VERDICT, Subject::Verdict(&judged));
    let contact_angle = contact_angle(case);
    let contact_angle = Results::of(CONTACT_ANGLE, Subject::ContactAngle(&contact_angle));
    let closed = Results::of(DESIGN, Subject::Design(case)).and(contact_angle);
    let closed = match case.raceway_form().measured {
        Some(profile) => closed.and(Results::of(PROFILE, Subject::Profile(&profile))),
        None => closed,
    };
    Record::from(closed.and(verdict))
        .with_sentences("reasons", judgement.reasons.clone())
        .with_sentences(
            "warnings",
            settle(case).map_or(vec![], |at_rest| at_rest.warnings(case)),
        )
        .with_part("passages", passages(judgement.passages.as_ref()))
        .with_part("raceways", Part::Many(raceways.collect()))
        .with_part("recommendation", recommendation)
        .with_part("curve", Some(curve))
}

/// Results of motion in space at the points of [`cageless::design::axial_points`].
pub fn axial_record(lags: &[AxialLag]) -> Record {
    Record::of(AXIAL, Subject::Axial(lags))
}

/// What a contact angle leaves of the first raceway, its balls pressed in as the most loaded one.
fn contact_angle(case: &Case) -> Option<ContactAngleEstimate> {
    let raceway = case.raceways.first()?;
    let pressed_in_m = match case.moves_in_space() {
        true => seats(case).map_or(0.0, |seats| {
            seats.iter().map(|seat| seat[1]).fold(0.0, f64::max)
        }),
        false => solve(case).map_or(0.0, |e| {
            let most = e.outer_force_n.iter().copied().fold(0.0, f64::max);
            (most / e.outer_stiffness_n_m1_5).powf(2.0 / 3.0)
        }),
    };
    Some(ContactAngleEstimate::new(
        &case.bearing,
        raceway,
        pressed_in_m,
    ))
}

/// A record of a recommendation, read by name.
#[derive(Debug, Clone, Copy)]
pub struct Recommended<'a>(pub &'a Record);

impl Recommended<'_> {
    /// Axial span lC, mm, and half angle θ, degrees, as judged.
    pub fn dimensions(self) -> [f64; 2] {
        ["axial_span_mm", "half_angle_deg"].map(|name| self.0.results.number(name))
    }

    /// Whether the raceway passes its verdict.
    pub fn passes(self) -> Option<bool> {
        self.0.results.flag("passes")
    }

    /// Kind, size and origin of the recommendation as a sentence.
    pub fn sentence(self) -> String {
        let number = |name| self.0.results.number(name);
        let start = ["starting_axial_span_mm", "starting_half_angle_deg"].map(number);
        let size = |[span, angle]: [f64; 2]| format!("lC {span:.3} mm, θ {angle:.3}°");
        let is_start = self.dimensions() == start;
        let (size, start) = (size(self.dimensions()), size(start));
        let judged = number("judged");
        let range = format!(
            "the usable range of θ on the curve of Eq. (11), {:.2}° (sliding) to {:.2}° (three \
             balls inside)",
            number("half_angle_min_deg"),
            number("half_angle_max_deg")
        );
        match (self.passes(), is_start) {
            (Some(true), true) => format!("recommended: {size}, in the middle of {range}"),
            (Some(true), false) => format!(
                "recommended: {size}, near the starting point {start} in the middle of {range}, \
                 which fails; {judged} raceways judged"
            ),
            _ => format!(
                "nothing recommended; starting point, which fails: {size}, in the middle of \
                 {range}; {judged} raceways near it were judged and none passes; design --search \
                 looks further"
            ),
        }
    }
}
