//! Path of the inner ring.

use serde_json::json;

use super::history::figure;
use super::panels::on;
use crate::figure::Figure;
use crate::plot::{PALETTE, Plot, line, with};
use crate::run_data::RunData;
use crate::sampling::{curve, history, range};
use crate::text::short;

/// Points of each history.
const POINTS: usize = 4000;

/// Path of the inner ring's centre at the end of the run, and its coordinates over time.
pub fn ring_orbit(run: &RunData) -> Option<Figure> {
    let ring = &run.ring;
    let n = ring.x_um.len().min(ring.y_um.len()).min(ring.time_s.len());
    if n == 0 {
        return None;
    }
    let (time, across, up) = (&ring.time_s[..n], &ring.x_um[..n], &ring.y_um[..n]);
    let (x, y) = curve(across, up, 6000);
    let mut plot = Plot::new(520)
        .axis(
            "xaxis",
            "Ring x (µm)",
            json!({ "scaleanchor": "y", "constrain": "domain", "domain": [0.0, 0.42] }),
        )
        .axis("yaxis", "Ring y (µm)", json!({ "constrain": "domain" }))
        .trace(with(
            line("path", &x, &y, PALETTE[0]),
            json!({ "line": { "width": 1 } }),
        ));
    for (k, (title, values, domain)) in [
        ("Ring x (µm)", across, [0.56, 1.0]),
        ("Ring y (µm)", up, [0.0, 0.44]),
    ]
    .into_iter()
    .enumerate()
    {
        let (x_axis, y_axis) = (format!("x{}", k + 2), format!("y{}", k + 2));
        let (t, v) = history(time, values, POINTS);
        plot = plot
            .axis(
                &format!("xaxis{}", k + 2),
                "Time t (s)",
                json!({ "domain": [0.55, 1.0], "anchor": y_axis, "nticks": 5 }),
            )
            .axis(
                &format!("yaxis{}", k + 2),
                title,
                json!({ "domain": domain, "anchor": x_axis }),
            )
            .trace(on(
                with(
                    line(title, &t, &v, PALETTE[k + 1]),
                    json!({ "line": { "width": 1 } }),
                ),
                &x_axis,
                &y_axis,
            ));
    }
    let (low, high) = range(up);
    let plot = plot.finding(&format!(
        "The ring is between {} and {} µm below the centre of the outer ring.",
        short(-high),
        short(-low)
    ));
    let transient = if time[0] < run.settled_after_s {
        " Part of it belongs to the transient."
    } else {
        ""
    };
    Some(figure(
        run,
        "Path of the inner ring",
        &format!(
            "Centre of the inner ring, from the centre of the outer ring; load and gravity point \
             down. The last part of the run, t = {} s to {} s, sampled every {} µs.{transient}",
            short(time[0]),
            short(time[n - 1]),
            short((time[n - 1] - time[0]) / (n.max(2) - 1) as f64 * 1e6)
        ),
        plot,
    ))
}
