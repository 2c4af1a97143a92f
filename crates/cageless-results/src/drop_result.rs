//! Results of one bearing of a drop.

use cageless::Case;
use cageless::simulation::RunOutcome;
use cageless::touchdown::{DropSummary, EndState, Limit, WhirlWindow};
use serde::{Serialize, Serializer};

use crate::kind::Kind;
use crate::limited::{limited, limited_in_succession};
use crate::table::DROP;
use crate::{Cell, DropJudgement, FinishedDrop, Results, Stopped, Subject, value_text};

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

impl DropResult {
    /// Results `summary` of the drop of `case` that ended as `outcome`.
    pub fn new(case: &Case, summary: &DropSummary, outcome: &RunOutcome) -> Self {
        let mut finished = FinishedDrop {
            case,
            summary,
            outcome,
            judgement: DropJudgement::of_drop(case, summary, outcome),
        };
        if !case.limits.is_empty() {
            let results = Results::of(DROP, Subject::Drop(&finished));
            finished.judgement = limited(finished.judgement, &case.limits, &results);
        }
        Self {
            results: Results::of(DROP, Subject::Drop(&finished)),
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

    /// What the rotor does at the end: `falling`, `settling`, `at-rest`, `pendulum`, `bouncing`,
    /// `forward-whirl` or `backward-whirl`.
    pub fn end_state(&self) -> &str {
        self.results.text("end_state")
    }

    /// Results of named drops as a table for readers: a column for each; the first row is the head.
    pub fn side_by_side(drops: &[(String, &Self)]) -> Vec<Vec<String>> {
        let (names, drops): (Vec<String>, Vec<&Self>) = drops.iter().cloned().unzip();
        let row = |first: &str, middle: Vec<String>, last: String| {
            let ends = (std::iter::once(first.to_owned()), std::iter::once(last));
            ends.0.chain(middle).chain(ends.1).collect()
        };
        let rows = Self::table(&drops).into_iter();
        let head = std::iter::once(row("result", names, "unit".to_owned()));
        head.chain(rows.map(|(label, values, unit)| row(label, values, unit)))
            .collect()
    }

    /// Results of drops side by side: label, value of each drop (a dash where it has none), unit.
    pub fn table(drops: &[&Self]) -> Vec<(&'static str, Vec<String>, String)> {
        let words = |of: fn(&Self) -> String| drops.iter().map(|drop| of(drop)).collect();
        let mut rows = vec![
            ("verdict", words(Self::verdict), String::new()),
            (
                "state at the end",
                words(Self::end_state_text),
                String::new(),
            ),
        ];
        let quantities = drops.iter().take(1).flat_map(|drop| drop.results.iter());
        for (quantity, _) in quantities.filter(|(q, _)| q.in_tables && q.kind != Kind::Numbers) {
            let value = |drop: &&Self| {
                let cell = drop.results.get(quantity.name)?;
                value_text(quantity, cell)
            };
            let values = drops.iter().map(|d| {
                let other = || d.instead(quantity.name).unwrap_or("–".to_owned());
                value(d).unwrap_or_else(other)
            });
            rows.push((quantity.label, values.collect(), quantity.printed_unit()));
        }
        rows
    }

    /// PASS, FAIL or that nothing was judged.
    fn verdict(&self) -> String {
        let headline = self.judgement.headline();
        headline.split(':').next().unwrap_or_default().to_owned()
    }

    /// What the rotor does at the end, in words.
    pub fn end_state_text(&self) -> String {
        end_state_text(self.end_state())
    }

    /// What stands in tables where a result has no value.
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
