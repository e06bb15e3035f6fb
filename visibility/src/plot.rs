//! Curves as SVG: self-contained, and readable on a light and on a dark page.
//!
//! An axis whose values span a factor of 16 or more is logarithmic. Numbers are written with two decimals, so that the
//! same curves are the same file on every host.

use std::fmt::Write;
use std::path::Path;

use crate::error::Result;
use crate::output;

const WIDTH: f64 = 720.0;
const HEIGHT: f64 = 400.0;
/// Left, top, right and bottom: axes and names.
const MARGINS: [f64; 4] = [70.0, 48.0, 190.0, 50.0];
/// Values that span this factor are drawn by their logarithms.
const DECADE: f64 = 16.0;
/// Colours that are told apart without red and green, one curve after the other.
const COLOURS: [&str; 8] = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#7f7f7f", "#8c6d31"];

/// A named curve; its points ascend along x.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// Its name, beside its last point.
    pub name: String,
    /// x and y, both above 0.
    pub points: Vec<[f64; 2]>,
}

/// Curves over one axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Plot {
    /// What it shows.
    pub title: String,
    /// What x and y are, with their units.
    pub axes: [String; 2],
    /// The curves.
    pub curves: Vec<Curve>,
}

/// From values to places.
struct Scale {
    low: f64,
    high: f64,
    is_log: bool,
    from: f64,
    to: f64,
}

impl Scale {
    fn new(values: impl Iterator<Item = f64> + Clone, from: f64, to: f64) -> Self {
        let (low, high) = (values.clone().fold(f64::INFINITY, f64::min), values.fold(f64::NEG_INFINITY, f64::max));
        let is_log = low > 0.0 && high / low >= DECADE;
        if is_log { Scale { low, high, is_log, from, to } } else { Scale { low: low.min(0.0), high, is_log, from, to } }
    }

    fn place(&self, value: f64) -> f64 {
        let along = |x: f64| if self.is_log { libm::log(x) } else { x };
        let size = along(self.high) - along(self.low);
        let part = if size > 0.0 { (along(value) - along(self.low)) / size } else { 0.5 };
        self.from + (self.to - self.from) * part
    }

    /// Round values within it.
    fn ticks(&self) -> Vec<f64> {
        let decade = |exponent: i32| libm::pow(10.0, f64::from(exponent));
        if self.is_log {
            let range = self.low * 0.999..=self.high * 1.001;
            let inside = |digits: &[f64]| -> Vec<f64> {
                let all = (-12..=18).flat_map(|exponent| digits.iter().map(move |digit| digit * decade(exponent)));
                all.filter(|x| range.contains(x)).collect()
            };
            let many = inside(&[1.0, 2.0, 5.0]);
            return if many.len() <= 8 { many } else { inside(&[1.0]) };
        }
        let rough = (self.high - self.low) / 5.0;
        let steps = (-12..=18).flat_map(|exponent| [1.0, 2.0, 5.0].map(|digit| digit * decade(exponent)));
        let step = steps.into_iter().find(|step| *step >= rough).unwrap_or(1.0);
        (0..=10).map(|i| f64::from(i) * step).filter(|x| *x <= self.high * 1.001).collect()
    }
}

/// A number as a reader would write it.
fn number(value: f64) -> String {
    for (unit, name) in [(1e9, " G"), (1e6, " M"), (1e3, " k")] {
        if value >= unit {
            return format!("{}{name}", short(value / unit));
        }
    }
    short(value)
}

fn short(value: f64) -> String {
    format!("{value:.3}").trim_end_matches('0').trim_end_matches('.').to_owned()
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

impl Plot {
    /// The picture as text.
    pub fn svg(&self) -> String {
        let points = || self.curves.iter().flat_map(|curve| curve.points.iter());
        let [left, top, right, bottom] = MARGINS;
        let x = Scale::new(points().map(|p| p[0]), left, WIDTH - right);
        let y = Scale::new(points().map(|p| p[1]), HEIGHT - bottom, top);
        let mut out = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {HEIGHT}\" font-family=\"sans-serif\" \
             font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n"
        );
        let text = |out: &mut String, at: [f64; 2], anchor: &str, what: &str| {
            let _ = writeln!(
                out,
                "<text x=\"{:.2}\" y=\"{:.2}\" text-anchor=\"{anchor}\" fill=\"#222222\">{}</text>",
                at[0],
                at[1],
                escaped(what)
            );
        };
        text(&mut out, [left, top - 24.0], "start", &self.title);
        text(&mut out, [(left + WIDTH - right) / 2.0, HEIGHT - 12.0], "middle", &self.axes[0]);
        text(&mut out, [left, top - 7.0], "start", &self.axes[1]);
        for tick in x.ticks() {
            line(&mut out, [[x.place(tick), HEIGHT - bottom], [x.place(tick), top]]);
            text(&mut out, [x.place(tick), HEIGHT - bottom + 16.0], "middle", &number(tick));
        }
        for tick in y.ticks() {
            line(&mut out, [[left, y.place(tick)], [WIDTH - right, y.place(tick)]]);
            text(&mut out, [left - 6.0, y.place(tick) + 4.0], "end", &number(tick));
        }
        for (curve, place) in self.curves.iter().zip(self.names(&y)) {
            let colour = COLOURS[place.0 % COLOURS.len()];
            let _ = write!(out, "<polyline fill=\"none\" stroke=\"{colour}\" stroke-width=\"2\" points=\"");
            curve.points.iter().for_each(|p| {
                let _ = write!(out, "{:.2},{:.2} ", x.place(p[0]), y.place(p[1]));
            });
            out.push_str("\"/>\n");
            for p in &curve.points {
                let at = [x.place(p[0]), y.place(p[1])];
                let _ = writeln!(out, "<circle cx=\"{:.2}\" cy=\"{:.2}\" r=\"3\" fill=\"{colour}\"/>", at[0], at[1]);
            }
            let at = [WIDTH - right + 10.0, place.1];
            let _ = writeln!(
                out,
                "<rect x=\"{:.2}\" y=\"{:.2}\" width=\"10\" height=\"10\" fill=\"{colour}\"/>",
                at[0],
                at[1] - 9.0
            );
            text(&mut out, [at[0] + 15.0, at[1]], "start", &curve.name);
        }
        out.push_str("</svg>\n");
        out
    }

    /// For each curve its number and where its name stands: beside its end, and none on another.
    fn names(&self, y: &Scale) -> Vec<(usize, f64)> {
        let end = |curve: &Curve| curve.points.last().map_or(y.from, |p| y.place(p[1]) + 4.0);
        let mut ends: Vec<(usize, f64)> = self.curves.iter().map(end).enumerate().collect();
        ends.sort_by(|a, b| a.1.total_cmp(&b.1));
        let mut above = f64::NEG_INFINITY;
        for (_, at) in &mut ends {
            *at = at.max(above + 15.0);
            above = *at;
        }
        ends.sort_by_key(|(number, _)| *number);
        ends
    }

    /// Writes it.
    ///
    /// # Errors
    ///
    /// A file that cannot be written; then nothing of it is left.
    pub fn write(&self, path: &Path) -> Result<()> {
        output::write(path, |out| out.write_all(self.svg().as_bytes()))
    }
}

fn line(out: &mut String, [a, b]: [[f64; 2]; 2]) {
    let _ = writeln!(
        out,
        "<path d=\"M{:.2} {:.2}L{:.2} {:.2}\" stroke=\"#dddddd\" fill=\"none\"/>",
        a[0], a[1], b[0], b[1]
    );
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn curves_stand_between_their_axes_and_names_beside_each_other() {
        let curve = |name: &str, y: f64| Curve { name: name.to_owned(), points: vec![[32.0, y], [1024.0, 2.0 * y]] };
        let curves = vec![curve("a & b", 10.0), curve("c", 10.1), curve("d", 4000.0)];
        let plot = Plot { title: "t".to_owned(), axes: ["x".to_owned(), "y".to_owned()], curves };
        let svg = plot.svg();
        assert_eq!((svg.matches("<polyline").count(), svg.matches("<circle").count()), (3, 6));
        assert!(svg.contains("a &amp; b") && svg.contains("points=\"70.00,350.00 530.00,"), "{svg}");
        assert!(svg.contains(">100</text>") && svg.contains(">1 k</text>"), "{svg}");
        let names = plot.names(&Scale::new([10.0, 8000.0].into_iter(), 350.0, 40.0));
        assert!((names[0].1 - names[1].1).abs() >= 15.0, "{names:?}");
        assert_eq!([0.25, 20.0, 9_064_000.0].map(number), ["0.25", "20", "9.064 M"]);
    }
}
