//! The loads or the direction that decide a word of the judgement.

use super::answer::LoadsAnswer;
use dolmen_words::message::Both;
use dolmen_words::{Language, Sentence, messages};

messages! {
    /// The word for weight with the combination that decides it.
    pub enum Governed in "judgement.governed" {
        UnderWind { word: Both } => { en: "{word} in wind", ko: "풍하중 작용 시 {word}" },
        UnderLoads { word: Both } => { en: "{word} under its static loads", ko: "정하중 작용 시 {word}" },
        UnderBoth { word: Both } => {
            en: "{word} under wind and static loads",
            ko: "풍하중·정하중 작용 시 {word}",
        },
        Towards { word: Both, direction: String } => {
            en: "{word} in direction {direction}",
            ko: "{direction} 방향 {word}",
        },
        UnderCombination { word: Both, name: String } => {
            en: "{word} under combination {name}",
            ko: "하중조합 {name}에서 {word}",
        },
    }
}

/// The wind, static loads or direction that govern a word.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Governing {
    /// Wind.
    Wind,
    /// Static loads.
    Loads,
    /// Both as they are.
    Both,
    /// A combination by its name.
    Combination(String),
    /// Its weight, in one of two directions: "y".
    Direction(&'static str),
}

impl Governing {
    /// The worst combination, or the kinds of load.
    pub(crate) fn of(loads: &LoadsAnswer) -> Governing {
        if loads.falls_as_it_hangs() {
            return Governing::Loads;
        }
        let name = loads.worst().and_then(|worst| worst.name.clone());
        match (name, loads.has_wind, loads.has_loads) {
            (Some(name), _, _) => Governing::Combination(name),
            (None, true, false) => Governing::Wind,
            (None, false, _) => Governing::Loads,
            (None, true, true) => Governing::Both,
        }
    }

    /// Its key in JSON: "wind", "loads", "wind and loads", the name of the combination.
    pub fn key(&self) -> &str {
        match self {
            Governing::Wind => "wind",
            Governing::Loads => "loads",
            Governing::Both => "wind and loads",
            Governing::Combination(name) => name,
            Governing::Direction(name) => name,
        }
    }

    /// Whether its weight alone decides.
    pub fn is_weight(&self) -> bool {
        matches!(self, Governing::Direction(_))
    }

    /// The word under these loads.
    pub(crate) fn under(&self, word: Both) -> Governed {
        match self {
            Governing::Wind => Governed::UnderWind { word },
            Governing::Loads => Governed::UnderLoads { word },
            Governing::Both => Governed::UnderBoth { word },
            Governing::Direction(name) => Governed::Towards {
                word,
                direction: (*name).to_owned(),
            },
            Governing::Combination(name) => Governed::UnderCombination {
                word,
                name: name.clone(),
            },
        }
    }
}

impl Governed {
    /// In a language.
    pub(crate) fn text(self, language: Language) -> String {
        Sentence::from(self).text(language)
    }
}
