//! From a run to the data of its report.

use cageless::collision::Collision;
use cageless::kinematics::rolling_orbit_speed_rad_s;
use cageless::passage::Passage;
use cageless::simulation::RunOutcome;
use cageless::snapshot::Snapshot;
use cageless::state::Work;
use cageless::vibration::{
    FILTER_CORNER, FILTER_ORDER, Signal, VibrationRecorder, sample_behind_filter, spectrum,
};
use cageless::{Case, FrictionLaw, Method, Profile};
use cageless_io::case_file::CaseFile;
use cageless_io::results::{SummaryFile, VERSION};
use cageless_report::{
    BallHistory, BearingOutline, CollisionPoint, EnergyItem, FrequencyMark, Motion, Parameter,
    Provenance, RingHistory, RunData, Sector, Vibration, VibrationSignal,
};

use crate::format::shown;

/// Sampling of vibration signals, as in the paper's experiment.
pub const SAMPLING_HZ: f64 = 5000.0;

/// Most snapshots and collisions that are kept for the figures.
const KEPT: usize = 8000;

/// What the figures need of a run, thinned out as it grows: memory does not depend on
/// the length of the run.
pub struct Histories {
    snapshots: Vec<Snapshot>,
    seen: usize,
    stride: usize,
    collisions: Vec<CollisionPoint>,
    collisions_seen: usize,
}

impl Histories {
    /// Nothing yet.
    pub fn new() -> Self {
        Self {
            snapshots: vec![],
            seen: 0,
            stride: 1,
            collisions: vec![],
            collisions_seen: 0,
        }
    }

    /// Keeps a snapshot, or every second, fourth … of them.
    pub fn push(&mut self, snapshot: Snapshot) {
        if self.seen.is_multiple_of(self.stride) {
            self.snapshots.push(snapshot);
        }
        self.seen += 1;
        if self.snapshots.len() > KEPT {
            let mut k = 0;
            self.snapshots.retain(|_| {
                k += 1;
                k % 2 == 1
            });
            self.stride *= 2;
        }
    }

    /// Keeps a collision, the first few thousand of them.
    pub fn collide(&mut self, c: &Collision) {
        self.collisions_seen += 1;
        if self.collisions.len() < KEPT {
            self.collisions.push(CollisionPoint {
                time_s: c.start_s,
                ball: c.ball + 1,
                next_ball: c.next_ball + 1,
                angle_deg: c.angle_rad.to_degrees(),
                approach_speed_m_s: c.approach_speed_m_s,
                peak_force_n: c.peak_force_n,
                impulse_n_s: c.impulse_n_s,
            });
        }
    }
}

/// Name of a profile in files and figures.
pub fn profile_name(profile: Profile) -> &'static str {
    match profile {
        Profile::Paper => "paper",
        Profile::Physical => "physical",
    }
}

/// Name of a method in figures.
pub fn method_name(method: Method) -> &'static str {
    match method {
        Method::Abm4 => "ABM4",
        Method::Symplectic => "leapfrog",
        Method::Adaptive => "adaptive, order 8",
    }
}

/// Where the numbers of a simulated figure come from.
pub fn provenance(case: &Case, discarded: String) -> Provenance {
    Provenance {
        case: case.title.clone(),
        profile: Some(profile_name(case.profile).to_owned()),
        friction_law: Some(match case.contact.friction_law {
            FrictionLaw::Smooth => {
                format!("smooth, tanh(ΔV/{} m/s)", case.contact.slip_scale_m_s)
            }
            FrictionLaw::Coulomb => "Coulomb".to_owned(),
        }),
        method: Some(method_name(case.solver.method).to_owned()),
        step_us: Some(case.solver.step_s * 1e6),
        discarded,
    }
}

/// The balls of snapshots in motion.
pub fn motion(case: &Case, title: &str, snapshots: &[Snapshot], provenance: Provenance) -> Motion {
    let over = |f: &dyn Fn(&Snapshot, usize) -> f64| -> Vec<Vec<f64>> {
        (0..case.bearing.balls())
            .map(|k| snapshots.iter().map(|s| f(s, k).to_degrees()).collect())
            .collect()
    };
    Motion {
        title: title.to_owned(),
        outline: BearingOutline::of(&case.bearing),
        sectors: case.raceways.iter().map(Sector::of).collect(),
        time_s: snapshots.iter().map(|s| s.time_s).collect(),
        angle_deg: over(&|s, k| s.angle_rad[k]),
        gap_deg: over(&|s, k| s.gap_rad[k]),
        provenance,
    }
}

/// A vibration signal as it is shown: behind the filter, after the transient.
pub fn vibration_signal(name: &str, acceleration: &Signal, after_s: f64) -> VibrationSignal {
    let sampled = sample_behind_filter(acceleration, SAMPLING_HZ).after(after_s);
    let s = spectrum(&sampled);
    VibrationSignal {
        name: name.to_owned(),
        time_s: (0..sampled.values.len())
            .map(|k| sampled.time_s(k))
            .collect(),
        rms_m_s2: (!sampled.values.is_empty()).then(|| sampled.rms()),
        acceleration_m_s2: sampled.values,
        frequency_hz: s.frequency_hz,
        amplitude_m_s2: s.amplitude,
    }
}

/// Frequency at which rolling balls pass a point of the outer ring.
pub fn ball_pass_mark(case: &Case) -> FrequencyMark {
    let bearing = &case.bearing;
    let orbit = rolling_orbit_speed_rad_s(
        bearing,
        case.operation.inner_speed_rad_s,
        bearing.ball_radius_m(),
    );
    FrequencyMark {
        frequency_hz: bearing.balls() as f64 * orbit / std::f64::consts::TAU,
        label: "ball passing".to_owned(),
    }
}

/// What was done to a vibration signal, for provenances.
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

fn parameter(name: &str, value: String, unit: &str) -> Parameter {
    Parameter {
        name: name.to_owned(),
        value,
        unit: unit.to_owned(),
        ..Parameter::default()
    }
}

/// Everything on the page of one run.
pub fn run_data(
    file: &CaseFile,
    outcome: &RunOutcome,
    summary: &SummaryFile,
    histories: &Histories,
    passages: &[Passage],
    vibration: Option<&VibrationRecorder>,
) -> RunData {
    let case = file.case();
    let settled = summary.settled_after_s;
    let bearing = &case.bearing;
    let orbit = rolling_orbit_speed_rad_s(
        bearing,
        case.operation.inner_speed_rad_s,
        bearing.ball_radius_m(),
    );
    let discarded = if settled.is_finite() {
        format!("t < {settled:.4} s")
    } else {
        "nothing".to_owned()
    };
    let provenance = provenance(case, discarded.clone());
    let snapshots = &histories.snapshots;
    let mut warnings = summary.warnings.clone();
    if let Some(stopped) = &summary.stopped {
        warnings.push(format!(
            "stopped at t = {:.6} s: {}. To change: {}.",
            stopped.time_s, stopped.cause, stopped.advice
        ));
    }
    if histories.collisions_seen > histories.collisions.len() {
        warnings.push(format!(
            "figures show the first {} of {} collisions; all are in collisions.parquet",
            histories.collisions.len(),
            histories.collisions_seen
        ));
    }
    RunData {
        title: if case.title.is_empty() {
            "Run".to_owned()
        } else {
            case.title.clone()
        },
        software: format!("Cageless {VERSION}, {}", outcome.instruction_set.name()),
        lead: lead(case, outcome, summary),
        warnings,
        parameters: parameters(file),
        results: [results(summary), passage_results(passages, settled)].concat(),
        outline: BearingOutline::of(bearing),
        sectors: case.raceways.iter().map(Sector::of).collect(),
        settled_after_s: settled,
        uniform_gap_deg: bearing.uniform_gap_rad().to_degrees(),
        rolling_orbit_speed_deg_s: Some(orbit.to_degrees()),
        time_s: snapshots.iter().map(|s| s.time_s).collect(),
        balls: (0..bearing.balls())
            .map(|k| ball_history(snapshots, k))
            .collect(),
        ring: RingHistory {
            time_s: snapshots.iter().map(|s| s.time_s).collect(),
            x_um: snapshots.iter().map(|s| s.ring.x_m * 1e6).collect(),
            y_um: snapshots.iter().map(|s| s.ring.y_m * 1e6).collect(),
        },
        collisions: histories.collisions.clone(),
        energy: energy(outcome),
        certificate: summary.certificate.as_ref().map(crate::verification::table),
        energy_residual_relative: Some(outcome.energy_residual_relative),
        vibration: vibration.map(|recorder| Vibration {
            signals: vec![vibration_signal(
                "outer ring",
                &recorder.acceleration()[1],
                settled,
            )],
            marks: vec![ball_pass_mark(case)],
            provenance: Provenance {
                discarded: format!("{discarded}; {}", filter_note(case)),
                ..provenance.clone()
            },
        }),
        motion: (snapshots.len() > 1)
            .then(|| motion(case, "", &last_orbits(snapshots, orbit), provenance.clone())),
        provenance,
    }
}

/// The last few orbits: the motion drawing interpolates, so samples must be close.
fn last_orbits(snapshots: &[Snapshot], orbit_rad_s: f64) -> Vec<Snapshot> {
    const MOST: usize = 2500;
    let end = snapshots.last().map_or(0.0, |s| s.time_s);
    let from = end - 8.0 * std::f64::consts::TAU / orbit_rad_s;
    let shown: Vec<Snapshot> = snapshots
        .iter()
        .filter(|s| s.time_s >= from)
        .cloned()
        .collect();
    let skip = shown.len().saturating_sub(MOST);
    shown[skip..].to_vec()
}

fn lead(case: &Case, outcome: &RunOutcome, summary: &SummaryFile) -> String {
    let statistics = if summary.settled_after_s.is_finite() {
        format!(
            " After {:.4} s: {} contacts between balls, gaps from {:.3}° to {:.3}°, ring at \
             ({:.3}, {:.3}) µm on average.",
            summary.settled_after_s,
            summary.collisions,
            summary.gap_min_deg,
            summary.gap_max_deg,
            summary.ring_x_um_mean,
            summary.ring_y_um_mean
        )
    } else {
        String::new()
    };
    format!(
        "{} balls, {:.0} rpm, {:.0} N, {}: {:.4} s simulated in {} steps.{statistics}",
        case.bearing.balls(),
        case.operation.inner_speed_rad_s * 60.0 / std::f64::consts::TAU,
        case.operation.radial_load_n,
        if case.raceways.is_empty() {
            "conventional outer ring"
        } else {
            "discrete raceway"
        },
        outcome.end_s,
        outcome.steps,
    )
}

/// One line per key of the case.
fn parameters(file: &CaseFile) -> Vec<Parameter> {
    let mut lines = vec![];
    let document = serde_json::to_value(file.document_as_run()).unwrap_or_default();
    flatten("", &document, &mut |key, value| {
        let source = if file.defaults().iter().any(|d| d == key) {
            "default"
        } else {
            "case file"
        };
        lines.push(Parameter {
            source: source.to_owned(),
            ..parameter(key, value, "")
        });
    });
    lines
}

fn flatten(prefix: &str, value: &serde_json::Value, add: &mut impl FnMut(&str, String)) {
    match value {
        serde_json::Value::Object(map) => {
            for (key, value) in map {
                let name = if prefix.is_empty() {
                    key.clone()
                } else {
                    format!("{prefix}.{key}")
                };
                flatten(&name, value, add);
            }
        }
        serde_json::Value::String(text) => add(prefix, text.clone()),
        other => add(prefix, other.to_string()),
    }
}

/// How the balls passed the discrete raceways after the transient.
fn passage_results(passages: &[Passage], settled_s: f64) -> Vec<Parameter> {
    let steady: Vec<&Passage> = passages.iter().filter(|p| p.enter_s > settled_s).collect();
    if steady.is_empty() {
        return vec![];
    }
    let n = steady.len() as f64;
    let mean = |f: &dyn Fn(&Passage) -> f64| steady.iter().map(|p| f(p)).sum::<f64>() / n;
    let hit_by_both = |p: &Passage| p.collisions_ahead > 0 && p.collisions_behind > 0;
    vec![
        parameter(
            "passages through a discrete raceway",
            steady.len().to_string(),
            "",
        ),
        parameter(
            "time of a passage, mean",
            shown(mean(&|p| (p.leave_s - p.enter_s) * 1e3), 3, ""),
            "ms",
        ),
        parameter(
            "contacts with neighbours per passage, mean",
            shown(
                mean(&|p| f64::from(p.collisions_ahead + p.collisions_behind)),
                3,
                "",
            ),
            "",
        ),
        parameter(
            "passages hit by both neighbours",
            shown(
                100.0 * mean(&|p| f64::from(u8::from(hit_by_both(p)))),
                1,
                "",
            ),
            "%",
        ),
        parameter(
            "largest slip in a passage, mean",
            shown(mean(&|p| p.slip_max_m_s), 4, ""),
            "m/s",
        ),
        parameter(
            "smallest gap ahead in a passage, mean",
            shown(mean(&|p| p.gap_min_rad.to_degrees()), 4, ""),
            "°",
        ),
    ]
}

fn results(s: &SummaryFile) -> Vec<Parameter> {
    vec![
        parameter("collisions between balls", s.collisions.to_string(), ""),
        parameter("smallest gap", shown(s.gap_min_deg, 4, ""), "°"),
        parameter("largest gap", shown(s.gap_max_deg, 4, ""), "°"),
        parameter(
            "mean place of the ring, x",
            shown(s.ring_x_um_mean, 4, ""),
            "µm",
        ),
        parameter(
            "mean place of the ring, y",
            shown(s.ring_y_um_mean, 4, ""),
            "µm",
        ),
        parameter(
            "largest slip under load",
            shown(s.slip_max_m_s, 4, ""),
            "m/s",
        ),
        parameter(
            "energy residual over all flows",
            format!("{:.2e}", s.energy_residual_relative),
            "",
        ),
        parameter("statistics after", shown(s.settled_after_s, 5, ""), "s"),
        parameter("steps", s.steps.to_string(), ""),
        parameter(
            "evaluations of the equations",
            s.rhs_evaluations.to_string(),
            "",
        ),
    ]
}

fn ball_history(snapshots: &[Snapshot], k: usize) -> BallHistory {
    let over = |f: &dyn Fn(&Snapshot) -> f64| snapshots.iter().map(f).collect::<Vec<f64>>();
    BallHistory {
        angle_deg: over(&|s| s.angle_rad[k].to_degrees()),
        gap_deg: over(&|s| s.gap_rad[k].to_degrees()),
        orbit_speed_deg_s: over(&|s| s.orbit_speed_rad_s[k].to_degrees()),
        inner_slip_m_s: over(&|s| s.inner_slip_m_s[k]),
        outer_slip_m_s: over(&|s| s.outer_slip_m_s[k]),
        inner_force_n: over(&|s| s.inner_force_n[k]),
        outer_force_n: over(&|s| s.outer_force_n[k]),
        x_mm: over(&|s| s.x_m[k] * 1e3),
        vx_m_s: over(&|s| s.vx_m_s[k]),
        vy_m_s: over(&|s| s.vy_m_s[k]),
    }
}

/// The ledger; positive into the bearing.
fn energy(outcome: &RunOutcome) -> Vec<EnergyItem> {
    let mut items: Vec<EnergyItem> = Work::ALL
        .into_iter()
        .map(|work| {
            let value = outcome.state.work_j(work);
            EnergyItem {
                name: work.name().replace('_', " "),
                energy_j: if work.is_loss() { -value } else { value },
            }
        })
        .filter(|item| item.energy_j != 0.0)
        .collect();
    items.push(EnergyItem {
        name: "stored (kinetic, elastic)".to_owned(),
        energy_j: -(outcome.end_energy_j - outcome.start_energy_j),
    });
    items
}
