//! Lists the names that each file of a crate takes from other files, by reading the source with `syn`.
//!
//! A path leads to the file that defines the item, not to one that re-exports it. Declaring `mod x;` is not an import; items under
//! `#[cfg(test)]` are left out.

use std::collections::{BTreeMap, BTreeSet};

use syn::buffer::Cursor;
use syn::parse::ParseStream;
use syn::visit::Visit;
use syn::{Attribute, Item, UseTree, Visibility};

/// Source text of each file of a crate, by its path in the folder `src`.
pub(crate) type Sources = BTreeMap<String, String>;
/// Names that the first file takes from the second.
pub(crate) type Imports = BTreeMap<(String, String), BTreeSet<String>>;

/// A module: the root, a file, or a `mod` with its body in a file.
#[derive(Default)]
struct Module {
    file: String,
    parent: usize,
    children: BTreeMap<String, usize>,
    /// Items that the module itself defines.
    items: BTreeSet<String>,
    macros: BTreeSet<String>,
    uses: Vec<Use>,
    /// Every path in its code, without `use` trees.
    paths: BTreeSet<Vec<String>>,
    /// Single names; they count only if a glob import may provide them.
    words: BTreeSet<String>,
    called_macros: BTreeSet<String>,
}

/// One leaf of a `use` tree. `name` is `None` for a glob and for `as _`.
struct Use {
    path: Vec<String>,
    name: Option<String>,
    glob: bool,
    hands_on: bool,
}

/// The target of a path.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Target {
    Module(usize),
    Item { file: String, name: String },
}

#[derive(Default)]
struct Tree {
    modules: Vec<Module>,
    left_out: Vec<String>,
}

/// Whether an item has an attribute that limits it to tests.
fn only_for_tests(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| {
        attribute.path().is_ident("cfg")
            && attribute
                .meta
                .require_list()
                .is_ok_and(|list| list.tokens.to_string() == "test")
    })
}

fn attributes(item: &Item) -> &[Attribute] {
    match item {
        Item::Const(i) => &i.attrs,
        Item::Enum(i) => &i.attrs,
        Item::Fn(i) => &i.attrs,
        Item::Impl(i) => &i.attrs,
        Item::Macro(i) => &i.attrs,
        Item::Mod(i) => &i.attrs,
        Item::Static(i) => &i.attrs,
        Item::Struct(i) => &i.attrs,
        Item::Trait(i) => &i.attrs,
        Item::Type(i) => &i.attrs,
        Item::Use(i) => &i.attrs,
        _ => &[],
    }
}

fn defined(item: &Item) -> Option<String> {
    let ident = match item {
        Item::Const(i) => &i.ident,
        Item::Enum(i) => &i.ident,
        Item::Fn(i) => &i.sig.ident,
        Item::Static(i) => &i.ident,
        Item::Struct(i) => &i.ident,
        Item::Trait(i) => &i.ident,
        Item::Type(i) => &i.ident,
        Item::Macro(i) => i.ident.as_ref()?,
        _ => return None,
    };
    Some(ident.to_string())
}

/// Reads the code of one module into the tree.
struct Reader<'a> {
    sources: &'a Sources,
    tree: &'a mut Tree,
    module: usize,
    /// Folder of the module's children, ending in a slash.
    folder: String,
    /// Nesting depth within functions, whose items do not belong to the module.
    depth: usize,
}

impl Reader<'_> {
    fn here(&mut self) -> &mut Module {
        &mut self.tree.modules[self.module]
    }

    fn note_path(&mut self, path: Vec<String>) {
        match path.len() {
            0 => {}
            1 => {
                self.here().words.extend(path);
            }
            _ => {
                self.here().paths.insert(path);
            }
        }
    }

    fn add_uses(&mut self, tree: &UseTree, before: &[String], hands_on: bool) {
        let with = |last: &syn::Ident| {
            let mut path = before.to_vec();
            if last != "self" || path.is_empty() {
                path.push(last.to_string());
            }
            path
        };
        let (path, name, glob) = match tree {
            UseTree::Path(p) => return self.add_uses(&p.tree, &with(&p.ident), hands_on),
            UseTree::Group(group) => {
                for tree in &group.items {
                    self.add_uses(tree, before, hands_on);
                }
                return;
            }
            UseTree::Name(n) => (with(&n.ident), with(&n.ident).last().cloned(), false),
            UseTree::Rename(r) => (
                with(&r.ident),
                Some(r.rename.to_string()).filter(|r| r != "_"),
                false,
            ),
            _ => (before.to_vec(), None, true),
        };
        self.here().uses.push(Use {
            path,
            name,
            glob,
            hands_on,
        });
    }

    fn add_module(&mut self, item: &syn::ItemMod) {
        let name = item.ident.to_string();
        let beside = format!("{}{name}.rs", self.folder);
        let inside = format!("{}{name}/mod.rs", self.folder);
        let folder = format!("{}{name}/", self.folder);
        let file = match &item.content {
            Some(_) => self.here().file.clone(),
            None if self.sources.contains_key(&beside) => beside,
            None => inside,
        };
        let module = self.tree.modules.len();
        self.tree.modules.push(Module {
            file: file.clone(),
            parent: self.module,
            ..Module::default()
        });
        self.here().children.insert(name, module);
        if let Some((_, items)) = &item.content {
            let mut reader = Reader {
                sources: self.sources,
                tree: self.tree,
                module,
                folder,
                depth: 0,
            };
            items.iter().for_each(|item| reader.visit_item(item));
        } else {
            read_file(self.sources, self.tree, module, folder);
        }
    }
}

impl<'ast> Visit<'ast> for Reader<'_> {
    fn visit_item(&mut self, item: &'ast Item) {
        if only_for_tests(attributes(item)) {
            if let Item::Mod(item) = item {
                let file = format!("{}{}", self.folder, item.ident);
                self.tree.left_out.push(file);
            }
            return;
        }
        if self.depth == 0
            && let Some(name) = defined(item)
        {
            if matches!(item, Item::Macro(_)) {
                self.here().macros.insert(name.clone());
            }
            self.here().items.insert(name);
        }
        if let Item::Mod(item) = item {
            return self.add_module(item);
        }
        self.depth += 1;
        syn::visit::visit_item(self, item);
        self.depth -= 1;
    }

    fn visit_impl_item_fn(&mut self, function: &'ast syn::ImplItemFn) {
        if !only_for_tests(&function.attrs) {
            syn::visit::visit_impl_item_fn(self, function);
        }
    }

    fn visit_item_use(&mut self, item: &'ast syn::ItemUse) {
        if item.leading_colon.is_none() {
            let hands_on = !matches!(item.vis, Visibility::Inherited);
            self.add_uses(&item.tree, &[], hands_on);
        }
    }

    /// `pub(super)` and similar name no item.
    fn visit_visibility(&mut self, _: &'ast Visibility) {}

    fn visit_path(&mut self, path: &'ast syn::Path) {
        if path.leading_colon.is_none() {
            self.note_path(path.segments.iter().map(|s| s.ident.to_string()).collect());
        }
        syn::visit::visit_path(self, path);
    }

    fn visit_macro(&mut self, called: &'ast syn::Macro) {
        if let Some(name) = called.path.get_ident() {
            self.here().called_macros.insert(name.to_string());
        }
        self.visit_path(&called.path);
        let mut paths = Vec::new();
        let read = called.parse_body_with(|input: ParseStream| {
            input.step(|cursor| {
                paths_of_tokens(*cursor, &mut paths);
                Ok(((), end(*cursor)))
            })
        });
        read.unwrap();
        paths.into_iter().for_each(|path| self.note_path(path));
    }

    fn visit_meta_list(&mut self, list: &'ast syn::MetaList) {
        let mut paths = Vec::new();
        let read = list.parse_args_with(|input: ParseStream| {
            input.step(|cursor| {
                paths_of_tokens(*cursor, &mut paths);
                Ok(((), end(*cursor)))
            })
        });
        read.unwrap();
        paths.into_iter().for_each(|path| self.note_path(path));
    }
}

/// The name after a `::`, and the tokens after it.
fn after_colons(cursor: Cursor) -> Option<(syn::Ident, Cursor)> {
    let (first, rest) = cursor.punct()?;
    let (second, rest) = rest.punct()?;
    rest.ident()
        .filter(|_| first.as_char() == ':' && second.as_char() == ':')
}

fn end(mut cursor: Cursor) -> Cursor {
    while let Some((_, rest)) = cursor.token_tree() {
        cursor = rest;
    }
    cursor
}

/// Every `a::b::c` and every single name in the tokens of a macro, except fields and methods.
fn paths_of_tokens(mut cursor: Cursor, paths: &mut Vec<Vec<String>>) {
    let mut after_point = false;
    while !cursor.eof() {
        if let Some((word, mut rest)) = cursor.ident() {
            let mut path = vec![word.to_string()];
            while let Some((word, behind)) = after_colons(rest) {
                path.push(word.to_string());
                rest = behind;
            }
            if !after_point {
                paths.push(path);
            }
            (cursor, after_point) = (rest, false);
        } else if let Some((inside, _, _, rest)) = cursor.any_group() {
            paths_of_tokens(inside, paths);
            (cursor, after_point) = (rest, false);
        } else if let Some((_, rest)) = cursor.token_tree() {
            after_point = cursor.punct().is_some_and(|(p, _)| p.as_char() == '.');
            cursor = rest;
        }
    }
}

fn read_file(sources: &Sources, tree: &mut Tree, module: usize, folder: String) {
    let file = tree.modules[module].file.clone();
    let text = sources
        .get(&file)
        .unwrap_or_else(|| panic!("{file} is declared by a `mod` and is not there"));
    let parsed = syn::parse_file(text).unwrap_or_else(|error| panic!("{file}: {error}"));
    let mut reader = Reader {
        sources,
        tree,
        module,
        folder,
        depth: 0,
    };
    parsed.items.iter().for_each(|item| reader.visit_item(item));
}

impl Tree {
    fn of(sources: &Sources) -> Tree {
        let mut tree = Tree::default();
        for file in sources
            .keys()
            .filter(|f| matches!(f.as_str(), "lib.rs" | "main.rs"))
        {
            let module = tree.modules.len();
            tree.modules.push(Module {
                file: file.clone(),
                parent: module,
                ..Module::default()
            });
            read_file(sources, &mut tree, module, String::new());
        }
        for file in sources.keys() {
            let read = tree.modules.iter().any(|module| &module.file == file);
            let left_out = tree.left_out.iter().any(|start| {
                file.strip_prefix(start)
                    .is_some_and(|r| r.starts_with(['.', '/']))
            });
            assert!(read || left_out, "no `mod` declares {file}");
        }
        tree
    }

    fn crate_root(&self, module: usize) -> usize {
        match self.modules[module].parent {
            parent if parent == module => module,
            parent => self.crate_root(parent),
        }
    }

    /// The meaning of a name in a module: a child module, an own item, or an import; a name may be both a module and a function. `open`
    /// holds the `use`s (module, place) being resolved, so that none refers to itself.
    fn meaning(&self, module: usize, name: &str, open: &mut Vec<(usize, usize)>) -> BTreeSet<Target> {
        let here = &self.modules[module];
        let mut found = BTreeSet::new();
        found.extend(here.children.get(name).map(|child| Target::Module(*child)));
        found.extend(here.items.get(name).map(|name| Target::Item {
            file: here.file.clone(),
            name: name.clone(),
        }));
        for (place, import) in here.uses.iter().enumerate() {
            if import.name.as_deref() == Some(name) && !open.contains(&(module, place)) {
                open.push((module, place));
                found.extend(self.resolve(module, &import.path, open));
                open.pop();
            }
        }
        if found.is_empty() {
            found = self.through_globs(module, name, open);
        }
        found
    }

    fn through_globs(&self, module: usize, name: &str, open: &mut Vec<(usize, usize)>) -> BTreeSet<Target> {
        let mut found = BTreeSet::new();
        for (place, import) in self.modules[module].uses.iter().enumerate() {
            if !import.glob || open.contains(&(module, place)) {
                continue;
            }
            open.push((module, place));
            for target in self.resolve(module, &import.path, open) {
                if let Target::Module(source) = target {
                    found.extend(self.meaning(source, name, open));
                }
            }
            open.pop();
        }
        found
    }

    /// The target of a path in a module; empty for a path into another crate.
    fn resolve(&self, module: usize, path: &[String], open: &mut Vec<(usize, usize)>) -> BTreeSet<Target> {
        let Some(first) = path.first() else {
            return BTreeSet::new();
        };
        let mut at = match first.as_str() {
            "crate" => BTreeSet::from([Target::Module(self.crate_root(module))]),
            "self" => BTreeSet::from([Target::Module(module)]),
            "super" => BTreeSet::from([Target::Module(self.modules[module].parent)]),
            name => self.meaning(module, name, open),
        };
        for name in &path[1..] {
            let mut next = BTreeSet::new();
            for target in &at {
                if let Target::Module(source) = target {
                    match name.as_str() {
                        "super" => {
                            next.insert(Target::Module(self.modules[*source].parent));
                        }
                        name => next.extend(self.meaning(*source, name, open)),
                    }
                }
            }
            if next.is_empty() {
                // the rest names a variant or a function of the type
                at.retain(|target| matches!(target, Target::Item { .. }));
                return at;
            }
            at = next;
        }
        at
    }

    /// The names that each file takes from each other file.
    fn imports(&self) -> Imports {
        let mut imports = Imports::new();
        for (index, module) in self.modules.iter().enumerate() {
            let mut add = |targets: BTreeSet<Target>| {
                for target in targets {
                    if let Target::Item { file, name } = target
                        && file != module.file
                    {
                        let names = imports.entry((module.file.clone(), file)).or_default();
                        names.insert(name);
                    }
                }
            };
            for import in &module.uses {
                let targets = self.resolve(index, &import.path, &mut Vec::new());
                if import.glob && import.hands_on {
                    for target in &targets {
                        if let Target::Module(source) = target {
                            let whole = &self.modules[*source];
                            let handed = whole.uses.iter().filter_map(|u| u.name.as_ref());
                            for name in whole.items.iter().chain(handed) {
                                add(self.meaning(*source, name, &mut Vec::new()));
                            }
                        }
                    }
                }
                add(targets);
            }
            for path in &module.paths {
                add(self.resolve(index, path, &mut Vec::new()));
            }
            if module.uses.iter().any(|u| u.glob) {
                let known = |word: &&String| {
                    !module.items.contains(*word) && module.uses.iter().all(|u| u.name.as_ref() != Some(word))
                };
                for word in module.words.iter().filter(known) {
                    add(self.through_globs(index, word, &mut Vec::new()));
                }
            }
            for name in &module.called_macros {
                add(self.macro_above(index, name));
            }
        }
        imports
    }

    /// A `macro_rules!` is visible in the modules declared below it without an import.
    fn macro_above(&self, module: usize, name: &str) -> BTreeSet<Target> {
        let here = &self.modules[module];
        if here.macros.contains(name) {
            let (file, name) = (here.file.clone(), name.to_owned());
            return BTreeSet::from([Target::Item { file, name }]);
        }
        if here.parent == module {
            return BTreeSet::new();
        }
        self.macro_above(here.parent, name)
    }
}

/// The names that each file takes from each other file.
pub(crate) fn imports(sources: &Sources) -> Imports {
    Tree::of(sources).imports()
}
