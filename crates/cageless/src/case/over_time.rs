//! Speed and load of a case over time.

use std::ops::Range;

use super::Case;
use crate::time_table::TimeTable;

impl Case {
    /// ωi at a time over the largest of the run, [`Case::largest_inner_speed_rad_s`]: exactly 1 at constant speed.
    pub(crate) fn inner_speed_ratio(&self, time_s: f64) -> f64 {
        match &self.operation.inner_speed_table {
            Some(table) => table.value(time_s) / self.largest_inner_speed_rad_s(),
            None => 1.0,
        }
    }

    /// Time in which the inner ring at its largest speed turns as far as it does between two times, s: exactly
    /// what lies between them at constant speed.
    pub(crate) fn time_at_largest_speed_s(&self, between_s: Range<f64>) -> f64 {
        match &self.operation.inner_speed_table {
            Some(table) => table.integral(between_s) / self.largest_inner_speed_rad_s(),
            None => between_s.end - between_s.start,
        }
    }

    /// Smallest and largest ωi of the run, rad/s.
    pub fn inner_speed_range_rad_s(&self) -> [f64; 2] {
        let (speed, table) = (
            self.operation.inner_speed_rad_s,
            &self.operation.inner_speed_table,
        );
        self.range(speed, table.as_ref())
    }

    /// Smallest and largest Fr of the run, N.
    pub fn radial_load_range_n(&self) -> [f64; 2] {
        let (load, table) = (
            self.operation.radial_load_n,
            &self.operation.radial_load_table,
        );
        self.range(load, table.as_ref())
    }

    fn range(&self, constant: f64, table: Option<&TimeTable>) -> [f64; 2] {
        table.map_or([constant; 2], |t| t.range_until(self.solver.duration_s))
    }

    /// The case at the constant speed and load of a time.
    pub(crate) fn held_at(&self, time_s: f64) -> Self {
        let mut held = self.clone();
        held.operation = self.operation.from_time(time_s);
        (
            held.operation.inner_speed_table,
            held.operation.radial_load_table,
        ) = (None, None);
        held
    }

    /// Times of the largest load and of the largest speed of the run, s; t = 0 alone where both are constant.
    pub(crate) fn extreme_times_s(&self) -> Vec<f64> {
        let end_s = self.solver.duration_s;
        let largest = |table: &Option<TimeTable>| {
            let table = table.as_ref()?;
            let times = table.times_s().iter().copied().filter(|t| *t < end_s);
            let all = times.chain([0.0, end_s]);
            all.max_by(|a, b| table.value(*a).total_cmp(&table.value(*b)))
        };
        let tables = [
            &self.operation.radial_load_table,
            &self.operation.inner_speed_table,
        ];
        let mut times: Vec<f64> = tables.into_iter().filter_map(largest).collect();
        if times.is_empty() {
            times.push(0.0);
        }
        times.dedup();
        times
    }
}
