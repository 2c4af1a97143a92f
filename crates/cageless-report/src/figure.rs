//! A figure: plot, number, caption, provenance, and buttons that save it.

use cageless_results::Record;

use crate::data::Provenance;
use crate::plot::Plot;
use crate::text::{escape, rich, script_json, slug};

/// A numbered figure.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    /// `Figure 6, paper formulation`; its slug is the anchor and the name of saved files.
    pub label: String,
    /// Caption: what the figure shows.
    pub caption: String,
    /// Provenance of its numbers.
    pub provenance: Provenance,
    /// The plot.
    pub plot: Plot,
}

impl Figure {
    /// A figure of `plot`.
    pub fn new(label: &str, caption: &str, provenance: &Provenance, plot: Plot) -> Self {
        Self {
            label: label.to_owned(),
            caption: caption.to_owned(),
            provenance: provenance.clone(),
            plot,
        }
    }

    /// A figure of the paper, labelled with the formulation too.
    pub fn of_paper(label: &str, caption: &str, provenance: &Provenance, plot: Plot) -> Self {
        Self::new(label, caption, provenance, plot).with_formulation()
    }

    /// The formulation behind a comma of the label, if there is one.
    pub fn with_formulation(mut self) -> Self {
        if let Some(formulation) = &self.provenance.formulation {
            self.label = format!("{}, formulation {formulation}", self.label);
        }
        self
    }

    /// The figure under another label.
    pub fn labelled(mut self, label: &str) -> Self {
        label.clone_into(&mut self.label);
        self
    }

    /// A figure of the numbers of `record`.
    pub fn of_record(label: &str, caption: &str, record: &Record, plot: Plot) -> Self {
        let provenance = record.provenance.clone().unwrap_or_default();
        Self::new(label, caption, &provenance, plot)
    }

    /// HTML with the anchor `id`, and with its provenance if it is `sourced`.
    pub fn html(&self, id: &str, sourced: bool) -> String {
        let sources: &[&Provenance] = if sourced { &[&self.provenance] } else { &[] };
        format!(
            "<figure id=\"{id}\" class=\"fig\">\n{views}\
             <div class=\"plot\" id=\"{id}-plot\" role=\"img\" aria-label=\"{label}\" \
             data-height=\"{height}\" style=\"height:{height}px\"></div>\n\
             <script type=\"application/json\" id=\"{id}-spec\">{spec}</script>\n\
             {below}</figure>\n",
            views = self.views(id),
            label = escape(&self.spoken()),
            height = self.plot.height_px,
            spec = script_json(&self.plot.spec()),
            below = below(id, &self.label, &self.caption, sources),
        )
    }

    /// Label and what the plot shows, for readers who do not see it.
    fn spoken(&self) -> String {
        match self.plot.description().as_str() {
            "" => self.label.clone(),
            description => format!("{}. {description}", self.label),
        }
    }

    /// Buttons for stretches of the x-axis.
    fn views(&self, id: &str) -> String {
        if self.plot.views.is_empty() {
            return String::new();
        }
        let button = |(k, (name, [from, to])): (usize, &(String, [f64; 2]))| {
            format!(
                "<button type=\"button\" data-view=\"{from},{to}\" data-figure=\"{id}\" \
                 aria-pressed=\"{}\">{}</button>",
                k == 0,
                rich(name)
            )
        };
        let buttons: String = self.plot.views.iter().enumerate().map(button).collect();
        format!(
            "<div class=\"views\" role=\"group\" aria-label=\"Part of {} that is shown\">{buttons}</div>\n",
            escape(&self.label)
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
    format!(
        "{caption}<div class=\"save\"><button type=\"button\" data-save=\"svg\" data-figure=\"{id}\" \
         aria-label=\"Save {name} as SVG\">SVG</button>\
         <button type=\"button\" data-save=\"png\" data-figure=\"{id}\" \
         aria-label=\"Save {name} as PNG\">PNG</button></div></figcaption>\n",
        caption = captioned(label, caption, sources.iter().copied()),
        name = escape(label),
    )
}

/// The begin of a caption: label, text and provenance.
pub(crate) fn captioned<'p>(
    label: &str,
    caption: &str,
    sources: impl Iterator<Item = &'p Provenance>,
) -> String {
    let given = |source: &&Provenance| **source != Provenance::default();
    let sources = sources.filter(given).map(|source| {
        let line = rich(&source.line());
        format!("<div class=\"provenance\">{line}</div>")
    });
    format!(
        "<figcaption><div class=\"caption\"><b>{}.</b> {}{}</div>",
        rich(label),
        rich(caption),
        sources.collect::<String>()
    )
}
