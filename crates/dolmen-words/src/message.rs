//! Sentences: one enum variant each, with typed arguments and both languages side by side.
//!
//! A missing translation, an unknown argument, or an argument that one language leaves out is a compile error.

use crate::Language;
use crate::printed_names::printed_name;
use crate::quantity::{Quantity, Values};
pub use crate::run::{Run, Slot, Slots};

/// A type that can be an argument of a sentence.
pub trait Argument {
    /// Its text in a language.
    fn said(&self, language: Language) -> Vec<Run>;
}

impl Argument for Quantity {
    fn said(&self, _language: Language) -> Vec<Run> {
        vec![Run::Quantity(self.clone())]
    }
}

impl Argument for String {
    fn said(&self, language: Language) -> Vec<Run> {
        self.as_str().said(language)
    }
}

/// A text in both languages.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Both {
    /// English.
    pub english: String,
    /// 한국어.
    pub korean: String,
}

impl Both {
    /// The results of `said` for each language.
    pub fn of<T: Into<String>>(said: impl Fn(Language) -> T) -> Self {
        Both {
            english: said(Language::English).into(),
            korean: said(Language::Korean).into(),
        }
    }

    /// Its text in a language.
    pub fn text(&self, language: Language) -> &str {
        language.pick(&self.english, &self.korean)
    }
}

/// The same text in both languages: a symbol, a name, or a text without a translation.
impl From<String> for Both {
    fn from(text: String) -> Self {
        Both {
            korean: text.clone(),
            english: text,
        }
    }
}

/// The same text in both languages: a symbol, a name, or a text without a translation.
impl From<&str> for Both {
    fn from(text: &str) -> Self {
        Both::from(text.to_owned())
    }
}

/// A message, as plain text.
impl<T: Into<Sentence>> From<T> for Both {
    fn from(message: T) -> Self {
        let sentence: Sentence = message.into();
        Both::of(|language| sentence.text(language))
    }
}

impl Argument for Both {
    fn said(&self, language: Language) -> Vec<Run> {
        self.text(language).said(language)
    }
}

impl Argument for usize {
    fn said(&self, _language: Language) -> Vec<Run> {
        vec![Run::Text(self.to_string())]
    }
}

/// Types with the same text in both languages: unrounded numbers and words.
macro_rules! said_as_displayed {
    ($($kind:ty),+) => {
        $(impl Argument for $kind {
            fn said(&self, _language: Language) -> Vec<Run> {
                vec![Run::Text(self.to_string())]
            }
        })+
    };
}

said_as_displayed!(u8, u16, u32, u64, i32, i64, f64);

impl Argument for str {
    fn said(&self, language: Language) -> Vec<Run> {
        vec![Run::Name(printed_name(self, language).into_owned())]
    }
}

impl<T: Argument + ?Sized> Argument for &T {
    fn said(&self, language: Language) -> Vec<Run> {
        (**self).said(language)
    }
}

impl<T: Argument + ?Sized> Argument for Box<T> {
    fn said(&self, language: Language) -> Vec<Run> {
        (**self).said(language)
    }
}

/// A sentence within a sentence.
impl Argument for Sentence {
    fn said(&self, language: Language) -> Vec<Run> {
        self.runs(language).to_vec()
    }
}

/// A list: "1.2, 3.4 and 5.6", "1.2, 3.4, 5.6".
impl<T: Argument> Argument for Vec<T> {
    fn said(&self, language: Language) -> Vec<Run> {
        let mut runs = Vec::new();
        for (at, one) in self.iter().enumerate() {
            let last = at + 1 == self.len();
            match (at, language) {
                (0, _) => {}
                (_, Language::English) if last => runs.push(Run::Text(" and ".to_owned())),
                _ => runs.push(Run::Text(", ".to_owned())),
            }
            runs.extend(one.said(language));
        }
        runs
    }
}

/// Values with a common unit, which follows the last.
impl Argument for Values {
    fn said(&self, language: Language) -> Vec<Run> {
        let last = self.0.len().saturating_sub(1);
        let bare = |(at, value): (usize, &Quantity)| match at == last {
            true => value.clone(),
            false => value.without_symbol(),
        };
        let each: Vec<Quantity> = self.0.iter().enumerate().map(bare).collect();
        each.said(language)
    }
}

/// A sentence before its arguments are filled in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Template {
    /// The group of its message, such as "chain.stability".
    pub group: &'static str,
    /// The name of its message, such as "Contradicted".
    pub message: &'static str,
    /// English, its arguments in braces.
    pub english: &'static str,
    /// 한국어.
    pub korean: &'static str,
}

impl Template {
    /// "chain.stability/contradicted", as in [`Sentence::id`].
    pub fn id(&self) -> String {
        message_id(self.group, self.message)
    }
}

/// A sentence in both languages, with its message and arguments.
#[derive(Clone, Debug, PartialEq)]
pub struct Sentence {
    /// "chain.stability/contradicted".
    pub id: String,
    /// The arguments by name, in English.
    pub arguments: Vec<(&'static str, Vec<Run>)>,
    /// English.
    pub english: Vec<Run>,
    /// 한국어.
    pub korean: Vec<Run>,
}

impl Sentence {
    /// Its pieces in a language.
    pub fn runs(&self, language: Language) -> &[Run] {
        language.pick(&self.english, &self.korean)
    }

    /// A message with its arguments.
    pub fn of_template(template: &Template, arguments: Vec<Given>) -> Self {
        Sentence {
            id: template.id(),
            english: filled(template.english, Language::English, &arguments),
            korean: filled(template.korean, Language::Korean, &arguments),
            arguments: arguments
                .into_iter()
                .map(|given| (given.name, given.english))
                .collect(),
        }
    }

    /// A symbol, the same in both languages: "kN·m/rad".
    pub fn of_symbol(symbol: &str) -> Self {
        let runs = vec![Run::Text(symbol.to_owned())];
        Sentence {
            id: "symbol".to_owned(),
            arguments: Vec::new(),
            english: runs.clone(),
            korean: runs,
        }
    }

    /// As plain text.
    pub fn text(&self, language: Language) -> String {
        self.runs(language).iter().map(Run::text).collect()
    }
}

/// An argument with its text in each language.
#[derive(Clone, Debug)]
pub struct Given {
    name: &'static str,
    english: Vec<Run>,
    korean: Vec<Run>,
}

impl Given {
    /// An argument with its name.
    pub fn of(name: &'static str, argument: &impl Argument) -> Self {
        Given {
            name,
            english: argument.said(Language::English),
            korean: argument.said(Language::Korean),
        }
    }
}

/// Fills in a template: `{name}` becomes the argument of that name, doubled braces become braces.
fn filled(template: &str, language: Language, arguments: &[Given]) -> Vec<Run> {
    let mut slots = Slots::default();
    let places: Vec<(&str, Slot)> = arguments
        .iter()
        .map(|given| {
            let runs = match language {
                Language::English => given.english.clone(),
                Language::Korean => given.korean.clone(),
            };
            (given.name, slots.put(runs))
        })
        .collect();
    let mut formatted = String::with_capacity(template.len());
    let mut rest = template;
    while let Some(at) = rest.find(['{', '}']) {
        let (text, braced) = rest.split_at(at);
        formatted.push_str(text);
        let (sign, behind) = braced.split_at(1);
        rest = match (behind.strip_prefix(sign), behind.split_once('}')) {
            (Some(behind), _) => {
                formatted.push_str(sign);
                behind
            }
            (None, Some((name, behind))) => {
                let place = places.iter().find(|(known, _)| *known == name);
                formatted.extend(place.map(|(_, slot)| slot.0));
                behind
            }
            (None, None) => behind, // refused at compile time
        };
    }
    formatted.push_str(rest);
    slots.fill(&formatted, language)
}

/// `chain.stability` and `ModelContradicted` make `chain.stability/model-contradicted`.
pub fn message_id(group: &str, variant: &str) -> String {
    let words = variant.char_indices().map(|(at, sign)| match sign {
        upper if upper.is_uppercase() && at > 0 => format!("-{}", upper.to_lowercase()),
        other => other.to_lowercase().to_string(),
    });
    format!("{group}/{}", words.collect::<String>())
}

/// Whether a sentence has a placeholder `{argument}`; runs at compile time.
pub const fn holds(sentence: &str, argument: &str) -> bool {
    let (sentence, argument) = (sentence.as_bytes(), argument.as_bytes());
    let mut at = 0;
    while at + argument.len() + 1 < sentence.len() {
        let mut same = 0;
        while same < argument.len() && sentence[at + 1 + same] == argument[same] {
            same += 1;
        }
        if sentence[at] == b'{' && same == argument.len() && sentence[at + 1 + same] == b'}' {
            return true;
        }
        at += 1;
    }
    false
}

/// Whether every placeholder of a sentence is a known argument; runs at compile time.
pub const fn knows(sentence: &str, names: &[&str]) -> bool {
    let sentence = sentence.as_bytes();
    let mut at = 0;
    while at < sentence.len() {
        let is_brace = sentence[at] == b'{' || sentence[at] == b'}';
        if is_brace && at + 1 < sentence.len() && sentence[at + 1] == sentence[at] {
            at += 2;
        } else if is_brace {
            let mut end = at + 1;
            while end < sentence.len() && sentence[end] != b'}' {
                end += 1;
            }
            if sentence[at] == b'}' || end == sentence.len() || !is_one_of(sentence, at + 1, end, names) {
                return false;
            }
            at = end + 1;
        } else {
            at += 1;
        }
    }
    true
}

/// Whether the bytes from `start` to `end` are one of the names.
const fn is_one_of(sentence: &[u8], start: usize, end: usize, names: &[&str]) -> bool {
    let mut number = 0;
    while number < names.len() {
        let name = names[number].as_bytes();
        let mut same = 0;
        while same < name.len() && start + same < end && sentence[start + same] == name[same] {
            same += 1;
        }
        if same == name.len() && start + same == end {
            return true;
        }
        number += 1;
    }
    false
}

/// Defines an enum of messages; `Sentence::from(message)` gives the sentence in both languages. A message with one argument may take it in
/// parentheses. At most 60 variants per enum, because compile time grows faster than their number.
///
/// ```
/// use dolmen_words::{Language, Quantity, Sentence, messages};
/// messages! {
///     /// Sentences about a pole.
///     pub enum Pole in "pole" {
///         Falls { link: String, factor: Quantity } => {
///             en: "{link} falls at {factor} times its weight.",
///             ko: "{link}이(가) 자중의 {factor}배에서 전도된다.",
///         },
///         Leans(link: String) => { en: "{link} leans.", ko: "{link}이(가) 기울었다." },
///     }
/// }
/// let said = Sentence::from(Pole::Falls { link: "노반".into(), factor: Quantity::beside_one(1.2, 3) });
/// assert_eq!(said.text(Language::Korean), "노반이 자중의 1.20배에서 전도된다.");
/// assert_eq!(said.id, "pole/falls");
/// let said = Sentence::from(Pole::Leans("노반".into()));
/// assert_eq!(said.text(Language::Korean), "노반이 기울었다.");
/// ```
///
/// An argument that one language leaves out does not compile:
///
/// ```compile_fail
/// use dolmen_words::{Quantity, messages};
/// messages! {
///     /// Sentences about a pole.
///     pub enum Pole in "pole" {
///         Falls { factor: Quantity } => { en: "It falls at {factor} times its weight.", ko: "전도된다." },
///     }
/// }
/// ```
#[macro_export]
macro_rules! messages {
    ($(#[$about:meta])* $visible:vis enum $name:ident in $group:literal {
        $($(#[$note:meta])* $message:ident $({ $($argument:ident: $kind:ty),* $(,)? })? $(($only:ident: $only_kind:ty))? => { en: $english:literal, ko: $korean:literal $(,)? }),* $(,)?
    }) => {
        $(#[$about])*
        #[derive(Clone, Debug, PartialEq)]
        #[allow(missing_docs, reason = "the sentence says what it is")]
        $visible enum $name { $($(#[$note])* $message $({ $($argument: $kind),* })? $(($only_kind))?),* }

        impl $name {
            /// Templates of the sentences.
            $visible const TEMPLATES: &'static [$crate::Template] = &[
                $($crate::Template {
                    group: $group,
                    message: stringify!($message),
                    english: $english,
                    korean: $korean,
                }),*
            ];
        }

        $($crate::argument_names!(@ $message, $english, $korean, [$($($argument),*)? $($only)?]);)*

        impl From<$name> for $crate::Sentence {
            fn from(message: $name) -> Self {
                match message {
                    $($name::$message $({ $($argument),* })? $(($only))? => $crate::Sentence::of_template(
                        &$crate::Template {
                            group: $group,
                            message: stringify!($message),
                            english: $english,
                            korean: $korean,
                        },
                        $crate::arguments!([] [$($($argument),*)? $($only)?]),
                    )),*
                }
            }
        }
    };
}

#[cfg(test)]
mod tests {
    use super::*;

    messages! {
        /// Sentences of these tests.
        enum Said in "test" {
            Plain => { en: "It stands.", ko: "안정하다." },
            Lies { stone: String, on: String } => {
                en: "{stone} lies on {on}.",
                ko: "{stone}이(가) {on}을(를) 누른다.",
            },
            Many { all: Values } => { en: "All: {all}.", ko: "모두 {all}을(를) 쓴다." },
            Among { all: Vec<Quantity> } => { en: "Among {all}.", ko: "{all}와(과) 비교." },
            Leans(stone: String) => { en: "{stone} leans.", ko: "{stone}이(가) 기울었다." },
        }
    }

    #[test]
    fn exact_a_message_may_take_its_only_argument_without_its_name() {
        let said = Sentence::from(Said::Leans("노반".into()));
        assert_eq!(said.text(Language::English), "노반 leans.");
        assert_eq!(said.text(Language::Korean), "노반이 기울었다.");
        assert_eq!(said.arguments[0].0, "stone");
    }

    #[test]
    fn holds_a_name_is_never_taken_for_a_particle_or_a_place() {
        let said = Sentence::from(Said::Lies {
            stone: "<은(는) {on}>".into(),
            on: "노반".into(),
        });
        assert_eq!(said.text(Language::Korean), "<은(는) {on}>이 노반을 누른다.");
        assert_eq!(said.text(Language::English), "<은(는) {on}> lies on 노반.");
        assert_eq!(said.arguments[1], ("on", vec![Run::Name("노반".into())]));
    }

    #[test]
    fn exact_lists_and_ids() {
        let hertz = |value| Quantity::new(value, crate::Unit::si("Hz"), crate::Digits::Significant(2));
        let said = Sentence::from(Said::Among {
            all: vec![hertz(1.0), hertz(2.0), hertz(3.0)],
        });
        assert_eq!(
            said.text(Language::English),
            "Among 1.0\u{202f}Hz, 2.0\u{202f}Hz and 3.0\u{202f}Hz."
        );
        assert_eq!(
            said.text(Language::Korean),
            "1.0\u{202f}Hz, 2.0\u{202f}Hz, 3.0\u{202f}Hz와 비교."
        );
        let said = Sentence::from(Said::Many {
            all: Values(vec![hertz(1.0), hertz(2.0)]),
        });
        assert_eq!(said.text(Language::English), "All: 1.0 and 2.0\u{202f}Hz.");
        assert_eq!(said.text(Language::Korean), "모두 1.0, 2.0\u{202f}Hz를 쓴다.");
        let template = Said::TEMPLATES[2];
        assert_eq!(
            (template.id().as_str(), template.english),
            ("test/many", "All: {all}.")
        );
        assert!(knows("{a} {{b}} {c}", &["a", "c"]) && knows("한 {a}", &["a"]) && !knows("{ab}", &["a"]));
        assert!(!knows("{a", &["a"]) && !knows("a}", &["a"]) && !knows("{a}", &["ab"]));
        assert!(holds("{a} b", "a") && holds("b {ab}", "ab") && !holds("{ab} a", "a") && !holds("{a", "a"));
        assert_eq!(
            message_id("chain", "ModelContradicted"),
            "chain/model-contradicted"
        );
        assert_eq!(Sentence::from(Said::Plain).id, "test/plain");
    }
}
