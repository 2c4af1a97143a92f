//! Results of a measured ring.

use crate::cell::Cell;
use crate::declare::*;
use crate::quantity::Quantity;
use crate::source::Source::{Dimension, Ring};

/// The ring as a whole.
#[rustfmt::skip]
pub const MEASURED: &[Quantity] = &[
    means("every dimension with a tolerance within it by more than its uncertainty; nothing where the limit of one lies within its uncertainty and none is out", part(high(flag("passes", "passes", Ring(|r| flagged(r.passes)))))),
    part(text("headline", "verdict with its reason", Ring(|r| Cell::Text(r.headline.clone())))),
    part(integer("points", "points of the file", Ring(|r| count(r.points)))),
    part(integer("points_used", "points of the groove that are used", Ring(|r| count(r.ring.used)))),
    means("shoulders, faces and the surroundings of slots, and what is more than 1 mm off", part(integer("points_elsewhere", "points of other faces", Ring(|r| count(r.ring.elsewhere))))),
    means("beyond five robust standard deviations from the fitted groove, left out", part(low(integer("outliers", "outliers", Ring(|r| count(r.outlier_lines.len())))))),
    file_only(integer("outlier_lines", "lines of the outliers in the file (list)", Ring(|r| Cell::List(r.outlier_lines.iter().map(|line| count(*line)).collect())))),
    means("of the points of the plain groove, 1.4826 times the median distance", part(low(quantity("scatter_um", "um", "robust standard deviation", Ring(|r| some(r.ring.deviation_m * 1e6)))))),
];

/// Where the ring lies in the machine, and radii of its groove, against the drawing.
#[rustfmt::skip]
pub const FRAME: &[Quantity] = &[
    part(in_tables(text("name", "frame", Dimension(|d| Cell::Text(d.name.to_owned()))))),
    part(in_tables(text("unit", "unit", Dimension(|d| Cell::Text(d.unit.to_owned()))))),
    part(quantity("measured", "", "measured", Dimension(|d| some(d.measured.value)))),
    means("k = 2, from the scatter of the points (GUM, JCGM 100)", part(low(quantity("expanded_uncertainty", "", "expanded uncertainty U", Dimension(|d| some(d.measured.expanded())))))),
];

/// A dimension of a raceway.
#[rustfmt::skip]
pub const DIMENSION: &[Quantity] = &[
    part(in_tables(text("name", "dimension", Dimension(|d| Cell::Text(d.name.to_owned()))))),
    part(in_tables(text("unit", "unit", Dimension(|d| Cell::Text(d.unit.to_owned()))))),
    part(quantity("drawn", "", "drawn", Dimension(|d| some(d.drawn)))),
    part(quantity("measured", "", "measured", Dimension(|d| some(d.measured.value)))),
    means("k = 2, from the scatter of the points (GUM, JCGM 100)", part(low(quantity("expanded_uncertainty", "", "expanded uncertainty U", Dimension(|d| some(d.measured.expanded())))))),
    part(quantity("tolerance", "", "tolerance, to either side", Dimension(|d| d.tolerance.into()))),
    means("within, out or not decided, where the limit lies within the uncertainty (ISO 14253-1); nothing without a tolerance", part(in_tables(text("verdict", "verdict", Dimension(|d| d.conformity().map_or(Cell::Null, |c| Cell::Text(c.name().to_owned()))))))),
];
