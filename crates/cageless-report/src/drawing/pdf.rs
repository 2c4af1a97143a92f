//! A drawing as PDF.

use std::f64::consts::FRAC_PI_2;

use pdf_writer::{Content, Finish, Name, Pdf, Rect, Ref, Str, TextStr};

use super::paper::{Anchor, Arc, Mark, Paper, Pen, on_circle, width_mm};

/// Points of a millimetre.
const POINTS: f32 = 72.0 / 25.4;
/// Name of the typeface in the file.
const FACE: Name = Name(b"F");

impl Paper {
    /// The drawing as PDF, one page in its true size.
    ///
    /// The typeface is Helvetica, which every viewer has, with the letters of Western European languages;
    /// Greek ones are spelt out, others become question marks.
    pub fn pdf(&self) -> Vec<u8> {
        let [catalogue, pages, page, face, content, info] = [1, 2, 3, 4, 5, 6].map(Ref::new);
        let mut pdf = Pdf::new();
        pdf.catalog(catalogue).pages(pages);
        pdf.pages(pages).kids([page]).count(1);
        let [width, height] = self.size_mm.map(|mm| mm as f32 * POINTS);
        let mut sheet = pdf.page(page);
        sheet
            .media_box(Rect::new(0.0, 0.0, width, height))
            .parent(pages)
            .contents(content);
        sheet.resources().fonts().pair(FACE, face);
        sheet.finish();
        pdf.type1_font(face)
            .base_font(Name(b"Helvetica"))
            .encoding_predefined(Name(b"WinAnsiEncoding"));
        pdf.stream(content, &self.content());
        pdf.document_info(info).title(TextStr(&self.title));
        pdf.finish()
    }

    fn content(&self) -> Vec<u8> {
        let mut content = Content::new();
        // Millimetres from the upper left corner, y down.
        let height = self.size_mm[1] as f32 * POINTS;
        content.transform([POINTS, 0.0, 0.0, -POINTS, 0.0, height]);
        content.set_line_join(pdf_writer::types::LineJoinStyle::RoundJoin);
        for mark in &self.marks {
            match mark {
                Mark::Line { points, pen } => {
                    set(&mut content, *pen);
                    through(&mut content, points);
                    content.stroke();
                }
                Mark::Arc { arc, pen } => {
                    set(&mut content, *pen);
                    curves(&mut content, arc);
                    content.stroke();
                }
                Mark::Filled(points) => {
                    through(&mut content, points);
                    content.close_path().fill_nonzero();
                }
                Mark::Text(text) => {
                    let width = width_mm(&text.text, text.size_mm);
                    let left = text.at[0]
                        - match text.anchor {
                            Anchor::Start => 0.0,
                            Anchor::Middle => 0.5 * width,
                            Anchor::End => width,
                        };
                    let matrix = [1.0, 0.0, 0.0, -1.0, left as f32, text.at[1] as f32];
                    content
                        .begin_text()
                        .set_font(FACE, text.size_mm as f32)
                        .set_text_matrix(matrix)
                        .show(Str(&encoded(&text.text)))
                        .end_text();
                }
            }
        }
        content.finish().to_vec()
    }
}

fn set(content: &mut Content, pen: Pen) {
    content.set_line_width(pen.width_mm() as f32);
    let dashes = pen.dashes_mm().iter().map(|mm| *mm as f32);
    content.set_dash_pattern(dashes, 0.0);
}

fn through(content: &mut Content, points: &[[f64; 2]]) {
    let mut points = points.iter().map(|point| point.map(|mm| mm as f32));
    if let Some([x, y]) = points.next() {
        content.move_to(x, y);
    }
    for [x, y] in points {
        content.line_to(x, y);
    }
}

/// An arc by cubic curves of at most a right angle each.
fn curves(content: &mut Content, arc: &Arc) {
    let Arc {
        centre,
        radius_mm,
        from_rad: from,
        to_rad: to,
    } = *arc;
    let count = ((to - from).abs() / FRAC_PI_2).ceil().max(1.0);
    let step = (to - from) / count;
    // Bézier: handles of 4/3·tan(step/4) radii meet circle and slope at both ends and in the middle.
    let handle = 4.0 / 3.0 * (step / 4.0).tan();
    let on = |angle: f64| on_circle(centre, radius_mm, angle);
    let beside = |angle: f64, length: f64| {
        let ([x, y], (sin, cos)) = (on(angle), angle.sin_cos());
        [x - length * radius_mm * sin, y + length * radius_mm * cos].map(|mm| mm as f32)
    };
    let [x, y] = on(from).map(|mm| mm as f32);
    content.move_to(x, y);
    for k in 0..count as u32 {
        let begin = from + step * f64::from(k);
        let end = begin + step;
        let ([x1, y1], [x2, y2]) = (beside(begin, handle), beside(end, -handle));
        let [x3, y3] = on(end).map(|mm| mm as f32);
        content.cubic_to(x1, y1, x2, y2, x3, y3);
    }
}

/// Bytes of a text in the encoding WinAnsi, Greek letters by their names.
fn encoded(text: &str) -> Vec<u8> {
    const GREEK: [(char, &str); 6] = [
        ('α', "alpha"),
        ('β', "beta"),
        ('θ', "theta"),
        ('ψ', "psi"),
        ('ω', "omega"),
        ('Δ', "Delta"),
    ];
    let mut bytes = vec![];
    for letter in text.chars() {
        match GREEK.into_iter().find(|(greek, _)| *greek == letter) {
            Some((_, name)) => bytes.extend(name.bytes()),
            None => bytes.push(match letter {
                '–' => 0x96,
                '’' => 0x92,
                '−' => b'-',
                'μ' => 0xb5,
                letter => u8::try_from(letter).unwrap_or(b'?'),
            }),
        }
    }
    bytes
}
