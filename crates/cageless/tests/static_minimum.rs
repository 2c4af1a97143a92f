//! Static equilibrium as the minimum of the potential energy: found for every bearing that
//! is accepted, and where an independent method finds it.

use std::f64::consts::{PI, TAU};

use crate::common::{conventional, dimensions, steel};
use cageless::equilibrium::{Equilibrium, EquilibriumError, solve, space};
use cageless::{Bearing, BearingDimensions, Case, Formulation, Gaps, Operation, Start, StartState};

/// SplitMix64 (Steele, Lea & Flood 2014).
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }

    fn log_between(&mut self, low: f64, high: f64) -> f64 {
        self.between(low.ln(), high.ln()).exp()
    }
}

fn at_lead(mut case: Case, lead_rad: f64) -> Case {
    case.start = Start::new(StartState::Settled, Gaps::Uniform, lead_rad);
    case
}

/// Any bearing with 3 to 60 balls of 2 to 20 mm, clearance 0 to 0.2 mm, load 0 to 20 kN,
/// 1 to 60 000 rpm, that the check accepts.
fn random_case(random: &mut Random) -> Case {
    loop {
        let balls = random.between(3.0, 61.0).floor();
        let rw = random.log_between(1e-3, 10e-3);
        let least = rw / (PI / balls).sin();
        let pitch = (least * random.between(1.0, 1.6)).max(1.6 * rw);
        let clearance = match random.between(0.0, 4.0) as u32 {
            0 => 0.0,
            1 => random.log_between(1e-7, 2e-4),
            _ => random.between(0.0, 2e-4),
        };
        let d = BearingDimensions {
            balls: balls as usize,
            ball_radius_m: rw,
            inner_groove_bottom_radius_m: pitch - rw,
            outer_groove_bottom_radius_m: pitch + rw + clearance,
            outer_shoulder_radius_m: pitch + clearance + 0.6 * rw,
            inner_shoulder_radius_m: None,
            inner_groove_curvature_radius_m: rw * random.between(1.02, 1.1),
            outer_groove_curvature_radius_m: rw * random.between(1.02, 1.1),
            inner_ring_mass_kg: random.log_between(0.3, 3.0) * 5e4 * pitch * rw * rw,
            inner_ring_damping_n_s_m: 0.0,
        };
        let Ok(bearing) = Bearing::new(d, steel()) else {
            continue;
        };
        let load = match random.between(0.0, 4.0) as u32 {
            0 => 0.0,
            1 => random.between(0.0, 2e4),
            _ => random.log_between(1e-2, 2e4),
        };
        let mut case = conventional(dimensions());
        case.bearing = bearing;
        case.operation = Operation {
            inner_speed_rad_s: random.log_between(1.0, 60e3) * TAU / 60.0,
            radial_load_n: load,
            gravity_m_s2: 9.81,
            ..case.operation
        };
        if random.next() < 0.2 {
            case.formulation = Formulation::Paper;
        }
        case.solver.step_s = 1e-10;
        let case = at_lead(case, random.between(0.0, TAU));
        if case.check().is_ok() {
            return case;
        }
    }
}

/// Force left on the ring, and all forces that act on it, from the result alone.
fn balance(case: &Case, e: &Equilibrium) -> [f64; 2] {
    let d = case.bearing.dimensions();
    let down = case.operation.radial_load_n + d.inner_ring_mass_kg * case.operation.gravity_m_s2;
    let (mut x, mut y, mut all) = (0.0, -down, down);
    for k in 0..case.bearing.balls() {
        let (sin, cos) = e.ball_angle_rad[k].sin_cos();
        let dx = e.ball_distance_m[k] * sin - e.ring_x_m;
        let dy = -e.ball_distance_m[k] * cos - e.ring_y_m;
        let (force, length) = (e.inner_force_n[k], dx.hypot(dy));
        x -= force * dx / length;
        y -= force * dy / length;
        all += force + e.outer_force_n[k];
    }
    [x.hypot(y), all]
}

#[test]
fn light_rings_with_clearance_settle_at_every_angle_and_speed() {
    let mut tries = 0;
    for clearance_um in [5.0, 10.0, 20.0, 50.0] {
        for load in [0.0, 10.0, 100.0, 300.0, 800.0, 1500.0] {
            for rpm in [100.0, 1000.0, 3000.0, 12_000.0] {
                for lead in 0..20 {
                    let mut d = dimensions();
                    d.outer_groove_bottom_radius_m += clearance_um * 1e-6;
                    let mut case = conventional(d);
                    case.operation.radial_load_n = load;
                    case.operation.inner_speed_rad_s = rpm * TAU / 60.0;
                    let lead_rad = TAU / 14.0 * f64::from(lead) / 20.0;
                    let case = at_lead(case, lead_rad);
                    let what = format!("{clearance_um} um {load} N {rpm} rpm lead {lead}");
                    let e = solve(&case).unwrap_or_else(|e| panic!("{what}: {e}"));
                    let [left, all] = balance(&case, &e);
                    assert!(left <= 1e-8 * all, "{what}: {left} of {all} N");
                    tries += 1;
                }
            }
        }
    }
    assert_eq!(tries, 1920);
}

#[test]
fn two_thousand_random_bearings_settle() {
    let mut random = Random(1);
    for k in 0..2000 {
        let case = random_case(&mut random);
        let e = solve(&case).unwrap_or_else(|e| panic!("{k}: {e} {case:?}"));
        let [left, all] = balance(&case, &e);
        assert!(left <= 1e-8 * all, "{k}: {left} of {all} N");
    }
}

/// A second way to the equilibrium: the N distances and the two coordinates of the ring all
/// together, contact by contact, by the method of Levenberg and Marquardt on the total energy
/// with a dense Cholesky factor.
struct AllTogether {
    /// Angle, T, Ri + R, Ki, Ko, steady push, m vt² of each ball.
    balls: Vec<[f64; 7]>,
    down: f64,
}

/// Energy, sum of its absolute terms, gradient, Hessian by rows.
struct Derivatives {
    energy: f64,
    magnitude: f64,
    gradient: Vec<f64>,
    hessian: Vec<Vec<f64>>,
}

impl AllTogether {
    fn new(case: &Case) -> Self {
        let (b, o) = (&case.bearing, &case.operation);
        let d = b.dimensions();
        let rw = d.ball_radius_m;
        let mass = 4.0 / 3.0 * PI * rw.powi(3) * b.materials().ball.density_kg_m3;
        let pitch = 0.5 * (d.inner_groove_bottom_radius_m + d.outer_groove_bottom_radius_m);
        // Pure rolling: half the speed of the inner raceway.
        let speed = 0.5 * o.inner_speed_rad_s * d.inner_groove_bottom_radius_m;
        let turning = mass * speed * speed;
        let doubled = if case.formulation == Formulation::Paper {
            turning / pitch
        } else {
            0.0
        };
        let n = d.balls;
        let [inner_stiffness, outer_stiffness, _] = case.stiffness_n_m1_5();
        let balls = (0..n)
            .map(|k| {
                let angle = case.start.lead_ball_angle_rad + TAU * k as f64 / n as f64;
                [
                    angle,
                    d.outer_groove_bottom_radius_m - rw,
                    d.inner_groove_bottom_radius_m + rw,
                    inner_stiffness,
                    outer_stiffness,
                    mass * o.gravity_m_s2 * angle.cos() + doubled,
                    turning,
                ]
            })
            .collect();
        Self {
            balls,
            down: o.radial_load_n + d.inner_ring_mass_kg * o.gravity_m_s2,
        }
    }

    /// At (X, Y, u1, …), u the distance beyond T.
    fn at(&self, q: &[f64]) -> Derivatives {
        let size = q.len();
        let mut d = Derivatives {
            energy: self.down * q[1],
            magnitude: (self.down * q[1]).abs(),
            gradient: vec![0.0; size],
            hessian: vec![vec![0.0; size]; size],
        };
        d.gradient[1] = self.down;
        for (k, &[angle, touching, reach, ki, ko, steady, turning]) in self.balls.iter().enumerate()
        {
            let (i, u) = (k + 2, q[k + 2]);
            let (ex, ey) = (angle.sin(), -angle.cos());
            let (px, py) = ((touching + u) * ex - q[0], (touching + u) * ey - q[1]);
            let length = px.hypot(py);
            let (nx, ny) = (px / length, py / length);
            let mut add = |term: f64| {
                d.energy += term;
                d.magnitude += term.abs();
            };
            add(-steady * u);
            add(-turning * (u / touching).ln_1p());
            d.gradient[i] -= steady + turning / (touching + u);
            d.hessian[i][i] += turning / (touching + u).powi(2);
            if u > 0.0 {
                add(0.4 * ko * u.powf(2.5));
                d.gradient[i] += ko * u.powf(1.5);
                d.hessian[i][i] += 1.5 * ko * u.sqrt();
            }
            // reach − length by the difference of squares, which keeps 1e-22 m.
            let out = touching + u;
            let nearer = 2.0 * out * (q[0] * ex + q[1] * ey) - q[0] * q[0] - q[1] * q[1];
            let depth = (reach - touching) - u + nearer / (out + length);
            if depth > 0.0 {
                add(0.4 * ki * depth.powf(2.5));
                let (force, slope) = (ki * depth.powf(1.5), 1.5 * ki * depth.sqrt());
                // d(length) = j·dq, and the curvature of the length.
                let j = [-nx, -ny, nx * ex + ny * ey];
                let t = [ny, -nx, -(ny * ex - nx * ey)];
                let at = [0, 1, i];
                for a in 0..3 {
                    d.gradient[at[a]] -= force * j[a];
                    for b in 0..3 {
                        d.hessian[at[a]][at[b]] +=
                            slope * j[a] * j[b] - force / length * t[a] * t[b];
                    }
                }
            }
        }
        d
    }

    /// (H + λ)p = −g by Cholesky; `None` if that is not positive definite.
    fn damped_step(d: &Derivatives, damping: f64) -> Option<Vec<f64>> {
        let n = d.gradient.len();
        let mut l = d.hessian.clone();
        let mut p: Vec<f64> = d.gradient.iter().map(|g| -g).collect();
        for i in 0..n {
            l[i][i] += damping;
            for j in 0..=i {
                let (rows, last) = l.split_at(i);
                let row = if j < i { &rows[j] } else { &last[0] };
                let dot: f64 = (0..j).map(|k| last[0][k] * row[k]).sum();
                let rest = l[i][j] - dot;
                l[i][j] = if i > j {
                    rest / l[j][j]
                } else if rest > 0.0 {
                    rest.sqrt()
                } else {
                    return None;
                };
            }
        }
        for i in 0..n {
            let dot: f64 = (0..i).map(|k| l[i][k] * p[k]).sum();
            p[i] = (p[i] - dot) / l[i][i];
        }
        for i in (0..n).rev() {
            let dot: f64 = (i + 1..n).map(|k| l[k][i] * p[k]).sum();
            p[i] = (p[i] - dot) / l[i][i];
        }
        Some(p)
    }

    fn minimum(&self, ring: [f64; 2]) -> (Vec<f64>, Derivatives) {
        let norm = |v: &[f64]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
        let mut q = ring.to_vec();
        q.resize(self.balls.len() + 2, 0.0);
        let mut here = self.at(&q);
        let mut damping = 1e8;
        for _ in 0..2000 {
            let Some(p) = Self::damped_step(&here, damping) else {
                damping = (damping * 4.0).max(1e-6);
                continue;
            };
            if norm(&p) < 1e-19 {
                break;
            }
            let tried: Vec<f64> = q.iter().zip(&p).map(|(q, p)| q + p).collect();
            let there = self.at(&tried);
            let noise = 1e-14 * here.magnitude;
            let change = there.energy - here.energy;
            let finer = change.abs() <= noise && norm(&there.gradient) < norm(&here.gradient);
            if change < -noise || finer {
                (q, here) = (tried, there);
                damping *= 0.2;
            } else if damping > 1e14 {
                break;
            } else {
                damping = (damping * 4.0).max(1e-6);
            }
        }
        (q, here)
    }
}

#[test]
fn two_hundred_random_bearings_settle_where_an_independent_method_has_them() {
    let mut random = Random(2);
    let mut worst = 0f64;
    for k in 0..200 {
        let case = random_case(&mut random);
        let e = solve(&case).unwrap();
        let other = AllTogether::new(&case);
        let depth = 0.5 * case.bearing.radial_internal_clearance_m() + 1e-5;
        let found = [0.7, -0.7, 0.1].map(|side| other.minimum([side * depth, -depth]));
        let (q, _) = found
            .iter()
            .min_by(|a, b| a.1.energy.total_cmp(&b.1.energy))
            .unwrap();
        let away = (q[0] - e.ring_x_m).hypot(q[1] - e.ring_y_m);
        let displacement = e.ring_x_m.hypot(e.ring_y_m);
        worst = worst.max(away / displacement);
        if away > 1e-6 * displacement {
            println!(
                "{k}: {q:.9?} against {} {} {:?} {:?}",
                e.ring_x_m,
                e.ring_y_m,
                case.operation,
                case.bearing.dimensions()
            );
        }
    }
    println!("largest difference {worst:e}");
    assert!(worst < 1e-6, "{worst:e}");
}

/// A ring on one ball at the very bottom slides off it, to the right where both sides are
/// alike.
#[test]
fn a_ring_on_one_ball_falls_to_the_right() {
    let mut d = dimensions();
    d.outer_groove_bottom_radius_m += 50e-6;
    let mut case = conventional(d);
    case.operation.radial_load_n = 0.0;
    case.operation.inner_speed_rad_s = 10.0;
    let at = |lead: f64| solve(&at_lead(case.clone(), lead)).unwrap();
    assert!(at(0.0).ring_x_m > 5e-6, "{}", at(0.0).ring_x_m);
    // A ball to the right of the bottom lets it down on the left, and the other way round.
    let (left, right) = (at(1e-3), at(-1e-3));
    assert!(left.ring_x_m * right.ring_x_m < 0.0);
    assert!((left.ring_x_m + right.ring_x_m).abs() < 1e-12);
    assert!((left.ring_y_m - right.ring_y_m).abs() < 1e-12);
}

#[test]
fn a_ring_that_no_ball_carries_is_refused_with_the_reason() {
    let mut case = conventional(dimensions());
    case.bearing = {
        let mut d = dimensions();
        d.balls = 3;
        Bearing::new(d, steel()).unwrap()
    };
    let room = 3.0 * case.bearing.nominal_gap_rad();
    case.start = Start::new(StartState::Settled, Gaps::List(vec![0.0, 0.0, room]), PI);
    let error = solve(&case).unwrap_err();
    assert_eq!(error, EquilibriumError::Unsupported);
    assert_eq!(space::solve(&case).unwrap_err(), error);
    assert!(error.to_string().contains("start.gaps"), "{error}");
}
