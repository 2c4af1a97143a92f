//! Balls and starts of the runs of a comparison.

use cageless_io::OptionError;
use cageless_io::case_file::{CaseError, CaseFile};
use cageless_io::estimate::SIGNIFICANCE;
use cageless_results::number_text::short;
use serde::Serialize;

/// Draws of each ring unless asked for otherwise: as many as run side by side.
pub const DRAWS: u64 = 8;
/// More would take days.
const MOST: u64 = 10_000;

/// Runs of each ring.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sampling {
    /// Draws of real balls in steady operation.
    Draws(u64),
    /// Uneven starts of the balls of the case, as long as the case says; nothing is judged.
    UnevenStarts(u64),
}

impl Sampling {
    /// Number of runs of each ring.
    pub fn count(self) -> u64 {
        match self {
            Self::Draws(count) | Self::UnevenStarts(count) => count,
        }
    }

    /// Refuses a number of runs of which there is no error.
    pub(super) fn check(self) -> Result<(), OptionError> {
        let name = match self {
            Self::Draws(_) => "draws",
            Self::UnevenStarts(_) => "starts",
        };
        if (2..=MOST).contains(&self.count()) {
            return Ok(());
        }
        let allowed = format!("from 2 to {MOST}");
        Err(OptionError::not_possible(name, self.count(), &allowed))
    }

    /// The case of run `number`.
    pub(super) fn sample(
        self,
        file: &CaseFile,
        seed: u64,
        number: u64,
    ) -> Result<CaseFile, CaseError> {
        match self {
            Self::Draws(_) => file.with_draw(seed, number),
            Self::UnevenStarts(_) => file.with_uneven_start(seed, number),
        }
    }
}

/// Runs of a comparison for the record.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Draws {
    /// Runs of each ring.
    pub count: u64,
    /// Seed of their balls and starts; `None` of finished runs.
    pub seed: Option<u64>,
    /// Number of the grade of the balls; `None` unless in steady operation.
    pub grade: Option<u32>,
    /// Name of the start; `None` unless in steady operation.
    pub start: Option<&'static str>,
    /// Orbits that are left out; `None` unless in steady operation.
    pub transient_orbits: Option<f64>,
    /// Orbits that are measured; `None` unless in steady operation.
    pub measured_orbits: Option<f64>,
    /// Supply of the oil film, which the case has; `None` of dry runs.
    #[serde(skip)]
    pub film_supply: Option<f64>,
}

impl Draws {
    /// Draws of a case.
    pub fn of(file: &CaseFile, sampling: Sampling) -> Self {
        let steady = Some(file.steady()).filter(|_| matches!(sampling, Sampling::Draws(_)));
        Self {
            count: sampling.count(),
            seed: Some(file.particulars().seed),
            grade: steady.map(|s| s.grade.number),
            start: steady.map(|s| s.start.name()),
            transient_orbits: steady.map(|s| s.transient_orbits),
            measured_orbits: steady.map(|s| s.measured_orbits),
            film_supply: file
                .case()
                .film
                .map(|film| film.supply)
                .filter(|supply| *supply > 0.0),
        }
    }

    /// One finished run of each ring.
    pub fn finished() -> Self {
        Self {
            count: 1,
            seed: None,
            grade: None,
            start: None,
            transient_orbits: None,
            measured_orbits: None,
            film_supply: None,
        }
    }

    /// How the rings were run.
    pub fn text(&self) -> String {
        let count = self.count;
        let means = format!(
            "Values are means ± standard error; differences are taken run by run and are significant by Student's \
             test at {} %.",
            100.0 * SIGNIFICANCE
        );
        match (self.seed, self.grade, self.measured_orbits) {
            (Some(seed), Some(grade), Some(orbits)) => format!(
                "Steady operation: {count} draws of balls of grade G{grade}, the same for every ring (seed {seed}), \
                 over {orbits} orbits after {} that are left out, from {}. {means}{}",
                self.transient_orbits.unwrap_or(0.0),
                match self.start {
                    Some("random") => "random gaps",
                    _ => "the queue in which the balls of a conventional ring end",
                },
                self.in_oil(),
            ),
            (Some(seed), ..) => format!(
                "Every ring runs from the same {count} starts: the gaps between the balls are drawn at random, each \
                 between 0 and twice the mean (seed {seed}). {means} Balls of one size keep whatever spacing they \
                 start with on a conventional ring, so that no benefit is judged."
            ),
            _ => "One run each, from the start of its own case, so that nothing is judged. Ideal balls that start \
                  evenly keep their gaps with any ring; after a contact the motion is chaotic. Compare case files \
                  instead of finished runs: they run in steady operation with the same real balls."
                .to_owned(),
        }
    }

    /// Reservation on a judgement in oil; empty of dry runs.
    fn in_oil(&self) -> String {
        self.film_supply.map_or_else(String::new, |supply| {
            let supply = short(supply);
            format!(
                " The balls run in oil (film.supply = {supply}); a raceway for oil may be wrong without: judge it dry as \
                 well, with film.supply = 0."
            )
        })
    }
}
