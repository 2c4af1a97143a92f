//! Possible values of the keys of a case, found by trying.

use cageless::simulation::Control;
use cageless_io::case_file::{CaseDocument, CaseValue, Change};
use serde::Deserialize;
use serde_json::{Value, json};

use crate::refusal::Refusal;

/// A control: a name, the values that it offers, and the keys that follow it linearly.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Span {
    name: String,
    low: f64,
    high: f64,
    /// Whole numbers only.
    #[serde(default)]
    whole: bool,
    keys: Vec<Follower>,
}

/// A key with its values at the low and the high end of the control.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Follower {
    key: String,
    low: f64,
    high: f64,
}

impl Span {
    /// The span of a single key.
    ///
    /// # Errors
    /// `low` is not below `high`.
    pub(crate) fn of_key(key: &str, low: f64, high: f64) -> Result<Self, Refusal> {
        let follower = Follower {
            key: key.to_owned(),
            low,
            high,
        };
        let span = Self {
            name: key.to_owned(),
            low,
            high,
            whole: false,
            keys: vec![follower],
        };
        span.check()?;
        Ok(span)
    }

    fn check(&self) -> Result<(), Refusal> {
        if !(self.low < self.high && (self.high - self.low).is_finite()) {
            let message = format!("{}: the span needs low < high", self.name);
            return Err(Refusal::new(message));
        }
        Ok(())
    }
}

/// Values that are tried over a span before the ends of the possible ranges are refined.
const TRIED: usize = 25;
/// Halvings of the interval between two tried values.
const HALVINGS: usize = 8;
/// Controls of one request, and keys of one control, at most.
const CONTROLS_MAX: usize = 32;

/// The ranges `[low, high]` of each control within which the case as a whole is possible, every other
/// value as it is. A range narrower than the distance of two tried values may be missed.
pub(crate) fn ranges(
    case: &str,
    spans: &[Span],
    control: &mut dyn FnMut(f64) -> Control,
) -> Result<Value, Refusal> {
    if spans.len() > CONTROLS_MAX || spans.iter().any(|s| s.keys.len() > CONTROLS_MAX) {
        let message = format!("at most {CONTROLS_MAX} controls and keys of each are allowed");
        return Err(Refusal::new(message));
    }
    let base = CaseDocument::parse(case, "case")?;
    let mut found = serde_json::Map::new();
    for (k, span) in spans.iter().enumerate() {
        if control(k as f64 / spans.len() as f64).is_break() {
            return Err(Refusal::new("cancelled"));
        }
        span.check()?;
        found.insert(span.name.clone(), json!(possible(&base, span)));
    }
    Ok(Value::Object(found))
}

/// The ranges `[low, high]` of one control within which the case as a whole is possible.
pub(crate) fn possible(base: &CaseDocument, span: &Span) -> Vec<[f64; 2]> {
    let allowed = |value: f64| {
        let part = (value - span.low) / (span.high - span.low);
        let values: Vec<CaseValue> = span
            .keys
            .iter()
            .map(|k| match k.low + part * (k.high - k.low) {
                whole if span.whole => CaseValue::Integer(whole.round() as i64),
                number => CaseValue::Number(number),
            })
            .collect();
        let changes: Vec<Change<'_>> = (span.keys.iter().zip(&values))
            .map(|(k, value)| Change::new(&k.key, value, ("case", 1)))
            .collect();
        base.with(&changes).is_ok()
    };
    let tried: Vec<f64> = if span.whole {
        let count = (span.high - span.low).min(1000.0) as usize;
        let values = (0..=count).map(|k| span.low.round() + k as f64);
        values.take_while(|&v| v <= span.high).collect()
    } else {
        let at = |k: usize| span.low + (span.high - span.low) * k as f64 / (TRIED - 1) as f64;
        (0..TRIED).map(at).collect()
    };
    let tried: Vec<(f64, bool)> = tried.into_iter().map(|v| (v, allowed(v))).collect();
    // The end of a range between a possible and an impossible value.
    let edge = |mut good: f64, mut bad: f64| {
        if !span.whole {
            for _ in 0..HALVINGS {
                let middle = 0.5 * (good + bad);
                if allowed(middle) {
                    good = middle;
                } else {
                    bad = middle;
                }
            }
        }
        good
    };
    let mut ranges: Vec<[f64; 2]> = vec![];
    let mut before = None;
    for stretch in tried.chunk_by(|a, b| a.1 == b.1) {
        let ((first, good), (last, _)) = (stretch[0], stretch[stretch.len() - 1]);
        if good {
            ranges.push([before.map_or(first, |bad| edge(first, bad)), last]);
        } else if let Some(range) = ranges.last_mut() {
            range[1] = edge(range[1], first);
        }
        before = Some(last);
    }
    ranges
}
