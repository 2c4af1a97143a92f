//! The studio: a page, or a part of one, that computes what its reader changes.

use serde_json::json;

use crate::text::script_json;

/// Remedy for a build without an engine for its pages.
pub const ENGINE_REMEDY: &str = env!("CAGELESS_ENGINE_REMEDY");

/// The engine, compressed and as base64; `None` if this build has none.
pub fn engine() -> Option<&'static str> {
    const ENGINE: &str = include!(concat!(env!("OUT_DIR"), "/engine.rs"));
    Some(ENGINE).filter(|text| !text.is_empty())
}

/// Time at which a studio begins to compute.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Opening {
    /// Opening of the page.
    AtOnce,
    /// Request of the reader.
    OnRequest,
}

/// Place of a studio in a page, with its case and the engine.
pub(crate) fn place(toml: &str, opening: Opening) -> String {
    let opening = match opening {
        Opening::AtOnce => "now",
        Opening::OnRequest => "later",
    };
    format!(
        "<div data-studio=\"{opening}\"><script type=\"application/json\" data-case>{}</script>\
         <script type=\"text/plain\" data-engine>{}</script></div>\n",
        script_json(&json!(toml)),
        engine().unwrap_or_default()
    )
}

/// Scripts of the studio: the source of its workers, and one module of all its parts.
pub(crate) fn scripts() -> String {
    let module = [
        include_str!("studio/dom.js"),
        include_str!("studio/engine.js"),
        include_str!("studio/case.js"),
        include_str!("studio/controls.js"),
        include_str!("studio/materials.js"),
        include_str!("studio/form.js"),
        include_str!("studio/draw.js"),
        include_str!("studio/contacts.js"),
        include_str!("studio/svg.js"),
        include_str!("studio/motion.js"),
        include_str!("studio/verdict.js"),
        include_str!("studio/comparison.js"),
        include_str!("studio/stage.js"),
        include_str!("studio/map.js"),
        include_str!("studio/surface.js"),
        include_str!("studio/drop.js"),
        include_str!("studio/studies.js"),
        include_str!("studio/save.js"),
        include_str!("studio/toolbar.js"),
        include_str!("studio/studio.js"),
        include_str!("studio/open.js"),
    ]
    .join("\n");
    format!(
        "<script type=\"text/plain\" data-worker>{}</script>\n<script type=\"module\">{module}</script>\n",
        include_str!("studio/worker.js")
    )
}

/// Style of the studio.
pub(crate) const STYLE: &str = include_str!("studio/studio.css");
