//! Sentences: one enum variant each, with typed arguments and both languages side by side.
//!
//! A missing translation, an unknown argument, or an argument that one language leaves out is a compile error.

use crate::Language;
use crate::printed_names::printed_name;
use crate::quantity::{Quantity, Values};
pub use crate::run::{Run, Slot, Slots};
pub use crate::template::{Medium, Template, holds, knows, marks_well, message_id};

/// A type that can be an argument of a sentence.
pub trait Argument {
    /// Its text in a language.
    fn said(&self, language: Language) -> Vec<Run>;

    /// Its text on paper, if it differs.
    fn said_on_paper(&self, _language: Language) -> Option<Vec<Run>> {
        None
    }
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

    fn said_on_paper(&self, language: Language) -> Option<Vec<Run>> {
        (**self).said_on_paper(language)
    }
}

impl<T: Argument + ?Sized> Argument for Box<T> {
    fn said(&self, language: Language) -> Vec<Run> {
        (**self).said(language)
    }

    fn said_on_paper(&self, language: Language) -> Option<Vec<Run>> {
        (**self).said_on_paper(language)
    }
}

/// A sentence within a sentence.
impl Argument for Sentence {
    fn said(&self, language: Language) -> Vec<Run> {
        self.runs(language).to_vec()
    }

    fn said_on_paper(&self, language: Language) -> Option<Vec<Run>> {
        let paper = self.paper.as_ref()?;
        Some(language.pick(&paper.english, &paper.korean).clone())
    }
}

/// A list: "1.2, 3.4 and 5.6", "1.2, 3.4, 5.6".
impl<T: Argument> Argument for Vec<T> {
    fn said(&self, language: Language) -> Vec<Run> {
        listed(self.iter().map(|one| one.said(language)).collect(), language)
    }

    fn said_on_paper(&self, language: Language) -> Option<Vec<Run>> {
        let each: Vec<_> = self.iter().map(|one| one.said_on_paper(language)).collect();
        each.iter().any(Option::is_some).then(|| {
            let each = self.iter().zip(each);
            let each = each.map(|(one, paper)| paper.unwrap_or_else(|| one.said(language)));
            listed(each.collect(), language)
        })
    }
}

/// Texts with commas between them, and "and" before the last in English.
fn listed(each: Vec<Vec<Run>>, language: Language) -> Vec<Run> {
    let mut runs = Vec::new();
    let count = each.len();
    for (at, one) in each.into_iter().enumerate() {
        match (at, language) {
            (0, _) => {}
            (_, Language::English) if at + 1 == count => runs.push(Run::Text(" and ".to_owned())),
            _ => runs.push(Run::Text(", ".to_owned())),
        }
        runs.extend(one);
    }
    runs
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
    /// What it says on paper, if that differs.
    paper: Option<Box<OnPaper>>,
}

/// What a sentence says to a reader who can type nothing.
#[derive(Clone, Debug, PartialEq)]
struct OnPaper {
    english: Vec<Run>,
    korean: Vec<Run>,
}

impl Sentence {
    /// A sentence without a template: a name or a symbol from elsewhere.
    pub fn of_runs(id: &str, english: Vec<Run>, korean: Vec<Run>) -> Self {
        Sentence {
            id: id.to_owned(),
            arguments: Vec::new(),
            english,
            korean,
            paper: None,
        }
    }

    /// Its pieces in a language.
    pub fn runs(&self, language: Language) -> &[Run] {
        language.pick(&self.english, &self.korean)
    }

    /// The same for paper: without commands and keys of the file, in the words that its template gives for paper.
    pub fn on_paper(&self) -> Self {
        match &self.paper {
            None => self.clone(),
            Some(paper) => Sentence {
                id: self.id.clone(),
                arguments: self.arguments.clone(),
                english: paper.english.clone(),
                korean: paper.korean.clone(),
                paper: None,
            },
        }
    }

    /// A message with its arguments.
    pub fn of_template(template: &Template, arguments: Vec<Given>) -> Self {
        let said = |medium, language| filled(&template.on(language, medium), medium, language, &arguments);
        let differs = template.has_marks() || arguments.iter().any(|given| given.paper.is_some());
        Sentence {
            id: template.id(),
            english: said(Medium::Screen, Language::English),
            korean: said(Medium::Screen, Language::Korean),
            paper: differs.then(|| {
                Box::new(OnPaper {
                    english: said(Medium::Paper, Language::English),
                    korean: said(Medium::Paper, Language::Korean),
                })
            }),
            arguments: arguments
                .into_iter()
                .map(|given| (given.name, given.english))
                .collect(),
        }
    }

    /// The text of an error that another error wraps.
    pub fn of_argument(argument: &(impl Argument + ?Sized)) -> Self {
        let of = |language| argument.said(language);
        let on_paper = |language| argument.said_on_paper(language);
        let on_paper = on_paper(Language::English).zip(on_paper(Language::Korean));
        Sentence {
            paper: on_paper.map(|(english, korean)| Box::new(OnPaper { english, korean })),
            ..Sentence::of_runs("handed-on", of(Language::English), of(Language::Korean))
        }
    }

    /// A symbol, the same in both languages: "kN·m/rad".
    pub fn of_symbol(symbol: &str) -> Self {
        let runs = vec![Run::Text(symbol.to_owned())];
        Sentence::of_runs("symbol", runs.clone(), runs)
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
    paper: Option<Box<OnPaper>>,
}

impl Given {
    /// An argument with its name.
    pub fn of(name: &'static str, argument: &impl Argument) -> Self {
        let said = Sentence::of_argument(argument);
        Given {
            name,
            english: said.english,
            korean: said.korean,
            paper: said.paper,
        }
    }

    fn runs(&self, medium: Medium, language: Language) -> &[Run] {
        match (medium, &self.paper) {
            (Medium::Paper, Some(paper)) => language.pick(&paper.english, &paper.korean),
            _ => language.pick(&self.english, &self.korean),
        }
    }
}

/// Fills in a template: `{name}` becomes the argument of that name, doubled braces become braces.
fn filled(template: &str, medium: Medium, language: Language, arguments: &[Given]) -> Vec<Run> {
    let mut slots = Slots::default();
    let places: Vec<(&str, Slot)> = arguments
        .iter()
        .map(|given| (given.name, slots.put(given.runs(medium, language).to_vec())))
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

/// Defines an enum of messages; `Sentence::from(message)` gives the sentence in both languages. A message with one argument may take it in
/// parentheses. What stands between `«` and `»` is said on a screen only, such as a key to write into the file; behind a bar,
/// `«on a screen|on paper»`, are the words for paper ([`Sentence::on_paper`]). At most 60 variants per enum, because compile time grows faster than their number.
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
///         NoBed => {
///             en: "No «bed_width|width of the bed» is given«; write it into the link».",
///             ko: "«bed_width가|접합면 폭이» 없다.« 부재에 쓴다.»",
///         },
///     }
/// }
/// let said = Sentence::from(Pole::Falls { link: "노반".into(), factor: Quantity::beside_one(1.2, 3) });
/// assert_eq!(said.text(Language::Korean), "노반이 자중의 1.20배에서 전도된다.");
/// assert_eq!(said.id, "pole/falls");
/// let said = Sentence::from(Pole::Leans("노반".into()));
/// assert_eq!(said.text(Language::Korean), "노반이 기울었다.");
/// let said = Sentence::from(Pole::NoBed);
/// assert_eq!(said.text(Language::English), "No bed_width is given; write it into the link.");
/// assert_eq!(said.on_paper().text(Language::English), "No width of the bed is given.");
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
        assert_eq!(Sentence::from(Said::Plain).id, "test/plain");
    }

    messages! {
        /// Sentences with words for paper.
        enum Marked in "test.marked" {
            Next { what: Sentence, all: Vec<Sentence> } => {
                en: "Next: {what}« (`dolmen check`)». All: {all}.",
                ko: "다음: {what}«(`dolmen check`)». 모두 {all}을(를) 본다.",
            },
            Give => { en: "give «bed_width|the width of the bed»", ko: "«bed_width|접합면 폭»" },
            Plain => { en: "look", ko: "살핀다" },
        }
    }

    #[test]
    fn exact_words_for_paper_pass_through_sentences_and_lists() {
        let said = Sentence::from(Marked::Next {
            what: Marked::Give.into(),
            all: vec![Marked::Plain.into(), Marked::Give.into()],
        });
        assert_eq!(
            said.text(Language::English),
            "Next: give bed_width (`dolmen check`). All: look and give bed_width."
        );
        let paper = said.on_paper();
        assert_eq!(
            paper.text(Language::English),
            "Next: give the width of the bed. All: look and give the width of the bed."
        );
        // each reading has its own particle
        assert_eq!(
            said.text(Language::Korean),
            "다음: bed_width(`dolmen check`). 모두 살핀다, bed_width를 본다."
        );
        assert_eq!(
            paper.text(Language::Korean),
            "다음: 접합면 폭. 모두 살핀다, 접합면 폭을 본다."
        );
        assert_eq!(paper.on_paper(), paper);
        let plain = Sentence::from(Marked::Plain);
        assert_eq!(plain.on_paper(), plain);
        let template = Marked::TEMPLATES[1];
        assert_eq!(
            template.on(Language::English, Medium::Paper),
            "give the width of the bed"
        );
    }
}
