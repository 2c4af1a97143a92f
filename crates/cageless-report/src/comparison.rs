//! Outer rings compared from the same starts with the same lots of balls (Zhao 2022,
//! Section 5).

use cageless_io::estimate::Estimate;
use serde::Serialize;

use crate::data::{Provenance, RacewayLabel};
use crate::table::{Cell, Row, Table};

/// Rings, lots of balls and speeds, each combination from several starts.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
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
#[derive(Debug, Clone, PartialEq, Serialize)]
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
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
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
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct RingNumbers {
    /// RMS of the vertical acceleration of the housing, m/s².
    pub rms_m_s2: Estimate,
    /// Its part at the multiples of the orbital frequency, m/s²; with the part between, start by
    /// start, its square adds up to that of the RMS.
    pub rms_at_passing_m_s2: Estimate,
    /// Its part between the multiples of the orbital frequency, m/s².
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
        self.speeds_rpm()
            .into_iter()
            .flat_map(|speed_rpm| [self.vibration(speed_rpm), self.contacts(speed_rpm)])
            .collect()
    }

    fn vibration(&self, speed_rpm: f64) -> Table {
        let columns = [
            "all",
            "at passing",
            "between",
            "contacts cut out",
            "contacts alone",
        ];
        self.table(
            format!("Housing at {speed_rpm} rpm"),
            "RMS of the vertical acceleration of the housing, its part at the multiples of the \
             orbital frequency and the part between them; the same under a force without the \
             contacts between balls, and under the contacts alone.",
            &[("RMS acceleration (m/s²)", 5)],
            &columns,
            ComparisonCell::vibration,
            speed_rpm,
        )
    }

    fn contacts(&self, speed_rpm: f64) -> Table {
        let columns = [
            "SD at the end (°)",
            "per second",
            "approach (mm/s)",
            "impulse (mN·s)",
            "impulses per second (N)",
        ];
        self.table(
            format!("Gaps and contacts at {speed_rpm} rpm"),
            "Standard deviation (SD) of the gaps at the end; contacts between balls, their mean \
             approach speed and impulse, and the sum of the impulses per second.",
            &[("Gaps", 1), ("Contacts between balls", 4)],
            &columns,
            ComparisonCell::contacts,
            speed_rpm,
        )
    }

    fn table(
        &self,
        label: String,
        caption: &str,
        groups: &[(&str, usize)],
        columns: &[&str],
        numbers: impl Fn(&ComparisonCell) -> Vec<Cell>,
        speed_rpm: f64,
    ) -> Table {
        let names = [
            ("Balls".to_owned(), false),
            ("Outer ring".to_owned(), false),
        ];
        let mut last = String::new();
        let rows = self
            .at_speed(speed_rpm)
            .map(|c| {
                let lot = if c.lot == last {
                    String::new()
                } else {
                    last.clone_from(&c.lot);
                    c.lot.clone()
                };
                let mut cells = vec![Cell::text(lot), Cell::text(c.ring_text())];
                cells.extend(numbers(c));
                Row::from(cells)
            })
            .collect();
        let groups = groups
            .iter()
            .map(|(text, count)| ((*text).to_owned(), *count));
        Table {
            label,
            caption: format!("{caption} Means over the starts ± their standard error."),
            groups: std::iter::once((String::new(), 2)).chain(groups).collect(),
            columns: names
                .into_iter()
                .chain(columns.iter().map(|name| ((*name).to_owned(), true)))
                .collect(),
            rows,
            provenance: Some(self.provenance.clone()),
        }
    }
}

/// An estimate in a unit `by` times as large, with its standard error; a dash for none.
fn scaled(value: Option<Estimate>, by: f64) -> Cell {
    Cell::number(value.map_or("–".to_owned(), |e| {
        Estimate {
            mean: e.mean * by,
            standard_error: e.standard_error * by,
            ..e
        }
        .text()
    }))
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

    /// Cells of the table of vibration.
    fn vibration(&self) -> Vec<Cell> {
        let numbers = &self.numbers;
        [
            numbers.rms_m_s2,
            numbers.rms_at_passing_m_s2,
            numbers.rms_between_m_s2,
            numbers.rms_without_contacts_m_s2,
            numbers.rms_from_contacts_m_s2,
        ]
        .map(|e| scaled(Some(e), 1.0))
        .to_vec()
    }

    /// Cells of the table of gaps and contacts.
    fn contacts(&self) -> Vec<Cell> {
        vec![
            scaled(Some(self.numbers.gap_deviation_deg), 1.0),
            scaled(Some(self.numbers.contacts_per_s), 1.0),
            scaled(self.approach_speed_m_s, 1e3),
            scaled(self.impulse_n_s, 1e3),
            scaled(Some(self.numbers.impulse_rate_n), 1.0),
        ]
    }
}
