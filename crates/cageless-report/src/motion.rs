//! Bearings in motion, drawn to scale as SVG from sampled ball angles (Fig. 13 and 14).

use std::fmt::Write;

use serde_json::{Value, json};

use crate::data::{Motion, Provenance, RacewaySector, RotorTrack};
use crate::figure::below;
use crate::text::{escape, script_json, slug};

/// One or more bearings that move together.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MotionFigure {
    /// `Figure 13 and 14`.
    pub label: String,
    /// Caption: what the figure shows.
    pub caption: String,
    /// Bearings, side by side.
    pub bearings: Vec<Motion>,
    /// Moments that get a button, s.
    pub moments_s: Vec<f64>,
    /// Stretches of the recorded time to choose from: name, from, to in s.
    pub stretches: Vec<(String, [f64; 2])>,
}

/// Thickness of a ring in the drawing, mm.
const RING: f64 = 5.0;
/// Room around a bearing, mm.
const ROOM: f64 = 3.0;
/// Room for title above and readout below, mm.
const TEXT: [f64; 2] = [5.0, 9.0];
/// Angles are stored in steps of 1e-4°.
const STEPS_PER_DEG: f64 = 1e4;
/// Times are stored in steps of 1 µs.
const STEPS_PER_S: f64 = 1e6;
const INK: &str = "#333333";
const HIT: &str = "#d55e00";

impl MotionFigure {
    /// Bearings in motion, each row by itself, without moments and stretches to choose from.
    pub fn new(label: &str, caption: &str, bearings: Vec<Motion>) -> Self {
        Self {
            label: label.to_owned(),
            caption: caption.to_owned(),
            bearings: bearings.into_iter().flat_map(Motion::rows).collect(),
            ..Self::default()
        }
    }

    /// Anchor that the label asks for.
    pub fn slug(&self) -> String {
        slug(&self.label)
    }

    /// Provenances of the bearings, each once.
    pub fn sources(&self) -> Vec<&Provenance> {
        let mut sources: Vec<&Provenance> = self.bearings.iter().map(|b| &b.provenance).collect();
        sources.dedup();
        sources
    }

    /// HTML with the anchor `id` and these provenances.
    pub fn html(&self, id: &str, sources: &[&Provenance]) -> String {
        let single = if self.bearings.len() < 2 {
            " single"
        } else {
            ""
        };
        let button =
            |s: &f64| format!("<button type=\"button\" data-moment=\"{s}\">{s} s</button>");
        let moments: String = self.moments_s.iter().map(button).collect();
        format!(
            "<figure id=\"{id}\" class=\"fig motion{single}\">\n{svg}\n\
             <div class=\"controls\"><button type=\"button\" data-play>Play</button>\
             <label>Slowed down <select data-speed>\
             <option value=\"2000\">2000 ×</option><option value=\"500\">500 ×</option>\
             <option value=\"200\" selected>200 ×</option><option value=\"50\">50 ×</option>\
             <option value=\"10\">10 ×</option></select></label>\
             <input type=\"range\" min=\"0\" max=\"10000\" value=\"0\" data-time aria-label=\"Time\">\
             <output data-clock></output>{moments}</div>\n\
             <div class=\"controls\">{stretches}\
             <label>from <input type=\"number\" step=\"0.0001\" data-from> s</label>\
             <label>to <input type=\"number\" step=\"0.0001\" data-until> s</label>\
             <button type=\"button\" data-film data-figure=\"{id}\" \
             title=\"The stretch of time at the chosen speed\">Save as GIF</button></div>\n\
             <script type=\"application/json\" data-motion>{data}</script>\n{below}</figure>\n",
            stretches = self.stretches_html(),
            svg = self.svg(id),
            data = script_json(&self.data()),
            below = below(id, &self.label, &self.caption, sources),
        )
    }

    /// The choice of a stretch of time; empty without stretches.
    fn stretches_html(&self) -> String {
        if self.stretches.is_empty() {
            return String::new();
        }
        let option = |(name, [from, to]): &(String, [f64; 2])| {
            format!("<option value=\"{from},{to}\">{}</option>", escape(name))
        };
        let options: String = self.stretches.iter().map(option).collect();
        format!(
            "<label>Show <select data-part><option value=\"\">the whole animation</option>{options}\
             </select></label>"
        )
    }

    /// Samples in whole steps, each but the first as a difference to the one before.
    fn data(&self) -> Value {
        let bearings: Vec<Value> = (self.bearings.iter())
            .map(|motion| {
                let count = samples(motion);
                let coded =
                    |values: &[f64], scale| differences(&values[..count.min(values.len())], scale);
                let angles = |values: &Vec<f64>| coded(values, STEPS_PER_DEG);
                let rows = |rows: &[Vec<f64>]| -> Value { rows.iter().map(angles).collect() };
                let rotor = motion.rotor.as_ref().map(|rotor| {
                    json!({
                        "x": angles(&rotor.x_mm), "y": angles(&rotor.y_mm),
                        "a": angles(&rotor.angle_deg), "ring": angles(&rotor.ring_angle_deg),
                    })
                });
                json!({
                    "rotor": rotor,
                    "t": coded(&motion.time_s, STEPS_PER_S),
                    "a": rows(&motion.angle_deg),
                    "g": rows(&motion.gap_deg),
                    "before": motion.balls_before,
                    "eps": motion.outline.ball_angle_deg,
                    "pitch": motion.outline.pitch_radius_mm,
                })
            })
            .collect();
        json!({ "bearings": bearings, "degree": STEPS_PER_DEG, "second": STEPS_PER_S })
    }

    fn svg(&self, id: &str) -> String {
        let half = self
            .bearings
            .iter()
            .map(|b| outer_edge(b) + ROOM)
            .fold(1.0, f64::max);
        let width = 2.0 * half * self.bearings.len().max(1) as f64;
        let height = TEXT[0] + 2.0 * half + TEXT[1];
        let mut out = format!(
            "<svg id=\"{id}-svg\" xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width:.3} {height:.3}\" \
             font-family=\"Helvetica Neue, Helvetica, Arial, Liberation Sans, sans-serif\" role=\"img\" \
             aria-label=\"{}\">\n<rect class=\"sheet\" width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
            escape(&self.label)
        );
        for (k, motion) in self.bearings.iter().enumerate() {
            let _ = write!(
                out,
                "<g data-bearing=\"{k}\" transform=\"translate({:.3},{:.3})\">\n{}</g>\n",
                half * (2 * k + 1) as f64,
                TEXT[0] + half,
                bearing(motion, half)
            );
        }
        out.push_str("</svg>");
        out
    }
}

/// Samples of which every ball has an angle.
fn samples(motion: &Motion) -> usize {
    motion
        .angle_deg
        .iter()
        .chain(&motion.gap_deg)
        .map(Vec::len)
        .fold(motion.time_s.len(), usize::min)
}

fn differences(values: &[f64], scale: f64) -> Vec<i64> {
    let mut before = 0;
    values
        .iter()
        .map(|v| {
            // A value that is not a number is drawn where the last one was.
            let step = if v.is_finite() {
                (v * scale).round() as i64
            } else {
                before
            };
            let difference = step - before;
            before = step;
            difference
        })
        .collect()
}

fn outer_edge(motion: &Motion) -> f64 {
    motion.outline.outer_groove_bottom_radius_mm + RING
}

/// Rings, raceways, balls and text of one bearing around the origin.
fn bearing(motion: &Motion, half: f64) -> String {
    let o = &motion.outline;
    let mut out = format!(
        "<text class=\"label\" y=\"{:.3}\" font-size=\"2.7\" font-weight=\"700\" text-anchor=\"middle\" fill=\"{INK}\">{}</text>\n",
        -half - 1.0,
        title(&motion.title)
    );
    out.push_str(&annulus(
        o.outer_groove_bottom_radius_mm,
        outer_edge(motion),
    ));
    for sector in &motion.sectors {
        out.push_str(&sector_path(
            sector,
            o.outer_groove_bottom_radius_mm,
            outer_edge(motion),
        ));
    }
    let inner = o.inner_groove_bottom_radius_mm;
    match &motion.rotor {
        None => out.push_str(&annulus((inner - RING).max(0.3 * inner), inner)),
        Some(rotor) => out.push_str(&ring_and_rotor(rotor, inner)),
    }
    for (k, angles) in motion.angle_deg.iter().enumerate() {
        let angle_deg = angles.first().copied().filter(|a| a.is_finite());
        out.push_str(&ball(motion, k, angle_deg.unwrap_or_default().to_radians()));
    }
    for _ in &motion.angle_deg {
        let _ = writeln!(
            out,
            "<circle data-touch r=\"0.9\" fill=\"{HIT}\" visibility=\"hidden\"/>"
        );
    }
    for (line, size) in [(0, 2.6), (1, 2.3)] {
        let _ = writeln!(
            out,
            "<text class=\"label\" data-line=\"{line}\" y=\"{:.3}\" font-size=\"{size}\" text-anchor=\"middle\" fill=\"{INK}\"></text>",
            half + 2.2 + 3.6 * f64::from(line)
        );
    }
    out
}

/// Ball `k` at ψ.
fn ball(motion: &Motion, k: usize, angle: f64) -> String {
    let o = &motion.outline;
    let (x, y) = (
        o.pitch_radius_mm * angle.sin(),
        o.pitch_radius_mm * angle.cos(),
    );
    let (fill, text) = match k {
        0 => ("#0072b2", "#ffffff"),
        1 => ("#56b4e9", "#10242e"),
        _ => ("#f4f5f6", INK),
    };
    format!(
        "<g data-ball transform=\"translate({x:.4},{y:.4})\"><circle r=\"{:.4}\" fill=\"{fill}\" \
         stroke=\"#555555\" stroke-width=\"0.2\"/><text y=\"1.1\" font-size=\"3\" \
         text-anchor=\"middle\" fill=\"{text}\">{}</text></g>\n",
        o.ball_radius_mm - 0.1,
        motion.balls_before + k + 1
    )
}

/// Inner ring with its bore and the rotor in it, each with a mark that turns.
fn ring_and_rotor(rotor: &RotorTrack, groove: f64) -> String {
    let bore = rotor.bore_radius_mm;
    let journal = (bore - rotor.gap_mm).max(0.3 * bore);
    format!(
        "{}<g data-ring-mark><circle r=\"0\" fill=\"none\"/><line x1=\"0\" y1=\"{:.3}\" x2=\"0\" \
         y2=\"{:.3}\" stroke=\"#7d8894\" stroke-width=\"0.8\"/></g>\n\
         <g data-rotor><circle r=\"{journal:.3}\" fill=\"#f3e3d3\" stroke=\"#946200\" \
         stroke-width=\"0.2\"/><line x1=\"0\" y1=\"0\" x2=\"0\" y2=\"{:.3}\" stroke=\"#946200\" \
         stroke-width=\"0.6\"/></g>\n",
        annulus(bore, groove),
        -bore,
        -groove,
        -journal
    )
}

/// Text of the drawing, lC with its index.
fn title(text: &str) -> String {
    escape(text).replace(
        "lC ",
        "<tspan font-style=\"italic\">l</tspan><tspan font-size=\"1.9\" dy=\"0.5\">C</tspan>\
         <tspan dy=\"-0.5\"> </tspan>",
    )
}

fn annulus(inside: f64, outside: f64) -> String {
    let circle = |r: f64| {
        format!(
            "M{r:.3},0A{r:.3},{r:.3} 0 1 0 {0:.3},0A{r:.3},{r:.3} 0 1 0 {r:.3},0Z",
            -r
        )
    };
    format!(
        "<path d=\"{}{}\" class=\"ring\" fill=\"#dde3e8\" fill-rule=\"evenodd\" stroke=\"#7d8894\" stroke-width=\"0.15\"/>\n",
        circle(outside),
        circle(inside)
    )
}

fn sector_path(sector: &RacewaySector, inside: f64, outside: f64) -> String {
    let at = |r: f64, angle: f64| {
        let (sin, cos) = angle.to_radians().sin_cos();
        format!("{:.3},{:.3}", r * sin, r * cos)
    };
    let (from, to) = (
        sector.centre_angle_deg - sector.half_angle_deg,
        sector.centre_angle_deg + sector.half_angle_deg,
    );
    let large = u8::from(sector.half_angle_deg > 90.0);
    format!(
        "<path d=\"M{}A{outside:.3},{outside:.3} 0 {large} 0 {}L{}A{inside:.3},{inside:.3} 0 {large} 1 {}Z\" \
         fill=\"#e69f00\" fill-opacity=\"0.6\" stroke=\"#946200\" stroke-width=\"0.15\"/>\n",
        at(outside, from),
        at(outside, to),
        at(inside, to),
        at(inside, from)
    )
}
