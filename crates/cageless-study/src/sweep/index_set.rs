//! Sets of indices, and the shards of a sweep.

use std::collections::BTreeMap;
use std::fmt;
use std::ops::Range;

/// A set of indices, kept as disjoint ranges: compact as long as the indices are contiguous.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct IndexSet {
    /// Start and end of each.
    ranges: BTreeMap<u64, u64>,
}

impl IndexSet {
    /// Adds an index; says whether it is new.
    pub fn insert(&mut self, index: u64) -> bool {
        let before = self.ranges.range(..=index).next_back();
        let (mut start, mut end) = (index, index + 1);
        if let Some((&s, &e)) = before {
            if index < e {
                return false;
            }
            if e == index {
                start = s;
            }
        }
        if let Some(e) = self.ranges.remove(&end) {
            end = e;
        }
        self.ranges.insert(start, end);
        true
    }

    /// Number of indices.
    pub fn len(&self) -> u64 {
        self.ranges.iter().map(|(s, e)| e - s).sum()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.ranges.is_empty()
    }

    /// Part of `whole` that is not in the set, in order.
    pub fn missing(&self, whole: Range<u64>) -> Vec<Range<u64>> {
        let mut missing = Vec::new();
        let mut at = whole.start;
        for (&start, &end) in &self.ranges {
            if start >= whole.end {
                break;
            }
            if start > at {
                missing.push(at..start);
            }
            at = at.max(end);
        }
        if at < whole.end {
            missing.push(at..whole.end);
        }
        missing
    }
}

/// Indices in words: `3, 7 to 9`, cut off after a few.
pub(crate) fn listed(ranges: &[Range<u64>]) -> String {
    const SHOWN: usize = 8;
    let mut words: Vec<String> = ranges
        .iter()
        .take(SHOWN)
        .map(|r| match r.end - r.start {
            1 => r.start.to_string(),
            _ => format!("{} to {}", r.start, r.end - 1),
        })
        .collect();
    if ranges.len() > SHOWN {
        words.push(format!("and {} more ranges", ranges.len() - SHOWN));
    }
    words.join(", ")
}

/// Share `number` of `of`, counted from 1: a contiguous range of the variants.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shard {
    number: u64,
    of: u64,
}

impl Shard {
    /// `None` unless 1 ≤ number ≤ of.
    pub fn new(number: u64, of: u64) -> Option<Self> {
        (1..=of).contains(&number).then_some(Self { number, of })
    }

    /// Number of the shard, from 1.
    pub fn number(self) -> u64 {
        self.number
    }

    /// Number of all shards.
    pub fn total(self) -> u64 {
        self.of
    }

    /// Its variants.
    pub fn range(self, variants: u64) -> Range<u64> {
        let end = |k: u64| (u128::from(variants) * u128::from(k) / u128::from(self.of)) as u64;
        end(self.number - 1)..end(self.number)
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.number, self.of)
    }
}

impl std::str::FromStr for Shard {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let parts = text.split_once('/');
        parts
            .and_then(|(number, of)| Self::new(number.parse().ok()?, of.parse().ok()?))
            .ok_or_else(|| "it must be I/N with 1 ≤ I ≤ N, such as 1/8".to_owned())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_grow_together_and_know_what_is_missing() {
        let mut ranges = IndexSet::default();
        for index in [5, 3, 9, 4, 8, 0] {
            assert!(ranges.insert(index));
            assert!(!ranges.insert(index));
        }
        assert_eq!(ranges.len(), 6);
        assert_eq!(ranges.missing(0..11), [1..3, 6..8, 10..11]);
        assert_eq!(ranges.missing(3..6), []);
        assert_eq!(ranges.missing(4..11), [6..8, 10..11]);
        assert_eq!(listed(&ranges.missing(0..11)), "1 to 2, 6 to 7, 10");
    }

    #[test]
    fn shards_take_every_variant_once() {
        for (variants, of) in [(10, 3), (2, 5), (0, 1), (1_000_000_007, 64)] {
            let mut at = 0;
            for number in 1..=of {
                let range = Shard::new(number, of).expect("a shard").range(variants);
                assert_eq!(range.start, at);
                at = range.end;
            }
            assert_eq!(at, variants);
        }
        assert!("0/3".parse::<Shard>().is_err() && "4/3".parse::<Shard>().is_err());
        assert!("1".parse::<Shard>().is_err() && "a/b".parse::<Shard>().is_err());
        assert_eq!("2/3".parse::<Shard>().expect("a shard").to_string(), "2/3");
    }
}
