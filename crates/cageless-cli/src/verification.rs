//! `cageless run --verify`: the members of a certificate, run on all cores.

use cageless::Case;
use cageless::certificate::{Certificate, FAR, Member, MemberError, Verdict, Watch, members};
use cageless::simulation::{Ending, Observer, RunOutcome};
use cageless_io::results::{CertificateFile, CertificateNumber, SummaryFile, rounded};
use cageless_report::{CertificateRow, CertificateTable};
use rayon::prelude::*;

use crate::format::{columns, pairs};
use crate::progress::{Progress, StopFlag};

/// A verification in progress: the first member is the run itself.
pub struct Verification {
    members: Vec<Member>,
    watch: Watch,
}

impl Verification {
    /// Of the run of `case`.
    pub fn new(case: &Case) -> Self {
        let members = members(case, FAR);
        let watch = members[0].watch();
        Self { members, watch }
    }

    /// What must watch the run itself.
    pub fn watch(&mut self) -> &mut dyn Observer {
        &mut self.watch
    }

    /// Runs the other members and adds the certificate, or why there is none, to the
    /// summary. A member that fails leaves the run without a certificate, not without
    /// results.
    pub fn finish(
        self,
        case: &Case,
        outcome: &RunOutcome,
        summary: &mut SummaryFile,
        stop: &StopFlag,
    ) {
        if !matches!(outcome.ending, Ending::Complete) {
            summary
                .warnings
                .push("not verified: the run did not come to its end".to_owned());
            return;
        }
        match self.certify(case, outcome, stop) {
            Ok(certificate) => {
                let certificate = CertificateFile::new(&certificate);
                summary.warnings.extend(certificate.warning());
                summary.certificate = Some(certificate);
            }
            Err(error) => summary.warnings.push(format!("not verified: {error}")),
        }
    }

    fn certify(
        self,
        case: &Case,
        outcome: &RunOutcome,
        stop: &StopFlag,
    ) -> Result<Certificate, MemberError> {
        let first = self.watch.record(outcome)?;
        let others = &self.members[1..];
        let work = |member: &Member| if member.role.half_step { 2.0 } else { 1.0 };
        let progress = Progress::new("verify", others.iter().map(work).sum(), stop);
        // In any order, collected in theirs.
        let records: Result<Vec<_>, MemberError> = others
            .par_iter()
            .with_max_len(1)
            .map(|member| {
                member.run(&mut progress.run_control(case.solver.duration_s, work(member)))
            })
            .collect();
        let mut all = vec![first];
        all.extend(records?);
        Certificate::new(case, &all).map_err(|error| MemberError::Case(error.into()))
    }
}

/// The value to the digits that are known of it.
fn value(number: &CertificateNumber) -> String {
    let known = if number.verdict == Verdict::Converged.name() {
        number.tolerance
    } else {
        number.spread
    };
    if number.unit == "1" {
        format!("{}", number.value)
    } else {
        rounded(number.value, known)
    }
}

fn facts(c: &CertificateFile) -> [(&'static str, String); 4] {
    [
        (
            "verified",
            format!(
                "{} numbers converged, {} statistical, {} neither ({} starts, steps of {} and {} µs)",
                c.converged,
                c.statistical,
                c.neither,
                c.members,
                c.step_us,
                c.step_us / 2.0
            ),
        ),
        ("predictability", c.predictability.clone()),
        (
            "energy balance",
            format!(
                "{:.1e} of all flows missing, {:.1e} at half the step",
                c.energy_residual_relative, c.energy_residual_relative_half_step
            ),
        ),
        (
            "momentum balance",
            format!(
                "{:.1e} of all impulses missing, {:.1e} at half the step",
                c.momentum_residual_relative, c.momentum_residual_relative_half_step
            ),
        ),
    ]
}

/// For the terminal.
pub fn text(c: &CertificateFile) -> String {
    let head = ["number", "value", "unit", "verdict", "because"].map(str::to_owned);
    let mut rows = vec![head.to_vec()];
    for (name, number) in c.ranked() {
        rows.push(vec![
            name.to_owned(),
            value(number),
            number.unit.clone(),
            number.verdict.clone(),
            number.reason.clone(),
        ]);
    }
    format!("\n{}\n{}", pairs(&facts(c)), columns(&rows))
}

/// For the report page.
pub fn table(c: &CertificateFile) -> CertificateTable {
    CertificateTable {
        facts: facts(c)
            .into_iter()
            .map(|(name, fact)| format!("{name}: {fact}"))
            .collect(),
        rows: c
            .ranked()
            .into_iter()
            .map(|(name, number)| CertificateRow {
                name: name.to_owned(),
                value: value(number),
                unit: number.unit.clone(),
                verdict: number.verdict.clone(),
                reason: number.reason.clone(),
                marked: number.verdict == Verdict::Neither.name(),
            })
            .collect(),
    }
}
