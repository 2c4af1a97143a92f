//! The criteria of a verdict, each with its value, its limit and the margin between them.

use super::raceway_verdict::RacewayVerdict;
use crate::contact::hertz::STRESS_LIMIT_PA;

/// A raceway slips when the critical gap falls this fraction short of β0 (Eq. (11)). In the
/// `paper` formulation those of the paper's ten structures that it calls slipping lose 9 %
/// and more, the others 3 % at most; the `physical` formulation, where balls slip earlier,
/// adds (f).
pub const SLIP_SHORTFALL: f64 = 0.05;
/// A raceway slips as well when the balls reach less of the theoretical drop of orbital speed
/// than this: they slide over it. A critical gap measured on sliding balls means nothing.
pub const SPEED_DROP_FRACTION: f64 = 0.8;
/// A raceway collides twice per passage when this fraction of the passages does. In the
/// `paper` formulation those of the paper's ten structures that it calls so lie well above,
/// the others well below; in `physical`, (c) falls below.
pub const DOUBLE_COLLISION_FRACTION: f64 = 0.25;
/// Share of its lag that a raceway must keep on elastic flanks, of the lag of rolling on rigid ones without a
/// contact angle: with less it hardly spaces the balls. Load, contact angle and sliding take the rest; β0 of
/// rigid flanks is out of reach there.
pub const LAG_MIN_FRACTION: f64 = 0.5;

/// Least critical gap over the steady-state gap: what spreads the balls.
pub const CRITICAL_GAP_MIN_FRACTION: f64 = 0.8;

/// One requirement on the motion of the balls, of verdict and search alike. Values, limits and margins are fractions
/// of 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Criterion {
    /// Largest Hertz pressure at rest over the 4200 MPa of ISO 76, at most 1.
    Pressure(f64),
    /// Largest Hertz pressure of a run, between balls as well, over the same, at most 1.
    PeakPressure(f64),
    /// Fraction of β0 by which sliding lowers the critical gap, at most [`SLIP_SHORTFALL`].
    Separation(f64),
    /// Critical gap over the steady-state gap: at most 1, beyond which evenly spaced balls collide, and at least what
    /// spreads them.
    SteadyGap {
        /// The fraction.
        value: f64,
        /// The least of it.
        least: f64,
    },
    /// Fraction of the kinematic deceleration that the balls reach, at least [`SPEED_DROP_FRACTION`].
    Deceleration(f64),
    /// Fraction of the passages in which both neighbours hit, at most [`DOUBLE_COLLISION_FRACTION`].
    BothNeighbours(f64),
    /// Share of its lag that a raceway keeps on elastic flanks, at least [`LAG_MIN_FRACTION`].
    Lag(f64),
}

impl Criterion {
    /// Name in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Pressure(_) => "pressure",
            Self::PeakPressure(_) => "peak-pressure",
            Self::SteadyGap { .. } => "steady-gap",
            Self::Separation(_) => "separation",
            Self::Deceleration(_) => "deceleration",
            Self::BothNeighbours(_) => "both-neighbours",
            Self::Lag(_) => "lag",
        }
    }

    /// Measured value.
    pub fn value(self) -> f64 {
        match self {
            Self::Pressure(value)
            | Self::PeakPressure(value)
            | Self::SteadyGap { value, .. }
            | Self::Separation(value)
            | Self::Deceleration(value)
            | Self::BothNeighbours(value)
            | Self::Lag(value) => value,
        }
    }

    /// A criterion of the same kind with this value.
    pub(super) fn with_value(self, value: f64) -> Self {
        match self {
            Self::Pressure(_) => Self::Pressure(value),
            Self::PeakPressure(_) => Self::PeakPressure(value),
            Self::SteadyGap { least, .. } => Self::SteadyGap { value, least },
            Self::Separation(_) => Self::Separation(value),
            Self::Deceleration(_) => Self::Deceleration(value),
            Self::BothNeighbours(_) => Self::BothNeighbours(value),
            Self::Lag(_) => Self::Lag(value),
        }
    }

    /// Limit of the value; of one with two the nearer.
    pub fn limit(self) -> f64 {
        match self {
            Self::Pressure(_) | Self::PeakPressure(_) => 1.0,
            Self::SteadyGap { least, .. } if self.at_least() => least,
            Self::SteadyGap { .. } => 1.0,
            Self::Separation(_) => SLIP_SHORTFALL,
            Self::Deceleration(_) => SPEED_DROP_FRACTION,
            Self::BothNeighbours(_) => DOUBLE_COLLISION_FRACTION,
            Self::Lag(_) => LAG_MIN_FRACTION,
        }
    }

    /// Whether the limit is the least value, else it is the largest.
    pub fn at_least(self) -> bool {
        match self {
            Self::Deceleration(_) | Self::Lag(_) => true,
            Self::SteadyGap { value, least } => value < 0.5 * (1.0 + least),
            _ => false,
        }
    }

    /// Distance of the value from its limit, negative beyond it.
    pub fn margin(self) -> f64 {
        match self.at_least() {
            true => self.value() - self.limit(),
            false => self.limit() - self.value(),
        }
    }

    /// Whether the limit is kept. A value that is not a number keeps none.
    pub fn is_met(self) -> bool {
        self.margin() >= 0.0
    }

    /// Whether the value is a number: without one nothing is judged.
    pub(crate) fn is_known(self) -> bool {
        !self.value().is_nan()
    }

    /// What sliding takes from the critical gap. On elastic flanks it is no criterion: spin on the flanks takes a
    /// part of it in every raceway, which a deeper one makes up for.
    pub(super) fn separation(elastic: bool, shortfall: f64) -> Option<Self> {
        (!elastic).then_some(Self::Separation(shortfall))
    }

    /// How far a raceway slows the balls: on elastic flanks by the lag that is left, on rigid ones by the
    /// deceleration that is reached.
    pub(super) fn slowing(elastic: bool, speed_drop_fraction: f64, lag_fraction: f64) -> Self {
        match elastic {
            true => Self::Lag(lag_fraction),
            false => Self::Deceleration(speed_drop_fraction),
        }
    }

    /// The verdict on a raceway that this criterion decides.
    pub fn verdict(self) -> RacewayVerdict {
        match self {
            _ if !self.is_known() => RacewayVerdict::NotJudged,
            _ if self.is_met() => RacewayVerdict::Smooth,
            Self::Pressure(_) | Self::PeakPressure(_) => RacewayVerdict::Overloaded,
            Self::SteadyGap { .. } if self.at_least() => RacewayVerdict::TooShallow,
            Self::SteadyGap { .. } => RacewayVerdict::TooDeep,
            Self::Separation(_) | Self::Deceleration(_) => RacewayVerdict::Slips,
            Self::BothNeighbours(_) => RacewayVerdict::DoubleCollision,
            Self::Lag(_) => RacewayVerdict::LosesLag,
        }
    }

    /// Margin over that of a raceway without load, sliding and collisions: 1 there, 0 at the limit. The
    /// load that makes a pressure grows as its cube.
    pub(crate) fn relative_margin(self) -> f64 {
        let ideal = match self {
            Self::Pressure(value) | Self::PeakPressure(value) => return 1.0 - value.powi(3),
            Self::SteadyGap { least, .. } => 0.5 * (1.0 - least),
            _ if self.at_least() => 1.0 - self.limit(),
            _ => self.limit(),
        };
        self.margin() / ideal
    }

    /// The criterion that decides: the first that fails, else the one nearest to its limit; `None` without any, and
    /// where one that is not known might fail.
    pub fn deciding(all: &[Self]) -> Option<Self> {
        let failed = all.iter().find(|c| c.is_known() && !c.is_met());
        let known = || all.iter().all(|c| c.is_known());
        let nearest = || {
            let all = all.iter();
            all.min_by(|a, b| a.relative_margin().total_cmp(&b.relative_margin()))
        };
        let deciding = failed.or_else(|| nearest().filter(|_| known()));
        deciding.copied()
    }

    /// The verdict of all criteria of a raceway.
    pub(super) fn verdict_of(all: &[Self]) -> RacewayVerdict {
        Self::deciding(all).map_or(RacewayVerdict::NotJudged, Self::verdict)
    }

    /// What is missing for a verdict, as a sentence: the first value that is not known.
    pub(super) fn missing(all: &[Self]) -> Option<String> {
        let unknown = all.iter().find(|c| !c.is_known())?;
        let what = match unknown {
            Self::Pressure(_) | Self::PeakPressure(_) => "the contact pressure",
            Self::Separation(_) | Self::SteadyGap { .. } => {
                "the critical gap or the steady-state gap"
            }
            Self::Deceleration(_) => "the deceleration in the raceway",
            Self::BothNeighbours(_) => "the fraction of double collisions",
            Self::Lag(_) => "the lag of a ball",
        };
        Some(format!("{what} is not known: no number came out"))
    }
}

/// Decimals that keep a value from being printed as equal to the limit that it misses: `least` at
/// least, six at most.
fn decimals(value: f64, limit: f64, least: usize) -> usize {
    let shown = |x: f64, digits: usize| format!("{x:.digits$}");
    (least..6)
        .find(|&digits| value == limit || shown(value, digits) != shown(limit, digits))
        .unwrap_or(6)
}

/// A fraction in per cent with as many decimals as tell it from its limit: `5.003 %`.
pub(crate) fn percent_beside(value: f64, limit: f64) -> String {
    let [value, limit] = [value, limit].map(|x| 100.0 * x);
    format!("{:.*} %", decimals(value, limit, 1), value)
}

impl std::fmt::Display for Criterion {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let (value, limit) = (self.value(), self.limit());
        let shown = percent_beside(value, limit);
        let bound = 100.0 * limit;
        match self {
            Self::Pressure(_) => return write_pressure(f, "at rest reaches", [value, limit]),
            Self::PeakPressure(_) => {
                return write_pressure(f, "of the motion reaches", [value, limit]);
            }
            Self::SteadyGap { least, .. } => write!(
                f,
                "the critical gap is {shown} of the steady-state gap ({:.0} to 100 % needed",
                100.0 * least
            ),
            Self::Separation(_) if value < 0.0 => write!(
                f,
                "sliding does not lower the critical gap (limit {bound:.0} % of β0"
            ),
            Self::Separation(_) => write!(
                f,
                "sliding lowers the critical gap by {shown} of β0 (limit {bound:.0} %"
            ),
            Self::Deceleration(_) => write!(
                f,
                "balls reach {shown} of the kinematic deceleration ({bound:.0} % needed"
            ),
            Self::BothNeighbours(_) => write!(
                f,
                "{shown} of the passages have a double collision (limit {bound:.0} %"
            ),
            Self::Lag(_) => write!(
                f,
                "balls keep {shown} of the lag of rolling on rigid flanks ({bound:.0} % needed"
            ),
        }?;
        let margin = percent_beside(self.margin().abs(), 0.0);
        let points = margin.trim_end_matches(" %");
        if self.is_met() {
            write!(f, ", margin {points} percentage points)")
        } else {
            write!(f, ", missed by {points} percentage points)")
        }
    }
}

/// Writes a pressure, its limit and the margin, all in MPa.
fn write_pressure(
    f: &mut std::fmt::Formatter<'_>,
    when: &str,
    fractions: [f64; 2],
) -> std::fmt::Result {
    let [value, limit] = fractions.map(|fraction| 1e-6 * STRESS_LIMIT_PA * fraction);
    let digits = decimals(value, limit, 0);
    let (word, margin) = match value <= limit {
        true => ("margin", limit - value),
        false => ("missed by", value - limit),
    };
    write!(
        f,
        "the contact pressure {when} {value:.digits$} MPa (limit {limit:.0} MPa of ISO 76, {word} \
         {margin:.digits$} MPa)"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_that_misses_its_limit_is_not_printed_as_the_limit() {
        assert_eq!(percent_beside(0.42, 0.25), "42.0 %");
        assert_eq!(percent_beside(0.050_03, 0.05), "5.003 %");
        assert_eq!(percent_beside(0.05, 0.05), "5.0 %");
        let text = Criterion::Separation(0.050_03).to_string();
        assert_eq!(
            text,
            "sliding lowers the critical gap by 5.003 % of β0 (limit 5 %, missed by 0.003 percentage points)"
        );
    }

    #[test]
    fn the_first_failure_decides_and_else_the_smallest_margin() {
        let good = [
            Criterion::Separation(0.01),
            Criterion::Deceleration(1.0),
            Criterion::BothNeighbours(0.23),
        ];
        assert_eq!(Criterion::deciding(&good), Some(good[2]));
        let bad = [
            Criterion::Separation(0.01),
            Criterion::Deceleration(0.5),
            Criterion::BothNeighbours(0.9),
        ];
        assert_eq!(Criterion::deciding(&bad), Some(bad[1]));
        // What is not known is neither kept nor missed, unless another is missed.
        let unknown = Criterion::Deceleration(f64::NAN);
        assert!(!unknown.is_met());
        assert_eq!(unknown.verdict(), RacewayVerdict::NotJudged);
        assert_eq!(Criterion::deciding(&[good[0], unknown]), None);
        assert_eq!(
            Criterion::verdict_of(&[good[0], unknown]),
            RacewayVerdict::NotJudged
        );
        assert_eq!(Criterion::deciding(&[unknown, bad[2]]), Some(bad[2]));
        let missing = Criterion::missing(&[good[0], unknown]).unwrap();
        assert!(missing.starts_with("the deceleration"), "{missing}");
        assert_eq!(Criterion::missing(&good), None);
        assert_eq!(Criterion::deciding(&[]), None);
        // A pressure by the load that is left, a third here; at the limit none.
        let pressed = [Criterion::BothNeighbours(0.15), Criterion::Pressure(0.874)];
        assert_eq!(Criterion::deciding(&pressed), Some(pressed[1]));
        assert!((pressed[1].relative_margin() - 0.332).abs() < 1e-3);
        assert_eq!(Criterion::Pressure(1.0).relative_margin(), 0.0);
        // By the fraction of the possible margin: 0.15 of 0.2, not 0.01 of 0.05.
        let close = [
            Criterion::Separation(0.04),
            Criterion::Deceleration(0.83),
            Criterion::BothNeighbours(0.20),
        ];
        assert_eq!(Criterion::deciding(&close), Some(close[1]));
    }

    #[test]
    fn a_pressure_is_in_megapascal() {
        let text = |value: f64| Criterion::Pressure(value).to_string();
        assert_eq!(
            text(0.5),
            "the contact pressure at rest reaches 2100 MPa (limit 4200 MPa of ISO 76, margin 2100 MPa)"
        );
        assert_eq!(
            text(1.5),
            "the contact pressure at rest reaches 6300 MPa (limit 4200 MPa of ISO 76, missed by 2100 MPa)"
        );
        assert!(
            text(1.0 + 1e-5).contains("4200.04 MPa"),
            "{}",
            text(1.0 + 1e-5)
        );
        assert!(text(f64::NAN).contains("NaN MPa"));
        for (value, met) in [(1.0, true), (1f64.next_up(), false), (f64::NAN, false)] {
            let pressure = Criterion::Pressure(value);
            assert_eq!((pressure.is_met(), pressure.at_least()), (met, false));
            let expected = match met {
                true => RacewayVerdict::Smooth,
                false if value.is_nan() => RacewayVerdict::NotJudged,
                false => RacewayVerdict::Overloaded,
            };
            assert_eq!(pressure.verdict(), expected);
        }
    }

    /// A critical gap has two ends: balls are spread by 80 % of the steady-state gap at least, and evenly spaced ones
    /// collide beyond all of it.
    #[test]
    fn a_critical_gap_has_both_ends() {
        let of = |value: f64| Criterion::SteadyGap { value, least: 0.8 };
        for (value, verdict) in [
            (0.8, RacewayVerdict::Smooth),
            (1.0, RacewayVerdict::Smooth),
            (0.8f64.next_down(), RacewayVerdict::TooShallow),
            (0.0, RacewayVerdict::TooShallow),
            (1f64.next_up(), RacewayVerdict::TooDeep),
            (5.53 / 2.66, RacewayVerdict::TooDeep),
        ] {
            assert_eq!(of(value).verdict(), verdict, "{value}");
        }
        assert_eq!(
            of(1.25).to_string(),
            "the critical gap is 125.0 % of the steady-state gap (80 to 100 % needed, missed by 25.0 percentage points)"
        );
        assert!((of(0.95).relative_margin() - 0.5).abs() < 1e-12);
        assert!((of(0.82).relative_margin() - 0.2).abs() < 1e-12);
    }

    /// At its limit a criterion is met, the next number beyond it is a failure; half way from the
    /// ideal value to the limit half of the margin is left.
    #[test]
    fn limits_are_met_up_to_themselves() {
        type Of = fn(f64) -> Criterion;
        let rows: [(Of, &str, f64, f64, RacewayVerdict, &str); 4] = [
            (
                Criterion::Separation,
                "separation",
                0.0,
                0.05,
                RacewayVerdict::Slips,
                "sliding lowers the critical gap by 6.0 % of β0 (limit 5 %, missed by 1.0 percentage points)",
            ),
            (
                Criterion::Deceleration,
                "deceleration",
                1.0,
                0.8,
                RacewayVerdict::Slips,
                "balls reach 76.0 % of the kinematic deceleration (80 % needed, missed by 4.0 \
                 percentage points)",
            ),
            (
                Criterion::BothNeighbours,
                "both-neighbours",
                0.0,
                0.25,
                RacewayVerdict::DoubleCollision,
                "30.0 % of the passages have a double collision (limit 25 %, missed by 5.0 \
                 percentage points)",
            ),
            (
                Criterion::Lag,
                "lag",
                1.0,
                0.5,
                RacewayVerdict::LosesLag,
                "balls keep 40.0 % of the lag of rolling on rigid flanks (50 % needed, missed by 10.0 \
                 percentage points)",
            ),
        ];
        for (of, name, ideal, limit, failure, text) in rows {
            let at = of(limit);
            assert_eq!((at.name(), at.value(), at.limit()), (name, limit, limit));
            assert_eq!(at.at_least(), ideal > limit);
            let beyond = |by: f64| limit + by * (limit - ideal);
            let next = if limit > ideal {
                limit.next_up()
            } else {
                limit.next_down()
            };
            assert!(at.is_met() && !of(next).is_met(), "{name}");
            assert_eq!(at.verdict(), RacewayVerdict::Smooth);
            assert_eq!(of(next).verdict(), failure);
            // Better than ideal is no failure: a critical gap above β0, say.
            assert!(of(beyond(-5.0)).is_met(), "{name}");
            for (value, margin) in [(ideal, 1.0), (beyond(-0.5), 0.5), (limit, 0.0)] {
                let found = of(value).relative_margin();
                assert!((found - margin).abs() < 1e-12, "{name} {value}: {found}");
                let found = of(value).margin();
                let expected = margin * (limit - ideal).abs();
                assert!((found - expected).abs() < 1e-12, "{name} {value}: {found}");
            }
            assert_eq!(of(beyond(0.2)).to_string(), text);
        }
        let text = Criterion::Separation(-0.2).to_string();
        assert!(
            text.starts_with("sliding does not lower the critical gap"),
            "{text}"
        );
        assert!(text.ends_with("margin 25.0 percentage points)"), "{text}");
    }
}
