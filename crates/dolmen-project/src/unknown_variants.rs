//! Named variants that are not in the file.

use super::content::{Project, Variant};
use super::error::Fault;
use super::wrong::{Common, WrongFile};
use dolmen_words::message::Both;
use dolmen_words::nearest;

/// Variants that studies name but that are not in the file.
pub(super) fn unknown_variants(project: &Project, variants: &[Variant]) -> Vec<Fault> {
    let known: Vec<&str> = variants.iter().map(|variant| variant.name.as_str()).collect();
    let mut faults = Vec::new();
    for study in &project.studies {
        for (i, name) in study.variants.iter().enumerate() {
            if known.contains(&name.as_str()) {
                continue;
            }
            let path = format!("study.{}.variants[{}]", study.name, i + 1);
            let span = project.spans.get(&path).cloned().unwrap_or(0..0);
            let fault = Fault::new(span, &path, WrongFile::ThereIsNoVariant(name.to_string()));
            let help: Both = match nearest(name, known.iter().copied()) {
                Some(near) => Common::DidYouMean(near.to_string()).into(),
                None => WrongFile::WriteVariantOrTake(name.to_string()).into(),
            };
            faults.push(match known.is_empty() {
                true => fault.help(help),
                false => fault.allowed(WrongFile::MustBeOneOf(known.join(", "))).help(help),
            });
        }
    }
    faults
}
