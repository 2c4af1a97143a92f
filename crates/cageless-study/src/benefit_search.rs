//! The raceway that helps most in steady operation, beside a plain ring and one ball fewer.

use cageless::steady::SteadyOperation;
use cageless_io::case_file::{CaseError, CaseFile};
use cageless_results::{Provenance, Record};
use serde::Serialize;

use crate::comparison::{
    Benefit, BenefitWord, DRAWS, RingComparison, judged_rings, plain_ring, steady_provenance,
    steady_task, with_fewer_balls,
};
use crate::error::StudyError;
use crate::progress::Progress;
use crate::task::Task;

/// Raceways of a search that short runs compare.
pub const CANDIDATES: usize = 8;
/// Raceways of these that long runs judge at most.
const FINALISTS: usize = 2;
/// Draws of balls of short runs: with so many, two raceways fill the lanes of a vector.
const SHORT_DRAWS: u64 = 4;
/// Orbits that short runs measure, or those of the case if these are fewer, after the transient of the case or of the
/// default, whichever is shorter.
const SHORT_ORBITS: f64 = 80.0;

/// Names of the tasks of short and long runs.
const CHOICE: &str = "benefit: candidates";
const JUDGEMENT: &str = "benefit";

/// A raceway that may help: the case that has it.
#[derive(Debug, Clone)]
pub struct Candidate {
    /// Name in tables and sentences.
    pub name: String,
    /// The case with it.
    pub file: CaseFile,
}

/// Score of a candidate in short runs.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CandidateScore {
    /// Name.
    pub name: String,
    /// Weighted mean of ln(ratio) to the plain ring of what is asked for, below 0 better; `None` without results.
    pub score: Option<f64>,
}

/// Benefit of raceways in steady operation.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BenefitSearch {
    /// Benefit of the best raceway; `None` where there is none to judge.
    pub benefit: Option<BenefitWord>,
    /// Answer of the search: the best raceway beside one ball fewer, in sentences.
    pub answer: String,
    /// Reasons of the benefit of the best raceway.
    pub benefit_reasons: Vec<String>,
    /// Scores in short runs, best first; empty where all raceways were judged.
    pub candidates: Vec<CandidateScore>,
    /// Plain ring, one ball fewer and the best raceways in long runs.
    pub comparison: RingComparison,
    /// Provenance of the long runs.
    #[serde(skip)]
    pub provenance: Provenance,
    /// Index of the raceway that helps most among the candidates.
    #[serde(skip)]
    pub best: Option<usize>,
    /// Structure of that raceway, of a search.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub recommended: Option<Record>,
}

impl BenefitSearch {
    /// Whether the best raceway helps; `None` if that is not judged or cannot be measured.
    pub fn helps(&self) -> Option<bool> {
        self.benefit.and_then(BenefitWord::helps)
    }
}

/// The case as it runs here: with the integration of a search, which is several times as fast as others.
pub(crate) fn quick(file: &CaseFile) -> Result<CaseFile, CaseError> {
    let mut document = file.document().clone();
    document.set("solver.method", "verlet");
    document.set("solver.step_us", "auto");
    CaseFile::from_document(document, "case")
}

/// The plain ring of a case and that with one ball fewer.
fn plain_rings(file: &CaseFile) -> Result<Vec<(String, CaseFile)>, StudyError> {
    let balls = file.case().bearing.balls();
    let plain = quick(&plain_ring(file)?)?;
    let fewer = with_fewer_balls(&plain, 1)?;
    Ok(vec![
        (format!("plain, {balls} balls"), plain),
        (format!("plain, {} balls", balls - 1), fewer),
    ])
}

/// The rings of short runs: the plain one, then all candidates.
fn short(rings: &[(String, CaseFile)]) -> Result<Vec<(String, CaseFile)>, CaseError> {
    let shorter = rings.iter().map(|(name, file)| {
        let mut document = file.document().clone();
        let transient = file.steady().transient_orbits;
        let transient = transient.min(SteadyOperation::default().transient_orbits);
        document.set("steady.transient_orbits", transient);
        let measured = file.steady().measured_orbits.min(SHORT_ORBITS);
        document.set("steady.measured_orbits", measured);
        Ok((name.clone(), CaseFile::from_document(document, "case")?))
    });
    shorter.collect()
}

/// The tasks of [`search_benefit`] of so many candidates, for `Progress::whole`.
///
/// # Errors
/// The bearing does not take one ball fewer.
pub fn tasks(file: &CaseFile, candidates: usize) -> Result<Vec<Task>, StudyError> {
    let mut rings = plain_rings(file)?;
    let own = ("raceway".to_owned(), quick(file)?);
    let judged = candidates.min(FINALISTS);
    let mut tasks = vec![];
    if candidates > judged {
        let mut all = vec![rings[0].clone()];
        all.resize(candidates + 1, own.clone());
        tasks.push(steady_task(CHOICE, &short(&all)?, SHORT_DRAWS)?);
    }
    rings.resize(judged + 2, own);
    tasks.push(steady_task(JUDGEMENT, &rings, DRAWS)?);
    Ok(tasks)
}

/// Candidates that are to be judged.
struct Chosen {
    /// Scores of all in short runs, the best first; empty without these.
    scores: Vec<CandidateScore>,
    /// Their places in the list of candidates.
    judged: Vec<usize>,
}

impl Chosen {
    /// All that work.
    fn of_few(
        candidates: usize,
        works: &dyn Fn(usize) -> Result<bool, StudyError>,
    ) -> Result<Self, StudyError> {
        let mut judged = vec![];
        for k in 0..candidates {
            if works(k)? {
                judged.push(k);
            }
        }
        Ok(Self {
            scores: vec![],
            judged,
        })
    }

    /// The best by short runs; `rings` has the plain one before those of the candidates.
    fn of_many(
        rings: &[(String, CaseFile)],
        works: &dyn Fn(usize) -> Result<bool, StudyError>,
        progress: &dyn Progress,
    ) -> Result<Self, StudyError> {
        let found = judged_rings(&short(rings)?, SHORT_DRAWS, CHOICE, progress)?;
        let mut ranked: Vec<(usize, &Benefit)> =
            found.benefits.iter().flatten().enumerate().collect();
        ranked.sort_by(|(_, a), (_, b)| a.rank.compare(&b.rank));
        let scores = ranked.iter().map(|(k, benefit)| CandidateScore {
            name: rings[k + 1].0.clone(),
            score: Some(benefit.rank.score).filter(|score| score.is_finite()),
        });
        let scores = scores.collect();
        let (mut judged, mut leader) = (vec![], None::<&Benefit>);
        for (k, benefit) in ranked {
            // Where the best is worse than the plain ring, the next changes no answer.
            let contends =
                leader.is_none_or(|leader| !leader.loses() && !benefit.is_clearly_worse(leader));
            if judged.len() < FINALISTS && contends && works(k)? {
                leader = leader.or(Some(benefit));
                judged.push(k);
            }
        }
        Ok(Self { scores, judged })
    }
}

fn helps(benefit: &Benefit) -> bool {
    benefit.benefit == BenefitWord::Helps
}

/// The best raceway beside one ball fewer, in a sentence.
fn answer(comparison: &RingComparison, raceway: Option<&Benefit>) -> String {
    let fewer = comparison.benefits[1].as_ref();
    let said = |benefit: Option<&Benefit>| benefit.map_or(String::new(), |b| b.headline.clone());
    match raceway.map(|b| b.benefit) {
        None => format!("There is no raceway to judge. {}.", said(fewer)),
        Some(BenefitWord::Helps) => {
            let fewer = fewer.map_or("", |b| b.benefit.label());
            let one = &comparison.runs[1];
            format!("{}. {one}: {fewer}.", said(raceway))
        }
        Some(_) if fewer.is_some_and(helps) => {
            format!(
                "No raceway helps here, one ball fewer does. {}.",
                said(fewer)
            )
        }
        Some(BenefitWord::NotJudged) => format!("{}.", said(raceway)),
        Some(_) => {
            let both = format!("{}. {}", said(raceway), said(fewer));
            format!("Neither a raceway nor one ball fewer helps here. {both}.")
        }
    }
}

/// Judges raceways in steady operation against the plain ring of a case, and one ball fewer beside them. Of many, short
/// runs leave the best, and one that is not clearly worse if the best may help. Candidates that do not work otherwise are left out.
///
/// # Errors
/// A case cannot start, a run left the physical range, or the progress ended the work.
pub fn search_benefit(
    file: &CaseFile,
    candidates: &[Candidate],
    works: &dyn Fn(usize) -> Result<bool, StudyError>,
    progress: &dyn Progress,
) -> Result<BenefitSearch, StudyError> {
    let mut rings = plain_rings(file)?;
    let named = |c: &Candidate| Ok::<_, CaseError>((c.name.clone(), quick(&c.file)?));
    let all: Vec<_> = candidates.iter().map(named).collect::<Result<_, _>>()?;
    let all_rings = [&rings[..1], &all].concat();
    let Chosen { scores, judged } = match candidates.len() > FINALISTS {
        true => Chosen::of_many(&all_rings, works, progress)?,
        false => Chosen::of_few(candidates.len(), works)?,
    };
    rings.extend(judged.iter().map(|&k| all[k].clone()));
    let comparison = judged_rings(&rings, DRAWS, JUDGEMENT, progress)?;
    let of_raceways = comparison.benefits[2..].iter().flatten().zip(&judged);
    let best = of_raceways.min_by(|(a, _), (b, _)| {
        let last = helps(b).cmp(&helps(a));
        last.then(a.rank.compare(&b.rank))
    });
    Ok(BenefitSearch {
        benefit: best.map(|(b, _)| b.benefit),
        answer: answer(&comparison, best.map(|(b, _)| b)),
        benefit_reasons: best.map_or(vec![], |(b, _)| b.benefit_reasons.clone()),
        best: best.filter(|(b, _)| helps(b)).map(|(_, &k)| k),
        recommended: None,
        provenance: steady_provenance(&rings[0].1),
        candidates: scores,
        comparison,
    })
}
