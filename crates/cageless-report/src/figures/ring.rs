//! Path of the inner ring.

use serde_json::json;

use super::history::figure;
use super::panels::Panel;
use crate::figure::Figure;
use crate::plot::{PALETTE, Plot, line_of};
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
    let path = curve(across, up, 6000);
    let mut plot = Plot::new(520)
        .to_scale(
            "Ring x (µm)",
            "Ring y (µm)",
            json!({ "domain": [0.0, 0.42] }),
        )
        .trace(line_of("path", path, PALETTE[0]).width(1.0));
    let coordinates = [
        ("Ring x (µm)", across, [0.56, 1.0]),
        ("Ring y (µm)", up, [0.0, 0.44]),
    ];
    for ((title, values, domain), k) in coordinates.into_iter().zip(1..) {
        let panel = Panel::new(k);
        let places = [
            json!({ "domain": [0.55, 1.0], "nticks": 5 }),
            json!({ "domain": domain }),
        ];
        let drawn = line_of(title, history(time, values, POINTS), PALETTE[k]);
        plot = plot
            .panel(&panel, ["Time t (s)", title], places)
            .trace(drawn.width(1.0).on(panel.axes()));
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
    let caption = format!(
        "Centre of the inner ring, from the centre of the outer ring; load and gravity point \
             down. The last part of the run, t = {} s to {} s, sampled every {} µs.{transient}",
        short(time[0]),
        short(time[n - 1]),
        short((time[n - 1] - time[0]) / (n.max(2) - 1) as f64 * 1e6)
    );
    Some(figure(run, "Path of the inner ring", &caption, plot))
}
