//! The outer ring as a dimensioned drawing, SVG and PDF.

mod dimension;
mod hatch;
mod paper;
mod pdf;
mod ring;
mod svg;
mod views;

pub use paper::Paper;
pub use ring::ring_drawing;
