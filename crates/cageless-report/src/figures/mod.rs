//! The figures, each a function of its data, and those of pages by name.

pub mod axial_load;
pub mod ball;
pub mod collisions;
pub mod compare;
pub mod comparison;
pub mod contact_angles;
pub mod design;
pub mod energy;
pub mod gap_map;
pub mod groove;
pub mod history;
pub mod orbit;
pub(crate) mod panels;
pub mod phase;
pub mod polar;
pub mod ring;
pub mod search;
pub mod shape;
pub mod spacing;
pub mod sweep;
pub mod vibration;

use cageless_results::Record;

use crate::figure::Figure;
use crate::tolerance::{influence_figure, sample_figure};
use crate::{DesignData, RunData, SweepData};

/// A figure by name.
pub struct Named<D: 'static> {
    /// Name.
    pub name: &'static str,
    /// Subject of the figure.
    pub about: &'static str,
    /// The figure, if there is anything to show.
    pub draw: fn(&D) -> Option<Figure>,
}

const fn named<D: 'static>(
    name: &'static str,
    about: &'static str,
    draw: fn(&D) -> Option<Figure>,
) -> Named<D> {
    Named { name, about, draw }
}

/// Figures of a run under the headings of its page, in its order.
#[rustfmt::skip]
pub const RUN: [(&str, &[Named<RunData>]); 5] = [
    (
        SPACING,
        &[
            named("gap_map", "smallest gap of each pair of neighbours over time, as colours", gap_map::gap_map),
            named("gaps", "gaps between neighbours over time", history::gaps),
            named("collisions", "contacts between balls: where, when, how hard", collisions::collisions),
        ],
    ),
    (
        "Loads, pressures and the inner ring",
        &[
            named("load_profile", "loads and pressures of all balls around the bearing, of the last orbits", polar::loads),
            named("ring_orbit", "orbit of the inner ring's centre", ring::ring_orbit),
            named("energy", "energy balance of the whole run", energy::energy),
        ],
    ),
    (
        "Motion of the balls",
        &[
            named("orbit_speed", "orbital speed of the balls over time", history::orbit_speed),
            named("sliding", "sliding speeds at the raceways", history::slip),
        ],
    ),
    (
        "Ball 1",
        &[
            named("loads", "forces on a ball at the raceways over ψ", ball::loads),
            named("contact_angles", "contacts of a ball on the unrolled grooves, of a run in space", contact_angles::contact_angles),
            named("groove", "a ball with its contact track on the outer groove in three dimensions, of a run in space", groove::groove),
            named("phase", "phase portrait of a ball", ball::phase),
        ],
    ),
    (
        "Vibration",
        &[named(
            "vibration",
            "vibration of the outer ring on its housing, spectrum of the whole run",
            |data| {
                let measured = data.vibration.as_ref()?;
                Some(vibration::vibration("Vibration", measured))
            },
        )],
    ),
];

/// The heading whose figures the motion of the balls follows.
pub(crate) const SPACING: &str = "Spacing and collisions";

/// Figures of a design.
#[rustfmt::skip]
pub const DESIGN: [Named<DesignData>; 5] = [
    named("curve", "θ over lC by Eq. (11), with the raceway and the limits", |data| data.curve.as_ref().map(design::curve)),
    named("contact_track", "contact track of the first raceway", |data| data.contact_track.as_ref().map(shape::contact_track)),
    named("surface", "surface of the first raceway", |data| data.surface.as_ref().map(shape::surface)),
    named("axial_load", "lag in the raceway over the axial load, of a design with axial loads", |data| data.axial.as_ref().map(axial_load::axial_load)),
    named("axial_gap", "critical gap over the axial load, of a design with axial loads", |data| data.axial.as_ref().map(axial_load::axial_gap)),
];

/// Figures of a search.
#[rustfmt::skip]
pub const SEARCH: [Named<Record>; 3] = [
    named("verdicts", "feasible designs and reasons for exclusion", |data| Some(search::verdicts(data))),
    named("critical_gaps", "critical gap over lC and θ", |data| Some(search::critical_gaps(data))),
    named("trade_offs", "trade-offs of the Pareto front", |data| (!data.parts("front").is_empty()).then(|| search::trade_offs(data))),
];

/// Figures of a tolerance analysis.
#[rustfmt::skip]
pub const TOLERANCE: [Named<Record>; 2] = [
    named("influences", "range of the critical gap over each influence", |data| Some(influence_figure(data))),
    named("samples", "critical gaps of the bearings in which everything deviates, by verdict", |data| data.part("samples").map(|s| sample_figure(data, s))),
];

/// Figures of the analysis of a sweep that are about all of its outputs.
#[rustfmt::skip]
pub const SWEEP: [Named<SweepData>; 1] = [named("shares", "sensitivity (main effects)", |data| {
    let varies = !data.outputs.is_empty() && !data.inputs.is_empty();
    varies.then(|| sweep::shares(data))
})];

/// Figures of the analysis of a sweep that are about one of its outputs.
#[rustfmt::skip]
const OF_OUTPUT: [(&str, &str); 2] = [
    ("effects", "means of an output over the inputs that explain most of it"),
    ("map", "mean of an output over the two inputs that explain most of it"),
];

/// Name, anchor on the page and meaning of the figures of a drop.
#[rustfmt::skip]
const DROP: [[&str; 3]; 10] = [
    ["orbit", "orbit", "path of the journal in the bore of the inner ring"],
    ["displacement", "displacement", "path of the journal from the centre of the stator, with its clearance"],
    ["spin_up", "spin-up", "speeds of rotor and inner ring over time"],
    ["forces", "forces", "forces of the rotor on the inner ring and of the balls on the outer ring over time"],
    ["whirl", "whirl", "whirl frequency and contact over time"],
    ["along_axis", "along-the-axis", "motion of rotor and inner ring along the axis and force of a shoulder over time, of a drop in space"],
    ["loads", "loads-of-the-balls", "largest forces of each ball"],
    ["heat", "heat-of-the-interfaces", "heat of each interface"],
    ["temperatures", "temperatures", "temperatures of rings and balls drop after drop"],
    ["end_states", "state-at-the-end", "states at the end of scattered drops over friction and support damping"],
];

/// Name, anchor on the page and meaning of the figures of a comparison.
#[rustfmt::skip]
const COMPARISON: [[&str; 3]; 3] = [
    ["spacing", "scatter-of-the-gaps", "standard deviation of the gaps over time"],
    ["ring", "height-of-the-inner-ring", "height of the inner ring over time"],
    ["loads", "largest-loads", "largest loads at the inner raceway around the bearing"],
];

/// Name, anchor on the page and meaning of the figures of a static equilibrium.
#[rustfmt::skip]
const STATIC: [[&str; 3]; 1] = [
    ["loads", "load-distribution", "contact forces and pressures of each ball over ψ"],
];

fn on_page(kind: &str) -> &'static [[&'static str; 3]] {
    match kind {
        "static" => &STATIC,
        "drop" => &DROP,
        "comparison" => &COMPARISON,
        _ => &[],
    }
}

/// Names of the figures of a kind of result, with what each shows.
pub fn of_kind(kind: &str) -> Vec<(&'static str, &'static str)> {
    fn names<D: 'static>(figures: &[Named<D>]) -> Vec<(&'static str, &'static str)> {
        figures.iter().map(|f| (f.name, f.about)).collect()
    }
    match kind {
        "run" => RUN.iter().flat_map(|(_, figures)| names(figures)).collect(),
        "design" => names(&DESIGN),
        "search" => names(&SEARCH),
        "tolerance" => names(&TOLERANCE),
        "analysis" => [names(&SWEEP), OF_OUTPUT.to_vec()].concat(),
        kind => on_page(kind)
            .iter()
            .map(|[name, _, about]| (*name, *about))
            .collect(),
    }
}

/// A figure of the page of a kind of result, in the JSON of plotly; `name` ends in `-bearing-2` for
/// the second bearing of several.
pub fn in_page<'p>(page: &'p str, kind: &str, name: &str) -> Option<&'p str> {
    let (name, bearing) = name.split_at(name.find('-').unwrap_or(name.len()));
    let [_, anchor, _] = on_page(kind).iter().find(|[n, ..]| *n == name)?;
    let begin = format!("<script type=\"application/json\" id=\"{anchor}{bearing}-spec\">");
    let (_, rest) = page.split_once(&begin)?;
    Some(rest.split_once("</script>")?.0)
}
