//! The number of a bearing in texts.

/// Number of bearing `k`, counted from 0, of `count` in texts; `None` of an only one.
pub fn bearing_number(k: usize, count: usize) -> Option<usize> {
    (count > 1).then_some(k + 1)
}

/// A text on bearing `k`, counted from 0, of `count`: "bearing 2: text" of several.
pub fn on_bearing(k: usize, count: usize, text: &str) -> String {
    match bearing_number(k, count) {
        None => text.to_owned(),
        Some(number) => format!("bearing {number}: {text}"),
    }
}
