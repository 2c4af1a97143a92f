//! Normal coordinates of the lateral motion of a rotor.

use super::{
    ClearancePlane, DMatrix, DVector, LinearRotor, RotorError, Rows, Unbalance, symmetric,
};

/// Lateral motion of a rotor in any coordinates.
pub(super) struct Lateral {
    pub mass: DMatrix<f64>,
    pub damping: DMatrix<f64>,
    pub gyroscopic: DMatrix<f64>,
    pub stiffness: DMatrix<f64>,
    pub spin_up: DMatrix<f64>,
    /// Force of a gravity of 1 m/s² along +Y, on the rotor and its housings.
    pub weight: DVector<f64>,
    /// m of the rotor alone, kg.
    pub rotor_kg: f64,
    /// x and y of each journal, rows over the coordinates.
    pub journals: Vec<DMatrix<f64>>,
    /// Columns of [`LinearRotor::shapes`]; those of least kinetic energy if absent.
    pub shapes: Option<DMatrix<f64>>,
    pub unbalances: Vec<Unbalance<Rows>>,
    pub planes: Vec<ClearancePlane<Rows>>,
    pub polar_inertia: f64,
}

impl Lateral {
    /// Changes to normal coordinates.
    pub(super) fn normal(self) -> Result<LinearRotor, RotorError> {
        let not_definite = || RotorError::Property {
            name: "M",
            property: "positive definite",
            found: String::new(),
        };
        let factor = self.mass.clone().cholesky().ok_or_else(not_definite)?.l();
        let inverse = factor.clone().try_inverse().ok_or_else(not_definite)?;
        let symmetric = symmetric(&(&inverse * &self.stiffness * inverse.transpose()));
        let modes = symmetric.symmetric_eigen().eigenvectors;
        // Coordinates q = V·u with Vᵀ·M·V = 1.
        let v = inverse.transpose() * &modes;
        let of = |matrix: &DMatrix<f64>| v.transpose() * matrix * &v;
        let journals: Vec<_> = self.journals.iter().map(|rows| rows * &v).collect();
        let shapes = match &self.shapes {
            Some(shapes) => modes.transpose() * factor.transpose() * shapes,
            None => least_energy(&journals)?,
        };
        let lift = v.transpose() * &self.weight;
        Ok(LinearRotor {
            damping: of(&self.damping),
            gyroscopic: of(&self.gyroscopic),
            stiffness: of(&self.stiffness),
            spin_up: of(&self.spin_up),
            lift,
            shapes,
            unbalances: self
                .unbalances
                .iter()
                .map(|u| u.at(&u.place * &v))
                .collect(),
            planes: self.planes.iter().map(|p| p.at(&p.place * &v)).collect(),
            journals,
            polar_inertia_kg_m2: self.polar_inertia,
            mass_kg: self.rotor_kg,
        })
    }
}

/// Shapes of least kinetic energy in which one journal coordinate is 1 and the others are 0.
fn least_energy(journals: &[DMatrix<f64>]) -> Result<DMatrix<f64>, RotorError> {
    let columns = journals[0].ncols();
    let mut all = DMatrix::zeros(2 * journals.len(), columns);
    for (k, rows) in journals.iter().enumerate() {
        all.view_mut((2 * k, 0), (2, columns)).copy_from(rows);
    }
    let negligible = 1e-12 * all.norm();
    all.pseudo_inverse(negligible)
        .map_err(|message| RotorError::Bearings(message.to_owned()))
}
