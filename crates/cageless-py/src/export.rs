//! The outer ring as files.

use std::path::{Path, PathBuf};

use cageless_io::cad::{Export, ExportNumbers, ExportOptions, Format, export, names_file};
use cageless_io::case_file::CaseFile;
use cageless_io::results::{PartialFile, ResultError, write_atomically};
use pyo3::prelude::*;

use crate::errors::{input, of_export, of_folder, of_results, other};

/// Numbers of the files in a folder.
const NUMBERS: &str = "export.json";

/// Writes the ring as one file, or as several into a folder; the numbers are JSON.
pub fn write(
    py: Python<'_>,
    file: &CaseFile,
    out: &Path,
    formats: Option<Vec<String>>,
    options: &ExportOptions,
) -> PyResult<String> {
    let file_is_meant = names_file(out);
    let named = Format::from_path(out).filter(|_| file_is_meant);
    if file_is_meant && named.is_none() {
        return Err(input(format!(
            "out = {}: the name of a file ends in .step, .stp, .stl or .csv, that of a folder has \
             no ending, or a slash at its end",
            out.display()
        )));
    }
    let formats = match formats {
        Some(names) => names.iter().map(|n| format(n)).collect::<PyResult<_>>()?,
        None => named.map_or(Format::ALL.to_vec(), |format| vec![format]),
    };
    check(out, named, &formats)?;
    options.check(&formats).map_err(|e| of_export(&e))?;
    py.detach(|| {
        let made = formats.iter().map(|&format| export(file, format, options));
        let made = made
            .collect::<Result<Vec<_>, _>>()
            .map_err(|e| of_export(&e))?;
        // Only now, so that bad input leaves no folder behind.
        if named.is_none() {
            std::fs::create_dir_all(out).map_err(|e| of_folder(out, e))?;
        }
        let mut numbers = Vec::new();
        for (format, made) in formats.iter().zip(&made) {
            let path = match named {
                Some(_) => PathBuf::from(out),
                None => out.join(format!("outer_ring.{}", format.name())),
            };
            numbers.push(into_file(made, &path).map_err(|e| of_results(&e))?);
        }
        if named.is_none() {
            let json = match numbers.as_slice() {
                [one] => serde_json::to_string_pretty(one),
                several => serde_json::to_string_pretty(several),
            };
            let json = json.map_err(other)? + "\n";
            write_atomically(&out.join(NUMBERS), json.as_bytes()).map_err(|e| of_results(&e))?;
        }
        serde_json::to_string(&numbers).map_err(other)
    })
}

fn into_file(made: &Export, path: &Path) -> Result<ExportNumbers, ResultError> {
    let mut file = PartialFile::create(path)?;
    let mut numbers = made.write(&mut file).map_err(|source| ResultError::Out {
        path: path.to_owned(),
        source,
    })?;
    file.commit()?;
    numbers.file = Some(path.display().to_string());
    Ok(numbers)
}

fn format(name: &str) -> PyResult<Format> {
    let known = Format::ALL.into_iter().find(|f| f.name() == name);
    known.ok_or_else(|| {
        input(format!(
            "formats = {name:?} is not possible: it must be of step, stl, csv"
        ))
    })
}

fn check(out: &Path, named: Option<Format>, formats: &[Format]) -> PyResult<()> {
    let Some(first) = formats.first() else {
        let message = "formats = [] is not possible: it must be of step, stl, csv";
        return Err(input(message));
    };
    match named {
        Some(named) if formats != [named] => Err(input(format!(
            "out = {}: is the name of a file of format {}, not of {}",
            out.display(),
            named.name(),
            formats
                .iter()
                .find(|f| **f != named)
                .unwrap_or(first)
                .name()
        ))),
        _ => Ok(()),
    }
}
