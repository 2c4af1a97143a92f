//! Pages with a studio: one of its own, or the last section of a report.

use crate::data::Parameter;
use crate::page::Page;
use crate::studio::Opening;

/// The studio of a case as a page of its own, which names the instruction set that it computes with itself.
pub fn studio_page(toml: &str) -> String {
    let software = format!("Cageless {}", env!("CARGO_PKG_VERSION"));
    let mut page = Page::new("Cageless studio", "", &software);
    page.studio(toml, Opening::AtOnce);
    page.html()
}

/// The last section of a report: its case, to be changed. What was computed stays above it.
/// `about` says which case it is where the page has several.
pub(crate) fn studio_section(page: &mut Page, toml: &str, about: &str) {
    if !toml.is_empty() {
        page.section("Change this case");
        if !about.is_empty() {
            page.paragraph(about);
        }
        page.studio(toml, Opening::OnRequest);
    }
}

/// The last sections of a report: every key of its case, and the case to be changed.
pub(crate) fn case_sections(page: &mut Page, title: &str, keys: &[Parameter], toml: &str) {
    page.section(title);
    page.parameters("Case", "Every key of the case.", keys, None);
    studio_section(page, toml, "");
}
