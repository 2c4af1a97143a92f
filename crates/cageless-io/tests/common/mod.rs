//! What the tests share.
#![allow(dead_code, reason = "each test file uses its part")]

use std::path::{Path, PathBuf};

use cageless::Case;
use cageless::dynamics::{Model, RightHandSide, State};
use cageless::reference::Textbook;
use cageless_io::case_file::{CaseError, CaseFile, template};

/// The template with one piece of text replaced.
pub fn edited(from: &str, to: &str) -> String {
    let text = template(false);
    assert!(text.contains(from), "the template has no `{from}`");
    text.replacen(from, to, 1)
}

/// The template without the lines of a film, whose oil takes the place of the viscosity of the ratings.
pub fn without_film(template: &str) -> String {
    let (before, film) = template.split_once("# [film]").expect("lines of a film");
    let (_, after) = film.split_once("\n\n").expect("a further section");
    before.to_owned() + after
}

/// Reads a text that must be refused.
pub fn refused(text: &str, overrides: &[&str]) -> CaseError {
    let overrides: Vec<String> = overrides.iter().map(|s| (*s).to_owned()).collect();
    match CaseFile::parse(text, "case.toml", &overrides) {
        Err(error) => error,
        Ok(file) => panic!("accepted: {:?}", file.document()),
    }
}

/// Line of the text that starts with `start`, counted from 1.
pub fn line_of(text: &str, start: &str) -> usize {
    1 + text
        .lines()
        .position(|l| l.starts_with(start))
        .expect("the line is there")
}

/// Folder of the reference trajectories.
pub fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/reference")
}

/// Rows of the reference: x, y, vx, vy, spin; the last row is the ring.
pub fn reference(name: &str) -> Vec<Vec<f64>> {
    let text = std::fs::read_to_string(folder().join(format!("{name}_2ms.csv"))).unwrap();
    text.lines()
        .filter(|line| !line.starts_with('#') && !line.starts_with("body"))
        .map(|line| {
            line.split(',')
                .skip(1)
                .filter_map(|v| v.parse().ok())
                .collect()
        })
        .collect()
}

/// RMS over the coordinates of (state − reference)/scale at 2 ms.
pub fn scaled_error_of(case: &Case, name: &str, state: &State) -> f64 {
    let model = Model::new(case).unwrap();
    let (layout, rows) = (state.layout(), reference(name));
    let n = layout.balls;
    assert_eq!(rows.len(), n + 1);
    let mut motion = Textbook::motion(layout, state.values());
    // The reference gives the absolute spin.
    let seen = RightHandSide::new(&model).snapshot(0.0, state, &vec![0.0; n]);
    motion[4 * n..5 * n].copy_from_slice(&seen.rotation_rad_s);
    let (ring, balls) = rows.split_last().unwrap();
    let of_balls = (0..5).flat_map(|coordinate| balls.iter().map(move |row| row[coordinate]));
    let expected: Vec<f64> = of_balls.chain(ring.iter().copied()).collect();
    assert_eq!(motion.len(), expected.len());
    let scales = Textbook::scales(layout);
    let squares =
        (motion.iter().zip(expected).zip(&scales)).map(|((a, b), s)| ((a - b) / s).powi(2));
    (squares.sum::<f64>() / scales.len() as f64).sqrt()
}
