//! Names that are printed differently from the file: those of its parts, surveys and motions, in the language of the reader.
//!
//! Sentences and labels of figures ask here for the name to print, so that Korean particles follow it. Keys, CSV heads, JSON and names of files keep
//! the name of the file. A thread prints for one reader; nothing is renamed before [`print_names`].

use crate::Language;
use std::borrow::Cow;
use std::cell::RefCell;
use std::collections::BTreeMap;

/// A name as it is printed in one language.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PrintedName {
    /// As the file writes it.
    pub name: String,
    /// The language.
    pub language: Language,
    /// The printed name in this language.
    pub printed: String,
}

#[derive(Default)]
struct Printed {
    english: BTreeMap<String, String>,
    korean: BTreeMap<String, String>,
    /// Language of the reader: labels of figures are drawn in one language.
    reader: Language,
    /// Number of callers that currently write for programs.
    keeping: usize,
}

thread_local! {
    static PRINTED: RefCell<Printed> = RefCell::default();
}

/// Prints these names from now on, for a reader of a language. A name that two files translate differently is printed as in the files.
///
/// # Example
/// ```
/// use dolmen_words::{Language, PrintedName, keeping_names, print_names, printed_name};
/// let one = |printed: &str| PrintedName { name: "base".into(), language: Language::Korean, printed: printed.into() };
/// print_names(&[one("기단")], Language::Korean);
/// assert_eq!(printed_name("base", Language::Korean), "기단");
/// assert_eq!(printed_name("base", Language::English), "base");
/// assert_eq!(keeping_names(|| printed_name("base", Language::Korean).into_owned()), "base");
/// assert_eq!(printed_name("base / ground", Language::Korean), "기단 / ground");
/// print_names(&[one("받침")], Language::Korean); // of another file
/// assert_eq!(printed_name("base", Language::Korean), "base");
/// ```
pub fn print_names(names: &[PrintedName], reader: Language) {
    PRINTED.with_borrow_mut(|all| {
        all.reader = reader;
        for of in names {
            let known = match of.language {
                Language::English => &mut all.english,
                Language::Korean => &mut all.korean,
            };
            let printed = match known.get(&of.name) {
                Some(other) if *other != of.printed => &of.name,
                _ => &of.printed,
            };
            known.insert(of.name.clone(), printed.clone());
        }
    });
}

/// The printed form of a name in a language: each of several names with commas, and both of a stone on another ("roof 1 / post a"). A name without
/// an entry stays as it is.
pub fn printed_name(name: &str, language: Language) -> Cow<'_, str> {
    PRINTED.with_borrow(|all| {
        let known = language.pick(&all.english, &all.korean);
        if known.is_empty() || all.keeping > 0 {
            return Cow::Borrowed(name);
        }
        let alone = known.get(name).cloned();
        let listed = || {
            let each = name.split(", ").map(|of| known.get(of).map(String::as_str));
            each.collect::<Option<Vec<&str>>>().map(|each| each.join(", "))
        };
        // the lower of the two may be the ground
        let stacked = || {
            let (upper, lower) = name.split_once(" / ")?;
            let of = |name: &str| known.get(name).cloned();
            let both = (of(upper), of(lower));
            let any = both.0.is_some() || both.1.is_some();
            let [upper, lower] = [(both.0, upper), (both.1, lower)]
                .map(|(printed, name)| printed.unwrap_or_else(|| name.to_owned()));
            any.then(|| format!("{upper} / {lower}"))
        };
        alone
            .or_else(listed)
            .or_else(stacked)
            .map_or(Cow::Borrowed(name), Cow::Owned)
    })
}

/// A label of a figure in the language of the reader: a name is printed, all else stays.
pub fn printed_label(label: &str) -> Cow<'_, str> {
    printed_name(label, PRINTED.with_borrow(|all| all.reader))
}

/// What is written for programs: names stay as the file writes them.
pub fn keeping_names<T>(work: impl FnOnce() -> T) -> T {
    /// Ends with the work, even if it panics.
    struct Keeping;
    impl Drop for Keeping {
        fn drop(&mut self) {
            PRINTED.with_borrow_mut(|all| all.keeping -= 1);
        }
    }
    PRINTED.with_borrow_mut(|all| all.keeping += 1);
    let _ends = Keeping;
    work()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::message::{Given, Sentence, Template};

    /// 이 after a consonant, 가 after a vowel.
    #[test]
    fn holds_particles_follow_the_printed_name() {
        let template = Template {
            group: "test",
            message: "Falls",
            english: "{part} falls.",
            korean: "{part}이(가) 붕괴한다.",
        };
        let said = |language| {
            let part = "bowl".to_owned();
            Sentence::of_template(&template, vec![Given::of("part", &part)]).text(language)
        };
        assert_eq!(said(Language::Korean), "bowl이 붕괴한다.");
        let printed = |language, printed: &str| PrintedName {
            name: "bowl".to_owned(),
            language,
            printed: printed.to_owned(),
        };
        print_names(&[printed(Language::Korean, "복발 받침대")], Language::Korean);
        assert_eq!(said(Language::Korean), "복발 받침대가 붕괴한다.");
        assert_eq!(said(Language::English), "bowl falls.");
        assert_eq!(printed_label("bowl"), "복발 받침대");
        assert_eq!(printed_label("bowls"), "bowls");
        assert_eq!(printed_label("bowl, bowl"), "복발 받침대, 복발 받침대");
        assert_eq!(printed_label("bowl, crown"), "bowl, crown");
        let kept = keeping_names(|| keeping_names(|| said(Language::Korean)) + &said(Language::Korean));
        assert_eq!(kept, "bowl이 붕괴한다.bowl이 붕괴한다.");
        // the same entry again changes nothing
        print_names(&[printed(Language::Korean, "복발 받침대")], Language::Korean);
        assert_eq!(said(Language::Korean), "복발 받침대가 붕괴한다.");
    }
}
