//! Writes the page of a reproduction again from its numbers: `reproduce_page report.json report.html`.

use cageless_report::{ReproduceData, from_json, reproduce_page};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut paths = std::env::args().skip(1);
    let (Some(numbers), Some(page)) = (paths.next(), paths.next()) else {
        return Err("usage: reproduce_page report.json report.html".into());
    };
    let data: ReproduceData = from_json(&std::fs::read_to_string(numbers)?)?;
    std::fs::write(page, reproduce_page(&data))?;
    Ok(())
}
