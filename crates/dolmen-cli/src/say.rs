//! Prints results to standard output.

use crate::progress::end_silence;
use crate::wrong::CommandError;
use anyhow::Result;
use std::io::Write as _;

/// Prints results to standard output. A closed pipe (`| head`) ends the command quietly; a full disk is an error.
pub(crate) fn say(text: &str) -> Result<()> {
    end_silence();
    match std::io::stdout().write_all(text.as_bytes()) {
        Err(fault) if fault.kind() == std::io::ErrorKind::BrokenPipe => Ok(()),
        written => written.map_err(|why| CommandError::CannotPrint { why }.into()),
    }
}

/// Prints a value as JSON.
pub(crate) fn say_json(value: &serde_json::Value) -> Result<()> {
    say(&format!("{value:#}\n"))
}
