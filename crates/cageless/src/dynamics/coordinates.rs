//! The coordinates of a bearing: one table that names what the state vector holds.
//!
//! ```
//! use cageless::dynamics::coordinates::{BALL, Kind};
//!
//! assert_eq!(BALL[2].name, "vx_m_s");
//! assert_eq!(BALL[2].kind, Kind::VelocityOf(0));
//! ```

/// What a coordinate is, so that methods, norms and columns can follow from the table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A position or angle; its rate is another coordinate of the same table.
    Position,
    /// The rate of the position with this index in the same table.
    VelocityOf(usize),
    /// A rate whose integral is not a coordinate.
    Rate,
}

/// One coordinate of every ball, or of a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coordinate {
    /// Name with its unit, as in the columns of the results.
    pub name: &'static str,
    /// Unit.
    pub unit: &'static str,
    /// Difference that is visible within one passage of a raceway: the scale of errors.
    pub error_scale: f64,
    /// What it is.
    pub kind: Kind,
}

const fn coordinate(
    name: &'static str,
    unit: &'static str,
    error_scale: f64,
    kind: Kind,
) -> Coordinate {
    Coordinate {
        name,
        unit,
        error_scale,
        kind,
    }
}

/// Index of a coordinate of the balls.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BallCoordinate {
    /// x of the centre.
    X,
    /// y of the centre.
    Y,
    /// ẋ of the centre.
    Vx,
    /// ẏ of the centre.
    Vy,
    /// Spin state of Zhao 2022, Eq. (13); in space −ωz.
    Spin,
    /// In space: z of the centre.
    Z,
    /// In space: ż of the centre.
    Vz,
    /// In space: ωx.
    OmegaX,
    /// In space: ωy.
    OmegaY,
}

impl BallCoordinate {
    /// All of a planar bearing, in the order of the state vector.
    pub const ALL: [Self; BALL.len()] = [Self::X, Self::Y, Self::Vx, Self::Vy, Self::Spin];
    /// All in space, in the order of the state vector.
    pub const IN_SPACE: [Self; BALL_IN_SPACE.len()] = [
        Self::X,
        Self::Y,
        Self::Vx,
        Self::Vy,
        Self::Spin,
        Self::Z,
        Self::Vz,
        Self::OmegaX,
        Self::OmegaY,
    ];
}

/// Coordinates of every ball.
pub const BALL: [Coordinate; 5] = [
    coordinate("x_m", "m", 1e-5, Kind::Position),
    coordinate("y_m", "m", 1e-5, Kind::Position),
    coordinate("vx_m_s", "m/s", 1.0, Kind::VelocityOf(0)),
    coordinate("vy_m_s", "m/s", 1.0, Kind::VelocityOf(1)),
    coordinate("rotation_rad_s", "rad/s", 200.0, Kind::Rate),
];

/// Coordinates of every ball in space; those of the plane come first.
pub const BALL_IN_SPACE: [Coordinate; 9] = [
    BALL[0],
    BALL[1],
    BALL[2],
    BALL[3],
    BALL[4],
    coordinate("z_m", "m", 1e-5, Kind::Position),
    coordinate("vz_m_s", "m/s", 1.0, Kind::VelocityOf(5)),
    coordinate("omega_x_rad_s", "rad/s", 200.0, Kind::Rate),
    coordinate("omega_y_rad_s", "rad/s", 200.0, Kind::Rate),
];

/// Index of a coordinate of the inner ring.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RingCoordinate {
    /// X of the centre.
    X,
    /// Y of the centre.
    Y,
    /// Ẋ of the centre.
    Vx,
    /// Ẏ of the centre.
    Vy,
    /// In space: Z of the centre.
    Z,
    /// In space: p, x of the axis **a** = (p, q, √(1 − p² − q²)): the tilt about Y.
    TiltP,
    /// In space: q, y of the axis: the tilt about −X.
    TiltQ,
    /// In space: Ż of the centre.
    Vz,
    /// In space: ṗ.
    TiltPRate,
    /// In space: q̇.
    TiltQRate,
}

impl RingCoordinate {
    /// All, in the order of the state vector.
    pub const ALL: [Self; RING.len()] = [Self::X, Self::Y, Self::Vx, Self::Vy];
}

/// Coordinates of the inner ring.
pub const RING: [Coordinate; 4] = [
    coordinate("ring_x_m", "m", 1e-5, Kind::Position),
    coordinate("ring_y_m", "m", 1e-5, Kind::Position),
    coordinate("ring_vx_m_s", "m/s", 0.1, Kind::VelocityOf(0)),
    coordinate("ring_vy_m_s", "m/s", 0.1, Kind::VelocityOf(1)),
];

/// Coordinates of the inner ring in space; those of the plane come first.
pub const RING_IN_SPACE: [Coordinate; 10] = [
    RING[0],
    RING[1],
    RING[2],
    RING[3],
    coordinate("ring_z_m", "m", 1e-5, Kind::Position),
    coordinate("tilt_p", "1", 1e-3, Kind::Position),
    coordinate("tilt_q", "1", 1e-3, Kind::Position),
    coordinate("ring_vz_m_s", "m/s", 0.1, Kind::VelocityOf(4)),
    coordinate("tilt_p_rate_per_s", "1/s", 10.0, Kind::VelocityOf(5)),
    coordinate("tilt_q_rate_per_s", "1/s", 10.0, Kind::VelocityOf(6)),
];

/// Index of a coordinate of the bodies under a falling rotor, in the plane; those of the inner ring
/// come first ([`RingCoordinate`]), more of them in space.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DropCoordinate {
    /// ωi of the inner ring, counter-clockwise.
    RingSpeed = RING.len() as isize,
    /// x of the outer ring, from its rest place.
    OuterX,
    /// y of the outer ring, from its rest place.
    OuterY,
    /// ẋ of the outer ring.
    OuterVx,
    /// ẏ of the outer ring.
    OuterVy,
    /// x of the rotor's mass centre.
    RotorX,
    /// y of the rotor's mass centre.
    RotorY,
    /// θ of the rotor.
    RotorAngle,
    /// ẋ of the rotor's mass centre.
    RotorVx,
    /// ẏ of the rotor's mass centre.
    RotorVy,
    /// Ω of the rotor, counter-clockwise.
    RotorSpeed,
    /// In space: z of the outer ring, from its rest place.
    OuterZ,
    /// In space: ż of the outer ring.
    OuterVz,
    /// In space: z of the rotor; where it is that of the inner ring, its shoulders are as far from either
    /// face.
    RotorZ,
    /// In space: ż of the rotor.
    RotorVz,
}

/// Index of a coordinate of an outer ring that slides in its housing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SlidingCoordinate {
    /// z of the ring, from where no preload displaces it.
    Z,
    /// ż of the ring.
    Vz,
}

/// Coordinates of each outer ring that slides in its housing, pushed by the preload spring of its row.
pub const SLIDING: [Coordinate; 2] = [
    coordinate("outer_ring_z_m", "m", 1e-5, Kind::Position),
    coordinate("outer_ring_vz_m_s", "m/s", 0.1, Kind::VelocityOf(0)),
];

/// Coordinates of the bodies under a falling rotor.
pub const DROP: [Coordinate; 15] = [
    RING[0],
    RING[1],
    RING[2],
    RING[3],
    coordinate("ring_speed_rad_s", "rad/s", 1.0, Kind::Rate),
    coordinate("housing_x_m", "m", 1e-5, Kind::Position),
    coordinate("housing_y_m", "m", 1e-5, Kind::Position),
    coordinate("housing_vx_m_s", "m/s", 0.1, Kind::VelocityOf(5)),
    coordinate("housing_vy_m_s", "m/s", 0.1, Kind::VelocityOf(6)),
    coordinate("rotor_x_m", "m", 1e-5, Kind::Position),
    coordinate("rotor_y_m", "m", 1e-5, Kind::Position),
    coordinate("rotor_angle_rad", "rad", 1e-3, Kind::Position),
    coordinate("rotor_vx_m_s", "m/s", 0.1, Kind::VelocityOf(9)),
    coordinate("rotor_vy_m_s", "m/s", 0.1, Kind::VelocityOf(10)),
    coordinate("rotor_speed_rad_s", "rad/s", 1.0, Kind::VelocityOf(11)),
];

/// Coordinates of the bodies under a falling rotor in space: the inner ring, the others in the order of
/// the plane, and what moves along the axis.
pub const DROP_IN_SPACE: [Coordinate; 25] = {
    let mut table = [RING_IN_SPACE[0]; 25];
    let (ring, shift) = (RING_IN_SPACE.len(), RING_IN_SPACE.len() - RING.len());
    let mut k = 0;
    while k < ring {
        table[k] = RING_IN_SPACE[k];
        k += 1;
    }
    while k < DROP.len() + shift {
        table[k] = DROP[k - shift];
        if let Kind::VelocityOf(position) = table[k].kind {
            table[k].kind = Kind::VelocityOf(position + shift);
        }
        k += 1;
    }
    table[k] = coordinate("housing_z_m", "m", 1e-5, Kind::Position);
    table[k + 1] = coordinate("housing_vz_m_s", "m/s", 0.1, Kind::VelocityOf(k));
    table[k + 2] = coordinate("rotor_z_m", "m", 1e-5, Kind::Position);
    table[k + 3] = coordinate("rotor_vz_m_s", "m/s", 0.1, Kind::VelocityOf(k + 2));
    table
};

/// A run of positions of a table and the run of their rates: first position, first rate, count.
pub(crate) fn second_order_runs(table: &[Coordinate]) -> Vec<[usize; 3]> {
    let mut runs: Vec<[usize; 3]> = vec![];
    for (rate, coordinate) in table.iter().enumerate() {
        let Kind::VelocityOf(position) = coordinate.kind else {
            continue;
        };
        match runs.last_mut() {
            Some([first, first_rate, count])
                if *first + *count == position && *first_rate + *count == rate =>
            {
                *count += 1;
            }
            _ => runs.push([position, rate, 1]),
        }
    }
    runs
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The enumerations index the tables.
    #[test]
    fn indices_follow_the_tables() {
        for (k, c) in BallCoordinate::ALL.into_iter().enumerate() {
            assert_eq!(c as usize, k);
        }
        for (k, c) in BallCoordinate::IN_SPACE.into_iter().enumerate() {
            assert_eq!(c as usize, k);
        }
        for (k, c) in RingCoordinate::ALL.into_iter().enumerate() {
            assert_eq!(c as usize, k);
        }
    }

    #[test]
    fn positions_and_rates_form_runs() {
        assert_eq!(second_order_runs(&BALL), [[0, 2, 2]]);
        assert_eq!(second_order_runs(&RING), [[0, 2, 2]]);
        assert_eq!(second_order_runs(&BALL_IN_SPACE), [[0, 2, 2], [5, 6, 1]]);
        assert_eq!(second_order_runs(&RING_IN_SPACE), [[0, 2, 2], [4, 7, 3]]);
        assert_eq!(second_order_runs(&DROP), [[0, 2, 2], [5, 7, 2], [9, 12, 3]]);
        assert_eq!(DROP[DropCoordinate::RotorSpeed as usize].unit, "rad/s");
        assert_eq!(DropCoordinate::RotorSpeed as usize + 1, DROP.len());
        let runs = second_order_runs(&DROP_IN_SPACE);
        let of_ring = [[0, 2, 2], [4, 7, 3]];
        let of_others = [[11, 13, 2], [15, 18, 3], [21, 22, 1], [23, 24, 1]];
        assert_eq!(runs, [&of_ring[..], &of_others].concat());
        let last = DropCoordinate::RotorVz as usize + RING_IN_SPACE.len() - RING.len();
        assert_eq!(DROP_IN_SPACE[last].name, "rotor_vz_m_s");
        assert_eq!(last + 1, DROP_IN_SPACE.len());
    }
}
