//! `cageless static`.

use cageless_report::static_page;
use cageless_results::equilibrium_record_noted;

use crate::args::StaticArgs;
use crate::driver::{Answer, PAGE, pretty, read_case_at_rest};
use crate::failure::Failure;
use crate::format::{columns, grouped, notes, pairs, warnings};

/// Solves and shows the equilibrium.
pub fn static_equilibrium(args: &StaticArgs) -> Result<(), Failure> {
    let (balls, args) = (args.balls, &args.case);
    let (file, note) = read_case_at_rest(&args.case, &args.set)?.resting()?;
    file.checked(|case| case.check_constant_operation("a static equilibrium"))?;
    let record = equilibrium_record_noted(file.case(), file.particulars(), note)?;
    let record = match file.oil_temperature_warning() {
        Some(warning) => {
            let warned = record.sentences("warnings").iter().cloned();
            let warned = warned.chain([warning]).collect();
            record.with_sentences("warnings", warned)
        }
        None => record,
    };
    let balls = match balls {
        true => columns(&record.results.columns()) + "\n",
        false => String::new(),
    };
    let limits = record.limits().lines();
    let limits = match limits.is_empty() {
        true => String::new(),
        false => pairs(&limits) + "\n",
    };
    let text = limits
        + &grouped(&record.results)
        + "\n"
        + &balls
        + &warnings(record.sentences("warnings"))
        + &notes(record.sentences("notes"));
    let files = args
        .output
        .files(|| Ok(vec![(PAGE, Some(static_page(&file, &record).into()))]))?;
    args.output.deliver(Answer {
        files,
        csv: true,
        ..Answer::new("static.json", pretty(&record)?, text)
    })
}
