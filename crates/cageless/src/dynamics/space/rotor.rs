//! The motion of a rotor above the inner ring in space, of the outer ring on its support, and what moves
//! along the axis.

use super::bearing::Totals;
use super::model::SpaceModel;
use super::rotor_touch::{Loads, RotorAlongAxis};
use super::workspace::SpaceWorkspace;
use crate::contact::journal_energy_j;
use crate::dynamics::coordinates::{DropCoordinate, RingCoordinate};
use crate::dynamics::energy::EnergyTerm;
use crate::dynamics::layout::Layout;
use crate::dynamics::model::Model;
use crate::dynamics::rotor::RotorBody;
use crate::simd::{Parameters, Workspace};

/// Speeds of the rotor along X, Y and Z.
fn velocity(layout: Layout, y: &[f64]) -> [f64; 3] {
    [
        DropCoordinate::RotorVx,
        DropCoordinate::RotorVy,
        DropCoordinate::RotorVz,
    ]
    .map(|coordinate| y[layout.drop(coordinate)])
}

/// Sets the rates of rotor and outer ring, adds to those of the inner ring what the rotor does to it, and
/// the powers of all of them; friction of the rotor only if asked for.
#[inline(never)] // once for all instruction sets
pub(super) fn rates_with_rotor(
    (p, model, space): (&Parameters, &Model, &SpaceModel),
    (w, s): (&mut Workspace, &mut SpaceWorkspace),
    totals: &Totals,
    y: &[f64],
    dydt: &mut [f64],
    with_friction: bool,
) {
    let (Some((body, outer_ring)), Some(along_axis)) = (p.drops.first(), &space.rotor) else {
        return;
    };
    let layout = model.layout;
    let bodies = (body, along_axis);
    let (contact, loads, heat) = s.rotor.evaluate(bodies, layout, y, with_friction);
    w.rotors[0] = contact;
    let (rotor, outer) = (velocity(layout, y), layout.outer_ring_motion(y));
    let [outer_z, outer_vz] = layout.outer_ring_along_axis(y);
    let [fx, fy, fz] = s.outer_ring_force_n();
    let [ox, oy] = outer_ring.acceleration(&outer, [fx, fy]);
    let oz =
        (fz + outer_ring.support_force_along_axis(outer_z, outer_vz)) * space.housing_inverse_mass;
    let speed = y[layout.drop(DropCoordinate::RotorSpeed)];
    for (coordinate, rate) in [
        (DropCoordinate::OuterX, outer.vx),
        (DropCoordinate::OuterY, outer.vy),
        (DropCoordinate::OuterZ, outer_vz),
        (DropCoordinate::OuterVx, ox),
        (DropCoordinate::OuterVy, oy),
        (DropCoordinate::OuterVz, oz),
        (DropCoordinate::RotorX, rotor[0]),
        (DropCoordinate::RotorY, rotor[1]),
        (DropCoordinate::RotorZ, rotor[2]),
        (DropCoordinate::RotorAngle, speed),
    ] {
        dydt[layout.drop(coordinate)] = rate;
    }
    let [_, moment] = totals.on_ring();
    let turning = moment.dot(&s.ring.axis) / body.ring_inertia;
    let [.., spin_up] = body.response([0.0; 2], body.drive_torque);
    let mut weight = [0.0; 3];
    weight[space.upward] = -model.ring.gravity;
    for (coordinate, rate) in [
        (DropCoordinate::RingSpeed, turning),
        (DropCoordinate::RotorVx, weight[0]),
        (DropCoordinate::RotorVy, weight[1]),
        (
            DropCoordinate::RotorVz,
            weight[2] + along_axis.load / along_axis.mass,
        ),
        (DropCoordinate::RotorSpeed, spin_up),
    ] {
        dydt[layout.drop(coordinate)] = rate;
    }
    for (place, rate) in rates_by(model, bodies, contact.offset, &loads) {
        dydt[place] += rate;
    }
    let falling = body.mass * weight[space.upward] * rotor[space.upward];
    for (term, power) in [
        (EnergyTerm::Load, along_axis.load * rotor[2]),
        (EnergyTerm::Weight, falling),
        (EnergyTerm::RotorFriction, heat),
        (
            EnergyTerm::RotorDamping,
            contact.contact.damping_power + s.rotor.face.damping_power,
        ),
        (
            EnergyTerm::SupportDamping,
            outer_ring.damping_power(&outer) + outer_ring.damping * outer_vz * outer_vz,
        ),
    ] {
        dydt[layout.energy_term(term)] += power;
    }
    dydt[layout.energy_term(EnergyTerm::Drive)] = match body.guide {
        None => body.drive_torque * speed,
        Some(_) => {
            -(loads.x * rotor[0] + loads.y * rotor[1] + loads.z * rotor[2] + loads[3] * speed)
        }
    };
}

/// Adds to the state and the rates what the friction of the balls does to rotor and rings over the step,
/// then the friction of the rotor itself.
#[inline(never)] // once for all instruction sets
pub(super) fn add_rotor_friction(
    (p, model, space): (&Parameters, &Model, &SpaceModel),
    (w, s): (&mut Workspace, &mut SpaceWorkspace),
    totals: &Totals,
    (h_s, y0): (f64, &[f64]),
    y: &mut [f64],
    dydt: &mut [f64],
) {
    let (Some((body, outer_ring)), Some(along_axis)) = (p.drops.first(), &space.rotor) else {
        return;
    };
    let layout = model.layout;
    let [_, moment] = totals.on_ring();
    let turning = moment.dot(&s.ring.axis) / body.ring_inertia;
    let [ox, oy, _] = totals.outer_ring.map(|f| f * outer_ring.inverse_mass);
    let oz = totals.outer_ring[2] * space.housing_inverse_mass;
    let mut add = |place: usize, rate: f64| {
        dydt[place] += rate;
        y[place] += h_s * rate;
    };
    for (coordinate, rate) in [
        (DropCoordinate::RingSpeed, turning),
        (DropCoordinate::OuterVx, ox),
        (DropCoordinate::OuterVy, oy),
        (DropCoordinate::OuterVz, oz),
    ] {
        add(layout.drop(coordinate), rate);
    }
    let contact = w.rotors[0];
    let step = (h_s, s.known);
    let bodies = (body, along_axis, model.ring.mass);
    let (loads, heat, [friction, slip]) =
        (s.rotor).implicit_friction(bodies, &contact, step, layout, [y0, y]);
    w.rotors[0].friction = friction;
    w.rotors[0].contact.slip = slip;
    let heat = (layout.energy_term(EnergyTerm::RotorFriction), heat);
    for (place, rate) in rates_by(model, (body, along_axis), contact.offset, &loads)
        .into_iter()
        .chain([heat])
    {
        dydt[place] += rate;
        y[place] += h_s * rate;
    }
}

/// Kinetic energy of rotor, turning inner ring and housing along the axis, and what is stored there, J.
pub(super) fn energy_along_axis_j(
    model: &Model,
    (space, along_axis): (&SpaceModel, &RotorAlongAxis),
    layout: Layout,
    y: &[f64],
) -> f64 {
    let Some(body) = &model.rotor else {
        return 0.0;
    };
    let [outer_z, outer_vz] = layout.outer_ring_along_axis(y);
    let vz = y[layout.drop(DropCoordinate::RotorVz)];
    let z = y[layout.drop(DropCoordinate::RotorZ)] - y[layout.ring(RingCoordinate::Z)];
    let faces = along_axis.faces.map_or(0.0, |[clearance, _]| {
        journal_energy_j(&body.journal, z.abs() - clearance)
    });
    let (mass, stiffness) = (space.housing_mass, model.outer_ring.stiffness);
    0.5 * body.mass * vz * vz
        + faces
        + 0.5 * mass * outer_vz * outer_vz
        + 0.5 * stiffness * outer_z * outer_z
}

/// Rates of the velocities of rotor, inner ring and its speed under loads of their contact.
fn rates_by(
    model: &Model,
    (body, along_axis): (&RotorBody, &RotorAlongAxis),
    [ex, ey]: [f64; 2],
    loads: &Loads,
) -> [(usize, f64); 8] {
    let (layout, ring) = (model.layout, model.ring.mass);
    // The moment about the mass centre: that about the journal less offset × force.
    let moment = loads[3] + ey * loads.x - ex * loads.y;
    let [ax, ay, spin] = body.response([loads.x, loads.y], moment);
    let of_drop = |coordinate, rate| (layout.drop(coordinate), rate);
    let of_ring = |coordinate, rate| (layout.ring(coordinate), rate);
    [
        of_drop(DropCoordinate::RotorVx, ax),
        of_drop(DropCoordinate::RotorVy, ay),
        of_drop(DropCoordinate::RotorVz, loads.z / along_axis.mass),
        of_drop(DropCoordinate::RotorSpeed, spin),
        of_drop(DropCoordinate::RingSpeed, loads[4] / body.ring_inertia),
        of_ring(RingCoordinate::Vx, -loads.x / ring),
        of_ring(RingCoordinate::Vy, -loads.y / ring),
        of_ring(RingCoordinate::Vz, -loads.z / ring),
    ]
}
