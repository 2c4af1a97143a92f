//! The page of a drop of a rotor.

use std::f64::consts::TAU;

use cageless::contact::hertz::STRESS_LIMIT_PA;
use cageless::{Case, RotorSnapshot, Snapshot};
use cageless_io::results::VERSION;
use cageless_study::drop::{DropRecord, DropResult, EnsembleResult};
use cageless_study::{Provenance, parameter, provenance};
use serde_json::json;

use crate::figure::Figure;
use crate::head::Head;
use crate::motion::MotionFigure;
use crate::page::Page;
use crate::plot::{GREY, PALETTE, Plot, line, markers, numbers, with};
use crate::run_report::motion;
use crate::sampling::history;
use crate::table::{Cell, Row, Table};
use crate::text::short;

/// Points of a trace over time.
const POINTS: usize = 3000;
/// Time before and after the first contact that the animation starts with, s.
const FIRST_IMPACT_S: [f64; 2] = [1e-3, 6e-3];

/// A drop and what is shown beside it.
pub struct DropReport<'d> {
    /// The case.
    pub case: &'d Case,
    /// The drop.
    pub drop: &'d DropRecord,
    /// The same with a conventional outer ring.
    pub conventional: Option<&'d DropRecord>,
    /// Scattered drops.
    pub ensemble: Option<&'d EnsembleResult>,
}

/// The self-contained page of a drop.
pub fn drop_page(report: &DropReport<'_>) -> String {
    let (case, record) = (report.case, report.drop);
    let title = match case.title.as_str() {
        "" => "Drop of a rotor",
        title => title,
    };
    let source = provenance(case, String::new());
    let mut page = Page::new(title, "", &format!("Cageless {VERSION}"));
    page.head(&head(&record.result));
    page.section("Results");
    page.table(&results(report, &source));
    page.section("Rotor and inner ring");
    let rotors = rotors(&record.snapshots);
    for figure in [
        orbit(case, &record.snapshots, &source),
        speeds(&rotors, &source),
        forces(case, &record.snapshots, &source),
        whirl(&record.result, &source),
    ] {
        page.figure(&figure);
    }
    page.section("Balls");
    page.figure(&loads(report, &source));
    page.motion(&balls_in_motion(report, &source));
    page.section("Energy");
    page.figure(&heat(report, &source));
    if let Some(ensemble) = report.ensemble {
        page.section("Scattered drops");
        page.table(&distribution(ensemble, &source));
        page.figure(&scatter(ensemble, &source));
    }
    page.html()
}

fn head(result: &DropResult) -> Head {
    let fact =
        |name: &str, value: Option<f64>, unit: &str| value.map(|v| parameter(name, short(v), unit));
    let limit_mpa = 1e-6 * STRESS_LIMIT_PA;
    let stress = result.inner_stress_max_mpa.max(result.outer_stress_max_mpa);
    let state = format!(
        "At the end of {} s: {}",
        short(result.end_s),
        words(&result.end_state)
    );
    let passes = match result.end_state.as_str() {
        "backward-whirl" => Some(false),
        _ if stress > limit_mpa => Some(false),
        _ => None,
    };
    let facts = [
        fact("First contact", result.first_contact_ms, "ms"),
        fact(
            "Largest force on the rotor",
            result.rotor_force_max_weights,
            "× weight",
        ),
        fact("Spin-up of the inner ring", result.spin_up_ms, "ms"),
        fact(
            "Largest contact pressure (ISO 76: 4200)",
            Some(stress),
            "MPa",
        ),
        fact(
            "Collisions between balls",
            Some(result.collisions as f64),
            "",
        ),
        fact("Heat of all interfaces", Some(result.heat_j()), "J"),
    ];
    Head::new(passes, &state).facts(facts.into_iter().flatten())
}

/// A state at the end in words.
fn words(state: &str) -> String {
    match state {
        "at-rest" => "at rest in the bottom".to_owned(),
        other => other.replace('-', " "),
    }
}

fn results(report: &DropReport<'_>, source: &Provenance) -> Table {
    let mut columns = vec![("Result".to_owned(), false), ("This drop".to_owned(), true)];
    let beside = report.conventional.map(|other| other.result.quantities());
    if beside.is_some() {
        columns.push(("Conventional outer ring".to_owned(), true));
    }
    columns.push(("Unit".to_owned(), false));
    let value = |v: Option<f64>| Cell::number(v.map_or("–".to_owned(), short));
    let mut state = vec![
        Cell::text("state at the end"),
        Cell::number(words(&report.drop.result.end_state)),
    ];
    state.extend(
        report
            .conventional
            .map(|o| Cell::number(words(&o.result.end_state))),
    );
    state.push(Cell::text(""));
    let mut rows = vec![Row {
        cells: state,
        ..Row::default()
    }];
    for (k, (name, unit, own)) in report.drop.result.quantities().into_iter().enumerate() {
        let mut cells = vec![Cell::text(name), value(own)];
        cells.extend(beside.as_ref().map(|other| value(other[k].2)));
        cells.push(Cell::text(unit));
        rows.push(Row {
            cells,
            ..Row::default()
        });
    }
    Table {
        label: "Results".to_owned(),
        caption: "From the moment at which the magnets let go to the end of the run.".to_owned(),
        columns,
        rows,
        provenance: Some(source.clone()),
        ..Table::default()
    }
}

fn rotors(snapshots: &[Snapshot]) -> Vec<(f64, RotorSnapshot)> {
    (snapshots.iter())
        .filter_map(|s| Some((1e3 * s.time_s, s.rotor?)))
        .collect()
}

fn figure(label: &str, caption: &str, source: &Provenance, plot: Plot) -> Figure {
    Figure {
        label: label.to_owned(),
        caption: caption.to_owned(),
        provenance: source.clone(),
        plot,
    }
}

/// Path of the journal in the bore, with the circle of the air gap.
fn orbit(case: &Case, snapshots: &[Snapshot], source: &Provenance) -> Figure {
    let Some(rotor) = &case.rotor else {
        return figure("Orbit", "", source, Plot::new(200));
    };
    let (mut x, mut y) = (Vec::new(), Vec::new());
    for s in snapshots {
        let Some(r) = s.rotor else { continue };
        let (sin, cos) = (r.angle_rad + rotor.eccentricity_phase_rad).sin_cos();
        x.push(1e6 * (r.x_m - rotor.eccentricity_m * cos - s.ring.x_m));
        y.push(1e6 * (r.y_m - rotor.eccentricity_m * sin - s.ring.y_m));
    }
    let gap = 1e6 * rotor.air_gap_m;
    let circle: Vec<f64> = (0..=120).map(|k| TAU * f64::from(k) / 120.0).collect();
    let of = |f: fn(f64) -> f64| -> Vec<f64> { circle.iter().map(|a| gap * f(*a)).collect() };
    let last = x.len().saturating_sub(1);
    let mut plot = Plot::new(560)
        .legend()
        .axis(
            "xaxis",
            "x of the journal in the bore (µm)",
            json!({ "constrain": "domain" }),
        )
        .axis(
            "yaxis",
            "y (µm)",
            json!({ "scaleanchor": "x", "scaleratio": 1, "constrain": "domain" }),
        )
        .trace(with(
            line("air gap", &of(f64::cos), &of(f64::sin), GREY),
            json!({ "line": { "dash": "dot" } }),
        ))
        .trace(line("centre of the journal", &x, &y, PALETTE[0]));
    if let (Some(x), Some(y)) = (x.get(last), y.get(last)) {
        plot = plot.trace(markers("end", &[*x], &[*y], PALETTE[1]));
    }
    figure(
        "Orbit",
        "Centre of the journal relative to the centre of the inner ring. Beyond the dotted circle, \
         the air gap, it is in contact.",
        source,
        plot,
    )
}

/// Time axis in ms.
fn over_time(height: u32, title: &str) -> Plot {
    Plot::new(height)
        .legend()
        .axis("xaxis", "Time since the magnets let go (ms)", json!({}))
        .axis("yaxis", title, json!({}))
}

fn trace(name: &str, rows: &[(f64, f64)], colour: &str) -> serde_json::Value {
    let (x, y): (Vec<f64>, Vec<f64>) = rows.iter().copied().unzip();
    let (x, y) = history(&x, &y, POINTS);
    line(name, &x, &y, colour)
}

/// Speeds of rotor and inner ring.
fn speeds(rotors: &[(f64, RotorSnapshot)], source: &Provenance) -> Figure {
    let of = |f: fn(&RotorSnapshot) -> f64| -> Vec<(f64, f64)> {
        rotors
            .iter()
            .map(|(t, r)| (*t, 60.0 / TAU * f(r)))
            .collect()
    };
    let plot = over_time(380, "Speed (rpm)")
        .trace(trace("rotor", &of(|r| r.speed_rad_s), PALETTE[1]))
        .trace(trace("inner ring", &of(|r| r.ring_speed_rad_s), PALETTE[0]));
    figure(
        "Spin-up",
        "Speed of the rotor and of the inner ring that it drives by friction, counter-clockwise \
         positive.",
        source,
        plot,
    )
}

/// Forces as multiples of the weight of the rotor.
fn forces(case: &Case, snapshots: &[Snapshot], source: &Provenance) -> Figure {
    let weight = case.rotor.as_ref().map_or(0.0, |r| r.mass_kg) * case.operation.gravity_m_s2;
    let (scale, unit) = if weight > 0.0 {
        (1.0 / weight, "Force / weight of the rotor")
    } else {
        (1.0, "Force (N)")
    };
    let contact: Vec<(f64, f64)> = (snapshots.iter())
        .filter_map(|s| Some((1e3 * s.time_s, scale * s.rotor?.contact_force_n)))
        .collect();
    let outer: Vec<(f64, f64)> = (snapshots.iter())
        .map(|s| {
            let force = s.ring.outer_force_x_n.hypot(s.ring.outer_force_y_n);
            (1e3 * s.time_s, scale * force)
        })
        .collect();
    let plot = over_time(400, unit)
        .trace(trace("balls on the outer ring", &outer, PALETTE[2]))
        .trace(trace("rotor on the inner ring", &contact, PALETTE[0]));
    figure(
        "Forces",
        "Normal force between rotor and inner ring and the force of the balls on the outer ring, \
         at the output interval: peaks between two rows are in the table only.",
        source,
        plot,
    )
}

/// Whirl frequency over time.
fn whirl(result: &DropResult, source: &Provenance) -> Figure {
    let rows = &result.whirl;
    let time: Vec<f64> = rows.iter().map(|w| w.time_ms).collect();
    let frequency: Vec<f64> = rows.iter().map(|w| w.frequency_hz).collect();
    let contact: Vec<f64> = rows.iter().map(|w| 100.0 * w.contact_fraction).collect();
    let plot = over_time(420, "Whirl frequency (Hz)")
        .axis(
            "yaxis",
            "Whirl frequency (Hz)",
            json!({ "domain": [0.42, 1.0] }),
        )
        .axis(
            "yaxis2",
            "Contact (%)",
            json!({ "domain": [0.0, 0.3], "range": [0, 105] }),
        )
        .axis(
            "xaxis",
            "Time since the magnets let go (ms)",
            json!({ "anchor": "y2" }),
        )
        .set("showlegend", json!(false))
        .horizontal("x", "y", 0.0, "dot")
        .trace(line("whirl frequency", &time, &frequency, PALETTE[3]))
        .trace(with(
            line("contact", &time, &contact, PALETTE[2]),
            json!({ "yaxis": "y2" }),
        ));
    figure(
        "Whirl",
        "Mean frequency at which the journal goes round the bore, window by window, and the part \
         of each window in contact. Negative: against the rotation of a rotor that turns \
         counter-clockwise.",
        source,
        plot,
    )
}

/// Peak load of every ball.
fn loads(report: &DropReport<'_>, source: &Provenance) -> Figure {
    let mut plot = Plot::new(380)
        .legend()
        .set("barmode", json!("group"))
        .axis("xaxis", "Ball", json!({ "dtick": 1 }))
        .axis(
            "yaxis",
            "Largest normal force (N)",
            json!({ "rangemode": "tozero" }),
        );
    let mut bars = |name: &str, forces: &[f64], colour: &str| {
        let balls: Vec<usize> = (1..=forces.len()).collect();
        plot = plot.clone().trace(json!({
            "type": "bar", "name": name, "x": balls, "y": numbers(forces),
            "marker": { "color": colour },
        }));
    };
    let own = &report.drop.result;
    bars("inner raceway", &own.inner_force_max_n, PALETTE[0]);
    bars("outer raceway", &own.outer_force_max_n, PALETTE[5]);
    if let Some(other) = report.conventional {
        let forces = &other.result.inner_force_max_n;
        bars("inner raceway, conventional ring", forces, GREY);
    }
    figure(
        "Loads of the balls",
        &format!(
            "Largest normal force of each ball in the whole drop. The largest pressures are {} MPa \
             at the inner and {} MPa at the outer raceway; 4200 MPa is the limit of ISO 76.",
            short(own.inner_stress_max_mpa),
            short(own.outer_stress_max_mpa)
        ),
        source,
        plot,
    )
}

fn balls_in_motion(report: &DropReport<'_>, source: &Provenance) -> MotionFigure {
    let case = report.case;
    let mut bearings = vec![motion(
        case,
        "this drop",
        &report.drop.snapshots,
        source.clone(),
    )];
    if let Some(other) = report.conventional {
        let plain = case.with_raceways(vec![]);
        let title = "conventional outer ring";
        bearings.push(motion(&plain, title, &other.snapshots, source.clone()));
    }
    let end = report.drop.result.end_s;
    let mut stretches = vec![];
    if let Some(ms) = report.drop.result.first_contact_ms {
        let first = 1e-3 * ms;
        let [before, after] = FIRST_IMPACT_S;
        let around = [(first - before).max(0.0), (first + after).min(end)];
        stretches.push(("first impact".to_owned(), around));
    }
    stretches.push(("whole drop".to_owned(), [0.0, end]));
    MotionFigure {
        label: "Motion of the balls".to_owned(),
        caption:
            "The balls from the moment at which the magnets let go, to scale; red: balls that \
                  touch."
                .to_owned(),
        bearings,
        moments_s: vec![],
        stretches,
    }
}

/// Heat of each interface.
fn heat(report: &DropReport<'_>, source: &Provenance) -> Figure {
    let items = |r: &DropResult| {
        [
            ("rotor on ring, friction", r.rotor_friction_j),
            ("rotor on ring, damping", r.rotor_damping_j),
            ("inner raceway", r.inner_friction_j),
            ("outer raceway", r.outer_friction_j),
            ("between balls", r.ball_friction_j),
            ("damping of the balls' contacts", r.contact_damping_j),
            ("support", r.support_damping_j),
        ]
    };
    let mut plot = Plot::new(420)
        .legend()
        .set("barmode", json!("group"))
        .set("margin", json!({ "l": 190, "r": 24, "t": 44, "b": 58 }))
        .axis("xaxis", "Heat (J)", json!({ "rangemode": "tozero" }))
        .axis("yaxis", "", json!({ "autorange": "reversed" }));
    let drops = [
        ("this drop", Some(report.drop), PALETTE[1]),
        ("conventional outer ring", report.conventional, GREY),
    ];
    for (name, record, colour) in drops {
        let Some(record) = record else { continue };
        let (names, values): (Vec<&str>, Vec<f64>) = items(&record.result).into_iter().unzip();
        plot = plot.trace(json!({
            "type": "bar", "orientation": "h", "name": name, "y": names, "x": numbers(&values),
            "marker": { "color": colour },
        }));
    }
    figure(
        "Heat of the interfaces",
        &format!(
            "Heat of each interface since the magnets let go. The energy balance closes to {:.1e} of \
             all terms.",
            report.drop.result.energy_residual_relative
        ),
        source,
        plot,
    )
}

fn distribution(ensemble: &EnsembleResult, source: &Provenance) -> Table {
    let ends: Vec<String> = (ensemble.end_states.iter())
        .map(|entry| format!("{} {}", entry.count, words(&entry.end_state)))
        .collect();
    let whirl = match (
        ensemble.backward_whirl_probability,
        ensemble.backward_whirl_interval,
    ) {
        (Some(p), Some([low, high])) => format!(
            " Probability of backward whirl: {:.1} % (95 %: {:.1} to {:.1} %).",
            1e2 * p,
            1e2 * low,
            1e2 * high
        ),
        _ => String::new(),
    };
    Table {
        label: "Distribution".to_owned(),
        caption: format!(
            "{} drops with scattered friction (±30 %), air gap (±10 %), support damping (factor 2), \
             direction of the unbalance and arrangement of the balls (seed {}): {}.{whirl}",
            ensemble.completed,
            ensemble.seed,
            ends.join(", ")
        ),
        columns: [
            ("Result", false),
            ("Least", true),
            ("Median", true),
            ("95 %", true),
            ("Largest", true),
            ("Unit", false),
        ]
        .map(|(text, numeric)| (text.to_owned(), numeric))
        .to_vec(),
        rows: (ensemble.quantiles.iter())
            .map(|q| Row {
                cells: vec![
                    Cell::text(&q.name),
                    Cell::number(short(q.least)),
                    Cell::number(short(q.median)),
                    Cell::number(short(q.high)),
                    Cell::number(short(q.most)),
                    Cell::text(&q.unit),
                ],
                ..Row::default()
            })
            .collect(),
        provenance: Some(source.clone()),
        ..Table::default()
    }
}

/// State at the end over friction and support damping.
fn scatter(ensemble: &EnsembleResult, source: &Provenance) -> Figure {
    let damped = ensemble
        .drops
        .iter()
        .any(|d| d.support_damping_n_s_m.is_some());
    let title = if damped {
        "Damping of the support (N·s/m)"
    } else {
        "Radial air gap (µm)"
    };
    let mut plot = Plot::new(420)
        .legend()
        .axis(
            "xaxis",
            "Friction coefficient between rotor and inner ring",
            json!({}),
        )
        .axis("yaxis", title, json!({}));
    for (k, entry) in ensemble.end_states.iter().enumerate() {
        let of_state = || {
            let rows = ensemble.drops.iter();
            rows.filter(|d| d.result.end_state == entry.end_state)
        };
        let x: Vec<f64> = of_state().map(|d| d.rotor_friction).collect();
        let y: Vec<f64> = of_state()
            .map(|d| d.support_damping_n_s_m.unwrap_or(d.air_gap_um))
            .collect();
        let name = words(&entry.end_state);
        plot = plot.trace(markers(&name, &x, &y, PALETTE[k % PALETTE.len()]));
    }
    figure(
        "State at the end",
        "State of each drop at its end over what was drawn for it.",
        source,
        plot,
    )
}
