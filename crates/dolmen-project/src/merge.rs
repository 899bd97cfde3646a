//! Merges a variant into the file: tables are merged, elements of a list are patched by number, everything else is
//! replaced. Every value keeps its place in the text, so that a problem points at the line that wrote it.

use super::check::Node;
use super::error::Fault;
use super::wrong::WrongFile;
use toml::de::{DeTable, DeValue};

/// Merges `patch` into `base`; returns the parts that cannot be merged.
pub(super) fn merge<'i>(base: &mut DeTable<'i>, patch: &DeTable<'i>, path: &str) -> Vec<Fault> {
    let mut faults = Vec::new();
    for (key, value) in patch.iter() {
        let name = key.get_ref().as_ref();
        let below = match path {
            "" => name.to_owned(),
            path => format!("{path}.{name}"),
        };
        match base.get_mut(name) {
            Some(under) => faults.extend(lay(under, value, &below)),
            None => {
                base.insert(key.clone(), value.clone());
            }
        }
    }
    faults
}

fn lay<'i>(under: &mut Node<'i>, over: &Node<'i>, path: &str) -> Vec<Fault> {
    let DeValue::Table(patch) = over.get_ref() else {
        *under = over.clone();
        return Vec::new();
    };
    match under.get_mut() {
        // A quantity with a new value is a new quantity: it must not keep the old cov and unit.
        DeValue::Table(_) if patch.contains_key("value") => *under = over.clone(),
        DeValue::Table(table) => return merge(table, patch, path),
        DeValue::Array(list) => return patch_list(list, patch, path),
        _ => *under = over.clone(),
    }
    Vec::new()
}

fn patch_list<'i>(list: &mut [Node<'i>], patch: &DeTable<'i>, path: &str) -> Vec<Fault> {
    let count = list.len();
    let mut faults = Vec::new();
    for (key, value) in patch.iter() {
        let number = key
            .get_ref()
            .parse::<usize>()
            .ok()
            .and_then(|number| number.checked_sub(1));
        match number.and_then(|index| list.get_mut(index)) {
            Some(under) => faults.extend(lay(under, value, &format!("{path}[{}]", key.get_ref()))),
            None => {
                let message = WrongFile::HasNoElement {
                    path: path.to_string(),
                    key: key.get_ref().to_string(),
                };
                let allowed = WrongFile::MustBeNumberFrom(count.to_string());
                let help = WrongFile::ListIsChangedBy(path.to_string());
                faults.push(Fault::new(key.span(), path, message).allowed(allowed).help(help));
            }
        }
    }
    faults
}
