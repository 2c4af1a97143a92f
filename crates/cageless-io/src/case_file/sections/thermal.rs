//! `[thermal]`.

use crate::case_file::declaration::prelude::*;

section! {
    /// `[thermal]`: what the heat of a drop warms, and what happens between drops.
    impl cageless::touchdown::Thermal {
        outer_ring_mass_kg => outer_ring_mass_kg: Option<f64> = Optional, Si("kg"); Above(0.0),
            "mass of the outer ring; that of a ring 0.3 Dw thick behind its groove and 1.6 Dw wide unless given", Absent;
        ring_specific_heat_j_kg_k => ring_specific_heat_j_kg_k: Option<f64> = Optional, Si("J/(kg K)"); Above(0.0),
            "specific heat of the rings; 460, bearing steel, unless given; needed of rings of another material", Absent;
        ball_specific_heat_j_kg_k => ball_specific_heat_j_kg_k: Option<f64> = Optional, Si("J/(kg K)"); Above(0.0),
            "specific heat of the balls; 460, bearing steel, unless given; needed of balls of another material", Absent;
        pause_s => pause_s: f64 = default(0.0), Si("s"); AtLeast(0.0),
            "time from the standstill of the rotor to the next drop", Absent;
        cooling_time_s => cooling_time_s: Option<f64> = Optional, Si("s"); Above(0.0),
            "time constant with which the bearing cools in the pause towards its temperature before the first drop; without one it keeps all heat", Absent;
    }
}
