//! Results of steady operation.

use crate::declare::*;
use crate::quantity::Quantity;
use crate::source::Source::Steady;

/// Contacts and forces of steady operation, of each draw of balls.
#[rustfmt::skip]
pub const STEADY: &[Quantity] = &[
    means("that began, of all pairs of neighbours", low(quantity("contact_rate_hz", "Hz", "contacts between balls per second", Steady(|s| some(s.contact_rates_hz[0]))))),
    means("by the speed of approach", low(quantity("contact_rate_above_0_1_m_s_hz", "Hz", "  contacts above 0.1 m/s", Steady(|s| some(s.contact_rates_hz[1]))))),
    means("by the speed of approach", low(quantity("contact_rate_above_0_5_m_s_hz", "Hz", "  contacts above 0.5 m/s", Steady(|s| some(s.contact_rates_hz[2]))))),
    means("mean over time of the sum of the normal forces between balls", low(quantity("impulse_rate_n", "N", "impulse between balls per second", Steady(|s| some(s.impulse_rate_n))))),
    means("normal force times sliding distance in an hour; times a wear coefficient (mm³/(kN·m)) the volume that wears off by Archard", low(quantity("ball_wear_kn_m_h", "kN m/h", "wear between balls, F·s (Archard)", Steady(|s| some(s.wear_w * 3.6))))),
    means("Hertz pressure while a queue of balls spreads or closes", quantity("transient_ball_pressure_mpa", "MPa", "peak contact pressure, ball on ball, in the transient", Steady(|s| some(s.transient_pressure_pa * 1e-6)))),
    means("the part that turns with ball 1, at the orbital frequency of the balls", low(quantity("turning_force_n", "N", "force on the outer ring that turns with the balls", Steady(|s| some(s.turning_force_n))))),
    means("amplitude of the vertical force at N times the angle of ball 1", low(quantity("passing_force_n", "N", "force on the outer ring as balls pass", Steady(|s| some(s.passing_force_n))))),
];
