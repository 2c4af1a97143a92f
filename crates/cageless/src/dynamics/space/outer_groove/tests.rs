//! Contacts with the outer ring against the section in equilibrium and differences of the energy.

use super::*;
use crate::common::{slotted, structure};
use crate::equilibrium::space::outer_section::{Flanks, OuterSection};
use crate::numerics::taylor::Taylor;

/// The flanks at ψ, not mirrored.
fn here(model: &FlankModel, psi: f64) -> Option<FlanksHere> {
    model.at(model.within(direction(psi))?, 1.0)
}

/// Along a slot of 1.9 mm and its run-out, on one edge and on both, for balls of two sizes: approach,
/// shares and normals are those of the section in equilibrium; the slopes of the energy over ρ, ζ and
/// ψ those that the forces take.
#[test]
fn contacts_at_the_edges_of_a_slot_have_an_energy() {
    let case = slotted();
    let raceway = case.raceways[0].clone().with_depth_error(1e-6).unwrap();
    let raceway = raceway.with_section_angle(0.05, &case.bearing).unwrap();
    let pieces = raceway.pieces().iter();
    let models: Vec<FlankModel> = pieces.map(|p| FlankModel::new(&raceway, 0, p)).collect();
    assert_eq!(models.len(), 2);
    let d = case.bearing.dimensions();
    let nominal_gap = d.outer_groove_curvature_radius_m - d.ball_radius_m;
    let mut merging = 0;
    for gap in [nominal_gap, nominal_gap - 2e-6] {
        let groove = OuterGroove {
            gap,
            nominal_gap,
            axial: 3e-6,
        };
        for psi in [0.05, -0.32, -0.36, 0.39, 0.415, 0.43, -0.4395] {
            let slot = raceway.slot().unwrap().at(psi);
            merging += usize::from(slot.stiffness_ratio[1] != 0.0);
            for place in [[6e-6, 0.0], [6e-6, 3e-6], [8e-6, -30e-6], [5e-6, 60e-6]] {
                let place = [place[0] + slot.sink_m[0], place[1] + 2e-5];
                let at = |psi: f64, place: [f64; 2]| {
                    let flanks = models.iter().find_map(|m| here(m, psi)).unwrap();
                    groove.touch_flanks(place[0], place[1], &flanks)
                };
                let energy = |psi: f64, place: [f64; 2]| {
                    let touch = at(psi, place);
                    1e11 * touch.stiffness * touch.approach.max(0.0).powf(2.5)
                };
                let touch = at(psi, place);
                let section = OuterSection {
                    gap_m: gap,
                    axial_m: 3e-6,
                    flanks: Some(Flanks {
                        angle_rad: slot.angle_rad[0],
                        section_angle_rad: 0.05,
                        nominal_gap_m: nominal_gap,
                        depth_error_m: raceway.depth_error_at_m(psi),
                        depth_m: slot.sink_m[0],
                        slot: Some(slot),
                    }),
                };
                let variables = Taylor::variables([place[0], place[1], slot.angle_rad[0]]);
                let [u, z, angle] = variables;
                let exact = section
                    .approach(
                        SectionVector {
                            radial: u,
                            axial: z,
                        },
                        angle,
                    )
                    .unwrap();
                assert!((touch.approach - exact.value).abs() < 1e-15);
                let pressed = touch.resultant();
                for (part, known) in [pressed.radial, pressed.axial].iter().zip(exact.gradient) {
                    assert!((part - known).abs() < 1e-9);
                }
                let contacts = section.contacts(SectionVector {
                    radial: place[0],
                    axial: place[1],
                });
                let sum: f64 = contacts.iter().map(|contact| contact.share).sum();
                assert!((sum - touch.share_0 - touch.share_1).abs() < 1e-9);
                let force = 2.5e11 * touch.stiffness * touch.approach.powf(1.5);
                let stiffening = 1e11 * touch.stiffening * touch.approach.powf(2.5);
                let SectionVector { radial, axial } = touch.resultant();
                let of = |value: f64, plus: f64, minus: f64, h: f64| {
                    let slope = (plus - minus) / (2.0 * h);
                    let error = (value - slope).abs();
                    assert!(
                        error < 2e-6 * force.max(value.abs()),
                        "{psi} {place:?} {value} {slope}"
                    );
                };
                let [u, z] = place;
                let h = 1e-10;
                of(
                    force * radial,
                    energy(psi, [u + h, z]),
                    energy(psi, [u - h, z]),
                    h,
                );
                of(
                    force * axial,
                    energy(psi, [u, z + h]),
                    energy(psi, [u, z - h]),
                    h,
                );
                let h = 1e-8;
                // A scale of force by length.
                let turning = (force * touch.slope + stiffening) / d.ball_radius_m;
                let around = |psi: f64| energy(psi, place) / d.ball_radius_m;
                of(turning, around(psi + h), around(psi - h), h);
            }
        }
    }
    assert!(merging == 10, "{merging}");
}

fn direction(psi: f64) -> PlaneVector {
    PlaneVector {
        x: psi.sin(),
        y: -psi.cos(),
    }
}

/// Over the whole raceway, on one flank and on both: approach and shares are those of the section
/// in equilibrium, the normals its gradient, the slope the derivative over ψ.
#[test]
fn contacts_are_those_of_the_section() {
    let case = structure(5.1, 25.2);
    for (turned, error, depth) in [
        (0.0, 0.0, 0.0),
        (0.1, 0.0, 0.0),
        (0.0, 2e-6, 0.0),
        (0.1, 1e-6, 3e-6),
    ] {
        let raceway = case.raceways[0].clone().with_depth_error(error).unwrap();
        let raceway = raceway.with_depth(depth).unwrap();
        let raceway = raceway.with_section_angle(turned, &case.bearing).unwrap();
        let model = FlankModel::new(&raceway, 0, &raceway.pieces()[0]);
        let d = case.bearing.dimensions();
        let gap = d.outer_groove_curvature_radius_m - d.ball_radius_m;
        let groove = OuterGroove {
            gap,
            nominal_gap: gap,
            axial: 0.0,
        };
        for psi in [-0.43, -0.3, 0.02, 0.2, 0.4395] {
            let [flank, slope] = raceway.contact_angle_rad(psi);
            for place in [[6e-6, 0.0], [6e-6, 3e-6], [8e-6, -30e-6], [5e-6, 80e-6]] {
                let at = |psi: f64, place: [f64; 2]| match here(&model, psi) {
                    Some(flanks) => groove.touch_flanks(place[0], place[1], &flanks),
                    None => groove.touch(place[0], place[1]),
                };
                let touch = at(psi, place);
                let section = OuterSection {
                    gap_m: gap,
                    axial_m: 0.0,
                    flanks: Some(Flanks {
                        angle_rad: flank,
                        section_angle_rad: turned,
                        nominal_gap_m: gap,
                        depth_error_m: raceway.depth_error_at_m(psi),
                        depth_m: raceway.depth_at_m(psi)[0],
                        slot: None,
                    }),
                };
                let [u, z, angle] = Taylor::variables([place[0], place[1], flank]);
                let Some(exact) = section.approach(
                    SectionVector {
                        radial: u,
                        axial: z,
                    },
                    angle,
                ) else {
                    assert!(touch.approach <= 0.0);
                    continue;
                };
                assert!(
                    (touch.approach - exact.value).abs() < 1e-15,
                    "{psi} {place:?}"
                );
                let pressed = touch.resultant();
                for (found, known) in [pressed.radial, pressed.axial].iter().zip(exact.gradient) {
                    assert!((found - known).abs() < 1e-9, "{psi} {place:?}");
                }
                let h = 1e-6;
                let across =
                    (at(psi + h, place).approach - at(psi - h, place).approach) / (2.0 * h);
                assert!(
                    (touch.slope - across).abs() < 1e-9,
                    "{psi} {place:?} {} {across}",
                    touch.slope
                );
                if [error, depth] == [0.0; 2] {
                    assert!((touch.slope - exact.gradient[2] * slope).abs() < 1e-12);
                }
            }
        }
    }
}
