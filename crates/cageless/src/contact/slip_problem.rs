//! Equations of the friction of a ball at the end of a step, and their solution.

use crate::numerics::lanes::lane_struct;

lane_struct! {
    /// The implicit equations s = s_free − H·f(s) of one ball.
    pub(crate) struct SlipProblem per lane SlipProblemLanes {
        /// ΔVo at the end of the step without friction, m/s.
        outer_free,
        /// ΔVi at the end of the step without friction, m/s.
        inner_free,
        /// H of ΔVo to fo, m/(s·N).
        outer_outer,
        /// H of ΔVo to fi.
        outer_inner,
        /// H of ΔVi to fo.
        inner_outer,
        /// H of ΔVi to fi.
        inner_inner,
        /// Normal force that outer friction acts under, N.
        outer_normal,
        /// Normal force that inner friction acts under, N.
        inner_normal,
    }
}

lane_struct! {
    /// Sliding speeds of one ball and the friction that belongs to them.
    pub(crate) struct Slips per lane SlipsLanes {
        /// ΔVo, m/s.
        outer,
        /// ΔVi, m/s.
        inner,
        /// fo, N.
        outer_friction,
        /// fi, N.
        inner_friction,
        /// dfo/dΔVo at the last iterate, N·s/m; 0 under laws that stick.
        outer_slope,
        /// dfi/dΔVi there.
        inner_slope,
        /// 1 once the equations hold to the tolerance, else 0.
        converged,
    }
}
