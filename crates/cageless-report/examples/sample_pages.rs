//! Writes pages with made-up data, to the directory given.

#[path = "../tests/synthetic/mod.rs"]
mod synthetic;

fn main() -> std::io::Result<()> {
    let directory = std::env::args().nth(1).unwrap_or_else(|| ".".into());
    let directory = std::path::Path::new(&directory);
    let pages = [
        (
            "reproduce.html",
            cageless_report::reproduce_page(&synthetic::reproduce()),
        ),
        (
            "run.html",
            cageless_report::run_page(&synthetic::run_data()),
        ),
        (
            "design.html",
            cageless_report::design_page(&synthetic::design()),
        ),
    ];
    for (name, page) in pages {
        println!("{name}: {:.1} MB", page.len() as f64 / 1e6);
        std::fs::write(directory.join(name), page)?;
    }
    Ok(())
}
