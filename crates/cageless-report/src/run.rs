//! Page of a run.

use crate::data::Motion;
use crate::figures::gap_map::gap_map;
use crate::figures::{RUN, SPACING};
use crate::head::Head;
use crate::motion::MotionFigure;
use crate::page::{Note, Page};
use crate::run_data::RunData;
use crate::sampling::range;
use crate::studio_page::case_sections;
use crate::text::short;

/// The page of one run.
pub fn run_page(data: &RunData) -> String {
    let mut page = Page::new(&data.title, &data.lead, &data.software);
    page.head(
        &Head::default()
            .open_benefit(data.passes)
            .verdict(data.passes, &data.headline)
            .facts(data.facts.clone()),
    );
    page.open_with_motion(
        data.motion
            .as_ref()
            .map(|m| motion_figure(m, &data.passages)),
    );
    page.open_with(gap_map(data));
    page.notes(Note::Warning, &data.warnings);
    for (title, figures) in RUN {
        page.section(title);
        page.figures(figures.iter().filter_map(|figure| (figure.draw)(data)));
        if title == SPACING {
            remarks(&mut page, data);
        }
    }
    let source = &data.provenance;
    page.section("Results");
    page.parameters(
        "Results",
        "Summary of results.",
        &data.results,
        Some(source),
    );
    page.section("Numerical verification");
    if let Some(verification) = &data.verification {
        verification.show(&mut page, "Numerical verification", source);
    }
    let title = "The case as run";
    case_sections(&mut page, title, &data.parameters, &data.case_toml);
    page.html()
}

/// Why a gap can be negative.
const FLATTENED: &str = "A gap is the angle between two balls less that at which they just touch: in \
    a contact, which flattens both, it is a little negative.";

/// Why pairs touch although the raceway spreads the balls.
const CLOSES: &str = "Inside the discrete raceway a pair closes up by design: the ball ahead slows \
    first, the one behind catches up and may touch it; the ball ahead leaves first and draws away, so \
    that the pair leaves with at least the critical gap. Contacts in the raceway are therefore no \
    fault; double collisions (contacts with the balls ahead and behind in one passage) are, and contacts elsewhere \
    show that the gaps have not settled. A gap is the angle between two balls less that at which they \
    just touch: in a contact, which flattens both, it is a little negative.";

/// Remarks on the gaps, and on a run without contacts between balls.
fn remarks(page: &mut Page, data: &RunData) {
    if !data.balls.is_empty() {
        let note = if data.sectors.is_empty() {
            FLATTENED
        } else {
            CLOSES
        };
        page.note(Note::Remark, note);
    }
    if data.collisions.is_empty() && !data.balls.is_empty() {
        page.note(Note::Remark, "No two balls touched.");
    }
}

/// The balls of a run in motion, with its passages to choose from.
fn motion_figure(motion: &Motion, passages: &[(String, [f64; 2])]) -> MotionFigure {
    let (from, to) = range(&motion.time_s);
    let caption = format!(
        "The balls from t = {} s to {} s, to scale. The inner ring turns counter-clockwise, \
         load and gravity point down; the discrete raceway is shaded orange, balls 1 and 2 \
         blue, balls in contact ringed. A passage or any stretch of time can be chosen, and \
         saved as an animated GIF.",
        short(from),
        short(to)
    );
    MotionFigure {
        stretches: passages.to_vec(),
        ..MotionFigure::new("Motion", &caption, vec![motion.clone()])
    }
}
