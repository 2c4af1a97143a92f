//! Data of reports in display units: degrees,
//! millimetres, micrometres, m/s, newtons.
//!
//! A value that could not be had is `f64::NAN` in a trace and `None` elsewhere; both
//! become `null` in JSON, a break in a line and a dash in a table.

use cageless::{Bearing, Raceway};
use serde::{Deserialize, Serialize};

pub use cageless_study::{Parameter, Provenance, RacewayLabel};

/// Outline of a bearing, for drawings to scale.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct BearingOutline {
    /// N of a row.
    pub balls: usize,
    /// Rw, mm.
    pub ball_radius_mm: f64,
    /// Ri, mm.
    pub inner_groove_bottom_radius_mm: f64,
    /// Ro, mm.
    pub outer_groove_bottom_radius_mm: f64,
    /// Rm, mm.
    pub pitch_radius_mm: f64,
    /// ε of Zhao 2022, Eq. (10), degrees: the angle from ball to ball in contact.
    pub ball_angle_deg: f64,
}

impl BearingOutline {
    /// Outline of `bearing`.
    pub fn new(bearing: &Bearing) -> Self {
        let d = bearing.dimensions();
        let pitch = (d.inner_groove_bottom_radius_m + d.outer_groove_bottom_radius_m) / 2.0;
        Self {
            balls: d.balls,
            ball_radius_mm: d.ball_radius_m * 1e3,
            inner_groove_bottom_radius_mm: d.inner_groove_bottom_radius_m * 1e3,
            outer_groove_bottom_radius_mm: d.outer_groove_bottom_radius_m * 1e3,
            pitch_radius_mm: pitch * 1e3,
            ball_angle_deg: 2.0 * (d.ball_radius_m / pitch).asin().to_degrees(),
        }
    }
}

/// The part of the turn that a discrete raceway takes up.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct RacewaySector {
    /// ψ of its middle, degrees.
    pub centre_angle_deg: f64,
    /// θ, degrees.
    pub half_angle_deg: f64,
}

impl RacewaySector {
    /// RacewaySector of `raceway`.
    pub fn new(raceway: &Raceway) -> Self {
        let d = raceway.dimensions();
        Self {
            centre_angle_deg: d.centre_angle_rad.to_degrees(),
            half_angle_deg: d.half_angle_rad.to_degrees(),
        }
    }
}

/// The balls of one bearing over time.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Motion {
    /// Title above the drawing, for example `Conventional`.
    pub title: String,
    /// Rings and balls.
    pub outline: BearingOutline,
    /// Discrete raceways; empty for a conventional outer ring.
    pub sectors: Vec<RacewaySector>,
    /// Times of the samples, s, increasing.
    pub time_s: Vec<f64>,
    /// ψ, degrees, continuous (not wrapped): `angle_deg[ball][sample]`.
    pub angle_deg: Vec<Vec<f64>>,
    /// Gap to the ball ahead, degrees: `gap_deg[ball][sample]`; if empty, the
    /// difference of the angles less ε.
    pub gap_deg: Vec<Vec<f64>>,
    /// Number of the first ball less one, of a row behind others.
    #[serde(default)]
    pub balls_before: usize,
    /// Rotor in the bore of the inner ring; `None` without one.
    #[serde(default)]
    pub rotor: Option<RotorTrack>,
    /// Provenance.
    pub provenance: Provenance,
}

impl Motion {
    /// Rows of the motion, each a drawing of its own; a single row as it is.
    pub fn rows(self) -> Vec<Self> {
        let (balls, all) = (self.outline.balls.max(1), self.angle_deg.len());
        if all <= balls {
            return vec![self];
        }
        let of = |values: &[Vec<f64>], from: usize| -> Vec<Vec<f64>> {
            values.iter().skip(from).take(balls).cloned().collect()
        };
        let row = |from: usize| Self {
            title: format!("{} row {}", self.title, from / balls + 1)
                .trim()
                .to_owned(),
            angle_deg: of(&self.angle_deg, from),
            gap_deg: of(&self.gap_deg, from),
            balls_before: from,
            ..self.clone()
        };
        (0..all).step_by(balls).map(row).collect()
    }
}

/// Motion of a rotor in the bore of the inner ring, as it is drawn.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RotorTrack {
    /// Radius of the bore, mm.
    pub bore_radius_mm: f64,
    /// Air gap as it is drawn, mm.
    pub gap_mm: f64,
    /// Centre of the journal relative to that of the ring, enlarged as the gap is, mm.
    pub x_mm: Vec<f64>,
    /// Height of the journal centre above that of the ring, enlarged as the gap is, mm.
    pub y_mm: Vec<f64>,
    /// Angle of the rotor, degrees, counter-clockwise.
    pub angle_deg: Vec<f64>,
    /// Angle of the inner ring, degrees, counter-clockwise.
    pub ring_angle_deg: Vec<f64>,
}

/// An acceleration signal and its spectrum.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct VibrationSignal {
    /// Legend entry, for example `conventional`.
    pub name: String,
    /// Time, s.
    pub time_s: Vec<f64>,
    /// Acceleration of the outer ring, m/s².
    pub acceleration_m_s2: Vec<f64>,
    /// If the signal is given by the lowest and the highest value of stretches of it, their
    /// length, s.
    pub stretch_s: Option<f64>,
    /// Frequencies of the spectrum, Hz.
    pub frequency_hz: Vec<f64>,
    /// Single-sided amplitude, m/s².
    pub amplitude_m_s2: Vec<f64>,
    /// Root mean square of the acceleration, m/s².
    pub rms_m_s2: Option<f64>,
    /// Largest absolute acceleration, m/s².
    pub peak_m_s2: Option<f64>,
    /// Distance of the spectrum's frequencies, Hz.
    pub resolution_hz: Option<f64>,
    /// Number of overlapping segments over which the spectrum is averaged.
    pub averages: usize,
}

/// Acceleration of the outer ring, one or more signals to compare (Fig. 12).
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Vibration {
    /// Signals, drawn one above the other on one scale.
    pub signals: Vec<VibrationSignal>,
    /// Frequencies worth a mark in the spectrum, for example that of ball passing.
    pub marks: Vec<FrequencyMark>,
    /// Provenance.
    pub provenance: Provenance,
}

/// A frequency worth a mark in a spectrum.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct FrequencyMark {
    /// Frequency, Hz.
    pub frequency_hz: f64,
    /// Short label.
    pub label: String,
}

/// A labelled moment.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Event {
    /// Label drawn at the line: `t0`, `a`.
    pub label: String,
    /// Time, s.
    pub time_s: f64,
    /// Description of the event for the caption.
    pub meaning: String,
}

impl Event {
    /// The moment `time_s`.
    pub fn new(label: &str, time_s: f64, meaning: &str) -> Self {
        let [label, meaning] = [label, meaning].map(str::to_owned);
        Self {
            label,
            time_s,
            meaning,
        }
    }
}
