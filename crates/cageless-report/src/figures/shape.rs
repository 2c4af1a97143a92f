//! Shape of the discrete raceway: contact track (Fig. 1b), surface (Fig. 2).

use serde_json::{Value, json};

use super::panels::Panel;
use crate::figure::Figure;
use crate::geometry::{ContactTrack, RacewaySurface};
use crate::plot::{
    Axes, GREY, Margin, PALETTE, Plot, SECTOR, Trace, line, line_in_space, number, numbers, plain,
};
use crate::sampling::range;
use crate::text::fixed;

/// Panels of Fig. 1b.
struct TrackPanels {
    /// Meridian section of the ball.
    section: Panel,
    /// r over ψ.
    along_r: Panel,
    /// z over ψ.
    along_z: Panel,
}

impl Default for TrackPanels {
    fn default() -> Self {
        let [section, along_r, along_z] = [0, 1, 2].map(Panel::new);
        Self {
            section,
            along_r,
            along_z,
        }
    }
}

impl TrackPanels {
    /// The section up to `edge`, beside it r above z.
    fn axes(&self, edge: f64) -> Plot {
        let range = json!([number(-edge), number(edge)]);
        let right = [0.52, 1.0];
        Plot::new(470)
        .margin(Margin { left: 64, right: 20, top: 40, ..Margin::default() })
        .panel(
            &self.section,
            ["Axial position z on the ball (mm)", "Radial position y on the ball (mm)"],
            [
                json!({ "domain": [0.0, 0.4], "scaleanchor": "y", "constrain": "domain", "range": range }),
                json!({ "constrain": "domain", "range": range }),
            ],
        )
        .panel(
            &self.along_r,
            ["", "Contact radius r (mm)"],
            [
                json!({ "domain": right, "matches": "x3", "showticklabels": false }),
                json!({ "domain": [0.55, 1.0] }),
            ],
        )
        .panel(
            &self.along_z,
            ["ψ from the middle of the raceway (°)", "Axial position z (mm)"],
            [json!({ "domain": right }), json!({ "domain": [0.0, 0.45] })],
        )
    }
}

/// Fig. 1b: the contact points on the ball, and r and z against ψ.
pub fn contact_track(track: &ContactTrack) -> Figure {
    let theta = track.structure.half_angle_deg;
    let rw = track.ball_radius_mm;
    let turn: Vec<f64> = (0..=180).map(|k| f64::from(2 * k).to_radians()).collect();
    let circle_x: Vec<f64> = turn.iter().map(|a| rw * a.sin()).collect();
    let circle_y: Vec<f64> = turn.iter().map(|a| rw * a.cos()).collect();
    let mirrored: Vec<f64> = track.axial_mm.iter().map(|z| -z).collect();
    let below: Vec<f64> = track.effective_radius_mm.iter().map(|r| -r).collect();
    let (least, _) = range(&track.effective_radius_mm);
    let half_span = track.structure.axial_span_mm / 2.0;
    let panels = TrackPanels::default();
    let mut plot = panels.axes(1.08 * rw);
    let [along_r, along_z] = [panels.along_r.axes(), panels.along_z.axes()];
    for Axes { x, y } in [along_r, along_z] {
        plot = plot.band(x, y, -theta, theta, SECTOR);
    }
    let (psi, r, z) = (
        &track.angle_deg,
        &track.effective_radius_mm,
        &track.axial_mm,
    );
    let span = line("lC", &[-half_span, half_span], &[-least, -least], "#333333");
    plot = plot
        .trace(line("ball", &circle_x, &circle_y, GREY))
        .trace(line("track, z > 0", z, &below, PALETTE[0]).width(4.0))
        .trace(line("track, z < 0", &mirrored, &below, PALETTE[1]).width(4.0))
        .trace(span.dash("dot"))
        .text(
            &plain(&format!("lC = {} mm", track.structure.axial_span_mm)),
            (0.0, -least),
            ("x", "y"),
            json!({ "yanchor": "bottom" }),
        )
        .trace(line("r", psi, r, PALETTE[2]).on(along_r))
        .trace(line("z > 0", psi, z, PALETTE[0]).on(along_z))
        .trace(line("z < 0", psi, &mirrored, PALETTE[1]).on(along_z));
    let caption = format!(
        "Contact track on the ball. Left: the meridian section of the ball with the two \
             branches of the track (blue z > 0, orange z < 0), outward being down as at the \
             bottom of the bearing. Right: effective contact radius r and axial position z along \
             the raceway (shaded, θ = {theta}°), Zhao 2022, Eq. (4) to (6)."
    );
    Figure::new("Figure 1b", &caption, &track.provenance, plot)
}

/// The surface of a groove to scale, coloured by its distance from the plain one, seen from `eye`.
pub(super) fn groove_plot(surface: &RacewaySurface, [x, y, z]: [f64; 3]) -> Plot {
    let grid = |rows: &[Vec<f64>]| -> Value { rows.iter().map(|row| numbers(row)).collect() };
    let [cut, left] = surface.depth_and_height_um();
    // Of a plain groove only rounding is left.
    let most = cut.max(left).max(0.1);
    let title = |text: &str| {
        json!({ "title": { "text": text }, "backgroundcolor": "#fff",
        "gridcolor": "#dddddd", "showbackground": false, "zeroline": false, "nticks": 5 })
    };
    let plot = Plot::new(560)
        .margin(Margin { left: 0, right: 0, top: 10, bottom: 0 })
        .set("scene", json!({
            "xaxis": title("x (mm)"), "yaxis": title("y (mm)"), "zaxis": title("z (mm)"),
            "aspectmode": "data",
            "camera": {
                "up": { "x": 0, "y": 1, "z": 0 },
                "eye": { "x": x, "y": y, "z": z },
                "center": { "x": 0, "y": -0.05, "z": 0 },
                "projection": { "type": "orthographic" },
            },
        }))
        .trace(json!({
            "type": "surface",
            "x": grid(&surface.x_mm), "y": grid(&surface.y_mm), "z": grid(&surface.z_mm),
            "surfacecolor": grid(&surface.deviation_um),
            "cmin": number(-most), "cmax": number(most),
            "colorscale": [[0, "#2166ac"], [0.5, "#f2f2f2"], [1, "#b2182b"]],
            "colorbar": {
                "title": { "text": "Deviation from<br>the plain groove (µm)", "side": "right" },
                "thickness": 16, "len": 0.75,
            },
            "lighting": { "ambient": 0.75, "diffuse": 0.5, "specular": 0.08, "roughness": 0.8 },
            "hovertemplate": "x %{x:.3f} mm<br>y %{y:.3f} mm<br>z %{z:.3f} mm<br>%{surfacecolor:.1f} µm<extra></extra>",
        }));
    let edges = surface.edges_mm.iter();
    edges.fold(plot, |plot, edge| {
        plot.trace(line_above("edge of the slot", edge.iter().copied(), 3))
    })
}

/// A line a little above the surface.
fn line_above(name: &str, points: impl Iterator<Item = [f64; 3]>, width: u32) -> Trace {
    line_in_space(
        name,
        &points.map(lift).collect::<Vec<_>>(),
        "#111111",
        width,
    )
}

/// Sentence about the drawn lines of a slot, with its dimensions; empty of other raceways.
pub(super) fn slot_sentence(surface: &RacewaySurface) -> String {
    let Some(size) = surface.slot_mm else {
        return String::new();
    };
    let [width, depth, radius] = size.map(|length| fixed(Some(length), 3));
    format!(
        "The thin lines are the edges of the slot, of radius {radius} mm: where they leave the groove and where \
         the walls begin, {width} mm apart in the middle; the floor is {depth} mm below the plain groove. "
    )
}

/// Fig. 2: the surface, in three dimensions.
pub fn surface(surface: &RacewaySurface) -> Figure {
    let [high, low] = surface.depth_and_height_um();
    let track = |sign: f64| {
        let points = surface
            .track_mm
            .iter()
            .map(move |[x, y, z]| [*x, *y, sign * z]);
        line_above("contact track", points, 5)
    };
    let plot = groove_plot(surface, [0.75, 1.15, 1.05])
        .trace(track(1.0))
        .trace(track(-1.0));
    let source = match surface.slot_mm {
        Some(_) => "Deviations",
        None => "Zhao 2022, Eq. (7); deviations",
    };
    let caption = format!(
        "Surface of the discrete raceway and a fifth of θ of the plain raceway at each end, \
             to scale, up to the shoulder; drag to turn it. Colour: distance from the plain \
             groove, positive where material is taken away. The lines are the contact tracks, \
             drawn 0.05 mm above the surface. {}{source} {} to {} µm.",
        slot_sentence(surface),
        fixed(Some(-low), 1),
        fixed(Some(high), 1)
    );
    Figure::new("Figure 2", &caption, &surface.provenance, plot)
}

/// A point of the track, a little closer to the axis, so that the surface does not
/// hide it.
fn lift(point: [f64; 3]) -> [f64; 3] {
    let rho = point[0].hypot(point[1]);
    let scale = if rho > 0.0 { 1.0 - 0.05 / rho } else { 1.0 };
    [point[0] * scale, point[1] * scale, point[2]]
}
