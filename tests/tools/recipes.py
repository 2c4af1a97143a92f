"""Follows the recipes of RECIPES.md on a copy of the project, all of them at once: each touches the files
that it lists and no other, and the command then has a law of friction, a shape of raceway, a method, a result,
a figure, a criterion and a key more.

    recipes.py FOLDER [BUILT]

FOLDER takes the copy and what is built from it; BUILT is a target folder whose dependencies are taken over.
"""

import argparse
import contextlib
import json
import math
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import checks

HERE = Path(__file__).resolve().parents[2]
CORE, IO, REPORT = "crates/cageless/src/", "crates/cageless-io/src/case_file/", "crates/cageless-report/src/"
DESIGN = "crates/cageless-design/src/"
FRICTION, INTEGRATOR, FIGURES = CORE + "contact/friction/", CORE + "integrator/", REPORT + "figures/"
SHAPE = CORE + "raceway/shape/"

# By file: the text of a new one, or for one that exists pairs of a text that occurs once and what is inserted before it.
RECIPES = {
    "A friction law with a parameter": {
        FRICTION
        + "rising.rs": """//! Friction that grows with the sliding speed.

use super::law::{Law, LawConstants, knee};
use super::parameters::FrictionParameters;
use crate::numerics::exponential::tanh;
use crate::numerics::lanes::lane_struct;

law_struct! {
    /// μ·(1 + a·|ΔV|)·tanh(ΔV/scale)·N.
    pub(crate) struct Rising per lane RisingLanes {
        /// μ at rest.
        coefficient,
        /// a, s/m.
        rise,
        /// 1/scale, s/m.
        inverse_regularisation_speed,
    }
}

impl Law for Rising {
    #[inline(always)]
    fn force_with_knee(&self, sliding_m_s: f64, normal_n: f64, inverse_knee_s_m: f64) -> [f64; 2] {
        let knee = tanh(sliding_m_s * inverse_knee_s_m);
        let largest = self.coefficient * normal_n;
        let factor = 1.0 + self.rise * sliding_m_s.abs();
        let slope = largest * (1.0 - knee * knee) * inverse_knee_s_m;
        [largest * knee * factor, slope * factor + largest * self.rise * knee.abs()]
    }

    knee!();
}

impl LawConstants for Rising {
    const NAME: &'static str = "rising";

    fn new(parameters: &FrictionParameters, _stick_gain_n_s_m: f64) -> Self {
        Self {
            coefficient: parameters.coefficient,
            rise: parameters.rise_s_m,
            inverse_regularisation_speed: 1.0 / parameters.regularisation_speed_m_s,
        }
    }

    fn describe(parameters: &FrictionParameters) -> String {
        format!("rising by {} s/m", parameters.rise_s_m)
    }
}
""",
        FRICTION
        + "mod.rs": [
            ["    /// μ(|ΔV|)·tanh(ΔV/scale)·N with μ", "    /// μ·(1 + a·|ΔV|)·tanh(ΔV/scale)·N.\n    rising: Rising per lane RisingLanes,\n"],
        ],
        FRICTION
        + "parameters.rs": [
            ["    /// μs of the Stribeck law, at least μ;", "    /// a, s/m.\n    pub rise_s_m: f64,\n"],
            ["            static_coefficient: None,", "            rise_s_m: 0.0,\n"],
            ['        not_negative(field!(of, "friction_coefficient")', '        not_negative(field!(of, "friction_rise_s_m"), self.rise_s_m)?;\n'],
        ],
        IO
        + "sections/friction.rs": [
            [
                "                    friction_table => table",
                "                    friction_rise_s_m => rise_s_m: f64 = default(0.0), Si(\"s/m\"); AtLeast(0.0),\n"
                '                        concat!("growth of ", $symbol, " over the sliding speed"), Absent;\n',
            ]
        ],
    },
    "An integrator": {
        INTEGRATOR
        + "heun.rs": """//! Heun's method.

use super::method::{Method, NamedMethod, Properties};
use super::runge_kutta::UnresolvedStep;
use super::step_state::{FixedSteps, StepState};
use super::system::System;

/// y(1) = y(0) + h/2·(f(0) + f(y(0) + h·f(0))).
#[derive(Debug, Clone)]
pub struct Heun {
    steps: FixedSteps,
}

impl NamedMethod for Heun {
    const PROPERTIES: Properties = Properties {
        name: "heun",
        label: "Heun",
        order: 2,
        oscillation_limit: 0.2,
        decay_limit: 2.0,
        solves_stiff_part: false,
        side_by_side: true,
        automatic_oscillation: [0.05, 0.05],
        automatic_decay: 0.5,
    };

    fn of_case(_dimension: usize, step_s: f64, _tolerance: f64) -> Self {
        Self {
            steps: FixedSteps::new(step_s),
        }
    }
}

impl Method for Heun {
    fn restart<S: System>(&mut self, _system: &mut S, step: &StepState) {
        self.steps.restart(step.t1_s);
    }

    fn perform_step<S: System>(
        &mut self,
        system: &mut S,
        step: &mut StepState,
        limit_s: f64,
    ) -> Result<(), UnresolvedStep> {
        (step.t1_s, _) = self.steps.next_end(limit_s);
        let h = step.size_s();
        for k in 0..step.y0.len() {
            step.y1[k] = step.y0[k] + h * step.f0[k];
        }
        system.derivative(step.t1_s, &step.y1, &mut step.f1);
        for k in 0..step.y0.len() {
            step.y1[k] = step.y0[k] + 0.5 * h * (step.f0[k] + step.f1[k]);
        }
        system.derivative(step.t1_s, &step.y1, &mut step.f1);
        Ok(())
    }
}
""",
        INTEGRATOR + "mod.rs": [["    /// Order 8(5,3) with error control", "    /// Heun's method.\n    heun: Heun,\n"]],
    },
    "A shape of raceway": {
        SHAPE
        + "cosine.rs": """//! A raceway whose flank angle is a cosine.

use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

use crate::error::InputError;
use crate::raceway::flank_angle::{FlankAngle, Flanks};
use crate::raceway::outline::Outline;

/// αc = α0 cos(πψ/2θ): α0, then π/2θ.
#[derive(Debug)]
struct Cosine(f64, f64);

impl FlankAngle for Cosine {
    fn at(&self, local_angle_rad: f64) -> [f64; 2] {
        let (sin, cos) = (self.1 * local_angle_rad).sin_cos();
        [self.0 * cos, -self.0 * self.1 * sin]
    }
}

pub(super) fn flanks(outline: &Outline<'_>) -> Result<Flanks, InputError> {
    let per_angle = FRAC_PI_2 / outline.half_angle_rad;
    Ok(Arc::new(Cosine(outline.middle_rad(), per_angle)))
}
""",
        CORE
        + "raceway/shape.rs": [
            ["mod ellipse;", "mod cosine;\n"],
            [
                "    /// Fitted to the points of a ring",
                '    /// αc = α0 cos(πψ/2θ).\n    Cosine = "cosine", cosine, "α0 cos(πψ/2θ)";\n',
            ],
        ],
    },
    "A scalar result": {
        "crates/cageless-results/src/table/run.rs": [
            [
                '    group(Group::Passages, quantity("passage_duration_mean_ms"',
                '    group(Group::Passages, quantity("passages_per_second_hz", "Hz", "passages a second", '
                "Run(|r| some(r.passages.count as f64 / r.outcome.end_s)))),\n",
            ]
        ],
    },
    "A figure": {
        FIGURES
        + "magnitudes.rs": """//! Magnitudes of the terms of the energy balance.

use serde_json::json;

use super::history::figure;
use crate::figure::Figure;
use crate::plot::{Plot, numbers};
use crate::run_data::RunData;

/// Magnitudes of the terms of the energy balance.
pub fn magnitudes(run: &RunData) -> Option<Figure> {
    let values: Vec<f64> = run.energy.iter().map(|item| item.energy_j.abs()).collect();
    let plot = Plot::new(300)
        .axis("xaxis", "Term", json!({}))
        .axis("yaxis", "Magnitude (J)", json!({}))
        .trace(json!({ "type": "bar", "y": numbers(&values) }));
    Some(figure(run, "Magnitudes", "Magnitudes of the terms.", plot))
}
""",
        FIGURES
        + "mod.rs": [
            ["pub mod orbit;", "pub mod magnitudes;\n"],
            ['            named("energy"', '            named("magnitudes", "magnitudes of the terms", magnitudes::magnitudes),\n'],
        ],
    },
    "A criterion of a verdict": {
        DESIGN
        + "criterion/often.rs": """//! Contacts of a passing ball.

use super::super::raceway_verdict::RacewayVerdict;
use super::requirement::{Bound, CauseKind, Requirement};

/// Contacts with neighbours per passage.
pub(crate) static OFTEN: Requirement = Requirement {
    name: "often",
    most: Some(Bound {
        limit: 1e-3,
        verdict: RacewayVerdict::DoubleCollision,
        cause: CauseKind {
            name: "often-hit",
            meaning: "balls are hit too often",
            remedy: "a shallower raceway",
        },
    }),
    sentence: |_| "balls are hit in {} of the passages",
    unknown: "the number of contacts",
    ..Requirement::PERCENT
};
""",
        DESIGN
        + "criterion/mod.rs": [
            ["mod pressure;", "mod often;\n"],
            ["pub(crate) use pressure::", "pub(crate) use often::OFTEN;\n"],
        ],
        DESIGN
        + "verdict.rs": [
            ["        BOTH_NEIGHBOURS.of(s.double", "        super::criterion::OFTEN.of(s.collisions_mean),\n"],
        ],
    },
    "A key of the case file": {
        CORE
        + "case/contact.rs": [
            ["    /// Friction between balls over that", "    /// Roughness over film thickness.\n    pub roughness_ratio: f64,\n"],
            ["            ball_friction_factor: 1.0,", "            roughness_ratio: 0.0,\n"],
            ['        not_negative("ball_friction_factor"', '        not_negative("roughness_ratio", self.roughness_ratio)?;\n'],
        ],
        IO
        + "sections/contact.rs": [
            [
                "        ball_friction_factor =>",
                "        roughness_ratio => roughness_ratio: f64 = default(0.0), Plain; AtLeast(0.0),\n"
                '            "roughness over film thickness", Commented("0.0", "roughness over film");\n',
            ]
        ],
    },
}


def copied(folder):
    """The files of the project, those that are not committed included."""
    tree = folder / "tree"
    shutil.rmtree(tree, ignore_errors=True)
    listed = subprocess.run(
        ["git", "ls-files", "-co", "--exclude-standard", "-z"], cwd=HERE, capture_output=True, check=True
    )
    for name in listed.stdout.decode().split("\0"):
        if name and (HERE / name).is_file():
            (tree / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(HERE / name, tree / name)
    return tree


def follow(tree):
    """Makes the changes of all recipes, each as its text in RECIPES.md says."""
    text = (HERE / "RECIPES.md").read_text()
    for title, changes in RECIPES.items():
        heading = re.search(rf"### {title}: (\d) files?\n(.*?)(?=\n###? )", text, re.S)
        checks.check(f"{title} is a recipe", heading)
        count, recipe = heading.groups()
        checks.check(f"{title}: number of files", int(count) == len(changes), f"{count}, not {len(changes)}")
        for name, change in changes.items():
            file = tree / name
            if isinstance(change, str):
                checks.check(f"{title}: {file.name} is new", not file.exists())
                checks.check(f"{title}: where {file.name} goes", str(Path(name).parent) in recipe)
                file.write_text(change)
                continue
            checks.check(f"{title}: {name} is listed", name in recipe or f"{Path(name).parent}/" in recipe)
            content = file.read_text()
            for before, line in change:
                checks.check(f"{title}: one place in {name}", content.count(before) == 1, before)
                content = content.replace(before, line + before, 1)
            file.write_text(content)


def build(folder, tree, built):
    """The command of the copy, with the dependencies of `built` where they fit."""
    target = folder / "target"
    for part in ("build", "deps", ".fingerprint") if built else ():
        for path in (built / "tests" / part).glob("*"):
            to = target / "tests" / part / path.name
            if "cageless" not in path.name and not to.exists():
                to.parent.mkdir(parents=True, exist_ok=True)
                # What the compiler removes meanwhile is compiled again.
                with contextlib.suppress(FileNotFoundError, shutil.Error):
                    shutil.copytree(path, to) if path.is_dir() else shutil.copy2(path, to)
    command = ["cargo", "build", "--locked", "--profile", "tests", "--workspace", "--exclude", "cageless-bench", "--bins"]
    # A few runs of milliseconds: what compiles fast is fast enough, the physics with its debug assertions and
    # without vector instructions.
    command += ["--config", "profile.tests.package.cageless.debug-assertions=true"]
    for crate in sorted(path.parent.name for path in tree.glob("crates/*/Cargo.toml")):
        command += ["--config", f"profile.tests.package.{crate}.opt-level={int(crate == 'cageless')}"]
    # Pages need no engine here.
    environment = {"CARGO_TARGET_DIR": str(target), "CAGELESS_ENGINE": "/dev/null"}
    done = subprocess.run(command, cwd=tree, env={**os.environ, **environment})
    checks.check("the copy compiles", done.returncode == 0)
    return target / "tests/cageless"


def run(cageless, tree, out, *settings):
    options = [option for setting in settings for option in ("--set", setting)]
    command = [cageless, "run", "cases/zhao-d.toml", "--json", "--out", out, *options]
    return subprocess.run(command, cwd=tree, capture_output=True, text=True)


def cosine_demand(span_m, half_angle_rad, ball_radius_m):
    """Largest |d ln Ω/dψ| over a raceway with αc = α0 cos(πψ/2θ): sin αc |αc′|/(cos αc (1 + cos αc))."""
    largest, per_angle = math.asin(span_m / (2 * ball_radius_m)), math.pi / 2 / half_angle_rad

    def demand(phase):
        angle, slope = largest * math.cos(phase), largest * per_angle * math.sin(phase)
        return math.sin(angle) * slope / (math.cos(angle) * (1 + math.cos(angle)))

    return max(demand(math.pi / 2 * k / 10000) for k in range(10001))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("built", type=Path, nargs="?")
    options = parser.parse_args()
    folder = options.folder.resolve()
    tree = copied(folder)
    follow(tree)
    if checks.failed():
        return checks.exit_code()
    cageless = build(folder, tree, options.built and options.built.resolve())
    short = ["solver.duration_s=0.02", "solver.method=heun", "solver.step_us=0.2", "contact.roughness_ratio=0.5"]
    rising = "contact.friction_law=rising"

    def numbers(*settings):
        done = run(cageless, tree, folder / "out", *short, *settings)
        checks.check("the run completes", done.returncode == 0, done.stderr)
        return json.loads(done.stdout)

    smooth, same, more = numbers(), numbers(rising), numbers(rising, "contact.friction_rise_s_m=5")
    checks.check("the key is in the case as run", more["case"]["contact"]["roughness_ratio"] == 0.5)
    checks.check("the method is in the case as run", more["case"]["solver"]["method"] == "heun")
    checks.check("the method balances energy", abs(smooth["energy_residual_relative"]) < 1e-3)
    checks.check("the new result", more["passages_per_second_hz"] == more["passages"] / more["simulated_s"])
    checks.check("a law without its growth is the smooth one", same["power_loss_w"] == smooth["power_loss_w"])
    checks.check("a law with its growth is not", more["power_loss_w"] != smooth["power_loss_w"])
    design = [cageless, "design", "cases/zhao-d.toml", "--json", "--set", "raceway.shape=cosine"]
    done = subprocess.run(design, cwd=tree, capture_output=True, text=True)
    checks.check("design takes the new shape", done.returncode == 0, done.stderr)
    verdict = json.loads(done.stdout)
    checks.check("the new criterion decides", verdict["criterion"] == "often", verdict["headline"])
    checks.check("it says its value", "balls are hit in " in verdict["headline"], verdict["headline"])
    raceway, bearing = more["case"]["raceway"], more["case"]["bearing"]
    expected = cosine_demand(raceway["axial_span_mm"], math.radians(raceway["half_angle_deg"]), bearing["ball_radius_mm"])
    found = json.loads(done.stdout)["speed_change_max_per_rad"]
    checks.check("the new shape asks for its friction", abs(found / expected - 1) < 1e-6, f"{found}, not {expected}")
    page = (folder / "out/report.html").read_text()
    for what in ('id="magnitudes"', "rising by 5 s/m", "passages a second", "Heun"):
        checks.check(f"the page has {what}", what in page)
    for setting, key in (("contact.roughness_ratio=-1", "contact.roughness_ratio"), ("contact.friction_rise_s_m=-1", "contact.friction_rise_s_m")):
        bad = run(cageless, tree, folder / "bad", setting)
        checks.check(f"{setting} is refused", bad.returncode == 2 and key in bad.stderr, bad.stderr)
    checks.check("balls run on the new shape", numbers("raceway.shape=cosine")["lag_per_pass_deg"] != smooth["lag_per_pass_deg"])
    return checks.exit_code()


if __name__ == "__main__":
    sys.exit(main())
