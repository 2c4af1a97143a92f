//! A rotor that several touchdown bearings catch, with linear lateral motion: rigid, or any by its
//! matrices.
//!
//! ```
//! use cageless::linear_rotor::RigidRotor;
//!
//! let rotor = RigidRotor {
//!     mass_kg: 40.0,
//!     polar_inertia_kg_m2: 0.04,
//!     transverse_inertia_kg_m2: 0.6,
//!     bearing_axial_m: vec![-0.1, 0.2],
//!     unbalances: vec![],
//!     clearances: vec![],
//! };
//! let rotor = rotor.linear()?;
//! // The nearer bearing carries more.
//! let shares = rotor.mass_shares_kg();
//! assert!((shares[0] - 40.0 * 2.0 / 3.0).abs() < 1e-9);
//! // A rigid rotor without contact: precession at Ω·Ip/It, and what rests stays at rest.
//! let values = rotor.eigenvalues(3000.0).unwrap();
//! let fastest = values.iter().fold(0.0, |most: f64, e| most.max(e.im));
//! assert!((fastest - 3000.0 * 0.04 / 0.6).abs() < 1e-6);
//! # Ok::<(), cageless::linear_rotor::RotorError>(())
//! ```

mod matrices;
mod normal;
mod rigid;
mod tilts;

pub use matrices::{Reduction, RotorMatrices};
pub use nalgebra::{Complex, DMatrix, DVector};
pub(crate) use rigid::ROUNDING;
pub use rigid::RigidRotor;

use std::f64::consts::TAU;

use nalgebra::Schur;
use thiserror::Error;

/// A rotor that cannot be.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum RotorError {
    /// A value out of range: name, value and what is allowed.
    #[error("{name} = {value}: must be {allowed}")]
    Value {
        /// Name of the value.
        name: &'static str,
        /// The value.
        value: f64,
        /// Allowed values.
        allowed: String,
    },
    /// A matrix of the wrong shape.
    #[error("matrix {name} is {rows} × {columns}: must be {size} × {size}, as M")]
    Shape {
        /// Name of the matrix.
        name: &'static str,
        /// Rows of the matrix.
        rows: usize,
        /// Columns of the matrix.
        columns: usize,
        /// Rows and columns that it should have.
        size: usize,
    },
    /// A matrix without a property that it must have.
    #[error("matrix {name} must be {property}{found}")]
    Property {
        /// Name of the matrix.
        name: &'static str,
        /// Property required of the matrix.
        property: &'static str,
        /// Contrary finding, as the end of the message; empty without one.
        found: String,
    },
    /// A node that the rotor does not have.
    #[error("node {node} does not exist: the rotor has the nodes 0 to {last}")]
    Node {
        /// The node.
        node: usize,
        /// The last node.
        last: usize,
    },
    /// Bearings that do not hold the rotor.
    #[error("{0}")]
    Bearings(String),
}

/// Radial clearance between rotor and stator in a plane: the magnetic gap of an active magnetic
/// bearing, a seal, an impeller.
#[derive(Debug, Clone, PartialEq)]
pub struct Clearance {
    /// Name of the plane in results.
    pub name: String,
    /// Largest displacement of the axis from the centre of the stator, m.
    pub radial_m: f64,
}

/// Unbalance in a plane of a rotor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unbalance<P> {
    /// The plane: its place on the axis of a [`RigidRotor`], m, or its node in [`RotorMatrices`], from 0.
    pub place: P,
    /// m·ε.
    pub moment_kg_m: f64,
    /// Direction at the start, from +X, counter-clockwise.
    pub phase_rad: f64,
}

/// Plane of a rotor with a clearance to the stator.
#[derive(Debug, Clone, PartialEq)]
pub struct ClearancePlane<P> {
    /// The plane, as that of an [`Unbalance`].
    pub place: P,
    /// The clearance.
    pub clearance: Clearance,
}

/// x and y of the axis in a plane, rows over the coordinates of the rotor.
pub(crate) type Rows = DMatrix<f64>;

impl<P> Unbalance<P> {
    /// The unbalance in a plane that is given otherwise.
    pub(crate) fn at<Q>(&self, place: Q) -> Unbalance<Q> {
        Unbalance {
            place,
            moment_kg_m: self.moment_kg_m,
            phase_rad: self.phase_rad,
        }
    }
}

impl<P> ClearancePlane<P> {
    /// The clearance in a plane that is given otherwise.
    pub(crate) fn at<Q>(&self, place: Q) -> ClearancePlane<Q> {
        let clearance = self.clearance.clone();
        ClearancePlane { place, clearance }
    }
}

impl RotorError {
    /// A value that is not `allowed`.
    pub(crate) fn value(name: &'static str, value: f64, allowed: impl Into<String>) -> Self {
        let allowed = allowed.into();
        Self::Value {
            name,
            value,
            allowed,
        }
    }

    fn without_bearings() -> Self {
        Self::Bearings("a rotor needs at least one touch-down bearing".to_owned())
    }
}

/// Lateral motion of a rotor in normal coordinates u, in which the mass matrix is the identity and
/// the symmetric part of the stiffness is diagonal:
/// ü + (C + Ω·G)·u̇ + (K + Ω̇·Ksdt)·u = forces.
#[derive(Debug, Clone, PartialEq)]
pub struct LinearRotor {
    /// C, 1/s.
    pub(crate) damping: DMatrix<f64>,
    /// G, antisymmetric.
    pub(crate) gyroscopic: DMatrix<f64>,
    /// K, 1/s².
    pub(crate) stiffness: DMatrix<f64>,
    /// Ksdt, 1.
    pub(crate) spin_up: DMatrix<f64>,
    /// Force of a gravity of 1 m/s² along +Y.
    pub(crate) lift: DVector<f64>,
    /// x and y of the journal in each bearing, rows over u.
    pub(crate) journals: Vec<DMatrix<f64>>,
    /// Shapes in which one journal coordinate is 1 and the others are 0: x and y of each journal
    /// in turn.
    pub(crate) shapes: DMatrix<f64>,
    /// Unbalances.
    pub(crate) unbalances: Vec<Unbalance<Rows>>,
    /// Planes with a clearance to the stator.
    pub(crate) planes: Vec<ClearancePlane<Rows>>,
    /// Ip about the axis, kg·m².
    pub polar_inertia_kg_m2: f64,
    /// m without housings, kg.
    pub mass_kg: f64,
}

impl LinearRotor {
    /// Number of normal coordinates.
    pub fn coordinates(&self) -> usize {
        self.lift.len()
    }

    /// Number of touchdown bearings.
    pub(crate) fn bearings(&self) -> usize {
        self.journals.len()
    }

    /// Part of the mass, housings included, that each bearing carries when the rotor rests in them.
    pub fn mass_shares_kg(&self) -> Vec<f64> {
        let loads = self.shapes.transpose() * &self.lift;
        (0..self.bearings()).map(|k| loads[2 * k + 1]).collect()
    }

    /// Sag of each journal under a gravity of 1 m/s² in the springs of the rotor to the ground alone, m;
    /// without end, or `None`, where it falls freely.
    pub fn own_sags_m(&self) -> Option<Vec<f64>> {
        let risen = self.stiffness.clone().lu().solve(&self.lift)?;
        let journals = self.journals.iter();
        Some(journals.map(|rows| (rows * &risen).norm()).collect())
    }

    /// Mass that the journal in bearing `k` shows to a sudden force across the axis, kg; the least
    /// over all directions.
    pub(crate) fn effective_mass_kg(&self, k: usize) -> f64 {
        let journal = &self.journals[k];
        let most = (journal * journal.transpose())
            .symmetric_eigenvalues()
            .max();
        1.0 / most
    }

    /// ω of the fastest normal coordinate at rest, rad/s.
    pub(crate) fn fastest_rad_s(&self) -> f64 {
        // The symmetric part of K is diagonal.
        self.stiffness.diagonal().max().max(0.0).sqrt()
    }

    /// Natural frequencies at rest without damping, Hz, the lowest first; 0 of rigid motions.
    pub fn frequencies_hz(&self) -> Vec<f64> {
        // The symmetric part of K is diagonal.
        let squares = self.stiffness.diagonal();
        let mut found: Vec<f64> = (squares.iter())
            .map(|square| square.max(0.0).sqrt() / TAU)
            .collect();
        found.sort_by(f64::total_cmp);
        found
    }

    /// Fastest decay of the lateral motion by C: the largest eigenvalue of M⁻¹·C, its symmetric
    /// part, 1/s.
    pub(crate) fn fastest_decay_1_s(&self) -> f64 {
        let rates = symmetric(&self.damping).symmetric_eigenvalues();
        rates.max().max(0.0)
    }

    /// Eigenvalues of the lateral motion at a constant speed, 1/s: real part the growth, imaginary
    /// part the angular frequency. `None` where the speed is no number, or its forces are beyond the
    /// range of numbers.
    pub fn eigenvalues(&self, speed_rad_s: f64) -> Option<Vec<Complex<f64>>> {
        let n = self.coordinates();
        // In [ω·u, u̇], ω of each coordinate, rounding is relative to the frequencies rather than
        // to their squares.
        let own = DVector::from_fn(n, |k, _| self.stiffness[(k, k)].max(1.0).sqrt());
        let mut state = DMatrix::zeros(2 * n, 2 * n);
        state.view_mut((0, n), (n, n)).set_diagonal(&own);
        let rates = &self.damping + &self.gyroscopic * speed_rad_s;
        let stiffness = &self.stiffness * DMatrix::from_diagonal(&own.map(|w| 1.0 / w));
        state.view_mut((n, 0), (n, n)).copy_from(&-stiffness);
        state.view_mut((n, n), (n, n)).copy_from(&-rates);
        let schur = Schur::try_new(state, f64::EPSILON, ITERATIONS_MAX * n)?;
        let found: Vec<Complex<f64>> = schur.complex_eigenvalues().iter().copied().collect();
        let finite = |value: &Complex<f64>| value.re.is_finite() && value.im.is_finite();
        found.iter().all(finite).then_some(found)
    }
}

/// Iterations of the QR algorithm for each coordinate, of which it takes a few.
const ITERATIONS_MAX: usize = 200;

/// Symmetric part of a matrix.
fn symmetric(matrix: &DMatrix<f64>) -> DMatrix<f64> {
    (matrix + matrix.transpose()) * 0.5
}
