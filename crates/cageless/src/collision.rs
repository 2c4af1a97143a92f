//! Contacts between neighbouring balls.

/// One contact of two neighbouring balls, from touch to parting.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Collision {
    /// When they touched.
    pub start_s: f64,
    /// How long they stayed in contact.
    pub duration_s: f64,
    /// Index (from 0) of the ball behind; the ball ahead is its neighbour.
    pub ball: usize,
    /// Index (from 0) of the ball ahead.
    pub next_ball: usize,
    /// ψ halfway between the two at first touch, wrapped to (−π, π].
    pub angle_rad: f64,
    /// Speed at which the surfaces approached along the line of centres at first touch.
    pub approach_speed_m_s: f64,
    /// Largest normal force.
    pub peak_force_n: f64,
    /// ∫ normal force dt.
    pub impulse_n_s: f64,
}
