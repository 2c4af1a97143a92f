//! Standstill of the rotor after a drop.

use cageless::Case;
use cageless::rating::rolling_torque_n_m;
use cageless::simulation::RotorDrop;
use cageless::touchdown::{Brake, EndPower, LAST, PARTS, SpinDown};
use cageless_results::number_text::short;
use cageless_results::{DropResult, bearing_number, on_bearing};

use super::DropRecord;

/// The standstill of the rotor, and the heat of its spin-down.
pub(super) struct Standstill {
    /// Time to it from the end of the drop.
    pub time_s: f64,
    /// Heat of each bearing.
    pub bearings: Vec<SpinDownHeat>,
    /// Warnings on the estimate.
    pub warnings: Vec<String>,
}

/// Heat of a bearing in the spin-down.
pub(super) struct SpinDownHeat {
    /// Heat of all its interfaces, J.
    pub heat_j: f64,
    /// Shares that warm inner ring, balls and outer ring.
    pub shares: [f64; PARTS],
}

/// Change of the braking torque within the last fifth, relative, from which it is not steady.
const UNSTEADY: f64 = 0.2;
/// Deviation of the speed of an inner ring from that of rolling, relative, beyond which it slides.
const SLIDES: f64 = 0.02;

impl Standstill {
    /// The standstill after a drop.
    ///
    /// # Errors
    /// A reason why there is no estimate: the rotor does not come to rest, or an inner ring still slides on
    /// it at the end of the drop.
    pub fn after(drop: &RotorDrop, record: &DropRecord) -> Result<Self, String> {
        let ends = record.bearings.iter().map(|b| b.result.end_power);
        let ends: Option<Vec<EndPower>> = ends.collect();
        let speed_rad_s = record.bearings[0].outcome.state.rotor_speed_rad_s();
        let rotor = drop.cases()[0].rotor.as_ref();
        let (Some(ends), Some(speed_rad_s), Some(rotor)) = (ends, speed_rad_s, rotor) else {
            return Err("the rotor has not touched every inner ring".to_owned());
        };
        let driven = || "the drive turns the rotor on, which does not come to rest".to_owned();
        let inertia_kg_m2 = rotor.polar_inertia_kg_m2;
        let drive_n_m = -rotor.drive_torque_n_m * speed_rad_s.signum();
        // A slow one stands at once.
        if ends.iter().any(|end| end.torque_n_m.is_none()) {
            let energy_j = 0.5 * inertia_kg_m2 * speed_rad_s * speed_rad_s;
            return match drive_n_m >= 0.0 {
                true => Ok(Self::at_once(energy_j, &ends)),
                false => Err(driven()),
            };
        }
        for (k, (case, bearing)) in drop.cases().iter().zip(&record.bearings).enumerate() {
            if let Some(reason) = slides(case, &bearing.result) {
                return Err(match bearing_number(k, ends.len()) {
                    None => reason,
                    Some(number) => format!("in bearing {number}, {reason}"),
                });
            }
        }
        let brakes = drop.cases().iter().zip(drop.carried_n()).zip(&ends);
        let mut warnings = vec![];
        let brakes = brakes.enumerate().map(|(k, ((case, carried_n), end))| {
            let rolling_n_m = rolling_torque_n_m(&case.bearing, carried_n.unwrap_or(0.0));
            let doubt = unsteady(end, rolling_n_m);
            warnings.extend(doubt.map(|text| on_bearing(k, ends.len(), &text)));
            Brake::new(end, rolling_n_m).ok_or_else(driven)
        });
        let brakes = brakes.collect::<Result<Vec<_>, _>>()?;
        let spin_down = SpinDown::new(inertia_kg_m2, speed_rad_s, &brakes, drive_n_m);
        let spin_down = spin_down.ok_or_else(driven)?;
        let heats = brakes.iter().zip(spin_down.heat_j);
        let heats = heats.map(|(brake, heat_j)| SpinDownHeat {
            heat_j,
            shares: brake.shares,
        });
        Ok(Self {
            time_s: spin_down.time_s,
            bearings: heats.collect(),
            warnings,
        })
    }

    /// All of the energy at once, shared as the power at the end.
    fn at_once(energy_j: f64, ends: &[EndPower]) -> Self {
        let power_w: f64 = ends.iter().map(|end| end.total_w).sum();
        // Of no heat at all a part has none.
        let of = |part_w: f64, all_w: f64| part_w / all_w.max(f64::MIN_POSITIVE);
        let bearings = ends.iter().map(|end| SpinDownHeat {
            heat_j: energy_j * of(end.total_w, power_w),
            shares: end.parts_w.map(|part_w| of(part_w, end.total_w)),
        });
        Self {
            time_s: 0.0,
            bearings: bearings.collect(),
            warnings: vec![],
        }
    }
}

/// Warning on a bearing whose own torque brakes the rotor and still changes at the end of a drop.
fn unsteady(end: &EndPower, rolling_n_m: f64) -> Option<String> {
    let torque_n_m = end.torque_n_m.filter(|own_n_m| *own_n_m > rolling_n_m)?;
    let change = end.torque_change.filter(|change| change.abs() > UNSTEADY)?;
    Some(format!(
        "the torque of {} N·mm that brakes the rotor still {} at the end of the drop, by {:.0} % within the last fifth: \
         the heat of the spin-down follows from it and is an estimate; simulate longer (solver.duration_s)",
        short(1e3 * torque_n_m),
        if change > 0.0 { "grows" } else { "falls" },
        100.0 * change.abs()
    ))
}

/// Whether the inner ring has come up to the speed of the rotor.
pub(super) fn spun_up(result: &DropResult) -> bool {
    result.results.value("spin_up_ms").is_some()
}

/// Why the torque at the end of a drop is not that of a ring which rolls with the rotor.
fn slides(case: &Case, result: &DropResult) -> Option<String> {
    const LONGER: &str = "simulate longer (solver.duration_s)";
    let value = |name: &str| result.results.value(name).unwrap_or(f64::NAN);
    let [ring, rotor] = ["ring_speed_rpm", "rotor_speed_rpm"].map(value);
    let journal = case.rotor.as_ref()?.radial_clearance_m;
    // Between the speeds of a face and of a bore.
    let rolling = journal / case.bearing.inner_ring_bore()?.radius_m + SLIDES;
    if !spun_up(result) || (ring / rotor - 1.0).abs() > rolling {
        return Some(format!(
            "the inner ring has not come up to speed at its end, and what brakes the rotor then is not \
             what brakes it afterwards: {LONGER}"
        ));
    }
    let [contact_ms, spin_up_ms] = ["first_contact_ms", "spin_up_ms"].map(value);
    let end_ms = 1e3 * value("simulated_s");
    (spin_up_ms > end_ms - LAST * (end_ms - contact_ms)).then(|| {
        format!(
            "the inner ring came up to speed after {} of {} ms, within the last fifth, whose torque \
             brakes the rotor afterwards: {LONGER}",
            short(spin_up_ms),
            short(end_ms)
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A torque that changes by more than a fifth is doubtful, unless rolling brakes more.
    #[test]
    fn a_torque_that_still_changes_is_said_to() {
        let end = |torque_change: f64| EndPower {
            total_w: 30.0,
            parts_w: [10.0; PARTS],
            torque_n_m: Some(0.03),
            torque_change: Some(torque_change),
        };
        assert_eq!(unsteady(&end(0.19), 0.01), None);
        assert_eq!(unsteady(&end(-0.5), 0.04), None);
        let falls = unsteady(&end(-0.5), 0.01).unwrap();
        assert!(
            falls.contains(
                "30 N·mm that brakes the rotor still falls at the end of the drop, by 50 %"
            ),
            "{falls}"
        );
        assert!(unsteady(&end(0.21), 0.01).unwrap().contains("still grows"));
    }
}
