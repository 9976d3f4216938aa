//! No file takes a name from another that takes one from it, nor by way of others. So whoever reads a file can begin at those that it takes
//! names from.
//!
//! What a file takes is what it names by a path. A name leads to the file in which it is declared, whatever re-exports it passes. Of the
//! modules that it stands in, a file may take whatever these declare: a folder is read from its `mod.rs`.

use proc_macro2::{TokenStream, TokenTree};
use quote::ToTokens;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use syn::{Item, UseTree, Visibility};

/// The crates, by the files in which they begin.
const CRATES: [&str; 14] = [
    "mech-macros/src/lib.rs",
    "mech-macros/compiler/src/lib.rs",
    "mech-runtime/src/lib.rs",
    "mech-runtime/core/src/lib.rs",
    "studio/src/lib.rs",
    "studio/page/src/lib.rs",
    "tools/src/bin/accuracy/main.rs",
    "tools/src/bin/effects/main.rs",
    "tools/notice/src/main.rs",
    "tests/fuzz/src/main.rs",
    "tests/support/src/lib.rs",
    "tests/conformance/host/src/lib.rs",
    "examples/gallery/src/lib.rs",
    "examples/gallery/src/main.rs",
];

/// The names of a path, from the first.
type Names = Vec<String>;

/// For each file those that it takes names from, and which.
type Arrows<'a> = BTreeMap<&'a Path, BTreeMap<&'a Path, BTreeSet<&'a str>>>;

/// A module, and what it says.
#[derive(Default)]
struct Module {
    file: PathBuf,
    declared: BTreeSet<String>,
    /// The paths that are taken over by `use`, by the names that they have here.
    used: BTreeMap<String, Names>,
    /// Modules all of whose names are taken over.
    globs: Vec<Names>,
    /// What it names: what it uses for itself, and every path in its code.
    named: BTreeSet<Names>,
}

/// The modules of a crate by their paths.
#[derive(Default)]
struct Modules(BTreeMap<Names, Module>);

impl Modules {
    /// Reads a file, and those of the modules that it declares.
    fn read(&mut self, file: &Path, folder: &Path, path: &Names) {
        let text =
            fs::read_to_string(file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
        let items = syn::parse_file(&text)
            .unwrap_or_else(|error| panic!("{}: {error}", file.display()))
            .items;
        self.add(items, file, folder, path);
    }

    fn add(&mut self, items: Vec<Item>, file: &Path, folder: &Path, path: &Names) {
        let mut module = Module { file: file.to_owned(), ..Module::default() };
        for item in items {
            match item {
                Item::Mod(inner) if is_for_tests(&inner.attrs) => {}
                Item::Mod(inner) => {
                    let name = inner.ident.to_string();
                    let below = folder.join(&name);
                    let path = [path.as_slice(), std::slice::from_ref(&name)].concat();
                    if let Some((_, items)) = inner.content {
                        self.add(items, file, &below, &path);
                        continue;
                    }
                    let beside = folder.join(format!("{name}.rs"));
                    let inside = below.join("mod.rs");
                    let file = if beside.exists() { beside } else { inside };
                    self.read(&file, &below, &path);
                }
                Item::Use(item) => {
                    let is_own = matches!(item.vis, Visibility::Inherited);
                    module.take(&item.tree, &mut Vec::new(), is_own);
                }
                item => {
                    module.declared.extend(name_of(&item));
                    module.name_all(item.to_token_stream());
                }
            }
        }
        self.0.insert(path.clone(), module);
    }

    /// The file in which something is declared that a module names; none if it is of another crate, or a local name.
    fn file_of(&self, module: &Names, names: &[String], depth: usize) -> Option<&Path> {
        let (first, rest) = names.split_first()?;
        let child = [module.as_slice(), std::slice::from_ref(first)].concat();
        let inside = |module: &Names| match rest {
            [] => Some(self.0.get(module)?.file.as_path()),
            _ => self.file_of(module, rest, depth),
        };
        let parent = || module[..module.len().saturating_sub(1)].to_vec();
        match first.as_str() {
            "crate" => return inside(&Vec::new()),
            "self" => return inside(module),
            "super" => return inside(&parent()),
            _ if self.0.contains_key(&child) => return inside(&child),
            _ => {}
        }
        let here = self.0.get(module)?;
        if here.declared.contains(first) {
            return Some(&here.file);
        }
        if depth > 20 {
            return None;
        }
        let all = |path: &Names| [path.as_slice(), rest].concat();
        if let Some(path) = here.used.get(first).filter(|path| *path != names) {
            return self.file_of(module, &all(path), depth + 1);
        }
        let mut globs = here.globs.iter();
        globs.find_map(|glob| self.file_of(module, &[glob.as_slice(), names].concat(), depth + 1))
    }

    /// Whether a file is that of a module, or of one that it stands in.
    fn is_above(&self, file: &Path, module: &Names) -> bool {
        let above = (0..=module.len()).filter_map(|length| self.0.get(&module[..length]));
        above.into_iter().any(|module| module.file == file)
    }

    /// For each file those that it takes names from, and which.
    fn arrows(&self) -> Arrows<'_> {
        let mut arrows = Arrows::new();
        for (path, module) in &self.0 {
            let from = arrows.entry(&module.file).or_default();
            for names in &module.named {
                let file = self.file_of(path, names, 0);
                if let Some(file) = file.filter(|file| !self.is_above(file, path)) {
                    from.entry(file).or_default().extend(names.last().map(String::as_str));
                }
            }
        }
        arrows
    }
}

impl Module {
    /// Notes what is used. What is only passed on is not taken for oneself.
    fn take(&mut self, tree: &UseTree, before: &mut Names, is_own: bool) {
        let mut note = |name: String, path: Names| {
            if is_own {
                self.named.insert(path.clone());
            }
            self.used.insert(name, path);
        };
        match tree {
            UseTree::Path(path) => {
                before.push(path.ident.to_string());
                self.take(&path.tree, before, is_own);
                before.pop();
            }
            UseTree::Group(group) => {
                group.items.iter().for_each(|tree| self.take(tree, before, is_own));
            }
            UseTree::Glob(_) => self.globs.push(before.clone()),
            UseTree::Name(name) if name.ident == "self" => {
                note(before.last().cloned().unwrap_or_default(), before.clone());
            }
            UseTree::Name(name) => {
                let name = name.ident.to_string();
                note(name.clone(), [before.as_slice(), &[name]].concat());
            }
            UseTree::Rename(name) => {
                let path = [before.as_slice(), &[name.ident.to_string()]].concat();
                note(name.rename.to_string(), path);
            }
        }
    }

    /// Notes every path in the tokens.
    fn name_all(&mut self, tokens: TokenStream) {
        let mut path = Names::new();
        let mut colons = 0;
        for token in tokens {
            match token {
                TokenTree::Ident(word) => {
                    if colons != 2 {
                        self.named.insert(std::mem::take(&mut path));
                    }
                    path.push(word.to_string());
                    colons = 0;
                }
                TokenTree::Punct(mark) if mark.as_char() == ':' => colons += 1,
                other => {
                    self.named.insert(std::mem::take(&mut path));
                    colons = 0;
                    if let TokenTree::Group(group) = other {
                        self.name_all(group.stream());
                    }
                }
            }
        }
        self.named.insert(path);
    }
}

fn is_for_tests(attributes: &[syn::Attribute]) -> bool {
    attributes.iter().any(|one| one.to_token_stream().to_string() == "# [cfg (test)]")
}

fn name_of(item: &Item) -> Option<String> {
    let name = match item {
        Item::Const(item) => &item.ident,
        Item::Enum(item) => &item.ident,
        Item::Fn(item) => &item.sig.ident,
        Item::Static(item) => &item.ident,
        Item::Struct(item) => &item.ident,
        Item::Trait(item) => &item.ident,
        Item::Type(item) => &item.ident,
        Item::Macro(item) => item.ident.as_ref()?,
        _ => return None,
    };
    Some(name.to_string())
}

/// All files to which arrows lead from one.
fn reached<'a>(arrows: &Arrows<'a>, from: &'a Path) -> BTreeSet<&'a Path> {
    let mut found = BTreeSet::new();
    let mut open = vec![from];
    while let Some(file) = open.pop() {
        let next = arrows.get(file).into_iter().flat_map(BTreeMap::keys);
        open.extend(next.filter(|file| found.insert(**file)));
    }
    found
}

/// The arrows of each circle, in words.
fn circles(arrows: &Arrows, root: &Path) -> BTreeSet<String> {
    let reach: BTreeMap<&Path, _> =
        arrows.keys().map(|file| (*file, reached(arrows, file))).collect();
    let is_tied = |one: &Path, other: &Path| {
        let leads = |one: &Path, other: &Path| reach.get(one).is_some_and(|to| to.contains(other));
        leads(one, other) && leads(other, one)
    };
    let name = |file: &Path| file.strip_prefix(root).unwrap_or(file).display().to_string();
    let circle = |from: &Path| {
        let members = arrows.iter().filter(|(file, _)| is_tied(from, file));
        let lines = members.flat_map(|(file, to)| {
            let inside = to.iter().filter(|(other, _)| is_tied(from, other));
            inside.map(move |(other, names)| {
                format!("{} -> {}: {names:?}\n", name(file), name(other))
            })
        });
        lines.collect::<String>()
    };
    arrows.keys().map(|file| circle(file)).filter(|lines| !lines.is_empty()).collect()
}

#[test]
fn no_file_is_in_a_circle() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut found = BTreeSet::new();
    for begin in CRATES {
        let file = root.join(begin);
        let mut modules = Modules::default();
        modules.read(&file, file.parent().expect("a folder"), &Vec::new());
        let arrows = modules.arrows();
        assert!(
            arrows.len() == 1 || arrows.values().any(|to| !to.is_empty()),
            "{begin}: no arrows"
        );
        found.extend(circles(&arrows, &root));
    }
    let lines: Vec<String> = found.iter().cloned().collect();
    assert!(found.is_empty(), "{} circles:\n{}", found.len(), lines.join("\n"));
}
