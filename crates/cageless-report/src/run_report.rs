//! Data of the report of a run.

use cageless::Case;
use cageless::Snapshot;
use cageless::passage::Passage;
use cageless::simulation::RunOutcome;
use cageless::vibration::{FILTER_CORNER, FILTER_ORDER, Measurement, Spectrum};
use cageless_io::case_file::CaseFile;
use cageless_io::results::VERSION;
use cageless_results::{Record, Stopped};
use cageless_study::ring_path::RingPosition;
use cageless_study::run::RunRecord;
use cageless_study::{RunHistories, RunSummary, SAMPLING_HZ, lines, parameters, provenance};

use crate::data::{
    BearingOutline, FrequencyMark, Motion, Parameter, Provenance, RacewaySector, Vibration,
    VibrationSignal,
};
use crate::lead;
use crate::rotor_track::rotor_track;
use crate::run_data::{BallHistory, EnergyItem, LoadProfile, Recent, RingHistory, RunData};
use crate::text::short;
use crate::verification::VerificationTable;

/// The balls of snapshots in motion.
pub fn motion(case: &Case, title: &str, snapshots: &[Snapshot], provenance: Provenance) -> Motion {
    let over = |f: &dyn Fn(&Snapshot, usize) -> f64| -> Vec<Vec<f64>> {
        (0..case.balls())
            .map(|k| snapshots.iter().map(|s| f(s, k).to_degrees()).collect())
            .collect()
    };
    Motion {
        title: title.to_owned(),
        outline: BearingOutline::new(&case.bearing),
        sectors: case.raceways.iter().map(RacewaySector::new).collect(),
        time_s: snapshots.iter().map(|s| s.time_s).collect(),
        angle_deg: over(&|s, k| s.angle_rad[k]),
        gap_deg: over(&|s, k| s.gap_rad[k]),
        balls_before: 0,
        rotor: rotor_track(case, snapshots),
        provenance,
    }
}

/// Distance of the frequencies of a spectrum, Hz; `None` without one.
fn resolution_hz(spectrum: &Spectrum) -> Option<f64> {
    (spectrum.stretch_s > 0.0).then(|| 1.0 / spectrum.stretch_s)
}

/// A vibration signal as it is shown.
pub fn vibration_signal(name: &str, measured: &Measurement) -> VibrationSignal {
    let trace = measured.trace();
    let spectrum = measured.spectrum();
    VibrationSignal {
        name: name.to_owned(),
        time_s: trace.iter().map(|point| point[0]).collect(),
        acceleration_m_s2: trace.iter().map(|point| point[1]).collect(),
        stretch_s: measured.trace_stretch_s(),
        rms_m_s2: (measured.samples() > 0).then(|| measured.rms()),
        peak_m_s2: (measured.samples() > 0).then_some(measured.peak),
        resolution_hz: resolution_hz(&spectrum),
        averages: spectrum.stretches,
        frequency_hz: spectrum.frequency_hz,
        amplitude_m_s2: spectrum.amplitude,
    }
}

/// Frequency at which rolling balls pass a point of the outer ring.
pub fn ball_pass_mark(case: &Case) -> FrequencyMark {
    let bearing = &case.bearing;
    let orbit = case.rolling_orbit_speed_rad_s();
    FrequencyMark {
        frequency_hz: bearing.balls() as f64 * orbit / std::f64::consts::TAU,
        label: "ball passing".to_owned(),
    }
}

/// Signal processing of a vibration, for provenances.
pub fn filter_note(case: &Case) -> String {
    let housing = case.housing.as_ref().map_or(String::new(), |h| {
        format!(
            "housing {} kg, {:.1e} N/m, {} N·s/m; ",
            h.mass_kg, h.stiffness_n_m, h.damping_n_s_m
        )
    });
    format!(
        "{housing}vertical acceleration sampled at {SAMPLING_HZ} Hz behind a Butterworth low-pass \
         of order {FILTER_ORDER} with its corner at {} Hz",
        FILTER_CORNER * SAMPLING_HZ
    )
}

/// Limits exceeded, warnings, and why a run stopped.
fn warnings(summary: &RunSummary) -> Vec<String> {
    let limits = summary.limits.limits_exceeded.iter();
    let mut warnings: Vec<String> = limits
        .map(|limit| format!("limit exceeded: {limit}"))
        .collect();
    warnings.extend(summary.warnings.iter().cloned());
    warnings.extend(summary.stopped.as_ref().map(Stopped::with_advice));
    warnings
}

/// Loads of the balls over ψ after the transient, or of all where nothing is after it.
fn load_profile(case: &Case, recent: &[Snapshot], settled_after_s: f64) -> Option<LoadProfile> {
    let from = recent.partition_point(|s| s.time_s < settled_after_s);
    let after = if from < recent.len() { from } else { 0 };
    LoadProfile::new(case, &recent[after..])
}

fn ring_history(path: &[RingPosition]) -> RingHistory {
    RingHistory {
        time_s: path.iter().map(|p| p.time_s).collect(),
        x_um: path.iter().map(|p| p.x_m * 1e6).collect(),
        y_um: path.iter().map(|p| p.y_m * 1e6).collect(),
    }
}

/// Vibration of the outer ring of a run.
fn vibration(case: &Case, measured: &Measurement, of_run: &Provenance) -> Vibration {
    Vibration {
        signals: vec![vibration_signal("outer ring", measured)],
        marks: vec![ball_pass_mark(case)],
        provenance: Provenance {
            discarded: format!("{}; {}", of_run.discarded, filter_note(case)),
            ..of_run.clone()
        },
    }
}

/// The discarded part of a run.
fn transient(settled_after_s: f64) -> String {
    match settled_after_s.is_finite() {
        true => format!("t < {settled_after_s:.4} s"),
        false => "nothing".to_owned(),
    }
}

fn verification_table(verification: &Record) -> VerificationTable {
    let numbers = verification.part("numbers").into_iter();
    VerificationTable::new(verification, numbers.flat_map(Record::members))
}

/// Data of the page of one run.
pub fn run_data(file: &CaseFile, record: &RunRecord) -> RunData {
    let RunRecord {
        outcome,
        summary,
        histories,
        ring_path,
        ..
    } = record;
    let (case, title) = (file.case(), file.particulars().title.as_str());
    let settled = summary.results.number("settled_after_s");
    let bearing = &case.bearing;
    let orbit = case.rolling_orbit_speed_rad_s();
    let provenance = provenance(title, case, transient(settled));
    let RunHistories {
        snapshots,
        stretch_s,
        recent,
        collisions,
        collisions_total,
    } = histories.clone().finish();
    let decimated = stretch_s.is_some();
    let shown = last_orbits(&recent, orbit, ORBITS_PLAYED);
    let Recent { time_s, balls } = histories_of(&snapshots, case.balls());
    RunData {
        // A seed beyond the whole numbers of TOML leaves the page without a studio.
        case_toml: file.document().to_toml().unwrap_or_default(),
        title: if title.is_empty() { "Run" } else { title }.to_owned(),
        software: format!("Cageless {VERSION}, {}", outcome.instruction_set.name()),
        lead: lead(case, outcome),
        warnings: warnings(summary),
        parameters: parameters(file),
        passes: summary.passes(),
        headline: summary.headline().to_owned(),
        results: lines(summary.results.rows()),
        outline: BearingOutline::new(bearing),
        sectors: case.raceways.iter().map(RacewaySector::new).collect(),
        settled_after_s: settled,
        uniform_gap_deg: bearing.nominal_gap_rad().to_degrees(),
        rolling_orbit_speed_deg_s: Some(orbit.to_degrees()),
        time_s,
        balls,
        stretch_s,
        recent: decimated.then(|| histories_of(&recent, case.balls())),
        view_s: view(&recent, orbit),
        facts: facts(summary),
        ring: ring_history(ring_path),
        load_profile: load_profile(case, &recent, settled),
        passages: passage_stretches(&record.passages.recent, shown),
        collisions,
        collisions_total,
        energy: energy(outcome),
        verification: summary.verification.as_ref().map(verification_table),
        energy_residual_relative: Some(outcome.energy_residual_relative),
        vibration: (record.vibration()).map(|measured| vibration(case, measured, &provenance)),
        motion: (recent.len() > 1).then(|| motion(case, "", shown, provenance.clone())),
        provenance,
    }
}

impl RunData {
    /// Data of the same run for figures of these snapshots alone: consecutive rows of its tables.
    pub fn within(&self, snapshots: &[Snapshot]) -> Self {
        let begin = snapshots.first().map_or(0.0, |s| s.time_s);
        let end = snapshots.last().map_or(0.0, |s| s.time_s);
        let Recent { time_s, balls } = histories_of(snapshots, self.balls.len());
        let mut collisions = self.collisions.clone();
        collisions.retain(|c| (begin..=end).contains(&c.time_s));
        let mut vibration = self.vibration.clone();
        for signal in vibration.iter_mut().flat_map(|v| &mut v.signals) {
            let from = signal.time_s.partition_point(|t| *t < begin);
            let to = signal.time_s.partition_point(|t| *t <= end);
            signal.time_s = signal.time_s[from..to].to_vec();
            signal.acceleration_m_s2 = signal.acceleration_m_s2[from..to].to_vec();
        }
        Self {
            time_s,
            balls,
            stretch_s: None,
            recent: None,
            view_s: None,
            ring: self.ring_within(snapshots, begin, end),
            collisions_total: collisions.len(),
            collisions,
            vibration,
            ..self.clone()
        }
    }

    /// The fine path of the inner ring where it was recorded, else its rows.
    fn ring_within(&self, snapshots: &[Snapshot], begin: f64, end: f64) -> RingHistory {
        let RingHistory { time_s, x_um, y_um } = &self.ring;
        let from = time_s.partition_point(|t| *t < begin);
        let to = time_s.partition_point(|t| *t <= end);
        if to - from > snapshots.len() {
            return RingHistory {
                time_s: time_s[from..to].to_vec(),
                x_um: x_um[from..to].to_vec(),
                y_um: y_um[from..to].to_vec(),
            };
        }
        RingHistory {
            time_s: snapshots.iter().map(|s| s.time_s).collect(),
            x_um: snapshots.iter().map(|s| s.ring.x_m * 1e6).collect(),
            y_um: snapshots.iter().map(|s| s.ring.y_m * 1e6).collect(),
        }
    }

    /// Data of the same run for figures of the balls with these indices from 0 alone.
    pub fn of_balls(&self, balls: &[usize]) -> Self {
        let chosen = |ball: usize| balls.contains(&ball);
        let mut data = self.clone();
        let recent = data.recent.iter_mut().map(|part| &mut part.balls);
        for all in recent.chain([&mut data.balls]) {
            let others = all.iter_mut().enumerate().filter(|(k, _)| !chosen(*k));
            others.for_each(|(_, ball)| *ball = BallHistory::default());
        }
        (data.collisions).retain(|c| chosen(c.ball - 1) || chosen(c.next_ball - 1));
        data.collisions_total = data.collisions.len();
        data
    }
}

/// Orbits of the balls that the animation has.
const ORBITS_PLAYED: f64 = 16.0;
/// Orbits of the balls that histories show first.
const ORBITS_SHOWN: f64 = 3.0;

/// The last orbits: the motion drawing interpolates, so samples must be close.
fn last_orbits(recent: &[Snapshot], orbit_rad_s: f64, orbits: f64) -> &[Snapshot] {
    let end = recent.last().map_or(0.0, |s| s.time_s);
    let from = end - orbits * std::f64::consts::TAU / orbit_rad_s;
    &recent[recent.partition_point(|s| s.time_s < from)..]
}

/// The stretch of time that histories show first; `None` if that is all there is.
fn view(recent: &[Snapshot], orbit_rad_s: f64) -> Option<[f64; 2]> {
    let last = last_orbits(recent, orbit_rad_s, ORBITS_SHOWN);
    let stretch = [last.first()?.time_s, last.last()?.time_s];
    (last.len() > 20 && stretch[0] > recent.first()?.time_s).then_some(stretch)
}

/// The passages within the recorded motion, each with a little before and after it.
fn passage_stretches(
    passages: &std::collections::VecDeque<Passage>,
    shown: &[Snapshot],
) -> Vec<(String, [f64; 2])> {
    let (Some(first), Some(last)) = (shown.first(), shown.last()) else {
        return vec![];
    };
    passages
        .iter()
        .filter(|p| p.enter_s >= first.time_s && p.leave_s <= last.time_s)
        .map(|p| {
            let hits = match (p.collisions_behind > 0, p.collisions_ahead > 0) {
                (true, true) => "double collision",
                (true, false) => "hit from behind",
                (false, true) => "hits the ball ahead",
                (false, false) => "free",
            };
            let room = 0.25 * (p.leave_s - p.enter_s);
            (
                format!("passage of ball {}, {:.4} s, {hits}", p.ball + 1, p.enter_s),
                [p.enter_s - room, p.leave_s + room],
            )
        })
        .collect()
}

/// Key numbers of a run, those with a bearing on the verdict first.
const FACTS: [&str; 6] = [
    "double_collision_fraction",
    "collisions",
    "power_loss_w",
    "inner_pressure_max_mpa",
    "outer_pressure_max_mpa",
    "ball_pressure_max_mpa",
];

/// The key numbers that have a value.
fn facts(summary: &RunSummary) -> Vec<Parameter> {
    lines(FACTS.iter().filter_map(|name| summary.results.row(name)))
}

fn lead(case: &Case, outcome: &RunOutcome) -> String {
    format!(
        "{}, {}, {}: {} s simulated. {}",
        lead::balls(case),
        lead::operation(case),
        if case.raceways.is_empty() {
            "conventional outer ring"
        } else {
            "discrete raceway"
        },
        short(outcome.end_s),
        case.operation.view(),
    )
    .trim_end()
    .to_owned()
}

/// Histories of all balls, row by row.
fn histories_of(snapshots: &[Snapshot], balls: usize) -> Recent {
    Recent {
        time_s: snapshots.iter().map(|s| s.time_s).collect(),
        balls: (0..balls).map(|k| ball_history(snapshots, k)).collect(),
    }
}

fn ball_history(snapshots: &[Snapshot], k: usize) -> BallHistory {
    let over = |f: &dyn Fn(&Snapshot) -> f64| snapshots.iter().map(f).collect::<Vec<f64>>();
    let in_space = snapshots.iter().all(Snapshot::is_in_space);
    let spatial = |f: &dyn Fn(&Snapshot) -> f64| if in_space { over(f) } else { vec![] };
    BallHistory {
        angle_deg: over(&|s| s.angle_rad[k].to_degrees()),
        gap_deg: over(&|s| s.gap_rad[k].to_degrees()),
        orbit_speed_deg_s: over(&|s| s.orbit_speed_rad_s[k].to_degrees()),
        inner_sliding_m_s: over(&|s| s.inner_sliding_m_s[k]),
        outer_sliding_m_s: over(&|s| s.outer_sliding_m_s[k]),
        inner_force_n: over(&|s| s.inner_force_n[k]),
        outer_force_n: over(&|s| s.outer_force_n[k]),
        x_mm: over(&|s| s.x_m[k] * 1e3),
        vx_m_s: over(&|s| s.vx_m_s[k]),
        vy_m_s: over(&|s| s.vy_m_s[k]),
        distance_m: spatial(&|s| s.place_in_outer_ring_m(k)[0]),
        z_m: spatial(&|s| s.place_in_outer_ring_m(k)[1]),
        inner_contact_angle_rad: spatial(&|s| s.inner_contact_angle_rad[k]),
    }
}

/// The ledger; positive into the bearing.
fn energy(outcome: &RunOutcome) -> Vec<EnergyItem> {
    let item = |name, energy_j| EnergyItem { name, energy_j };
    let layout = outcome.state.layout();
    let terms = layout.energy_terms().iter().map(|&work| {
        let value = outcome.state.energy_term_j(work);
        let energy_j = if work.is_loss() { -value } else { value };
        item(work.name().replace('_', " "), energy_j)
    });
    let stored_j = -(outcome.end_energy_j - outcome.start_energy_j);
    let stored = item("stored (kinetic, elastic)".to_owned(), stored_j);
    let terms = terms.filter(|item| item.energy_j != 0.0);
    terms.chain([stored]).collect()
}
