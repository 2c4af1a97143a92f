//! Films of the contacts as friction has them, each under its own load at its own angle.
//!
//! Set with the knees of the law from the last evaluation, and frozen over a step.

use super::block::{INNER, SpaceBlock};
use super::creep::rolling_m_s;
use crate::ball::PolarMotionLanes;
use crate::contact::FilmTractionLanes;
use crate::contact::creep::LEAST_SPEED_SQUARE;
use crate::film::{GrooveFilms, SlotEdge};
use crate::numerics::lanes::LANES;

/// Sets the films of a block.
#[inline(always)]
pub(super) fn set_films(
    [at_outer, at_inner]: &[GrooveFilms; 2],
    polar: &PolarMotionLanes,
    b: &mut SpaceBlock,
) {
    for &place in b.places {
        let rolling = rolling_m_s(polar, b, place);
        let mut films = FilmTractionLanes::ZERO;
        for lane in 0..LANES {
            let load = b.frames[place].force_n.0[lane];
            // Padding has no place.
            if load <= 0.0 {
                continue;
            }
            let square = rolling.0[lane] * rolling.0[lane] + LEAST_SPEED_SQUARE;
            let film = match place {
                INNER => at_inner.at(load, square, inner_curvature(b, lane)),
                _ => (on_edge(b, lane))
                    .and_then(|edge| at_outer.at_edge(load, square, edge))
                    .unwrap_or_else(|| {
                        at_outer.at(load, square, outer_curvature(polar, b, place, lane))
                    }),
            };
            films.put(lane, film);
        }
        b.films[place] = films;
    }
}

/// cos α over the distance of the contact from the axis of the outer ring, 1/m.
#[inline(always)]
fn outer_curvature(polar: &PolarMotionLanes, b: &SpaceBlock, place: usize, lane: usize) -> f64 {
    let cosine = [&b.outer.radial_0, &b.outer.radial_1][place].0[lane];
    cosine / (polar.distance.0[lane] + cosine / b.inverse_radius.0[lane])
}

/// cos α over the distance of the contact from the axis of the inner ring, 1/m.
#[inline(always)]
fn inner_curvature(b: &SpaceBlock, lane: usize) -> f64 {
    let (groove, cosine) = (b.inner_groove.get(lane), b.inner.cosine.0[lane]);
    cosine / (groove.centre - cosine * groove.curvature)
}

/// Edge of a slot that a ball touches.
#[inline(always)]
fn on_edge(b: &SpaceBlock, lane: usize) -> Option<SlotEdge> {
    let slot = (b.outer.slot.0[lane] as usize).checked_sub(1)?;
    let merged = b.outer.merged.0[lane];
    Some(SlotEdge { slot, merged })
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::super::bearing::{Bearing, Drive};
    use super::super::workspace::SpaceWorkspace;
    use super::super::{Vector, evaluate};
    use super::*;
    use crate::case::Case;
    use crate::common::slotted;
    use crate::contact::FilmTraction;
    use crate::dynamics::coordinates::{BallCoordinate, RingCoordinate};
    use crate::dynamics::model::Model;
    use crate::film::{Film, LubricatedContact, Oil, Rolling, Traction};
    use crate::initial_conditions::initial_state;
    use crate::reference::Structure;
    use crate::simd::{Parameters, Workspace};

    /// Film of a contact by the formulas.
    fn expected(case: &Case, contact: &LubricatedContact, at: Rolling) -> FilmTraction {
        let film = case.film.as_ref().unwrap();
        let h = contact.film_thickness(&film.oil, at).central_m;
        let share = (-2.1 * (h / film.roughness_m).powf(0.85)).exp();
        let area = PI * contact.cross_axis_m(at.load_n).powi(2) * contact.axis_ratio;
        let stiff = film.oil.viscosity_pa_s.ln() + 9.67;
        let z = film.oil.pressure_viscosity_1_pa / (5.1e-9 * stiff);
        let power = (1.0 + 5.1e-9 * at.load_n / area).powf(z) - 1.0;
        let viscous = h / (film.oil.viscosity_pa_s * (stiff * power).exp());
        let creep = crate::contact::creep::creep_coefficient(contact.axis_ratio, 0.3);
        let shear_pa = 206e9 / 2.6;
        let limit = film.traction_coefficient * at.load_n;
        FilmTraction {
            asperity_share: share,
            limit: (1.0 - share) * limit,
            stress_ratio: 5e6 * area / limit,
            inverse_speed: 1.0 / (5e6 * viscous + PI * 5e6 * at.speed_m_s / (shear_pa * creep)),
        }
    }

    /// Contact of ball `k` at a place, from where the ball is in the ring and the normal: the ring curves by cos α over
    /// the distance of the contact from its axis, and at the edge of a slot as the slot does.
    fn contact_of(
        case: &Case,
        b: &SpaceBlock,
        place: usize,
        k: usize,
        along: [Vector; 2],
    ) -> LubricatedContact {
        let bearing = &case.bearing;
        let [ball, normal] = along;
        let radial = Vector::new(ball.x, ball.y, 0.0).normalize();
        let point = ball + normal * bearing.ball_radius_m();
        let cosine = normal.dot(&radial).abs();
        let curvature = cosine / point.xy().norm();
        match (place, on_edge(b, k)) {
            (INNER, _) => LubricatedContact::inner_curved(bearing, curvature),
            (_, Some(edge)) => {
                let slot = case.raceways[edge.slot].slot().unwrap();
                LubricatedContact::of_ring(bearing, slot.merged_curvatures_per_m(edge.merged))
            }
            _ => LubricatedContact::outer_curved(bearing, curvature),
        }
    }

    /// Under an axial load, on flanks and at the edges of a slot each contact has the film of its own load, speed and
    /// angle.
    #[test]
    fn each_contact_has_the_film_of_its_angle() {
        let mut counts = [0; 4];
        for mut case in [Structure::D.case(), slotted()] {
            case.operation.space.axial_load_n = 1500.0;
            case.film = Some(Film {
                traction: Traction::Film,
                ..Film::flooded(Oil::mineral(2e-3, 0.035))
            });
            let (state, _) = initial_state(&case).unwrap();
            let (layout, mut y) = (state.layout(), state.values().to_vec());
            y[layout.ring(RingCoordinate::Vx)] = 0.2;
            for k in 0..case.balls() {
                y[layout.ball(BallCoordinate::Spin, k)] *= 1.02;
            }
            let models = vec![Model::new(&case).unwrap()];
            let parameters = Parameters::new(&models, layout);
            let space = models[0].space.as_ref().unwrap();
            let mut w = Workspace::new(&parameters, case.formulation);
            let mut s = SpaceWorkspace::new(&models[0], space);
            let drive = Drive {
                inner_speed: case.operation.inner_speed_rad_s,
                radial_load: case.operation.radial_load_n,
                unbalance: [0.0; 2],
            };
            let bearing = Bearing {
                parameters: &parameters,
                model: &models[0],
                space,
                drive,
            };
            let mut rates = vec![0.0; y.len()];
            evaluate(bearing, &mut w, &mut s, &y, &mut rates, true);
            let b = &s.blocks[0];
            for k in 0..case.balls() {
                let [ball, velocity, rotation] =
                    super::super::evaluation::ball_motion(layout, &y, k);
                for &place in b.places {
                    let frame = b.frames[place].get(k);
                    if frame.force_n <= 0.0 {
                        continue;
                    }
                    let normal = Vector::new(frame.normal_x, frame.normal_y, frame.normal_z);
                    let along = Vector::new(frame.along_x, frame.along_y, frame.along_z);
                    let from_ring = ball
                        - if place == INNER {
                            s.ring.centre
                        } else {
                            Vector::zeros()
                        };
                    let reach = normal * case.bearing.ball_radius_m();
                    let arm = Vector::new(frame.arm_x, frame.arm_y, frame.arm_z);
                    let ring = match place {
                        INNER => s.ring.velocity + s.ring.rotation.cross(&arm),
                        _ => Vector::zeros(),
                    };
                    let touched = ball + reach;
                    let carried = along.dot(&velocity) * touched.xy().norm() / ball.xy().norm();
                    let surfaces = velocity + rotation.cross(&reach) + ring;
                    let speed_m_s = 0.5 * along.dot(&surfaces) - carried;
                    let contact = contact_of(&case, b, place, k, [from_ring, normal]);
                    let at = Rolling {
                        load_n: frame.force_n,
                        speed_m_s: speed_m_s.abs(),
                    };
                    let (found, expected) = (b.films[place].get(k), expected(&case, &contact, at));
                    for (a, b) in [
                        (found.asperity_share, expected.asperity_share),
                        (found.limit, expected.limit),
                        (found.stress_ratio, expected.stress_ratio),
                        (found.inverse_speed, expected.inverse_speed),
                    ] {
                        assert!(
                            (a / b - 1.0).abs() < 3e-3,
                            "{place} {k}: {found:?} {expected:?}"
                        );
                    }
                    counts[place] += 1;
                    counts[3] += usize::from(place != INNER && on_edge(b, k).is_some());
                }
            }
        }
        assert!(counts.iter().all(|count| *count > 0), "{counts:?}");
    }
}
