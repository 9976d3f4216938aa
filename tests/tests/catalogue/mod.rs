//! `docs/diagnoses.md` is what the compiler says: the meanings are those of the enum's own documentation, the messages those
//! of the reporter, and each remedy is made and compiled. Examples stand beside this file: first in comments the variant, what to do
//! about it, and lines that are taken out and put in. Renew with
//! `UPDATE_CATALOGUE=1 cargo test -p mech-tests --test compiler catalogue`, and read it.

use mech_compiler::model::Model;
use mech_compiler::structure::Diagnosis;
use mech_compiler::syntax::Parsed;
use mech_compiler::{compile, repair, reporter, requirement};
use mech_test_support::{model, parsed};
use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::{env, fs};

const HEAD: &str = "\
# What the compiler can find wrong

Each diagnosis stands with its meaning, the smallest mechanism that has it, and what the compiler says about that. A remedy is an \
edit after which it compiles. Errors of the text itself (unknown names, bad numbers, misspelt statements) come before these \
and are not listed. This page is made and checked by `tests/tests/catalogue`.
";

/// A mechanism that is wrong, and the edit that makes it right.
struct Entry {
    /// The variant of `Diagnosis`.
    variant: String,
    /// What to do about it.
    remedy: String,
    /// What to write instead of what.
    edit: [String; 2],
    /// The text.
    example: String,
}

impl Entry {
    fn read(text: &str) -> Self {
        let with = |sign: &str| {
            let lines = text.lines().filter_map(|line| line.strip_prefix(sign));
            lines.collect::<Vec<_>>().join("\n")
        };
        let comments = with("// ");
        let (variant, remedy) = comments.split_once('\n').expect("a variant and a remedy");
        let example = text.lines().filter(|line| !line.starts_with("//"));
        Self {
            variant: variant.to_owned(),
            remedy: remedy.to_owned(),
            edit: [with("//- "), with("//+ ")],
            example: example.collect::<Vec<_>>().join("\n"),
        }
    }
}

/// All of them, by the names of their files.
fn entries() -> Vec<Entry> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/catalogue");
    let files = fs::read_dir(folder).expect("the folder");
    let mut paths: Vec<_> = files.map(|file| file.expect("a file").path()).collect();
    paths.retain(|path| path.extension().is_some_and(|end| end == "mech"));
    paths.sort_by_key(|path| path.file_stem().map(ToOwned::to_owned));
    let texts = paths.iter().map(|path| fs::read_to_string(path).expect("a text"));
    texts.map(|text| Entry::read(&text)).collect()
}

#[test]
fn every_diagnosis_is_listed() {
    let listed: BTreeSet<String> = entries().into_iter().map(|entry| entry.variant).collect();
    let variants: BTreeSet<String> = variants().into_iter().map(|(name, _)| name).collect();
    assert_eq!(listed, variants, "the examples against the enum");
}

#[test]
fn the_page_is_what_the_compiler_says() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/diagnoses.md");
    let page = page();
    if env::var_os("UPDATE_CATALOGUE").is_some() {
        fs::write(path, &page).expect("the page");
    }
    let there = fs::read_to_string(path).expect("the page").replace("\r\n", "\n");
    assert!(
        there == page,
        "docs/diagnoses.md is stale: renew it with UPDATE_CATALOGUE=1, and read what changed\n{page}"
    );
}

#[test]
fn every_remedy_mends_its_example() {
    for entry in entries() {
        let ([from, to], name) = (&entry.edit, &entry.variant);
        assert_eq!(entry.example.matches(from).count(), 1, "{name}: {from}");
        let model = model(&entry.example.replace(from, to));
        let diagnoses = diagnoses(&model);
        assert!(diagnoses.is_empty(), "{name} is not mended: {diagnoses:?}");
    }
}

fn page() -> String {
    let (mut page, entries) = (HEAD.to_owned(), entries());
    for (variant, meaning) in variants() {
        let _ = write!(page, "\n## `{variant}`\n\n{meaning}\n");
        for entry in entries.iter().filter(|entry| entry.variant == variant) {
            let (example, messages) = (&entry.example, messages(entry));
            let _ = write!(
                page,
                "\n```text\n{example}\n```\n\n```text\n{messages}\n```\n\n{} Here: {}.\n",
                entry.remedy,
                edit(&entry.edit)
            );
        }
    }
    page
}

fn edit([from, to]: &[String; 2]) -> String {
    let quoted = |text: &str| {
        let lines: Vec<String> = text.lines().map(|line| format!("`{}`", line.trim())).collect();
        lines.join(" ")
    };
    let from = quoted(from);
    if to.is_empty() {
        format!("leave {from} out")
    } else {
        format!("instead of {from} write {}", quoted(to))
    }
}

/// All that the compiler says, as it shows it.
fn messages(entry: &Entry) -> String {
    let Parsed { model, places, source, .. } = parsed(&entry.example);
    let diagnoses = diagnoses(&model);
    assert!(!diagnoses.is_empty(), "{}", entry.variant);
    let first = format!("{:?}", diagnoses[0]);
    let name = first.split([' ', '{', '(']).next();
    assert_eq!(name, Some(&entry.variant[..]), "{diagnoses:?}");
    let offers = repair::offers(&model, &source, &diagnoses);
    let messages = reporter::messages(&diagnoses, &offers, &model, &places);
    let shown = |text: &str| {
        let text = format!("error: {text}").replace('\n', "\n       ");
        let lines: Vec<&str> = text.lines().map(str::trim_end).collect();
        lines.join("\n")
    };
    let shown: Vec<String> = messages.iter().map(|message| shown(&message.text)).collect();
    shown.join("\n\n")
}

/// What is wrong with a mechanism, or with what is expected of it.
fn diagnoses(model: &Model) -> Vec<Diagnosis> {
    match compile(model) {
        Ok(compiled) => {
            let judged = requirement::judge(model, &compiled).into_iter();
            judged.filter_map(Result::err).collect()
        }
        Err(diagnoses) => diagnoses,
    }
}

/// The variants of `Diagnosis` with their documentation, as its source has them.
fn variants() -> Vec<(String, String)> {
    let source = include_str!("../../../mech-macros/compiler/src/structure/diagnosis.rs");
    let file = syn::parse_file(source).expect("the source is Rust");
    let diagnosis = file.items.into_iter().find_map(|item| match item {
        syn::Item::Enum(item) if item.ident == "Diagnosis" => Some(item),
        _ => None,
    });
    let variants = diagnosis.expect("the enum").variants;
    let variant = |variant: &syn::Variant| (variant.ident.to_string(), meaning(&variant.attrs));
    variants.iter().map(variant).collect()
}

fn meaning(attributes: &[syn::Attribute]) -> String {
    let line = |attribute: &syn::Attribute| match &attribute.meta {
        syn::Meta::NameValue(syn::MetaNameValue {
            value: syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Str(text), .. }),
            ..
        }) => Some(text.value().trim().to_owned()),
        _ => None,
    };
    let lines: Vec<String> = attributes.iter().filter_map(line).collect();
    lines.join(" ")
}
