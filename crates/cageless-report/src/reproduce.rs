//! Every table and figure of Zhao 2022 beside the paper's own numbers.

use cageless::vibration::AFTER_CONTACT_S;

use crate::comparison::RingComparison;
use crate::figures::{comparison, design, orbit, phase, shape, spacing, vibration};
use crate::motion::MotionFigure;
use crate::page::{Note, Page};
use crate::reproduce_data::ReproduceData;
use crate::studio_page::studio_section;
use crate::tables;

/// Moments of the high-speed photographs in the paper's Fig. 13 and 14, s.
const PHOTOGRAPHS_S: [f64; 4] = [0.05, 0.1, 0.15, 0.2];

/// The page with every table and figure of the paper.
pub fn reproduce_page(data: &ReproduceData) -> String {
    let mut page = Page::new(
        "Discrete dynamics of balls in cageless ball bearings, reproduced",
        &data.lead,
        &data.software,
    );
    open(&mut page, data);
    page.note(Note::Remark, SOURCE);
    page.section("Claims of the paper");
    page.claims(&data.claims);
    page.section("Parameters");
    if !data.table1.is_empty() {
        page.table(&tables::table1(&data.table1));
    }
    page.section("The discrete raceway");
    page.figures(data.contact_track.iter().map(shape::contact_track));
    page.figures(data.surface.iter().map(shape::surface));
    page.section("Axial span and half angle");
    page.figures(data.design_curve.iter().map(design::curve));
    page.section("Spacing of the balls");
    page.figures(data.gap_histories.iter().map(spacing::gap_history));
    page.figures(data.neighbours.iter().map(spacing::neighbours));
    page.section("Ten structures: theory and simulation");
    if let Some(table) = &data.table2 {
        page.table(&tables::table2(table));
        page.figure(&design::table2(table));
        page.fold("What moves with what the paper leaves open", |page| {
            tables::spread(table).iter().for_each(|t| page.table(t));
        });
    }
    page.section("Phase portraits of ball 1");
    for portraits in &data.phase_portraits {
        page.figures([phase::velocities(portraits), phase::positions(portraits)]);
    }
    page.section("Orbital speed in the discrete raceway");
    page.figures(data.orbit_speeds.iter().map(orbit::speeds));
    page.section("Vibration");
    let vibrations = data.vibrations.iter();
    page.figures(vibrations.map(|v| vibration::vibration("Figure 12", v).with_formulation()));
    if let Some(rings) = &data.ring_comparison {
        rings_compared(&mut page, rings);
    }
    studio_section(&mut page, &data.case_toml, STUDIO);
    page.html()
}

/// Section on rings with equal and unequal balls.
fn rings_compared(page: &mut Page, rings: &RingComparison) {
    page.section("Rings compared with equal and unequal balls");
    page.paragraph(&format!(
        "{} At passing: the part of the power spectrum at the multiples of the balls' mean \
         orbital frequency, where everything lies that recurs with each orbit, contacts \
         included if they do; between: the rest. The squares of the two add up to that of the \
         RMS, start by start. Contacts cut out: the housing under the same force, but with a \
         straight line from each touch of two balls to {} ms after they part; contacts alone: \
         the housing under what was cut out. These two add up as signals; their squares do \
         not where they are correlated, as they are where balls stay in contact for much of a \
         passage: the line then takes out force of the passage as well, and the rest may \
         exceed the whole. Contacts: from touch to parting, in the part of the \
         run that is not discarded.",
        rings.starts,
        AFTER_CONTACT_S * 1e3
    ));
    page.paragraph(&format!(
        "Left out by the model: {}.",
        rings.left_out.join(", ")
    ));
    page.paragraph(&format!(
        "To repeat the comparison: {}. The raceways found by search: {}.",
        rings.command,
        rings.search_commands.join(", ")
    ));
    page.figure(&comparison::comparison(rings));
    rings.tables().iter().for_each(|t| page.table(t));
}

/// Opening of the page: Table 2, the phase portraits, the balls.
fn open(page: &mut Page, data: &ReproduceData) {
    page.open_with(data.table2.iter().map(design::table2_overview));
    page.open_with(data.phase_portraits.first().map(phase::overview));
    if !data.motions.is_empty() {
        let caption = "The balls of the conventional and of the discrete bearing, with the moments of the paper's \
                       photographs.";
        page.open_with_motion(Some(MotionFigure {
            moments_s: PHOTOGRAPHS_S.to_vec(),
            ..MotionFigure::new("Figures 13 and 14", caption, data.motions.clone())
        }));
    }
}

const STUDIO: &str = "Structure (d) of Table 2, the raceway of the experiment, with the equations of \
    the formulation `physical`. Everything above stays as it was computed.";

const SOURCE: &str = "Zhao, Y.; Zhou, G.; Wang, Q. Discrete Dynamics of Balls in Cageless Ball \
    Bearings. Symmetry 2022, 14, 2242, doi 10.3390/sym14112242 (CC BY). Numbers of figures, tables \
    and equations are the paper's. Gap: angle from a ball to the ball ahead less the angle of two \
    balls in contact; 0 is contact. ψ: place of a ball, from the bottom, counter-clockwise.";
