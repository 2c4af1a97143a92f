//! Load zone of a bearing, and the transition to it of Section 4.3.

use std::f64::consts::{PI, TAU};

use cageless::collision::Collision;
use cageless::equilibrium::solve;
use cageless::numerics::wrap_angle_rad;
use cageless::{Case, Gaps, Start, StartState};
use cageless_study::StudyError;

/// Names of the parts of |ψ| that the transition of Section 4.3, which the paper does not bound,
/// may be, as in [`transition_rad`].
pub const TRANSITIONS: [&str; 3] = [
    "at 60° < |ψ| < 150°",
    "within 30° of the ends of the load zone",
    "within 15° of the ends of the load zone",
];

/// Bounds of |ψ| of the parts named in [`TRANSITIONS`].
fn transition_rad(load_zone_rad: f64) -> [[f64; 2]; 3] {
    let around = |window: f64| [load_zone_rad - window, load_zone_rad + window];
    [
        [PI / 3.0, PI / 1.2],
        around(30f64.to_radians()),
        around(15f64.to_radians()),
    ]
}

/// Share of `contacts` in each of the parts, and of contacts spread evenly.
pub fn transition_shares(contacts: &[Collision], load_zone_rad: f64) -> [[f64; 2]; 3] {
    transition_rad(load_zone_rad).map(|[from, to]| {
        let inside = |c: &&Collision| (from..to).contains(&c.angle_rad.abs());
        let count = contacts.iter().filter(inside).count();
        [count as f64 / contacts.len() as f64, (to - from) / PI]
    })
}

/// Arrangements of balls in which the end of the load zone is found.
const ARRANGEMENTS: u32 = 16;

/// Largest |ψ| at which an evenly spaced ball in static equilibrium carries load at the inner
/// raceway, to the distance of the angles that [`ARRANGEMENTS`] turned balls take up.
pub fn load_zone_rad(case: &Case) -> Result<f64, StudyError> {
    let spacing = TAU / case.bearing.balls() as f64;
    let mut end = 0.0;
    for turned in 0..ARRANGEMENTS {
        let mut case = case.clone();
        case.start = Start::new(
            StartState::Settled,
            Gaps::Uniform,
            spacing * f64::from(turned) / f64::from(ARRANGEMENTS),
        );
        let found = solve(&case)?;
        let balls = found.ball_angle_rad.iter().zip(&found.inner_force_n);
        let loaded = balls.filter(|(_, force_n)| **force_n > 0.0);
        end = loaded.fold(end, |end, (angle, _)| {
            f64::max(end, wrap_angle_rad(*angle).abs())
        });
    }
    Ok(end)
}
