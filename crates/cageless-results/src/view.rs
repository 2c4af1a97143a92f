//! Records as tables for readers.

use crate::unit::printed;
use crate::{Cell, Quantity, Record, value_text};

/// Label and unit of a result at the head of a column.
pub fn heading(quantity: &Quantity) -> String {
    match quantity.printed_unit().as_str() {
        "" => quantity.label.trim().to_owned(),
        unit => format!("{} ({unit})", quantity.label.trim()),
    }
}

/// A row for each record, a column for each of its results that tables have and for its lists of
/// sentences; the first row is the head: label and unit.
pub fn table_of<'r>(records: impl IntoIterator<Item = &'r Record>) -> Vec<Vec<String>> {
    let mut records = records.into_iter().peekable();
    let Some(first) = records.peek().copied() else {
        return vec![];
    };
    let shown = |record: &Record| -> Vec<_> {
        let all = record
            .iter()
            .filter(|(q, _)| q.in_tables && q.symbol.is_empty());
        let all = all.filter(|(q, _)| q.kind != crate::Kind::Numbers);
        all.map(|(q, cell)| (q, cell.clone())).collect()
    };
    let mut rows = vec![];
    let sentences = first.sentences.iter().map(|(name, _)| (*name).to_owned());
    rows.push(
        (shown(first)
            .iter()
            .map(|(q, _)| heading(q))
            .chain(sentences))
        .collect(),
    );
    rows.extend(records.map(|record| -> Vec<String> {
        let cells = shown(record).into_iter();
        let cells = cells.map(|(q, cell)| value_text(q, &cell).unwrap_or("–".to_owned()));
        let sentences = record.sentences.iter().map(|(_, all)| all.join(", "));
        cells.chain(sentences).collect()
    }));
    rows
}

/// [`table_of`] judgements of a verification, each value in the unit of readers.
pub fn table_of_judgements<'r>(records: impl IntoIterator<Item = &'r Record>) -> Vec<Vec<String>> {
    let for_readers = |record: &Record| {
        let (factor, unit) = printed(record.text("unit"));
        let value = record.value("value").map(|value| factor * value);
        let values = [("value", value.into()), ("unit", Cell::Text(unit))];
        Record::from(record.results.clone().with(&values))
    };
    let all: Vec<Record> = records.into_iter().map(for_readers).collect();
    table_of(&all)
}
