//! Histories of all balls over the time of a run.

use serde_json::{Value, json};

use crate::figure::Figure;
use crate::plot::{Axes, Margin, PALETTE, Plot, line_of, number};
use crate::run_data::{BallHistory, RunData};
use crate::sampling::{Points, history, range};
use crate::text::short;

/// One history of a ball.
type History = fn(&BallHistory) -> &Vec<f64>;

/// Balls whose gaps are shown at once.
const SHOWN: usize = 3;
/// Points of a trace before the stretch of time that is shown first.
const POINTS_BEFORE: usize = 2000;

/// Points of all traces of a figure with one trace per ball.
const POINTS_OF_ALL: usize = 28_000;

/// Gaps of all pairs over time.
pub fn gaps(run: &RunData) -> Option<Figure> {
    let plot = per_ball(run, "Gap to the ball ahead (°)", SHOWN, |ball| {
        &ball.gap_deg
    })?
    .horizontal("x", "y", 0.0, "solid")
    .horizontal("x", "y", run.uniform_gap_deg, "dash")
    .finding(&smallest_gap(run));
    let caption = format!(
        "Gaps over time of balls 1 to {SHOWN} to the ball ahead; 0 is contact, the dashed line is \
             the nominal gap. Click a ball in the legend to add or hide it, double-click to see it \
             alone.{}",
        stretches(run)
    );
    Some(figure(run, "Gaps", &caption, plot))
}

/// The smallest gap of the run in a sentence.
pub(super) fn smallest_gap(run: &RunData) -> String {
    let least = |(k, ball): (usize, &BallHistory)| (k, range(&ball.gap_deg).0);
    let pairs = run.balls.iter().enumerate();
    let pairs = pairs
        .filter(|(_, ball)| !ball.gap_deg.is_empty())
        .map(least);
    let Some((k, gap)) = pairs.min_by(|a, b| a.1.total_cmp(&b.1)) else {
        return String::new();
    };
    let row = run.outline.balls;
    let next = k - k % row + (k + 1) % row + 1;
    format!(
        "The smallest gap is {}°, between balls {} and {next}; the nominal gap is {}°.",
        short(gap),
        k + 1,
        short(run.uniform_gap_deg)
    )
}

/// Orbital speeds over time.
pub fn orbit_speed(run: &RunData) -> Option<Figure> {
    let mut plot = per_ball(run, "Orbital speed (°/s)", 1, |ball| {
        &ball.orbit_speed_deg_s
    })?;
    if let Some(rolling) = run.rolling_orbit_speed_deg_s {
        plot = plot.horizontal("x", "y", rolling, "dash");
    }
    let caption = format!(
        "Orbital speed of ball 1 over time; the dashed line is pure rolling on the plain \
             raceway. Click a ball in the legend to add it.{}",
        stretches(run)
    );
    Some(figure(run, "Orbital speed", &caption, plot))
}

/// ΔVi and ΔVo over time.
pub fn slip(run: &RunData) -> Option<Figure> {
    let plot = with_time(run, Plot::new(620), "y2");
    let inner = "Sliding speed, inner<br>raceway ΔVi (m/s)";
    let plot = plot.y(inner, json!({ "domain": [0.54, 1.0], "anchor": "x" }));
    let outer = "Sliding speed, outer<br>raceway ΔVo (m/s)";
    let plot = plot.axis(
        "yaxis2",
        outer,
        json!({ "domain": [0.0, 0.46], "anchor": "x" }),
    );
    let kinds: [History; 2] = [|b| &b.inner_sliding_m_s, |b| &b.outer_sliding_m_s];
    let plot = of_balls(run, plot, &kinds, 1)?;
    let caption = format!(
        "Sliding speeds of ball 1 at the inner and the outer raceway over time; click a \
             ball in the legend to add it. Positive ΔVi speeds orbit and spin up, positive ΔVo \
             slows the orbit and speeds the spin up.{}",
        stretches(run)
    );
    Some(figure(run, "Slip", &caption, plot))
}

pub(super) fn figure(run: &RunData, label: &str, caption: &str, plot: Plot) -> Figure {
    Figure::new(label, caption, &run.provenance, plot)
}

/// The first ball that has a history: its number from 1, its rows, the first of them to be shown, and
/// what part of the run they are.
pub(crate) fn shown_ball(run: &RunData) -> Option<(usize, &BallHistory, usize, String)> {
    let first = run.balls.iter().position(|b| !b.angle_deg.is_empty())?;
    let (ball, from, part) = match &run.recent {
        Some(recent) => {
            let part = format!("after t = {} s", short(recent.from_s()));
            (recent.balls.get(first)?, 0, part)
        }
        None => (
            &run.balls[first],
            settled(run),
            "after the transient".to_owned(),
        ),
    };
    Some((first + 1, ball, from, part))
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
pub(super) fn with_time(run: &RunData, plot: Plot, anchor: &str) -> Plot {
    let times = run.time_s.iter().chain(&run.ring.time_s);
    let begin = times.clone().copied().reduce(f64::min).unwrap_or(0.0);
    let end = times.copied().fold(begin, f64::max);
    let shown = json!({ "anchor": anchor, "range": [number(begin), number(end)] });
    let mut plot = plot.x("Time t (s)", shown);
    if let Some(view) = run.view_s {
        plot = plot
            .view("last orbits", view)
            .view("whole run", [begin, end]);
    }
    plot.discarded("x", "paper", begin, run.settled_after_s.min(end))
}

/// A panel over time with one trace per ball.
fn per_ball(run: &RunData, title: &str, shown: usize, of: History) -> Option<Plot> {
    let format = if title.contains("°/s") { ",.0f" } else { "" };
    let plot = with_time(run, Plot::new(470), "y")
        .margin(Margin::above(30))
        .y(title, json!({ "tickformat": format }));
    of_balls(run, plot, &[of], shown)
}

/// Adds a trace per ball to each panel, which has one of the `kinds` of histories; ball 1 is drawn last and
/// strong, the first `shown` balls are shown at once, the others when asked for. `None` without histories.
fn of_balls(run: &RunData, mut plot: Plot, kinds: &[History], shown: usize) -> Option<Plot> {
    // Of selected balls all are shown alike.
    let selected = run.balls.iter().any(|ball| ball.angle_deg.is_empty());
    let mut any = false;
    for (of, y) in kinds.iter().zip(["y", "y2"]) {
        let balls = run.balls.iter().enumerate().rev();
        for (k, _) in balls.filter(|(_, ball)| !of(ball).is_empty()) {
            any = true;
            let history = run_history(run, k, *of, kinds.len() * run.balls.len());
            let strong = k == 0 || selected;
            let visible = match strong || k < shown {
                true => Value::Bool(true),
                false => "legendonly".into(),
            };
            let trace = line_of(
                &format!("ball {}", k + 1),
                history,
                PALETTE[k % PALETTE.len()],
            )
            .width(if strong { 1.8 } else { 1.0 })
            .dash(["solid", "dash", "dot"][k / PALETTE.len() % 3])
            .with(json!({ "visible": visible }))
            .in_group(&(k + 1).to_string(), y == "y");
            plot = plot.trace(trace.on(Axes { x: "x", y }));
        }
    }
    // One entry per ball, at the right.
    let legend = json!({
        "orientation": "v", "x": 1.01, "y": 1, "font": { "size": 11 }, "traceorder": "reversed",
    });
    any.then(|| plot.legend().set("legend", legend))
}

/// History of ball `k`: every row of the stretch that is shown first, few points before it.
fn run_history(run: &RunData, k: usize, of: History, traces: usize) -> Points {
    let all = run.balls.get(k).map_or(&[][..], |ball| of(ball).as_slice());
    let most = if k == 0 {
        4000
    } else {
        (POINTS_OF_ALL / traces.max(1)).clamp(800, 4000)
    };
    let Some([from, _]) = run.view_s else {
        return history(&run.time_s, all, most);
    };
    let before = run.time_s.partition_point(|t| *t < from).min(all.len());
    let Points { mut x, mut y } = history(
        &run.time_s[..before],
        &all[..before],
        most.min(POINTS_BEFORE),
    );
    // Of a long run only the recent rows follow one another.
    let (time, rows) = match &run.recent {
        Some(recent) => (
            recent.time_s.as_slice(),
            recent
                .balls
                .get(k)
                .map_or(&[][..], |ball| of(ball).as_slice()),
        ),
        None => (run.time_s.as_slice(), all),
    };
    let count = time.len().min(rows.len());
    let start = time[..count].partition_point(|t| *t < from);
    x.extend(&time[start..count]);
    y.extend(&rows[start..count]);
    Points { x, y }
}
