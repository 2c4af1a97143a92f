//! Results of a rotor in several bearings, from those of its bearings.

use crate::Cell;
use cageless::touchdown::EndState;

/// Rule by which a result of a rotor in several bearings follows from those of its bearings.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Across {
    /// The largest of the bearings that have it.
    Largest,
    /// The largest; none if a bearing has none.
    LargestOfAll,
    /// The smallest of the bearings that have it.
    Smallest,
    /// The sum.
    Sum,
    /// The value of the rotor, common to all bearings.
    Same,
    /// The verdict on all bearings and the planes of the rotor.
    Verdict,
    /// The worst state at the end, the last in the order of [`EndState::ALL`].
    WorstState,
}

impl Across {
    pub(super) fn of<'c>(self, cells: impl Iterator<Item = &'c Cell> + Clone) -> Cell {
        let largest = || {
            cells
                .clone()
                .filter(|c| value(c).is_some())
                .max_by(|a, b| order(a, b))
        };
        let found = match self {
            Self::Largest => largest(),
            Self::LargestOfAll if cells.clone().any(|cell| value(cell).is_none()) => None,
            Self::LargestOfAll => largest(),
            Self::Smallest => {
                let cells = cells.clone().filter(|c| value(c).is_some());
                cells.min_by(|a, b| order(a, b))
            }
            Self::Sum => return sum(cells),
            Self::Same | Self::Verdict => cells.clone().next(),
            Self::WorstState => cells.clone().max_by_key(|cell| severity(cell)),
        };
        found.cloned().unwrap_or(Cell::Null)
    }
}

fn value(cell: &Cell) -> Option<f64> {
    cell.number().filter(|value| !value.is_nan())
}

fn order(a: &Cell, b: &Cell) -> std::cmp::Ordering {
    let of = |cell| value(cell).unwrap_or(f64::NAN);
    of(a).total_cmp(&of(b))
}

fn sum<'c>(cells: impl Iterator<Item = &'c Cell>) -> Cell {
    cells.fold(Cell::Null, |sum, cell| match (sum, cell) {
        (Cell::Integer(a), Cell::Integer(b)) => Cell::Integer(a + b),
        (Cell::Null, cell) => cell.clone(),
        (sum, Cell::Null) => sum,
        (sum, cell) => match (value(&sum), value(cell)) {
            (Some(a), Some(b)) => Cell::Number(a + b),
            _ => Cell::Null,
        },
    })
}

fn severity(cell: &Cell) -> Option<usize> {
    let Cell::Text(name) = cell else {
        return None;
    };
    EndState::ALL.iter().position(|state| state.name() == name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_one_bearing_lacks_counts_as_its_rule_says() {
        let cells = [Cell::Number(2.0), Cell::Null, Cell::Number(3.0)];
        let of = |across: Across| across.of(cells.iter());
        assert_eq!(of(Across::Largest), Cell::Number(3.0));
        assert_eq!(of(Across::LargestOfAll), Cell::Null);
        assert_eq!(of(Across::Smallest), Cell::Number(2.0));
        assert_eq!(of(Across::Sum), Cell::Number(5.0));
        let counts = [Cell::Integer(2), Cell::Integer(5)];
        assert_eq!(Across::Sum.of(counts.iter()), Cell::Integer(7));
        let none = [Cell::Null, Cell::Null];
        assert_eq!(Across::Largest.of(none.iter()), Cell::Null);
    }

    #[test]
    fn the_worst_state_is_a_backward_whirl() {
        let state = |name: &str| Cell::Text(name.to_owned());
        let cells = [
            state("bouncing"),
            state("backward-whirl"),
            state("pendulum"),
        ];
        assert_eq!(Across::WorstState.of(cells.iter()), state("backward-whirl"));
        assert_eq!(Across::WorstState.of(cells[..1].iter()), state("bouncing"));
    }
}
