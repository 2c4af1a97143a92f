//! Plain text tables for the terminal.

use std::io::IsTerminal;

use cageless_results::{
    DropResult, DryVerdict, Results, Shown, ShownBeside, number_text, with_unit,
};
use cageless_study::comparison::{ComparedResult, RingComparison};

/// Verdict of long runs of real balls, with the table of the rings and a blank line.
pub fn compared(answer: &str, comparison: &RingComparison) -> String {
    let table = rings(comparison, comparison.subject().into_iter());
    format!("{answer}\n\n{table}\n")
}

/// Table of what is asked and of results in which rings differ, side by side, with what was drawn.
pub fn rings<'r>(
    comparison: &RingComparison,
    results: impl Iterator<Item = &'r ComparedResult>,
) -> String {
    let mut rows = vec![comparison.headings()];
    rows.extend(comparison.rows(results.filter(|result| result.is_telling())));
    format!("{}\n{}\n", columns(&rows), comparison.draws.text())
}

/// Lines up columns: text to the left, numbers to the right. The first row is the head.
pub fn columns(rows: &[Vec<String>]) -> String {
    let width = |k: usize| {
        rows.iter()
            .filter_map(|r| r.get(k))
            .map(|c| c.chars().count())
            .max()
    };
    let widths: Vec<usize> = (0..).map_while(width).collect();
    let numeric: Vec<bool> = (0..widths.len())
        .map(|k| {
            rows.iter()
                .skip(1)
                .filter_map(|r| r.get(k))
                .all(|c| c == "–" || c.replace('−', "-").parse::<f64>().is_ok())
        })
        .collect();
    rows.iter()
        .map(|row| {
            let line: String = row
                .iter()
                .enumerate()
                .map(|(k, cell)| {
                    let pad = " ".repeat(widths[k] - cell.chars().count());
                    if numeric[k] {
                        format!("{pad}{cell}  ")
                    } else {
                        format!("{cell}{pad}  ")
                    }
                })
                .collect();
            line.trim_end().to_owned() + "\n"
        })
        .collect()
}

/// `name = value unit` lines, names lined up.
pub fn pairs(rows: &[(impl AsRef<str>, String)]) -> String {
    let length = |name: &dyn AsRef<str>| name.as_ref().chars().count();
    let width = rows.iter().map(|(name, _)| length(name)).max().unwrap_or(0);
    rows.iter()
        .map(|(name, value)| {
            let padding = " ".repeat(width - length(name));
            format!("{}{padding}  {value}\n", name.as_ref())
        })
        .collect()
}

/// Values of results with their units, by label under the headings of their groups.
pub fn grouped(results: &Results) -> String {
    under_headings(&results.groups())
}

/// Results of drops under the headings of their groups: those of one with their units, of several side by side.
pub fn drops(named: &[(String, &DropResult)]) -> String {
    let (names, drops): (Vec<String>, Vec<&DropResult>) = named.iter().cloned().unzip();
    let groups = DropResult::groups(&drops);
    if drops.len() == 1 {
        let one = |(label, values, unit): ShownBeside| (label, values.concat(), unit);
        let groups = groups.into_iter();
        let groups: Vec<_> = groups
            .map(|(heading, rows)| (heading, rows.into_iter().map(one).collect()))
            .collect();
        return under_headings(&groups);
    }
    let row = |first: String, values: Vec<String>, unit: String| {
        let (first, last) = (std::iter::once(first), std::iter::once(unit));
        first.chain(values).chain(last).collect::<Vec<_>>()
    };
    let mut rows = vec![row(String::new(), names, "unit".to_owned())];
    for (k, (heading, listed)) in groups.into_iter().enumerate() {
        if k > 0 {
            rows.push(vec![]);
        }
        rows.push(vec![heading.to_owned()]);
        let listed = listed.into_iter();
        rows.extend(listed.map(|(label, values, unit)| row(format!("  {label}"), values, unit)));
    }
    columns(&rows)
}

fn under_headings(groups: &[(&str, Vec<Shown>)]) -> String {
    let length = |label: &str| label.chars().count();
    let labels = groups.iter().flat_map(|(_, rows)| rows);
    let width = labels.map(|(label, ..)| length(label)).max().unwrap_or(0);
    let line = |(label, value, unit): &Shown| {
        let padding = " ".repeat(width - length(label));
        format!("  {label}{padding}  {}\n", with_unit(value, unit))
    };
    let group = |(heading, rows): &(&str, Vec<_>)| {
        let heading = match *heading {
            "" => String::new(),
            heading => format!("{heading}\n"),
        };
        heading + &rows.iter().map(line).collect::<String>()
    };
    groups.iter().map(group).collect::<Vec<_>>().join("\n")
}

/// Values of results with their units, by label.
pub fn values(results: &Results) -> Vec<(&'static str, String)> {
    let rows = results.rows();
    rows.map(|(label, value, unit)| (label, with_unit(&value, &unit)))
        .collect()
}

/// A verdict with its reason, in green or red on a terminal.
pub fn judged(passes: Option<bool>, headline: &str) -> String {
    if !std::io::stdout().is_terminal() || std::env::var_os("NO_COLOR").is_some() {
        return headline.to_owned();
    }
    coloured(passes, headline)
}

/// The verdict of a tolerance analysis with its reason, below it that without oil.
pub fn headlines(results: &Results) -> String {
    let own = judged(results.flag("passes"), results.text("headline")) + "\n";
    let dry = DryVerdict::of(results).map(|dry| {
        let headline = judged(dry.passes, dry.headline);
        format!("{}: {headline}\n", DryVerdict::NAME)
    });
    own + &dry.unwrap_or_default()
}

/// The verdict at the head of a headline in its colour.
fn coloured(passes: Option<bool>, headline: &str) -> String {
    let colour = match passes {
        Some(true) => "32",
        Some(false) => "31",
        None => return headline.to_owned(),
    };
    let ends = [" in ", " from ", ":", ";"];
    let word = ends.iter().filter_map(|end| headline.find(end)).min();
    let (word, rest) = headline.split_at(word.unwrap_or(headline.len()));
    format!("\u{1b}[1;{colour}m{word}\u{1b}[0m{rest}")
}

/// A number with so many decimals and a true minus sign; what rounds to zero has none.
pub fn fixed(value: f64, decimals: usize) -> String {
    number_text::fixed(Some(value), decimals)
}

/// A line for each note.
pub fn notes(all: &[String]) -> String {
    all.iter().map(|n| format!("note: {n}\n")).collect()
}

/// A line for each warning.
pub fn warnings(all: &[String]) -> String {
    all.iter().map(|w| format!("warning: {w}\n")).collect()
}

#[cfg(test)]
mod tests {
    use super::{coloured, columns};

    #[test]
    fn numbers_with_a_minus_sign_and_dashes_are_lined_up_to_the_right() {
        let rows = ["name", "−12.5", "–", "3"].map(|cell| vec!["a".to_owned(), cell.to_owned()]);
        assert_eq!(columns(&rows), "a   name\na  −12.5\na      –\na      3\n");
    }

    #[test]
    fn a_verdict_has_the_colour_of_its_word() {
        assert_eq!(
            coloured(Some(true), "works in this run: smooth"),
            "\u{1b}[1;32mworks\u{1b}[0m in this run: smooth"
        );
        assert_eq!(
            coloured(Some(false), "does not work; slides"),
            ["\u{1b}[1;31m", "does not work", "\u{1b}[0m; slides"].concat()
        );
        assert_eq!(
            coloured(None, "not judged: no raceway"),
            "not judged: no raceway"
        );
    }
}
