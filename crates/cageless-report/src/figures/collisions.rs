//! Contacts between balls over time.

use serde_json::{Value, json};

use super::history::{figure, with_time};
use crate::figure::Figure;
use crate::plot::{PALETTE, Plot, markers, numbers};
use crate::run_data::{CollisionPoint, RunData};
use crate::text::short;

/// Collisions drawn at most.
const COLLISIONS: usize = 4000;

/// Angular position of collisions over time.
pub fn collisions(run: &RunData) -> Option<Figure> {
    let mut hits = run.collisions.clone();
    hits.sort_by(|a, b| b.impulse_n_s.total_cmp(&a.impulse_n_s));
    let most = hits.first()?.impulse_n_s.max(1e-300);
    let total = run.collisions_total.max(hits.len());
    hits.truncate(COLLISIONS);
    let column = |of: fn(&CollisionPoint) -> f64| -> Vec<f64> { hits.iter().map(of).collect() };
    let size: Vec<f64> = hits
        .iter()
        .map(|c| 4.0 + 16.0 * (c.impulse_n_s / most).max(0.0).sqrt())
        .collect();
    let text: Value = hits.iter().map(hover_text).collect();
    // The axis shows where contacts are, with the ends of the raceways.
    let edges = run.sectors.iter().flat_map(|s| {
        let edge = |sign: f64| s.centre_angle_deg + sign * s.half_angle_deg;
        [edge(-1.0), edge(1.0)].map(|a| a - 360.0 * (a / 360.0).round())
    });
    let angles = hits.iter().map(|c| c.angle_deg).chain(edges.clone());
    let shown = angle_range(angles);
    let plot = with_time(run, Plot::new(460), "y");
    let mut plot = plot.y("ψ of the contact, 0 at the bottom (°)", shown);
    for edge in edges {
        plot = plot.horizontal("x", "y", edge, "dash");
    }
    let (time, angle) = (column(|c| c.time_s), column(|c| c.angle_deg));
    plot = plot.trace(markers("collisions", &time, &angle, PALETTE[1]).with(json!({
        "marker": { "size": numbers(&size), "opacity": 0.55, "line": { "width": 0.5, "color": "#7a3500" } },
        "text": text, "hovertemplate": "%{text}<br>t %{x} s, ψ %{y}°<extra></extra>",
    })));
    let drawn = if total > COLLISIONS {
        format!(" The {COLLISIONS} strongest are drawn.")
    } else {
        String::new()
    };
    let late = |c: &&CollisionPoint| c.time_s > run.settled_after_s;
    let counted = if run.settled_after_s > 0.0 && total == run.collisions.len() {
        let late = run.collisions.iter().filter(late).count();
        format!(
            ", {late} of them after the transient of {} s",
            short(run.settled_after_s)
        )
    } else {
        String::new()
    };
    let contacts = if total == 1 { "contact" } else { "contacts" };
    let caption = format!(
        "{total} {contacts} between balls of the whole run{counted}: place over time. The area of a marker grows with the impulse, the largest \
         being {} N·s; dashed lines are the ends of the discrete raceway.{drawn}",
        short(most)
    );
    Some(figure(run, "Collisions", &caption, plot.last_view_first()))
}

fn hover_text(c: &CollisionPoint) -> String {
    format!(
        "balls {} and {}<br>approach {} m/s<br>peak {} N<br>impulse {} N·s",
        c.ball,
        c.next_ball,
        short(c.approach_speed_m_s),
        short(c.peak_force_n),
        short(c.impulse_n_s)
    )
}

/// Range of an axis around these angles, degrees; a whole turn where they are spread over most of one.
fn angle_range(angles_deg: impl Iterator<Item = f64>) -> Value {
    let most = angles_deg.fold(0.0f64, |m, a| m.max(a.abs()));
    let most = (1.25 * most / 5.0).ceil() * 5.0;
    match most > 120.0 {
        true => json!({ "range": [-180, 180], "dtick": 45 }),
        false => json!({ "range": [-most, most] }),
    }
}
