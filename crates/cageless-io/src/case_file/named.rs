//! Choices that a case file or a plan makes by name.

use cageless::film::{OilGrade, Traction};
use cageless::touchdown::LimitSide;
use cageless::{
    Assembly, BearingClass, FlankModel, Formulation, FrictionModel, IntegrationMethod, Lubricant,
    Motion, RacewayShape, Regularisation, Shaft, SkfSeries, steady::SteadyStart,
};
use cageless_results::Computation;

use super::spanned_toml::{Node, Value};

/// A choice with a name for each value. A new value needs one more line here.
pub(crate) trait Named: Copy + PartialEq + 'static {
    /// Every name with its value.
    const NAMES: &'static [(&'static str, Self)];

    /// The value of a name.
    fn from_name(name: &str) -> Option<Self> {
        Self::NAMES
            .iter()
            .find(|(n, _)| *n == name)
            .map(|&(_, value)| value)
    }

    /// The value that a text names, or a whole number by its digits.
    fn of_node(node: &Node) -> Option<Self> {
        match &node.value {
            Value::Text(text) => Self::from_name(text),
            Value::Integer(digits) => Self::from_name(&digits.to_string()),
            _ => None,
        }
    }

    /// `"one" or "other"`, for messages.
    fn choices() -> String {
        let names: Vec<_> = Self::NAMES.iter().map(|(name, _)| *name).collect();
        quoted(&names)
    }
}

/// Choices of an enum that lists its names.
macro_rules! named {
    ($($Name:ty),*) => {
        $(impl $crate::case_file::named::Named for $Name {
            const NAMES: &'static [(&'static str, Self)] = Self::NAMES;
        })*
    };
}
pub(crate) use named;

/// `"one" or "other"`.
pub(super) fn quoted(names: &[&str]) -> String {
    let quoted: Vec<_> = names.iter().map(|name| format!("\"{name}\"")).collect();
    match quoted.split_last() {
        Some((last, rest)) if !rest.is_empty() => format!("{} or {last}", rest.join(", ")),
        _ => quoted.concat(),
    }
}

cageless::named_enum! {
    /// Kind of initial state; [`cageless::StartState`] has the details.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub(crate) enum StartKind {
        /// Static equilibrium at speed.
        Settled = "settled",
        /// Pure rolling, ring where put.
        Rolling = "rolling",
        /// Everything at rest in the middle.
        AtRest = "at-rest",
    }
}

cageless::named_enum! {
    /// Shapes that a search tries.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub(crate) enum SearchedShapes {
        /// Shape of the case alone.
        Own = "own",
        /// Every shape that needs no profile, and that of the case.
        All = "all",
    }
}

/// Switches.
impl Named for bool {
    const NAMES: &'static [(&'static str, Self)] = &[("no", false), ("yes", true)];
}

named!(
    Assembly,
    BearingClass,
    Computation,
    FlankModel,
    FrictionModel,
    IntegrationMethod,
    LimitSide,
    Lubricant,
    Motion,
    Formulation,
    OilGrade,
    RacewayShape,
    Regularisation,
    SearchedShapes,
    Shaft,
    SkfSeries,
    StartKind,
    SteadyStart,
    Traction
);
