//! The claims of the paper one by one, with what we find, and its errata. Every status and every
//! sentence follows from numbers, see [`cageless_report::claim`].

mod equations;
mod evidence;
mod recommendation;
mod section5;
mod simulation;
mod structures;
#[cfg(test)]
mod tests;
mod theory;

use cageless_report::Claim;

pub use evidence::Evidence;

/// All claims, in the order of the paper.
pub fn claims(e: &Evidence) -> Vec<Claim> {
    let chapters = [
        theory::claims(e),
        simulation::claims(e),
        structures::claims(e),
        recommendation::claims(e),
        section5::claims(e),
        equations::claims(e),
    ];
    chapters.into_iter().flatten().collect()
}

/// First paragraph of the report.
pub fn lead(e: &Evidence) -> String {
    let t = &e.table2;
    let [published, consistent] = [0, 3].map(|column| {
        format!(
            "{:.3}° on nine of the ten structures and by {:.3}° at lC = 5.60 mm",
            t.largest_difference_deg(column),
            t.odd_difference_deg(column)
        )
    });
    let yields = (0..10).map(|row| t.gap_deg(3, row) - t.gap_deg(4, row));
    let [least, most] = yields.fold([f64::INFINITY, 0.0], |[least, most], by| {
        [f64::min(least, by), f64::max(most, by)]
    });
    let slide = (3..10).all(|row| t.gap_deg(3, row) < t.gap_deg(0, row));
    format!(
        "The critical gaps of the equations exactly as published, with Coulomb friction, differ \
         from the paper's simulated column by up to {published}. Those of mechanically consistent \
         equations differ by up to {consistent}{}. \
         Elastic flanks, which yield under the load and on which balls slide and spin, lower these \
         by {least:.2}° to {most:.2}°: the published equations have rigid ones.",
        if slide {
            "; they are smaller from structure (d) on, because balls slide earlier"
        } else {
            ""
        }
    )
}
