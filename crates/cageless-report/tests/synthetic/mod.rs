//! Made-up data of plausible shape: balls that roll exactly, on real geometry.
#![allow(
    dead_code,
    unused_imports,
    reason = "each user of this module takes what it needs"
)]

mod claims;
mod design;
mod run;

use claims::claims;
pub use design::{design, search_json};
pub use run::run_data;

use cageless::kinematics::rolling_orbit_speed_rad_s;
use cageless::{Bearing, Raceway, RacewayDimensions, reference};
use cageless_report::*;

/// lC, θ, theory and simulated value of the paper's Table 2.
pub const STRUCTURES: [(&str, f64, f64, f64, f64); 10] = [
    ("a", 4.95, 35.0, 1.8153, 1.8131),
    ("b", 5.0, 30.5, 1.8176, 1.8281),
    ("c", 5.05, 27.5, 1.8185, 1.8323),
    ("d", 5.1, 25.2, 1.8171, 1.8190),
    ("e", 5.15, 23.5, 1.8183, 1.7932),
    ("f", 5.2, 22.0, 1.8156, 1.7552),
    ("g", 5.4, 18.167, 1.8161, 1.6589),
    ("h", 5.6, 15.774, 1.8161, 1.6594),
    ("i", 5.8, 14.062, 1.8161, 1.5416),
    ("j", 6.0, 12.717, 1.8160, 1.4538),
];
const SPEED: f64 = 12_000.0 * std::f64::consts::PI / 30.0;
const STEP: f64 = 2e-5;

pub fn bearing() -> Bearing {
    reference::bearing()
}

pub fn structure(k: usize) -> RacewayLabel {
    let (letter, span, theta, ..) = STRUCTURES[k];
    RacewayLabel {
        letter: letter.into(),
        axial_span_mm: span,
        half_angle_deg: theta,
    }
}

pub fn raceway(k: usize) -> Raceway {
    let dimensions = RacewayDimensions {
        axial_span_m: STRUCTURES[k].1 * 1e-3,
        half_angle_rad: STRUCTURES[k].2.to_radians(),
        centre_angle_rad: 0.0,
    };
    Raceway::new(dimensions, &bearing()).expect("the paper's raceway")
}

fn source(k: usize, formulation: &str) -> Provenance {
    Provenance {
        case: format!(
            "Zhao 2022, structure {}, 12 000 rpm, 1500 N",
            structure(k).label()
        ),
        formulation: Some(formulation.into()),
        friction_law: Some("smooth, 0.02 m/s".into()),
        film: None,
        method: Some("ABM4".into()),
        step_us: Some(1.0),
        discarded: "the first 0.1 s".into(),
    }
}

/// ψ (degrees) and Ω (degrees/s) of balls that roll, `gap` apart in turn.
pub struct Rolling {
    pub time: Vec<f64>,
    pub angle: Vec<Vec<f64>>,
    pub speed: Vec<Vec<f64>>,
}

pub fn rolling(raceway: Option<&Raceway>, duration: f64, wobble: f64) -> Rolling {
    let bearing = bearing();
    let speed_at = |psi: f64, t: f64, k: usize| {
        let r = raceway.map_or(bearing.ball_radius_m(), |d| d.effective_radius_m(psi));
        let noise = wobble * ((t * 90.0 + k as f64).sin() + (t * 37.0 * k as f64).cos());
        rolling_orbit_speed_rad_s(&bearing, SPEED, r) * (1.0 + noise)
    };
    let mut out = Rolling {
        time: vec![],
        angle: vec![vec![]; 14],
        speed: vec![vec![]; 14],
    };
    let mut psi: Vec<f64> = (0..14)
        .map(|k| f64::from(k) * std::f64::consts::TAU / 14.0)
        .collect();
    for step in 0..=(duration / STEP).round() as usize {
        let t = step as f64 * STEP;
        out.time.push(t);
        for (k, angle) in psi.iter_mut().enumerate() {
            let here = speed_at(*angle, t, k);
            out.angle[k].push(angle.to_degrees());
            out.speed[k].push(here.to_degrees());
            *angle += STEP * speed_at(*angle + here * STEP / 2.0, t, k);
        }
    }
    out
}

pub fn gaps(angle: &[Vec<f64>], epsilon: f64) -> Vec<Vec<f64>> {
    let n = angle.len();
    (0..n)
        .map(|k| {
            let turn = if k + 1 == n { 360.0 } else { 0.0 };
            let ahead = &angle[(k + 1) % n];
            ahead
                .iter()
                .zip(&angle[k])
                .map(|(a, b)| a + turn - b - epsilon)
                .collect()
        })
        .collect()
}

fn motion(title: &str, raceways: &[Raceway], wobble: f64, formulation: &str) -> Motion {
    let run = rolling(raceways.first(), 0.21, wobble);
    let thin = |v: &Vec<f64>| v.iter().step_by(5).copied().collect::<Vec<f64>>();
    Motion {
        title: title.into(),
        outline: BearingOutline::new(&bearing()),
        sectors: raceways.iter().map(RacewaySector::new).collect(),
        time_s: thin(&run.time),
        angle_deg: run.angle.iter().map(thin).collect(),
        gap_deg: vec![],
        provenance: source(3, formulation),
        ..Motion::default()
    }
}

fn vibration(names: &[(&str, f64)]) -> Vibration {
    let signals = names
        .iter()
        .map(|(name, size)| {
            let time: Vec<f64> = (0..5000).map(|k| f64::from(k) * 2e-4).collect();
            let wave = |t: &f64| {
                let seed = (t * 1e6).sin() * 43758.5453;
                size * ((t * std::f64::consts::TAU * 280.0).sin()
                    + 3.0 * (seed - seed.floor() - 0.5))
            };
            let f: Vec<f64> = (0..2500).map(f64::from).collect();
            let a = f
                .iter()
                .map(|f| size * (0.02 + 1.0 / (1.0 + (f - 280.0).powi(2) / 9.0)))
                .collect();
            VibrationSignal {
                name: (*name).into(),
                acceleration_m_s2: time.iter().map(wave).collect(),
                time_s: time,
                frequency_hz: f,
                amplitude_m_s2: a,
                rms_m_s2: Some(*size),
                peak_m_s2: Some(4.0 * size),
                resolution_hz: Some(1.0),
                averages: 1,
                stretch_s: None,
            }
        })
        .collect();
    let mark = FrequencyMark {
        frequency_hz: 280.0,
        label: "ball passing".into(),
    };
    Vibration {
        signals,
        marks: vec![mark],
        provenance: source(3, "physical"),
    }
}

fn verdict(k: usize) -> String {
    ["double collision", "smooth", "slips"][if k < 3 {
        0
    } else if k < 6 {
        1
    } else {
        2
    }]
    .into()
}

fn event(label: &str, time_s: f64, meaning: &str) -> Event {
    Event {
        label: label.into(),
        time_s,
        meaning: meaning.into(),
    }
}

pub fn reproduce() -> ReproduceData {
    let bearing = bearing();
    let outline = BearingOutline::new(&bearing);
    let uniform = 360.0 / 14.0 - outline.ball_angle_deg;
    let run = rolling(Some(&raceway(0)), 0.6, 0.0004);
    let gap = gaps(&run.angle, outline.ball_angle_deg);
    let turn = 20_000..20_640;
    let stage = |k: usize| run.time[turn.start] + 0.0128 * k as f64 / 4.0;
    let history = |formulation: &str| GapHistory {
        structure: structure(0),
        ball: 1,
        time_s: run.time.clone(),
        gap_deg: gap[0].clone(),
        settled_after_s: 0.1,
        turn_time_s: run.time[turn.clone()].to_vec(),
        turn_gap_deg: gap[0][turn.clone()].to_vec(),
        stages: vec![
            event("a", stage(0), "into the unloaded zone"),
            event("b", stage(1), "into the loaded zone"),
            event("c", stage(2), "into the discrete raceway"),
            event("d", stage(3), "out of it"),
            event("e", stage(4), "end of the turn"),
        ],
        uniform_gap_deg: uniform,
        provenance: source(0, formulation),
    };
    let window = 20_000..20_400;
    let cut = |v: &Vec<f64>| v[window.clone()].to_vec();
    let neighbours = Neighbours {
        structure: structure(0),
        time_s: cut(&run.time),
        orbit_speed_deg_s: [cut(&run.speed[0]), cut(&run.speed[1]), cut(&run.speed[2])],
        gap_deg: [cut(&gap[0]), cut(&gap[1])],
        balls: [1, 2, 3],
        events: (0..5)
            .map(|k| {
                event(
                    &format!("t{k}"),
                    0.4 + 0.0012 * f64::from(k + 1),
                    "something happens",
                )
            })
            .collect(),
        provenance: source(0, "paper"),
    };
    let portraits = (0..10)
        .map(|k| {
            let r = rolling(Some(&raceway(k)), 0.06, 0.0004);
            let pairs = || r.angle[0].iter().map(|a| a.to_radians()).zip(&r.speed[0]);
            let v = |s: &f64| s.to_radians() * 23.0025e-3;
            PhasePortrait {
                structure: structure(k),
                verdict: verdict(k),
                x_mm: pairs().map(|(a, _)| 23.0025 * a.sin()).collect(),
                vx_m_s: pairs().map(|(a, s)| v(s) * a.cos()).collect(),
                vy_m_s: pairs().map(|(a, s)| v(s) * a.sin()).collect(),
            }
        })
        .collect();
    let passages = (0..10)
        .map(|k| {
            let angle: Vec<f64> = (-450..=450).map(|d| f64::from(d) / 10.0).collect();
            let rolling: Vec<f64> = angle
                .iter()
                .map(|a| {
                    let r = raceway(k).effective_radius_m(a.to_radians());
                    rolling_orbit_speed_rad_s(&bearing, SPEED, r).to_degrees()
                })
                .collect();
            let lag = k * 2;
            let speed = (0..angle.len())
                .map(|i| rolling[i.saturating_sub(lag)] * 1.0005)
                .collect();
            OrbitSpeed {
                structure: structure(k),
                verdict: verdict(k),
                angle_deg: angle,
                speed_deg_s: speed,
                rolling_deg_s: rolling,
            }
        })
        .collect();
    ReproduceData {
        case_toml: "title = \"structure (d)\"\n".into(),
        software: "cageless 0.1.0, x86-64 AVX2 <synthetic data>".into(),
        lead: "Synthetic data: this page only shows what a report looks like. Nothing in it was simulated.".into(),
        table1: table1(),
        table2: Some(table2()),
        contact_track: Some(ContactTrack::sample(&raceway(3), &bearing, structure(3))),
        surface: Some(RacewaySurface::sample(&raceway(3), &bearing, structure(3))),
        design_curve: Some(design_curve(uniform)),
        gap_histories: vec![history("paper"), history("physical")],
        neighbours: vec![neighbours],
        phase_portraits: vec![PhasePortraits { portraits, provenance: source(3, "paper") }],
        orbit_speeds: vec![OrbitSpeeds { passages, provenance: source(3, "physical") }],
        vibrations: vec![vibration(&[("conventional", 40.0), ("discrete raceway", 12.0)])],
        ring_comparison: Some(ring_comparison()),
        motions: vec![
            motion("Figure 13: conventional", &[], 0.004, "physical"),
            motion("Figure 14: discrete raceway, lC 5.1 mm, θ 25.2°", &[raceway(3)], 0.0, "physical"),
        ],
        claims: claims(),
    }
}

fn ring_comparison() -> RingComparison {
    let around = |mean: f64| Estimate::new(&[0.9 * mean, mean, 1.1 * mean]).expect("values");
    let mut cells = vec![];
    for speed_rpm in [3000.0, 12_000.0] {
        for (lot, variation_um) in [("equal balls", 0.0), ("G10", 0.5)] {
            for (ring, raceway) in [
                ("conventional", None),
                ("structure (d)", Some(structure(3))),
            ] {
                let rms = around(if raceway.is_some() { 0.45 } else { 0.03 });
                let numbers = RingNumbers {
                    rms_m_s2: rms,
                    rms_at_passing_m_s2: rms,
                    rms_between_m_s2: rms,
                    rms_without_contacts_m_s2: rms,
                    rms_from_contacts_m_s2: rms,
                    gap_deviation_deg: rms,
                    contacts_per_s: rms,
                    impulse_rate_n: rms,
                };
                cells.push(ComparisonCell {
                    speed_rpm,
                    lot: lot.into(),
                    lot_diameter_variation_um: variation_um,
                    ring: ring.into(),
                    difference: raceway.is_some().then_some(numbers),
                    raceway,
                    numbers: RingNumbers {
                        gap_deviation_deg: around(1.3),
                        contacts_per_s: around(120.0),
                        ..numbers
                    },
                    approach_speed_m_s: Some(around(0.09)),
                    impulse_n_s: None,
                    transition_density: [Some(around(1.1)), Some(around(0.9)), None],
                    last_quarter_less: [RecordChange {
                        rms_m_s2: rms,
                        contacts_per_s: rms,
                        impulse_rate_n: rms,
                    }; 2],
                });
            }
        }
    }
    RingComparison {
        cells,
        starts: "3 starts per combination.".into(),
        command: "cageless reproduce".into(),
        search_commands: vec!["cageless design case.toml --search".into()],
        left_out: vec!["tilt".into()],
        provenance: source(3, "physical"),
    }
}

fn parameter(name: &str, symbol: &str, value: &str, unit: &str, source: &str) -> Parameter {
    Parameter {
        name: name.into(),
        symbol: symbol.into(),
        value: value.into(),
        unit: unit.into(),
        source: source.into(),
    }
}

fn table1() -> Vec<Parameter> {
    vec![
        parameter("Ball radius", "Rw", "4.7625", "mm", "Table 1"),
        parameter(
            "Radius of the outer groove bottom",
            "Ro",
            "27.765",
            "mm",
            "Table 1",
        ),
        parameter("Number of balls", "N", "14", "", "Table 1"),
        parameter("Inner ring speed", "ωi", "12 000", "rpm", "Table 1"),
        parameter(
            "Groove curvature radius, outer",
            "Re",
            "4.953",
            "mm",
            "not in the paper: 0.52 × ball diameter",
        ),
    ]
}

fn table2() -> Table2 {
    let shift = [
        [0.012, 0.001],
        [0.0074, 0.001],
        [-0.02, 0.003],
        [-0.0237, 0.003],
    ];
    let rows = STRUCTURES
        .iter()
        .enumerate()
        .map(|(k, (.., theory, simulated))| Table2Row {
            structure: structure(k),
            theory_deg: theory + 2e-5,
            theory_polar_deg: Some(theory + 0.003 * k as f64),
            paper_theory_deg: *theory,
            paper_simulated_deg: *simulated,
            critical_gap_deg: shift
                .iter()
                .enumerate()
                .map(|(v, s)| {
                    (k != 2 || v != 3).then(|| {
                        simulated + s[0] + s[1] * k as f64 - if k == 7 { 0.06 } else { 0.0 }
                    })
                })
                .collect(),
            remark: if k == 7 {
                "does not follow its neighbours".into()
            } else {
                String::new()
            },
        })
        .collect();
    let variant = |p: &str, f: &str| Variant {
        formulation: p.into(),
        friction_law: f.into(),
    };
    let spread = |cause: &str, size: f64| Spread {
        cause: cause.into(),
        variant: "paper, coulomb".into(),
        change_deg: (0..10)
            .map(|k| (k != 4).then_some(size * (1.0 - 0.1 * f64::from(k))))
            .collect(),
    };
    Table2 {
        variants: vec![
            variant("paper", "coulomb"),
            variant("paper", "smooth"),
            variant("physical", "coulomb"),
            variant("physical", "smooth"),
        ],
        rows,
        spreads: vec![
            spread("step 1 to 0.5 µs", 0.004),
            spread("start at ψ = −120°", 0.01),
            spread("damping 2e5 to 4e5", -0.003),
            spread("groove radius 0.52 to 0.53", 0.002),
            spread("touch read as δb > 0", -0.0131),
        ],
        provenance: source(3, "paper and physical"),
    }
}

fn design_curve(uniform: f64) -> DesignCurve {
    let span: Vec<f64> = (0..100).map(|k| 4.9 + 0.025 * f64::from(k)).collect();
    let theta = |s: &f64| {
        12.0 + 14.0 / (1.0 + 2.0 * (s - 5.0).max(-0.3)).powi(3) - 4.0 * (s - 5.5).max(0.0)
    };
    DesignCurve {
        half_angle_deg: span.iter().map(theta).collect(),
        half_angle_polar_deg: span.iter().map(|s| theta(s) + 0.8).collect(),
        axial_span_mm: span,
        uniform_gap_deg: uniform,
        paper: (0..10).map(structure).collect(),
        limits: vec![
            DesignLimit {
                quantity: LimitedQuantity::AxialSpan,
                value: 7.4,
                label: "Eq. (8): lC < 7.40 mm".into(),
            },
            DesignLimit {
                quantity: LimitedQuantity::HalfAngle,
                value: 25.714,
                label: "three balls inside above ε + β0".into(),
            },
            DesignLimit {
                quantity: LimitedQuantity::HalfAngle,
                value: 22.0,
                label: "the paper's lower limit 22°".into(),
            },
        ],
        provenance: Provenance {
            case: "Zhao 2022, Table 1".into(),
            ..Provenance::default()
        },
    }
}
