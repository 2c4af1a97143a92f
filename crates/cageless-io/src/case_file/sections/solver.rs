//! `[solver]`.

use cageless::IntegrationMethod;
use cageless_design::search::SEED;

use crate::case_file::declaration::prelude::*;
use crate::case_file::fields::Step;

section! {
    /// `[solver]`: integration. The error per step is a hundredth of what a figure shows.
    struct SolverSection {
        method => method: IntegrationMethod = default(IntegrationMethod::VelocityVerlet.name()), Plain,
            "integration method",
            Commented("\"verlet\"", "\"abm4\": the paper's; \"adaptive\": for references");
        step_us => step_s: Step = default("auto"), Microsecond; Above(0.0),
            "step of the integration, from the stiffest contact unless it is a number",
            Commented("\"auto\"", "from the stiffest contact, or a number");
        tolerance => tolerance: f64 = default(1e-8), Plain; Above(0.0),
            "error per step of the adaptive method",
            Commented("1.0e-8", "error per step, only for \"adaptive\"");
        duration_s => duration_s: f64 = default(0.5), Si("s"); Above(0.0),
            "simulated time", Shown("0.5", "simulated time");
        transient_s => transient_s: Option<f64> = Optional, Si("s"); AtLeast(0.0),
            "time at the start that results leave out; two orbits of the balls, at most half, unless given",
            Absent;
        seed => seed: u64 = default(SEED as i64), Plain,
            "seed of random starts (run --verify, design --search) and samples (tolerance, drop)",
            Commented("0", "of the random starts and samples of run --verify,\n\
                design --search and tolerance");
    }
}
