//! Progress on standard error, on a terminal only.

use crate::at_work::{AtWork, time_left};
use crate::signals;
use dolmen_work::{Progress, Stage};
use indicatif::{ProgressBar, ProgressState, ProgressStyle};
use std::io::IsTerminal as _;
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

/// Interval of the progress spinner.
const TICK: Duration = Duration::from_millis(120);

/// Time after which a silent verb shows a spinner.
const PATIENCE: Duration = Duration::from_secs(2);

/// The spinner of a verb that has printed nothing yet.
struct Silence {
    is_over: bool,
    line: Option<ProgressBar>,
}

static SILENCE: Mutex<Silence> = Mutex::new(Silence {
    is_over: false,
    line: None,
});

/// Shows a spinner on a terminal after two seconds, until [`end_silence`].
pub(crate) fn show_work(quiet: bool) {
    if quiet || !std::io::stderr().is_terminal() {
        return;
    }
    std::thread::spawn(|| {
        std::thread::sleep(PATIENCE);
        let mut silence = SILENCE.lock().unwrap_or_else(PoisonError::into_inner);
        if !silence.is_over {
            let line = styled(ProgressBar::new_spinner(), "{spinner} {msg} {elapsed}");
            line.set_message(AtWork::Computing.text());
            line.enable_steady_tick(TICK);
            silence.line = Some(line);
        }
    });
}

/// Removes the spinner of [`show_work`] for good, before other output.
pub(crate) fn end_silence() {
    let mut silence = SILENCE.lock().unwrap_or_else(PoisonError::into_inner);
    silence.is_over = true;
    if let Some(line) = silence.line.take() {
        line.finish_and_clear();
    }
}

/// A progress bar or a spinner.
pub(crate) struct Terminal {
    quiet: bool,
    shown: Mutex<Shown>,
}

struct Shown {
    bar: ProgressBar,
    /// Length of a run, s; `None` during other work.
    whole_s: Option<f64>,
}

impl Terminal {
    pub(crate) fn new(quiet: bool) -> Self {
        Terminal {
            quiet,
            shown: Mutex::new(Shown {
                bar: ProgressBar::hidden(),
                whole_s: None,
            }),
        }
    }

    fn bar(&self, length: u64, template: &str) -> ProgressBar {
        styled(
            if self.quiet {
                ProgressBar::hidden()
            } else {
                ProgressBar::new(length)
            },
            template,
        )
    }

    /// Shows a message while `work` runs.
    pub(crate) fn waiting<T>(&self, message: AtWork, work: impl FnOnce() -> T) -> T {
        let bar = self.spinner(message.text());
        let done = work();
        bar.finish_and_clear();
        done
    }

    fn spinner(&self, message: String) -> ProgressBar {
        let bar = if self.quiet {
            ProgressBar::hidden()
        } else {
            ProgressBar::new_spinner()
        };
        let bar = styled(bar, "{spinner} {msg} {elapsed}");
        bar.set_message(message);
        bar.enable_steady_tick(TICK);
        bar
    }
}

fn styled(bar: ProgressBar, template: &str) -> ProgressBar {
    if let Ok(style) = ProgressStyle::with_template(template) {
        let left = |state: &ProgressState, out: &mut dyn std::fmt::Write| {
            let _ = out.write_str(&time_left(state.eta())); // a failure only leaves the time out of the bar
        };
        bar.set_style(style.with_key("eta", left));
    }
    bar
}

impl Progress for Terminal {
    fn begin(&self, stage: &Stage) {
        end_silence();
        let mut shown = self.shown.lock().unwrap_or_else(PoisonError::into_inner);
        shown.bar.finish_and_clear();
        shown.whole_s = None;
        shown.bar = match stage {
            Stage::Simulating { whole_s } => {
                signals::watch();
                shown.whole_s = Some(*whole_s);
                let template = "{bar:40} {msg} {eta} ".to_owned() + &AtWork::Left.text();
                self.bar((1e3 * whole_s) as u64, &template)
            }
            Stage::Runs { about } => {
                signals::watch();
                let (of, runs, left) = (AtWork::RunsOf.text(), AtWork::Runs.text(), AtWork::Left.text());
                let template = format!("{{bar:40}} {{pos}} {of} {{len}} {runs} {{eta}} {left}");
                self.bar(*about as u64, &template)
            }
            Stage::Reading { file } => self.spinner(AtWork::Reading(file.clone()).text()),
            Stage::Identifying { file } => self.spinner(AtWork::Identifying(file.clone()).text()),
            Stage::Joining => self.spinner(AtWork::Joining.text()),
        };
    }

    fn advance(&self, position: f64) {
        if self.quiet {
            return;
        }
        let shown = self.shown.lock().unwrap_or_else(PoisonError::into_inner);
        match shown.whole_s {
            Some(whole_s) => {
                shown.bar.set_position((1e3 * position) as u64);
                shown.bar.set_message(format!("{position:.1} of {whole_s:.1} s,"));
            }
            None => shown.bar.set_position(position as u64),
        }
    }

    fn end(&self) {
        let shown = self.shown.lock().unwrap_or_else(PoisonError::into_inner);
        shown.bar.finish_and_clear();
    }

    fn is_cancelled(&self) -> bool {
        signals::asked_to_stop()
    }
}
