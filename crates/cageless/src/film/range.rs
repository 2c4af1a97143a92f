//! Range of the fit of the rolling force.

use std::fmt::{self, Display, Formatter};

use super::contact::LubricatedContact;
use super::oil::Oil;
use super::rolling_force::{Rolling, speed_parameter};

/// U of the fit.
const SPEEDS: [f64; 2] = [6e-13, 1.6e-10];
/// κW of the fit.
const LOADS: [f64; 2] = [5e-10, 1.8e-5];
/// κ of the fit.
const AXES: [f64; 2] = [1.0 / 60.0, 1.0];
/// Thickness over R_x up to which Reynolds' equation holds.
const THICKNESS: f64 = 1e-3;

/// Parameter outside the range of the fit of the rolling force (Biboulet & Houpert).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RangeExceeded {
    /// U, κW, κ or h_c/R_x.
    pub parameter: &'static str,
    /// Value over the limit that it exceeds: above 1 beyond the upper, below 1 beyond the lower one.
    pub factor: f64,
}

impl LubricatedContact {
    /// The parameter furthest outside the range of the fit; `None` within, and without load or speed. Nothing is
    /// clamped to the range.
    pub(crate) fn range_exceeded(&self, oil: &Oil, rolling: Rolling) -> Option<RangeExceeded> {
        if !(rolling.load_n > 0.0) || rolling.speed_m_s == 0.0 {
            return None;
        }
        let speed = speed_parameter(self, oil, rolling.speed_m_s.abs());
        let load = self.axis_ratio * self.load_parameter(rolling.load_n);
        let film = self.film_thickness(oil, rolling).central_m / self.rolling_radius_m;
        let beyond = [
            ("U", speed, SPEEDS),
            ("κW", load, LOADS),
            ("κ", self.axis_ratio, AXES),
            ("h_c/R_x", film, [0.0, THICKNESS]),
        ];
        let beyond = beyond
            .into_iter()
            .filter_map(|(parameter, value, [least, most])| {
                let factor = match value {
                    _ if value > most => value / most,
                    _ if value < least => value / least,
                    _ => return None,
                };
                Some(RangeExceeded { parameter, factor })
            });
        beyond.max_by(|a, b| a.distance().total_cmp(&b.distance()))
    }
}

impl Display for RangeExceeded {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "{} × {}", self.parameter, self.factor_text())
    }
}

impl RangeExceeded {
    /// The factor to at least three digits.
    pub(crate) fn factor_text(&self) -> String {
        let decimals = (2.0 - self.factor.log10().floor()).max(3.0);
        format!("{:.1$}", self.factor, decimals as usize)
    }

    /// |ln factor|.
    pub(crate) fn distance(&self) -> f64 {
        self.factor.ln().abs()
    }
}
