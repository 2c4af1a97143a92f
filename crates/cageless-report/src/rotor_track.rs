//! Motion of a rotor in the bore of the inner ring, as it is drawn.

use cageless::{Case, RotorSnapshot, Snapshot};

use crate::data::RotorTrack;

/// Air gap of a rotor as it is drawn, mm: real ones would not be seen.
const DRAWN_GAP_MM: f64 = 1.2;

/// Motion of the rotor and the inner ring of a drop; `None` without a rotor.
pub(crate) fn rotor_track(case: &Case, snapshots: &[Snapshot]) -> Option<RotorTrack> {
    let rotor = case.rotor.as_ref()?;
    let bore = case.bearing.inner_ring_bore()?;
    let enlarged = DRAWN_GAP_MM / rotor.radial_clearance_m;
    let rows: Vec<(f64, RotorSnapshot, [f64; 2])> = (snapshots.iter())
        .filter_map(|s| Some((s.time_s, s.rotor?, [s.ring.x_m, s.ring.y_m])))
        .collect();
    let place = |axis: usize| -> Vec<f64> {
        let centre = |(_, r, ring): &(f64, RotorSnapshot, [f64; 2])| {
            let journal = rotor.journal_m([r.x_m, r.y_m], r.angle_rad);
            enlarged * (journal[axis] - ring[axis])
        };
        rows.iter().map(centre).collect()
    };
    let mut ring_angle = 0.0;
    let mut ring_angle_deg = Vec::with_capacity(rows.len());
    for (k, (time_s, r, _)) in rows.iter().enumerate() {
        if let Some((before_s, before, _)) = k.checked_sub(1).map(|k| &rows[k]) {
            let mean = 0.5 * (before.ring_speed_rad_s + r.ring_speed_rad_s);
            ring_angle += mean * (time_s - before_s);
        }
        ring_angle_deg.push(ring_angle.to_degrees());
    }
    Some(RotorTrack {
        bore_radius_mm: 1e3 * bore.radius_m,
        gap_mm: DRAWN_GAP_MM,
        x_mm: place(0),
        y_mm: place(1),
        angle_deg: rows
            .iter()
            .map(|(_, r, _)| r.angle_rad.to_degrees())
            .collect(),
        ring_angle_deg,
    })
}
