//! A figure: plot, number, caption, provenance, and buttons that save it.

use crate::data::Provenance;
use crate::plot::Plot;
use crate::text::{escape, rich, script_json, slug};

/// A numbered figure.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    /// `Figure 6, paper profile`; its slug is the anchor and the name of saved files.
    pub label: String,
    /// Caption: what the figure shows.
    pub caption: String,
    /// Provenance of its numbers.
    pub provenance: Provenance,
    /// The plot.
    pub plot: Plot,
}

impl Figure {
    /// HTML with the anchor `id`.
    pub fn html(&self, id: &str) -> String {
        format!(
            "<figure id=\"{id}\" class=\"fig\">\n\
             <div class=\"scroll\"><div class=\"plot\" id=\"{id}-plot\" role=\"img\" \
             aria-label=\"{label}\" style=\"height:{height}px;min-width:{width}px\"></div></div>\n\
             <script type=\"application/json\" id=\"{id}-spec\">{spec}</script>\n\
             {below}</figure>\n",
            label = escape(&self.label),
            height = self.plot.height_px,
            width = self.plot.min_width_px,
            spec = script_json(&self.plot.spec()),
            below = below(id, &self.label, &self.caption, &[&self.provenance]),
        )
    }

    /// The plot on its own, in the JSON of plotly, as high as on a page.
    pub fn json(&self) -> String {
        let mut spec = self.plot.spec();
        spec["layout"]["height"] = self.plot.height_px.into();
        spec.to_string()
    }

    /// Anchor that the label asks for.
    pub fn slug(&self) -> String {
        slug(&self.label)
    }
}

/// Caption, provenance and buttons under whatever is drawn.
pub(crate) fn below(id: &str, label: &str, caption: &str, sources: &[&Provenance]) -> String {
    let mut out = format!(
        "<figcaption><div class=\"caption\"><b>{}.</b> {}",
        rich(label),
        rich(caption)
    );
    for source in sources {
        out.push_str(&format!(
            "<div class=\"provenance\">{}</div>",
            rich(&source.line())
        ));
    }
    out.push_str(&format!(
        "</div><div class=\"save\"><button type=\"button\" data-save=\"svg\" data-figure=\"{id}\">SVG</button>\
         <button type=\"button\" data-save=\"png\" data-figure=\"{id}\">PNG</button></div></figcaption>\n"
    ));
    out
}
