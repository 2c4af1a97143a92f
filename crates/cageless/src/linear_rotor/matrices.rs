//! A rotor given by its matrices, and its reduction.

use std::ops::Range;

use super::normal::Lateral;
use super::rigid::{POLAR_INERTIA, finite, positive, within};
use super::{ClearancePlane, DMatrix, DVector, LinearRotor, RotorError, Unbalance, symmetric};

/// Matrices of the lateral motion of a rotor,
/// (M + Ma)·q̈ + (C + Ω·G)·q̇ + (K + Ω̇·Ksdt)·q = f.
///
/// A node has the coordinates [x, y, α, β]: displacements along X and Y in m, and rotations about
/// X and Y in rad, so that of a rigid tilt dx/dz = β and dy/dz = −α. Those of all nodes are followed
/// by [x, y] of each housing.
#[derive(Debug, Clone, PartialEq)]
pub struct RotorMatrices {
    /// M, symmetric and positive definite.
    pub mass: DMatrix<f64>,
    /// Ma, symmetric: inertia without weight, that of the fluid in seals.
    pub added_mass: DMatrix<f64>,
    /// C.
    pub damping: DMatrix<f64>,
    /// G, antisymmetric; of a disc +Ip in row α and column β, −Ip in row β and column α.
    pub gyroscopic: DMatrix<f64>,
    /// K; its antisymmetric part is that of cross-coupled stiffnesses.
    pub stiffness: DMatrix<f64>,
    /// Ksdt, of a speed that changes.
    pub spin_up: DMatrix<f64>,
    /// Number of housings: bodies of the stator on which the rotor rests, in springs of K.
    pub housings: usize,
    /// Ip of the whole rotor about its axis, kg·m².
    pub polar_inertia_kg_m2: f64,
}

/// Nodes and modes that a reduction keeps.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Reduction {
    /// Node of each touchdown bearing, from 0.
    pub bearing_nodes: Vec<usize>,
    /// Further nodes whose displacements are kept, those of sensors.
    pub kept_nodes: Vec<usize>,
    /// Unbalances; their nodes are kept as well.
    pub unbalances: Vec<Unbalance<usize>>,
    /// Clearances to the stator; their nodes are kept as well.
    pub clearances: Vec<ClearancePlane<usize>>,
    /// Modes with all of these nodes held are kept up to this frequency; all of them without it.
    pub frequency_max_hz: Option<f64>,
}

/// Coordinates of a node.
pub(super) const NODE_COORDINATES: usize = 4;
/// Coordinates of a housing.
pub(super) const HOUSING_COORDINATES: usize = 2;

/// Asymmetry that rounding explains, as a fraction of the largest element.
const ROUNDING: f64 = 1e-9;

impl RotorMatrices {
    /// Number of nodes.
    pub(crate) fn nodes(&self) -> usize {
        self.shaft() / NODE_COORDINATES
    }

    /// Number of coordinates of all nodes.
    fn shaft(&self) -> usize {
        let housings = self.housings.saturating_mul(HOUSING_COORDINATES);
        self.mass.nrows().saturating_sub(housings)
    }

    /// The rotor reduced to its touchdown nodes and the kept nodes with the modes of the rest
    /// (Craig & Bampton 1968, AIAA J. 6, 1313–1319), in normal coordinates. With all modes kept
    /// the reduction is exact.
    ///
    /// # Errors
    /// A [`RotorError`]: matrices that cannot be those of a rotor, nodes that do not exist, or too
    /// few nodes to hold the rest.
    pub fn reduce(&self, reduction: &Reduction) -> Result<LinearRotor, RotorError> {
        self.check()?;
        reduction.check()?;
        let held = self.held_nodes(reduction)?;
        let size = self.mass.nrows();
        let place = |node: usize| [NODE_COORDINATES * node, NODE_COORDINATES * node + 1];
        let boundary: Vec<usize> = held.iter().flat_map(|node| place(*node)).collect();
        let inner: Vec<usize> = (0..size).filter(|k| !boundary.contains(k)).collect();
        let part = |matrix: &DMatrix<f64>, rows: &[usize], columns: &[usize]| {
            matrix.select_rows(rows).select_columns(columns)
        };
        let stiffness = symmetric(&self.stiffness);
        let singular = || moves_freely(held.len());
        let inner_stiffness = part(&stiffness, &inner, &inner);
        let factor = inner_stiffness.clone().cholesky().ok_or_else(singular)?;
        if !is_well_held(&factor.l(), &inner_stiffness) {
            return Err(singular());
        }
        let static_shapes = -factor.solve(&part(&stiffness, &inner, &boundary));
        let inertia = &self.mass + &self.added_mass;
        let modes = held_modes(
            &part(&inertia, &inner, &inner),
            &factor.l(),
            reduction.frequency_max_hz,
        )?;
        let t = shapes(&boundary, &inner, &static_shapes, &modes);
        let of = |matrix: &DMatrix<f64>| t.transpose() * matrix * &t;
        let rows = |node: usize| {
            let mut rows = DMatrix::zeros(2, t.ncols());
            let first = 2 * held.iter().position(|n| *n == node).unwrap_or(0);
            (rows[(0, first)], rows[(1, first + 1)]) = (1.0, 1.0);
            rows
        };
        let journals: Vec<_> = reduction.bearing_nodes.iter().map(|n| rows(*n)).collect();
        let of_shaft = self.upwards(0..self.shaft());
        let lateral = Lateral {
            mass: symmetric(&of(&inertia)),
            damping: of(&self.damping),
            gyroscopic: of(&self.gyroscopic),
            stiffness: of(&self.stiffness),
            spin_up: of(&self.spin_up),
            weight: t.transpose() * &self.mass * self.upwards(0..size),
            rotor_kg: of_shaft.dot(&(&self.mass * &of_shaft)),
            shapes: self.journal_shapes(&of(&stiffness), reduction, &held),
            journals,
            unbalances: (reduction.unbalances.iter())
                .map(|u| u.at(rows(u.place)))
                .collect(),
            planes: (reduction.clearances.iter())
                .map(|c| c.at(rows(c.place)))
                .collect(),
            polar_inertia: self.polar_inertia_kg_m2,
        };
        lateral.normal()
    }

    /// Displacement of these coordinates by 1 along +Y.
    fn upwards(&self, moved: Range<usize>) -> DVector<f64> {
        let shaft = self.shaft();
        let along_y = |k: usize| match k < shaft {
            true => k % NODE_COORDINATES == 1,
            false => (k - shaft) % HOUSING_COORDINATES == 1,
        };
        DVector::from_fn(self.mass.nrows(), |k, _| {
            f64::from(u8::from(moved.contains(&k) && along_y(k)))
        })
    }

    /// Static shapes of the journals: further kept nodes follow without force.
    fn journal_shapes(
        &self,
        stiffness: &DMatrix<f64>,
        reduction: &Reduction,
        held: &[usize],
    ) -> Option<DMatrix<f64>> {
        let count = reduction.bearing_nodes.len();
        let size = stiffness.nrows();
        let index = |node: &usize| held.iter().position(|n| n == node);
        let given: Vec<usize> = (reduction.bearing_nodes.iter())
            .filter_map(index)
            .flat_map(|k| [2 * k, 2 * k + 1])
            .collect();
        let free: Vec<usize> = (0..size).filter(|k| !given.contains(k)).collect();
        let mut shapes = DMatrix::zeros(size, 2 * count);
        for (column, row) in given.iter().enumerate() {
            shapes[(*row, column)] = 1.0;
        }
        if free.is_empty() {
            return Some(shapes);
        }
        let block = stiffness.select_rows(&free).select_columns(&free);
        let coupling = stiffness.select_rows(&free).select_columns(&given);
        let factor = block.clone().cholesky()?;
        if !is_well_held(&factor.l(), &block) {
            return None;
        }
        let follow = -factor.solve(&coupling);
        for (row, place) in free.iter().enumerate() {
            shapes.row_mut(*place).copy_from(&follow.row(row));
        }
        Some(shapes)
    }

    /// Touchdown nodes, kept nodes and those of unbalances and clearances, each once.
    fn held_nodes(&self, reduction: &Reduction) -> Result<Vec<usize>, RotorError> {
        if reduction.bearing_nodes.is_empty() {
            return Err(RotorError::without_bearings());
        }
        let mut held: Vec<usize> = vec![];
        let unbalanced = reduction.unbalances.iter().map(|u| u.place);
        let further = reduction.kept_nodes.iter().copied().chain(unbalanced);
        let further = further.chain(reduction.clearances.iter().map(|c| c.place));
        for (k, node) in reduction.bearing_nodes.iter().copied().enumerate() {
            self.check_node(node)?;
            if reduction.bearing_nodes[..k].contains(&node) {
                return Err(RotorError::Bearings(format!(
                    "two touch-down bearings are at node {node}: each needs its own"
                )));
            }
            held.push(node);
        }
        for node in further {
            self.check_node(node)?;
            if !held.contains(&node) {
                held.push(node);
            }
        }
        Ok(held)
    }

    fn check_node(&self, node: usize) -> Result<(), RotorError> {
        if node < self.nodes() {
            return Ok(());
        }
        Err(RotorError::Node {
            node,
            last: self.nodes().saturating_sub(1),
        })
    }

    fn check(&self) -> Result<(), RotorError> {
        let size = self.mass.nrows();
        for (name, matrix) in [
            ("M", &self.mass),
            ("Ma", &self.added_mass),
            ("C", &self.damping),
            ("G", &self.gyroscopic),
            ("K", &self.stiffness),
            ("Ksdt", &self.spin_up),
        ] {
            if matrix.shape() != (size, size) {
                return Err(RotorError::Shape {
                    name,
                    rows: matrix.nrows(),
                    columns: matrix.ncols(),
                    size,
                });
            }
            if let Some(value) = matrix.iter().find(|v| !v.is_finite()) {
                return Err(RotorError::Property {
                    name,
                    property: "of finite numbers",
                    found: format!(", not {value}"),
                });
            }
        }
        if self.shaft() == 0 || !self.shaft().is_multiple_of(NODE_COORDINATES) {
            let housings = match self.housings {
                0 => String::new(),
                count => format!(" with two of each of {count} housings, [x, y]"),
            };
            return Err(RotorError::Property {
                name: "M",
                property: "of four coordinates a node, [x, y, α, β]",
                found: format!(", not {size} in all{housings}"),
            });
        }
        paired("M", "symmetric", &self.mass, 1.0)?;
        paired("Ma", "symmetric", &self.added_mass, 1.0)?;
        paired("G", "antisymmetric", &self.gyroscopic, -1.0)?;
        for (name, matrix) in [
            ("M", self.mass.clone()),
            ("M + Ma", &self.mass + &self.added_mass),
        ] {
            if matrix.cholesky().is_none() {
                return Err(RotorError::Property {
                    name,
                    property: "positive definite",
                    found: String::new(),
                });
            }
        }
        positive("polar_inertia_kg_m2", self.polar_inertia_kg_m2)?;
        within(
            "polar_inertia_kg_m2",
            POLAR_INERTIA,
            self.polar_inertia_kg_m2,
        )?;
        self.check_tilts()
    }
}

impl Reduction {
    /// Checks the numbers.
    fn check(&self) -> Result<(), RotorError> {
        if let Some(frequency) = self.frequency_max_hz {
            positive("frequency_max_hz", frequency)?;
        }
        for unbalance in &self.unbalances {
            finite("moment_kg_m", unbalance.moment_kg_m)?;
            finite("phase_rad", unbalance.phase_rad)?;
        }
        for clearance in &self.clearances {
            positive("radial_m", clearance.clearance.radial_m)?;
        }
        Ok(())
    }
}

/// The error of a rotor that so many kept nodes do not hold.
fn moves_freely(held: usize) -> RotorError {
    let remedy = match held {
        1 => "two touch-down bearings hold it, or kept nodes elsewhere",
        _ => "K connects its nodes, and the coordinates are [x, y, α, β] of each node in turn",
    };
    RotorError::Bearings(format!(
        "the rotor could still move freely with the {held} kept nodes held: {remedy}"
    ))
}

/// Checks that a matrix is `sign` times its transpose.
fn paired(
    name: &'static str,
    property: &'static str,
    matrix: &DMatrix<f64>,
    sign: f64,
) -> Result<(), RotorError> {
    let largest = matrix.amax();
    for column in 0..matrix.ncols() {
        for row in 0..=column {
            let [a, b] = [matrix[(row, column)], matrix[(column, row)]];
            if (a - sign * b).abs() > ROUNDING * largest {
                return Err(RotorError::Property {
                    name,
                    property,
                    found: format!(
                        ": its elements ({row}, {column}) and ({column}, {row}) are {a} and {b}"
                    ),
                });
            }
        }
    }
    Ok(())
}

/// Whether a stiffness has no direction without resistance, by its Cholesky factor.
fn is_well_held(factor: &DMatrix<f64>, stiffness: &DMatrix<f64>) -> bool {
    (0..factor.nrows()).all(|k| factor[(k, k)].powi(2) > 1e-12 * stiffness[(k, k)])
}

/// Shapes of all coordinates, one column each: for every one at the `boundary` the static shape of a displacement of 1
/// there alone, then the modes with the boundary held.
fn shapes(
    boundary: &[usize],
    inner: &[usize],
    static_shapes: &DMatrix<f64>,
    modes: &DMatrix<f64>,
) -> DMatrix<f64> {
    let (b, m) = (boundary.len(), modes.ncols());
    let mut t = DMatrix::zeros(b + inner.len(), b + m);
    for (column, row) in boundary.iter().enumerate() {
        t[(*row, column)] = 1.0;
    }
    for (row, inner) in inner.iter().enumerate() {
        for column in 0..b {
            t[(*inner, column)] = static_shapes[(row, column)];
        }
        for column in 0..m {
            t[(*inner, b + column)] = modes[(row, column)];
        }
    }
    t
}

/// Modes of mass M on the stiffness L·Lᵀ, columns, up to a frequency.
fn held_modes(
    mass: &DMatrix<f64>,
    factor: &DMatrix<f64>,
    frequency_max_hz: Option<f64>,
) -> Result<DMatrix<f64>, RotorError> {
    let size = mass.nrows();
    if size == 0 {
        return Ok(DMatrix::zeros(0, 0));
    }
    // L⁻¹·M·L⁻ᵀ has the eigenvalues 1/ω², the lowest modes the most exactly.
    let halfway = factor.solve_lower_triangular(mass);
    let flexibility = halfway.and_then(|h| factor.solve_lower_triangular(&h.transpose()));
    let Some(flexibility) = flexibility else {
        return Err(RotorError::Property {
            name: "K",
            property: "regular with the kept nodes held",
            found: String::new(),
        });
    };
    let eigen = symmetric(&flexibility).symmetric_eigen();
    let least = frequency_max_hz.map_or(0.0, |f| (std::f64::consts::TAU * f).powi(-2));
    let kept: Vec<usize> = (0..size)
        .filter(|k| eigen.eigenvalues[*k] >= least)
        .collect();
    let vectors = eigen.eigenvectors.select_columns(&kept);
    factor
        .transpose()
        .solve_upper_triangular(&vectors)
        .ok_or_else(|| RotorError::Property {
            name: "K",
            property: "regular with the kept nodes held",
            found: String::new(),
        })
}
