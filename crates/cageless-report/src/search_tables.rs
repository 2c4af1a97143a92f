//! Tables of a search.

use cageless::design::search::NEIGHBOURS_WIDER;

use crate::design::{MotionNumbers, PointNumbers, SearchData, StructureData};
use crate::table::{Cell, Row, Table};
use crate::text::fixed;

/// Rows of the front that are printed.
const FRONT_ROWS: usize = 24;

fn columns(names: &[(&str, bool)]) -> Vec<(String, bool)> {
    names
        .iter()
        .map(|&(name, numeric)| (name.to_owned(), numeric))
        .collect()
}

fn percent(share: Option<f64>, decimals: usize) -> String {
    fixed(share.map(|s| 100.0 * s), decimals)
}

/// A number of a structure at a point, its error and its decimals.
type Quantity = (
    &'static str,
    usize,
    fn(&PointNumbers) -> Option<f64>,
    Option<fn(&MotionNumbers) -> f64>,
);

/// Quantities printed for each design; the last function selects a result of the motion, which
/// may have an error.
const QUANTITIES: [Quantity; 14] = [
    ("critical gap (°)", 3, |n| n.critical_gap_deg, None),
    ("reserve (°)", 3, |n| n.margin_deg, None),
    (
        "critical gap below β0 (%)",
        1,
        |n| Some(100.0 * n.slip_shortfall?),
        None,
    ),
    (
        "peak contact pressure at rest, outer raceway (MPa)",
        0,
        |n| n.pressure_mpa,
        None,
    ),
    (
        "collisions per ball and orbit",
        3,
        |_| None,
        Some(|m| m.collisions),
    ),
    (
        "collisions per ball and orbit in steady state",
        3,
        |_| None,
        Some(|m| m.collisions_late),
    ),
    (
        "double collisions (%)",
        1,
        |_| None,
        Some(|m| 100.0 * m.double_collision_fraction),
    ),
    ("impulse (mN·s)", 3, |_| None, Some(|m| m.impulse_mn_s)),
    (
        "spacing scatter on arrival (% of the steady gap)",
        1,
        |_| None,
        Some(|m| 100.0 * m.spacing_scatter),
    ),
    (
        "smallest gap on arrival (°)",
        3,
        |_| None,
        Some(|m| m.gap_min_deg),
    ),
    ("sliding speed (m/s)", 3, |_| None, Some(|m| m.sliding_m_s)),
    (
        "achieved deceleration (% of kinematic value)",
        1,
        |_| None,
        Some(|m| 100.0 * m.speed_drop_fraction),
    ),
    ("vibration (N)", 2, |_| None, Some(|m| m.force_deviation_n)),
    (
        "power of sliding friction, whole run (W)",
        2,
        |_| None,
        Some(|m| m.friction_w),
    ),
];

/// `0.052 ± 0.004`, or without the error if there is none.
fn shown(quantity: &Quantity, n: &PointNumbers) -> String {
    let (_, decimals, plain, of_motion) = quantity;
    let Some(of) = of_motion else {
        return fixed(plain(n), *decimals);
    };
    let value = fixed(n.motion.as_ref().map(of), *decimals);
    match &n.errors {
        Some(errors) => format!("{value} ± {}", fixed(Some(of(errors)), *decimals)),
        None => value,
    }
}

/// The recommendation beside the case's own structure.
pub fn comparison(search: &SearchData) -> Table {
    let structures: Vec<(&str, &StructureData)> = [
        ("recommended", &search.recommended),
        ("initial design", &search.own),
    ]
    .into_iter()
    .filter_map(|(role, s)| s.as_ref().map(|s| (role, s)))
    .collect();
    let mut head = columns(&[("", false)]);
    for _ in &structures {
        head.extend(search.points.iter().map(|p| (p.label(), true)));
    }
    let mut groups = vec![(String::new(), 1)];
    groups.extend(
        structures
            .iter()
            .map(|(role, s)| (format!("{role}: {}", s.label()), search.points.len())),
    );
    let row = |name: &str, cell: &dyn Fn(&StructureData, &PointNumbers) -> String| {
        let mut cells = vec![Cell::text(name)];
        for (_, structure) in &structures {
            cells.extend(
                structure
                    .points
                    .iter()
                    .map(|n| Cell::number(cell(structure, n))),
            );
        }
        Row {
            cells,
            ..Row::default()
        }
    };
    let mut rows = vec![
        row("β0 of Eq. (11) (°)", &|s, _| fixed(s.beta0_deg, 3)),
        row("steady gap (°)", &|s, _| fixed(s.steady_gap_deg, 3)),
    ];
    rows.extend(
        QUANTITIES
            .iter()
            .map(|quantity| row(quantity.0, &|_, n| shown(quantity, n))),
    );
    Table {
        label: "Comparison".to_owned(),
        caption: format!(
            "From at least twelve unevenly spaced starts, ± standard error of the mean. Critical gaps are measured with the neighbours of the \
                  pair {:.0} % further off than at even spacing. Reserve: \
                  steady-state gap less critical gap. Critical gap below β0: shortfall of the \
                  critical gap below β0. Achieved deceleration: lowest orbital speed in the raceway \
                  against pure rolling. Steady state: second half of the run. \
                  Spacing scatter: standard deviation of the gaps on arrival over the steady gap. \
                  Vibration: standard deviation of the force on the outer ring.",
            100.0 * (NEIGHBOURS_WIDER - 1.0)
        ),
        groups,
        columns: head,
        rows,
        provenance: Some(search.provenance.clone()),
    }
}

/// Number of designs excluded by each reason.
pub fn rejections(search: &SearchData) -> Table {
    Table {
        label: "Rejections".to_owned(),
        caption: "Structures of the maps at the operating points and of the band between them \
                  that each requirement excludes; a design is counted under the first that fails."
            .to_owned(),
        columns: columns(&[
            ("requirement", false),
            ("structures", true),
            ("meaning", false),
        ]),
        rows: search
            .rejections
            .iter()
            .map(|r| Row {
                cells: vec![
                    Cell::text(&r.reason),
                    Cell::number(r.count.to_string()),
                    Cell::text(&r.meaning),
                ],
                ..Row::default()
            })
            .collect(),
        ..Table::default()
    }
}

/// Places of the raceways.
pub fn placements(search: &SearchData) -> Table {
    let mut head = columns(&[
        ("ψ of the middles (°)", false),
        ("evaluated", true),
        ("acceptable", true),
        ("sliding lowers the critical gap by at least (%)", true),
        ("best", false),
    ]);
    head.extend(columns(&[
        ("margin (°)", true),
        ("collisions in steady state", true),
        ("spacing scatter on arrival (%)", true),
        ("friction (W)", true),
    ]));
    let rows = search
        .placements
        .iter()
        .map(|p| {
            let places: Vec<String> = p
                .centre_angles_deg
                .iter()
                .map(|c| fixed(Some(*c), 0))
                .collect();
            let first = p.best.as_ref().and_then(|b| b.points.first());
            let mut cells = vec![
                Cell::text(places.join(", ")),
                Cell::number(p.structures.to_string()),
                Cell::number(p.accepted.to_string()),
                Cell::number(percent(p.least_shortfall, 1)),
                Cell::text(p.best.as_ref().map_or("–".to_owned(), |b| {
                    format!("lC {:.3} mm, θ {:.2}°", b.axial_span_mm, b.half_angle_deg)
                })),
            ];
            cells.extend(
                [
                    fixed(first.and_then(|n| n.margin_deg), 3),
                    fixed(first.and_then(|n| Some(n.motion?.collisions_late)), 3),
                    percent(first.and_then(|n| Some(n.motion?.spacing_scatter)), 1),
                    fixed(first.and_then(|n| Some(n.motion?.friction_w)), 2),
                ]
                .map(Cell::number),
            );
            Row {
                cells,
                ..Row::default()
            }
        })
        .collect();
    Table {
        label: "Places".to_owned(),
        caption: "Where and how many: places of the raceways, with the best acceptable structure \
                  at each (numbers at the first operating point)."
            .to_owned(),
        columns: head,
        rows,
        ..Table::default()
    }
}

/// The Pareto front.
pub fn front(search: &SearchData) -> Table {
    let several = search.placements.len() > 1;
    let mut head = columns(&[("lC (mm)", true), ("θ (°)", true)]);
    if several {
        head.push(("ψ (°)".to_owned(), false));
    }
    head.extend(QUANTITIES.iter().map(|q| (q.0.to_owned(), true)));
    let rows = search
        .front
        .iter()
        .take(FRONT_ROWS)
        .filter_map(|structure| {
            let n = structure.points.first()?;
            let mut cells = vec![
                Cell::number(fixed(Some(structure.axial_span_mm), 3)),
                Cell::number(fixed(Some(structure.half_angle_deg), 2)),
            ];
            if several {
                let places = structure.centre_angles_deg.iter();
                let places: Vec<String> = places.map(|c| fixed(Some(*c), 0)).collect();
                cells.push(Cell::text(places.join(", ")));
            }
            cells.extend(QUANTITIES.iter().map(|q| Cell::number(shown(q, n))));
            Some(Row {
                cells,
                ..Row::default()
            })
        })
        .collect();
    let accepted = search.band.iter().filter(|s| s.status == "accepted");
    let feasible = accepted.count();
    Table {
        label: "Pareto front".to_owned(),
        caption: format!(
            "Pareto-optimal designs, sorted by distance from the ideal point{} ({} of {} shown; \
             numbers at the first operating point, from {} uneven starts).",
            if search.front.len() == feasible {
                ". All feasible designs are among them: each is the best compromise for some weights \
                 of the objectives, so that the order alone tells them apart"
            } else {
                ""
            },
            search.front.len().min(FRONT_ROWS),
            search.front.len(),
            search.starts
        ),
        columns: head,
        rows,
        ..Table::default()
    }
}
