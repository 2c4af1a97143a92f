//! Rigid tilts of a rotor given by its matrices, and the signs of rotations and spin that they show.

use super::matrices::{NODE_COORDINATES, RotorMatrices};
use super::{DVector, RotorError, symmetric};

/// Coordinates of a node that a tilt about an axis moves.
#[derive(Clone, Copy)]
struct Tilting {
    displaced: usize,
    turned: usize,
}

/// Coordinates of a tilt about X.
const ABOUT_X: Tilting = Tilting {
    displaced: 1,
    turned: 2,
};
/// Coordinates of a tilt about Y.
const ABOUT_Y: Tilting = Tilting {
    displaced: 0,
    turned: 3,
};

/// Largest elastic energy of a rigid tilt, that of springs which hold the rotor, as a fraction of the energies of
/// single elements of K: with as stiff springs G is found to a few percent.
const RIGID: f64 = 1e-2;

/// Largest ratio of Ip by G and Ip of the rotor, either way: some leave the shaft out of G.
const INERTIA_RATIO: f64 = 2.0;

impl RotorMatrices {
    /// Checks signs of rotations in K, and sign and amount of G, unless stiff springs hold the rotor; G may be 0.
    pub(super) fn check_tilts(&self) -> Result<(), RotorError> {
        let (Some(about_x), Some(about_y)) = (self.rigid_tilt(ABOUT_X), self.rigid_tilt(ABOUT_Y))
        else {
            return Ok(());
        };
        // −z and z.
        let [y, x] = [(&about_x, ABOUT_X), (&about_y, ABOUT_Y)].map(|(tilt, of)| {
            DVector::from_fn(self.nodes(), |node, _| {
                tilt[NODE_COORDINATES * node + of.displaced]
            })
        });
        if x.dot(&y) > 0.0 {
            return Err(RotorError::Property {
                name: "K",
                property: "of rotations about X and Y, dx/dz = β and dy/dz = −α",
                found: ": in a rigid tilt x follows β as y follows α".to_owned(),
            });
        }
        let inertia = about_x.dot(&(&self.gyroscopic * &about_y));
        let given = self.polar_inertia_kg_m2;
        if inertia < 0.0 {
            return Err(RotorError::Property {
                name: "G",
                property: "+Ip in row α and column β of a disc, −Ip in row β and column α",
                found: ": it has the opposite sign".to_owned(),
            });
        }
        let least = given / INERTIA_RATIO;
        if self.gyroscopic.amax() > 0.0 && !(least..=given * INERTIA_RATIO).contains(&inertia) {
            return Err(RotorError::Property {
                name: "G",
                property: "of the whole rotor",
                found: format!(
                    ": it has {inertia:.3e} kg·m² about the axis by G, polar_inertia_kg_m2 is {given:.3e}"
                ),
            });
        }
        Ok(())
    }

    /// The rigid tilt by 1 about an axis, at the first node without displacement; none where stiff springs hold the rotor.
    fn rigid_tilt(&self, about: Tilting) -> Option<DVector<f64>> {
        let stiffness = symmetric(&self.stiffness);
        let mut tilt = DVector::zeros(stiffness.nrows());
        for node in 0..self.nodes() {
            tilt[NODE_COORDINATES * node + about.turned] = 1.0;
        }
        let moved: Vec<usize> = (1..self.nodes())
            .map(|node| NODE_COORDINATES * node + about.displaced)
            .collect();
        if moved.is_empty() {
            return None;
        }
        // With all rotations given, the nodes are held one by the other.
        let held = stiffness.select_rows(&moved).select_columns(&moved);
        let forces = (&stiffness * &tilt).select_rows(&moved);
        let places = held.cholesky()?.solve(&forces);
        for (place, value) in moved.iter().zip(places.iter()) {
            tilt[*place] = -value;
        }
        let energy = tilt.dot(&(&stiffness * &tilt)).abs();
        let of_elements = tilt.abs().dot(&(stiffness.abs() * tilt.abs()));
        (energy <= RIGID * of_elements && of_elements.is_finite()).then_some(tilt)
    }
}
