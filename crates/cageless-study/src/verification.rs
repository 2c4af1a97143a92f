//! How far the numbers of a run can be trusted: the members of its certificate, run on all
//! threads.

use cageless::Case;
use cageless::certificate::{Certificate, FAR, Member, MemberError, Watch, members};
use cageless::simulation::{Ending, Observer, RunOutcome};
use cageless_io::results::{CertificateFile, SummaryFile};
use rayon::prelude::*;

use crate::watcher::Watcher;

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
    pub fn watch(&mut self) -> &mut (dyn Observer + Send) {
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
        watcher: &dyn Watcher,
    ) {
        if !matches!(outcome.ending, Ending::Complete) {
            summary
                .warnings
                .push("not verified: the run did not come to its end".to_owned());
            return;
        }
        match self.certify(case, outcome, watcher) {
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
        watcher: &dyn Watcher,
    ) -> Result<Certificate, MemberError> {
        let first = self.watch.record(outcome)?;
        let others = &self.members[1..];
        let work = |member: &Member| if member.role.half_step { 2.0 } else { 1.0 };
        let progress = watcher.begin("verify", others.iter().map(work).sum());
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
