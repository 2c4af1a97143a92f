//! One ball: its velocities and its loads.

use serde_json::json;

use super::history::{figure, shown_ball};
use super::panels::shade_sectors;
use crate::figure::Figure;
use crate::plot::{PALETTE, Plot, line_of};
use crate::run_data::RunData;
use crate::sampling::{Points, curve, wrapped};

/// Phase portrait of a ball.
pub fn phase(run: &RunData) -> Option<Figure> {
    let (number, ball, from, part) = shown_ball(run)?;
    if ball.vx_m_s.is_empty() || ball.vy_m_s.is_empty() {
        return None;
    }
    let after = |v: &[f64]| v.get(from..).unwrap_or_default().to_vec();
    let velocities = curve(&after(&ball.vx_m_s), &after(&ball.vy_m_s), 8000);
    let plot = Plot::new(560)
        .to_scale("vx (m/s)", "vy (m/s)", json!({}))
        .trace(line_of(&format!("ball {number}"), velocities, PALETTE[0]).width(1.0));
    let caption = format!("Velocity of the centre of ball {number}, y against x, {part}.");
    let label = format!("Phase portrait of ball {number}");
    Some(figure(run, &label, &caption, plot))
}

/// Loads of a ball against its angular position.
pub fn loads(run: &RunData) -> Option<Figure> {
    let (number, ball, from, part) = shown_ball(run)?;
    if ball.inner_force_n.is_empty() || ball.angle_deg.is_empty() {
        return None;
    }
    let from = from.min(ball.angle_deg.len());
    let mut plot = Plot::new(440)
        .legend()
        .x(
            "ψ, 0 at the bottom (°)",
            json!({ "range": [-180, 180], "dtick": 45 }),
        )
        .y("Contact force (N)", json!({ "rangemode": "tozero" }));
    plot = shade_sectors(plot, &run.sectors, "x", "y");
    for (values, name, colour) in [
        (&ball.outer_force_n, "outer raceway Fo", PALETTE[1]),
        (&ball.inner_force_n, "inner raceway Fi", PALETTE[0]),
    ] {
        let values = values.get(from..).unwrap_or_default();
        let Points { x: angle, y: force } = wrapped(&ball.angle_deg[from..], values);
        let drawn = curve_with_breaks(&angle, &force);
        plot = plot.trace(line_of(name, drawn, colour).width(1.0));
    }
    let caption = format!(
        "Normal forces on ball {number} at both raceways against its angular position ψ, all turns {part}; \
             the discrete raceway is shaded."
    );
    Some(figure(
        run,
        "Ball load vs. angular position ψ",
        &caption,
        plot,
    ))
}

/// Thins each stretch between breaks by itself.
fn curve_with_breaks(x: &[f64], y: &[f64]) -> Points {
    let total = x.len().max(1);
    let (mut xs, mut ys) = (Vec::new(), Vec::new());
    let mut from = 0;
    for at in (0..=x.len()).filter(|&i| i == x.len() || x[i].is_nan()) {
        let share = (8000 * (at - from) / total).max(8);
        let kept = curve(&x[from..at], &y[from..at], share);
        xs.extend(kept.x);
        ys.extend(kept.y);
        if at < x.len() {
            xs.push(f64::NAN);
            ys.push(f64::NAN);
        }
        from = at + 1;
    }
    Points { x: xs, y: ys }
}
