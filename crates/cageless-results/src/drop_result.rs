//! Results of one bearing of a drop.

use cageless::Case;
use cageless::simulation::RunOutcome;
use cageless::touchdown::{DropSummary, EndPower, EndState, Limit, WhirlWindow};
use serde::{Serialize, Serializer};

use crate::group::Group;
use crate::kind::Kind;
use crate::limited::{limited, limited_in_succession};
use crate::results::is_zero;
use crate::table::DROP;
use crate::{
    Cell, DropJudgement, FinishedDrop, Particulars, Quantity, Results, Stopped, Subject, value_text,
};

/// A result of drops side by side: label, value of each, unit.
pub type ShownBeside = (&'static str, Vec<String>, String);

/// Results of one bearing of a drop.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DropResult {
    /// Scalar results.
    #[serde(flatten)]
    pub results: Results,
    /// Every limit that is exceeded, or why the drop was not judged.
    #[serde(rename = "reasons", serialize_with = "reasons")]
    pub judgement: DropJudgement,
    /// Why it ended early, if it did.
    pub stopped: Option<Stopped>,
    /// Heating by the bearing at the end; `None` before the first contact.
    #[serde(skip)]
    pub end_power: Option<EndPower>,
    /// Temperatures of parts that no heat warms, which tables leave out.
    #[serde(skip)]
    pub unheated: Vec<&'static str>,
    /// Motion of the rotor and collisions between balls over time.
    pub windows: Vec<WindowRow>,
}

/// A state at the end, as files name it, in words.
pub fn end_state_text(name: &str) -> String {
    let state = EndState::from_name(name);
    state.map_or_else(String::new, |state| state.text().to_owned())
}

fn reasons<S: Serializer>(judgement: &DropJudgement, serializer: S) -> Result<S::Ok, S::Error> {
    judgement.reasons().serialize(serializer)
}

/// Motion of the rotor round the bore, and collisions between balls, in one interval.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WindowRow {
    /// Middle of the interval, ms.
    pub time_ms: f64,
    /// Whirl frequency, Hz, counter-clockwise positive.
    pub whirl_frequency_hz: f64,
    /// Fraction of the interval in contact.
    pub contact_fraction: f64,
    /// Mean contact force, N.
    pub force_mean_n: f64,
    /// Contacts between balls that began.
    pub collisions: u64,
}

impl WindowRow {
    fn new(w: &WhirlWindow) -> Self {
        Self {
            time_ms: 500.0 * (w.start_s + w.end_s),
            whirl_frequency_hz: w.frequency_hz(),
            contact_fraction: w.contact_fraction,
            force_mean_n: w.force_mean_n,
            collisions: w.collisions.all,
        }
    }
}

/// Temperatures of inner ring, balls and outer ring at the end.
const TEMPERATURES: [&str; 3] = [
    "inner_ring_temperature_c",
    "ball_temperature_c",
    "outer_ring_temperature_c",
];
/// Rise of a temperature from which heat has flowed, K.
const WARMED_K: f64 = 0.05;

/// Temperatures that are those of the start.
fn unheated(particulars: &Particulars, results: &Results) -> Vec<&'static str> {
    let parts = TEMPERATURES.into_iter().zip(particulars.parts_c());
    let cold = parts.filter(|(name, start_c)| {
        let end_c = results.value(name);
        end_c.is_some_and(|end_c| end_c - start_c < WARMED_K)
    });
    cold.map(|(name, _)| name).collect()
}

impl DropResult {
    /// Results `summary` of the drop of `case` that ended as `outcome`.
    pub fn new(
        case: &Case,
        particulars: &Particulars,
        summary: &DropSummary,
        outcome: &RunOutcome,
    ) -> Self {
        let mut finished = FinishedDrop {
            case,
            particulars,
            summary,
            outcome,
            judgement: DropJudgement::of_drop(case, summary, outcome),
        };
        if !particulars.limits.is_empty() {
            let results = Results::of(DROP, Subject::Drop(&finished));
            finished.judgement = limited(finished.judgement, &particulars.limits, &results);
        }
        let results = Results::of(DROP, Subject::Drop(&finished));
        Self {
            end_power: summary.end_power,
            unheated: unheated(particulars, &results),
            results,
            judgement: finished.judgement,
            stopped: Stopped::of(case, outcome),
            windows: summary.whirl.iter().map(WindowRow::new).collect(),
        }
    }

    /// Judges the drop by the limits on results of a succession, of which it is one drop, as well.
    pub(crate) fn judge_in_succession(&mut self, limits: &[Limit], succession: &Results) {
        let judgement = std::mem::take(&mut self.judgement);
        self.judge(limited_in_succession(judgement, limits, succession));
    }

    /// Gives the drop another verdict.
    pub fn judge(&mut self, judgement: DropJudgement) {
        self.judgement = judgement;
        let [verdict, passes] = [Kind::Text, Kind::Flag].map(|kind| self.judgement.cell(kind));
        let headline = Cell::Text(self.judgement.headline());
        self.results = std::mem::take(&mut self.results).with(&[
            ("verdict", verdict),
            ("passes", passes),
            ("headline", headline),
        ]);
    }

    /// Name of the state of the rotor at the end: `falling`, `settling`, `at-rest`, `pendulum`, `bouncing`,
    /// `forward-whirl` or `backward-whirl`.
    pub fn end_state(&self) -> &str {
        self.results.text("end_state")
    }

    /// Results of drops side by side under the headings of their groups: label, value of each drop (a dash where it
    /// has none), unit. What none of them has is left out, and zeros by symmetry are.
    pub fn groups(drops: &[&Self]) -> Vec<(&'static str, Vec<ShownBeside>)> {
        let words = |of: fn(&Self) -> String| drops.iter().map(|drop| of(drop)).collect();
        let state = (
            "state at the end",
            words(Self::end_state_text),
            String::new(),
        );
        let mut rows = vec![(Group::Rotor, state)];
        // A verdict of one drop stands above its results.
        if drops.len() > 1 {
            let verdict = (
                "verdict on the bearing",
                words(Self::verdict),
                String::new(),
            );
            rows.insert(0, (Group::Rotor, verdict));
        }
        let quantities = drops.iter().take(1).flat_map(|drop| drop.results.iter());
        let quantities = quantities.filter(|(q, _)| q.in_tables && q.kind != Kind::Numbers);
        rows.extend(quantities.filter_map(|(q, _)| Some((q.group, Self::beside(q, drops)?))));
        rows.sort_by_key(|(group, _)| *group);
        let groups = rows.chunk_by(|a, b| a.0 == b.0);
        let of = |rows: &[(Group, ShownBeside)]| {
            let listed = rows.iter().map(|(_, row)| row.clone()).collect();
            (rows[0].0.heading(), listed)
        };
        groups.map(of).collect()
    }

    /// A result of drops side by side; `None` of one that none of them shows.
    fn beside(quantity: &Quantity, drops: &[&Self]) -> Option<ShownBeside> {
        let text = |drop: &&Self| {
            let cell = drop.results.get(quantity.name)?;
            let warms = !drop.unheated.contains(&quantity.name);
            let shown = warms && (quantity.shows_zero || !is_zero(quantity, cell));
            (value_text(quantity, cell).map(|text| (text, shown)))
                .or_else(|| Some((drop.instead(quantity.name)?, true)))
        };
        let values: Vec<_> = drops.iter().map(text).collect();
        let shown = values.iter().flatten().any(|(_, shown)| *shown);
        let has_value = |drop: &&Self| drop.results.value(quantity.name).is_some();
        // Words in place of a value have no unit.
        let unit = match drops.iter().any(has_value) {
            true => quantity.printed_unit(),
            false => String::new(),
        };
        let values = values.into_iter();
        let texts = values.map(|value| value.map_or("–".to_owned(), |(text, _)| text));
        shown.then(|| (quantity.label, texts.collect(), unit))
    }

    /// PASS, FAIL or that nothing was judged.
    fn verdict(&self) -> String {
        let headline = self.judgement.headline();
        headline.split(':').next().unwrap_or_default().to_owned()
    }

    /// State of the rotor at the end, in words.
    pub fn end_state_text(&self) -> String {
        end_state_text(self.end_state())
    }

    /// Text in tables in place of a missing value of a result.
    pub fn instead(&self, name: &str) -> Option<String> {
        if name != "spin_up_ms" {
            return None;
        }
        self.results.value("first_contact_ms")?;
        let [ring, rotor] =
            ["ring_speed_rpm", "rotor_speed_rpm"].map(|name| self.results.value(name));
        Some(format!("not reached ({:.0} of {:.0} rpm)", ring?, rotor?))
    }
}
