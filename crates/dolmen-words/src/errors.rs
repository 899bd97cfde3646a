//! Sentences of errors: each variant of an enum in both languages, beside the enum.

use crate::Language;
use crate::message::{Argument, Run};

/// The text of an error in a language.
pub fn text_of(error: &dyn Argument, language: Language) -> String {
    error.said(language).iter().map(Run::text).collect()
}

/// The text of `$error` in both languages, if it is one of these types.
#[macro_export]
macro_rules! sayable {
    ($error:expr, $($kind:ty),+ $(,)?) => {{
        let error: &(dyn std::error::Error + 'static) = $error;
        None::<&dyn $crate::message::Argument>
            $(.or_else(|| error.downcast_ref::<$kind>().map(|own| own as &dyn $crate::message::Argument)))+
    }};
}

/// Gives each variant of an error a sentence in both languages: `Display` shows the English one, [`Argument`] both. The fields of a variant
/// are the arguments of its sentence, unless `as` lists others. An error that only wraps another one has no sentence of its own.
///
/// ```
/// use dolmen_words::{Language, sentences};
/// #[derive(Debug)]
/// enum Refused {
///     TooLong { side: String, length_m: f64 },
/// }
/// sentences! {
///     Refused in "refused" {
///         TooLong { side, length_m } as { side, length_m: format!("{length_m:.2}") } => {
///             en: "{side} is {length_m} m long",
///             ko: "{side}이(가) {length_m} m이다",
///         },
///     }
/// }
/// let refused = Refused::TooLong { side: "기단".to_owned(), length_m: 20.0 };
/// assert_eq!(refused.to_string(), "기단 is 20.00 m long");
/// assert_eq!(refused.sentence().text(Language::Korean), "기단이 20.00 m이다");
/// ```
#[macro_export]
macro_rules! sentences {
    ($error:ident in $group:literal {
        $($variant:ident $({ $($field:ident),* $(,)? })? $(($($part:ident),*))? $(as { $($argument:ident $(: $value:expr)?),* $(,)? })?
            => { en: $english:literal, ko: $korean:literal $(,)? }),* $(,)?
    }
    $(handed on { $($handed:ident($kind:ty)),* $(,)? })?
    $(caused by { $($effect:ident: $cause:ident),* $(,)? })?
    ) => {
        impl $error {
            /// Templates of the sentences.
            pub const TEMPLATES: &'static [$crate::Template] = &[
                $($crate::Template {
                    group: $group,
                    message: stringify!($variant),
                    english: $english,
                    korean: $korean,
                }),*
            ];

            /// Its sentence in both languages.
            pub fn sentence(&self) -> $crate::Sentence {
                #[allow(unused_variables, clippy::allow_attributes, reason = "a sentence need not say every field")]
                match self {
                    $($error::$variant $({ $($field,)* .. })? $(($($part),*))? => $crate::Sentence::of_template(
                        &$crate::Template {
                            group: $group,
                            message: stringify!($variant),
                            english: $english,
                            korean: $korean,
                        },
                        $crate::arguments!([$($($field),*)? $($($part),*)?] [$($($argument $(: $value)?),*)?]),
                    ),)*
                    $($($error::$handed(why) => $crate::Sentence::of_argument(why),)*)?
                }
            }
        }

        $($crate::argument_names!($variant, $english, $korean, [$($($field),*)? $($($part),*)?] [$($($argument),*)?]);)*

        impl std::fmt::Display for $error {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str(&self.sentence().text($crate::Language::English))
            }
        }

        impl $crate::message::Argument for $error {
            fn said(&self, language: $crate::Language) -> Vec<$crate::message::Run> {
                self.sentence().runs(language).to_vec()
            }

            fn said_on_paper(&self, language: $crate::Language) -> Option<Vec<$crate::message::Run>> {
                $crate::message::Argument::said_on_paper(&self.sentence(), language)
            }
        }

        impl std::error::Error for $error {
            fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
                match self {
                    $($($error::$handed(why) => why.source(),)*)?
                    $($($error::$effect { $cause, .. } => Some($cause),)*)?
                    #[allow(unreachable_patterns, clippy::allow_attributes, reason = "all may be handed on")]
                    _ => None,
                }
            }
        }

        $($(impl From<$kind> for $error {
            fn from(why: $kind) -> Self {
                $error::$handed(why)
            }
        })*)?
    };
}

/// Arguments of a sentence: those listed, otherwise the fields.
#[doc(hidden)]
#[macro_export]
macro_rules! arguments {
    ([$($field:ident),*] []) => {
        vec![$($crate::message::Given::of(stringify!($field), $field)),*]
    };
    ([$($field:ident),*] [$($argument:ident $(: $value:expr)?),+]) => {
        vec![$($crate::message::Given::of(stringify!($argument), &$crate::argument!($argument $(: $value)?))),+]
    };
}

/// One argument: a field or an expression.
#[doc(hidden)]
#[macro_export]
macro_rules! argument {
    ($argument:ident) => {
        $argument
    };
    ($argument:ident : $value:expr) => {
        $value
    };
}

/// Checks at compile time that both sentences use every argument and no other.
#[doc(hidden)]
#[macro_export]
macro_rules! argument_names {
    ($variant:ident, $english:literal, $korean:literal, [$($field:ident),*] []) => {
        $crate::argument_names!(@ $variant, $english, $korean, [$($field),*]);
    };
    ($variant:ident, $english:literal, $korean:literal, [$($field:ident),*] [$($argument:ident),+]) => {
        $crate::argument_names!(@ $variant, $english, $korean, [$($argument),+]);
    };
    (@ $variant:ident, $english:literal, $korean:literal, [$($name:ident),*]) => {
        const _: () = {
            const NAMES: &[&str] = &[$(stringify!($name)),*];
            $(assert!(
                $crate::message::holds($english, stringify!($name)) && $crate::message::holds($korean, stringify!($name)),
                concat!(stringify!($variant), " leaves out ", stringify!($name))
            );)*
            assert!(
                $crate::message::knows($english, NAMES) && $crate::message::knows($korean, NAMES),
                concat!(stringify!($variant), " has a place for an argument that it does not have")
            );
            assert!(
                $crate::message::marks_well($english) && $crate::message::marks_well($korean),
                concat!(stringify!($variant), " has a mark « without its », or more than one bar between them")
            );
        };
    };
}

/// Korean sentences for errors of the library, whose `Display` is English: braces as in `format!`, particles in both forms.
macro_rules! korean_of {
    ($error:ty { $($pattern:pat => $korean:literal $(, $name:ident = $value:expr)*;)* } $(handed on $handed:pat => $why:expr;)*) => {
        impl $crate::message::Argument for $error {
            fn said(&self, language: $crate::Language) -> Vec<$crate::message::Run> {
                #[allow(unused_variables, unused_imports, clippy::allow_attributes, reason = "a sentence need not say every field")]
                let text = match (language, self) {
                    ($crate::Language::English, _) => self.to_string(),
                    $((_, $handed) => return $crate::message::Argument::said($why, language),)*
                    $((_, $pattern) => {
                        $(let $name = $value;)*
                        $crate::particles::particles(&format!($korean), None)
                    })*
                };
                vec![$crate::message::Run::Name(text)]
            }
        }
    };
}

pub(crate) use korean_of;
