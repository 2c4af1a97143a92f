//! The motion of a case, or the drop of its rotor, one stretch at a time.

use std::f64::consts::{PI, TAU};

use cageless::Case;
use cageless::Rotor;
use cageless::dynamics::Layout;
use cageless::dynamics::State;
use cageless::equilibrium::space::{inner_point, outer_points};
use cageless::initial_state_controlled;
use cageless::recorder::Recorder;
use cageless::simulation::{Control, Ending, Simulation};
use cageless::{RotorSnapshot, Snapshot};
use cageless_results::Particulars;
use serde::Deserialize;
use serde_json::{Value, json};

use crate::refusal::Refusal;

/// A stretch of a motion: from the start of the case, or from where the last one ended.
#[derive(Debug, Deserialize)]
pub(crate) struct Stretch {
    /// Simulated time.
    duration_s: f64,
    /// Number of frames that it is divided into.
    frames: usize,
    /// `resume` of the answer before.
    #[serde(default)]
    resume: Option<String>,
}

/// Frames of one stretch at most.
const FRAMES_MAX: usize = 4000;
/// Steps of one stretch at most: some ten seconds of computing.
const STEPS_MAX: f64 = 2e6;

/// End of a stretch as `resume`: the bits of its numbers in hexadecimal, so that nothing is rounded.
fn hex(values: &[f64]) -> String {
    values
        .iter()
        .map(|v| format!("{:016x}", v.to_bits()))
        .collect()
}

fn unhex(text: &str, count: usize) -> Result<Vec<f64>, Refusal> {
    let number = |k: usize| {
        let bits = u64::from_str_radix(text.get(16 * k..16 * (k + 1))?, 16).ok()?;
        Some(f64::from_bits(bits)).filter(|v| v.is_finite())
    };
    let values = (0..count).map(number).collect::<Option<_>>();
    values
        .filter(|_| text.len() == 16 * count)
        .ok_or_else(|| Refusal::new("resume is not what the last stretch returned"))
}

impl Stretch {
    /// Time from one frame to the next, s.
    fn interval_s(&self, case: &Case) -> Result<f64, Refusal> {
        let duration_s = self.duration_s;
        if !(duration_s > 0.0 && duration_s / case.solver.step_s <= STEPS_MAX) {
            return Err(Refusal::new(format!(
                "duration_s = {duration_s} is not possible: more than 0 and at most {:e} s, which is \
                 {STEPS_MAX:e} steps",
                STEPS_MAX * case.solver.step_s
            )));
        }
        if !(1..=FRAMES_MAX).contains(&self.frames) {
            let message = format!("frames = {}: 1 to {FRAMES_MAX} are allowed", self.frames);
            return Err(Refusal::new(message));
        }
        let interval_s = duration_s / self.frames as f64;
        const LEAST_S: f64 = Particulars::INTERVAL_MIN_S;
        if !(interval_s >= LEAST_S) {
            return Err(Refusal::new(format!(
                "duration_s = {duration_s:e} in {} frames is not possible: at least {LEAST_S:e} s \
                 from one to the next",
                self.frames
            )));
        }
        Ok(interval_s)
    }
}

/// Where a stretch begins.
struct Start {
    time_s: f64,
    state: State,
    /// ψ of the balls.
    angles_rad: Vec<f64>,
}

impl Start {
    fn of(
        case: &Case,
        stretch: &Stretch,
        control: &mut dyn FnMut(f64) -> Control,
    ) -> Result<Self, Refusal> {
        let Some(resume) = &stretch.resume else {
            let (state, angles_rad) = initial_state_controlled(case, &mut || control(0.0))?;
            return Ok(Self {
                time_s: 0.0,
                state,
                angles_rad,
            });
        };
        // Time, state, ψ of the balls.
        let mut state = State::zero(Layout::of_case(case));
        let length = state.values().len();
        let values = unhex(resume, 1 + length + case.balls())?;
        let (own, angles_rad) = values[1..].split_at(length);
        state.values_mut().copy_from_slice(own);
        Ok(Self {
            time_s: values[0],
            state: state.without_ledger(),
            angles_rad: angles_rad.to_vec(),
        })
    }
}

/// Cause of an early end of a stretch that began at `from_s`; `None` of a whole one.
fn stopped(ending: &Ending, from_s: f64) -> Result<Option<Value>, Refusal> {
    Ok(match ending {
        Ending::Stopped(stop) => Some(json!({
            "time_s": from_s + stop.time_s,
            "cause": stop.cause.to_string(),
            "advice": stop.advice_by_key(),
        })),
        Ending::Interrupted => return Err(Refusal::new("cancelled")),
        Ending::ObserverFailed(error) => return Err(Refusal::new(error.to_string())),
        Ending::Complete => None,
    })
}

/// Runs a stretch and returns its frames, its collisions so far and what the next needs.
pub(crate) fn motion(
    case: &Case,
    stretch: &Stretch,
    control: &mut dyn FnMut(f64) -> Control,
) -> Result<Value, Refusal> {
    let (duration_s, interval_s) = (stretch.duration_s, stretch.interval_s(case)?);
    let start = Start::of(case, stretch, control)?;
    let from_s = start.time_s;
    let mut part = case.clone();
    part.solver.duration_s = duration_s;
    part.operation = case.operation.from_time(from_s);
    let mut frames: Vec<Snapshot> = vec![];
    let outcome = {
        let mut recorder = Recorder::new(interval_s, |snapshot| {
            // The first and the last, and one more by rounding: whatever the times, no more.
            if frames.len() > stretch.frames + 2 {
                return Err("more frames than were asked for".into());
            }
            frames.push(snapshot);
            Ok(())
        });
        let mut simulation = Simulation::at(&part, &start.state, &start.angles_rad)?;
        simulation.run_controlled(duration_s, &mut [&mut recorder], &mut |time_s| {
            control(time_s / duration_s)
        })
    };
    let stopped = stopped(&outcome.ending, from_s)?;
    let resume = match (&stopped, frames.last()) {
        (None, Some(last)) => {
            let time_s = [from_s + outcome.end_s];
            Some(hex(
                &[&time_s, outcome.state.values(), &last.angle_rad].concat()
            ))
        }
        _ => None,
    };
    // The first frame of a later stretch is the last of the one before.
    let skipped = usize::from(stretch.resume.is_some());
    let shown: Vec<Value> = frames[skipped.min(frames.len())..]
        .iter()
        .map(|s| frame(case, from_s, s))
        .collect();
    Ok(json!({
        "from_s": from_s,
        "to_s": from_s + outcome.end_s,
        "steps": outcome.steps,
        "energy_residual_relative": outcome.energy_residual_relative,
        "frames": shown,
        "stopped": stopped,
        "resume": resume,
    }))
}

/// Degrees of a radian.
pub(crate) const DEGREES: f64 = 180.0 / PI;

/// Numbers in another unit, to `digits` decimals.
pub(crate) fn rounded(values: &[f64], factor: f64, digits: i32) -> Vec<f64> {
    let scale = 10f64.powi(digits);
    values
        .iter()
        .map(|v| (v * factor * scale).round() / scale)
        .collect()
}

/// One frame, to the precision of a picture.
fn frame(case: &Case, from_s: f64, s: &Snapshot) -> Value {
    let mut frame = json!({
        "t": from_s + s.time_s,
        "angle_deg": rounded(&s.angle_rad, DEGREES, 5),
        "gap_deg": rounded(&s.gap_rad, DEGREES, 5),
        "inner_force_n": rounded(&s.inner_force_n, 1.0, 2),
        "outer_force_n": rounded(&s.outer_force_n, 1.0, 2),
        "sliding_m_s": rounded(&s.outer_sliding_m_s, 1.0, 4),
        "ring_um": rounded(&[s.ring.x_m, s.ring.y_m], 1e6, 3),
    });
    if s.is_in_space() {
        frame["space"] = contacts(case, s);
    }
    if let (Some(rotor), Some(r)) = (&case.rotor, &s.rotor) {
        frame["rotor"] = rotor_frame(rotor, r, [s.ring.x_m, s.ring.y_m]);
    }
    frame
}

/// Contacts of the balls with both raceways in a frame: angle and half length of each ellipse, over the
/// radius of the ball, degrees, and z in its ring, mm; all 0 without contact. Of the outer raceway the contact on the plain groove
/// or the flank towards +Z, and that on the other flank.
fn contacts(case: &Case, s: &Snapshot) -> Value {
    let mut found: [[Vec<f64>; 3]; 3] = Default::default();
    let (rows, radius_m) = (case.all_rows(), case.bearing.ball_radius_m());
    for k in 0..s.balls() {
        let row = &rows[k / case.bearing.balls()];
        let ring_z_m = row.axial_position_m - row.contact_sign * row.preload_m;
        let place = s.place_in_outer_ring_m(k);
        let [plus, minus] = outer_points(case, k, s.angle_rad[k], place, s.outer_force_n[k]);
        let inner = inner_point(case, s.inner_contact_angle_rad[k], s.inner_force_n[k]);
        for (contact, point) in found.iter_mut().zip([inner, plus, minus]) {
            let values = point.map_or([0.0; 3], |p| {
                let z_m = place[1] + radius_m * p.angle_rad.sin() - ring_z_m;
                [p.angle_rad, p.contact.semi_axes_m[1] / radius_m, z_m]
            });
            contact
                .iter_mut()
                .zip(values)
                .for_each(|(all, v)| all.push(v));
        }
    }
    let [inner, plus, minus] = found.map(|[angle, reach, z]| {
        let degrees = |values: &[f64]| rounded(values, DEGREES, 3);
        [degrees(&angle), degrees(&reach), rounded(&z, 1e3, 4)]
    });
    json!({
        "inner": inner, "outer": [plus, minus],
        "ring_z_um": rounded(&[s.ring.z_m], 1e6, 3),
    })
}

/// Rotor and housing of a frame; the journal from the centre of the bore.
fn rotor_frame(rotor: &Rotor, r: &RotorSnapshot, ring_m: [f64; 2]) -> Value {
    let rpm = 60.0 / TAU;
    let [x, y] = rotor.journal_m([r.x_m, r.y_m], r.angle_rad);
    json!({
        "journal_um": rounded(&[x - ring_m[0], y - ring_m[1]], 1e6, 3),
        "housing_um": rounded(&[r.housing_x_m, r.housing_y_m], 1e6, 3),
        "speed_rpm": rounded(&[r.speed_rad_s, r.ring_speed_rad_s], rpm, 2),
        "angle_deg": rounded(&[r.angle_rad], DEGREES, 3),
        "force_n": rounded(&[r.contact_force_n], 1.0, 2),
        "z_um": rounded(&[r.z_m], 1e6, 3),
        "shoulder_force_n": rounded(&[r.shoulder_force_n], 1.0, 2),
        "sliding_m_s": rounded(&[r.contact_sliding_m_s], 1.0, 4),
    })
}
