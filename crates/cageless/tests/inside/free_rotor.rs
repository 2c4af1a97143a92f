//! A rotor that touches nothing against its own linear equations.

use super::linear_rotor::{SPEED_RAD_S, bearing, dropped, rigid};
use cageless::IntegrationMethod;
use cageless::linear_rotor::{Complex, DMatrix, DVector, Reduction, RotorMatrices};
use cageless::simulation::RotorDrop;

/// A steel shaft of 0.4 m in beam elements with two discs.
pub fn shaft(elements: usize) -> RotorMatrices {
    let (modulus, density, diameter): (f64, f64, f64) = (2.06e11, 7850.0, 0.03);
    let l = 0.4 / elements as f64;
    let area = std::f64::consts::PI * diameter.powi(2) / 4.0;
    let stiffness = modulus * std::f64::consts::PI * diameter.powi(4) / 64.0 / l.powi(3);
    let mass = density * area * l / 420.0;
    let size = 4 * (elements + 1);
    let mut m = DMatrix::zeros(size, size);
    let mut k = DMatrix::zeros(size, size);
    let mut g = DMatrix::zeros(size, size);
    let bending = [
        [12.0, 6.0 * l, -12.0, 6.0 * l],
        [6.0 * l, 4.0 * l * l, -6.0 * l, 2.0 * l * l],
        [-12.0, -6.0 * l, 12.0, -6.0 * l],
        [6.0 * l, 2.0 * l * l, -6.0 * l, 4.0 * l * l],
    ];
    let inertia = [
        [156.0, 22.0 * l, 54.0, -13.0 * l],
        [22.0 * l, 4.0 * l * l, 13.0 * l, -3.0 * l * l],
        [54.0, 13.0 * l, 156.0, -22.0 * l],
        [-13.0 * l, -3.0 * l * l, -22.0 * l, 4.0 * l * l],
    ];
    for element in 0..elements {
        // x with β, y with −α.
        for (places, sign) in [([0, 3, 4, 7], 1.0), ([1, 2, 5, 6], -1.0)] {
            let signs = [1.0, sign, 1.0, sign];
            for row in 0..4 {
                for column in 0..4 {
                    let at = (4 * element + places[row], 4 * element + places[column]);
                    let s = signs[row] * signs[column];
                    m[at] += s * mass * inertia[row][column];
                    k[at] += s * stiffness * bending[row][column];
                }
            }
        }
    }
    let (disc, polar, transverse) = (4.0, 0.02, 0.011);
    for node in [elements / 4, elements - 1] {
        for (place, value) in [(0, disc), (1, disc), (2, transverse), (3, transverse)] {
            m[(4 * node + place, 4 * node + place)] += value;
        }
        g[(4 * node + 2, 4 * node + 3)] = polar;
        g[(4 * node + 3, 4 * node + 2)] = -polar;
    }
    RotorMatrices {
        damping: &k * 1e-6,
        spin_up: g.clone(),
        added_mass: DMatrix::zeros(size, size),
        housings: 0,
        mass: m,
        gyroscopic: g,
        stiffness: k,
        polar_inertia_kg_m2: 0.041,
    }
}

/// The shaft of four elements on two unequal housings, with some fluid about its middle.
fn on_housings() -> RotorMatrices {
    let shaft = shaft(4);
    let size = shaft.mass.nrows();
    let grown = |matrix: &DMatrix<f64>| matrix.clone().resize(size + 4, size + 4, 0.0);
    let mut m = RotorMatrices {
        mass: grown(&shaft.mass),
        added_mass: grown(&shaft.added_mass),
        damping: grown(&shaft.damping),
        gyroscopic: grown(&shaft.gyroscopic),
        stiffness: grown(&shaft.stiffness),
        spin_up: grown(&shaft.spin_up),
        housings: 2,
        ..shaft
    };
    for (node, housing, kg) in [(0, size, 3.0), (4, size + 2, 2.0)] {
        for axis in [0, 1] {
            let (on, under) = (4 * node + axis, housing + axis);
            m.mass[(under, under)] = kg;
            for (matrix, link, ground) in
                [(&mut m.stiffness, 2e6, 5e6), (&mut m.damping, 300.0, 100.0)]
            {
                matrix[(on, on)] += link;
                matrix[(on, under)] -= link;
                matrix[(under, on)] -= link;
                matrix[(under, under)] += link + ground;
            }
        }
    }
    (m.added_mass[(8, 8)], m.added_mass[(9, 9)]) = (1.5, 1.5);
    m
}

/// A rotor on housings has its own mass, and the housing on which a journal rests hangs on it in
/// part.
#[test]
fn housings_are_no_mass_of_the_rotor_but_weigh_on_its_bearings() {
    let matrices = on_housings();
    let of = |matrices: &RotorMatrices| {
        let reduction = Reduction {
            bearing_nodes: vec![0, 4],
            frequency_max_hz: Some(2000.0),
            ..Reduction::default()
        };
        matrices.reduce(&reduction).unwrap()
    };
    let (rotor, alone) = (of(&matrices), of(&shaft(4)));
    assert!((rotor.mass_kg / alone.mass_kg - 1.0).abs() < 1e-12);
    // Held at the journal, a housing of mass m between springs k and K hangs on it with m·k/(k + K).
    let shares = rotor.mass_shares_kg();
    for (k, kg) in [(0, 3.0), (1, 2.0)] {
        let own = alone.mass_shares_kg()[k];
        let expected = own + kg * 2.0 / 7.0;
        assert!((shares[k] / expected - 1.0).abs() < 1e-9, "{shares:?}");
    }
    let said = |change: fn(&mut RotorMatrices)| {
        let mut matrices = on_housings();
        change(&mut matrices);
        let reduction = Reduction {
            bearing_nodes: vec![0, 4],
            ..Reduction::default()
        };
        matrices.reduce(&reduction).unwrap_err().to_string()
    };
    assert_eq!(
        said(|m| m.housings = 1),
        "matrix M must be of four coordinates a node, [x, y, α, β], not 24 in all with two of each \
         of 1 housings, [x, y]"
    );
    assert!(said(|m| m.housings = usize::MAX).contains("not 24 in all"));
    assert!(said(|m| m.added_mass[(8, 8)] = -9.0).contains("M + Ma must be positive definite"));
    assert!(said(|m| m.added_mass[(8, 9)] = 1.0).contains("matrix Ma must be symmetric"));
}

/// Exact test 9, eigenvalues: those of the full matrices, also where cross-coupled stiffness tells
/// forward from backward whirl.
#[test]
fn eigenvalues_are_those_of_the_matrices() {
    let matrices = shaft(6);
    let found = eigenvalues_of(&matrices);
    // With the modes up to four times the highest of interest: 1e-3 of the lowest ones.
    let few = matrices.reduce(&Reduction {
        bearing_nodes: vec![0, 6],
        frequency_max_hz: Some(4.0 * found[3].im / std::f64::consts::TAU),
        ..Reduction::default()
    });
    let few = few.unwrap();
    assert!(few.coordinates() < matrices.mass.nrows());
    for value in found.iter().take(3) {
        let near = few.eigenvalues(SPEED_RAD_S).unwrap().into_iter();
        let miss = near.fold(f64::INFINITY, |least, e| least.min((e - value).norm()));
        assert!(miss < 1e-3 * value.norm(), "{value} {miss}");
    }
    let mut sealed = shaft(6);
    for node in [0, 3, 6] {
        let (x, y) = (4 * node, 4 * node + 1);
        (sealed.stiffness[(x, x)], sealed.stiffness[(y, y)]) = (
            sealed.stiffness[(x, x)] + 1e6,
            sealed.stiffness[(y, y)] + 1.5e6,
        );
        sealed.stiffness[(x, y)] += 2e5;
        sealed.stiffness[(y, x)] -= 2e5;
        sealed.damping[(x, y)] += 100.0;
    }
    eigenvalues_of(&sealed);
    let rotor = sealed.reduce(&Reduction {
        bearing_nodes: vec![0, 6],
        ..Reduction::default()
    });
    let fastest_growth = |speed: f64| {
        let values = rotor.as_ref().unwrap().eigenvalues(speed).unwrap();
        let values = values.into_iter();
        values.fold(f64::NEG_INFINITY, |most, e| most.max(e.re))
    };
    let [forward, backward] = [SPEED_RAD_S, -SPEED_RAD_S].map(fastest_growth);
    assert!(
        (forward - backward).abs() > 0.01 * forward.abs(),
        "{forward} {backward}"
    );
}

#[test]
fn a_speed_beyond_all_numbers_has_no_eigenvalues() {
    let rotor = shaft(2).reduce(&Reduction {
        bearing_nodes: vec![0, 2],
        ..Reduction::default()
    });
    let rotor = rotor.unwrap();
    for speed_rad_s in [f64::NAN, f64::INFINITY, 1e200, 1e300] {
        assert_eq!(rotor.eigenvalues(speed_rad_s), None, "{speed_rad_s}");
    }
    let found = rotor.eigenvalues(1e6).unwrap();
    assert!(
        found
            .iter()
            .all(|value| value.re.is_finite() && value.im.is_finite())
    );
}

/// Those of the rotor with all of its modes, the slowest first, of which eight are compared.
fn eigenvalues_of(matrices: &RotorMatrices) -> Vec<Complex<f64>> {
    let reduction = Reduction {
        bearing_nodes: vec![0, 6],
        ..Reduction::default()
    };
    let rotor = matrices.reduce(&reduction).unwrap();
    assert_eq!(rotor.coordinates(), matrices.mass.nrows());
    let mut found: Vec<Complex<f64>> = rotor.eigenvalues(SPEED_RAD_S).unwrap();
    found.retain(|e| e.im > 100.0);
    found.sort_by(|a, b| a.im.total_cmp(&b.im));
    assert!(found.len() > 6);
    for value in found.iter().take(8) {
        let exact = eigenvalue_near(matrices, *value);
        assert!(
            (value - exact).norm() < 1e-9 * exact.norm(),
            "{value} {exact}"
        );
    }
    found
}

/// The eigenvalue of λ²·M + λ·(C + Ω·G) + K near a value: Newton's method with its eigenvector.
fn eigenvalue_near(matrices: &RotorMatrices, value: Complex<f64>) -> Complex<f64> {
    let complex = |matrix: &DMatrix<f64>| matrix.map(|v| Complex::new(v, 0.0));
    let rates = &matrices.damping + &matrices.gyroscopic * SPEED_RAD_S;
    let [m, c, k] = [&matrices.mass, &rates, &matrices.stiffness].map(complex);
    // Off the eigenvalue, where the equations can be solved.
    let mut value = value * 1.000_01;
    let mut vector = DVector::from_fn(m.nrows(), |k, _| Complex::new(1.0, 0.3 * k as f64));
    for _ in 0..12 {
        let pencil = &m * (value * value) + &c * value + &k;
        let slope = &m * (value * 2.0) + &c;
        let Some(next) = pencil.lu().solve(&(slope * &vector)) else {
            break;
        };
        let place = next.icamax();
        value -= vector[place] / next[place];
        vector = &next / next[place];
    }
    value
}

/// Exact test 9, response: a rotor that touches nothing moves as its linear equations say,
/// exp(A·t) with A from the full matrices.
#[test]
fn a_rotor_without_contact_moves_as_its_matrices_say() {
    moves_as_its_matrices_say(&shaft(4));
    moves_as_its_matrices_say(&on_housings());
}

fn moves_as_its_matrices_say(matrices: &RotorMatrices) {
    let bearing_nodes = vec![0, 3];
    let reduction = Reduction {
        bearing_nodes: bearing_nodes.clone(),
        ..Reduction::default()
    };
    let rotor = matrices.reduce(&reduction).unwrap();
    let mut cases = vec![bearing(IntegrationMethod::Adaptive); 2];
    for (case, [vx, vy]) in cases.iter_mut().zip([[0.02, -0.01], [-0.015, 0.03]]) {
        let journal = case.rotor.as_mut().unwrap();
        (journal.x_m, journal.y_m) = (0.0, 0.0);
        (journal.vx_m_s, journal.vy_m_s) = (vx, vy);
        case.solver.tolerance = 1e-12;
    }
    let drop = RotorDrop::new(rotor, SPEED_RAD_S, 0.0, cases, Some(1e-5)).unwrap();
    let outcome = dropped(&drop);
    // Beside the energy of the spin, hardly any flows.
    assert!(outcome.rotor.energy_residual_relative.abs() < 1e-6);
    // State [q, q̇, 1] of the full matrices, from the static shape of the journals' velocities.
    let n = matrices.mass.nrows();
    let inverse = (&matrices.mass + &matrices.added_mass)
        .try_inverse()
        .unwrap();
    let shaft = n - 2 * matrices.housings;
    let upwards = DVector::from_fn(n, |k, _| {
        let y = if k < shaft { k % 4 } else { k % 2 };
        if y == 1 { 1.0 } else { 0.0 }
    });
    let mut a = DMatrix::zeros(2 * n + 1, 2 * n + 1);
    a.view_mut((0, n), (n, n)).fill_with_identity();
    let rates = &matrices.damping + &matrices.gyroscopic * SPEED_RAD_S;
    a.view_mut((n, 0), (n, n))
        .copy_from(&-(&inverse * &matrices.stiffness));
    a.view_mut((n, n), (n, n)).copy_from(&-(&inverse * rates));
    let weight = &inverse * (&matrices.mass * upwards) * -9.81;
    a.view_mut((n, 2 * n), (n, 1)).copy_from(&weight);
    let velocities = static_shape(matrices, &bearing_nodes, &[0.02, -0.01, -0.015, 0.03]);
    let mut start = DVector::zeros(2 * n + 1);
    start[2 * n] = 1.0;
    start.rows_mut(n, n).copy_from(&velocities);
    let end = (a * 2e-3).exp() * start;
    for (k, node) in bearing_nodes.iter().enumerate() {
        let journal = outcome.bearings[k].state.rotor_motion().unwrap();
        for (value, place, scale) in [
            (journal.x, 4 * node, 1e-5),
            (journal.y, 4 * node + 1, 1e-5),
            (journal.vx, n + 4 * node, 0.1),
            (journal.vy, n + 4 * node + 1, 0.1),
        ] {
            let error = (value - end[place]) / scale;
            println!("node {node}: {error:.1e}");
            assert!(error.abs() < 1e-6, "{value} {} {error:e}", end[place]);
        }
    }
}

/// A rigid rotor whose axis is kicked in its clearance precesses in the direction of its rotation:
/// with s = sx + i·sy, It·s̈ = i·Ip·Ω·ṡ, so that s = ṡ0·(e^(iλt) − 1)/(iλ) with λ = Ω·Ip/It.
#[test]
fn a_kicked_axis_precesses_forwards() {
    for speed in [SPEED_RAD_S, -SPEED_RAD_S] {
        let mut cases = vec![bearing(IntegrationMethod::Adaptive); 2];
        for (case, kick) in cases.iter_mut().zip([-0.02, 0.02]) {
            let journal = case.rotor.as_mut().unwrap();
            (journal.y_m, journal.vx_m_s, journal.vy_m_s) = (0.0, kick, 0.0);
        }
        let rotor = rigid([-0.15, 0.15]).linear().unwrap();
        let drop = RotorDrop::new(rotor, speed, 0.0, cases, Some(1e-5)).unwrap();
        let outcome = dropped(&drop);
        let (rate, t) = (speed * 0.04 / 0.6, 2e-3);
        let expected = [
            0.02 * (rate * t).sin() / rate,
            0.02 * (1.0 - (rate * t).cos()) / rate,
        ];
        let [near, far] = [0, 1].map(|k| outcome.bearings[k].state.rotor_motion().unwrap());
        let tilt = [0.5 * (far.x - near.x), 0.5 * (far.y - near.y)];
        for (value, exact) in tilt.iter().zip(expected) {
            assert!(
                (value - exact).abs() < 1e-11,
                "{speed}: {tilt:?} {expected:?}"
            );
        }
        assert!(tilt[1] * speed > 8e-6 * speed.abs());
    }
}

/// A free rotor under the torque of a drive, with a Ksdt that is not G and stiffness that is not
/// symmetric: the full linear equations with Ω = Ω0 + τ/Ip·t, by the classical Runge–Kutta method.
#[test]
fn a_driven_rotor_moves_as_its_matrices_say() {
    let mut matrices = shaft(4);
    for node in [1, 3] {
        // As ross has it: the lower triangle alone.
        let (a, b) = (4 * node + 2, 4 * node + 3);
        (matrices.spin_up[(a, b)], matrices.spin_up[(b, a)]) = (0.0, -0.04);
    }
    (matrices.stiffness[(8, 9)], matrices.stiffness[(9, 8)]) = (3e5, -3e5);
    let (nodes, duration, torque) = ([0, 4], 1e-3, 6e4);
    let rotor = matrices.reduce(&Reduction {
        bearing_nodes: nodes.to_vec(),
        ..Reduction::default()
    });
    let velocities = [0.05, -0.04, -0.03, 0.06];
    let mut cases = vec![bearing(IntegrationMethod::Adaptive); 2];
    for (k, case) in cases.iter_mut().enumerate() {
        let journal = case.rotor.as_mut().unwrap();
        (journal.x_m, journal.y_m) = (0.0, 0.0);
        (journal.vx_m_s, journal.vy_m_s) = (velocities[2 * k], velocities[2 * k + 1]);
        (case.solver.tolerance, case.solver.duration_s) = (1e-12, duration);
    }
    let rotor = rotor.unwrap();
    let drop = RotorDrop::new(rotor, SPEED_RAD_S, torque, cases, Some(1e-5)).unwrap();
    let outcome = dropped(&drop);
    assert!(outcome.rotor.energy_residual_relative.abs() < 1e-6);
    let spin_up = torque / matrices.polar_inertia_kg_m2;
    let n = matrices.mass.nrows();
    let inverse = matrices.mass.clone().try_inverse().unwrap();
    let weight = DVector::from_fn(n, |k, _| if k % 4 == 1 { -9.81 } else { 0.0 });
    let rate = |t: f64, q: &DVector<f64>, v: &DVector<f64>| {
        let speed = SPEED_RAD_S + spin_up * t;
        let load = &matrices.damping * v
            + &matrices.gyroscopic * v * speed
            + &matrices.stiffness * q
            + &matrices.spin_up * q * spin_up;
        &weight - &inverse * load
    };
    let (mut q, mut v) = (
        DVector::zeros(n),
        static_shape(&matrices, &nodes, &velocities),
    );
    let steps = 8000;
    let h = duration / f64::from(steps);
    for k in 0..steps {
        let t = f64::from(k) * h;
        let a1 = rate(t, &q, &v);
        let (q2, v2) = (&q + &v * (0.5 * h), &v + &a1 * (0.5 * h));
        let a2 = rate(t + 0.5 * h, &q2, &v2);
        let (q3, v3) = (&q + &v2 * (0.5 * h), &v + &a2 * (0.5 * h));
        let a3 = rate(t + 0.5 * h, &q3, &v3);
        let (q4, v4) = (&q + &v3 * h, &v + &a3 * h);
        let a4 = rate(t + h, &q4, &v4);
        q += (&v + (&v2 + &v3) * 2.0 + &v4) * (h / 6.0);
        v += (a1 + (a2 + a3) * 2.0 + a4) * (h / 6.0);
    }
    for (k, node) in nodes.iter().enumerate() {
        let journal = outcome.bearings[k].state.rotor_motion().unwrap();
        let speed = SPEED_RAD_S + spin_up * duration;
        assert!(
            (journal.speed / speed - 1.0).abs() < 1e-12,
            "{}",
            journal.speed
        );
        for (value, exact, scale) in [
            (journal.x, q[4 * node], 1e-5),
            (journal.y, q[4 * node + 1], 1e-5),
            (journal.vx, v[4 * node], 0.1),
            (journal.vy, v[4 * node + 1], 0.1),
        ] {
            let error = (value - exact) / scale;
            println!("node {node}: {error:.1e}");
            assert!(error.abs() < 1e-6, "{value} {exact} {error:e}");
        }
    }
}

/// Velocities of all coordinates where those of the given nodes are given and the rest follows
/// without force.
fn static_shape(matrices: &RotorMatrices, nodes: &[usize], velocities: &[f64]) -> DVector<f64> {
    let n = matrices.mass.nrows();
    let stiffness = (&matrices.stiffness + matrices.stiffness.transpose()) * 0.5;
    let given: Vec<usize> = nodes.iter().flat_map(|k| [4 * k, 4 * k + 1]).collect();
    let free: Vec<usize> = (0..n).filter(|k| !given.contains(k)).collect();
    let part =
        |rows: &[usize], columns: &[usize]| stiffness.select_rows(rows).select_columns(columns);
    let velocities = DVector::from_column_slice(velocities);
    let rest = -part(&free, &free).try_inverse().unwrap() * part(&free, &given) * &velocities;
    let mut all = DVector::zeros(n);
    for (value, place) in velocities.iter().zip(&given) {
        all[*place] = *value;
    }
    for (value, place) in rest.iter().zip(&free) {
        all[*place] = *value;
    }
    all
}
