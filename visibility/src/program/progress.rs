//! Progress of long work, on standard error, for people: only on a terminal, and not where `CI` is set.

use std::io::IsTerminal;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

const STEPS: u64 = 1000;

/// A bar that vanishes when it is dropped.
pub(crate) struct Progress(ProgressBar);

impl Progress {
    pub(crate) fn new(what: String) -> Self {
        let people = std::io::stderr().is_terminal() && std::env::var_os("CI").is_none();
        let target = if people { ProgressDrawTarget::stderr() } else { ProgressDrawTarget::hidden() };
        let bar = ProgressBar::with_draw_target(Some(STEPS), target);
        if let Ok(style) = ProgressStyle::with_template("{msg} {wide_bar} {percent:>3} %  {eta} left") {
            bar.set_style(style);
        }
        Progress(bar.with_message(what))
    }

    /// Shows a share of the work, from 0 to 1.
    pub(crate) fn show(&self, share: f32) {
        self.0.set_position((share.clamp(0.0, 1.0) * STEPS as f32) as u64);
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}
