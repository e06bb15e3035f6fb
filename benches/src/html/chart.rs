//! Bars on a logarithmic scale that begin at 1 and go left or right.

use std::fmt::Write;

use super::escape;

/// One bar.
pub(super) struct Bar {
    /// Bars of a group stand together under its name.
    pub group: String,
    /// What is measured.
    pub label: String,
    /// SIMD level.
    pub level: String,
    /// Positive.
    pub value: f64,
    /// Stands behind the value.
    pub detail: String,
    /// A change, and whether it is for the better.
    pub note: Option<(String, bool)>,
}

/// A titled chart; nothing is drawn of one without bars.
pub(super) struct Chart<'a> {
    /// HTML.
    pub title: &'a str,
    /// HTML.
    pub caption: &'a str,
    /// Whether bars to the left are the good ones.
    pub less_is_better: bool,
    pub bars: Vec<Bar>,
}

/// Units of the picture: columns, and the height of a bar's row and of a group's name.
const LEFT: f64 = 190.0;
const PLOT: f64 = 520.0;
const WIDTH: f64 = 940.0;
const TOP: f64 = 26.0;
const ROW: f64 = 19.0;
const NAME: f64 = 26.0;

impl Chart<'_> {
    pub(super) fn render(&self, page: &mut String) {
        if self.bars.is_empty() {
            return;
        }
        let scale = Scale::of(&self.bars);
        let several = self.bars.iter().any(|bar| bar.level != self.bars[0].level);
        let mut body = String::new();
        let (mut y, mut group) = (TOP, "");
        for bar in &self.bars {
            if bar.group != group {
                group = &bar.group;
                y += NAME;
                let _ = writeln!(body, "<text class=\"group\" x=\"0\" y=\"{:.1}\">{}</text>", y - 8.0, escape(group));
            }
            self.bar(bar, scale, several, y, &mut body);
            y += ROW;
        }
        let _ = writeln!(page, "<section class=\"chart\">\n<h2>{}</h2>\n<p>{}</p>", self.title, self.caption);
        let height = y + 6.0;
        let _ = writeln!(page, "<svg viewBox=\"0 0 {WIDTH} {height}\" role=\"img\" aria-label=\"{}\">", self.title);
        for exponent in scale.low..=scale.high {
            let value = libm::exp2(f64::from(exponent));
            let (x, class) = (scale.x(value), if exponent == 0 { "one" } else { "grid" });
            let _ = writeln!(body, "<text class=\"tick\" x=\"{x:.1}\" y=\"16\">{}</text>", tick(value));
            let _ = writeln!(page, "<line class=\"{class}\" x1=\"{x:.1}\" y1=\"{TOP}\" x2=\"{x:.1}\" y2=\"{y:.1}\"/>");
        }
        page.push_str(&body);
        page.push_str("</svg>\n</section>\n");
    }

    fn bar(&self, bar: &Bar, scale: Scale, several: bool, y: f64, body: &mut String) {
        let (from, to) = (scale.x(1.0), scale.x(bar.value));
        let tone = if (bar.value < 1.0) == self.less_is_better { "better" } else { "worse" };
        let label = if several { format!("{} \u{b7} {}", bar.label, bar.level) } else { bar.label.clone() };
        let base = y + 13.0;
        let _ = writeln!(
            body,
            "<text class=\"label\" x=\"{:.1}\" y=\"{base:.1}\">{}</text>\
             <rect class=\"bar {tone}\" x=\"{:.1}\" y=\"{:.1}\" width=\"{:.1}\" height=\"{:.1}\" rx=\"2\"/>\
             <text class=\"value\" x=\"{:.1}\" y=\"{base:.1}\">{:.2}</text>",
            LEFT - 10.0,
            escape(&label),
            from.min(to),
            y + 3.0,
            (to - from).abs().max(1.0),
            ROW - 6.0,
            LEFT + PLOT + 52.0,
            bar.value
        );
        let _ = write!(
            body,
            "<text class=\"detail\" x=\"{:.1}\" y=\"{base:.1}\">{}</text>",
            LEFT + PLOT + 140.0,
            escape(&bar.detail)
        );
        if let Some((note, good)) = &bar.note {
            let tone = if *good { "better" } else { "worse" };
            let _ = write!(body, "<text class=\"note {tone}\" x=\"{WIDTH}\" y=\"{base:.1}\">{}</text>", escape(note));
        }
        body.push('\n');
    }
}

/// Powers of two at both ends.
#[derive(Clone, Copy)]
struct Scale {
    low: i32,
    high: i32,
}

impl Scale {
    /// Holds 1, a step beside it, and every bar.
    fn of(bars: &[Bar]) -> Self {
        let exponents = bars.iter().map(|bar| libm::log2(bar.value));
        let (low, high) = exponents.fold((-1.0_f64, 1.0_f64), |(low, high), e| (low.min(e), high.max(e)));
        Scale { low: low.floor() as i32, high: high.ceil() as i32 }
    }

    fn x(self, value: f64) -> f64 {
        let share = (libm::log2(value) - f64::from(self.low)) / f64::from(self.high - self.low);
        LEFT + PLOT * share
    }
}

fn tick(value: f64) -> String {
    if value >= 1.0 { format!("{value}") } else { format!("1/{}", 1.0 / value) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bar(value: f64) -> Bar {
        let text = String::new;
        Bar { group: text(), label: text(), level: text(), value, detail: text(), note: None }
    }

    #[test]
    fn the_scale_holds_every_bar_and_one() {
        let scale = Scale::of(&[bar(0.2), bar(3.0)]);
        assert_eq!((scale.low, scale.high), (-3, 2));
        assert_eq!((scale.x(0.125), scale.x(4.0)), (LEFT, LEFT + PLOT));
        assert_eq!((tick(0.25), tick(4.0)), ("1/4".to_owned(), "4".to_owned()));
    }

    #[test]
    fn a_chart_without_bars_is_nothing() {
        let mut page = String::new();
        Chart { title: "x", caption: "y", less_is_better: true, bars: Vec::new() }.render(&mut page);
        assert_eq!(page, "");
    }
}
