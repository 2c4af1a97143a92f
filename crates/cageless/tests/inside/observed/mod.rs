//! What observers record of a run, against the same numbers worked out from its state at every
//! step: balls of fourteen sizes, uneven gaps, two different raceways, none at the bottom.

mod recording;

use std::f64::consts::{PI, TAU};

use cageless::collision::Collision;
use cageless::contact::flash_temperature::{STEEL_EFFUSIVITY, flash_temperature_k};
use cageless::dynamics::energy::EnergyTerm;
use cageless::passage::{Passage, PassageTally};
use cageless::raceway_contact::{RacewayContact, RacewayPoint};
use cageless::summary::ContactPeak;
use cageless::verification::Quantity;
use recording::{RECORDING, Recording, Row, Seen};

fn close(found: f64, expected: f64, tolerance: f64, what: &str) {
    assert!(
        (found - expected).abs() <= tolerance,
        "{what}: {found:e}, expected {expected:e}"
    );
}

/// As [`close`], by a fraction of the expected value.
fn near(found: f64, expected: f64, fraction: f64, what: &str) {
    close(found, expected, fraction * expected.abs(), what);
}

/// The value `part` of the way from `a` to `b`.
fn mix([a, b]: [f64; 2], part: f64) -> f64 {
    a + part * (b - a)
}

/// Passages of ball `k` through raceway `r`: first step inside and first step outside again.
fn stays(run: &Recording, r: usize, k: usize) -> Vec<[usize; 2]> {
    let mut stays = vec![];
    let mut entered = None;
    for step in 1..run.rows.len() {
        let [before, after] = [step - 1, step].map(|n| beyond_end(run, r, k, n) < 0.0);
        match (before, after) {
            (false, true) => entered = Some(step),
            (true, false) => stays.extend(entered.take().map(|enter| [enter, step])),
            _ => {}
        }
    }
    stays
}

/// |ψ − centre| − θ of a ball, below zero inside.
fn beyond_end(run: &Recording, r: usize, k: usize, row: usize) -> f64 {
    let [centre, half] = [[30.0, 25.2], [-100.0, 18.167]][r].map(f64::to_radians);
    let off = (run.rows[row].balls[k].psi() - centre + PI).rem_euclid(TAU) - PI;
    off.abs() - half
}

#[test]
fn every_number_of_a_passage() {
    let run = &*RECORDING;
    let mut count = 0;
    let mut tallies = [PassageTally::new(); 2];
    for (r, k) in (0..2).flat_map(|r| (0..14).map(move |k| (r, k))) {
        let found = run
            .passages
            .iter()
            .filter(|p| (p.raceway, p.ball) == (r, k));
        let found: Vec<&Passage> = found.collect();
        let stays = stays(run, r, k);
        assert_eq!(found.len(), stays.len(), "raceway {r}, ball {k}");
        for (p, [enter, leave]) in found.into_iter().zip(stays) {
            let what = format!("{p:?}");
            // Where the end of the raceway lies in the step, and a value there.
            let at_end = |step: usize, value: &dyn Fn(&Row) -> f64| {
                let [a, b] = [step - 1, step].map(|n| beyond_end(run, r, k, n));
                mix(
                    [value(&run.rows[step - 1]), value(&run.rows[step])],
                    a / (a - b),
                )
            };
            let behind = (k + 13) % 14;
            close(p.enter_s, at_end(enter, &|row| row.time_s), 2e-9, &what);
            close(p.leave_s, at_end(leave, &|row| row.time_s), 2e-9, &what);
            let gap_enter = at_end(enter, &|row| run.gap_rad(row, k));
            let gap_leave = at_end(leave, &|row| run.gap_rad(row, k));
            close(p.gap_enter_rad, gap_enter, 2e-7, &what);
            close(p.gap_leave_rad, gap_leave, 2e-7, &what);
            let gap_behind = at_end(enter, &|row| run.gap_rad(row, behind));
            close(p.gap_behind_rad, gap_behind, 2e-7, &what);

            let inside = &run.rows[enter..leave];
            let least = |of: &dyn Fn(&Row) -> f64| inside.iter().map(of).fold(f64::MAX, f64::min);
            let most = |of: &dyn Fn(&Row) -> f64| inside.iter().map(of).fold(f64::MIN, f64::max);
            let gap_min = least(&|row| run.gap_rad(row, k));
            close(
                p.gap_min_rad,
                gap_min.min(gap_enter).min(gap_leave),
                2e-7,
                &what,
            );
            let orbits = [
                least(&|row| row.balls[k].orbit()),
                most(&|row| row.balls[k].orbit()),
            ];
            for (found, expected) in p.orbit_speed_range_rad_s.into_iter().zip(orbits) {
                near(found, expected, 1e-12, &what);
            }
            let slip = |row: &Row| {
                let ball = &row.balls[k];
                let loaded = |slip: f64, force: f64| if force > 0.0 { slip.abs() } else { 0.0 };
                loaded(ball.inner_slip, ball.inner_n).max(loaded(ball.outer_slip, ball.outer_n))
            };
            near(p.sliding_max_m_s, most(&slip), 1e-12, &what);
            let touches = |pair| (enter..leave).filter(|&n| run.touches(n, pair)).count();
            assert_eq!(p.collisions_ahead as usize, touches(k), "{what}");
            assert_eq!(p.collisions_behind as usize, touches(behind), "{what}");
            tallies[r].add(p);
            count += 1;
        }
    }
    assert_eq!(count, run.passages.len());
    assert!(tallies.iter().all(|t| t.count > 40), "{tallies:?}");
    // The run has what tells the numbers apart.
    let some = |of: &dyn Fn(&Passage) -> bool| run.passages.iter().any(of);
    assert!(some(&|p| p.collisions_ahead > 0 && p.collisions_behind == 0));
    assert!(some(&|p| p.collisions_behind > 0 && p.collisions_ahead == 0));
    assert!(some(
        &|p| p.gap_min_rad < p.gap_enter_rad.min(p.gap_leave_rad)
    ));
    assert!(some(
        &|p| p.gap_leave_rad < p.gap_enter_rad && p.gap_min_rad == p.gap_leave_rad
    ));
}

#[test]
fn every_number_of_a_collision() {
    let run = &*RECORDING;
    let mut count = 0;
    for k in 0..14 {
        let overlap = |step: usize| run.overlap_m(&run.rows[step], k);
        let touched = (1..run.rows.len()).filter(|&n| run.touches(n, k));
        let found: Vec<&Collision> = run.collisions.iter().filter(|c| c.ball == k).collect();
        for (c, touch) in found.into_iter().zip(touched) {
            let what = format!("{c:?}");
            let next = (k + 1) % 14;
            assert_eq!(c.next_ball, next, "{what}");
            let part = overlap(touch - 1) / (overlap(touch - 1) - overlap(touch));
            let rows = [&run.rows[touch - 1], &run.rows[touch]];
            let start = mix(rows.map(|row| row.time_s), part);
            close(c.start_s, start, 1e-7, &what);
            let part = (c.start_s - rows[0].time_s) / run.case.solver.step_s;
            let at = |k: usize, of: fn(&Seen) -> f64| mix(rows.map(|row| of(&row.balls[k])), part);
            let middle = [|b: &Seen| b.x, |b: &Seen| b.y].map(|of| at(k, of) + at(next, of));
            close(c.angle_rad, middle[0].atan2(-middle[1]), 1e-7, &what);
            let apart = [|b: &Seen| b.x, |b: &Seen| b.y].map(|of| at(next, of) - at(k, of));
            let faster = [|b: &Seen| b.vx, |b: &Seen| b.vy].map(|of| at(k, of) - at(next, of));
            let along = (apart[0] * faster[0] + apart[1] * faster[1]) / apart[0].hypot(apart[1]);
            close(c.approach_speed_m_s, along, 2e-3 * along + 5e-4, &what);

            let part_step = (touch + 1..run.rows.len()).find(|&n| overlap(n) <= 0.0);
            let part_step = part_step.expect("passed on when it ends");
            let [last, first] = [part_step - 1, part_step].map(overlap);
            let times = [part_step - 1, part_step].map(|n| run.rows[n].time_s);
            let end = mix(times, last / (last - first));
            close(c.duration_s, end - start, 1e-7, &what);
            let forces: Vec<f64> = (run.rows[touch..part_step].iter())
                .map(|row| row.balls[k].pair_n)
                .collect();
            let largest = forces.iter().copied().fold(0.0, f64::max);
            assert!(
                (1.0..1.1).contains(&(c.peak_force_n / largest)),
                "{what} {largest}"
            );
            // The first and the last step are closed for a part of it.
            let whole: f64 = forces.windows(2).map(|f| f[0] + f[1]).sum();
            let impulse = 0.5
                * (run.case.solver.step_s * whole
                    + forces[0] * (run.rows[touch].time_s - c.start_s)
                    + forces[forces.len() - 1] * (c.start_s + c.duration_s - times[0]));
            near(c.impulse_n_s, impulse, 1e-9, &what);
            count += 1;
        }
    }
    assert!(count > 20 && run.collisions.len() == count, "{count}");
}

#[test]
fn every_number_of_a_summary() {
    let run = &*RECORDING;
    let (s, rows) = (&run.summary, run.settled());
    let first = run.rows.len() - rows.len();
    near(
        s.settled_after_s,
        run.rows[first - 1].time_s,
        1e-4,
        "transient",
    );
    let (mut touches, mut open, mut above) = (0, 0, [0; 3]);
    for (n, k) in (first..run.rows.len()).flat_map(|n| (0..14).map(move |k| (n, k))) {
        if !run.touches(n, k) {
            continue;
        }
        let [from, to] = [n - 1, n].map(|row| run.rows[row].time_s);
        let begun = |c: &&Collision| c.ball == k && c.start_s >= from && c.start_s < to;
        touches += 1;
        // A contact that is closed at the end of the run is not passed on.
        let Some(collision) = run.collisions.iter().find(begun) else {
            open += 1;
            continue;
        };
        for (above, limit_m_s) in above.iter_mut().zip([0.1, 0.5, 1.0]) {
            *above += u64::from(collision.approach_speed_m_s > limit_m_s);
        }
    }
    assert!(touches > above[0] && above[0] > 0, "{touches} {above:?}");
    assert_eq!(s.collisions.all, touches);
    for (found, above) in s.collisions.above.into_iter().zip(above) {
        assert!((above..=above + open).contains(&found), "{found} {above}");
    }
    assert!(open < 2);
    // Gaps are looked at every eighth step.
    let gaps = || {
        rows.iter()
            .step_by(8)
            .flat_map(|row| (0..14).map(|k| run.gap_rad(row, k)))
    };
    close(
        s.gap_min_rad,
        gaps().fold(f64::MAX, f64::min),
        1e-12,
        "smallest gap",
    );
    close(
        s.gap_max_rad,
        gaps().fold(f64::MIN, f64::max),
        1e-12,
        "largest gap",
    );
    let means = [0, 1].map(|axis| {
        let twice: f64 = (run.rows[first - 1..].windows(2))
            .map(|w| w[0].ring[axis] + w[1].ring[axis])
            .sum();
        twice / 2.0 / rows.len() as f64
    });
    close(s.ring_x_mean_m, means[0], 1e-15, "mean x");
    close(s.ring_y_mean_m, means[1], 1e-15, "mean y");
    let sliding = |ball: &Seen| {
        let loaded = |slip: f64, force: f64| if force > 0.0 { slip.abs() } else { 0.0 };
        loaded(ball.inner_slip, ball.inner_n).max(loaded(ball.outer_slip, ball.outer_n))
    };
    let slips = rows.iter().flat_map(|row| row.balls.iter().map(sliding));
    near(
        s.sliding_max_m_s,
        slips.fold(0.0, f64::max),
        1e-12,
        "largest sliding speed",
    );
}

/// Force on the outer ring at the end of step `n`: what load, weight and drag leave of the change of the momentum of
/// balls and inner ring.
fn outer_ring_force_n(run: &Recording, n: usize) -> [f64; 2] {
    let h = run.case.solver.step_s;
    let mass_kg = |k| 7850.0 * 4.0 / 3.0 * PI * run.radius_m(k).powi(3);
    let [before, now, after] = [n - 1, n, n + 1].map(|n| &run.rows[n]);
    [0, 1].map(|axis| {
        let [a, b, c] = [before, now, after].map(|row| row.ring[axis]);
        let speed = |row: &Row, k: usize| [row.balls[k].vx, row.balls[k].vy][axis];
        let balls: f64 = (0..14)
            .map(|k| mass_kg(k) * (speed(after, k) - speed(before, k)) / (2.0 * h))
            .sum();
        let down = 1500.0 + 9.81 * (0.2 + (0..14).map(mass_kg).sum::<f64>());
        -[0.0, down][axis]
            - 2000.0 * (c - a) / (2.0 * h)
            - 0.2 * (a - 2.0 * b + c) / (h * h)
            - balls
    })
}

/// Rates are sums over all steps after the transient; the parts of the force are means of every eighth step, here from
/// central differences.
#[test]
fn every_number_of_steady_operation() {
    let run = &*RECORDING;
    let (s, rows, h) = (&run.steady, run.settled(), run.case.solver.step_s);
    let first = run.rows.len() - rows.len();
    let time_s = h * rows.len() as f64;
    let pairs = || rows.iter().flat_map(|row| &row.balls);
    let touches = (first..run.rows.len()).flat_map(|n| (0..14).map(move |k| (n, k)));
    let touches = touches.filter(|&(n, k)| run.touches(n, k)).count();
    near(
        s.contact_rates_hz[0],
        touches as f64 / time_s,
        1e-9,
        "contacts",
    );
    let impulse: f64 = pairs().map(|ball| h * ball.pair_n).sum();
    near(s.impulse_rate_n, impulse / time_s, 1e-9, "impulse");
    // An open pair slides without load.
    let wear = pairs().filter(|ball| ball.pair_n > 0.0);
    let wear: f64 = wear
        .map(|ball| ball.pair_n * (h * ball.pair_slip.abs()))
        .sum();
    near(s.wear_w, wear / time_s, 1e-9, "wear");
    // At full friction wear is the work of friction over its coefficient; below it more.
    let term = EnergyTerm::without_rotor()
        .iter()
        .position(|t| *t == EnergyTerm::BallFriction);
    let [from, to] = [first - 1, run.rows.len() - 1].map(|n| run.rows[n].ledger[term.unwrap()]);
    let work_w = (to - from).abs() / time_s / 0.007;
    assert!(
        (0.999..1.02).contains(&(s.wear_w / work_w)),
        "{} {work_w}",
        s.wear_w
    );

    let before = run.rows[..first].iter().flat_map(|row| &row.balls);
    let largest = before.map(|ball| ball.pair_n).fold(0.0, f64::max);
    let pressure = run.case.bearing.ball_contact().peak_pressure_pa(largest);
    near(
        s.transient_pressure_pa,
        pressure,
        1e-12,
        "pressure in the transient",
    );

    let mut sums = [0.0; 4];
    let mut count = 0.0;
    for n in (first + 7..run.rows.len() - 1).step_by(8) {
        let [fx, fy] = outer_ring_force_n(run, n);
        let row = &run.rows[n];
        let (x, y) = (row.balls[0].x, row.balls[0].y);
        let angle = y.atan2(x);
        let (sine, cosine) = angle.sin_cos();
        let of = [
            fx * cosine + fy * sine,
            fy * cosine - fx * sine,
            fy * (14.0 * angle).cos(),
            fy * (14.0 * angle).sin(),
        ];
        for (sum, value) in sums.iter_mut().zip(of) {
            *sum += value;
        }
        count += 1.0;
    }
    let means = sums.map(|sum| sum / count);
    near(s.turning_force_n, means[0].hypot(means[1]), 3e-2, "turning");
    near(
        s.passing_force_n,
        2.0 * means[2].hypot(means[3]),
        3e-2,
        "passing",
    );
}

/// The gaps of each instant about their mean, looked at every 64th step, and the force on the outer ring.
#[test]
fn every_deviation() {
    let run = &*RECORDING;
    let (s, rows) = (&run.summary, run.settled());
    let variance = |row: &Row| {
        let gaps: Vec<f64> = (0..14).map(|k| run.gap_rad(row, k)).collect();
        let mean = gaps.iter().sum::<f64>() / 14.0;
        gaps.iter().map(|gap| (gap - mean).powi(2)).sum::<f64>() / 14.0
    };
    // A look is that of the time since the one before.
    let deviation = |from_s: f64, to_s: f64| {
        let (mut last_s, mut time_s, mut sum) = (s.settled_after_s, 0.0, 0.0);
        for row in rows.iter().step_by(64) {
            let since_s = row.time_s - std::mem::replace(&mut last_s, row.time_s);
            if row.time_s > from_s && row.time_s <= to_s {
                time_s += since_s;
                sum += since_s * variance(row);
            }
        }
        (sum / time_s).sqrt()
    };
    let middle_s = 0.5 * (s.settled_after_s + 0.05);
    let [all, first, second] =
        [(0.0, 1.0), (0.0, middle_s), (middle_s, 1.0)].map(|(from, to)| deviation(from, to));
    near(s.gap_deviation_rad, all, 1e-9, "gaps");
    near(s.gap_deviation_change_rad, second - first, 1e-9, "change");
    assert!((second - first).abs() > 0.01 * all, "{first} {second}");

    let force = |n: usize, axis: usize| outer_ring_force_n(run, n)[axis];
    let first = run.rows.len() - rows.len();
    let deviations = [0, 1].map(|axis| {
        let looked = (first + 1..run.rows.len() - 1).step_by(2);
        let forces: Vec<f64> = looked.map(|n| force(n, axis)).collect();
        let mean = forces.iter().sum::<f64>() / forces.len() as f64;
        let squares: f64 = forces.iter().map(|force| (force - mean).powi(2)).sum();
        (squares / forces.len() as f64).sqrt()
    });
    let both = deviations[0].hypot(deviations[1]);
    near(s.outer_ring_force_deviation_n, both, 2e-3, "force");
}

/// Peaks of contacts given by force, sliding speed, pressure and semi-axis, which surfaces pass at
/// `surface_m_s`.
fn peak(contacts: impl Iterator<Item = [f64; 4]>, surface_m_s: f64) -> ContactPeak {
    let mut peak = ContactPeak::default();
    for [force, slip, pressure, axis] in contacts {
        peak.force_n = peak.force_n.max(force);
        peak.pressure_pa = peak.pressure_pa.max(pressure);
        if pressure * slip.abs() > peak.pressure_velocity_pa_m_s {
            peak.pressure_velocity_pa_m_s = pressure * slip.abs();
            let speeds = [surface_m_s, surface_m_s - slip];
            peak.flash_temperature_k =
                flash_temperature_k(0.007, pressure, axis, speeds, STEEL_EFFUSIVITY);
        }
    }
    peak
}

#[test]
fn every_peak_of_the_contacts() {
    let run = &*RECORDING;
    let (bearing, rows) = (&run.case.bearing, run.settled());
    // Contacts with the raceways are looked at every 4 µs, each second step, those between balls in each.
    let looked = || rows.iter().skip(1).step_by(2).flat_map(|row| &row.balls);
    let of = |force: f64, slip: f64, contact: RacewayContact| {
        [force, slip, contact.pressure_pa, contact.semi_axes_m[0]]
    };
    let inner = (looked().filter(|b| b.inner_n > 0.0)).map(|b| {
        let point = RacewayPoint::of_outer(1.0, b.inner_n);
        of(
            b.inner_n,
            b.inner_slip,
            RacewayContact::inner(bearing, point),
        )
    });
    let own = (0..bearing.balls()).cycle().zip(looked());
    let outer = (own.filter(|(_, b)| b.outer_n > 0.0)).map(|(k, b)| {
        let cosine = b.radius / bearing.ball(k).radius_m;
        let point = RacewayPoint::of_outer(cosine, b.outer_n);
        let contact = RacewayContact::outer(bearing, point);
        of(b.outer_n, b.outer_slip, contact)
    });
    let contact = bearing.ball_contact();
    let between = (rows
        .iter()
        .flat_map(|row| &row.balls)
        .filter(|b| b.pair_n > 0.0))
    .map(|b| {
        let [axis, _] = contact.semi_axes_m(b.pair_n);
        [
            b.pair_n,
            b.pair_slip,
            contact.peak_pressure_pa(b.pair_n),
            axis,
        ]
    });
    let speed = run.case.operation.inner_speed_rad_s;
    let orbit = speed * 18.24e-3 / (18.24e-3 + 27.765e-3);
    let peaks = &run.summary.peaks;
    for (name, found, expected) in [
        (
            "inner",
            peaks.inner,
            peak(inner, (speed - orbit) * 18.24e-3),
        ),
        ("outer", peaks.outer, peak(outer, orbit * 27.765e-3)),
        (
            "balls",
            peaks.balls,
            peak(between, orbit * bearing.pitch_radius_m()),
        ),
    ] {
        near(found.force_n, expected.force_n, 1e-12, name);
        near(found.pressure_pa, expected.pressure_pa, 1e-9, name);
        let [found_pv, pv] = [found, expected].map(|p| p.pressure_velocity_pa_m_s);
        near(found_pv, pv, 1e-6, name);
        near(
            found.flash_temperature_k,
            expected.flash_temperature_k,
            1e-6,
            name,
        );
        assert!(expected.flash_temperature_k > 0.0);
    }
}

#[test]
fn every_mean_of_whole_orbits() {
    let run = &*RECORDING;
    let (means, rows) = (run.summary.means.unwrap(), run.settled());
    let turned = |k: usize, to: usize| -> f64 {
        let step =
            |w: &[Row]| (w[1].balls[k].psi() - w[0].balls[k].psi() + PI).rem_euclid(TAU) - PI;
        rows[..=to].windows(2).map(step).sum()
    };
    let orbits = (turned(0, rows.len() - 1) / TAU).floor();
    let mut end = 0;
    let mut angle = 0.0;
    while angle < TAU * orbits {
        let [a, b] = [end, end + 1].map(|n| rows[n].balls[0].psi());
        angle += (b - a + PI).rem_euclid(TAU) - PI;
        end += 1;
    }
    assert_eq!(f64::from(means.orbits), orbits);
    assert!(orbits >= 1.0);
    assert_eq!(means.interval_s, [rows[0].time_s, rows[end].time_s]);
    let time_s = rows[end].time_s - rows[0].time_s;
    let all = |k| turned(k, end);
    let orbit = (0..14).map(all).sum::<f64>() / 14.0 / time_s;
    near(means.orbit_speed_rad_s, orbit, 1e-9, "orbit");
    let spin = |row: &Row| row.balls.iter().map(|b| b.spin).sum::<f64>() / 14.0;
    let spins = rows[..end].iter().map(spin).sum::<f64>() / end as f64;
    near(means.rotation_rad_s, spins, 2e-4, "rotation");
    near(means.ftf_hz, orbit / TAU, 1e-9, "FTF");
    near(means.bpfo_hz, 14.0 * orbit / TAU, 1e-9, "BPFO");
    let speed = run.case.operation.inner_speed_rad_s;
    assert_eq!(means.inner_speed_rad_s, speed);
    near(means.bpfi_hz, 14.0 * (speed - orbit) / TAU, 1e-9, "BPFI");
    near(means.bsf_hz, (spins + orbit) / TAU, 2e-4, "BSF");

    for (k, &term) in EnergyTerm::without_rotor().iter().enumerate() {
        let power = (rows[end].ledger[k] - rows[0].ledger[k]) / time_s;
        close(means.power_w(term), power, 1e-9 * power.abs(), term.name());
    }
    let rubbed = |of: fn(&Seen) -> f64| {
        let power = |row: &Row| row.balls.iter().map(of).sum::<f64>();
        rows[..end].iter().map(power).sum::<f64>() / end as f64
    };
    let inner = rubbed(|b| (b.inner_friction_n * b.inner_slip).abs());
    let outer = rubbed(|b| (b.outer_friction_n * b.outer_slip).abs());
    assert!((inner / outer - 1.0).abs() > 0.02, "{inner} {outer}");
    near(
        means.power_w(EnergyTerm::InnerFriction),
        inner,
        2e-3,
        "inner friction",
    );
    near(
        means.power_w(EnergyTerm::OuterFriction),
        outer,
        2e-3,
        "outer friction",
    );
}

#[test]
fn every_quantity_of_a_verification() {
    let run = &*RECORDING;
    let (s, rows) = (&run.summary, run.settled());
    let last = &run.rows[run.rows.len() - 1];
    let mean = |of: &dyn Fn(&Row) -> f64| rows.iter().map(of).sum::<f64>() / rows.len() as f64;
    let deviation = |axis: usize| {
        let centre = mean(&|row| row.ring[axis]);
        mean(&|row| (row.ring[axis] - centre).powi(2)).sqrt()
    };
    let of_balls = |of: fn(&Seen) -> f64| mean(&|row| row.balls.iter().map(of).sum::<f64>() / 14.0);
    let lead: f64 = (run.rows.windows(2))
        .map(|w| (w[1].balls[0].psi() - w[0].balls[0].psi() + PI).rem_euclid(TAU) - PI)
        .sum();
    let means = s.means.as_ref().unwrap();
    let mut tally = PassageTally::new();
    let settled = run
        .passages
        .iter()
        .filter(|p| p.enter_s > s.settled_after_s);
    settled.for_each(|passage| tally.add(passage));
    let lag = tally.means().lag_rad;
    for quantity in Quantity::ALL {
        let (expected, fraction) = match quantity {
            Quantity::Collisions => (s.collisions.all as f64, 0.0),
            Quantity::GapMin => (s.gap_min_rad, 0.0),
            Quantity::GapMax => (s.gap_max_rad, 0.0),
            Quantity::RingXMean => (s.ring_x_mean_m, 0.0),
            Quantity::RingYMean => (s.ring_y_mean_m, 0.0),
            Quantity::SlipMax => (s.sliding_max_m_s, 0.0),
            Quantity::RingXDeviation => (deviation(0), 1e-9),
            Quantity::RingYDeviation => (deviation(1), 1e-9),
            Quantity::OrbitSpeedMean => (of_balls(Seen::orbit), 1e-4),
            Quantity::SpinMean => (of_balls(|b| b.spin), 1e-4),
            Quantity::InnerForceMax => (s.peaks.inner.force_n, 0.0),
            Quantity::OuterForceMax => (s.peaks.outer.force_n, 0.0),
            Quantity::PowerLoss => (means.power_loss_w, 0.0),
            Quantity::FrictionTorque => (means.friction_torque_n_m, 0.0),
            Quantity::LagPerPass => (lag, 1e-12),
            Quantity::RingXEnd => (last.ring[0], 0.0),
            Quantity::RingYEnd => (last.ring[1], 0.0),
            Quantity::LeadBallAngleEnd => (0.1 + lead, 1e-9),
        };
        near(
            run.record.value(quantity),
            expected,
            fraction,
            &format!("{quantity:?}"),
        );
    }
    let distinct = |a: f64, b: f64| assert!((a / b - 1.0).abs() > 1e-3, "{a} {b}");
    distinct(deviation(0), deviation(1));
    distinct(s.ring_x_mean_m, last.ring[0]);
    assert_eq!(run.outcome.end_s, last.time_s);
    assert_eq!(run.outcome.steps as usize, run.rows.len() - 1);
}
