//! Shards of a sweep.

use std::fmt;
use std::ops::Range;

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

    /// Indices of the variants of the shard, from 0, of `variants` in all.
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
