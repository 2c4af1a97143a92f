//! Reasons for which there is no equilibrium.

use crate::bearing::BeyondGroove;
use crate::error::{InputError, degrees};

/// Why a case has no static equilibrium, or none was found.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum EquilibriumError {
    /// The case itself is wrong.
    #[error(transparent)]
    Input(#[from] InputError),
    /// The balls at their angles leave a gap through which the ring falls.
    #[error(
        "no static equilibrium exists: the balls at their starting angles leave a gap through \
         which the loaded ring falls; spread them (start.gaps)"
    )]
    Unsupported,
    /// Balls of a settled start overlap where the rings seat them.
    #[error(
        "the balls cannot start settled: between the rings ball {} and the ball ahead of it would \
         overlap by {:.1} µm; give them a gap of at least {:.4}° (start.gaps), or begin with \
         start.state = \"rolling\"",
        ball + 1, overlap_m * 1e6, 1e-4 * (1e4 * degrees(*gap_rad)).ceil()
    )]
    BallsOverlap {
        /// The ball, from 0.
        ball: usize,
        /// Depth of the overlap.
        overlap_m: f64,
        /// Gap at which they touch.
        gap_rad: f64,
    },
    /// A contact that left its groove over the shoulder.
    #[error(
        "the load presses {}; reduce axial load, moments or tilt, or raise the shoulder",
        BeyondGroove { ball: *ball, ring: *ring, angle_rad: *angle_rad, shoulder_rad: *shoulder_rad }
    )]
    BeyondGroove {
        /// The ball, from 0, through all rows.
        ball: usize,
        /// The ring: 0 for the inner, 1 for the outer one.
        ring: usize,
        /// Contact angle of the ball.
        angle_rad: f64,
        /// Contact angle at which the groove ends.
        shoulder_rad: f64,
    },
    /// No convergence.
    #[error(
        "no static equilibrium found: where its search ended, contacts and loads differ by {residual_n:.3e} N; \
         the bearing may carry no such load: reduce loads, moments and preload, or see whether the contact \
         angles of its rows face the axial load"
    )]
    NotConverged {
        /// Force left on the ring.
        residual_n: f64,
    },
    /// The caller ended the search.
    #[error("interrupted")]
    Interrupted,
}

impl From<BeyondGroove> for EquilibriumError {
    fn from(beyond: BeyondGroove) -> Self {
        Self::BeyondGroove {
            ball: beyond.ball,
            ring: beyond.ring,
            angle_rad: beyond.angle_rad,
            shoulder_rad: beyond.shoulder_rad,
        }
    }
}
