//! The pieces of a sentence, and the placeholders of its arguments.

use crate::Language;
use crate::particles::{Ending, ending, ending_of_unit, particles};
use crate::quantity::Quantity;

/// A piece of a sentence. Each renderer formats pieces in its own way, and the numbers stay available.
#[derive(Clone, Debug, PartialEq)]
pub enum Run {
    /// Words of the sentence.
    Text(String),
    /// A name from the user, printed unchanged.
    Name(String),
    /// A number with its unit.
    Quantity(Quantity),
}

impl Run {
    pub(crate) fn ending(&self) -> Option<Ending> {
        match self {
            Run::Text(text) | Run::Name(text) => ending(text),
            Run::Quantity(quantity) => {
                ending_of_unit(&quantity.unit.symbol).or_else(|| ending(&quantity.number()))
            }
        }
    }

    /// As plain text.
    pub fn text(&self) -> String {
        match self {
            Run::Text(text) | Run::Name(text) => text.clone(),
            Run::Quantity(quantity) => quantity.text(),
        }
    }
}

/// Arguments of a sentence during formatting: each is a private-use character that is replaced afterwards. So a name is never
/// mistaken for a particle, and renderers receive the values.
#[derive(Debug, Default)]
pub struct Slots(Vec<Vec<Run>>);

/// Placeholder of an argument in a format string.
#[derive(Clone, Copy, Debug)]
pub struct Slot(pub(crate) char);

/// The first character of the private use area, which no sentence holds.
const FIRST_SLOT: u32 = 0xE000;

impl Slots {
    /// Stores an argument and returns its placeholder.
    pub fn put(&mut self, runs: Vec<Run>) -> Slot {
        self.0.push(runs);
        let index = u32::try_from(self.0.len() - 1).unwrap_or(0);
        Slot(char::from_u32(FIRST_SLOT + index).unwrap_or(char::REPLACEMENT_CHARACTER))
    }

    /// The pieces of a formatted sentence, with the right particles.
    pub fn fill(self, formatted: &str, language: Language) -> Vec<Run> {
        let of = |sign: char| {
            let index = u32::from(sign).checked_sub(FIRST_SLOT)?;
            self.0.get(usize::try_from(index).ok()?)
        };
        let mut runs: Vec<Run> = Vec::new();
        let push_text = |runs: &mut Vec<Run>, text: &str| {
            let before = runs.last().and_then(Run::ending);
            let text = match language {
                Language::English => text.to_owned(),
                Language::Korean => particles(text, before),
            };
            if !text.is_empty() {
                runs.push(Run::Text(text));
            }
        };
        let mut text = String::new();
        for sign in formatted.chars() {
            match of(sign) {
                Some(argument) => {
                    push_text(&mut runs, &text);
                    text.clear();
                    runs.extend(argument.iter().cloned());
                }
                None => text.push(sign),
            }
        }
        push_text(&mut runs, &text);
        runs
    }
}
