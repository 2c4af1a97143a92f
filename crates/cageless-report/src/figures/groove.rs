//! A ball with its contact track on the outer groove, of a run in space.

use std::f64::consts::{PI, TAU};

use serde_json::{Value, json};

use super::history::figure;
use super::shape::{groove_plot, slot_sentence};
use crate::data::RacewayLabel;
use crate::figure::Figure;
use crate::geometry::RacewaySurface;
use crate::groove_contacts::{ContactHistory, GrooveContacts};
use crate::plot::{PALETTE, line_in_space, numbers};
use crate::run_data::RunData;

/// Points of the outline of an ellipse, and of the ball around and from pole to pole.
const OUTLINE: usize = 48;
const BALL: [usize; 2] = [32, 17];
/// Place from which it is seen, above the load zone.
const EYE: [f64; 3] = [0.5, 1.4, 0.62];
/// Distance of lines from the surface, m: none hides in it.
const LIFT_M: f64 = 3e-5;

/// The groove around the first raceway, or at the bottom, with a ball, its contacts and their tracks.
pub fn groove(run: &RunData) -> Option<Figure> {
    let ball = GrooveContacts::of(run)?;
    let case = &ball.case;
    let (row, raceway) = (ball.row(), case.raceways.first());
    let label = RacewayLabel::default();
    let surface = RacewaySurface::in_row(raceway, &case.bearing, row.contact_sign, label);
    let view = View {
        ball: &ball,
        centre_rad: raceway.map_or(0.0, |r| r.dimensions().centre_angle_rad),
        ring_m: row.axial_position_m - row.contact_sign * row.preload_m,
    };
    let middle = |k: &usize| view.angle_rad(*k).abs();
    let seen = |k: &usize| middle(k) <= surface.half_angle_rad;
    let rows: Vec<usize> = (0..ball.angle_rad.len()).filter(seen).collect();
    let drawn = (rows.iter().copied()).min_by(|a, b| middle(a).total_cmp(&middle(b)))?;
    let on_sphere = |polar: f64, turn: f64| view.on_sphere(drawn, polar, turn);
    let mut plot = groove_plot(&surface, EYE).trace(sphere(&on_sphere));
    for (contact, colour) in ball.outer.iter().zip(PALETTE) {
        let (track, outline) = (view.track(contact, &rows), view.ellipse(contact, drawn));
        for (name, points, width) in [("track", track, 3), ("ellipse", outline, 4)] {
            if points.iter().any(|p| p[0].is_finite()) {
                let points_mm: Vec<_> = points.iter().map(|p| p.map(|v| v * 1e3)).collect();
                plot = plot.trace(line_in_space(name, &points_mm, colour, width));
            }
        }
    }
    let flank = match surface.slot_mm {
        Some(_) => "edge",
        None => "flank",
    };
    let [around, colours] = match raceway {
        Some(_) => [
            "around the first raceway",
            &format!(
                ": blue on the plain groove and on the {flank} towards +z, orange on the other. Colour of the \
                 surface: distance from the plain groove, positive where material is taken away"
            ),
        ],
        None => ["at the bottom", ""],
    };
    let caption = format!(
        "Outer groove {around}, to scale, up to its shoulders, with ball {} near the middle, its contact \
         ellipses there and the tracks of its contacts {}{colours}. {}Drag to turn it.",
        ball.ball,
        ball.part,
        slot_sentence(&surface)
    );
    Some(figure(run, "Ball on the groove", &caption, plot))
}

/// A ball in the frame of a drawing: that of the ring, turned so that `centre_rad` is at the bottom.
struct View<'a> {
    ball: &'a GrooveContacts,
    centre_rad: f64,
    /// Axial position of the ring.
    ring_m: f64,
}

impl View<'_> {
    fn radius_m(&self) -> f64 {
        self.ball.case.bearing.ball_radius_m()
    }

    /// ψ of the ball in row `k` from the bottom, −π to π.
    fn angle_rad(&self, k: usize) -> f64 {
        let from_centre = self.ball.angle_rad[k] - self.centre_rad;
        from_centre - TAU * (from_centre / TAU).round()
    }

    /// A point in the direction `angle` of the meridian plane from the centre of the ball in row `k`.
    fn point(&self, k: usize, ahead: f64, angle: f64, radius: f64) -> [f64; 3] {
        let [distance, z] = self.ball.centre_m[k];
        let (rho, psi) = (distance + radius * angle.cos(), self.angle_rad(k) + ahead);
        [
            rho * psi.sin(),
            -rho * psi.cos(),
            z - self.ring_m + radius * angle.sin(),
        ]
    }

    /// A point of the ball in row `k`, by its angles from the radius and about it.
    fn on_sphere(&self, k: usize, polar: f64, turn: f64) -> [f64; 3] {
        let radius = self.radius_m();
        let [distance, z] = self.ball.centre_m[k];
        let (sin, cos) = self.angle_rad(k).sin_cos();
        let (rho, along) = (
            distance + radius * polar.cos(),
            radius * polar.sin() * turn.sin(),
        );
        let height = z - self.ring_m + radius * polar.sin() * turn.cos();
        [rho * sin + along * cos, along * sin - rho * cos, height]
    }

    /// Track of a contact over these rows, interrupted where one is left out.
    fn track(&self, contact: &ContactHistory, rows: &[usize]) -> Vec<[f64; 3]> {
        let mut track: Vec<[f64; 3]> = vec![];
        for (n, &k) in rows.iter().enumerate() {
            if n > 0 && rows[n - 1] + 1 < k {
                track.push([f64::NAN; 3]);
            }
            track.push(self.point(k, 0.0, contact.angle_rad[k], self.radius_m() - LIFT_M));
        }
        track
    }

    /// Outline of the ellipse of a contact in row `k`.
    fn ellipse(&self, contact: &ContactHistory, k: usize) -> Vec<[f64; 3]> {
        let radius = self.radius_m();
        let [along, across] = contact.semi_axes_m[k];
        let (angle, distance) = (contact.angle_rad[k], self.ball.centre_m[k][0] + radius);
        let outline = (0..=OUTLINE).map(|n| {
            let turn = TAU * n as f64 / OUTLINE as f64;
            let angle = angle + across / radius * turn.cos();
            self.point(
                k,
                along * turn.sin() / distance,
                angle,
                radius - 2.0 * LIFT_M,
            )
        });
        outline.collect()
    }
}

fn mm(lengths_m: impl Iterator<Item = f64>) -> Value {
    numbers(&lengths_m.map(|v| v * 1e3).collect::<Vec<f64>>())
}

/// A ball that can be seen through, by its points over the angle from a pole and around it.
fn sphere(point: &dyn Fn(f64, f64) -> [f64; 3]) -> Value {
    let [around, along] = BALL;
    let share = |k: usize, count: usize| k as f64 / (count - 1) as f64;
    let of = |axis: usize| -> Value {
        let row = |k: usize| {
            let polar = PI * share(k, along);
            let turn = |n: usize| point(polar, TAU * share(n, around))[axis];
            mm((0..around).map(turn))
        };
        (0..along).map(row).collect()
    };
    json!({
        "type": "surface", "name": "ball", "hoverinfo": "skip", "showscale": false, "opacity": 0.3,
        "x": of(0), "y": of(1), "z": of(2), "colorscale": [[0, "#8a98a8"], [1, "#8a98a8"]],
    })
}
