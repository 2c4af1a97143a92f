//! Data of a run.

use super::*;

pub fn run_data() -> RunData {
    let bearing = bearing();
    let outline = BearingOutline::new(&bearing);
    let raceway = raceway(3);
    let r = rolling(Some(&raceway), 0.5, 0.0006);
    let gap = gaps(&r.angle, outline.ball_angle_deg);
    let balls = (0..14)
        .map(|k| {
            let psi: Vec<f64> = r.angle[k].iter().map(|a| a.to_radians()).collect();
            let load = |a: &f64| 700.0 * a.cos().max(0.0).powf(1.5);
            let v: Vec<f64> = r.speed[k]
                .iter()
                .map(|s| s.to_radians() * 23.0025e-3)
                .collect();
            BallHistory {
                angle_deg: r.angle[k].clone(),
                gap_deg: gap[k].clone(),
                orbit_speed_deg_s: r.speed[k].clone(),
                inner_sliding_m_s: psi
                    .iter()
                    .map(|a| 0.02 * (1.0 - a.cos()) + 0.01 * (5.0 * a).sin())
                    .collect(),
                outer_sliding_m_s: psi.iter().map(|a| -0.01 * (1.0 - a.cos())).collect(),
                inner_force_n: psi.iter().map(load).collect(),
                outer_force_n: psi.iter().map(|a| load(a) + 22.0).collect(),
                x_mm: psi.iter().map(|a| 23.0025 * a.sin()).collect(),
                vx_m_s: psi.iter().zip(&v).map(|(a, v)| v * a.cos()).collect(),
                vy_m_s: psi.iter().zip(&v).map(|(a, v)| v * a.sin()).collect(),
                ..BallHistory::default()
            }
        })
        .collect();
    let ring = |f: fn(f64) -> f64| r.time.iter().map(|t| f(*t)).collect::<Vec<f64>>();
    RunData {
        case_toml: "title = \"</script><b>\"\n".into(),
        title: "Zhao 2022, structure (d) <synthetic>".into(),
        software: "cageless 0.1.0".into(),
        lead: "Synthetic data: nothing here was simulated.".into(),
        passes: Some(false),
        headline: "does not work in this run: double collision".into(),
        warnings: vec!["A warning with <angle brackets> & an ampersand.".into()],
        parameters: table1(),
        results: vec![
            parameter("Collisions", "", "214", "", ""),
            parameter("Smallest gap", "", "−0.0021", "°", ""),
        ],
        outline,
        sectors: vec![RacewaySector::new(&raceway)],
        settled_after_s: 0.1,
        uniform_gap_deg: 1.8161,
        rolling_orbit_speed_deg_s: Some(28_551.0),
        time_s: r.time.clone(),
        balls,
        ring: RingHistory {
            x_um: ring(|t| 0.6 * (t * 1759.0).sin() + 2.0 * (-t * 60.0).exp()),
            y_um: ring(|t| {
                -22.0 + 0.4 * (t * 1759.0).cos() + 9.0 * (-t * 50.0).exp() * (t * 3000.0).cos()
            }),
            time_s: r.time.clone(),
        },
        stretch_s: None,
        recent: None,
        view_s: Some([0.45, 0.5]),
        facts: vec![parameter("Peak pressure", "", "2100", "MPa", "")],
        load_profile: Some(LoadProfile {
            to_s: 0.5,
            angle_deg: vec![0.0, 90.0, 180.0, 270.0],
            inner_force_mean_n: vec![600.0, 0.0, 0.0, f64::NAN],
            inner_force_max_n: vec![700.0, 10.0, 0.0, f64::NAN],
            outer_force_mean_n: vec![622.0, 22.0, 22.0, 22.0],
            outer_force_max_n: vec![722.0, 32.0, 22.0, 22.0],
            inner_pressure_max_mpa: vec![2100.0, 500.0, 0.0, f64::NAN],
            outer_pressure_max_mpa: vec![1900.0, 700.0, 600.0, 600.0],
            ..LoadProfile::default()
        }),
        passages: vec![("passage of ball 1 <free>".into(), [0.1, 0.105])],
        collisions_total: 214,
        collisions: (0..214_u32)
            .map(|k| CollisionPoint {
                time_s: 0.002 + 0.0023 * f64::from(k),
                ball: k as usize % 14 + 1,
                next_ball: (k as usize + 1) % 14 + 1,
                angle_deg: 20.0 * (f64::from(k) * 0.7).sin() + if k % 9 == 0 { 100.0 } else { 0.0 },
                approach_speed_m_s: 0.05,
                peak_force_n: 12.0,
                impulse_n_s: 2e-4 * (1.0 + (f64::from(k) * 1.3).sin()),
            })
            .collect(),
        energy: [
            ("work of the drive", 812.0),
            ("friction, inner raceway", -401.3),
            ("friction, outer raceway", -322.0),
            ("damping", -88.1),
            ("change of kinetic energy", -0.55),
        ]
        .map(|(name, energy_j)| EnergyItem {
            name: name.into(),
            energy_j,
        })
        .to_vec(),
        energy_residual_relative: Some(3.2e-7),
        verification: Some(VerificationTable {
            facts: vec![cageless_study::parameter(
                "predictability",
                "<synthetic>".into(),
                "",
            )],
            rows: [
                ["result", "value", "unit", "verdict", "reason"],
                [
                    "smallest gap",
                    "−0.0021",
                    "°",
                    "converged",
                    "changes by 1e-7 & less",
                ],
                ["mean displacement", "−22.4", "µm", "step-biased", "z = −10"],
            ]
            .map(|row| row.map(str::to_owned).to_vec())
            .to_vec(),
        }),
        vibration: Some(vibration(&[
            ("outer ring, x", 20.0),
            ("outer ring, y", 31.0),
        ])),
        motion: Some(motion("Structure (d)", &[raceway], 0.0, "physical")),
        provenance: source(3, "physical"),
    }
}
