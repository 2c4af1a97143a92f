//! The driver of commands that compute: folder, progress, files, text, page and exit code.

use std::io::Write;
use std::path::Path;

use cageless::dynamics::InstructionSet;
use cageless_io::arrangement::BearingArrangement;
use cageless_io::case_file::CaseFile;
use cageless_io::results::{Metadata, ResultError, ResultFolder, RunWriter, values_csv};
use cageless_io::{io_error_message, on_terminal};
use cageless_study::Progress;
use cageless_study::run::Rows;
use serde::Serialize;

use crate::args::{CaseArgs, Output};
use crate::failure::Failure;
use crate::format::pairs;
use crate::interrupt::Interrupt;
use crate::progress::{Bars, is_quiet, message};

/// Page in the folder of `--out`.
pub const PAGE: &str = "report.html";
/// Data of the page.
pub const PAGE_DATA: &str = "report.json";

/// Files of a folder by name; `None`: one of an earlier call is removed.
pub type Files = Vec<(&'static str, Option<Vec<u8>>)>;

/// Results of a command.
pub struct Answer {
    /// Name of the JSON document in the folder.
    pub name: &'static str,
    /// JSON document that `--json` prints.
    pub json: String,
    /// Text for the terminal.
    pub text: String,
    /// Whether the folder has the JSON document as CSV even if that is not asked for.
    pub csv: bool,
    /// Further files of the folder.
    pub files: Files,
    /// File of which nothing is needed any longer once the answer is there.
    pub journal: Option<&'static str>,
    /// Ending of the command once all is delivered.
    pub ending: Result<(), Failure>,
}

impl Answer {
    /// An answer without further files.
    pub fn new(name: &'static str, json: String, text: String) -> Self {
        Self {
            name,
            json,
            text,
            csv: false,
            files: vec![],
            journal: None,
            ending: Ok(()),
        }
    }
}

/// A JSON document on many lines.
pub fn pretty<T: Serialize>(result: &T) -> Result<String, Failure> {
    Ok(serde_json::to_string_pretty(result)? + "\n")
}

impl Output {
    /// Computes and delivers what is computed. Bad input is to be found before, so that it leaves no
    /// folder behind; what stands where one of `files` is to be, before anything is computed.
    pub fn drive(
        &self,
        files: &[&str],
        compute: impl FnOnce(&dyn Progress) -> Result<Answer, Failure>,
    ) -> Result<(), Failure> {
        self.drive_into(files, |_, bars| compute(bars))
    }

    /// [`Self::drive`] of what writes tables into the folder while it computes.
    pub fn drive_into(
        &self,
        files: &[&str],
        compute: impl FnOnce(&mut Option<ResultFolder>, &dyn Progress) -> Result<Answer, Failure>,
    ) -> Result<(), Failure> {
        let mut folder = self.folder()?;
        if let Some(folder) = &folder {
            files
                .iter()
                .try_for_each(|name| writable(&folder.dir().join(name)))?;
        }
        let stop = Interrupt::caught();
        let bars = Bars::new(&stop);
        let answer = compute(&mut folder, &bars)?;
        drop(bars);
        self.deliver_into(folder, answer)
    }

    /// The folder of `--out`, which nobody else writes to until the answer is delivered.
    fn folder(&self) -> Result<Option<ResultFolder>, ResultError> {
        self.out.as_deref().map(ResultFolder::open).transpose()
    }

    /// Writes the files, prints JSON or text and opens the page.
    pub fn deliver(&self, answer: Answer) -> Result<(), Failure> {
        self.deliver_into(self.folder()?, answer)
    }

    fn deliver_into(
        &self,
        folder: Option<ResultFolder>,
        mut answer: Answer,
    ) -> Result<(), Failure> {
        if let Some(mut folder) = folder {
            for (name, contents) in &answer.files {
                match contents {
                    Some(contents) => folder.add(name, contents)?,
                    None => folder.remove(name),
                }
            }
            let kind = answer.name.trim_end_matches(".json");
            let as_csv = format!("{kind}.csv");
            match answer.csv || self.csv {
                true => {
                    let values = values_csv(kind, &serde_json::from_str(&answer.json)?);
                    folder.add(&as_csv, values.as_bytes())?;
                }
                // Page data are no result.
                false if answer.name == PAGE_DATA => {}
                false => folder.remove(&as_csv),
            }
            folder.commit(answer.name, &answer.json)?;
            if let Some(journal) = answer.journal {
                // It is in nobody's way if it stays.
                let _ = std::fs::remove_file(folder.dir().join(journal));
            }
        }
        let written = |(name, _): &&(&str, _)| *name == PAGE;
        let page = answer.files.iter().find(written).and(self.out.as_ref());
        let page = page.map(|dir| dir.join(PAGE));
        if let (Some(page), false) = (&page, answer.text.is_empty()) {
            answer.text += &pairs(&[("page", page.display().to_string())]);
        }
        match self.json {
            true => print(&answer.json)?,
            false => tell(&answer.text)?,
        }
        if let (true, Some(page)) = (self.open, &page)
            && let Err(error) = open::that_detached(page)
        {
            // Without a browser the page is there nevertheless.
            let page = page.display();
            message(&format!(
                "warning: {page} was written but could not be opened: {error}"
            ));
        }
        answer.ending
    }

    /// Delivers the answer of a command without a page.
    pub fn deliver_numbers(&self, mut answer: Answer) -> Result<(), Failure> {
        if self.open {
            let message = "--open: this command writes no page";
            return Err(Failure::Input(message.to_owned()));
        }
        answer.csv = true;
        self.deliver(answer)
    }

    /// Output of a command that always writes a page into a folder.
    pub fn of_page(json: bool, open: bool, folder: &Path) -> Self {
        Self {
            json,
            out: Some(folder.to_owned()),
            csv: false,
            open,
        }
    }

    /// Files for a folder; none without one.
    pub fn files(&self, files: impl FnOnce() -> Result<Files, Failure>) -> Result<Files, Failure> {
        match self.out {
            Some(_) => files(),
            None => Ok(vec![]),
        }
    }
}

/// Tables of a run or drop in the making; none without a folder.
pub struct Tables(Vec<Option<RunWriter>>);

impl Tables {
    /// Opens the tables of bearings, each in a place within the folder.
    pub fn create<'c>(
        folder: Option<&ResultFolder>,
        bearings: impl IntoIterator<Item = (String, &'c CaseFile)>,
    ) -> Result<Self, Failure> {
        let isa = InstructionSet::chosen().name();
        let open = |(place, file): (String, &CaseFile)| -> Result<_, Failure> {
            let Some(folder) = folder else {
                return Ok(None);
            };
            let case = serde_json::to_string(&file.document_as_run())?;
            let metadata = Metadata {
                isa,
                case: &case,
                in_space: file.case().moves_in_space(),
            };
            Ok(Some(folder.tables(&place, &metadata)?))
        };
        let writers: Result<_, _> = bearings.into_iter().map(open).collect();
        writers.map(Self)
    }

    /// Receivers of the rows of each bearing.
    pub fn rows(&mut self) -> Vec<Option<&mut (dyn Rows + Send)>> {
        let writers = self.0.iter_mut().map(Option::as_mut);
        writers
            .map(|writer| writer.map(|writer| writer as &mut (dyn Rows + Send)))
            .collect()
    }

    /// Completes the tables, and those as CSV, too, if `csv`.
    pub fn finish(self, folder: &mut Option<ResultFolder>, csv: bool) -> Result<(), Failure> {
        if let Some(folder) = folder {
            for writer in self.0.into_iter().flatten() {
                folder.add_tables(writer, csv)?;
            }
        }
        Ok(())
    }
}

impl CaseArgs {
    /// The case of a command that takes those which pass a check.
    pub fn read(
        &self,
        check: fn(&cageless::Case) -> Result<(), cageless::InputError>,
    ) -> Result<CaseFile, Failure> {
        let file = read_case(&self.case, &self.set)?;
        file.checked(check)?;
        Ok(file)
    }
}

/// Reads the case of a command.
pub fn read_case(path: &Path, set: &[String]) -> Result<CaseFile, Failure> {
    of_case(path, BearingArrangement::read(path, set)?)
}

/// [`read_case`] of a command that computes no motion.
pub fn read_case_at_rest(path: &Path, set: &[String]) -> Result<CaseFile, Failure> {
    of_case(path, BearingArrangement::read_at_rest(path, set)?)
}

fn of_case(path: &Path, file: BearingArrangement) -> Result<CaseFile, Failure> {
    file.case().cloned().ok_or_else(|| {
        Failure::Input(format!(
            "{}: is the file of a rotor on several bearings, which `cageless drop`, `cageless \
             check` and the plans of `cageless sweep` take; for any other command give the case of one \
             bearing, the file that its [[bearing]] names as case",
            path.display()
        ))
    })
}

/// Prints text to stdout, without control sequences. A closed pipe (`cageless new | head`) is not an error.
pub fn print(text: &str) -> Result<(), Failure> {
    let mut out = std::io::stdout().lock();
    let text = on_terminal(text);
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() == std::io::ErrorKind::BrokenPipe => Ok(()),
        other => Ok(other?),
    }
}

/// Prints a result as text, unless the user wants none.
pub fn tell(text: &str) -> Result<(), Failure> {
    if is_quiet() { Ok(()) } else { print(text) }
}

/// Makes the folder of `--out`.
pub fn make_folder(dir: &Path) -> Result<(), Failure> {
    std::fs::create_dir_all(dir).map_err(|error| {
        Failure::Input(format!(
            "--out {}: {}",
            dir.display(),
            io_error_message(&error)
        ))
    })
}

/// Refuses a folder where a file is to be.
pub fn writable(path: &Path) -> Result<(), Failure> {
    if path.is_dir() {
        let path = path.display();
        return Err(Failure::Input(format!(
            "--out {path}: is a directory where a file is to be"
        )));
    }
    Ok(())
}
