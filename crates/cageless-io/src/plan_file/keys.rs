//! Keys of a plan itself. Those of its base, below its sections, are in [`super::key`].

use cageless_results::Computation;

use super::{Kept, SampleMethod, Scale};
use crate::case_file::declaration::prelude::*;

sections! {
    /// The keys of a plan.
    PlanSections, PLAN, "plan", HeadSection {
        set: BaseKeys, "changes to the case, for all variants", Heading::Absent;
        grid: BaseKeys, "axes of which every combination is a variant", Heading::Absent;
        samples: Option<SamplesSection>, "points in the space of further axes", Heading::Absent;
        scatter: Option<ScatterSection>, "random deviations", Heading::Absent;
    }
}

const CASE: &str =
    "the path of a case file or of a rotor file in quotes, or the case itself, [case]";

section! {
    /// The head of a plan.
    struct HeadSection {
        schema => schema: u64 = default(SCHEMA as i64), Plain, "version of the file format", Absent;
        title => title: String = default(""), Plain, "free text", Absent;
        seed => seed: u64 = default(0_i64), Plain; AtLeast(0.0), "seed of whatever is random", Absent;
        case => case: Base = Required, Plain, CASE, Absent;
        compute => compute: Vec<Computation> = Required, Plain, "a list of computations", Absent;
        keep => keep: Option<Vec<Kept>> = Optional, Plain, "columns besides the inputs", Absent;
    }
}

/// A section that has keys of the base alone.
#[derive(Debug)]
pub(crate) struct BaseKeys;

impl SectionKeys for BaseKeys {
    const KEYS: &'static [Key] = &[];

    fn read(_: &Reader<'_>) -> Result<Self, CaseError> {
        Ok(Self)
    }
}

section! {
    /// `[samples]`, besides its axes.
    struct SamplesSection {
        method => method: SampleMethod = Required, Plain, "how the points are chosen", Absent;
        count => count: u64 = Required, Plain; AtLeast(1.0), "the number of points", Absent;
    }
}

section! {
    /// `[scatter]`, besides its keys.
    struct ScatterSection {
        repeats => repeats: u64 = default(1_i64), Plain; AtLeast(1.0), "draws for each point", Absent;
    }
}

section! {
    /// A range of values of an axis.
    struct RangeKeys {
        from => from: f64 = Required, Plain, "first value", Absent;
        to => to: f64 = Required, Plain, "last value", Absent;
        scale => scale: Option<Scale> = Optional, Plain, "spacing of the values", Absent;
        count => count: Option<u64> = Optional, Plain; AtLeast(2.0), "number of values", Absent;
    }
}

/// Base of all variants: a path or a section, read by a reader of its own.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Base;

field!(Base, Kind::Text, |reader, name, node| match node.value {
    Value::Text(_) | Value::Section(_) => Ok(Self),
    _ => Err(reader.refuse(name, node, CASE)),
});

// In the order in which they are done, without repetition.
field!(Vec<Computation>, Computation::KIND, |reader, name, node| {
    let allowed = format!("a list of {}", Computation::choices());
    let mut list = reader.items(name, node, &allowed, Computation::of_node)?;
    if list.is_empty() {
        return Err(reader.refuse(name, node, &allowed));
    }
    list.sort_unstable();
    list.dedup();
    Ok(list)
});

field!(Vec<Kept>, Kind::Text, |reader, name, node| {
    let column = |item: &Node| match &item.value {
        Value::Text(name) => Some(Kept {
            name: name.clone(),
            line: item.line(),
        }),
        _ => None,
    };
    reader.items(name, node, "a list of columns in quotes", column)
});
