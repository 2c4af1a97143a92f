//! Runs side by side: one page, the same axes, and their differences.

use cageless_study::comparison::{ComparedResult, RingComparison};

use crate::compared_run::{ComparedRun, films, provenance};
use crate::data::{Motion, Provenance};
use crate::figures::compare as figures;
use crate::head::Head;
use crate::motion::MotionFigure;
use crate::page::{Note, Page};
use crate::sampling::range;
use crate::table::{Column, Row, Table};
use crate::text::short;

/// The page of `compare`.
pub fn compare_page(runs: &[ComparedRun], comparison: &RingComparison) -> String {
    let names = comparison.runs.join(", ");
    let software = runs.first().map_or("", |run| &run.data.software);
    // What is of one start says which.
    let shown = |run: &ComparedRun| match comparison.draws.seed {
        Some(_) => format!("{}, draw 1 of {}", run.name, comparison.draws.count),
        None => run.name.clone(),
    };
    let lead: Vec<String> = (runs.iter().zip(films(runs)))
        .map(|(run, film)| format!("{}{film}: {}", shown(run), run.data.lead))
        .collect();
    let mut page = Page::new(&format!("Comparison: {names}"), &lead.join(" "), software);
    page.head(&head(comparison));
    if comparison.draws.seed.is_some() {
        page.open_with(figures::benefit(comparison, &provenance(runs)));
    } else {
        page.open_with(figures::spacing(runs));
    }
    page.open_with_motion(motion(runs, comparison));
    for left_out in &comparison.left_out {
        let text = format!("{}: left out, {}", left_out.name, left_out.why);
        page.note(Note::Warning, &text);
    }
    for run in runs {
        for warning in &run.data.warnings {
            page.note(Note::Warning, &format!("{}: {warning}", shown(run)));
        }
    }
    page.section("Differences");
    differing(&mut page, comparison);
    // What is judged stands in the head.
    if comparison.draws.grade.is_none() {
        page.paragraph(&comparison.statement);
    }
    let subject = comparison.subject_over_time();
    if comparison.draws.seed.is_some() {
        page.note(Note::Remark, &comparison.draws.text());
        let label = "What a remedy changes";
        let of = provenance(runs);
        page.figures(figures::benefit(comparison, &of));
        page.table(&table(label, of, comparison, subject.iter().copied()));
    }
    let all = comparison.results.iter();
    page.table(&table("Results", provenance(runs), comparison, all));
    let section = |page: &mut Page, heading: &str| {
        page.section(heading);
        if comparison.draws.seed.is_some() {
            let start = of_start(comparison);
            page.note(Note::Remark, &format!("Figures show the runs{start}."));
        }
    };
    section(&mut page, "Spacing of the balls");
    page.figures(figures::spacing(runs));
    section(&mut page, "Inner ring and loads");
    page.figures(figures::ring(runs).into_iter().chain(figures::loads(runs)));
    page.html()
}

/// Verdicts on the remedies, or on each run where none is judged, and the limits of each.
fn head(comparison: &RingComparison) -> Head {
    let judged = comparison.benefits.iter().flatten();
    let judged = judged.map(|benefit| (benefit.benefit.helps(), benefit.headline.clone()));
    let works = comparison.runs.iter().zip(&comparison.verdicts);
    let works = works.map(|(name, verdict)| match verdict.headline.as_str() {
        "" => (verdict.passes, String::new()),
        headline => (verdict.passes, format!("{name}: {headline}")),
    });
    let all = judged.chain(works.filter(|_| comparison.draws.grade.is_none()));
    let head = all.fold(Head::default(), |head, (passes, text)| {
        head.verdict(passes, &text)
    });
    let of_ring = comparison.runs.iter().zip(&comparison.limits);
    of_ring.fold(head, |head, (name, limits)| {
        let named = limits.verdicts().into_iter();
        let named: Vec<_> = named
            .map(|(kept, text)| (kept, format!("{name}: {text}")))
            .collect();
        head.limits(&named)
    })
}

/// Keys that are shown at once.
const UNFOLDED: usize = 8;

/// Keys in which the cases differ, folded away if they are many.
fn differing(page: &mut Page, comparison: &RingComparison) {
    let keys = &comparison.differing_keys;
    if keys.is_empty() {
        return;
    }
    let mut rows = vec![vec!["key".to_owned()]];
    rows[0].extend(comparison.runs.iter().cloned());
    rows.extend(keys.iter().map(|key| {
        let values = key.values.iter().cloned();
        let values = values.map(|value| value.unwrap_or("–".to_owned()));
        std::iter::once(key.key.clone()).chain(values).collect()
    }));
    let caption = "Keys of the cases that differ; a dash where one is left out.";
    let table = Table::of("Keys that differ", caption, rows, None);
    match keys.len() > UNFOLDED {
        true => {
            let summary = format!("{} keys of the cases differ", keys.len());
            page.fold(&summary, |page| page.table(&table));
        }
        false => page.table(&table),
    }
}

/// Section with benefit, cost and what a remedy changes.
pub(crate) fn benefit_section(page: &mut Page, comparison: &RingComparison, source: &Provenance) {
    page.section("Does it help?");
    page.note(Note::Remark, &comparison.draws.text());
    page.figures(figures::benefit(comparison, source));
    let subject = comparison.subject().into_iter();
    let label = "What a remedy changes";
    page.table(&table(label, source.clone(), comparison, subject));
}

fn table<'r>(
    label: &str,
    source: Provenance,
    comparison: &RingComparison,
    results: impl Iterator<Item = &'r ComparedResult>,
) -> Table {
    let headings = comparison.headings();
    let last = headings.len() - 1;
    // Of each run but the first its values, their differences and a judgement.
    let kind = |k: usize| match k {
        1 => Column::Number,
        2.. if k < last => [Column::Number, Column::Dim, Column::Text][(k - 2) % 3],
        _ => Column::Text,
    };
    let rows = comparison.rows(results).into_iter();
    let columns = headings.into_iter().enumerate();
    Table {
        label: label.to_owned(),
        caption: format!(
            "Each ring after the transient of its runs, and its difference from {}. Better and \
             worse only where the cases differ in nothing but the raceway and the difference is \
             significant.",
            comparison.runs[0]
        ),
        columns: columns.map(|(k, name)| (name, kind(k))).collect(),
        rows: rows.map(Row::from).collect(),
        provenance: Some(source),
        ..Table::default()
    }
}

/// Which of several starts figures show.
fn of_start(comparison: &RingComparison) -> String {
    match comparison.draws.seed {
        Some(_) => format!(" with draw 1 of {}", comparison.draws.count),
        None => String::new(),
    }
}

/// The last orbits of the runs side by side.
fn motion(runs: &[ComparedRun], comparison: &RingComparison) -> Option<MotionFigure> {
    let motions = motions(runs);
    let first = motions.first()?;
    let (from, to) = range(&first.time_s);
    let caption = format!(
        "The last orbits of each run{}, to scale, side by side at the same speed: {} from \
         t = {} s to {} s. The inner rings turn counter-clockwise, load and gravity point \
         down; discrete raceways are shaded orange, balls 1 and 2 blue, balls in contact \
         ringed.",
        of_start(comparison),
        first.title,
        short(from),
        short(to)
    );
    Some(MotionFigure::new("Motion", &caption, motions))
}

/// The motions on the time axis of the first; runs may have different lengths.
fn motions(runs: &[ComparedRun]) -> Vec<Motion> {
    let mut begin_s = None;
    let motions = runs.iter().filter_map(|run| {
        let mut motion = run.data.motion.clone()?;
        let own_s = *motion.time_s.first()?;
        let shift_s = *begin_s.get_or_insert(own_s) - own_s;
        motion.time_s.iter_mut().for_each(|t| *t += shift_s);
        motion.title.clone_from(&run.name);
        Some(motion)
    });
    motions.collect()
}
