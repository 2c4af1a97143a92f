//! Bearings that deviate from their drawing and operate beside their design point.

use cageless::BallGrade;
use cageless::Case;
use cageless::InputError;
use cageless::film::FLOODED;
use cageless::numerics::RandomStream;
use cageless::raceway::{Raceway, RacewayDimensions};

cageless::named_enum! {
    /// Something that is not what the drawing says.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum Influence {
        /// Depth of the raceways.
        GrooveDepth = "groove depth",
        /// lC.
        AxialSpan = "axial span",
        /// θ.
        HalfAngle = "half angle",
        /// Radii of the balls within their lot.
        BallRadius = "ball radii",
        /// μ.
        Friction = "friction coefficient",
        /// Radial internal clearance Gr.
        Clearance = "radial internal clearance",
        /// Speed of the inner ring.
        Speed = "speed",
        /// Radial load, and the axial load with it.
        Load = "load",
        /// αg by which the sections of the raceways are turned, in space.
        SectionAngle = "contact angle of the raceway",
        /// Viscosity of the oil of a film.
        Viscosity = "oil viscosity",
        /// Supply of a film.
        Supply = "oil supply",
    }
}

/// Tolerance of each influence, ±.
#[derive(Debug, Clone, PartialEq)]
pub struct Tolerances {
    /// Depth at the centre of a raceway, along the normal.
    pub groove_depth_m: f64,
    /// Axial span lC.
    pub axial_span_m: f64,
    /// Half angle θ.
    pub half_angle_rad: f64,
    /// Angle by which the sections of the raceways are turned; 0 in the plane.
    pub section_angle_rad: f64,
    /// Lot that the balls come from; `None`: all equal.
    pub ball_grade: Option<BallGrade>,
    /// Friction coefficient μ.
    pub friction: f64,
    /// Radial internal clearance Gr, down to the largest interference.
    pub clearance_m: f64,
    /// Speed, as a fraction.
    pub speed_fraction: f64,
    /// Load, as a fraction.
    pub load_fraction: f64,
    /// Viscosity of the oil of a film, as a fraction.
    pub viscosity_fraction: f64,
    /// Factor of the supply of a film to either side, 1 or more; a supply above 1 floods no more.
    pub supply_factor: f64,
}

impl Default for Tolerances {
    /// No tolerance.
    fn default() -> Self {
        Self {
            groove_depth_m: 0.0,
            axial_span_m: 0.0,
            half_angle_rad: 0.0,
            section_angle_rad: 0.0,
            ball_grade: None,
            friction: 0.0,
            clearance_m: 0.0,
            speed_fraction: 0.0,
            load_fraction: 0.0,
            viscosity_fraction: 0.0,
            supply_factor: 1.0,
        }
    }
}

impl Tolerances {
    /// Lowest and highest deviation of `influence` in a case; of the balls' radii that of one
    /// ball.
    pub fn range(&self, case: &Case, influence: Influence) -> [f64; 2] {
        let both = |t: f64| [-t, t];
        match influence {
            Influence::GrooveDepth => both(self.groove_depth_m),
            Influence::AxialSpan => both(self.axial_span_m),
            Influence::HalfAngle => both(self.half_angle_rad),
            Influence::SectionAngle => both(self.section_angle_rad),
            Influence::BallRadius => both(self.ball_grade.map_or(0.0, |g| g.radius_deviation_m())),
            Influence::Friction => both(self.friction),
            Influence::Clearance => {
                let bearing = &case.bearing;
                let most = bearing.dimensions().interference_max_m(bearing.materials());
                let down = self
                    .clearance_m
                    .min(bearing.radial_internal_clearance_m() + 2.0 * most);
                [-down, self.clearance_m]
            }
            Influence::Speed => both(self.speed_fraction * case.operation.inner_speed_rad_s),
            Influence::Load => both(self.load_fraction * case.operation.radial_load_n),
            Influence::Viscosity => both(case.film.map_or(0.0, |film| {
                self.viscosity_fraction * film.oil.viscosity_pa_s
            })),
            Influence::Supply => case.film.map_or([0.0; 2], |film| {
                let ends = [
                    film.supply / self.supply_factor,
                    film.supply * self.supply_factor,
                ];
                ends.map(|end| end.min(FLOODED) - film.supply)
            }),
        }
    }
}

/// One bearing's deviations from the case.
#[derive(Debug, Clone, PartialEq)]
pub struct Deviation {
    /// Deviations of all influences except the balls, in the order of [`Influence::ALL`], SI units.
    values: [f64; Influence::ALL.len()],
    /// Deviations of the ball radii; empty: none.
    ball_radius_m: Vec<f64>,
}

impl Deviation {
    fn none() -> Self {
        Self {
            values: [0.0; Influence::ALL.len()],
            ball_radius_m: vec![],
        }
    }

    fn one(influence: Influence, value: f64) -> Self {
        let mut deviation = Self::none();
        deviation.values[influence as usize] = value;
        deviation
    }

    /// Value of one influence, SI units; of the balls' radii 0.
    pub(crate) fn value(&self, influence: Influence) -> f64 {
        self.values[influence as usize]
    }

    /// Deviations of the balls' radii; empty if all are nominal.
    #[cfg(test)]
    pub(crate) fn ball_radius_m(&self) -> &[f64] {
        &self.ball_radius_m
    }

    /// The case of this bearing.
    ///
    /// # Errors
    /// The bearing is impossible, say because the raceway violates Zhao 2022, Eq. (8) or (9).
    pub fn apply(&self, case: &Case) -> Result<Case, InputError> {
        case.check_constant_operation("a tolerance study")?;
        let of = |influence: Influence| self.value(influence);
        let mut radii = case.bearing.ball_radius_deviations_m().to_vec();
        if radii.is_empty() {
            radii.clone_from(&self.ball_radius_m);
        } else {
            for (radius, more) in radii.iter_mut().zip(&self.ball_radius_m) {
                *radius += more;
            }
        }
        let bearing = (case.bearing)
            .with_clearance_deviation(of(Influence::Clearance))?
            .with_ball_radius_deviations(radii)?;
        let raceways = case
            .raceways
            .iter()
            .map(|raceway| {
                let designed = *raceway.dimensions();
                let dimensions = RacewayDimensions {
                    axial_span_m: designed.axial_span_m + of(Influence::AxialSpan),
                    half_angle_rad: designed.half_angle_rad + of(Influence::HalfAngle),
                    ..designed
                };
                let turned = raceway.section_angle_rad() + of(Influence::SectionAngle);
                Raceway::formed(dimensions, raceway.form(), &bearing)?
                    .with_depth_error(raceway.depth_error_m() + of(Influence::GrooveDepth))?
                    .with_section_angle(turned, &bearing)
            })
            .collect::<Result<_, _>>()?;
        let mut varied = Case {
            bearing,
            raceways,
            ..case.clone()
        };
        varied.contact.shift_friction(of(Influence::Friction));
        if let Some(film) = &mut varied.film {
            film.oil.viscosity_pa_s += of(Influence::Viscosity);
            film.supply = (film.supply + of(Influence::Supply)).clamp(0.0, FLOODED);
            film.check()?;
        }
        varied.operation.inner_speed_rad_s += of(Influence::Speed);
        let operation = &mut varied.operation;
        if operation.radial_load_n != 0.0 {
            operation.space.axial_load_n *= 1.0 + of(Influence::Load) / operation.radial_load_n;
        }
        operation.radial_load_n += of(Influence::Load);
        cageless::step_limits::check(&varied)?;
        Ok(varied)
    }
}

/// A bearing to be judged.
#[derive(Debug, Clone, PartialEq)]
pub struct Trial {
    /// The only influence that deviates; `None`: none, or all at once.
    pub influence: Option<Influence>,
    /// Size of the deviation.
    pub deviation: Deviation,
}

/// Lots of balls drawn for the row of the balls' radii.
const LOTS: u64 = 4;

/// The case as drawn (first), then each influence at both ends of its range with all else as
/// drawn (for the balls several lots), then `samples` bearings in which everything deviates at
/// once. Every deviation is uniform within its range and independent of the others, the radius
/// of each ball on its own; the same seed gives the same bearings.
pub fn trials(case: &Case, tolerances: &Tolerances, samples: u64, seed: u64) -> Vec<Trial> {
    let mut trials = vec![Trial {
        influence: None,
        deviation: Deviation::none(),
    }];
    let lot = |stream: &mut RandomStream| {
        tolerances
            .ball_grade
            .map_or(vec![], |grade| lot(stream, grade, case.bearing.balls()))
    };
    for influence in Influence::ALL {
        let range = tolerances.range(case, influence);
        if influence == Influence::BallRadius {
            if range[1] > 0.0 {
                trials.extend((0..LOTS).map(|k| Trial {
                    influence: Some(influence),
                    deviation: Deviation {
                        ball_radius_m: lot(&mut RandomStream::new(seed, LOT, 0, k)),
                        ..Deviation::none()
                    },
                }));
            }
            continue;
        }
        trials.extend(range.into_iter().filter(|v| *v != 0.0).map(|value| Trial {
            influence: Some(influence),
            deviation: Deviation::one(influence, value),
        }));
    }
    trials.extend((0..samples).map(|k| {
        let mut stream = RandomStream::new(seed, MONTE_CARLO, 0, k);
        let mut deviation = Deviation::none();
        let mut draw = |stream: &mut RandomStream, influence: Influence| {
            let [low, high] = tolerances.range(case, influence);
            deviation.values[influence as usize] = stream.between(low, high);
        };
        // What only space or oil has comes last: other bearings are drawn as if it were not there.
        let of_oil = [Influence::Viscosity, Influence::Supply];
        let last = [Influence::BallRadius, Influence::SectionAngle];
        let last = last.into_iter().chain(of_oil).collect::<Vec<_>>();
        for influence in Influence::ALL.into_iter().filter(|i| !last.contains(i)) {
            draw(&mut stream, influence);
        }
        let ball_radius_m = lot(&mut stream);
        draw(&mut stream, Influence::SectionAngle);
        for influence in of_oil {
            draw(&mut stream, influence);
        }
        deviation.ball_radius_m = ball_radius_m;
        Trial {
            influence: None,
            deviation,
        }
    }));
    trials
}

/// Deviations of the radii of `balls` balls of one lot, uniform within what the grade admits and
/// independent of each other. The same seed and index give the same lot; lots of the same seed
/// and index in two grades differ by a factor alone.
pub fn ball_lot_m(grade: BallGrade, balls: usize, seed: u64, index: u64) -> Vec<f64> {
    lot(&mut RandomStream::new(seed, LOT, 0, index), grade, balls)
}

/// Purpose of the random streams of single lots.
const LOT: u64 = 1;
/// Purpose of the random streams of bearings that deviate in everything at once.
const MONTE_CARLO: u64 = 2;

fn lot(stream: &mut RandomStream, grade: BallGrade, balls: usize) -> Vec<f64> {
    let most = grade.radius_deviation_m();
    (0..balls).map(|_| stream.between(-most, most)).collect()
}
