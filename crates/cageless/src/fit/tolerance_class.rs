//! Tolerance classes of shafts and holes, such as k5 and H7, and their limits (ISO 286-1:2010).

use super::size_range::{MICROMETRE_M, SizeRange};

/// Fundamental deviation of a tolerance class, by its letters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Letters {
    D,
    E,
    F,
    G,
    H,
    Js,
    J,
    K,
    M,
    N,
    P,
    R,
}

/// Letters of a shaft; in capitals, those of a hole.
const LETTERS: [(&str, Letters); 12] = [
    ("d", Letters::D),
    ("e", Letters::E),
    ("f", Letters::F),
    ("g", Letters::G),
    ("h", Letters::H),
    ("js", Letters::Js),
    ("j", Letters::J),
    ("k", Letters::K),
    ("m", Letters::M),
    ("n", Letters::N),
    ("p", Letters::P),
    ("r", Letters::R),
];

/// Standard tolerance grades of the tables, IT4 to IT9.
const GRADES: std::ops::RangeInclusive<usize> = 4..=9;

/// Letters and grade of a name.
fn parsed(name: &str) -> Option<(String, usize)> {
    let digits = name.find(|c: char| c.is_ascii_digit())?;
    let (letters, grade) = name.split_at(digits);
    let grade = grade.parse().ok().filter(|grade| GRADES.contains(grade))?;
    // Without a sign or leading zeros.
    (name == format!("{letters}{grade}")).then(|| (letters.to_owned(), grade))
}

/// Tolerance class of a shaft, k5 say.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ShaftClass {
    letters: Letters,
    grade: usize,
}

impl ShaftClass {
    /// Names that there are, as a phrase.
    pub const ALLOWED: &'static str = "a tolerance class of ISO 286 for a shaft, \"k5\" say: d, e, f, g, h, js, k, m, n, p \
         or r with grade 4 to 9, or j5 to j7";

    /// The class of a name; `None` if there is none.
    pub fn from_name(name: &str) -> Option<Self> {
        let (found, grade) = parsed(name)?;
        let (_, letters) = LETTERS.into_iter().find(|(name, _)| *name == found)?;
        let is_one = letters != Letters::J || (5..=7).contains(&grade);
        is_one.then_some(Self { letters, grade })
    }

    /// Lower and upper limit deviation of a nominal size, m; `None` beyond 1 to 500 mm.
    pub(crate) fn limits_m(self, size_m: f64) -> Option<[f64; 2]> {
        let range = SizeRange::of(size_m)?;
        let tolerance = range.tolerance_um(self.grade);
        // es of d to h, ei of the others.
        let es = |deviation: f64| [-deviation - tolerance, -deviation];
        let ei = |deviation: f64| [deviation, deviation + tolerance];
        let [d, e, f, g] = range.clearances_um;
        let [k, m, n, p] = range.interferences_um;
        let limits_um = match self.letters {
            Letters::D => es(d),
            Letters::E => es(e),
            Letters::F => es(f),
            Letters::G => es(g),
            Letters::H => es(0.0),
            Letters::Js => ei(-0.5 * tolerance),
            Letters::J => ei(range.shaft_j_um[usize::from(self.grade == 7)]),
            Letters::K if self.grade > 7 => ei(0.0),
            Letters::K => ei(k),
            Letters::M => ei(m),
            Letters::N => ei(n),
            Letters::P => ei(p),
            Letters::R => ei(SizeRange::r_um(size_m)),
        };
        Some(limits_um.map(|um| um * MICROMETRE_M))
    }
}

/// Tolerance class of a hole, H7 say.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct HoleClass {
    letters: Letters,
    grade: usize,
}

impl HoleClass {
    /// Names that there are, as a phrase.
    pub const ALLOWED: &'static str = "a tolerance class of ISO 286 for a hole, \"H7\" say: D, E, F, G, H, JS, M, N, P or R \
         with grade 4 to 9, J6 to J8 or K4 to K8";

    /// The class of a name; `None` if there is none.
    pub fn from_name(name: &str) -> Option<Self> {
        let (found, grade) = parsed(name)?;
        let is_named = |(name, _): &(&str, Letters)| name.to_uppercase() == found;
        let (_, letters) = LETTERS.into_iter().find(is_named)?;
        let is_one = match letters {
            Letters::J => (6..=8).contains(&grade),
            Letters::K => grade <= 8,
            _ => true,
        };
        is_one.then_some(Self { letters, grade })
    }

    /// Lower and upper limit deviation of a nominal size, m; `None` beyond 1 to 500 mm.
    ///
    /// EI of D to H is −es of the shaft. ES of K, M, N up to IT8 and of P, R up to IT7 is −ei + Δ,
    /// Δ = ITn − IT(n−1), 0 up to 3 mm; −ei above these grades, and 0 for N above 3 mm.
    pub(crate) fn limits_m(self, size_m: f64) -> Option<[f64; 2]> {
        let range = SizeRange::of(size_m)?;
        let tolerance = range.tolerance_um(self.grade);
        let ei = |deviation: f64| [deviation, deviation + tolerance];
        let es = |deviation: f64| [deviation - tolerance, deviation];
        let raised = |deviation: f64, most: usize| match self.grade <= most {
            true => es(-deviation + range.step_um(self.grade)),
            false => es(-deviation),
        };
        let [d, e, f, g] = range.clearances_um;
        let [k, m, n, p] = range.interferences_um;
        let limits_um = match self.letters {
            Letters::D => ei(d),
            Letters::E => ei(e),
            Letters::F => ei(f),
            Letters::G => ei(g),
            Letters::H => ei(0.0),
            Letters::Js => ei(-0.5 * tolerance),
            Letters::J => es(range.hole_j_um[self.grade - 6]),
            Letters::K => raised(k, 8),
            // The one exception of the standard.
            Letters::M if self.grade == 6 && range.to_mm == 315.0 => es(-9.0),
            Letters::M => raised(m, 8),
            Letters::N if self.grade > 8 && range.to_mm > 3.0 => es(0.0),
            Letters::N => raised(n, 8),
            Letters::P => raised(p, 7),
            Letters::R => raised(SizeRange::r_um(size_m), 7),
        };
        Some(limits_um.map(|um| um * MICROMETRE_M))
    }
}
