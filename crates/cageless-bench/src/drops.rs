//! What a discrete raceway does in the drop of a rotor: the same scattered drops with a
//! conventional and with discrete raceways, at two speeds, dry and lubricated, and from which
//! friction on the balls rattle.

use std::path::PathBuf;
use std::time::Instant;

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
    /// Drops of each row.
    #[arg(long, default_value_t = 16)]
    samples: u64,
    /// Simulated time of each drop, s.
    #[arg(long, default_value_t = 1.0)]
    duration_s: f64,
    /// Computes one table only.
    #[arg(long)]
    table: Option<Which>,
}

/// Tables.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Which {
    /// Conventional against discrete raceways.
    Raceways,
    /// Friction of the balls from which they rattle.
    Friction,
}

/// A bearing: name, case, and its discrete raceways with their values.
type Raceways = &'static [(&'static str, [f64; 2])];
const BEARINGS: [(&str, &str, Raceways); 2] = [
    (
        "paper",
        "touchdown-d.toml",
        &[("paper's (d)", [5.1, 25.2]), ("searched", [5.093, 24.06])],
    ),
    (
        "full 6205",
        "touchdown-6205.toml",
        &[("searched", [2.974, 12.07])],
    ),
];
const SPEEDS_RPM: [f64; 2] = [10_000.0, 30_000.0];
/// Friction coefficients of the balls and of rotor on ring.
const FRICTION: [(&str, [f64; 2]); 2] = [("dry", [0.1, 0.15]), ("lubricated", [0.007, 0.05])];
/// Friction coefficients of the balls in the second table; that of rotor on ring is 0.15.
const BALL_FRICTION: [f64; 6] = [0.007, 0.02, 0.03, 0.05, 0.07, 0.1];
/// Collisions of each ball per second, at the end of a drop, beyond which the balls rattle.
const RATTLING_HZ: f64 = 500.0;

pub fn run(options: &Options) -> Result<()> {
    let clock = Instant::now();
    let mut rows = 0;
    if options.table != Some(Which::Friction) {
        rows += raceways(options)?;
    }
    if options.table != Some(Which::Raceways) {
        rows += friction(options)?;
    }
    let drops = rows as f64 * options.samples as f64;
    let wall_s = clock.elapsed().as_secs_f64();
    println!(
        "\n{drops} drops of {} s in {wall_s:.0} s: {:.3} s per simulated second",
        options.duration_s,
        wall_s / (drops * options.duration_s)
    );
    Ok(())
}

fn raceways(options: &Options) -> Result<usize> {
    println!(
        "{} drops of {} s each; mean, and mean ± standard error of the difference to the \
         conventional ring in the same drops\n",
        options.samples, options.duration_s
    );
    print!("| bearing | speed, rpm | friction | raceway | rattling | backward whirl, % |");
    for (name, _) in COMPARED {
        print!(" {name} |");
    }
    println!(
        "\n|---|---|---|---|---|---|{}",
        "---|".repeat(COMPARED.len())
    );
    let mut rows = 0;
    for (bearing, case, discrete) in BEARINGS {
        for rpm in SPEEDS_RPM {
            for (name, friction) in FRICTION {
                let mut row = |raceway: &str, values: Option<[f64; 2]>| {
                    rows += 1;
                    let result = drops(options, case, rpm, friction, values)
                        .with_context(|| format!("{bearing}, {raceway}"))?;
                    print!("| {bearing} | {rpm} | {name} | {raceway} |");
                    Ok::<_, anyhow::Error>(result)
                };
                let plain = row("conventional", None)?;
                println!("{}", cells(&plain, None));
                for (label, values) in discrete {
                    let result = row(label, Some(*values))?;
                    println!("{}", cells(&result, Some(&plain)));
                }
            }
        }
    }
    Ok(rows)
}

/// Drops that end rattling over the friction coefficient of the balls.
fn friction(options: &Options) -> Result<usize> {
    println!(
        "\nDrops out of {} that end with more than {RATTLING_HZ} collisions of each ball per \
         second, and their heat of friction at the balls, J\n",
        options.samples
    );
    let (_, case, discrete) = BEARINGS[0];
    println!("| friction of the balls | speed, rpm | conventional | paper's (d) |");
    println!("|---|---|---|---|");
    let mut rows = 0;
    for rpm in SPEEDS_RPM {
        for balls in BALL_FRICTION {
            print!("| {balls} | {rpm} |");
            for values in [None, Some(discrete[0].1)] {
                rows += 1;
                let result = drops(options, case, rpm, [balls, 0.15], values)?;
                let heat = mean(&result.drops, |d| d.bearing.result.value("ball_heat_j"));
                print!(" {}, {} |", rattling(&result), figures(heat));
            }
            println!();
        }
    }
    Ok(rows)
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
    let case = match raceway {
        Some(_) => file.case().clone(),
        None => file.case().conventional(),
    };
    let result = ensemble(&case, options.samples, &Scatter::default(), &Silent)?;
    for reason in &result.stopped {
        eprintln!("{rpm} rpm, friction {balls}: a drop stopped {reason}");
    }
    Ok(result)
}

/// Name of a result, and the result.
type Compared = (&'static str, fn(&DropRow) -> Option<f64>);

/// Results of a drop that are compared, with their headings.
const COMPARED: [Compared; 8] = [
    ("collisions per s at the end", |d| {
        d.bearing.result.value("end_collision_rate_hz")
    }),
    ("pressure ball on ball, GPa", |d| {
        d.bearing.result.value("ball_stress_max_gpa")
    }),
    ("pressure on the raceways, GPa", |d| {
        let [inner, outer] = ["inner_stress_max_gpa", "outer_stress_max_gpa"];
        Some(
            d.bearing
                .result
                .value(inner)?
                .max(d.bearing.result.value(outer)?),
        )
    }),
    ("ball sliding, m/s", |d| {
        d.bearing.result.value("ball_slip_max_m_s")
    }),
    ("heat at the balls, J", |d| {
        d.bearing.result.value("ball_heat_j")
    }),
    ("spin-up, ms", |d| d.bearing.result.value("spin_up_ms")),
    ("ring at the end, rpm", |d| {
        d.bearing.result.value("ring_speed_rpm")
    }),
    ("largest force, weights", |d| {
        d.bearing.result.value("rotor_force_max_weights")
    }),
];

/// Drops that end with rattling balls.
fn rattling(result: &EnsembleResult) -> usize {
    let rattles = |d: &&DropRow| {
        let balls = d.bearing.result.values("inner_force_max_of_ball_n").len() as f64;
        let rate = d.bearing.result.value("end_collision_rate_hz");
        rate.is_some_and(|rate| rate > RATTLING_HZ * balls)
    };
    result.drops.iter().filter(rattles).count()
}

fn cells(result: &EnsembleResult, plain: Option<&EnsembleResult>) -> String {
    let whirl = (result.distribution.backward_whirl.interval)
        .zip(result.distribution.backward_whirl.fraction)
        .map_or("-".to_owned(), |([low, high], p)| {
            format!("{:.0} ({:.0} to {:.0})", 1e2 * p, 1e2 * low, 1e2 * high)
        });
    let mut text = format!(
        " {} of {} | {whirl} |",
        rattling(result),
        result.drops.len()
    );
    for (_, of) in COMPARED {
        let missing = result.drops.iter().filter(|d| of(d).is_none()).count();
        let difference = plain.map(|plain| difference(&result.drops, &plain.drops, of));
        text += " ";
        text += &match difference.flatten() {
            _ if missing == result.drops.len() => "-".to_owned(),
            None => figures(mean(&result.drops, of)),
            Some([d, s]) => {
                let mean = mean(&result.drops, of);
                format!("{} ({})", figures(mean), change(d, s, mean))
            }
        };
        if missing > 0 {
            text += &format!(", {missing} without");
        }
        text += " |";
    }
    text
}

/// Fraction of a mean below which a difference with its standard error is called none.
const EQUAL: f64 = 2e-3;

/// A difference with its standard error to two digits.
fn change(difference: f64, error: f64, mean: f64) -> String {
    if difference.abs() + error < EQUAL * mean.abs() {
        return "equal".to_owned();
    }
    let sign = if difference < 0.0 { '−' } else { '+' };
    let [difference, error] =
        [difference.abs(), error].map(|v| cageless_study::number_text::significant(v, 2));
    format!("{sign}{difference} ± {error}")
}

/// A number to three digits.
fn figures(value: f64) -> String {
    cageless_study::number_text::significant(value, 3)
}

fn mean(drops: &[DropRow], of: fn(&DropRow) -> Option<f64>) -> f64 {
    let values: Vec<f64> = drops.iter().filter_map(of).collect();
    values.iter().sum::<f64>() / values.len() as f64
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
