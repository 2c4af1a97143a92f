//! A drawing as SVG.

use super::paper::{Anchor, Arc, Mark, Paper, Place, on_circle};
use crate::text::escape;

impl Paper {
    /// The drawing as SVG, in the colour of the text around it; black on its own.
    pub fn svg(&self) -> String {
        let [width, height] = self.size_mm;
        let marks: String = self.marks.iter().map(mark).collect();
        let title = escape(&self.title);
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"drawing\" role=\"img\" width=\"{width}mm\" \
             height=\"{height}mm\" viewBox=\"0 0 {width} {height}\" color=\"#000\" fill=\"none\" \
             stroke=\"currentColor\" stroke-linejoin=\"round\" font-family=\"Helvetica, Arial, 'Liberation Sans', \
             sans-serif\">\n<title>{title}</title>\n{marks}</svg>\n"
        )
    }
}

fn mark(mark: &Mark) -> String {
    let (path, pen) = match mark {
        Mark::Line { points, pen } => (through(points), pen),
        Mark::Arc { arc, pen } => {
            let Arc {
                centre,
                radius_mm,
                from_rad: from,
                to_rad: to,
            } = *arc;
            let at = |angle| on_circle(centre, radius_mm, angle);
            let sweep = u8::from(to > from);
            // In two halves: an arc of SVG must not end where it begins.
            let half = 0.5 * (from + to);
            let arc = |end: f64| format!("A{0} {0} 0 0 {sweep} {1}", radius_mm, place(at(end)));
            let path = format!("M{}{}{}", place(at(from)), arc(half), arc(to));
            (path, pen)
        }
        Mark::Filled(points) => {
            let path = through(points);
            return format!("<path d=\"{path}Z\" fill=\"currentColor\" stroke=\"none\"/>\n");
        }
        Mark::Text(text) => {
            let anchor = match text.anchor {
                Anchor::Start => "",
                Anchor::Middle => " text-anchor=\"middle\"",
                Anchor::End => " text-anchor=\"end\"",
            };
            return format!(
                "<text x=\"{:.3}\" y=\"{:.3}\" font-size=\"{}\" fill=\"currentColor\" stroke=\"none\"{anchor}>{}</text>\n",
                text.at[0],
                text.at[1],
                text.size_mm,
                escape(&text.text)
            );
        }
    };
    let dashes = match pen.dashes_mm() {
        [] => String::new(),
        dashes => {
            let lengths: Vec<String> = dashes.iter().map(f64::to_string).collect();
            format!(" stroke-dasharray=\"{}\"", lengths.join(" "))
        }
    };
    format!(
        "<path d=\"{path}\" stroke-width=\"{}\"{dashes}/>\n",
        pen.width_mm()
    )
}

fn through(points: &[Place]) -> String {
    let places: Vec<String> = points.iter().map(|point| place(*point)).collect();
    format!("M{}", places.join("L"))
}

fn place([x, y]: Place) -> String {
    format!("{x:.3} {y:.3}")
}
