//! Room around the panels of a plot.

use serde_json::{Value, json};

/// Room between the panels of a plot and its edges, pixels.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Margin {
    /// Room to the left.
    pub left: u32,
    /// Room to the right.
    pub right: u32,
    /// Room above.
    pub top: u32,
    /// Room below.
    pub bottom: u32,
}

impl Default for Margin {
    fn default() -> Self {
        Self {
            left: 72,
            right: 24,
            top: 44,
            bottom: 58,
        }
    }
}

impl Margin {
    /// Usual room with `top` above, pixels.
    pub fn above(top: u32) -> Self {
        Self {
            top,
            ..Self::default()
        }
    }

    /// The key `margin` of a layout.
    pub(crate) fn json(self) -> Value {
        json!({ "l": self.left, "r": self.right, "t": self.top, "b": self.bottom })
    }
}
