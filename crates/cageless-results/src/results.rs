//! Values of results.

use serde::ser::{Serialize, SerializeMap, Serializer};
use serde_json::{Map, Value};

use crate::Cell;
use crate::group::Group;
use crate::kind::Kind;
use crate::quantity::Quantity;
use crate::source::Subject;

/// A result for readers: label, value, unit.
pub type Shown = (&'static str, String, String);

/// Scalar results with their quantities, in the order of the table. Serialised as a map from
/// name to value.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Results(Vec<(&'static Quantity, Cell)>);

impl Results {
    /// Results `rows` of a subject; those that are computed from something else are left out.
    pub fn of(rows: &'static [Quantity], subject: Subject<'_>) -> Self {
        let all = rows.iter();
        Self(
            all.filter_map(|q| Some((q, q.of.value(subject)?)))
                .collect(),
        )
    }

    /// Results with these values by name.
    pub fn only(rows: &'static [Quantity], values: &[(&str, Cell)]) -> Self {
        let found = |q: &Quantity| values.iter().find(|(name, _)| q.name == *name);
        let all = rows.iter();
        Self(all.filter_map(|q| Some((q, found(q)?.1.clone()))).collect())
    }

    /// These results, then `more`.
    pub fn and(mut self, more: Self) -> Self {
        self.0.extend(more.0);
        self
    }

    /// These results with other values of those named.
    pub(crate) fn with(mut self, values: &[(&str, Cell)]) -> Self {
        for (quantity, cell) in &mut self.0 {
            if let Some((_, value)) = values.iter().find(|(name, _)| quantity.name == *name) {
                *cell = value.clone();
            }
        }
        self
    }

    /// Every quantity with its value.
    pub fn iter(&self) -> impl Iterator<Item = (&'static Quantity, &Cell)> {
        self.0.iter().map(|(quantity, cell)| (*quantity, cell))
    }

    /// Value of a quantity.
    pub fn get(&self, name: &str) -> Option<&Cell> {
        let mut all = self.iter();
        all.find(|(q, _)| q.name == name).map(|(_, cell)| cell)
    }

    /// Value of a numeric quantity; NaN if there is none.
    pub fn number(&self, name: &str) -> f64 {
        self.value(name).unwrap_or(f64::NAN)
    }

    /// Value of a numeric quantity, if it has one.
    pub fn value(&self, name: &str) -> Option<f64> {
        self.get(name).and_then(Cell::number)
    }

    /// Text of a quantity; empty if it has none.
    pub fn text(&self, name: &str) -> &str {
        self.get(name).and_then(Cell::text).unwrap_or_default()
    }

    /// Whether a flag is set; `None` if it has no value.
    pub fn flag(&self, name: &str) -> Option<bool> {
        match self.get(name) {
            Some(Cell::Integer(flag)) => Some(*flag == 1),
            _ => None,
        }
    }

    /// Values of a quantity of every ball; empty if there are none.
    pub fn values(&self, name: &str) -> &[f64] {
        match self.get(name) {
            Some(Cell::Numbers(values)) => values,
            _ => &[],
        }
    }

    /// Items of a list; none if there is no list.
    pub fn items(&self, name: &str) -> &[Cell] {
        self.get(name).map_or(&[], Cell::items)
    }

    /// Quantities for readers that have a value: label, value, unit. A life in revolutions is left out beside that in
    /// hours, and zeros by symmetry are.
    pub fn rows(&self) -> impl Iterator<Item = Shown> {
        self.shown().filter_map(|(q, cell)| row(q, cell))
    }

    fn shown(&self) -> impl Iterator<Item = (&'static Quantity, &Cell)> {
        self.iter().filter(|(q, cell)| {
            let hours = q.name.strip_suffix("_mrev").map(|life| format!("{life}_h"));
            let said = hours.is_some_and(|hours| self.value(&hours).is_some());
            q.in_tables && !said && (q.shows_zero || !is_zero(q, cell))
        })
    }

    /// [`Results::rows`] under the headings of their groups.
    pub fn groups(&self) -> Vec<(&'static str, Vec<Shown>)> {
        let rows = self
            .shown()
            .filter_map(|(q, cell)| Some((q.group, row(q, cell)?)));
        let mut rows: Vec<_> = rows.collect();
        rows.sort_by_key(|(group, _)| *group);
        let groups = rows.chunk_by(|a, b| a.0 == b.0);
        let of = |rows: &[(Group, Shown)]| {
            let listed = rows.iter().map(|(_, row)| row.clone()).collect();
            (rows[0].0.heading(), listed)
        };
        groups.map(of).collect()
    }

    /// Values of every ball as a table for readers: the number of the ball, then the lists with a symbol.
    /// The first row is the head.
    pub fn columns(&self) -> Vec<Vec<String>> {
        let lists = self.iter().filter(|(q, _)| !q.symbol.is_empty());
        let head = |q: &Quantity| format!("{} {}", q.symbol, q.printed_unit());
        let mut columns = vec![];
        for (quantity, cell) in lists {
            if let Cell::Numbers(values) = cell {
                let value = |v: &f64| quantity.number_text(*v);
                let mut column = vec![head(quantity)];
                column.extend(values.iter().map(value));
                columns.push(column);
            }
        }
        let balls = columns.first().map_or(0, Vec::len);
        let row = |k: usize| {
            let ball = if k == 0 {
                "ball".to_owned()
            } else {
                k.to_string()
            };
            let rest = columns
                .iter()
                .map(|c| c.get(k).cloned().unwrap_or_default());
            std::iter::once(ball).chain(rest).collect()
        };
        (0..balls).map(row).collect()
    }

    /// Symbols of [`Results::columns`] with their labels: `ψ angular position, r …`.
    pub fn legend(&self) -> String {
        let lists = self.iter().filter(|(q, _)| !q.symbol.is_empty());
        let words = |q: &Quantity| match is_named_in(q.symbol, q.label) {
            true => q.label.to_owned(),
            false => format!("{} {}", q.symbol, q.label),
        };
        let words: Vec<_> = lists.map(|(q, _)| words(q)).collect();
        words.join("; ")
    }

    /// Label, value and unit of one quantity, if it has a value.
    pub fn row(&self, name: &str) -> Option<Shown> {
        let found = self.iter().find(|(q, _)| q.name == name);
        found.and_then(|(q, cell)| row(q, cell))
    }
}

/// Whether words of a label are the symbol: `po` stands in "contact points", too.
fn is_named_in(symbol: &str, label: &str) -> bool {
    let letter = |c: Option<char>| c.is_some_and(char::is_alphanumeric);
    label.match_indices(symbol).any(|(at, _)| {
        let (before, after) = (&label[..at], &label[at + symbol.len()..]);
        !letter(before.chars().next_back()) && !letter(after.chars().next())
    })
}

/// Whether a value reads as nothing but zeros.
pub(crate) fn is_zero(quantity: &Quantity, cell: &Cell) -> bool {
    let texts = value_text(quantity, cell);
    texts.is_some_and(|text| text.split(", ").all(|value| value == "0"))
}

fn row(q: &'static Quantity, cell: &Cell) -> Option<Shown> {
    Some((q.label, value_text(q, cell)?, q.printed_unit()))
}

/// A value for readers, in [`Quantity::printed_unit`]; `None` if there is none.
pub fn value_text(quantity: &Quantity, cell: &Cell) -> Option<String> {
    match (quantity.kind, cell) {
        (Kind::Flag, Cell::Integer(flag)) => Some(if *flag == 1 { "yes" } else { "no" }.into()),
        (_, Cell::Integer(count)) => Some(count.to_string()),
        (_, Cell::Number(value)) => Some(quantity.number_text(*value)),
        (_, Cell::Text(text)) => Some(text.clone()),
        (Kind::Range, Cell::Numbers(values)) => {
            let values = values.iter().map(|value| quantity.number_text(*value));
            Some(values.collect::<Vec<_>>().join(" … "))
        }
        (Kind::Few, Cell::Numbers(values)) => {
            let values = values.iter().map(|value| quantity.number_text(*value));
            Some(values.collect::<Vec<_>>().join(", "))
        }
        (_, Cell::List(cells)) => {
            let texts = cells.iter().map(|cell| value_text(quantity, cell));
            Some(texts.collect::<Option<Vec<_>>>()?.join(", "))
        }
        (_, Cell::Null | Cell::Numbers(_)) => None,
    }
}

impl Results {
    /// Adds every name with its value to a map.
    pub(crate) fn serialize_entries<M: SerializeMap>(&self, map: &mut M) -> Result<(), M::Error> {
        let mut all = self.iter();
        all.try_for_each(|(q, cell)| map.serialize_entry(q.name, &cell.json(q.kind)))
    }

    /// The results `rows` of a JSON object.
    pub(crate) fn read(
        rows: &'static [Quantity],
        object: &Map<String, Value>,
    ) -> Result<Self, String> {
        let cell = |q: &'static Quantity| {
            let value = object.get(q.name);
            let value = value.ok_or_else(|| format!("{} is missing", q.name))?;
            Ok((q, Cell::read(q.kind, value)))
        };
        rows.iter().map(cell).collect::<Result<_, _>>().map(Self)
    }
}

impl Serialize for Results {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.0.len()))?;
        self.serialize_entries(&mut map)?;
        map.end()
    }
}
