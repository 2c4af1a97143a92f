//! What every page must be: self-contained, valid, labelled.

use std::collections::HashSet;

use cageless_report::*;
use serde_json::Value;

fn pages() -> [(&'static str, String); 3] {
    [
        ("design", design_page(&crate::synthetic::design())),
        ("reproduce", reproduce_page(&crate::synthetic::reproduce())),
        ("run", run_page(&crate::synthetic::run_data())),
    ]
}

/// The page without the contents of its scripts, and those contents.
fn split(page: &str) -> (String, Vec<String>) {
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
fn specs(page: &str) -> Vec<(String, Value)> {
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
        let (html, scripts) = split(&page);
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
        let (html, _) = split(&page);
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
        let specs = specs(&page);
        let least = if name == "design" { 6 } else { 8 };
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
            for (_, polar) in layout.iter().filter(|(key, _)| key.starts_with("polar")) {
                let title = polar["radialaxis"]["title"]["text"].as_str();
                titled += usize::from(title.is_some_and(|t| t.ends_with(')')));
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
                    figure.contains("class=\"provenance\""),
                    "{name}: {}",
                    &caption[..40]
                );
                assert!(
                    figure.contains("data-save=\"svg\"") && figure.contains("data-save=\"png\"")
                );
            }
        }
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
fn rings_are_compared_with_error_bars() {
    let page = reproduce_page(&crate::synthetic::reproduce());
    let (html, _) = split(&page);
    assert!(html.contains("120.0 ± 6.9"), "a mean with its error");
    assert!(html.contains("Left out by the model: tilt."));
    let specs = specs(&page);
    let (_, spec) = specs
        .iter()
        .find(|(id, _)| id == "rings-compared")
        .expect("a figure");
    for trace in spec["data"].as_array().expect("traces") {
        assert_eq!(trace["type"], "bar");
        let (bars, errors) = (&trace["y"], &trace["error_y"]["array"]);
        assert_eq!(
            bars.as_array().map(Vec::len),
            errors.as_array().map(Vec::len)
        );
        assert!(errors[0].as_f64().expect("an error") > 0.0);
    }
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
            search: Some(SearchData::default()),
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

/// Every status with the requirements that decide it, and the sentences that follow.
#[test]
fn claims_are_shown_with_their_criteria() {
    let data = crate::synthetic::reproduce();
    let status: Vec<ClaimStatus> = data.claims.iter().map(Claim::status).collect();
    let expected = [
        ClaimStatus::Confirmed,
        ClaimStatus::NotConfirmed,
        ClaimStatus::Partly,
        ClaimStatus::Erratum,
        ClaimStatus::NotTested,
    ];
    assert_eq!(status, expected);
    assert_eq!(
        data.claims[2].finding,
        "The computation finds it, in a sentence that states how far. The computation does not \
         find it."
    );
    assert_eq!(data.claims[4].finding, "");
    let page = reproduce_page(&data);
    assert!(page.contains("Each status follows from the requirements listed with it"));
    for (mark, value, count) in [("met\">✓", "0.0074°", 2), ("missed\">✗", "0.074°", 2)] {
        let line = format!(
            "aria-label=\"{mark}</span> critical gap of <code>paper</code> less 1.8190°: \
             <b>{value}</b> (at most 0.02°)</li>"
        );
        assert_eq!(page.matches(&line).count(), count, "{line}");
    }
}

#[test]
fn code_between_backticks_is_set_as_code() {
    let mut data = crate::synthetic::reproduce();
    data.claims[0].numbers = "0.031° in `paper`, 0.034° in `physical`".into();
    data.claims[0].finding = "found in `paper`".into();
    let (html, _) = split(&reproduce_page(&data));
    assert!(html.contains("0.031° in <code>paper</code>, 0.034° in <code>physical</code>"));
    assert!(!html.contains('`'));
}

/// A remark per row would be a column that is empty but for one cell, and the table wider than
/// the page.
#[test]
fn remarks_of_table_2_stand_in_its_caption() {
    let mut data = crate::synthetic::reproduce();
    let table = data.table2.as_mut().expect("a table");
    table.rows.iter_mut().for_each(|row| row.remark.clear());
    table.rows[4].remark = "repeats the value of 5.40 mm".into();
    let span = format!("{:.2}", table.rows[4].structure.axial_span_mm);
    let (html, _) = split(&reproduce_page(&data));
    let (_, table) = html.split_once("id=\"table-2\"").expect("Table 2");
    let (caption, rows) = table.split_once("<tbody>").expect("rows");
    let said = format!("Marked: <i>l</i><sub>C</sub> {span} mm repeats the value of 5.40 mm.");
    assert!(caption.contains(&said), "{caption}");
    assert!(!caption.contains("Remark"));
    let (rows, _) = rows.split_once("</tbody>").expect("an end");
    assert!(!rows.contains("repeats") && rows.contains("class=\"marked\""));
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

/// The figure of a design page whose anchor begins with `id`.
fn search_figure(search: SearchData, id: &str) -> Value {
    let data = DesignData {
        search: Some(search),
        ..crate::synthetic::design()
    };
    let found = specs(&design_page(&data));
    let (_, spec) = (found.into_iter())
        .find(|(name, _)| name.starts_with(id))
        .unwrap_or_else(|| panic!("{id} is missing"));
    spec
}

fn synthetic_search() -> SearchData {
    crate::synthetic::design().search.expect("a search")
}

#[test]
fn axes_of_trade_offs_show_what_is_acceptable() {
    let mut search = synthetic_search();
    // The raceway of the case, hit far more often than any that is acceptable.
    let mut own = search.band[0].clone();
    own.status = "rejected".into();
    for point in &mut own.points {
        if let Some(motion) = &mut point.motion {
            motion.collisions_late = 36.0;
            motion.spacing_scatter = 5.0;
        }
    }
    search.own_from_usual_starts = Some(own);
    let spec = search_figure(search, "trade-offs");
    let range = |axis: &str| {
        let range = &spec["layout"][axis]["range"];
        [0, 1].map(|k| range[k].as_f64().expect("a range"))
    };
    let (x, y) = (range("xaxis"), range("yaxis"));
    assert!(y[1] < 36.0 && x[1] < 500.0, "{x:?} {y:?}");
    for trace in spec["data"].as_array().expect("traces") {
        if trace["xaxis"] != "x" || trace["yaxis"] != "y" {
            continue;
        }
        let at = |axis: &str| trace[axis][0].as_f64().expect("a number");
        assert!((x[0]..=x[1]).contains(&at("x")) && (y[0]..=y[1]).contains(&at("y")));
        if trace["name"] == "initial design" {
            // At the edge, with its values.
            assert_eq!([at("x"), at("y")], [x[1], y[1]]);
            assert_eq!(trace["text"][0], "500, 36");
        }
    }
}

#[test]
fn the_recommended_raceway_lies_on_its_own_verdict() {
    let mut search = synthetic_search();
    for map in &mut search.maps {
        let cells = map.verdict.iter_mut().flatten();
        cells.for_each(|verdict| *verdict = "insufficient-separation".to_owned());
    }
    search.band[1].status = "rejected".into();
    search.band[1].reason = Some("slips".into());
    let best = search.band[0].clone();
    let spec = search_figure(search, "design-map-verdicts");
    let traces = spec["data"].as_array().expect("traces");
    let tried: Vec<_> = (traces.iter())
        .filter(|t| t["name"] == "structures tried")
        .collect();
    assert_eq!(tried.len(), 1, "at the speed that is asked for");
    let (colours, x) = (&tried[0]["marker"]["color"], &tried[0]["x"]);
    assert!((x[0].as_f64().expect("a place") - best.axial_span_mm).abs() < 1e-3);
    assert_eq!(
        (&colours[0], &colours[1]),
        (&"#009e73".into(), &"#d55e00".into())
    );
    assert!(traces.iter().any(|t| t["name"] == "works"), "the legend");
}

/// Every verdict of a page says whether it passes, in words and in colour, and a page with two
/// critical gaps of one raceway says why.
#[test]
fn pages_say_what_passes() {
    let page = design_page(&crate::synthetic::design());
    for said in [
        "<p class=\"judged pass\" role=\"status\">✔ PASS: smooth</p>",
        "Without the search: nothing recommended; starting point, which fails",
        "neighbours of the pair 40 % further off",
    ] {
        assert!(page.contains(said), "{said}");
    }
    assert!(
        run_page(&crate::synthetic::run_data()).contains("✘ FAIL in this run: hit from both sides")
    );
}

/// The verdict and the key numbers come before everything else.
#[test]
fn the_result_is_on_top() {
    let (html, _) = split(&run_page(&crate::synthetic::run_data()));
    let (header, _) = html.split_once("</header>").expect("a header");
    assert!(header.contains("class=\"head fail\"") && header.contains("✘ FAIL"));
    assert!(header.contains("<dt>Peak pressure</dt><dd>2.1 <span class=\"unit\">GPa</span></dd>"));
    let data = DesignData {
        shown: Some(ShownRaceway {
            name: "recommended raceway".into(),
            passes: Some(true),
            headline: "PASS: smooth".into(),
            toml: "[raceway]\naxial_span_mm = 5.1\n".into(),
            contact_track: crate::synthetic::design().contact_track.expect("a track"),
            surface: crate::synthetic::design().surface.expect("a surface"),
            ..ShownRaceway::default()
        }),
        passes: Some(false),
        headline: "FAIL: slips".into(),
        ..crate::synthetic::design()
    };
    let (html, _) = split(&design_page(&data));
    let (header, body) = html.split_once("</header>").expect("a header");
    let recommended = header.find("Recommended raceway: PASS").expect("a verdict");
    let own = header.find("Initial design: FAIL").expect("a verdict");
    assert!(recommended < own && header.contains("class=\"head pass\""));
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

fn swept() -> SweepData {
    let quantity = |name: &str, unit: &str| SweepQuantity {
        name: name.into(),
        unit: unit.into(),
    };
    let output = |name: &str| SweepOutput {
        quantity: quantity(name, ""),
        shares: vec![Some(0.7), Some(0.2)],
        effects: vec![
            MainEffect {
                input: quantity("operation_radial_load_n", "N"),
                levels: Levels::Numbers(vec![500.0, 1500.0]),
                mean: vec![0.2, 0.8],
                min: vec![0.0, 0.5],
                max: vec![0.5, 1.0],
            },
            MainEffect {
                input: quantity("raceway_axial_span_mm", "mm"),
                levels: Levels::Numbers(vec![5.0, 5.1]),
                mean: vec![0.4, 0.6],
                min: vec![0.0, 0.5],
                max: vec![0.5, 1.0],
            },
        ],
        ..SweepOutput::default()
    };
    let names = [
        "verdict_passes",
        "run_collisions",
        "run_gap_min_deg",
        "run_slip_max_m_s",
        "run_steps",
    ];
    SweepData {
        variants: 40,
        passed: Some([30, 40]),
        inputs: vec![
            quantity("operation_radial_load_n", "N"),
            quantity("raceway_axial_span_mm", "mm"),
        ],
        outputs: names.map(output).to_vec(),
        chosen: 4,
        ..SweepData::default()
    }
}

/// A sweep shows what was asked for, choices before conditions, and folds the rest away.
#[test]
fn a_sweep_shows_its_choice_first() {
    let page = sweep_page(&swept());
    let (html, _) = split(&page);
    assert!(html.contains("30 of 40 variants pass (75 %)"));
    let folded = html.find("<details>").expect("a fold");
    let place = |id: &str| html.find(&format!("id=\"{id}\"")).expect("a figure");
    assert!(place("effects-on-passes") < folded && place("effects-on-smallest-gap") < folded);
    assert!(
        place("effects-on-largest-sliding-speed-under-load") > folded
            && place("effects-on-steps") > folded
    );
    let specs = specs(&page);
    let spec = |id: &str| {
        &specs
            .iter()
            .find(|(name, _)| name == id)
            .expect("a figure")
            .1
    };
    let sensitivity = spec("sensitivity-main-effects");
    assert_eq!(sensitivity["data"][0]["x"][1], "radial load");
    // What only the computation is about is no finding.
    let rows = sensitivity["data"][0]["y"].as_array().expect("outputs");
    assert_eq!(rows.len(), 4);
    assert!(!rows.iter().any(|row| row == "steps"));
    let title = &spec("effects-on-passes")["layout"]["xaxis"]["title"]["text"];
    assert_eq!(title, "Axial span <i>l</i><sub>C</sub> (mm)");
}
