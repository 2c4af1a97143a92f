//! The equations of motion in space: balls with six degrees of freedom between an inner ring with
//! three translations and two tilts and the true surface of the outer ring.
//!
//! All in inertial Cartesian coordinates, in which a sphere has no gyroscopic term. The plane is
//! the special case z = 0 without tilt. Friction acts in strips across the groove, with spin and
//! the differential sliding of a curved contact.

mod bearing;
mod block;
mod creep;
mod edges;
mod energy;
mod evaluation;
mod film;
mod frame;
mod friction;
mod inner_groove;
mod model;
mod newton;
mod normal_contacts;
mod outer_groove;
mod ring;
mod sliding;
mod strips;
mod traction;
mod workspace;

pub(crate) use bearing::{Bearing, Drive};
pub(crate) use edges::edges;
pub(crate) use energy::energy_j;
pub(crate) use evaluation::evaluate;
pub(crate) use friction::add_implicit_friction;
pub(crate) use model::SpaceModel;
pub(crate) use sliding::outer_z_m;
pub(crate) use workspace::{BallContacts, SpaceWorkspace};

/// A vector in the frame of the outer ring: X, Y, Z.
pub(crate) type Vector = nalgebra::Vector3<f64>;
