//! The coordinates of a bearing: one table that names what the state vector holds.

pub use crate::world::body::RingCoordinate;

#[cfg(test)]
pub(crate) use crate::world::body::BodyCoordinate;
pub(crate) use crate::world::body::{OuterRingCoordinate, RotorCoordinate, SlidingCoordinate};

/// Kind of a coordinate, from which methods, norms and columns follow.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    /// A position or angle; its rate is another coordinate of the same table.
    Position,
    /// The rate of the position with this index in the same table.
    VelocityOf(usize),
    /// A rate whose integral is not a coordinate.
    Rate,
}

/// One coordinate of every ball, or of a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Coordinate {
    /// Name with its unit, as in the columns of the results.
    pub name: &'static str,
    /// Unit.
    pub unit: &'static str,
    /// Difference that is visible within one passage of a raceway: the scale of errors.
    pub error_scale: f64,
    /// Kind of the coordinate.
    pub(crate) kind: Kind,
}

pub(crate) const fn coordinate(
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
pub(crate) enum BallCoordinate {
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
    pub(crate) const ALL: [Self; BALL.len()] = [Self::X, Self::Y, Self::Vx, Self::Vy, Self::Spin];
    /// All in space, in the order of the state vector.
    #[cfg(test)]
    pub(crate) const IN_SPACE: [Self; BALL_IN_SPACE.len()] = [
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
pub(crate) const BALL: [Coordinate; 5] = [
    coordinate("x_m", "m", 1e-5, Kind::Position),
    coordinate("y_m", "m", 1e-5, Kind::Position),
    coordinate("vx_m_s", "m/s", 1.0, Kind::VelocityOf(0)),
    coordinate("vy_m_s", "m/s", 1.0, Kind::VelocityOf(1)),
    coordinate("rotation_rad_s", "rad/s", 200.0, Kind::Rate),
];

/// Coordinates of every ball in space; those of the plane come first.
pub(crate) const BALL_IN_SPACE: [Coordinate; 9] = [
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

/// A position and its rate, by their places among coordinates of one kind.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Pair {
    pub position: usize,
    pub rate: usize,
}

/// Positions of a table with their rates.
pub(crate) fn second_order_pairs(table: &[Coordinate]) -> impl Iterator<Item = Pair> {
    let pairs = table.iter().enumerate();
    pairs.filter_map(|(rate, coordinate)| match coordinate.kind {
        Kind::VelocityOf(position) => Some(Pair { position, rate }),
        Kind::Position | Kind::Rate => None,
    })
}

/// Positions one after the other whose rates are so as well.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Run {
    /// First position.
    pub position: usize,
    /// First rate.
    pub rate: usize,
    pub count: usize,
}

/// Runs of positions and of their rates.
pub(crate) fn runs(pairs: impl Iterator<Item = Pair>) -> Vec<Run> {
    let mut runs: Vec<Run> = vec![];
    for Pair { position, rate } in pairs {
        let follows =
            |run: &Run| run.position + run.count == position && run.rate + run.count == rate;
        match runs.last_mut().filter(|run| follows(run)) {
            Some(run) => run.count += 1,
            None => runs.push(Run {
                position,
                rate,
                count: 1,
            }),
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
    }

    #[test]
    fn positions_and_rates_form_runs() {
        let of = |table: &[Coordinate]| runs(second_order_pairs(table));
        let in_plane = Run {
            position: 0,
            rate: 2,
            count: 2,
        };
        let along_axis = Run {
            position: 5,
            rate: 6,
            count: 1,
        };
        assert_eq!(of(&BALL), [in_plane]);
        assert_eq!(of(&BALL_IN_SPACE), [in_plane, along_axis]);
    }
}
