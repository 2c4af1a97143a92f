//! Verdict on a drop, with its reasons.

use cageless::contact::STRESS_LIMIT_PA;
use cageless::rating::BasicRatings;
use cageless::simulation::{Ending, RESIDUAL_FRACTION, RotorOutcome, RunOutcome};
use cageless::touchdown::{DropSummary, EndState, JUDGED_AFTER_S, Whirl};
use cageless::{Case, Shaft, Support};

use crate::Stopped;
use crate::bearing_number::on_bearing;
use crate::cell::Cell;
use crate::kind::Kind;
use crate::number_text::short;
use crate::unit::rpm;

/// Verdict on a drop.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct DropJudgement {
    /// Whether the rotor has touched the inner ring.
    touched: bool,
    /// Whether the rotor will rest on the bearing.
    carries: bool,
    /// Every limit that is exceeded.
    failed: Vec<String>,
    /// Reasons of a missing verdict, unless a limit is exceeded. They are a limit on a result without a
    /// value, by the name of the result, or that the drop was interrupted, with no name.
    unjudged: Vec<(String, String)>,
    /// Stop of a run outside the physical range, which is said beside limits that are exceeded.
    stopped: Vec<String>,
    /// Grounds of the verdict of a drop that passes.
    kept: Vec<String>,
}

impl DropJudgement {
    /// Whether bearing and rotor survive the drop; `None` where it was not judged.
    pub fn passes(&self) -> Option<bool> {
        match (self.failed.is_empty(), self.unjudged.is_empty()) {
            (false, _) => Some(false),
            (true, true) if self.touched => Some(true),
            _ => None,
        }
    }

    /// Compliance with all limits, touched or not; `None` where something could not be judged.
    pub(crate) fn keeps(&self) -> Option<bool> {
        match (self.failed.is_empty(), self.unjudged.is_empty()) {
            (false, _) => Some(false),
            (true, true) => Some(true),
            (true, false) => None,
        }
    }

    /// Every limit that is exceeded, after a stop outside the physical range; or why the drop was not judged.
    pub fn reasons(&self) -> Vec<String> {
        if !self.failed.is_empty() {
            return [&self.stopped[..], &self.failed].concat();
        }
        let unjudged = self.unjudged.iter().map(|(_, text)| text.clone());
        let untouched = (!self.touched).then(untouched);
        untouched.into_iter().chain(unjudged).collect()
    }

    /// The verdict in files: `pass`, `fail` or `not-judged`.
    pub fn name(&self) -> &'static str {
        match self.passes() {
            Some(true) => "pass",
            Some(false) => "fail",
            None => "not-judged",
        }
    }

    /// The verdict as a result: whether the drop passes, or its name.
    pub(crate) fn cell(&self, kind: Kind) -> Cell {
        match kind {
            Kind::Flag => self
                .passes()
                .map_or(Cell::Null, |passes| Cell::Integer(passes.into())),
            _ => Cell::Text(self.name().to_owned()),
        }
    }

    /// PASS or FAIL with its reasons.
    pub fn headline(&self) -> String {
        let (word, reasons) = match self.passes() {
            Some(true) => ("PASS", self.kept.clone()),
            Some(false) => ("FAIL", self.reasons()),
            None => ("not judged", self.reasons()),
        };
        format!("{word}: {}", reasons.join("; "))
    }

    /// Verdict on a drop onto one bearing.
    pub fn of_drop(case: &Case, summary: &DropSummary, outcome: &RunOutcome) -> Self {
        let mut failed = vec![];
        let mut kept = vec![];
        let (mut unjudged, mut stopped) = (vec![], vec![]);
        match Stopped::of(case, outcome) {
            Some(stop) if !gave_way(outcome) => {
                unjudged.push((String::new(), stop.reason(case)));
                stopped.extend((!stop.is_interrupted()).then(|| stop.reason(case)));
            }
            Some(stop) => failed.push(stop.reason(case)),
            None => {}
        }
        let pressures = [
            ("at the inner raceway", summary.inner_pressure_max_pa),
            ("at the outer raceway", summary.outer_pressure_max_pa),
            ("between balls", summary.ball_pressure_max_pa),
        ];
        let mpa = |pa: f64| 1e-6 * pa;
        let limit_mpa = mpa(STRESS_LIMIT_PA);
        for (place, pressure_pa) in pressures {
            if pressure_pa.is_nan() {
                let text = format!("the contact pressure {place} is not known");
                unjudged.push((String::new(), text));
            } else if pressure_pa > STRESS_LIMIT_PA {
                let pressure_mpa = mpa(pressure_pa);
                failed.push(format!(
                    "contact pressure {place} {pressure_mpa:.0} MPa, above {limit_mpa:.0} MPa \
                     (ISO 76)"
                ));
            }
        }
        let most_mpa = pressures
            .iter()
            .fold(0.0, |most: f64, p| most.max(mpa(p.1)));
        kept.push(format!(
            "largest contact pressure {most_mpa:.0} MPa (limit {limit_mpa:.0} MPa, ISO 76)"
        ));
        if let Some(limit_m) = case
            .rotor
            .as_ref()
            .and_then(|rotor| rotor.clearance_limit_m)
        {
            let most_m = summary.rotor_displacement_max_m;
            displaced("the journal", most_m, limit_m).add_to(&mut kept, &mut failed);
        }
        failed.extend(not_carried(case, summary.rotor_weight_n));
        failed.extend(whirl(summary, outcome));
        unjudged.extend(too_short(summary, outcome));
        kept.extend(not_at_speed(summary));
        let rotor = case.rotor.as_ref();
        let lies = rotor.is_some_and(|rotor| rotor.shaft == Shaft::Horizontal);
        Self {
            touched: summary.end_state != EndState::Falling,
            carries: lies
                && summary
                    .rotor_weight_n
                    .is_some_and(|weight_n| weight_n > 0.0),
            failed,
            kept,
            unjudged,
            stopped,
        }
    }

    /// Adds a limit of a user on a result that keeps it or not.
    pub(crate) fn limit(&mut self, exceeded: bool, text: String) {
        match exceeded {
            true => self.failed.push(text),
            false => self.kept.push(text),
        }
    }

    /// Adds a limit of a user on a result without a value.
    pub(crate) fn not_judged(&mut self, result: &str, text: String) {
        self.unjudged.push((result.to_owned(), text));
    }

    /// Forgets that a result had no value.
    pub(crate) fn judge_again(&mut self, result: &str) {
        self.unjudged.retain(|(name, _)| name != result);
    }

    /// Verdict on drops one after the other by that on the first and those on the `later` ones, of which
    /// the first that does not pass counts; `missing` is why there are fewer than were asked for.
    pub fn with_later(mut self, later: &[Self], missing: Option<&String>) -> Self {
        let first = |passes: Option<bool>| {
            let mut numbered = (2..).zip(later);
            let (number, drop) = numbered.find(|(_, drop)| drop.passes() == passes)?;
            Some(format!("drop {number}: {}", drop.reasons().join("; ")))
        };
        self.failed.extend(first(Some(false)));
        let unjudged = first(None).into_iter().chain(missing.cloned());
        self.unjudged
            .extend(unjudged.map(|text| (String::new(), text)));
        if !later.is_empty() {
            let drops = 1 + later.len();
            self.kept
                .push(format!("all {drops} drops within these limits"));
        }
        self
    }

    /// Verdict on a drop by the verdicts on its bearings, and on the planes and the energy balance of the
    /// rotor.
    pub fn of_bearings(bearings: &[&Self], rotor: &RotorOutcome) -> Self {
        let mut all = Self {
            touched: bearings.iter().any(|bearing| bearing.touched),
            carries: true,
            ..Self::default()
        };
        let awaits = |bearing: &Self| all.touched && bearing.carries && !bearing.touched;
        let awaited: Vec<bool> = bearings.iter().map(|bearing| awaits(bearing)).collect();
        for (k, bearing) in bearings.iter().enumerate() {
            let number = |text: &String| on_bearing(k, bearings.len(), text);
            all.failed.extend(bearing.failed.iter().map(number));
            all.stopped.extend(bearing.stopped.iter().map(number));
            let awaited = awaited[k].then(|| (String::new(), untouched()));
            let unjudged = awaited.iter().chain(&bearing.unjudged);
            all.unjudged
                .extend(unjudged.map(|(name, text)| (name.clone(), number(text))));
            all.kept.extend(bearing.kept.iter().map(number));
        }
        all.with_rotor(rotor)
    }

    /// The verdict with that on the planes and the energy balance of the rotor.
    pub(crate) fn with_rotor(mut self, rotor: &RotorOutcome) -> Self {
        for plane in &rotor.planes {
            let (clearance, most_m) = (&plane.clearance, plane.displacement_max_m);
            displaced(&clearance.name, most_m, clearance.radial_m)
                .add_to(&mut self.kept, &mut self.failed);
        }
        let residual = rotor.energy_residual_relative;
        self.failed.extend(unbalanced(residual));
        self.unjudged.extend(not_balanced(residual));
        self
    }

    /// Verdict on a drop with that on scattered ones like it, whether they pass and in words.
    pub fn with_samples(mut self, passes: Option<bool>, text: &str) -> Self {
        let text = match (self.passes(), passes) {
            (Some(true), None | Some(false)) => format!("{text}; nominal drop {}", self.headline()),
            _ => text.to_owned(),
        };
        match passes {
            Some(true) => self.kept.insert(0, text),
            Some(false) => self.failed.push(text),
            None => self.unjudged.push((String::new(), text)),
        }
        self
    }

    /// The verdict with limits that are exceeded besides.
    pub fn failed(mut self, reasons: impl IntoIterator<Item = String>) -> Self {
        self.failed.extend(reasons);
        self
    }
}

/// Reason why a bearing that the rotor has not reached is not judged.
fn untouched() -> String {
    format!("the rotor has not touched the inner ring: {LONGER}")
}

/// Backward whirl at any time, or else a forward one up to the end whose force still grows.
fn whirl(summary: &DropSummary, outcome: &RunOutcome) -> Option<String> {
    let forward = |whirl: &&Whirl| whirl.frequency_hz * summary.rotor_speed_rad_s > 0.0;
    let growing = || {
        summary
            .end_whirl
            .as_ref()
            .filter(forward)
            .filter(|w| w.grows())
    };
    let (sense, whirl, grows) = match (&summary.backward_whirl, growing()) {
        (Some(backward), _) => ("backward", backward, ""),
        (None, growing) => ("forward", growing?, ", and growing"),
    };
    let ms = |time_s: f64| format!("{} ms", short(1e3 * time_s));
    let until = match whirl.to_s < outcome.end_s - 1e-9 {
        true => ms(whirl.to_s),
        false => format!("the end at {}", ms(outcome.end_s)),
    };
    let weight_n = summary.rotor_weight_n.filter(|weight_n| *weight_n > 0.0);
    let weights = weight_n.map_or(String::new(), |weight_n| {
        format!(", {} times its weight", short(whirl.force_max_n / weight_n))
    });
    Some(format!(
        "{sense} whirl from {} to {until} ({} Hz), with up to {} N on the rotor{weights}{grows}",
        ms(whirl.from_s),
        short(whirl.frequency_hz.abs()),
        short(whirl.force_max_n)
    ))
}

/// Reason why a drop onto a bearing ended too early for a verdict: two of a short time after the first contact, a ring
/// that slides and a rotor that sinks or rebounds.
fn too_short(summary: &DropSummary, outcome: &RunOutcome) -> Option<(String, String)> {
    let touched_s = summary.first_contact_s?;
    let after_s = outcome.end_s - touched_s;
    let open = [
        (after_s < JUDGED_AFTER_S)
            .then(|| format!("{} ms after the first contact", short(1e3 * after_s))),
        not_at_speed(summary),
        (summary.end_state == EndState::Settling).then(|| summary.end_state.text().to_owned()),
    ];
    let open: Vec<String> = open.into_iter().flatten().collect();
    (open.len() > 1).then(|| {
        let least_s = touched_s + JUDGED_AFTER_S;
        let advice = match outcome.end_s < least_s {
            true => format!("{LONGER}, {} s at least", short(least_s)),
            false => LONGER.to_owned(),
        };
        (
            String::new(),
            format!("it ends too early ({}): {advice}", open.join(", ")),
        )
    })
}

/// Advice where a drop ends too early.
const LONGER: &str = "simulate longer (solver.duration_s)";

/// The speeds of inner ring and rotor where the ring still slides at the end.
fn not_at_speed(summary: &DropSummary) -> Option<String> {
    summary.first_contact_s?;
    let [ring, rotor] = [summary.ring_speed_rad_s, summary.rotor_speed_rad_s].map(rpm);
    let slides = summary.spin_up_s.is_none();
    slides.then(|| format!("inner ring not up to speed yet ({ring:.0} of {rotor:.0} rpm)"))
}

/// A limit in a sentence.
enum Limit {
    Kept(String),
    Failed(String),
}

impl Limit {
    fn add_to(self, kept: &mut Vec<String>, failed: &mut Vec<String>) {
        match self {
            Self::Kept(sentence) => kept.push(sentence),
            Self::Failed(sentence) => failed.push(sentence),
        }
    }
}

/// A displacement against its clearance.
fn displaced(what: &str, most_m: f64, limit_m: f64) -> Limit {
    let (most, limit) = (1e6 * most_m, 1e6 * limit_m);
    let (is, verb, of_margin): (fn(String) -> Limit, _, _) = match most_m > limit_m {
        true => (Limit::Failed, "beyond", "exceeded by"),
        false => (Limit::Kept, "within", "margin"),
    };
    is(format!(
        "{what} displaced by {} µm, {verb} its clearance of {} µm ({of_margin} {} µm)",
        short(most),
        short(limit),
        short((limit - most).abs())
    ))
}

/// Whether the bearing gave way; else its computation failed or was interrupted.
fn gave_way(outcome: &RunOutcome) -> bool {
    matches!(&outcome.ending, Ending::Stopped(stop) if stop.cause.gives_way())
}

fn unbalanced(residual: f64) -> Option<String> {
    (residual.abs() > RESIDUAL_FRACTION).then(|| {
        format!(
            "energy balance error of the rotor {:.1} %, above {:.0} %: the step is too long for these \
             numbers",
            100.0 * residual.abs(),
            100.0 * RESIDUAL_FRACTION
        )
    })
}

/// A balance without a number.
fn not_balanced(residual: f64) -> Option<(String, String)> {
    let text = "the energy balance error of the rotor is not known".to_owned();
    residual.is_nan().then(|| (String::new(), text))
}

/// Why bearing or support cannot carry the weight of the rotor once it rests.
fn not_carried(case: &Case, weight_n: Option<f64>) -> Vec<String> {
    let Some(weight_n) = weight_n else {
        return vec![];
    };
    let mut reasons = vec![];
    // Rows share the load.
    let rows = case.rows.len().max(1);
    let static_rating_n = BasicRatings::of_rows(&case.bearing, rows).static_n;
    if weight_n > static_rating_n {
        reasons.push(format!(
            "the bearing cannot carry the rotor: its weight of {} N exceeds the basic static load \
             rating C0r of {} N (ISO 76)",
            short(weight_n),
            short(static_rating_n)
        ));
    }
    if let Some(support) = &case.support {
        let (sag_m, most_m) = (sag_m(support, weight_n), case.bearing.ball_radius_m());
        if sag_m > most_m {
            reasons.push(format!(
                "the support cannot carry the rotor: it yields by {} mm under its weight, more \
                 than the radius of a ball ({} mm); a stiffer support (support.stiffness_n_m) or \
                 a hard stop (support.stop_gap_um) holds it",
                short(1e3 * sag_m),
                short(1e3 * most_m)
            ));
        }
    }
    reasons
}

/// Displacement of the support under a weight at rest.
fn sag_m(support: &Support, weight_n: f64) -> f64 {
    let free_m = weight_n / support.stiffness_n_m;
    match &support.stop {
        Some(stop) if free_m > stop.gap_m => {
            let beyond_n = weight_n - support.stiffness_n_m * stop.gap_m;
            stop.gap_m + beyond_n / (support.stiffness_n_m + stop.stiffness_n_m)
        }
        _ => free_m,
    }
}
