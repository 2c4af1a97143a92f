//! Drops one after the other, with the heat of those before.

use cageless::simulation::{Ending, RotorDrop};
use cageless::touchdown::PARTS;
use cageless_io::arrangement::BearingArrangement;
use cageless_io::case_file::{CaseError, CaseFile};
use cageless_results::number_text::short;
use cageless_results::{
    DropJudgement, Quantity, Record, SuccessiveDrop, succession_record, table_of,
};

use super::length::um;
use super::standstill::{Standstill, spun_up};
use super::{DropRecord, FiledDrop};
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
    /// The heat that leaves the bearing no clearance for another drop.
    pub runaway: Option<String>,
    /// Doubts about the heat of a spin-down, by its drop.
    pub doubts: Vec<String>,
    /// Why the last drop has no temperatures at standstill.
    pub without_standstill: Option<String>,
    /// Whether the progress cancelled it.
    pub interrupted: bool,
}

/// Temperatures of the parts that warm: results, and keys of `[fit]`.
const TEMPERATURES: [&str; PARTS] = [
    "inner_ring_temperature_c",
    "ball_temperature_c",
    "outer_ring_temperature_c",
];
/// The parts.
const NAMES: [&str; PARTS] = ["inner ring", "balls", "outer ring"];
/// Key of the touch-down clearance.
const CLEARANCE: &str = "rotor.radial_clearance_um";

/// Temperatures of each bearing at standstill, or why there are none.
type Warm = Result<Vec<[f64; PARTS]>, String>;

impl Succession {
    /// The rotor of `file` dropped `count` times, the first time as in `first`. After each drop it spins
    /// down to standstill; the bearing keeps the heat of both except what it loses in the pause, and
    /// drops again with the clearances of its temperatures.
    ///
    /// # Errors
    /// A bearing cannot start.
    pub fn new(
        file: &BearingArrangement,
        filed: &FiledDrop<'_>,
        first: &mut DropRecord,
        count: u64,
        progress: &dyn Progress,
    ) -> Result<Self, StudyError> {
        let mut done = Self::default();
        let mut warm = done.add(filed, first);
        done.earliest = first.judgement();
        for number in 2..=count {
            let warmed = match &warm {
                Ok(standstill_c) => warmed(file, filed, standstill_c),
                Err(reason) => {
                    let before = number - 1;
                    done.cut_short = Some(format!(
                        "drop {number} needs the temperatures after drop {before}: {reason}"
                    ));
                    return Ok(done);
                }
            };
            let warmed = match warmed {
                Ok(warmed) => warmed,
                Err(error) => {
                    let reason = format!(
                        "drop {number} is not possible at the temperatures after drop {}: {}",
                        number - 1,
                        error.message()
                    );
                    done.runaway = Some(format!("thermal runaway, {reason}"));
                    done.cut_short = Some(reason);
                    return Ok(done);
                }
            };
            let Some(drop) = warmed.drop().cloned() else {
                break;
            };
            let files = warmed.cases();
            let drop = FiledDrop { drop, files };
            let none = files.iter().map(|_| None).collect();
            let mut record = DropRecord::of(&drop, none, progress)?;
            if matches!(record.ending(), Ending::Complete) {
                slowed(first, &drop.drop, &mut record);
                warm = done.add(&drop, &mut record);
            }
            done.later.push(record.judgement());
            match record.ending() {
                Ending::Complete => {}
                Ending::Interrupted => {
                    done.interrupted = true;
                    return Ok(done);
                }
                _ => {
                    let stopped = &record.bearings[record.last_index()].result.stopped;
                    let reason = stopped.as_ref().map(ToString::to_string);
                    let reason = reason.unwrap_or_default();
                    done.cut_short = Some(format!("drop {number} stopped {reason}"));
                    return Ok(done);
                }
            }
        }
        let last = 1 + done.later.len();
        let without = |reason| format!("no temperatures at standstill after drop {last}: {reason}");
        done.without_standstill = warm.err().map(without);
        Ok(done)
    }

    /// Adds a drop; returns the temperatures of each bearing at standstill.
    fn add(&mut self, filed: &FiledDrop<'_>, record: &mut DropRecord) -> Warm {
        let drop = &filed.drop;
        let number = 1 + self.records.len() / record.bearings.len();
        let standstill = Standstill::after(drop, record);
        let doubts = standstill
            .iter()
            .flat_map(|standstill| &standstill.warnings);
        self.doubts
            .extend(doubts.map(|text| format!("drop {number}: {text}")));
        let rotor = &record.rotor;
        let results = record.bearings.iter_mut().map(|b| &mut b.result);
        let cases = drop
            .cases()
            .iter()
            .zip(filed.files)
            .zip(results)
            .enumerate();
        let ended: Vec<_> = cases
            .map(|(bearing, ((case, file), result))| {
                let heat = standstill.as_ref().ok().map(|s| &s.bearings[bearing]);
                let standstill_c = heat.and_then(|heat| {
                    let thermal = &file.particulars().thermal;
                    let capacities = thermal
                        .capacities_j_k(&case.bearing, case.rows.len())
                        .ok()?;
                    let mut parts_c = [0.0; PARTS];
                    for (k, part_c) in parts_c.iter_mut().enumerate() {
                        let rise_k = heat.shares[k] * heat.heat_j / capacities[k];
                        *part_c = result.results.value(TEMPERATURES[k])? + rise_k;
                    }
                    Some(parts_c)
                });
                let soft = standstill_c.and_then(|parts_c| softened(file, parts_c));
                result.judge(result.judgement.clone().failed(soft));
                let ended = SuccessiveDrop {
                    number,
                    bearing,
                    case,
                    particulars: file.particulars(),
                    heat_j: result.results.number("dissipated_j"),
                    spin_down_s: standstill.as_ref().ok().map(|s| s.time_s),
                    spin_down_heat_j: heat.map(|heat| heat.heat_j),
                    rotor,
                    standstill_c,
                    judgement: DropJudgement::default(),
                };
                self.records.push(succession_record(ended, result));
                standstill_c
            })
            .collect();
        standstill?;
        let all: Option<_> = ended.into_iter().collect();
        all.ok_or_else(|| "rings and balls have no specific heat".to_owned())
    }

    /// The table of the drops, a row for each bearing; below several bearings one of them all, whose heat is the sum.
    /// The first row is the head.
    pub fn table(&self) -> Vec<Vec<String>> {
        let bearings = self.records.iter().map(|record| record.number("bearing"));
        let bearings = bearings.fold(1.0, f64::max) as usize;
        let mut rows = table_of(&self.records);
        if bearings == 1 {
            return rows;
        }
        let mut quantities = self.records[0].iter().filter(|(q, _)| q.in_tables);
        let quantities: Vec<&Quantity> = quantities.by_ref().map(|(q, _)| q).collect();
        let mut all = vec![rows.remove(0)];
        for (records, rows) in self.records.chunks(bearings).zip(rows.chunks(bearings)) {
            all.extend(rows.iter().cloned());
            let mut sum = vec!["–".to_owned(); all[0].len()];
            for (cell, quantity) in sum.iter_mut().zip(&quantities) {
                let of_bearing = |record: &Record| record.value(quantity.name);
                *cell = match quantity.name {
                    "drop" | "spin_down_s" => of_bearing(&records[0]),
                    "dissipated_j" | "spin_down_heat_j" => records.iter().map(of_bearing).sum(),
                    "bearing" => {
                        *cell = "all".to_owned();
                        continue;
                    }
                    _ => continue,
                }
                .map_or("–".to_owned(), |value| quantity.number_text(value));
            }
            all.push(sum);
        }
        all
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

/// The hottest part beyond the temperature at which its material softens.
fn softened(file: &CaseFile, standstill_c: [f64; PARTS]) -> Option<String> {
    let limits_c = file.softening_c();
    let beyond = (0..PARTS).filter_map(|k| {
        let (part_c, limit_c) = (standstill_c[k], limits_c[k]?);
        (part_c > limit_c).then_some((k, part_c, limit_c))
    });
    let (k, part_c, limit_c) = beyond.max_by(|a, b| a.1.total_cmp(&b.1))?;
    Some(format!(
        "{} at {part_c:.0} °C at standstill with all heat kept, above the {limit_c:.0} °C at which the \
         steel softens",
        NAMES[k]
    ))
}

/// Fails the bearings of a warm drop whose inner ring no longer comes up to speed.
fn slowed(first: &DropRecord, drop: &RotorDrop, record: &mut DropRecord) {
    let cases = drop.cases().iter().zip(&first.bearings);
    for ((case, cold), warm) in cases.zip(&mut record.bearings) {
        if spun_up(&cold.result) && !spun_up(&warm.result) {
            let reason = format!(
                "thermal runaway: the inner ring, which came up to speed after {} ms in the first drop, does not \
                 within {} ms with Gr {} µm; largest force on the rotor {} N",
                short(cold.result.results.number("spin_up_ms")),
                short(1e3 * warm.result.results.number("simulated_s")),
                um(case.bearing.radial_internal_clearance_m()),
                short(warm.result.results.number("rotor_force_max_n"))
            );
            warm.result
                .judge(warm.result.judgement.clone().failed([reason]));
        }
    }
}

/// The file with the temperatures at which its bearings are after the pause, and what they make of the
/// touch-down clearances.
fn warmed(
    file: &BearingArrangement,
    filed: &FiledDrop<'_>,
    standstill_c: &[[f64; PARTS]],
) -> Result<BearingArrangement, CaseError> {
    let drop = &filed.drop;
    let cases = || drop.cases().iter().enumerate();
    let start_c = filed.particulars().zip(standstill_c);
    let start_c: Vec<_> = start_c
        .map(|(own, standstill_c)| own.thermal.after_pause_c(*standstill_c, own.parts_c()))
        .collect();
    let temperatures = cases().flat_map(|(k, _)| {
        let parts = TEMPERATURES.iter().zip(start_c[k]);
        parts.map(move |(name, part_c)| {
            let key = file.key_in(k, &format!("fit.{name}"));
            format!("{key}={part_c:?}")
        })
    });
    let warm = file.changed(&temperatures.collect::<Vec<_>>())?;
    // The bore grows with the inner ring; the rotor stays as it is.
    let clearances = cases().filter_map(|(k, case)| {
        let fit = warm.cases()[k].particulars().fit?;
        let (rotor, bore) = (case.rotor.as_ref()?, case.bearing.inner_ring_bore()?);
        let rise_k = start_c[k][0] - filed.files[k].particulars().parts_c()[0];
        let growth_m = bore.radius_m * fit.ring_expansion_per_k * rise_k;
        let cold_um = warm.cases()[k].document().number(CLEARANCE)?;
        let clearance_um = cold_um * (1.0 + growth_m / rotor.radial_clearance_m);
        Some(format!("{}={clearance_um:?}", file.key_in(k, CLEARANCE)))
    });
    warm.changed(&clearances.collect::<Vec<_>>())
}
