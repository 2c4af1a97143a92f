//! Student's distribution, for means of a few runs.
//!
//! ```
//! use cageless::numerics::two_sided_limit;
//!
//! assert!((two_sided_limit(0.05, 4) - 2.776).abs() < 1e-3); // as in every table
//! ```

/// P(|T| > t) for Student's T with `freedoms` degrees of freedom (1 or more).
///
/// Abramowitz and Stegun, *Handbook of Mathematical Functions*, 26.7.3 and 26.7.4, with
/// tan θ = t/√ν.
pub(crate) fn two_sided_tail(t: f64, freedoms: usize) -> f64 {
    let angle = (t.abs() / (freedoms as f64).sqrt()).atan();
    let (sine, cosine) = angle.sin_cos();
    let odd = freedoms % 2 == 1;
    // Odd ν: cos θ + 2/3 cos³θ + … ; even ν: 1 + 1/2 cos²θ + …, up to the power ν − 2.
    let mut power = if odd { 1 } else { 0 };
    let mut term = if odd { cosine } else { 1.0 };
    let mut sum = 0.0;
    while power + 2 <= freedoms {
        sum += term;
        term *= cosine * cosine * (power + 1) as f64 / (power + 2) as f64;
        power += 2;
    }
    let within = if odd {
        std::f64::consts::FRAC_2_PI * (angle + sine * sum)
    } else {
        sine * sum
    };
    1.0 - within
}

/// t with P(|T| > t) = `probability`, to 1e-9.
pub fn two_sided_limit(probability: f64, freedoms: usize) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    while two_sided_tail(high, freedoms) > probability && high < 1e12 {
        low = high;
        high *= 2.0;
    }
    while high - low > 1e-9 * high {
        let middle = 0.5 * (low + high);
        if two_sided_tail(middle, freedoms) > probability {
            low = middle;
        } else {
            high = middle;
        }
    }
    high
}

#[cfg(test)]
mod tests {
    use super::two_sided_limit;

    /// Printed tables: t for 5 % and 1 % two-sided.
    #[test]
    fn limits_of_printed_tables() {
        for (probability, freedoms, limit) in [
            (0.05, 1, 12.706),
            (0.05, 2, 4.303),
            (0.05, 4, 2.776),
            (0.05, 8, 2.306),
            (0.01, 3, 5.841),
            (0.01, 7, 3.499),
            (0.01, 30, 2.750),
        ] {
            let got = two_sided_limit(probability, freedoms);
            assert!(
                (got - limit).abs() < 6e-4,
                "{probability} {freedoms}: {got}"
            );
        }
    }
}
