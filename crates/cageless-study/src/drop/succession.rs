//! Drops one after the other, with the heat of those before.

use cageless::simulation::{Ending, RotorDrop};
use cageless::touchdown::{PARTS, SpinDown};
use cageless_io::case_file::CaseError;
use cageless_io::plan_file::VariantFile;
use cageless_results::{DropJudgement, Record, SuccessiveDrop, succession_record};

use super::DropRecord;
use crate::StudyError;
use crate::progress::Progress;

/// Drops one after the other: a record for each drop and bearing, in this order.
#[derive(Default)]
pub struct Succession {
    /// The records.
    pub records: Vec<Record>,
    /// Verdict on the first drop, its planes included.
    earliest: DropJudgement,
    /// Verdicts on the drops after the first, on one that did not complete as well.
    pub later: Vec<DropJudgement>,
    /// Why there are fewer drops than were asked for.
    pub cut_short: Option<String>,
    /// Whether the progress cancelled it.
    pub interrupted: bool,
}

/// Temperatures of the parts that warm: results, and keys of `[fit]`.
const TEMPERATURES: [&str; PARTS] = [
    "inner_ring_temperature_c",
    "ball_temperature_c",
    "outer_ring_temperature_c",
];
/// Results of the temperatures at standstill, and the parts.
const STANDSTILL: [(&str, &str); PARTS] = [
    ("inner_ring_standstill_c", "the inner ring"),
    ("ball_standstill_c", "the balls"),
    ("outer_ring_standstill_c", "the outer ring"),
];
/// Temperature above which bearing steel softens, °C: 100Cr6 is tempered at 150 to 200 °C (ISO 683-17).
const SOFTENING_C: f64 = 200.0;
/// Powers that warm them at the end of a drop.
const POWERS: [&str; PARTS] = ["inner_ring_power_w", "ball_power_w", "outer_ring_power_w"];
/// Key of the touch-down clearance.
const CLEARANCE: &str = "rotor.radial_clearance_um";

impl Succession {
    /// The rotor of `file` dropped `count` times, the first time as in `first`. After each drop it spins
    /// down to standstill; the bearing keeps the heat of both except what it loses in the pause, and
    /// drops again with the clearances of its temperatures.
    ///
    /// # Errors
    /// A bearing cannot start.
    pub fn new(
        file: &VariantFile,
        drop: &RotorDrop,
        first: &mut DropRecord,
        count: u64,
        progress: &dyn Progress,
    ) -> Result<Self, StudyError> {
        let mut done = Self::default();
        let mut warm_c = done.add(drop, first);
        done.earliest = first.judgement();
        let mut spun_up = has_spun_up(first);
        for number in 2..=count {
            let warm = match &warm_c {
                Some(warm_c) => warmed(file, drop, warm_c),
                None => {
                    let reason = match spun_up {
                        false => {
                            "the inner ring has not come up to speed at its end, and what brakes \
                                  the rotor then is not what brakes it afterwards: simulate longer \
                                  (solver.duration_s)"
                        }
                        true => {
                            "the rotor does not come to rest, or rings and balls have no specific \
                                 heat (thermal.ring_specific_heat_j_kg_k, \
                                 thermal.ball_specific_heat_j_kg_k)"
                        }
                    };
                    let before = number - 1;
                    done.cut_short = Some(format!(
                        "drop {number} needs the temperatures after drop {before}: {reason}"
                    ));
                    break;
                }
            };
            let warm = match warm {
                Ok(warm) => warm,
                Err(error) => {
                    done.cut_short = Some(format!(
                        "drop {number} is not possible at the temperatures after drop {}: {}",
                        number - 1,
                        error.message()
                    ));
                    break;
                }
            };
            let Some(drop) = warm.drop() else { break };
            let none = drop.cases().iter().map(|_| None).collect();
            let mut record = DropRecord::of(&drop, none, progress)?;
            if matches!(record.ending(), Ending::Complete) {
                warm_c = done.add(&drop, &mut record);
                spun_up = has_spun_up(&record);
            }
            done.later.push(record.judgement());
            match record.ending() {
                Ending::Complete => {}
                Ending::Interrupted => {
                    done.interrupted = true;
                    break;
                }
                _ => {
                    let stopped = &record.bearings[record.last_index()].result.stopped;
                    let reason = stopped.as_ref().map(ToString::to_string);
                    let reason = reason.unwrap_or_default();
                    done.cut_short = Some(format!("drop {number} stopped {reason}"));
                    break;
                }
            }
        }
        Ok(done)
    }

    /// Adds a drop; returns the temperatures of each bearing at standstill.
    fn add(&mut self, drop: &RotorDrop, record: &mut DropRecord) -> Option<Vec<[f64; PARTS]>> {
        let number = 1 + self.records.len() / record.bearings.len();
        let spin_down = spin_down(drop, record);
        // A rotor makes all of its heat in all of its bearings.
        let bearings = record.bearings.iter();
        let power_w: f64 = bearings
            .filter_map(|b| b.result.results.value("end_power_w"))
            .sum();
        let results = record.bearings.iter_mut().map(|b| &mut b.result);
        let cases = drop.cases().iter().enumerate().zip(results);
        let ended: Vec<_> = cases
            .map(|((bearing, case), result)| {
                let standstill_c = spin_down.and_then(|spin_down| {
                    let capacities = case
                        .thermal
                        .capacities_j_k(&case.bearing, case.rows.len())
                        .ok()?;
                    let mut parts_c = [0.0; PARTS];
                    for (k, part_c) in parts_c.iter_mut().enumerate() {
                        // Of no heat at all a part has none.
                        let share =
                            result.results.value(POWERS[k])? / power_w.max(f64::MIN_POSITIVE);
                        let rise_k = share * spin_down.heat_j / capacities[k];
                        *part_c = result.results.value(TEMPERATURES[k])? + rise_k;
                    }
                    Some(parts_c)
                });
                let ended = SuccessiveDrop {
                    number,
                    bearing,
                    case,
                    heat_j: result.results.number("dissipated_j"),
                    spin_down,
                    standstill_c,
                    judgement: DropJudgement::default(),
                };
                self.records.push(succession_record(ended, result));
                standstill_c
            })
            .collect();
        ended.into_iter().collect()
    }

    /// Warning of the first drop after which a part is too hot for bearing steel.
    pub fn overheated(&self) -> Option<String> {
        self.records.iter().find_map(|record| {
            let parts = STANDSTILL
                .iter()
                .filter_map(|(key, part)| Some((part, record.value(key)?)));
            let (part, hottest_c) = parts.max_by(|a, b| a.1.total_cmp(&b.1))?;
            (hottest_c > SOFTENING_C).then(|| {
                format!(
                    "after drop {} {part} would be at {hottest_c:.0} °C with all heat kept: bearing steel \
                     softens above {SOFTENING_C} °C (100Cr6, ISO 683-17), and what follows are numbers of \
                     parts that would have failed",
                    record.number("drop")
                )
            })
        })
    }

    /// The first drop with this verdict, with the reasons.
    pub fn first(&self, verdict: &str) -> Option<(usize, String)> {
        let all = std::iter::once(&self.earliest).chain(&self.later);
        // Without a row there are no drops in succession.
        let judged = (1..).zip(all).filter(|_| !self.records.is_empty());
        let mut found = judged.filter(|(_, judgement)| judgement.name() == verdict);
        found
            .next()
            .map(|(number, judgement)| (number, judgement.reasons().join("; ")))
    }
}

/// Whether every inner ring has come up to the speed of the rotor.
fn has_spun_up(record: &DropRecord) -> bool {
    let mut bearings = record.bearings.iter();
    bearings.all(|bearing| bearing.result.results.value("spin_up_ms").is_some())
}

/// Spin-down of the rotor after a drop; `None` where it does not come to rest, or where an inner ring
/// still slides on it at the end of the drop. A slow one stands at once.
fn spin_down(drop: &RotorDrop, record: &DropRecord) -> Option<SpinDown> {
    let all = |name: &str| -> Option<Vec<f64>> {
        let bearings = record.bearings.iter();
        bearings.map(|b| b.result.results.value(name)).collect()
    };
    let rotor = drop.cases()[0].rotor.as_ref()?;
    let (inertia_kg_m2, speed_rad_s) = (
        rotor.polar_inertia_kg_m2,
        record.bearings[0].outcome.state.rotor_motion()?.speed,
    );
    let drive_n_m = -rotor.drive_torque_n_m * speed_rad_s.signum();
    all("end_power_w")?;
    let Some(torques_n_m) = all("braking_torque_n_m") else {
        return (drive_n_m >= 0.0).then_some(SpinDown {
            time_s: 0.0,
            heat_j: 0.5 * inertia_kg_m2 * speed_rad_s * speed_rad_s,
        });
    };
    let contacts_n_m = torques_n_m.iter().sum();
    has_spun_up(record)
        .then(|| SpinDown::new(inertia_kg_m2, speed_rad_s, contacts_n_m, drive_n_m))
        .flatten()
}

/// The file with the temperatures at which its bearings are after the pause, and what they make of the
/// touch-down clearances.
fn warmed(
    file: &VariantFile,
    drop: &RotorDrop,
    standstill_c: &[[f64; PARTS]],
) -> Result<VariantFile, CaseError> {
    let prefix = |k: usize| match drop.rotor() {
        None => String::new(),
        Some(_) => format!("bearing.{}.", k + 1),
    };
    let cases = || drop.cases().iter().enumerate();
    let start_c: Vec<_> = cases()
        .map(|(k, case)| case.thermal.after_pause_c(standstill_c[k], case.parts_c()))
        .collect();
    let temperatures = cases().flat_map(|(k, _)| {
        let parts = TEMPERATURES.iter().zip(start_c[k]);
        parts.map(move |(key, part_c)| format!("{}fit.{key}={part_c:?}", prefix(k)))
    });
    let warm = file.changed(&temperatures.collect::<Vec<_>>())?;
    // The bore grows with the inner ring; the rotor stays as it is.
    let clearances = cases().filter_map(|(k, case)| {
        let fit = warm.cases()[k].case().fit?;
        let (rotor, bore) = (case.rotor.as_ref()?, case.bearing.inner_ring_bore()?);
        let rise_k = start_c[k][0] - case.parts_c()[0];
        let growth_m = bore.radius_m * fit.ring_expansion_per_k * rise_k;
        let cold_um = warm.cases()[k].document().number(CLEARANCE)?;
        let clearance_um = cold_um * (1.0 + growth_m / rotor.radial_clearance_m);
        Some(format!("{}{CLEARANCE}={clearance_um:?}", prefix(k)))
    });
    warm.changed(&clearances.collect::<Vec<_>>())
}
