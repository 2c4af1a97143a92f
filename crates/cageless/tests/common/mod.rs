// Cases that the tests, the examples and the examples of the documentation share.

use std::f64::consts::TAU;

use cageless::simulation::{Control, Ending, RunOutcome, run};
use cageless::{
    Bearing, BearingDimensions, Case, Contact, FlankModel, Formulation, FrictionLaw,
    FrictionParameters, Gaps, InnerRingBore, IntegrationMethod, Material, Motion, Operation,
    Output, Raceway, RacewayDimensions, RacewayForm, RacewayShape, Rotor, Shaft, Solver,
    SpatialLoad, Start, StartState, Support,
};

/// Zhao 2022, Table 1, with the usual values for what the paper leaves out.
#[allow(dead_code)]
pub fn dimensions() -> BearingDimensions {
    BearingDimensions {
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
    }
}

#[allow(dead_code)]
pub fn steel() -> Material {
    Material {
        density_kg_m3: 7850.0,
        youngs_modulus_pa: 206e9,
        poisson_ratio: 0.3,
    }
}

/// The ten structures of Zhao 2022, Table 2: lC in mm, θ in degrees, β0 by Eq. (11) as
/// printed there, simulated value.
#[allow(dead_code)]
pub const STRUCTURES: [(f64, f64, f64, f64); 10] = [
    (4.95, 35.0, 1.8153, 1.8131),
    (5.0, 30.5, 1.8176, 1.8281),
    (5.05, 27.5, 1.8185, 1.8323),
    (5.1, 25.2, 1.8171, 1.8190),
    (5.15, 23.5, 1.8183, 1.7932),
    (5.2, 22.0, 1.8156, 1.7552),
    (5.4, 18.167, 1.8161, 1.6589),
    (5.6, 15.774, 1.8161, 1.6594),
    (5.8, 14.062, 1.8161, 1.5416),
    (6.0, 12.717, 1.8160, 1.4538),
];

#[allow(dead_code)]
pub fn raceway(bearing: &Bearing, span_mm: f64, angle_deg: f64, centre_deg: f64) -> Raceway {
    Raceway::new(
        RacewayDimensions {
            axial_span_m: span_mm * 1e-3,
            half_angle_rad: angle_deg.to_radians(),
            centre_angle_rad: centre_deg.to_radians(),
        },
        bearing,
    )
    .unwrap()
}

/// Conventional outer ring, 12 000 rpm, 1500 N, damped contacts, smooth friction.
#[allow(dead_code)]
pub fn conventional(dimensions: BearingDimensions) -> Case {
    Case {
        title: String::new(),
        bearing: Bearing::new(dimensions, steel()).unwrap(),
        raceways: vec![],
        operation: Operation {
            clockwise: false,
            inner_speed_rad_s: 12_000.0 * TAU / 60.0,
            radial_load_n: 1500.0,
            gravity_m_s2: 9.81,
            inner_speed_table: None,
            radial_load_table: None,
            space: SpatialLoad::default(),
        },
        contact: Contact {
            friction_law: FrictionLaw::Smooth,
            friction: FrictionParameters::smooth(0.007, 0.02),
            outer_friction_factor: 1.0,
            ball_friction_factor: 1.0,
            friction_strips: 1,
            damping_n_s_m1_5: 2e5,
            ball_restitution: 0.95,
            inner_stiffness_n_m1_5: None,
            outer_stiffness_n_m1_5: None,
            ball_stiffness_n_m1_5: None,
        },
        formulation: Formulation::Physical,
        motion: Motion::BySymmetry,
        flanks: FlankModel::Rigid,
        start: Start::new(StartState::Settled, Gaps::Uniform, 0.0),
        solver: Solver {
            method: IntegrationMethod::Abm4,
            step_s: 1e-6,
            tolerance: 1e-8,
            duration_s: 0.02,
            transient_s: None,
        },
        seed: 0,
        housing: None,
        rotor: None,
        support: None,
        rows: vec![],
        fit: None,
        lubrication: None,
        thermal: Default::default(),
        limits: vec![],
        output: Output { interval_s: 1e-4 },
    }
}

/// The bearing of Zhao 2022, Table 1, with a slot at the bottom whose edges have a radius of 0.3 mm.
#[allow(dead_code)]
pub fn slotted() -> Case {
    let case = conventional(dimensions());
    let form = RacewayForm {
        shape: RacewayShape::Slot,
        edge_radius_m: 0.3e-3,
        ..RacewayForm::default()
    };
    let dimensions = RacewayDimensions {
        axial_span_m: 5.1e-3,
        half_angle_rad: 25.2f64.to_radians(),
        centre_angle_rad: 0.0,
    };
    let slot = Raceway::formed(dimensions, form, &case.bearing).unwrap();
    case.with_raceways(vec![slot])
}

/// The same with a discrete raceway at the bottom.
#[allow(dead_code)]
pub fn structure(span_mm: f64, angle_deg: f64) -> Case {
    let case = conventional(dimensions());
    let raceway = raceway(&case.bearing, span_mm, angle_deg, 0.0);
    case.with_raceways(vec![raceway])
}

/// The bearing with a rotor of 20 kg that falls from 30 000 rpm through 0.2 mm, balls dry.
#[allow(dead_code)]
pub fn drop_case() -> Case {
    let mut case = conventional(BearingDimensions {
        inner_ring_damping_n_s_m: 0.0,
        ..dimensions()
    });
    let bore = InnerRingBore {
        polar_inertia_kg_m2: 5.5e-5,
        radius_m: 15e-3,
    };
    case.bearing = case.bearing.with_inner_ring_bore(bore).unwrap();
    case.operation.inner_speed_rad_s = 0.0;
    case.operation.radial_load_n = 0.0;
    case.contact.friction.coefficient = 0.1;
    case.start = Start::new(StartState::AtRest, Gaps::Uniform, 0.0);
    case.rotor = Some(Rotor {
        mass_kg: 20.0,
        polar_inertia_kg_m2: 0.02,
        speed_rad_s: 30_000.0 * TAU / 60.0,
        radial_clearance_m: 2e-4,
        eccentricity_m: 0.0,
        eccentricity_phase_rad: 0.0,
        friction_law: FrictionLaw::Smooth,
        friction: FrictionParameters::smooth(0.15, 0.05),
        contact_stiffness_n_mp: 1e9,
        contact_exponent: 1.0,
        contact_damping_s_m: 0.3,
        x_m: 0.0,
        y_m: 0.0,
        vx_m_s: 0.0,
        vy_m_s: 0.0,
        drive_torque_n_m: 0.0,
        clearance_limit_m: None,
        shaft: Shaft::Horizontal,
        axial_clearance_m: None,
        shoulder_radius_m: None,
        axial_load_n: 0.0,
        z_m: 0.0,
        vz_m_s: 0.0,
    });
    case.support = Some(Support {
        mass_kg: 0.5,
        stiffness_n_m: 2e7,
        damping_n_s_m: 4e3,
        stop: None,
    });
    case
}

/// Without contact damping.
#[allow(dead_code)]
pub fn undamped(mut case: Case) -> Case {
    case.contact.damping_n_s_m1_5 = 0.0;
    case.contact.ball_restitution = 1.0;
    case
}

/// Outcome of a run that completes.
#[allow(dead_code)]
pub fn complete(case: &Case) -> RunOutcome {
    let outcome = run(case, &mut [], &mut |_| Control::Continue(())).unwrap();
    assert!(
        matches!(outcome.ending, Ending::Complete),
        "{:?}",
        outcome.ending
    );
    outcome
}
