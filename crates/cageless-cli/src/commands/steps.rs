//! Steps of a run or drop.

use cageless::Case;
use cageless_results::number_text::significant;

/// Number and size of the steps of a run or drop.
pub fn steps_text(case: &Case) -> String {
    let solver = &case.solver;
    let steps = significant((solver.duration_s / solver.step_s).ceil(), 3);
    format!("{steps} of {} µs", significant(1e6 * solver.step_s, 4))
}

/// Number of steps above which `check` warns: hours of computing.
const MANY_STEPS: f64 = 1e9;

/// Warnings about what a case, or the bearings of a rotor, will come to.
pub fn check_warnings<'c>(cases: impl IntoIterator<Item = &'c Case>) -> Vec<String> {
    let mut warnings = vec![];
    for case in cases {
        warnings.extend(case.bearing.fall_warning());
        if case.solver.duration_s > MANY_STEPS * case.solver.step_s {
            warnings.push(format!(
                "the run takes {}, hours of computing: shorten it (solver.duration_s), or \
                 change what makes the step small (contact.damping_n_s_m1_5, \
                 bearing.inner_ring_damping_n_s_m, stiff contacts of light bodies)",
                steps_text(case).replacen(" of", " steps of", 1)
            ));
        }
    }
    warnings.dedup();
    warnings
}
