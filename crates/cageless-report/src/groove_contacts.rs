//! Contacts of one ball with both grooves over a stretch of a run in space.

use cageless::Case;
use cageless::Row;
use cageless::equilibrium::space::{GroovePoint, inner_point, outer_points};
use cageless_io::case_file::CaseFile;

use crate::figures::history::shown_ball;
use crate::run_data::RunData;

/// One contact over the rows of a stretch; NaN where the ball does not touch.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ContactHistory {
    /// Angle of its normal from the radius, positive where an axial load along +z presses.
    pub angle_rad: Vec<f64>,
    /// Semi-axes of its ellipse along and across the groove.
    pub semi_axes_m: Vec<[f64; 2]>,
}

impl ContactHistory {
    fn push(&mut self, point: Option<GroovePoint>) {
        self.angle_rad.push(point.map_or(f64::NAN, |p| p.angle_rad));
        let axes = point.map_or([f64::NAN; 2], |p| p.contact.semi_axes_m);
        self.semi_axes_m.push(axes);
    }

    /// Angles of one end of its ellipse: the larger for sign 1, the smaller for −1.
    pub fn ends_rad(&self, sign: f64, ball_radius_m: f64) -> Vec<f64> {
        let points = self.angle_rad.iter().zip(&self.semi_axes_m);
        points
            .map(|(angle, [_, across])| angle + sign * across / ball_radius_m)
            .collect()
    }
}

/// A ball on its grooves.
#[derive(Debug, Clone)]
pub struct GrooveContacts {
    /// The case that was run.
    pub case: Case,
    /// Number of the ball, from 1.
    pub ball: usize,
    /// Part of the run, in words.
    pub part: String,
    /// ψ.
    pub angle_rad: Vec<f64>,
    /// Distance of its centre from the bearing axis, and z.
    pub centre_m: Vec<[f64; 2]>,
    /// Contacts with the outer raceway: on the plain groove the first, of two flanks that towards +z
    /// first.
    pub outer: [ContactHistory; 2],
    /// Contact with the inner raceway.
    pub inner: ContactHistory,
}

impl GrooveContacts {
    /// Contacts of the ball that a page shows, over its last orbits; `None` of a run in the plane.
    pub fn of(run: &RunData) -> Option<Self> {
        let (ball, history, from, part) = shown_ball(run)?;
        let rows = history.z_m.len();
        let time_s = run.recent.as_ref().map_or(&run.time_s, |r| &r.time_s);
        let view = (run.view_s).map(|[begin, _]| time_s.partition_point(|t| *t < begin));
        let from = from.max(view.unwrap_or(0));
        if from >= rows {
            return None;
        }
        let file = CaseFile::parse(&run.case_toml, "case", &[]).ok()?;
        let mut found = Self {
            case: file.case().clone(),
            ball,
            part: view.map_or(part, |_| "over the last orbits".to_owned()),
            angle_rad: vec![],
            centre_m: vec![],
            outer: Default::default(),
            inner: ContactHistory::default(),
        };
        for k in from..rows {
            let angle_rad = history.angle_deg[k].to_radians();
            let centre = [history.distance_m[k], history.z_m[k]];
            let force_n = history.outer_force_n[k];
            let points = outer_points(&found.case, ball - 1, angle_rad, centre, force_n);
            for (contact, point) in found.outer.iter_mut().zip(points) {
                contact.push(point);
            }
            let (angle, force_n) = (history.inner_contact_angle_rad[k], history.inner_force_n[k]);
            found.inner.push(inner_point(&found.case, angle, force_n));
            found.angle_rad.push(angle_rad);
            found.centre_m.push(centre);
        }
        Some(found)
    }

    /// Row of the ball.
    pub fn row(&self) -> Row {
        self.case.all_rows()[(self.ball - 1) / self.case.bearing.balls()]
    }

    /// Whether the ball sits on both flanks, for each time at which it touches a raceway.
    pub fn in_raceway(&self) -> Vec<bool> {
        let raceways = &self.case.raceways;
        let inside = |psi: &f64| raceways.iter().any(|r| r.contains(*psi));
        let [one, other] = &self.outer;
        let flanks = one.angle_rad.iter().zip(&other.angle_rad);
        let touching = self
            .angle_rad
            .iter()
            .zip(flanks)
            .filter(|(psi, _)| inside(psi));
        let touching = touching.map(|(_, (one, other))| [one, other].map(|a| a.is_finite()));
        (touching.filter(|[one, other]| *one || *other))
            .map(|[one, other]| one && other)
            .collect()
    }
}
