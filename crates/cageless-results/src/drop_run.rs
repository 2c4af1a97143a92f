//! Results of a drop: those of its bearings and of the rotor.

use cageless::simulation::{PlaneDisplacement, RotorDrop, RotorDropOutcome, RotorOutcome};
use cageless::touchdown::DropRecorder;

use crate::bearing_number::bearing_number;
use crate::table::PLANE;
use crate::{Across, Cell, DropJudgement, DropResult, Particulars, Quantity, Record, Subject};

/// Results of a drop.
#[derive(Debug, Clone)]
pub struct DropRun {
    /// Results of each bearing.
    pub bearings: Vec<DropResult>,
    /// Outcome of the rotor.
    pub rotor: RotorOutcome,
    /// Reason why the drop stopped early, if it did, with the bearing of several.
    pub stopped: Option<String>,
}

impl DropRun {
    /// Results of `drop`, which ended as `outcome`, with particulars and recorder of each bearing.
    pub fn new<'p>(
        drop: &RotorDrop,
        particulars: impl IntoIterator<Item = &'p Particulars>,
        recorders: Vec<DropRecorder>,
        outcome: &RotorDropOutcome,
    ) -> Self {
        let bearings = drop.cases().iter().zip(particulars);
        let ended = bearings.zip(recorders).zip(&outcome.bearings);
        let mut bearings: Vec<DropResult> = ended
            .map(|(((case, own), recorder), ended)| {
                DropResult::new(case, own, &recorder.summary(&ended.state), ended)
            })
            .collect();
        let stopped = outcome.stopped_bearing().map(|k| {
            let reason = bearings[k].stopped.as_ref().map(ToString::to_string);
            let reason = reason.unwrap_or_default();
            match bearing_number(k, bearings.len()) {
                None => reason,
                Some(number) => format!("in bearing {number} {reason}"),
            }
        });
        // One that stops interrupts the others, and the stop is its own.
        if let Some(k) = outcome.stopped_bearing() {
            let others = bearings.iter_mut().enumerate().filter(|(j, _)| *j != k);
            others.for_each(|(_, bearing)| bearing.stopped = None);
        }
        Self {
            bearings,
            rotor: outcome.rotor.clone(),
            stopped,
        }
    }

    /// The verdict on all bearings and the planes of the rotor.
    pub fn judgement(&self) -> DropJudgement {
        let bearings: Vec<_> = self.bearings.iter().map(|b| &b.judgement).collect();
        DropJudgement::of_bearings(&bearings, &self.rotor)
    }

    /// Value of a quantity for the drop as a whole.
    pub fn value(&self, quantity: &Quantity) -> Cell {
        if let Some(own) = quantity.of(Subject::RotorDrop(&self.rotor)) {
            return own;
        }
        let found = |bearing: &DropResult| {
            let cell = bearing.results.get(quantity.name);
            cell.cloned().unwrap_or(Cell::Null)
        };
        match (quantity.across, &self.bearings[..]) {
            (Some(Across::Verdict), _) => self.judgement().cell(quantity.kind),
            (_, [only]) => found(only),
            (Some(across), all) => across.of(all.iter().map(found).collect::<Vec<_>>().iter()),
            (None, _) => Cell::Null,
        }
    }
}

/// Each plane of a rotor against its clearance.
pub fn plane_records(planes: &[PlaneDisplacement]) -> Vec<Record> {
    let record = |plane| Record::of(PLANE, Subject::Plane(plane));
    planes.iter().map(record).collect()
}
