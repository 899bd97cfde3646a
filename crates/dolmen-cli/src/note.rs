//! Lines on standard error.

/// Prints a line to standard error; a closed pipe (`2>&1 | head`) is no error.
macro_rules! note {
    ($($said:tt)*) => {{
        use std::io::Write as _;
        $crate::progress::end_silence();
        let _ = writeln!(std::io::stderr(), $($said)*);
    }};
}

pub(crate) use note;
