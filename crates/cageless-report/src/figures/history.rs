//! Figures of a single run: histories of all balls, ring, loads, collisions, energy.

use serde_json::{Value, json};

use super::{on, shade_sectors};
use crate::figure::Figure;
use crate::plot::{PALETTE, Plot, line, markers, number, numbers, plain, with};
use crate::run::{BallHistory, RunData};
use crate::sampling::{curve, history, range, wrapped};
use crate::text::short;

/// One history of a ball.
type History = fn(&BallHistory) -> &Vec<f64>;

/// Points of all traces of a figure with one trace per ball.
const POINTS_OF_ALL: usize = 28_000;
/// Collisions drawn at most.
const COLLISIONS: usize = 4000;

/// Gaps of all pairs over time.
pub fn gaps(run: &RunData) -> Option<Figure> {
    let plot = per_ball(run, "Gap to the ball ahead (°)", true, |ball| {
        &ball.gap_deg
    })?
    .horizontal("x", "y", 0.0, "solid")
    .horizontal("x", "y", run.uniform_gap_deg, "dot");
    Some(figure(
        run,
        "Gaps",
        &format!(
            "Gaps of all pairs over time; 0 is contact, the dotted line is the nominal gap. Ball 1 \
             to 2 is drawn strong; click a ball in the legend to hide it, double-click to see it \
             alone.{}",
            stretches(run)
        ),
        plot,
    ))
}

/// Orbital speeds over time.
pub fn orbit_speed(run: &RunData) -> Option<Figure> {
    let mut plot = per_ball(run, "Orbital speed (°/s)", false, |ball| {
        &ball.orbit_speed_deg_s
    })?;
    if let Some(rolling) = run.rolling_orbit_speed_deg_s {
        plot = plot.horizontal("x", "y", rolling, "dot");
    }
    Some(figure(
        run,
        "Orbital speed",
        &format!(
            "Orbital speed of ball 1 over time; the dotted line is pure rolling on the plain \
             raceway. Click a ball in the legend to add it.{}",
            stretches(run)
        ),
        plot,
    ))
}

/// ΔVi and ΔVo over time.
pub fn slip(run: &RunData) -> Option<Figure> {
    let mut plot = with_time(run, Plot::new(620), "y2")
        .legend()
        .set("legend", ball_legend())
        .axis(
            "yaxis",
            "Sliding speed at inner raceway ΔVi (m/s)",
            json!({ "domain": [0.54, 1.0], "anchor": "x" }),
        )
        .axis(
            "yaxis2",
            "Sliding speed at outer raceway ΔVo (m/s)",
            json!({ "domain": [0.0, 0.46], "anchor": "x" }),
        );
    let kinds: [(History, &str); 2] = [(|b| &b.inner_slip_m_s, "y"), (|b| &b.outer_slip_m_s, "y2")];
    let mut any = false;
    for (of, y) in kinds {
        for (k, ball) in run.balls.iter().enumerate().rev() {
            if of(ball).is_empty() {
                continue;
            }
            any = true;
            let trace = ball_trace(run, k, of(ball), 2 * run.balls.len(), false);
            plot = plot.trace(on(with(trace, json!({ "showlegend": y == "y" })), "x", y));
        }
    }
    any.then(|| {
        figure(
            run,
            "Slip",
            &format!(
                "Sliding speeds of ball 1 at the inner and the outer raceway over time; click a \
                 ball in the legend to add it. Positive ΔVi speeds orbit and spin up, positive ΔVo \
                 slows the orbit and speeds the spin up.{}",
                stretches(run)
            ),
            plot,
        )
    })
}

/// Phase portrait of a ball.
pub fn phase(run: &RunData) -> Option<Figure> {
    let Shown {
        number,
        ball,
        from,
        part,
    } = shown_ball(run)?;
    if ball.vx_m_s.is_empty() || ball.vy_m_s.is_empty() {
        return None;
    }
    let after = |v: &[f64]| v.get(from..).unwrap_or_default().to_vec();
    let (px, py) = curve(&after(&ball.vx_m_s), &after(&ball.vy_m_s), 8000);
    let plot = Plot::new(560)
        .axis(
            "xaxis",
            "vx (m/s)",
            json!({ "scaleanchor": "y", "constrain": "domain" }),
        )
        .axis("yaxis", "vy (m/s)", json!({ "constrain": "domain" }))
        .trace(with(
            line(&format!("ball {number}"), &px, &py, PALETTE[0]),
            json!({ "line": { "width": 1 } }),
        ));
    Some(figure(
        run,
        &format!("Phase portrait of ball {number}"),
        &format!("Velocity of the centre of ball {number}, y against x, {part}."),
        plot,
    ))
}

/// Path of the inner ring's centre: all of it, and enlarged after the transient.
pub fn ring_orbit(run: &RunData) -> Option<Figure> {
    let ring = &run.ring;
    let n = ring.x_um.len().min(ring.y_um.len()).min(ring.time_s.len());
    if n == 0 {
        return None;
    }
    let cut = ring.time_s[..n].partition_point(|t| *t < run.settled_after_s);
    let (x, y) = curve(&ring.x_um[cut..n], &ring.y_um[cut..n], 6000);
    let settled = |colour: &str| {
        with(
            line("settled", &x, &y, colour),
            json!({ "line": { "width": 1 } }),
        )
    };
    let plot = Plot::new(500).at_least(800).legend();
    if cut == 0 {
        let plot = plot
            .axis("xaxis", "Ring x (µm)", json!({ "scaleanchor": "y" }))
            .axis("yaxis", "Ring y (µm)", json!({}))
            .trace(settled(PALETTE[0]));
        let part = run.recent.as_ref().map_or(String::new(), |recent| {
            format!(" Shown after t = {} s.", short(recent.from_s))
        });
        return Some(figure(
            run,
            "Path of the inner ring",
            &format!("{RING}{part}"),
            plot,
        ));
    }
    let (x0, y0) = curve(&ring.x_um[..cut], &ring.y_um[..cut], 3000);
    let plot = plot
        .axis(
            "xaxis",
            "Ring x (µm)",
            json!({ "scaleanchor": "y", "domain": [0.0, 0.44] }),
        )
        .axis("yaxis", "Ring y (µm)", json!({}))
        .axis(
            "xaxis2",
            "Ring x (µm)",
            json!({
                "scaleanchor": "y2", "domain": [0.56, 1.0], "anchor": "y2",
            }),
        )
        .axis("yaxis2", "Ring y (µm)", json!({ "anchor": "x2" }))
        .trace(line("transient, discarded", &x0, &y0, "#c4c4c4"))
        .trace(settled(PALETTE[0]))
        .trace(on(
            with(settled(PALETTE[0]), json!({ "showlegend": false })),
            "x2",
            "y2",
        ));
    let caption = format!("{RING} Left: all of the run; right: after the transient, enlarged.");
    Some(figure(run, "Path of the inner ring", &caption, plot))
}

const RING: &str = "Centre of the inner ring, from the centre of the outer ring; load and gravity \
    point down.";

/// Loads of a ball against its angular position.
pub fn loads(run: &RunData) -> Option<Figure> {
    let Shown {
        number,
        ball,
        from,
        part,
    } = shown_ball(run)?;
    if ball.inner_force_n.is_empty() || ball.angle_deg.is_empty() {
        return None;
    }
    let from = from.min(ball.angle_deg.len());
    let mut plot = Plot::new(440)
        .legend()
        .axis(
            "xaxis",
            "ψ, 0 at the bottom (°)",
            json!({ "range": [-180, 180], "dtick": 45 }),
        )
        .axis(
            "yaxis",
            "Contact force (N)",
            json!({ "rangemode": "tozero" }),
        );
    plot = shade_sectors(plot, &run.sectors, "x", "y");
    for (values, name, colour) in [
        (&ball.outer_force_n, "outer raceway Fo", PALETTE[1]),
        (&ball.inner_force_n, "inner raceway Fi", PALETTE[0]),
    ] {
        let values = values.get(from..).unwrap_or_default();
        let (angle, force) = wrapped(&ball.angle_deg[from..], values);
        let (x, y) = curve_with_breaks(&angle, &force);
        plot = plot.trace(with(
            line(name, &x, &y, colour),
            json!({ "line": { "width": 1 } }),
        ));
    }
    Some(figure(
        run,
        "Ball load vs. angular position ψ",
        &format!(
            "Normal forces on ball {number} at both raceways against its angular position ψ, all turns {part}; \
             the discrete raceway is shaded."
        ),
        plot,
    ))
}

/// Angular position of collisions over time.
pub fn collisions(run: &RunData) -> Option<Figure> {
    let mut hits = run.collisions.clone();
    hits.sort_by(|a, b| b.impulse_n_s.total_cmp(&a.impulse_n_s));
    let most = hits.first()?.impulse_n_s.max(1e-300);
    let total = run.collisions_total.max(hits.len());
    hits.truncate(COLLISIONS);
    let column =
        |of: fn(&crate::run::CollisionPoint) -> f64| -> Vec<f64> { hits.iter().map(of).collect() };
    let size: Vec<f64> = hits
        .iter()
        .map(|c| 4.0 + 16.0 * (c.impulse_n_s / most).max(0.0).sqrt())
        .collect();
    let text: Value = hits
        .iter()
        .map(|c| {
            format!(
                "balls {} and {}<br>approach {} m/s<br>peak {} N<br>impulse {} N·s",
                c.ball,
                c.next_ball,
                short(c.approach_speed_m_s),
                short(c.peak_force_n),
                short(c.impulse_n_s)
            )
        })
        .collect();
    let mut plot = with_time(run, Plot::new(460), "y").axis(
        "yaxis",
        "ψ of the contact, 0 at the bottom (°)",
        json!({ "range": [-180, 180], "dtick": 45 }),
    );
    for sector in &run.sectors {
        for edge in [
            sector.centre_angle_deg - sector.half_angle_deg,
            sector.centre_angle_deg + sector.half_angle_deg,
        ] {
            plot = plot.horizontal("x", "y", edge - 360.0 * (edge / 360.0).round(), "dash");
        }
    }
    plot = plot.trace(with(
        markers("collisions", &column(|c| c.time_s), &column(|c| c.angle_deg), PALETTE[1]),
        json!({
            "marker": { "size": numbers(&size), "opacity": 0.55, "line": { "width": 0.5, "color": "#7a3500" } },
            "text": text, "hovertemplate": "%{text}<br>t %{x} s, ψ %{y}°<extra></extra>",
        }),
    ));
    let drawn = if total > COLLISIONS {
        format!(" The {COLLISIONS} strongest are drawn.")
    } else {
        String::new()
    };
    Some(figure(
        run,
        "Collisions",
        &format!(
            "{total} contacts between balls: place over time. The area of a marker grows with the impulse, the largest \
         being {} N·s; dashed lines are the ends of the discrete raceway.{drawn}",
            short(most)
        ),
        plot,
    ))
}

/// Energy balance of a run.
pub fn energy(run: &RunData) -> Option<Figure> {
    if run.energy.is_empty() {
        return None;
    }
    let names: Value = run.energy.iter().map(|item| plain(&item.name)).collect();
    let values: Vec<f64> = run.energy.iter().map(|item| item.energy_j).collect();
    let colours: Value = values
        .iter()
        .map(|v| if *v < 0.0 { PALETTE[1] } else { PALETTE[0] })
        .collect();
    let labels: Value = values.iter().map(|v| format!("{} J", short(*v))).collect();
    let (low, high) = range(&values);
    let room = (high.max(0.0) - low.min(0.0)).max(1e-12) * 0.16;
    let bounds = json!([
        number(low.min(0.0) - if low < 0.0 { room } else { 0.0 }),
        number(high.max(0.0) + if high > 0.0 { room } else { 0.0 }),
    ]);
    let plot = Plot::new(36 * run.energy.len() as u32 + 130)
        .axis("xaxis", "Energy, positive into the bearing (J)", json!({ "range": bounds, "zeroline": true, "zerolinecolor": "#555" }))
        .axis("yaxis", "", json!({ "type": "category", "autorange": "reversed" }))
        .trace(json!({
            "type": "bar", "orientation": "h", "y": names, "x": numbers(&values),
            "marker": { "color": colours }, "text": labels, "textposition": "outside", "cliponaxis": false,
        }));
    let rest = run.energy_residual_relative.map_or(String::new(), |r| {
        format!(" Residual: {} of the sum of all energy flows.", short(r))
    });
    Some(figure(
        run,
        "Energy balance",
        &format!("Work and energy over the run.{rest}"),
        plot,
    ))
}

fn figure(run: &RunData, label: &str, caption: &str, plot: Plot) -> Figure {
    Figure {
        label: label.to_owned(),
        caption: caption.to_owned(),
        provenance: run.provenance.clone(),
        plot,
    }
}

/// A ball to be shown in a plane.
struct Shown<'r> {
    /// Number, from 1.
    number: usize,
    ball: &'r BallHistory,
    /// First row to be shown.
    from: usize,
    /// The part of the run that is shown.
    part: String,
}

/// The first ball that has a history.
fn shown_ball(run: &RunData) -> Option<Shown<'_>> {
    let first = run.balls.iter().position(|b| !b.angle_deg.is_empty())?;
    Some(match &run.recent {
        Some(recent) => Shown {
            number: first + 1,
            ball: &recent.ball,
            from: 0,
            part: format!("after t = {} s", short(recent.from_s)),
        },
        None => Shown {
            number: first + 1,
            ball: &run.balls[first],
            from: settled(run),
            part: "after the transient".to_owned(),
        },
    })
}

/// Remark on the decimation of histories over time.
fn stretches(run: &RunData) -> String {
    run.stretch_s.map_or(String::new(), |stretch| {
        format!(
            " Every {} ms of the run are shown by their lowest and highest value.",
            short(stretch * 1e3)
        )
    })
}

/// First row after the transient; 0 if nothing is left after it.
fn settled(run: &RunData) -> usize {
    let from = run.time_s.partition_point(|t| *t < run.settled_after_s);
    if from < run.time_s.len() { from } else { 0 }
}

/// Time axis along the bottom of all panels, transient shaded.
fn with_time(run: &RunData, plot: Plot, anchor: &str) -> Plot {
    let times = run.time_s.iter().chain(&run.ring.time_s);
    let begin = times.clone().copied().reduce(f64::min).unwrap_or(0.0);
    let end = times.copied().fold(begin, f64::max);
    plot.axis(
        "xaxis",
        "Time t (s)",
        json!({ "anchor": anchor, "range": [number(begin), number(end)] }),
    )
    .discarded("x", "paper", begin, run.settled_after_s.min(end))
}

/// One entry per ball, at the right.
fn ball_legend() -> Value {
    json!({
        "orientation": "v", "x": 1.01, "y": 1, "font": { "size": 11 }, "traceorder": "reversed",
    })
}

/// A panel over time with one trace per ball, ball 1 drawn last and strong, the
/// others shown at once or when asked for.
fn per_ball(
    run: &RunData,
    title: &str,
    all: bool,
    of: impl Fn(&BallHistory) -> &Vec<f64>,
) -> Option<Plot> {
    let mut plot = with_time(run, Plot::new(470), "y")
        .legend()
        .set("margin", json!({ "l": 72, "r": 24, "t": 30, "b": 58 }))
        .set("legend", ball_legend())
        .axis(
            "yaxis",
            title,
            json!({ "tickformat": if title.contains("°/s") { ",.0f" } else { "" } }),
        );
    let mut any = false;
    for (k, ball) in run.balls.iter().enumerate().rev() {
        if !of(ball).is_empty() {
            any = true;
            plot = plot.trace(ball_trace(run, k, of(ball), run.balls.len(), all));
        }
    }
    any.then_some(plot)
}

fn ball_trace(run: &RunData, k: usize, values: &[f64], traces: usize, shown: bool) -> Value {
    // Of selected balls all are shown alike.
    let selected = run.balls.iter().any(|ball| ball.angle_deg.is_empty());
    let strong = k == 0 || selected;
    let points = if strong {
        4000
    } else {
        (POINTS_OF_ALL / traces.max(1)).clamp(800, 4000)
    };
    let (x, y) = history(&run.time_s, values, points);
    let colour = PALETTE[k % PALETTE.len()];
    let dash = ["solid", "dash", "dot"][k / PALETTE.len() % 3];
    let width = if strong { 1.8 } else { 1.0 };
    with(
        line(&format!("ball {}", k + 1), &x, &y, colour),
        json!({
            "line": { "width": width, "dash": dash },
            "opacity": if strong || !shown { 1.0 } else { 0.55 },
            "visible": if strong || shown { Value::Bool(true) } else { "legendonly".into() },
            "legendgroup": k + 1,
        }),
    )
}

/// Thins each stretch between breaks by itself.
fn curve_with_breaks(x: &[f64], y: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let total = x.len().max(1);
    let (mut xs, mut ys) = (Vec::new(), Vec::new());
    let mut from = 0;
    for at in (0..=x.len()).filter(|&i| i == x.len() || x[i].is_nan()) {
        let share = (8000 * (at - from) / total).max(8);
        let (px, py) = curve(&x[from..at], &y[from..at], share);
        xs.extend(px);
        ys.extend(py);
        if at < x.len() {
            xs.push(f64::NAN);
            ys.push(f64::NAN);
        }
        from = at + 1;
    }
    (xs, ys)
}
