//! One self-contained HTML page: nothing is loaded from anywhere.

use std::collections::HashSet;

use crate::claim::{self, Claim};
use crate::data::{Parameter, Provenance};
use crate::drawing::Paper;
use crate::figure::Figure;
use crate::head::{Head, verdict_html};
use crate::motion::MotionFigure;
use crate::studio::{self, Opening};
use crate::table::Table;
use crate::tables::parameter_table;
use crate::text::{escape, rich, slug};

/// A page under construction.
#[derive(Debug, Clone, Default)]
pub struct Page {
    title: String,
    lead: String,
    head: String,
    software: String,
    opening: String,
    /// Labels of the figures in the opening, which stand nowhere else.
    opened: HashSet<String>,
    body: String,
    /// Provenance under the last figure or table.
    source: String,
    contents: Vec<(String, String)>,
    ids: HashSet<String>,
    /// Title of a section that has begun, until something is added to it.
    begun: Option<String>,
    section_open: bool,
    plots: bool,
    motion: bool,
    studio: bool,
    sheet: bool,
}

/// Style of a page on sheets of A4.
const SHEET: &str = include_str!("sheet.css");

/// Weight of a note.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Note {
    /// Remark.
    Remark,
    /// Warning.
    Warning,
}

impl Page {
    /// An empty page.
    pub fn new(title: &str, lead: &str, software: &str) -> Self {
        Self {
            title: title.to_owned(),
            lead: lead.to_owned(),
            software: software.to_owned(),
            ..Self::default()
        }
    }

    /// The page as sheets of A4, to be printed.
    pub fn sheet(mut self) -> Self {
        self.sheet = true;
        self
    }

    fn add(&mut self, html: &str) {
        if let Some(title) = self.begun.take() {
            let id = self.unique(&format!("section-{}", slug(&title)));
            let end = if self.section_open {
                "</section>\n"
            } else {
                ""
            };
            let heading = rich(&title);
            self.body += &format!("{end}<section id=\"{id}\"><h2>{heading}</h2>\n");
            self.section_open = true;
            self.contents.push((id, title));
        }
        self.body.push_str(html);
    }

    /// Starts a section, which appears in the page and its table of contents once something is added to it.
    pub fn section(&mut self, title: &str) {
        self.begun = Some(title.to_owned());
    }

    /// Adds a paragraph.
    pub fn paragraph(&mut self, text: &str) {
        self.add(&format!("<p>{}</p>\n", rich(text)));
    }

    /// Adds a note in a box.
    pub fn note(&mut self, weight: Note, text: &str) {
        let class = match weight {
            Note::Remark => "note",
            Note::Warning => "note warning",
        };
        self.add(&format!("<p class=\"{class}\">{}</p>\n", rich(text)));
    }

    /// Adds a note for each text.
    pub fn notes<T: AsRef<str>>(&mut self, weight: Note, texts: &[T]) {
        for text in texts {
            self.note(weight, text.as_ref());
        }
    }

    /// Adds a verdict in a box: green if it passes, red if it fails, grey if nothing was judged.
    pub fn verdict(&mut self, passes: Option<bool>, headline: &str) {
        self.add(&verdict_html(passes, headline));
    }

    /// Opens the page with figures: on the first screen, above the contents, and in no section below.
    pub fn open_with(&mut self, figures: impl IntoIterator<Item = Figure>) {
        for figure in figures {
            let html = self.figure_html(&figure);
            self.opening += &html;
            self.opened.insert(figure.label);
        }
    }

    /// Opens the page with balls in motion.
    pub fn open_with_motion(&mut self, motion: Option<MotionFigure>) {
        if let Some(motion) = motion {
            let html = self.motion_html(&motion);
            self.opening += &html;
            self.opened.insert(motion.label);
        }
    }

    /// Whether this provenance differs from that of the figure or table before.
    fn is_new(&mut self, source: &Provenance) -> bool {
        let line = source.line();
        line != std::mem::replace(&mut self.source, line.clone())
    }

    /// Sets the box on top of the page.
    pub fn head(&mut self, head: &Head) {
        self.head = head.html();
    }

    /// Adds a heading within a section.
    pub fn heading(&mut self, title: &str) {
        self.add(&format!("<h3>{}</h3>\n", rich(title)));
    }

    /// Adds a text to be pasted into a file, with a button that copies it.
    pub fn paste(&mut self, name: &str, text: &str) {
        self.add(&format!(
            "<div class=\"paste\"><pre tabindex=\"0\" aria-label=\"{name}\">{}</pre>\
             <button type=\"button\" data-copy aria-label=\"Copy {name}\">Copy</button></div>\n",
            escape(text),
            name = escape(name),
        ));
    }

    /// Adds what `add` adds, if anything, folded away until it is asked for.
    pub fn fold(&mut self, summary: &str, add: impl FnOnce(&mut Self)) {
        let (before, begun) = (std::mem::take(&mut self.body), self.begun.take());
        let source = self.source.clone();
        add(self);
        let folded = std::mem::replace(&mut self.body, before);
        (self.begun, self.source) = (begun, source);
        if !folded.is_empty() {
            let summary = rich(summary);
            self.add(&format!(
                "<details><summary>{summary}</summary>\n{folded}</details>\n"
            ));
        }
    }

    /// Adds a figure that the page does not open with.
    pub fn figure(&mut self, figure: &Figure) {
        if !self.opened.contains(&figure.label) {
            let html = self.figure_html(figure);
            self.add(&html);
        }
    }

    fn figure_html(&mut self, figure: &Figure) -> String {
        let id = self.unique(&figure.slug());
        self.plots = true;
        let sourced = self.is_new(&figure.provenance);
        figure.html(&id, sourced)
    }

    /// Adds figures.
    pub fn figures(&mut self, figures: impl IntoIterator<Item = Figure>) {
        figures.into_iter().for_each(|figure| self.figure(&figure));
    }

    /// Adds a table of parameters or results if there are any.
    pub fn parameters(
        &mut self,
        label: &str,
        caption: &str,
        parameters: &[Parameter],
        source: Option<&Provenance>,
    ) {
        if !parameters.is_empty() {
            self.table(&parameter_table(
                label,
                caption,
                parameters,
                source.cloned(),
            ));
        }
    }

    /// Adds a table.
    pub fn table(&mut self, table: &Table) {
        let id = self.unique(&table.slug());
        let source = table.provenance.as_ref();
        let sourced = source.is_some_and(|source| self.is_new(source));
        self.add(&table.html(&id, sourced));
    }

    /// Adds a drawing.
    pub fn drawing(&mut self, paper: &Paper) {
        let svg = paper.svg();
        self.add(&format!(
            "<figure class=\"scroll\" tabindex=\"0\" aria-label=\"Drawing\">{svg}</figure>\n"
        ));
    }

    fn motion_html(&mut self, motion: &MotionFigure) -> String {
        let id = self.unique(&motion.slug());
        self.motion = true;
        let mut sources = motion.sources();
        sources.retain(|source| self.is_new(source));
        motion.html(&id, &sources)
    }

    /// Adds a studio of the case in `toml`, which computes in the page what its reader changes.
    pub fn studio(&mut self, toml: &str, opening: Opening) {
        self.studio = true;
        self.add(&studio::place(toml, opening));
    }

    /// Adds claims, if there are any: how many have each status, and a line for each.
    pub fn claims(&mut self, claims: &[Claim]) {
        if claims.is_empty() {
            return;
        }
        self.paragraph(&claim::counts(claims));
        self.fold("How a status follows", |page| page.paragraph(claim::RULE));
        claims.iter().for_each(|c| self.add(&c.html()));
    }

    /// The page.
    pub fn html(mut self) -> String {
        if self.section_open {
            self.body.push_str("</section>\n");
        }
        let link = |(id, title): &(String, String)| {
            format!("<li><a href=\"#{id}\">{}</a></li>", rich(title))
        };
        let nav = match self.contents.iter().map(link).collect::<String>().as_str() {
            "" => String::new(),
            links => format!("<nav aria-label=\"Contents\"><ol>{links}</ol></nav>\n"),
        };
        let mut scripts = String::new();
        if self.plots {
            scripts.push_str(&format!("<script>{}</script>\n", PLOTLY_JS));
        }
        scripts.push_str(&format!("<script>{}</script>\n", include_str!("page.js")));
        if self.motion || self.studio {
            scripts.push_str(&format!("<script>{}</script>\n", include_str!("gif.js")));
        }
        if self.motion {
            scripts.push_str(&format!("<script>{}</script>\n", include_str!("motion.js")));
        }
        if self.studio {
            scripts.push_str(&studio::scripts());
        }
        let lead = if self.lead.is_empty() {
            String::new()
        } else {
            format!("<p class=\"lead\">{}</p>\n", rich(&self.lead))
        };
        let opening = match self.opening.as_str() {
            "" => String::new(),
            pictures => format!(
                "<section class=\"opening\" aria-label=\"Overview\">\n{pictures}</section>\n"
            ),
        };
        format!(
            "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
             <title>{title}</title>\n<link rel=\"icon\" href=\"data:,\">\n<style>{css}</style></head>\n\
             <body><header><h1>{title}</h1>\n{lead}{head}</header>\n\
             {opening}{nav}\
             <noscript><p class=\"note warning\">The figures are drawn by JavaScript, which is \
             switched off here; tables and captions can be read without it.</p></noscript>\n\
             <main>\n{body}</main>\n<footer>{software}</footer>\n{scripts}</body></html>\n",
            title = escape(&self.title),
            css = [
                include_str!("page.css"),
                if self.studio { studio::STYLE } else { "" },
                if self.sheet { SHEET } else { "" },
            ]
            .concat(),
            head = self.head,
            body = self.body,
            software = rich(&self.software),
        )
    }

    fn unique(&mut self, wanted: &str) -> String {
        let mut id = wanted.to_owned();
        let mut k = 2;
        while !self.ids.insert(id.clone()) {
            id = format!("{wanted}-{k}");
            k += 1;
        }
        id
    }
}

/// plotly.js.
const PLOTLY_JS: &str = include_str!(env!("CAGELESS_PLOTLY_JS"));
