//! Colours of a judgement.

/// Green, amber, red, from the best to the worst.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Colour {
    /// Nothing to act on was found.
    Green,
    /// Needs attention: a small margin, unknown, not decided, or contradicted by a survey.
    Amber,
    /// Unstable, below demand, fallen, beyond its room or strength, or damaged to state 3.
    Red,
}

impl Colour {
    /// The worst of several; green for none.
    pub fn worst(colours: impl IntoIterator<Item = Colour>) -> Colour {
        colours.into_iter().max().unwrap_or(Colour::Green)
    }

    /// Its key: green, amber, red.
    pub fn word(self) -> &'static str {
        match self {
            Colour::Green => "green",
            Colour::Amber => "amber",
            Colour::Red => "red",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holds_the_worst_colour_wins() {
        assert_eq!(Colour::worst([]), Colour::Green);
        assert_eq!(Colour::worst([Colour::Amber, Colour::Green]), Colour::Amber);
        assert_eq!(
            Colour::worst([Colour::Green, Colour::Red, Colour::Amber]),
            Colour::Red
        );
    }
}
