//! What every page must be: self-contained, valid, labelled.

use std::collections::HashSet;
use std::sync::OnceLock;

use cageless_report::*;
use serde_json::Value;

/// A page of each kind, made once.
fn pages() -> &'static [(&'static str, String); 3] {
    static PAGES: OnceLock<[(&str, String); 3]> = OnceLock::new();
    PAGES.get_or_init(|| {
        [
            ("design", design_page(&crate::synthetic::design())),
            ("reproduce", reproduce_page(&crate::synthetic::reproduce())),
            ("run", run_page(&crate::synthetic::run_data())),
        ]
    })
}

/// The page without the contents of its scripts, and those contents.
pub fn split(page: &str) -> (String, Vec<String>) {
    let (mut html, mut scripts) = (String::new(), Vec::new());
    let mut rest = page;
    while let Some(at) = rest.find("<script") {
        let open = at + rest[at..].find('>').expect("a tag ends") + 1;
        let close = open + rest[open..].find("</script>").expect("a script ends");
        html.push_str(&rest[..open]);
        scripts.push(rest[open..close].to_owned());
        rest = &rest[close..];
    }
    html.push_str(rest);
    (html, scripts)
}

/// Values of `name="…"` in `html`.
fn attributes<'a>(html: &'a str, name: &str) -> Vec<&'a str> {
    let key = format!(" {name}=\"");
    html.split(&key)
        .skip(1)
        .filter_map(|part| part.split('"').next())
        .collect()
}

/// Specifications of the plots, with the anchor of their figure.
pub fn specs(page: &str) -> Vec<(String, Value)> {
    let mut out = Vec::new();
    for part in page
        .split("<script type=\"application/json\" id=\"")
        .skip(1)
    {
        let id = part.split("-spec\"").next().expect("an id").to_owned();
        let json = part
            .split_once('>')
            .and_then(|(_, t)| t.split("</script").next());
        let value = serde_json::from_str(json.expect("a body")).expect("valid JSON");
        out.push((id, value));
    }
    out
}

#[test]
fn pages_load_nothing() {
    for (name, page) in pages() {
        let (html, scripts) = split(page);
        assert!(attributes(&html, "src").is_empty(), "{name}");
        for target in attributes(&html, "href") {
            assert!(
                target.starts_with('#') || target.starts_with("data:"),
                "{name}: {target}"
            );
        }
        assert!(
            !html.contains("@import") && !html.contains("url("),
            "{name}"
        );
        // plotly.js comes along; MathJax, which the same crate carries, does not.
        assert_eq!(
            scripts.iter().filter(|s| s.contains("plotly.js v")).count(),
            1,
            "{name}"
        );
        assert!(
            !page.contains("MathJax.loader") && page.len() < 12_000_000,
            "{name}: {}",
            page.len()
        );
    }
}

#[test]
fn ids_are_unique_and_anchors_lead_somewhere() {
    for (name, page) in pages() {
        let (html, _) = split(page);
        let ids = attributes(&html, "id");
        let unique: HashSet<_> = ids.iter().collect();
        assert_eq!(ids.len(), unique.len(), "{name}");
        for target in attributes(&html, "href")
            .iter()
            .filter_map(|t| t.strip_prefix('#'))
        {
            assert!(unique.contains(&target), "{name}: {target}");
        }
        for figure in attributes(&html, "data-figure") {
            assert!(unique.contains(&figure), "{name}: {figure}");
        }
    }
}

#[test]
fn axes_have_units_and_figures_have_captions_and_provenance() {
    for (name, page) in pages() {
        let specs = specs(page);
        let least = if *name == "design" { 6 } else { 8 };
        assert!(specs.len() >= least, "{name}");
        for (id, spec) in &specs {
            let layout = spec["layout"].as_object().expect("a layout");
            let context = layout.get("scene").and_then(Value::as_object);
            let axes = layout.iter().chain(context.into_iter().flatten());
            let mut titled = 0;
            for (key, axis) in axes.filter(|(key, _)| key[1..].starts_with("axis")) {
                let title = axis["title"]["text"].as_str().unwrap_or_default();
                let bare = axis["showticklabels"] == false || axis["type"] == "category";
                assert!(
                    bare || title.ends_with(')') && title.contains('('),
                    "{name}, {id}, {key}: {title}"
                );
                titled += usize::from(title.ends_with(')'));
            }
            // The heading of a polar diagram has the unit; a title would lie across the numbers of its axis.
            for (key, _) in layout.iter().filter(|(key, _)| key.starts_with("polar")) {
                let headings = layout["annotations"].as_array().into_iter().flatten();
                let heading = |a: &Value| a["text"].as_str().is_some_and(|t| t.ends_with(")</b>"));
                let own = headings.filter(|a| a["name"] == **key).any(heading);
                assert!(own, "{name}, {id}, {key}");
                titled += 1;
            }
            assert!(titled >= 1, "{name}, {id}");
        }
        for figure in page.split("<figure ").skip(1) {
            let figure = figure.split("</figure>").next().unwrap_or_default();
            let caption = figure
                .split("class=\"caption\"><b>")
                .nth(1)
                .expect("a caption");
            assert!(caption.len() > 20, "{name}");
            if figure.contains("data-save") {
                assert!(
                    figure.contains("data-save=\"svg\"") && figure.contains("data-save=\"png\"")
                );
            }
        }
    }
}

/// A provenance stands below the first figure of several that share it.
#[test]
fn a_provenance_is_not_repeated() {
    for (name, page) in pages() {
        let lines: Vec<&str> = (page.split("class=\"provenance\">").skip(1))
            .filter_map(|part| part.split("</div>").next())
            .collect();
        assert!(!lines.is_empty(), "{name}");
        assert!(
            lines.windows(2).all(|pair| pair[0] != pair[1]),
            "{name}: {lines:?}"
        );
    }
}

#[test]
fn text_is_escaped() {
    let mut run = crate::synthetic::run_data();
    run.title = "<img src=x onerror=alert(1)>".into();
    run.provenance.case = "a </script><b>case</b>".into();
    run.energy[0].name = "<b>work</b>".into();
    run.motion
        .iter_mut()
        .for_each(|m| m.title = "</svg><u>".into());
    let page = run_page(&run);
    let (html, _) = split(&page);
    for raw in ["<img", "<b>case", "<u>", "<synthetic>", "<angle"] {
        assert!(!html.contains(raw), "{raw}");
    }
    assert!(html.contains("&lt;img src=x onerror=alert(1)&gt;"));
    let (_, energy) = specs(&page)
        .into_iter()
        .find(|(id, _)| id == "energy-balance")
        .expect("an energy balance");
    let name = energy["data"][0]["y"][0].as_str().expect("a name");
    assert!(name.starts_with("&lt;b&gt;work&lt;/b&gt;<br>"), "{name}");
}

#[test]
fn what_is_not_a_number_is_null_and_numbers_survive() {
    let mut data = crate::synthetic::reproduce();
    data.gap_histories[0].gap_deg[3] = f64::NAN;
    data.gap_histories[0].turn_gap_deg[4] = f64::INFINITY;
    data.motions[0].angle_deg[0][0] = f64::NAN;
    specs(&reproduce_page(&data));
    let json = to_json(&data).expect("data of plain numbers");
    let value: Value = serde_json::from_str(&json).expect("valid JSON");
    assert!(value["gap_histories"][0]["gap_deg"][3].is_null());
    assert!(value["table2"]["rows"][2]["critical_gap_deg"][3].is_null());
    let theory = data.table2.as_ref().expect("a table").rows[0].theory_deg;
    // The reader of serde_json may be off in the last digit; the text is exact, see below.
    let read = value["table2"]["rows"][0]["theory_deg"]
        .as_f64()
        .expect("a number");
    assert!((read - theory).abs() < 1e-15, "{read} {theory}");
    assert_eq!(value["claims"][3]["verdict"], "erratum");
    let criterion = &value["claims"][2]["criterion"];
    assert_eq!(criterion[1]["value"], 0.074);
    assert_eq!(criterion[1]["limit"], "at most 0.02°");
    let holds = [&criterion[0]["holds"], &criterion[1]["holds"]];
    assert_eq!(holds, ["met", "missed"]);

    let awkward = [
        0.1 + 0.2,
        1.0 / 3.0,
        5e-324,
        1.797e308,
        -2.5e-7,
        123_456_789.123_456_79,
    ];
    let text = to_json(&awkward).expect("numbers");
    let back: Vec<f64> = text
        .trim_matches(['[', ']'])
        .split(',')
        .filter_map(|t| t.parse().ok())
        .collect();
    assert_eq!(back, awkward);
}

#[test]
fn data_that_are_missing_or_too_short_leave_a_page() {
    for page in [
        reproduce_page(&ReproduceData::default()),
        run_page(&RunData::default()),
        design_page(&DesignData::default()),
        design_page(&DesignData {
            search: Some(cageless_results::Record::default()),
            ..DesignData::default()
        }),
    ] {
        assert!(page.contains("</html>"));
    }
    let mut run = crate::synthetic::run_data();
    run.time_s.truncate(10);
    run.balls[0].vx_m_s.truncate(3);
    run.balls[1].gap_deg.clear();
    run.ring.y_um.truncate(1);
    run.settled_after_s = 1e9;
    if let Some(motion) = &mut run.motion {
        motion.angle_deg[2].truncate(5);
    }
    specs(&run_page(&run));
    let empty = ReproduceData {
        gap_histories: vec![GapHistory::default()],
        neighbours: vec![Neighbours::default()],
        phase_portraits: vec![PhasePortraits::default()],
        orbit_speeds: vec![OrbitSpeeds::default()],
        vibrations: vec![Vibration::default()],
        ring_comparison: Some(RingComparison::default()),
        motions: vec![Motion::default()],
        table2: Some(Table2::default()),
        design_curve: Some(DesignCurve::default()),
        surface: Some(RacewaySurface::default()),
        contact_track: Some(ContactTrack::default()),
        ..ReproduceData::default()
    };
    specs(&reproduce_page(&empty));
}

#[test]
fn the_raceway_surface_carries_the_contact_track() {
    let bearing = crate::synthetic::bearing();
    let surface = RacewaySurface::sample(
        &crate::synthetic::raceway(3),
        &bearing,
        crate::synthetic::structure(3),
    );
    for point in surface.track_mm.iter().skip(24).step_by(24).take(8) {
        let nearest = (0..surface.x_mm.len())
            .flat_map(|k| (0..surface.x_mm[k].len()).map(move |m| (k, m)))
            .map(|(k, m)| {
                let apart = [
                    surface.x_mm[k][m] - point[0],
                    surface.y_mm[k][m] - point[1],
                    surface.z_mm[k][m] - point[2],
                ];
                apart.iter().map(|d| d * d).sum::<f64>().sqrt()
            })
            .fold(f64::INFINITY, f64::min);
        // Within half the spacing of the grid.
        assert!(nearest < 0.15, "{point:?} is {nearest} mm from the surface");
    }
    let track = ContactTrack::sample(
        &crate::synthetic::raceway(3),
        &bearing,
        crate::synthetic::structure(3),
    );
    let widest = track.axial_mm.iter().copied().fold(0.0, f64::max);
    assert!((2.0 * widest - 5.1).abs() < 1e-9, "{widest}");
}

/// A long run says how fine its histories and spectra are, and from when on paths are shown.
#[test]
fn a_thinned_run_says_so() {
    let mut data = crate::synthetic::run_data();
    let plain = run_page(&data);
    assert!(!plain.contains("lowest and highest value"));
    data.stretch_s = Some(0.0128);
    data.recent = Some(Recent {
        time_s: vec![99.5, 99.6],
        balls: vec![data.balls[0].clone()],
    });
    data.collisions_total = 123_456;
    let signal = &mut data.vibration.as_mut().unwrap().signals[0];
    signal.stretch_s = Some(0.0256);
    signal.averages = 121;
    signal.resolution_hz = Some(0.5);
    let page = run_page(&data);
    for text in [
        "Every 12.8 ms of the run are shown by their lowest and highest value.",
        "y against x, after t = 99.5 s",
        "all turns after t = 99.5 s",
        "123456 contacts between balls",
        "every 25.6 ms are shown",
        "a value every 0.5 Hz",
        "over 121 stretches of 2 s",
    ] {
        assert!(page.contains(text), "{text}");
    }
}

#[test]
fn the_label_of_what_is_discarded_begins_in_its_shade() {
    let mut data = crate::synthetic::run_data();
    // So short a transient that a centred label would lie across the axis.
    data.settled_after_s = data.time_s[0] + 1e-3;
    let begin = data.time_s[0];
    let mut labels = 0;
    for (id, spec) in specs(&run_page(&data)) {
        let annotations = spec["layout"]["annotations"].as_array().expect("a list");
        for label in annotations.iter().filter(|a| a["text"] == "discarded") {
            assert_eq!(label["x"].as_f64(), Some(begin), "{id}");
            assert_eq!(label["xanchor"], "left", "{id}");
            labels += 1;
        }
    }
    assert!(labels >= 2, "{labels}");
}

/// Every verdict of a page says whether it passes, in words and in colour, and a page with two
/// critical gaps of one raceway says why.
#[test]
fn pages_say_what_passes() {
    let page = design_page(&crate::synthetic::design());
    for said in [
        "<p class=\"judged pass\" role=\"status\">✔ works: smooth</p>",
        "neighbours of the pair 40 % further off",
    ] {
        assert!(page.contains(said), "{said}");
    }
    assert!(
        run_page(&crate::synthetic::run_data())
            .contains("✘ does not work in this run: double collision")
    );
}

/// What stands between the header and the contents.
fn opening(body: &str) -> &str {
    body.split("<nav").next().expect("a beginning")
}

/// The verdict and the key numbers come first, then the pictures, which stand nowhere else.
#[test]
fn the_result_is_on_top() {
    let (html, _) = split(&run_page(&crate::synthetic::run_data()));
    let (header, body) = html.split_once("</header>").expect("a header");
    for id in ["motion", "gaps-of-all-pairs"] {
        let figure = format!("<figure id=\"{id}\"");
        assert!(
            opening(body).contains(&figure) && body.matches(&figure).count() == 1,
            "{id}"
        );
    }
    assert!(header.contains("class=\"head fail\"") && header.contains("✘ does not work"));
    assert!(header.contains("<dt>Peak pressure</dt><dd>2100 <span class=\"unit\">MPa</span></dd>"));
    let data = DesignData {
        shown: Some(ShownRaceway {
            name: "recommended raceway".into(),
            passes: Some(true),
            headline: "works: smooth".into(),
            toml: "[raceway]\naxial_span_mm = 5.1\n".into(),
            contact_track: crate::synthetic::design().contact_track.expect("a track"),
            surface: crate::synthetic::design().surface.expect("a surface"),
            ..ShownRaceway::default()
        }),
        passes: Some(false),
        headline: "does not work: slides".into(),
        ..crate::synthetic::design()
    };
    let (html, _) = split(&design_page(&data));
    let (header, body) = html.split_once("</header>").expect("a header");
    assert!(opening(body).contains("id=\"design-map-verdicts"));
    let recommended = header
        .find("Recommended raceway: works")
        .expect("a verdict");
    let own = header
        .find("Initial design: does not work")
        .expect("a verdict");
    // Not green: a raceway that works need not help.
    let open = header.find("Benefit not judged").expect("a remark");
    assert!(open < recommended && recommended < own);
    assert!(header.contains("class=\"head unjudged\""));
    assert!(body.contains("[raceway]\naxial_span_mm = 5.1\n</pre>"));
    // The initial design has its figures, under names of their own.
    assert!(
        body.contains("id=\"contact-track\"")
            && body.contains("id=\"contact-track-initial-design\"")
    );
}

/// Every figure says its ranges in words, and every hovered point what it is.
#[test]
fn figures_have_descriptions_and_hovered_points_names() {
    let page = run_page(&crate::synthetic::run_data());
    let (html, _) = split(&page);
    let labels = attributes(&html, "aria-label");
    let gaps = labels
        .iter()
        .find(|l| l.starts_with("Gaps. "))
        .expect("a description");
    assert!(
        gaps.contains("The smallest gap is") && gaps.contains("over Time t (s) from"),
        "{gaps}"
    );
    let names: Vec<_> = labels.iter().filter(|l| l.starts_with("Save ")).collect();
    let different: HashSet<_> = names.iter().collect();
    assert_eq!(names.len(), different.len());
    for (id, spec) in specs(&page) {
        for trace in spec["data"].as_array().expect("traces") {
            if trace["type"] == "scatter" && trace["hoverinfo"] != "skip" {
                let said = trace["hovertemplate"].as_str().unwrap_or_default();
                assert!(said.contains("%{"), "{id}: {said}");
            }
        }
    }
}
