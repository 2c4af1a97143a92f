// Cases that the tests share.

use cageless::dynamics::State;
use cageless::film::Oil;
use cageless::reference::{self, Structure};
use cageless::simulation::{Control, Ending, Observer, RunOutcome, Simulation, run};
use cageless::surface::OuterRingDimensions;
use cageless::{
    Bearing, BearingDimensions, Case, InputError, Material, Raceway, RacewayDimensions,
    RacewayForm, RacewayShape,
};

/// Zhao 2022, Table 1.
#[allow(dead_code)]
pub fn dimensions() -> BearingDimensions {
    reference::DIMENSIONS
}

#[allow(dead_code)]
pub fn steel() -> Material {
    Material::STEEL
}

/// The ten structures of Zhao 2022, Table 2: lC in mm, θ in degrees, β0 by Eq. (11) as
/// printed there, simulated value.
#[allow(dead_code)]
pub fn structures() -> [(f64, f64, f64, f64); 10] {
    Structure::ALL.map(|structure| {
        let row = structure.row();
        let gaps_deg = [row.theoretical_gap_deg, row.simulated_gap_deg];
        (
            row.axial_span_mm,
            row.half_angle_deg,
            gaps_deg[0],
            gaps_deg[1],
        )
    })
}

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

/// The conventional bearing of the paper with other dimensions.
#[allow(dead_code)]
pub fn conventional(dimensions: BearingDimensions) -> Case {
    Case {
        bearing: Bearing::new(dimensions, steel()).unwrap(),
        ..reference::conventional()
    }
}

/// The bearing of Zhao 2022, Table 1, with a slot at the bottom whose edges have a radius of 0.3 mm.
#[allow(dead_code)]
pub fn slotted() -> Case {
    let case = conventional(dimensions());
    let form = RacewayForm::default().reshaped(RacewayShape::Slot, 0.3e-3);
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

#[allow(dead_code)]
pub fn drop_case() -> Case {
    reference::rotor_drop()
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

/// Outcome of a run of a case from a given state.
#[allow(dead_code)]
pub fn run_from(
    case: &Case,
    state: &State,
    angle_rad: &[f64],
    observers: &mut [&mut dyn Observer],
    control: &mut dyn FnMut(f64) -> Control,
) -> Result<RunOutcome, InputError> {
    let mut simulation = Simulation::at(case, state, angle_rad)?;
    Ok(simulation.run_controlled(case.solver.duration_s, observers, control))
}

/// Oil of the reference numbers, of a viscosity in mPa·s.
#[allow(dead_code)]
pub fn oil(mpa_s: f64) -> Oil {
    Oil {
        pressure_viscosity_1_pa: 1.5e-8,
        ..Oil::mineral(1e-3 * mpa_s, 0.035)
    }
}

/// Outer ring of the bearing of Zhao 2022, without blends.
#[allow(dead_code)]
pub const OUTER_RING: OuterRingDimensions = OuterRingDimensions {
    outer_ring_outer_radius_m: 31e-3,
    outer_ring_width_m: 16e-3,
    blend_m: 0.0,
};
