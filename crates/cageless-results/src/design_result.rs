//! Results of a design.

use cageless::Case;
use cageless::closed_forms::{ContactAngleEstimate, seats, span_angle_curve};
use cageless::equilibrium::{settle, solve};
use cageless::film::FilmAtRest;
use cageless::simulation::Control;
use cageless_design::critical_gap::CriticalGapError;
use cageless_design::{AxialLag, AxialLimit, Judgement, NoLag, Recommendation, axial_load_keeping};

use crate::number_text::significant;
use crate::overheating::overheating;
use crate::table::{CURVE, RECOMMENDATION};
use crate::thin_inlet::thin_inlet;
use crate::{
    AXIAL, CONTACT_ANGLE, DESIGN, FILM_VERDICT, Judged, JudgedRaceway, PASSAGES, PROFILE, Part,
    Particulars, RACEWAY, Record, Results, Subject, VERDICT,
};

/// Points of the lC–θ curve.
const CURVE_POINTS: usize = 60;

/// Results of the verdict on the raceways of a case: closed forms, verdict, `reasons`, `warnings`,
/// `passages`, each of the `raceways`, a `recommendation` near the curve of Eq. (11), and that `curve`.
pub fn design_record(
    case: &Case,
    particulars: &Particulars,
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
    let verdict = match judgement.dry {
        Some(_) => verdict.and(Results::of(FILM_VERDICT, Subject::Verdict(&judged))),
        None => verdict,
    };
    let contact_angle = contact_angle(case);
    let contact_angle = Results::of(CONTACT_ANGLE, Subject::ContactAngle(&contact_angle));
    let closed = Results::of(DESIGN, Subject::Design(case)).and(contact_angle);
    let closed = match case.raceway_form().measured {
        Some(profile) => closed.and(Results::of(PROFILE, Subject::Profile(&profile))),
        None => closed,
    };
    Record::from(closed.and(verdict))
        .with_sentences("reasons", judgement.reasons.clone())
        .with_sentences("warnings", warnings(case))
        .with_limits(&particulars.limits)
        .with_part("passages", passages(judgement.passages.as_ref()))
        .with_part("raceways", Part::Many(raceways.collect()))
        .with_part("recommendation", recommendation)
        .with_part("curve", Some(curve))
}

/// Warnings of a case at rest and of its film.
fn warnings(case: &Case) -> Vec<String> {
    let Ok(at_rest) = settle(case) else {
        return vec![];
    };
    let film = FilmAtRest::new(case, &at_rest).into_iter();
    let of_film = film.flat_map(|film| {
        let heat = overheating(&case.bearing, film.power_w);
        film.warnings().into_iter().chain(heat)
    });
    let of_film = of_film.chain(thin_inlet(case));
    at_rest.warnings(case).into_iter().chain(of_film).collect()
}

/// Results of motion in space at the points of [`cageless_design::axial_points`]: `findings` says what the
/// limits are, or why there are none, and which runs stopped.
pub fn axial_record(lags: &[AxialLag]) -> Record {
    // Where one limit is no load, those that leave less of the lag are none for the same reason.
    let limits = SHARES.iter();
    let mut limits = limits.map(|(share, text)| (axial_load_keeping(lags, *share), text));
    let without = limits.find(|(limit, _)| limit.load_n().is_none());
    let without = without.and_then(|(limit, share)| limit_text(&limit, share));
    let with_reason = |at| Some((at, stopped(at)?));
    let stopped: Vec<(&AxialLag, String)> = lags.iter().filter_map(with_reason).collect();
    let stopped = stopped.first().map(|(at, reason)| {
        format!(
            "{} of {} loads and tilts lack results, as a run stopped. The first, {} N and {} mrad: {reason}.",
            stopped.len(),
            lags.len(),
            significant(at.axial_load_n, DIGITS),
            significant(1e3 * at.tilt_x_rad, DIGITS)
        )
    });
    Record::of(AXIAL, Subject::Axial(lags))
        .with_sentences("findings", without.into_iter().chain(stopped).collect())
}

/// Reason of the first run at a load and tilt that stopped.
fn stopped(at: &AxialLag) -> Option<String> {
    match (&at.lag, &at.critical_gap_rad) {
        (Err(NoLag::Stopped(stop)), _) => {
            let (reason, advice) = (stop.reason(), stop.advice_by_key());
            Some(format!("the run stopped {reason}; {advice}"))
        }
        (_, Some(Err(CriticalGapError::Stopped(stop)))) => {
            Some(format!("a run of a pair stopped {}", stop.reason()))
        }
        _ => None,
    }
}

/// Digits of loads and tilts.
const DIGITS: usize = 6;

/// Shares of the lag whose axial loads are results.
const SHARES: [(f64, &str); 3] = [(0.75, "three quarters"), (0.5, "half"), (0.0, "nothing")];

/// Why a limit is no load; `None` if it is one.
fn limit_text(limit: &AxialLimit, share: &str) -> Option<String> {
    Some(match limit {
        AxialLimit::Load(_) => return None,
        AxialLimit::EveryLoad => {
            format!("More than {share} of the lag is left under every axial load.")
        }
        AxialLimit::EveryLoadBorne(load_n) => format!(
            "More than {share} of the lag is left up to {} N; the bearing does not bear the next axial load.",
            significant(*load_n, DIGITS)
        ),
        AxialLimit::Unknown {
            axial_load_n,
            reason,
        } => format!(
            "The axial load that leaves {share} of the lag is not known: at {} N {reason}.",
            significant(*axial_load_n, DIGITS)
        ),
    })
}

/// Estimate of the lag in the first raceway by contact angle, its balls pressed in as the most loaded one.
fn contact_angle(case: &Case) -> Option<ContactAngleEstimate> {
    let raceway = case.raceways.first()?;
    let pressed_in_m = match case.moves_in_space() {
        true => seats(case, &mut || Control::Continue(())).map_or(0.0, |seats| {
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
        let is_start = self.dimensions() == start;
        let [span, angle] = self.dimensions();
        let size = format!("lC {span:.3} mm, θ {angle:.3}°");
        match self.passes() {
            Some(true) if is_start => format!(
                "Recommended: {size} (the middle of the usable range of θ on the curve of Eq. (11), {:.2} to {:.2}°)",
                number("half_angle_min_deg"),
                number("half_angle_max_deg")
            ),
            Some(true) => format!("Recommended: {size} (best of {} tried)", number("judged")),
            _ => format!(
                "No suggestion from the closed form: none of {} raceways near {size} passes. Use design --search",
                number("judged")
            ),
        }
    }
}
