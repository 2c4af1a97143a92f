//! Benefit of a raceway as drawn and at both ends of its machining tolerances.

use cageless_design::tolerance::Tolerances;
use cageless_io::case_file::{CaseFile, MachiningErrors};
use cageless_results::Provenance;
use serde::Serialize;

use crate::benefit_search::quick;
use crate::comparison::{
    Benefit, BenefitWord, DRAWS, RingComparison, judged_rings, plain_ring, steady_provenance,
    steady_task, with_fewer_balls,
};
use crate::error::StudyError;
use crate::progress::Progress;
use crate::task::Task;

/// Name of the task.
const TASK: &str = "benefit";

/// Benefit within tolerances.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct TolerancedBenefit {
    /// Benefit of the raceway that helps least.
    pub benefit: BenefitWord,
    /// Benefit of each raceway, in a sentence.
    pub answer: String,
    /// Plain ring, raceway as drawn, those with the smallest and the largest critical gap, and one ball fewer.
    pub comparison: RingComparison,
    /// Provenance of the runs.
    #[serde(skip)]
    pub provenance: Provenance,
}

impl TolerancedBenefit {
    /// Whether every raceway helps; `None` if that is not judged or cannot be measured.
    pub fn helps(&self) -> Option<bool> {
        self.benefit.helps()
    }
}

/// Rings of a case and its tolerances: the plain one, those with the raceway, and the plain one with one ball fewer.
pub(crate) struct TolerancedRings(Vec<(String, CaseFile)>);

/// Rings with the raceway: as drawn and at both ends of its tolerances.
const RACEWAYS: usize = 3;

impl TolerancedRings {
    /// A deeper, shorter and narrower raceway has the smallest critical gap, the opposite the largest.
    ///
    /// # Errors
    /// A raceway at the end of its tolerances is not possible.
    pub(crate) fn new(file: &CaseFile, tolerances: &Tolerances) -> Result<Self, StudyError> {
        let file = &quick(file)?;
        let plain = plain_ring(file)?;
        let fewer = with_fewer_balls(&plain, 1)?;
        let machined = |weaker: f64| {
            file.with_machined_raceways(&MachiningErrors {
                groove_depth_m: weaker * tolerances.groove_depth_m,
                axial_span_m: -weaker * tolerances.axial_span_m,
                half_angle_rad: -weaker * tolerances.half_angle_rad,
            })
        };
        let rings = [
            ("plain".to_owned(), plain),
            ("as drawn".to_owned(), file.clone()),
            ("weakest".to_owned(), machined(1.0)?),
            ("strongest".to_owned(), machined(-1.0)?),
            (
                format!("plain, {} balls", fewer.case().bearing.balls()),
                fewer,
            ),
        ];
        Ok(Self(rings.into()))
    }

    /// The task of [`Self::judge`].
    pub(crate) fn task(&self) -> Result<Task, StudyError> {
        steady_task(TASK, &self.0, DRAWS)
    }

    /// Judges the raceways against the plain ring.
    ///
    /// # Errors
    /// A run left the physical range, or the progress ended the work.
    pub(crate) fn judge(&self, progress: &dyn Progress) -> Result<TolerancedBenefit, StudyError> {
        let comparison = judged_rings(&self.0, DRAWS, TASK, progress)?;
        let benefits: Vec<&Benefit> = comparison.benefits.iter().flatten().collect();
        let named = comparison.runs[1..].iter().zip(&benefits).take(RACEWAYS);
        let worst = named.clone().max_by_key(|(_, b)| severity(b.benefit));
        let (benefit, mut answer) = match worst {
            None => (BenefitWord::NotJudged, String::new()),
            Some((_, worst)) if worst.benefit == BenefitWord::Helps => {
                let drawn = &benefits[0].why;
                let all = "The raceway helps as drawn and at both ends of its tolerances";
                (worst.benefit, format!("{all}. As drawn: {drawn}."))
            }
            Some((name, worst)) => {
                let words = named.map(|(name, b)| format!("{name} {}", b.benefit.label()));
                let words: Vec<String> = words.collect();
                let why = format!("{name}: {}", worst.why);
                (
                    worst.benefit,
                    format!("Raceway {}; {why}.", words.join(", ")),
                )
            }
        };
        if let Some(fewer) = benefits.last() {
            answer += &format!(" One ball fewer: {}.", fewer.benefit.label());
        }
        Ok(TolerancedBenefit {
            benefit,
            answer,
            provenance: steady_provenance(&self.0[0].1),
            comparison,
        })
    }
}

/// Order of what speaks against a raceway.
fn severity(benefit: BenefitWord) -> u8 {
    match benefit {
        BenefitWord::Helps => 0,
        BenefitWord::NoMeasurableBenefit => 1,
        BenefitWord::NotJudged => 2,
        BenefitWord::Harms => 3,
    }
}

#[cfg(test)]
mod tests {
    use cageless::simulation::Control;
    use cageless_design::judge;
    use cageless_io::case_file::template;

    use super::*;
    use crate::tolerance::Request;

    /// Each machining error alone moves the critical gap to the side on which its ring stands.
    #[test]
    fn the_weakest_raceway_has_the_smallest_critical_gap() {
        let none = Request {
            groove_depth_um: 0.0,
            axial_span_um: 0.0,
            half_angle_deg: 0.0,
            ..Request::default()
        };
        let depth = Request {
            groove_depth_um: 5.0,
            ..none
        };
        let span = Request {
            axial_span_um: 50.0,
            ..none
        };
        let angle = Request {
            half_angle_deg: 1.0,
            ..none
        };
        for flanks in ["rigid", "elastic"] {
            let set = [format!("model.flanks={flanks}")];
            let file = CaseFile::parse(&template(false), "case", &set).unwrap();
            for request in [depth, span, angle] {
                let tolerances = request.check(file.case(), "case").unwrap();
                let rings = TolerancedRings::new(&file, &tolerances).unwrap();
                let gaps: Vec<f64> = rings.0[1..=RACEWAYS]
                    .iter()
                    .map(|(_, ring)| {
                        let judged = judge(ring.case(), &mut |_| Control::Continue(()));
                        judged.unwrap().critical_gap_rad.unwrap()
                    })
                    .collect();
                let [drawn, weakest, strongest] = gaps[..] else {
                    panic!("{gaps:?}");
                };
                assert!(
                    weakest < drawn && drawn < strongest,
                    "{flanks} {request:?} {gaps:?}"
                );
            }
        }
    }

    /// The case of a bearing is that of its machining errors, however it is made.
    #[test]
    fn machined_raceways_are_those_of_the_tolerance_table() {
        let file = CaseFile::parse(&template(false), "case", &[]).unwrap();
        let tolerances = Request::default().check(file.case(), "case").unwrap();
        let rings = TolerancedRings::new(&file, &tolerances).unwrap();
        let weakest = &rings.0[2].1.case().raceways[0];
        let (found, drawn) = (weakest.dimensions(), file.case().raceways[0].dimensions());
        let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-12, "{a} {b}");
        near(found.axial_span_m, drawn.axial_span_m - 20e-6);
        near(
            found.half_angle_rad,
            drawn.half_angle_rad - 0.1f64.to_radians(),
        );
        near(weakest.depth_error_m(), 2e-6);
    }

    #[test]
    fn what_harms_weighs_most() {
        let mut words = BenefitWord::ALL.to_vec();
        words.sort_by_key(|word| severity(*word));
        let last = [BenefitWord::NotJudged, BenefitWord::Harms];
        assert_eq!(words[0], BenefitWord::Helps);
        assert_eq!(words[2..], last);
    }
}
