//! Outer rings compared from the same starts with the same lots of balls (Zhao 2022,
//! Section 5).

use cageless_io::estimate::Estimate;
use serde::{Deserialize, Serialize};

use crate::data::{Provenance, RacewayLabel};
use crate::table::Table;

/// Rings, lots of balls and speeds, each combination from several starts.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct RingComparison {
    /// One cell per combination: by speed, lot and ring, the conventional ring first.
    pub cells: Vec<ComparisonCell>,
    /// Sampling of the starts and lots.
    pub starts: String,
    /// Command that gives the numbers again.
    pub command: String,
    /// Commands that found the raceways.
    pub search_commands: Vec<String>,
    /// Differences of the model from the paper's experiment.
    pub left_out: Vec<String>,
    /// Provenance.
    pub provenance: Provenance,
}

/// One ring with one lot of balls at one speed: means over the starts.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ComparisonCell {
    /// Speed of the inner ring, rpm.
    pub speed_rpm: f64,
    /// `equal balls`, or the grade of ISO 3290-1: `G5`.
    pub lot: String,
    /// VDwL of the grade, µm; 0 for equal balls.
    pub lot_diameter_variation_um: f64,
    /// `conventional`, `structure (d)`, `found by search`.
    pub ring: String,
    /// The discrete raceway; `None` for the conventional ring.
    pub raceway: Option<RacewayLabel>,
    /// Vibration, gaps and contacts.
    #[serde(flatten)]
    pub numbers: RingNumbers,
    /// Mean approach speed of a contact, m/s; `None` without contacts.
    pub approach_speed_m_s: Option<Estimate>,
    /// Mean impulse of a contact, N·s; `None` without contacts.
    pub impulse_n_s: Option<Estimate>,
    /// Density of the contacts over that of contacts spread evenly: at 60° < |ψ| < 150°, within 30°
    /// and within 15° of the ends of the load zone; `None` without contacts.
    pub transition_density: [Option<Estimate>; 3],
    /// Last quarter of the record less the first and less the second, start by start, transient
    /// included.
    pub last_quarter_less: [RecordChange; 2],
    /// Differences from the conventional ring, start by start; `None` for that itself.
    pub difference: Option<RingNumbers>,
}

/// Change over time within a record.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct RecordChange {
    /// RMS of the acceleration of the housing, m/s².
    pub rms_m_s2: Estimate,
    /// Contacts between balls per second.
    pub contacts_per_s: Estimate,
    /// Sum of the impulses of the contacts per second, N.
    pub impulse_rate_n: Estimate,
}

/// Vibration, gaps and contacts of a ring, or of a ring less the conventional one with the same balls
/// from the same starts.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct RingNumbers {
    /// RMS of the vertical acceleration of the housing, m/s².
    pub rms_m_s2: Estimate,
    /// RMS of the part at the multiples of the orbital frequency, m/s²; with the part between, start by
    /// start, its square adds up to that of the whole.
    pub rms_at_passing_m_s2: Estimate,
    /// RMS of the part between the multiples of the orbital frequency, m/s².
    pub rms_between_m_s2: Estimate,
    /// RMS of the acceleration under a force from which the contacts between balls are cut out,
    /// m/s².
    pub rms_without_contacts_m_s2: Estimate,
    /// RMS of the acceleration under what was cut out, m/s².
    pub rms_from_contacts_m_s2: Estimate,
    /// Standard deviation of the gaps at the end, degrees.
    pub gap_deviation_deg: Estimate,
    /// Contacts between balls per second.
    pub contacts_per_s: Estimate,
    /// Sum of the impulses of the contacts per second, N.
    pub impulse_rate_n: Estimate,
}

impl RingComparison {
    /// The speeds, in the order of the cells.
    pub fn speeds_rpm(&self) -> Vec<f64> {
        let mut speeds: Vec<f64> = self.cells.iter().map(|c| c.speed_rpm).collect();
        speeds.dedup();
        speeds
    }

    /// The cells of one speed.
    pub fn at_speed(&self, speed_rpm: f64) -> impl Iterator<Item = &ComparisonCell> {
        self.cells.iter().filter(move |c| c.speed_rpm == speed_rpm)
    }

    /// For each speed a table of the vibration and one of gaps and contacts.
    pub fn tables(&self) -> Vec<Table> {
        let of_speed = |speed_rpm| {
            [
                self.table(
                    &format!("Housing at {speed_rpm} rpm"),
                    "RMS of the vertical acceleration of the housing, its part at the multiples of the \
                     orbital frequency and the part between them; the same under a force without the \
                     contacts between balls, and under the contacts alone.",
                    &[("RMS acceleration (m/s²)", 5)],
                    &VIBRATION,
                    speed_rpm,
                ),
                self.table(
                    &format!("Gaps and contacts at {speed_rpm} rpm"),
                    "Standard deviation (SD) of the gaps at the end; contacts between balls, their mean \
                     approach speed and impulse, and the sum of the impulses per second.",
                    &[("Gaps", 1), ("Contacts between balls", 4)],
                    &CONTACTS,
                    speed_rpm,
                ),
            ]
        };
        self.speeds_rpm().into_iter().flat_map(of_speed).collect()
    }

    fn table(
        &self,
        label: &str,
        caption: &str,
        groups: &[(&str, usize)],
        columns: &[Column],
        speed_rpm: f64,
    ) -> Table {
        let head = ["Balls", "Outer ring"].into_iter();
        let head = head.chain(columns.iter().map(|(name, ..)| *name));
        let mut rows = vec![head.map(str::to_owned).collect()];
        let mut last = "";
        for cell in self.at_speed(speed_rpm) {
            let lot = if cell.lot == last { "" } else { &cell.lot };
            last = &cell.lot;
            let numbers = columns.iter().map(|(_, by, of)| scaled(of(cell), *by));
            let first = [lot.to_owned(), cell.ring_text()];
            rows.push(first.into_iter().chain(numbers).collect());
        }
        let caption = format!("{caption} Means over the starts ± their standard error.");
        let groups = [("", 2)].iter().chain(groups);
        Table {
            groups: groups
                .map(|(text, count)| ((*text).to_owned(), *count))
                .collect(),
            ..Table::of(label, &caption, rows, Some(self.provenance.clone()))
        }
    }
}

/// A column of a table: heading, factor of its unit, number.
type Column = (&'static str, f64, fn(&ComparisonCell) -> Option<Estimate>);

const VIBRATION: [Column; 5] = [
    ("all", 1.0, |c| Some(c.numbers.rms_m_s2)),
    ("at passing", 1.0, |c| Some(c.numbers.rms_at_passing_m_s2)),
    ("between", 1.0, |c| Some(c.numbers.rms_between_m_s2)),
    ("contacts cut out", 1.0, |c| {
        Some(c.numbers.rms_without_contacts_m_s2)
    }),
    ("contacts alone", 1.0, |c| {
        Some(c.numbers.rms_from_contacts_m_s2)
    }),
];

const CONTACTS: [Column; 5] = [
    ("SD at the end (°)", 1.0, |c| {
        Some(c.numbers.gap_deviation_deg)
    }),
    ("per second", 1.0, |c| Some(c.numbers.contacts_per_s)),
    ("approach (mm/s)", 1e3, |c| c.approach_speed_m_s),
    ("impulse (mN·s)", 1e3, |c| c.impulse_n_s),
    ("impulses per second (N)", 1.0, |c| {
        Some(c.numbers.impulse_rate_n)
    }),
];

/// An estimate in a unit `by` times as large, with its standard error; a dash for none.
fn scaled(value: Option<Estimate>, by: f64) -> String {
    value.map_or("–".to_owned(), |e| {
        Estimate {
            mean: e.mean * by,
            standard_error: e.standard_error * by,
            ..e
        }
        .text()
    })
}

impl ComparisonCell {
    /// Name of the ring with the dimensions of its raceway.
    pub fn ring_text(&self) -> String {
        match &self.raceway {
            Some(r) => format!(
                "{}: {} mm, {}°",
                self.ring, r.axial_span_mm, r.half_angle_deg
            ),
            None => self.ring.clone(),
        }
    }
}
