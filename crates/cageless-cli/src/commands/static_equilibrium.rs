//! `cageless static`.

use cageless::equilibrium::solve;
use cageless_io::results::write_atomically;
use cageless_report::{static_page, static_sheet};
use cageless_results::static_record;

use super::files::{deliver, make_folder, read_case};
use crate::args::CaseArgs;
use crate::failure::Failure;
use crate::format::{columns, notes, page_line, pairs, values, warnings};

/// Solves and shows the equilibrium.
pub fn static_equilibrium(args: &CaseArgs) -> Result<(), Failure> {
    let file = read_case(args)?;
    let case = file.case();
    let record = static_record(case, &solve(case)?);
    if let Some(dir) = &args.out {
        make_folder(dir)?;
        for (name, text) in [
            ("report.html", static_page(&file, &record)),
            ("sheet.html", static_sheet(&file, &record)),
        ] {
            write_atomically(&dir.join(name), text.as_bytes())?;
        }
    }
    let text = pairs(&values(&record.results))
        + "\n"
        + &columns(&record.results.columns())
        + "\n"
        + &warnings(record.sentences("warnings"))
        + &notes(record.sentences("notes"))
        + &page_line(args.out.as_deref(), "report.html");
    deliver(args, "static.json", &record, &text)
}
