//! Lines and texts on a sheet of paper.

use std::f64::consts::{FRAC_PI_2, TAU};

/// A place on the paper: x to the right, y down, mm from the upper left corner.
pub(super) type Place = [f64; 2];

/// Kinds of lines (ISO 128-2).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Pen {
    /// Visible edge.
    Wide,
    /// Dimension, leader, frame of a table.
    Narrow,
    /// Hidden edge.
    Dashed,
    /// Centre line, neighbouring part.
    Chain,
    /// Extent of a stated requirement.
    WideChain,
}

impl Pen {
    /// Width of the line, mm.
    pub(super) fn width_mm(self) -> f64 {
        match self {
            Self::Wide | Self::WideChain => 0.5,
            Self::Narrow | Self::Dashed | Self::Chain => 0.18,
        }
    }

    /// Lengths of dashes and gaps, mm; empty for a continuous line.
    pub(super) fn dashes_mm(self) -> &'static [f64] {
        match self {
            Self::Wide | Self::Narrow => &[],
            Self::Dashed => &[2.0, 1.0],
            Self::Chain | Self::WideChain => &[5.0, 1.0, 0.5, 1.0],
        }
    }
}

/// Point of a text at its place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Anchor {
    /// Start of the text.
    Start,
    /// Middle of the text.
    Middle,
    /// End of the text.
    End,
}

/// A text; its place is on the base line.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Text {
    pub text: String,
    pub at: Place,
    pub size_mm: f64,
    pub anchor: Anchor,
}

/// An arc about a centre; angles from +x towards +y.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Arc {
    pub centre: Place,
    pub radius_mm: f64,
    pub from_rad: f64,
    pub to_rad: f64,
}

/// Element of a drawing.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Mark {
    /// A line through points.
    Line { points: Vec<Place>, pen: Pen },
    /// An arc.
    Arc { arc: Arc, pen: Pen },
    /// A filled outline.
    Filled(Vec<Place>),
    /// A text.
    Text(Text),
}

/// A sheet of paper, mm.
#[derive(Debug, Clone, PartialEq)]
pub struct Paper {
    pub(super) size_mm: [f64; 2],
    pub(super) title: String,
    pub(super) marks: Vec<Mark>,
}

/// Length of an arrow, and half its width, mm.
const ARROW_MM: [f64; 2] = [2.5, 0.42];
/// Height of the capitals of texts over their size.
const CAPITALS: f64 = 0.72;
/// Frame of a sheet, mm from its edge.
pub(super) const FRAME_MM: f64 = 8.0;
/// Size of dimensions, mm.
pub(super) const TEXT_MM: f64 = 3.6;
/// Size of notes, mm.
pub(super) const NOTE_MM: f64 = 3.1;

impl Paper {
    /// An empty sheet.
    pub(super) fn new(title: &str, size_mm: [f64; 2]) -> Self {
        Self {
            size_mm,
            title: title.to_owned(),
            marks: vec![],
        }
    }

    pub(super) fn line(&mut self, points: impl IntoIterator<Item = Place>, pen: Pen) {
        let points = points.into_iter().collect();
        self.marks.push(Mark::Line { points, pen });
    }

    /// A rectangle by its upper left and its lower right corner.
    pub(super) fn rectangle(&mut self, upper_left: Place, lower_right: Place, pen: Pen) {
        let ([left, top], [right, bottom]) = (upper_left, lower_right);
        let corners = [[left, top], [right, top], [right, bottom], [left, bottom]];
        self.line(corners.into_iter().chain([[left, top]]), pen);
    }

    pub(super) fn arc(&mut self, centre: Place, radius_mm: f64, range_rad: [f64; 2], pen: Pen) {
        let [from_rad, to_rad] = range_rad;
        let arc = Arc {
            centre,
            radius_mm,
            from_rad,
            to_rad,
        };
        self.marks.push(Mark::Arc { arc, pen });
    }

    pub(super) fn circle(&mut self, centre: Place, radius_mm: f64, pen: Pen) {
        self.arc(centre, radius_mm, [0.0, TAU], pen);
    }

    /// An arrow whose tip is at a place and which points along a direction.
    pub(super) fn arrow(&mut self, tip: Place, [x, y]: [f64; 2]) {
        let length = x.hypot(y);
        let [x, y] = [x / length, y / length];
        let [long, half] = ARROW_MM;
        let foot = [tip[0] - long * x, tip[1] - long * y];
        self.marks.push(Mark::Filled(vec![
            tip,
            [foot[0] - half * y, foot[1] + half * x],
            [foot[0] + half * y, foot[1] - half * x],
        ]));
    }

    pub(super) fn text(&mut self, at: Place, anchor: Anchor, size_mm: f64, text: &str) {
        self.marks.push(Mark::Text(Text {
            text: text.to_owned(),
            at,
            size_mm,
            anchor,
        }));
    }

    /// A text whose middle is at a height.
    pub(super) fn centred(&mut self, at: Place, anchor: Anchor, size_mm: f64, text: &str) {
        let base = at[1] + 0.5 * CAPITALS * size_mm;
        self.text([at[0], base], anchor, size_mm, text);
    }

    /// A horizontal dimension between two places in either order, its line at the height `y_mm`.
    pub(super) fn horizontal(&mut self, places: [Place; 2], y_mm: f64, text: &str) {
        for [x, y] in places {
            let beyond = 1.0 * (y_mm - y).signum();
            self.line([[x, y + beyond], [x, y_mm + beyond]], Pen::Narrow);
        }
        let [one, other] = places.map(|[x, _]| x);
        let [left, right] = [one.min(other), one.max(other)];
        self.between([left, y_mm], [right, y_mm]);
        let width = width_mm(text, TEXT_MM);
        let (at, anchor) = match right - left > width + 2.0 {
            true => ([0.5 * (left + right), y_mm - 1.0], Anchor::Middle),
            false => ([right + ARROW_MM[0] + 1.5, y_mm - 1.0], Anchor::Start),
        };
        self.text(at, anchor, TEXT_MM, text);
    }

    /// A line with arrows at both ends, from outside where the places are near.
    fn between(&mut self, from: Place, to: Place) {
        let along = [to[0] - from[0], to[1] - from[1]];
        let length = along[0].hypot(along[1]);
        let back = along.map(|part| -part);
        if length > 3.0 * ARROW_MM[0] {
            self.line([from, to], Pen::Narrow);
            self.arrow(from, back);
            self.arrow(to, along);
        } else {
            let out = along.map(|part| 2.0 * ARROW_MM[0] * part / length);
            self.line([[from[0] - out[0], from[1] - out[1]], from], Pen::Narrow);
            self.line([to, [to[0] + out[0], to[1] + out[1]]], Pen::Narrow);
            self.arrow(from, along);
            self.arrow(to, back);
        }
    }

    /// A leader from a text to a place, with an arrow there.
    pub(super) fn leader(&mut self, tip: Place, elbow: Place, text: &str) {
        self.arrow(tip, [tip[0] - elbow[0], tip[1] - elbow[1]]);
        let right = elbow[0] >= tip[0];
        let end = elbow[0] + if right { 2.0 } else { -2.0 };
        self.line([tip, elbow, [end, elbow[1]]], Pen::Narrow);
        let (x, anchor) = match right {
            true => (end + 0.8, Anchor::Start),
            false => (end - 0.8, Anchor::End),
        };
        self.centred([x, elbow[1]], anchor, TEXT_MM, text);
    }

    /// An angle about a centre, its arc between two directions with arrows at both ends.
    pub(super) fn angle(&mut self, centre: Place, radius_mm: f64, range_rad: [f64; 2]) {
        self.arc(centre, radius_mm, range_rad, Pen::Narrow);
        for (angle, turn) in range_rad.into_iter().zip([-1.0, 1.0]) {
            // Chord of an arrow: it lies along the arc.
            let lean = 0.5 * ARROW_MM[0] / radius_mm;
            let along = angle + turn * (FRAC_PI_2 - lean);
            self.arrow(
                on_circle(centre, radius_mm, angle),
                [along.cos(), along.sin()],
            );
        }
    }

    /// A table from its upper left corner down: texts of each row at the left of columns of these widths.
    pub(super) fn table(&mut self, [left, top]: Place, widths_mm: &[f64], rows: &[Vec<String>]) {
        const ROW_MM: f64 = 5.4;
        let width: f64 = widths_mm.iter().sum();
        let height = ROW_MM * rows.len() as f64;
        self.rectangle([left, top], [left + width, top + height], Pen::Narrow);
        for (k, row) in rows.iter().enumerate() {
            let y = top + ROW_MM * k as f64;
            if k > 0 {
                self.line([[left, y], [left + width, y]], Pen::Narrow);
            }
            let mut x = left;
            for (text, width) in row.iter().zip(widths_mm) {
                let middle = [x + 1.2, y + 0.5 * ROW_MM];
                self.centred(middle, Anchor::Start, NOTE_MM, text);
                x += width;
            }
        }
        let mut x = left;
        for width in &widths_mm[..widths_mm.len() - 1] {
            x += width;
            self.line([[x, top], [x, top + height]], Pen::Narrow);
        }
    }
}

/// The place on a circle at an angle from +x towards +y.
pub(super) fn on_circle([x, y]: Place, radius_mm: f64, angle_rad: f64) -> Place {
    let (sin, cos) = angle_rad.sin_cos();
    [x + radius_mm * cos, y + radius_mm * sin]
}

/// Width of a text in a sans-serif face, mm, about.
pub(super) fn width_mm(text: &str, size_mm: f64) -> f64 {
    let share = |letter: char| match letter {
        ' ' | '.' | ',' | ':' | 'i' | 'l' | 'I' | 'f' | 't' | 'j' => 0.278,
        '°' => 0.4,
        'm' | 'w' | 'M' | 'W' | 'Ø' | '–' => 0.78,
        'A'..='Z' => 0.69,
        _ => 0.556,
    };
    text.chars().map(share).sum::<f64>() * size_mm
}
