//! A value for each bearing of a drop.

use std::ops::Deref;
use std::slice;

use cageless::simulation::RotorDrop;
use serde::Serialize;

/// A value for each bearing of a drop. In files that of the only bearing of a case stands beside what
/// belongs to the drop, those below a linear rotor in a list.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Bearings<T> {
    /// That of the only bearing.
    Case(T),
    /// Those below a linear rotor.
    Rotor {
        /// Each bearing.
        bearings: Vec<T>,
    },
}

impl<T> Bearings<T> {
    /// The values of the bearings of a drop.
    ///
    /// # Panics
    /// If there is none.
    pub fn new(drop: &RotorDrop, values: impl IntoIterator<Item = T>) -> Self {
        let mut values = values.into_iter();
        match drop.rotor() {
            None => Self::Case(values.next().expect("a bearing")),
            Some(_) => Self::Rotor {
                bearings: values.collect(),
            },
        }
    }
}

impl<T> Deref for Bearings<T> {
    type Target = [T];

    fn deref(&self) -> &[T] {
        match self {
            Self::Case(value) => slice::from_ref(value),
            Self::Rotor { bearings } => bearings,
        }
    }
}
