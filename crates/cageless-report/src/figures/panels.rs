//! Panels of a figure, their axes and titles.

use serde_json::{Value, json};

use crate::data::RacewaySector;
use crate::plot::{Axes, Plot, SECTOR, with};

/// Space between the panels of a figure, parts of its width and height.
#[derive(Debug, Clone, Copy)]
pub struct Space {
    /// From one column to the next.
    pub across: f64,
    /// From one row to the next.
    pub down: f64,
}

/// A pair of axes of a figure that has several.
pub struct Panel {
    /// `x` of the first, `x2` of the second, …
    x: String,
    y: String,
    /// Stretches of the figure that it takes up along x and y; all of it if there are none.
    places: Option<[[f64; 2]; 2]>,
    /// Whether it is the first of its figure.
    pub first: bool,
    /// Whether it stands at the left edge.
    pub leftmost: bool,
    /// Whether no other stands below it.
    pub lowest: bool,
}

impl Panel {
    /// Panel `index`, from 0.
    pub fn new(index: usize) -> Self {
        let number = if index == 0 {
            String::new()
        } else {
            (index + 1).to_string()
        };
        Self {
            x: format!("x{number}"),
            y: format!("y{number}"),
            places: None,
            first: index == 0,
            leftmost: true,
            lowest: true,
        }
    }

    /// `count` panels in rows of `columns`, with `space` between them.
    pub fn grid(count: usize, columns: usize, space: Space) -> Vec<Self> {
        let columns = columns.max(1);
        let rows = count.div_ceil(columns).max(1);
        let (across, up) = (
            stretches(columns, space.across),
            stretches(rows, space.down),
        );
        let panel = |k: usize| Self {
            places: Some([across[k % columns], up[rows - 1 - k / columns]]),
            leftmost: k.is_multiple_of(columns),
            lowest: k + columns >= count,
            ..Self::new(k)
        };
        (0..count).map(panel).collect()
    }

    /// The title of a column of panels if it is the lowest of them, else none.
    pub fn at_bottom<'t>(&self, title: &'t str) -> &'t str {
        if self.lowest { title } else { "" }
    }

    /// The title of a row of panels if it is the leftmost of them, else none.
    pub fn at_left<'t>(&self, title: &'t str) -> &'t str {
        if self.leftmost { title } else { "" }
    }

    /// Names of its axes, for traces and marks.
    pub fn axes(&self) -> Axes<'_> {
        Axes {
            x: &self.x,
            y: &self.y,
        }
    }
}

/// `count` stretches one after the other, over 0 to 1, with `space` between them.
fn stretches(count: usize, space: f64) -> Vec<[f64; 2]> {
    let width = (1.0 - space * (count - 1) as f64) / count as f64;
    let lows = (0..count).map(|k| k as f64 * (width + space));
    lows.map(|low| [low, low + width]).collect()
}

impl Plot {
    /// Sets the axes of a panel, with further keys.
    pub fn panel(self, panel: &Panel, titles: [&str; 2], more: [Value; 2]) -> Self {
        let Axes { x, y } = panel.axes();
        let axis = |k: usize, more: Value| {
            let axis = json!({ "anchor": ([y, x][k]) });
            let domain = panel.places.map(|places| json!({ "domain": places[k] }));
            with(with(axis, domain.unwrap_or(json!({}))), more)
        };
        let [x_more, y_more] = more;
        self.axis(&x.replace('x', "xaxis"), titles[0], axis(0, x_more))
            .axis(&y.replace('y', "yaxis"), titles[1], axis(1, y_more))
    }

    /// Writes a title above a panel.
    pub fn title_above(self, panel: &Panel, text: &str, font: Value) -> Self {
        let Axes { x, y } = panel.axes();
        let [x, y] = [x, y].map(|axis| format!("{axis} domain"));
        let more = json!({ "yanchor": "bottom", "font": font });
        self.text(text, (0.5, 1.02), (&x, &y), more)
    }
}

/// Shades discrete raceways on an axis of ψ in (−180°, 180°].
pub fn shade_sectors(mut plot: Plot, sectors: &[RacewaySector], x: &str, y: &str) -> Plot {
    for sector in sectors {
        let centre = sector.centre_angle_deg - 360.0 * (sector.centre_angle_deg / 360.0).round();
        let (from, to) = (
            centre - sector.half_angle_deg,
            centre + sector.half_angle_deg,
        );
        plot = plot.band(x, y, from.max(-180.0), to.min(180.0), SECTOR);
        if from < -180.0 {
            plot = plot.band(x, y, from + 360.0, 180.0, SECTOR);
        }
        if to > 180.0 {
            plot = plot.band(x, y, -180.0, to - 360.0, SECTOR);
        }
    }
    plot
}

/// Letter, lC and θ, and below it the verdict, for a small panel.
pub fn panel_title(structure: &crate::data::RacewayLabel, verdict: &str) -> String {
    let plain = crate::plot::plain;
    let letter = if structure.letter.is_empty() {
        String::new()
    } else {
        format!("<b>({})</b> ", plain(&structure.letter))
    };
    format!(
        "{letter}{} mm, {}°<br><i>{}</i>",
        structure.axial_span_mm,
        structure.half_angle_deg,
        plain(verdict)
    )
}
