//! Panels of a figure, their axes and titles.

use serde_json::{Value, json};

use crate::data::RacewaySector;
use crate::plot::{Plot, SECTOR};

/// Places of `count` panels side by side or one above the other, over 0 to 1, with
/// `space` between them.
pub fn panels(count: usize, space: f64) -> Vec<[f64; 2]> {
    let width = (1.0 - space * (count.max(1) - 1) as f64) / count.max(1) as f64;
    (0..count)
        .map(|k| k as f64 * (width + space))
        .map(|low| [low, low + width])
        .collect()
}

/// `xaxis` for `x` 0, `xaxis2` for 1, …
pub fn axis_name(letter: &str, index: usize) -> String {
    if index == 0 {
        format!("{letter}axis")
    } else {
        format!("{letter}axis{}", index + 1)
    }
}

/// `x` for 0, `x2` for 1, …
pub fn axis_ref(letter: &str, index: usize) -> String {
    if index == 0 {
        letter.to_owned()
    } else {
        format!("{letter}{}", index + 1)
    }
}

/// Puts a trace on a pair of axes.
pub fn on(trace: Value, x: &str, y: &str) -> Value {
    crate::plot::with(trace, json!({ "xaxis": x, "yaxis": y }))
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

/// `label` with the profile behind a comma, if there is one.
pub fn labelled(label: &str, provenance: &crate::data::Provenance) -> String {
    match &provenance.profile {
        Some(profile) => format!("{label}, profile {profile}"),
        None => label.to_owned(),
    }
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
