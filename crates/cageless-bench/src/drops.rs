//! What a discrete raceway does in the drop of a rotor: the same scattered drops with a
//! conventional and with discrete raceways, at two speeds, dry and lubricated.

use std::path::PathBuf;

use anyhow::{Context, Result};
use cageless::touchdown::Scatter;
use cageless_io::case_file::CaseFile;
use cageless_study::Silent;
use cageless_study::drop::{DropRow, EnsembleResult, ensemble};
use clap::Args;

#[derive(Debug, Args)]
pub struct Options {
    /// Folder of the cases.
    #[arg(long, default_value = "cases")]
    cases: PathBuf,
    /// Drops of each cell.
    #[arg(long, default_value_t = 16)]
    samples: u64,
    /// Simulated time of each drop, s.
    #[arg(long, default_value_t = 0.3)]
    duration_s: f64,
}

/// A discrete raceway: its name, lC (mm) and θ (°).
type Raceway = (&'static str, [f64; 2]);

/// Bearings: name, case, and its discrete raceways.
const BEARINGS: [(&str, &str, &[Raceway]); 2] = [
    (
        "paper",
        "touchdown-d.toml",
        &[("paper's (d)", [5.1, 25.2]), ("searched", [5.09, 24.6])],
    ),
    (
        "full 6205",
        "touchdown-6205.toml",
        &[("searched", [2.974, 12.07])],
    ),
];
const SPEEDS_RPM: [f64; 2] = [10_000.0, 30_000.0];
/// Friction coefficients of the balls and of rotor on ring.
const FRICTION: [(&str, f64, f64); 2] = [("dry", 0.1, 0.15), ("lubricated", 0.007, 0.05)];

pub fn run(options: &Options) -> Result<()> {
    println!(
        "{} drops of {} s each; mean ± standard error of the difference to the conventional ring \
         in the same drops\n",
        options.samples, options.duration_s
    );
    println!(
        "| bearing | speed, rpm | friction | raceway | backward whirl, % | collisions | largest \
         pressure, MPa | ball sliding, m/s | heat at the balls, J | spin-up, ms | largest force, \
         weights |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|---|");
    for (bearing, case, raceways) in BEARINGS {
        for rpm in SPEEDS_RPM {
            for (name, balls, rotor) in FRICTION {
                let row = |raceway: &str, values: Option<[f64; 2]>| {
                    let result = drops(options, case, rpm, [balls, rotor], values)
                        .with_context(|| format!("{bearing}, {raceway}"))?;
                    let head = format!("| {bearing} | {rpm} | {name} | {raceway} |");
                    Ok::<_, anyhow::Error>((head, result))
                };
                let (head, plain) = row("conventional", None)?;
                println!("{head}{}", cells(&plain, None));
                for (label, values) in raceways {
                    let (head, discrete) = row(label, Some(*values))?;
                    println!("{head}{}", cells(&discrete, Some(&plain)));
                }
            }
        }
    }
    Ok(())
}

fn drops(
    options: &Options,
    case: &str,
    rpm: f64,
    [balls, rotor]: [f64; 2],
    raceway: Option<[f64; 2]>,
) -> Result<EnsembleResult> {
    let mut set = vec![
        format!("rotor.speed_rpm={rpm}"),
        format!("contact.friction_coefficient={balls}"),
        format!("rotor.friction_coefficient={rotor}"),
        format!("solver.duration_s={}", options.duration_s),
    ];
    if let Some([span, angle]) = raceway {
        set.push(format!("raceway.axial_span_mm={span}"));
        set.push(format!("raceway.half_angle_deg={angle}"));
    }
    let file = CaseFile::read(&options.cases.join(case), &set)?;
    let mut case = file.case().clone();
    if raceway.is_none() {
        case.raceways.clear();
    }
    Ok(ensemble(
        &case,
        options.samples,
        &Scatter::default(),
        &Silent,
    )?)
}

/// Results of a drop that are compared.
const COMPARED: [fn(&DropRow) -> Option<f64>; 6] = [
    |d| Some(d.result.collisions as f64),
    |d| {
        Some(
            d.result
                .inner_stress_max_mpa
                .max(d.result.outer_stress_max_mpa),
        )
    },
    |d| Some(d.result.ball_slip_max_m_s),
    |d| {
        let r = &d.result;
        Some(r.inner_friction_j + r.outer_friction_j + r.ball_friction_j)
    },
    |d| d.result.spin_up_ms,
    |d| d.result.rotor_force_max_weights,
];

fn cells(result: &EnsembleResult, plain: Option<&EnsembleResult>) -> String {
    let whirl = result
        .backward_whirl_interval
        .zip(result.backward_whirl_probability)
        .map_or("-".to_owned(), |([low, high], p)| {
            format!("{:.0} ({:.0} to {:.0})", 1e2 * p, 1e2 * low, 1e2 * high)
        });
    let mut text = format!(" {whirl} |");
    for of in COMPARED {
        let values: Vec<f64> = result.drops.iter().filter_map(of).collect();
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        let missing = result.drops.len() - values.len();
        let difference = plain.map(|plain| difference(&result.drops, &plain.drops, of));
        text += &match (values.is_empty(), difference.flatten()) {
            (true, _) => " - |".to_owned(),
            (_, None) => format!(" {mean:.4}{} |", without(missing)),
            (_, Some([d, s])) => format!(" {mean:.4} ({d:+.3} ± {s:.3}){} |", without(missing)),
        };
    }
    text
}

/// How many drops have no such result.
fn without(missing: usize) -> String {
    if missing == 0 {
        return String::new();
    }
    format!(", {missing} without")
}

/// Mean of the paired differences and its standard error.
fn difference(
    one: &[DropRow],
    other: &[DropRow],
    of: fn(&DropRow) -> Option<f64>,
) -> Option<[f64; 2]> {
    let pairs: Vec<f64> = (one.iter().zip(other))
        .filter_map(|(a, b)| Some(of(a)? - of(b)?))
        .collect();
    let n = pairs.len() as f64;
    if n < 2.0 {
        return None;
    }
    let mean = pairs.iter().sum::<f64>() / n;
    let variance = pairs.iter().map(|d| (d - mean).powi(2)).sum::<f64>() / (n - 1.0);
    Some([mean, (variance / n).sqrt()])
}
