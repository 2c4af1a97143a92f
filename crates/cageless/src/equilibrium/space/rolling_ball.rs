//! A ball that rolls between the rings.

/// Ball where its forces seat it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RollingBall {
    /// ψ, rad.
    pub angle_rad: f64,
    /// |rb|, m.
    pub distance_m: f64,
    /// vt of pure rolling on both raceways, m/s.
    pub speed_m_s: f64,
    /// Arm of its rotation at the outer raceway over its radius.
    pub outer_arm: f64,
    /// Approach to the inner raceway, m; 0 or below: the gap.
    pub inner_depth_m: f64,
}
