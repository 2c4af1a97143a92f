//! Footer of a table of a sweep.

use std::path::Path;

use cageless_io::plan_file::difference;
use cageless_io::results::{TableReader, VERSION};

use super::evaluate::Sweep;
use super::shard::Shard;
use crate::StudyError;

/// Version of the layout of the tables.
const SCHEMA: u64 = 1;

/// Identity of the sweep of a table: rows of one identity may be merged.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Identity {
    /// Version of Cageless.
    pub version: String,
    /// The plan in its normal form.
    pub plan: String,
    /// Seed of the plan.
    pub seed: u64,
    /// Number of variants of the whole plan.
    pub variants: u64,
}

impl Identity {
    /// Identity of a sweep of this program.
    pub fn new(sweep: &Sweep) -> Self {
        Self {
            version: VERSION.to_owned(),
            plan: sweep.normal().to_owned(),
            seed: sweep.plan().seed,
            variants: sweep.variants(),
        }
    }

    /// Identity of an existing table; `None` if it is not one of a sweep.
    pub fn read(table: &TableReader) -> Option<Self> {
        let number = |key| table.footer(key)?.parse().ok();
        (number("schema")? == SCHEMA).then_some(())?;
        Some(Self {
            version: table.footer("version")?.to_owned(),
            plan: table.footer("plan")?.to_owned(),
            seed: number("seed")?,
            variants: number("variants")?,
        })
    }

    /// The footer of a table, computed with the instruction sets `isa`.
    pub(crate) fn footer(
        &self,
        isa: &[String],
        shard: Option<Shard>,
    ) -> Vec<(&'static str, String)> {
        let mut footer = vec![
            ("schema", SCHEMA.to_string()),
            ("version", self.version.clone()),
            ("isa", isa.join(", ")),
            ("seed", self.seed.to_string()),
            ("variants", self.variants.to_string()),
            ("plan", self.plan.clone()),
        ];
        footer.extend(shard.map(|shard| ("shard", shard.to_string())));
        footer
    }

    /// Text of the identity, to be read by [`Identity::differences`].
    pub(crate) fn text(&self) -> String {
        format!("version = {}\n{}", self.version, self.plan)
    }

    /// Whether `result` is there and holds all `rows` of this sweep, or of a shard of it.
    /// Anything else in its place is refused, with the differences.
    pub(crate) fn is_there(
        &self,
        result: &Path,
        shard: Option<Shard>,
        rows: u64,
    ) -> Result<bool, StudyError> {
        if !result.exists() {
            return Ok(false);
        }
        let remedy = "Choose another --out, or remove it";
        let what = result.display().to_string();
        let foreign = |why: &str| StudyError::Input(format!("{what} {why}. {remedy}"));
        if result.is_dir() {
            return Err(foreign("is a directory where the result is to be"));
        }
        let found = TableReader::open(result)?;
        let before = Self::read(&found).ok_or_else(|| foreign("is not the result of a sweep"))?;
        self.must_be(&before.text(), &what, remedy)?;
        let shard = shard.map(|s| s.to_string());
        if found.footer("shard") != shard.as_deref() || found.rows() != rows {
            return Err(foreign("holds another part of the sweep"));
        }
        Ok(true)
    }

    /// Refuses a table of another sweep, or of none.
    pub(crate) fn must_own(&self, table: &TableReader, remedy: &str) -> Result<(), StudyError> {
        let what = table.path().display().to_string();
        let found = Self::read(table)
            .ok_or_else(|| StudyError::Input(format!("{what} is not part of a sweep. {remedy}")))?;
        self.must_be(&found.text(), &what, remedy)
    }

    /// Refuses another identity, with the differences.
    pub(crate) fn must_be(&self, before: &str, what: &str, remedy: &str) -> Result<(), StudyError> {
        let differences = difference(before, &self.text());
        if differences.is_empty() {
            return Ok(());
        }
        Err(StudyError::Input(format!(
            "{what} is of another plan: {}. {remedy}",
            differences.join("; ")
        )))
    }
}

/// Adds the instruction sets of a table to a sorted list.
pub(crate) fn add_isa(list: &mut Vec<String>, isa: &str) {
    list.extend(isa.split(", ").filter(|s| !s.is_empty()).map(str::to_owned));
    list.sort_unstable();
    list.dedup();
}
