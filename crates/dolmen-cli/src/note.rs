//! Lines on standard error.

/// Prints a line to standard error; a reader that has gone (`2>&1 | head`) is no fault.
macro_rules! note {
    ($($said:tt)*) => {{
        use std::io::Write as _;
        $crate::progress::end_silence();
        let _ = writeln!(std::io::stderr(), $($said)*);
    }};
}

pub(crate) use note;
