//! The bearing, the structures and the equations of Zhao 2022, as they are printed.
//!
//! ```
//! use cageless::reference::{self, Structure};
//!
//! assert_eq!(reference::bearing().balls(), 14);
//! let case = Structure::D.case();
//! assert_eq!(case.raceways.len(), 1);
//! assert_eq!(case.operation.radial_load_n, 1500.0);
//! ```

mod textbook;

use std::f64::consts::TAU;

use crate::bearing::{Bearing, BearingDimensions, InnerRingBore};
use crate::case::{Case, StartState};
use crate::flank_model::FlankModel;
use crate::integrator::IntegrationMethod;
use crate::material::Material;
use crate::raceway::{Raceway, RacewayDimensions};
use crate::rotor::{Rotor, Support};

pub use textbook::Textbook;

/// Dimensions of Zhao 2022, Table 1, with the usual values for what the paper leaves out: mass and damping of the
/// inner ring.
pub const DIMENSIONS: BearingDimensions = BearingDimensions {
    balls: 14,
    ball_radius_m: 4.7625e-3,
    inner_groove_bottom_radius_m: 18.24e-3,
    outer_groove_bottom_radius_m: 27.765e-3,
    outer_shoulder_radius_m: 26e-3,
    inner_shoulder_radius_m: None,
    inner_groove_curvature_radius_m: 4.953e-3,
    outer_groove_curvature_radius_m: 4.953e-3,
    inner_ring_mass_kg: 0.2,
    inner_ring_damping_n_s_m: 2000.0,
};

/// The bearing of [`DIMENSIONS`], of steel.
pub fn bearing() -> Bearing {
    Bearing::new(DIMENSIONS, Material::STEEL).expect("the parts of Table 1 fit together")
}

/// The bearing with a plain outer raceway: 12 000 rpm, 1500 N, and the paper's method with a step of 1 µs over 20 ms.
pub fn conventional() -> Case {
    let mut case = Case::of(bearing());
    case.operation.inner_speed_rad_s = 12_000.0 * TAU / 60.0;
    case.operation.radial_load_n = 1500.0;
    case.flanks = FlankModel::Rigid;
    case.contact.friction_strips = 1;
    case.solver.method = IntegrationMethod::Abm4;
    case.solver.duration_s = 0.02;
    case
}

/// The bearing below a rotor of 20 kg that falls from 30 000 rpm through 0.2 mm, balls dry (μ = 0.1); the paper has no
/// rotor.
pub fn rotor_drop() -> Case {
    let undamped = BearingDimensions {
        inner_ring_damping_n_s_m: 0.0,
        ..DIMENSIONS
    };
    let bore = InnerRingBore {
        polar_inertia_kg_m2: 5.5e-5,
        radius_m: 15e-3,
    };
    let bearing = Bearing::new(undamped, Material::STEEL);
    let bearing = bearing.and_then(|bearing| bearing.with_inner_ring_bore(bore));
    let mut case = Case {
        bearing: bearing.expect("the bore lies below the groove of Table 1"),
        ..conventional()
    };
    case.operation.inner_speed_rad_s = 0.0;
    case.operation.radial_load_n = 0.0;
    case.contact.friction.coefficient = 0.1;
    case.start.state = StartState::AtRest;
    case.rotor = Some(Rotor::estimated(20.0, 0.02, 30_000.0 * TAU / 60.0, 2e-4));
    case.support = Some(Support {
        mass_kg: 0.5,
        stiffness_n_m: 2e7,
        damping_n_s_m: 4e3,
        stop: None,
    });
    case
}

/// A structure of Zhao 2022, Table 2.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Structure {
    /// lC = 4.95 mm, θ = 35°.
    A,
    /// lC = 5 mm, θ = 30.5°.
    B,
    /// lC = 5.05 mm, θ = 27.5°.
    C,
    /// lC = 5.1 mm, θ = 25.2°.
    D,
    /// lC = 5.15 mm, θ = 23.5°.
    E,
    /// lC = 5.2 mm, θ = 22°.
    F,
    /// lC = 5.4 mm, θ = 18.167°.
    G,
    /// lC = 5.6 mm, θ = 15.774°.
    H,
    /// lC = 5.8 mm, θ = 14.062°.
    I,
    /// lC = 6 mm, θ = 12.717°.
    J,
}

/// A row of Zhao 2022, Table 2.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StructureRow {
    /// lC, mm.
    pub axial_span_mm: f64,
    /// θ, °.
    pub half_angle_deg: f64,
    /// β0 by Eq. (11) as printed, °.
    pub theoretical_gap_deg: f64,
    /// Critical gap as simulated there, °.
    pub simulated_gap_deg: f64,
}

/// Zhao 2022, Table 2.
const TABLE_2: [[f64; 4]; 10] = [
    [4.95, 35.0, 1.8153, 1.8131],
    [5.0, 30.5, 1.8176, 1.8281],
    [5.05, 27.5, 1.8185, 1.8323],
    [5.1, 25.2, 1.8171, 1.8190],
    [5.15, 23.5, 1.8183, 1.7932],
    [5.2, 22.0, 1.8156, 1.7552],
    [5.4, 18.167, 1.8161, 1.6589],
    [5.6, 15.774, 1.8161, 1.6594],
    [5.8, 14.062, 1.8161, 1.5416],
    [6.0, 12.717, 1.8160, 1.4538],
];

impl Structure {
    /// The ten structures, in the order of the table.
    pub const ALL: [Self; 10] = [
        Self::A,
        Self::B,
        Self::C,
        Self::D,
        Self::E,
        Self::F,
        Self::G,
        Self::H,
        Self::I,
        Self::J,
    ];

    /// Row of the structure in the table.
    pub const fn row(self) -> StructureRow {
        let [
            axial_span_mm,
            half_angle_deg,
            theoretical_gap_deg,
            simulated_gap_deg,
        ] = TABLE_2[self as usize];
        StructureRow {
            axial_span_mm,
            half_angle_deg,
            theoretical_gap_deg,
            simulated_gap_deg,
        }
    }

    /// Raceway of the structure in a bearing, at the bottom.
    ///
    /// # Errors
    /// The [`InputError`](crate::InputError) of a bearing into which it does not fit.
    pub fn raceway(self, bearing: &Bearing) -> Result<Raceway, crate::InputError> {
        let row = self.row();
        let dimensions = RacewayDimensions {
            axial_span_m: row.axial_span_mm * 1e-3,
            half_angle_rad: row.half_angle_deg.to_radians(),
            centre_angle_rad: 0.0,
        };
        Raceway::new(dimensions, bearing)
    }

    /// The case of [`conventional`] with its raceway.
    pub fn case(self) -> Case {
        let case = conventional();
        let raceway = self.raceway(&case.bearing);
        case.with_raceways(vec![raceway.expect("a raceway of Table 2 in its bearing")])
    }
}
