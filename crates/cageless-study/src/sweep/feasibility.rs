//! Whether a plan has any possible variant, found out before anything is computed.

use rayon::prelude::*;

use super::variants::Variants;
use crate::StudyError;
use crate::threads::each_of;

/// Variants that are tried at most, spread over the plan.
const PROBES: u64 = 20_000;

/// Refuses a plan none of whose variants is a possible case.
pub(crate) fn some_are_possible(variants: &Variants) -> Result<(), StudyError> {
    let count = variants.count;
    let probes = count.min(PROBES);
    let index = |k: u64| (u128::from(k) * u128::from(count) / u128::from(probes)) as u64;
    let possible = |k: u64| variants.variant(index(k)).1.is_ok();
    // One of the first few, as a rule.
    if (0..probes.min(4)).any(possible) || each_of(0..probes).any(possible) {
        return Ok(());
    }
    match variants.variant(0).1 {
        Ok(_) => Ok(()),
        Err(first) => Err(StudyError::Input(format!(
            "{}{} variants is a possible case. The first: {first}",
            match variants.plan.name.as_str() {
                "" => String::new(),
                name => format!("{name}: "),
            },
            match probes {
                probes if probes == count => format!("none of the {count}"),
                probes => format!("none of {probes} variants spread over the {count}"),
            }
        ))),
    }
}
