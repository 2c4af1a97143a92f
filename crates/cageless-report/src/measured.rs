//! The page of a measured ring.

use cageless::surface::PointOff;
use cageless_results::{Record, measured_rows, software};
use cageless_study::measured::Measured;
use cageless_study::{Provenance, lines};
use serde_json::{Value, json};

use crate::figure::Figure;
use crate::head::Head;
use crate::length::{mm, um};
use crate::page::{Note, Page};
use crate::plot::{Margin, Plot, number, numbers};
use crate::table::Table;

/// Most cells of the map along ψ and across the groove.
const CELLS: [f64; 2] = [120.0, 30.0];
/// Points of a cell in the mean.
const POINTS_PER_CELL: f64 = 4.0;
/// Share of the cells beyond the ends of the colour scale.
const BEYOND: f64 = 0.01;

/// The self-contained page of the ring of a case with this title.
pub fn measured_page(title: &str, measured: &Measured) -> String {
    let record = &measured.record;
    let source = Provenance {
        case: title.to_owned(),
        method: Some("points of a measuring machine".to_owned()),
        ..Provenance::default()
    };
    let title = match title {
        "" => "Measured ring".to_owned(),
        title => format!("Measured ring: {title}"),
    };
    let mut page = Page::new(&title, "", &software());
    let head = Head::new(record.flag("passes"), record.text("headline"));
    page.head(&head.facts(lines(record.rows())));
    page.notes(Note::Warning, record.sentences("warnings"));
    page.section("Dimensions");
    let raceways = record.parts("raceways");
    for (raceway, nth) in raceways.iter().zip(1..) {
        dimensions(&mut page, raceway, (raceways.len() > 1).then_some(nth));
    }
    page.section("Deviations");
    if let Some(figure) = deviation_map(&measured.deviations, &source) {
        page.figure(&figure);
    }
    page.section("Frame");
    let caption = "Where the ring lies in the frame of the points, and radii of its groove against the drawing. \
                   Expanded uncertainties U with k = 2.";
    page.table(&Table::of(
        "Frame",
        caption,
        measured_rows(record.parts("frame")),
        None,
    ));
    page.html()
}

fn dimensions(page: &mut Page, raceway: &Record, nth: Option<usize>) {
    if raceway.parts("dimensions").is_empty() {
        return;
    }
    let label = nth.map_or("Raceway".to_owned(), |nth| format!("Raceway {nth}"));
    let caption = "Drawn and measured. A verdict needs the limit outside of the expanded uncertainty U, k = 2 \
                   (ISO 14253-1).";
    let rows = measured_rows(raceway.parts("dimensions"));
    page.table(&Table::of(&label, caption, rows, None));
    page.parameters(
        "Fit",
        "Points of the raceway and what is fitted to them.",
        &lines(raceway.rows()),
        None,
    );
}

/// Least and largest of the values of points.
fn ends(points: &[PointOff], of: &dyn Fn(&PointOff) -> f64) -> [f64; 2] {
    let values = points.iter().map(of);
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], v| {
        [a.min(v), b.max(v)]
    })
}

/// Cells of equal width along an axis.
struct Cells {
    from: f64,
    to: f64,
    count: usize,
}

impl Cells {
    /// The cell of a value.
    fn of(&self, value: f64) -> usize {
        let Self { from, to, count } = *self;
        (((value - from) / (to - from) * count as f64) as usize).min(count - 1)
    }

    fn middles(&self) -> Vec<f64> {
        let width = (self.to - self.from) / self.count as f64;
        (0..self.count)
            .map(|k| self.from + (k as f64 + 0.5) * width)
            .collect()
    }
}

/// Means of the deviations over angle and axial position; `None` without points.
pub fn deviation_map(points: &[PointOff], source: &Provenance) -> Option<Figure> {
    let along = |p: &PointOff| p.angle_rad.to_degrees();
    let across = |p: &PointOff| mm(p.axial_m);
    let (angles, heights) = (ends(points, &along), ends(points, &across));
    if points.is_empty() || !(angles[1] > angles[0] && heights[1] > heights[0]) {
        return None;
    }
    // As fine as points fill.
    let [most, high] = CELLS;
    let share = (points.len() as f64 / (POINTS_PER_CELL * most * high))
        .sqrt()
        .min(1.0);
    let cells = |ends: [f64; 2], most: f64| Cells {
        from: ends[0],
        to: ends[1],
        count: (most * share).ceil().max(2.0) as usize,
    };
    let (angles, heights) = (cells(angles, most), cells(heights, high));
    let mut sums = vec![vec![(0.0, 0.0); angles.count]; heights.count];
    for point in points {
        let (row, column) = (heights.of(across(point)), angles.of(along(point)));
        let (sum, count) = &mut sums[row][column];
        *sum += um(point.deviation_m);
        *count += 1.0;
    }
    let mean = |(sum, count): &(f64, f64)| (*count > 0.0).then(|| sum / count);
    let mut sizes: Vec<f64> = sums
        .iter()
        .flatten()
        .filter_map(mean)
        .map(f64::abs)
        .collect();
    sizes.sort_unstable_by(f64::total_cmp);
    let largest = sizes[((1.0 - BEYOND) * (sizes.len() - 1) as f64) as usize];
    let row = |row: &Vec<(f64, f64)>| -> Value {
        let cells = row
            .iter()
            .map(|c| mean(c).map_or(Value::Null, |v| number((v * 1e3).round() / 1e3)));
        cells.collect()
    };
    let z: Value = sums.iter().map(row).collect();
    let plot = Plot::new(420)
        .margin(Margin::above(24))
        .x("Angle ψ (°)", json!({}))
        .y("Axial position z (mm)", json!({}))
        .trace(json!({
            "type": "heatmap", "x": numbers(&angles.middles()),
            "y": numbers(&heights.middles()), "z": z, "name": "deviation",
            "zmin": number(-largest), "zmax": number(largest), "colorscale": "RdBu",
            "colorbar": { "title": { "text": "Deviation (µm)", "side": "right" }, "thickness": 14 },
            "hovertemplate": "ψ %{x:.1f}°<br>z %{y:.2f} mm<br>%{z:.2f} µm<extra></extra>",
        }));
    let caption = "Deviation of the points from the surface of the drawing, mean of each cell, in the frame of the \
                   ring and turned as drawn: above 0 material is left.";
    Some(Figure::new("Deviation map", caption, source, plot))
}
