//! The page with all exhibits.

use super::{escape, graph_svg};
use crate::{Exhibit, Graphs};
use mech_compiler::graphs::{EdgeKind, Graph};
use std::fmt::Write;

const HEAD: &str = r#"<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>If it compiles, it moves</title>
<style>
:root {
  --back: #f1ece1; --card: #faf6ed; --line: #ddd5c6; --text: #2a2c39; --soft: #6d6a68; --accent: #3f74b0;
}
@media (prefers-color-scheme: dark) {
  :root { --back: #15181f; --card: #1e222c; --line: #333947; --text: #e7e4dc; --soft: #9a9fab; --accent: #86bbdd; }
}
* { box-sizing: border-box; }
body {
  margin: 0 auto; max-width: 76rem; padding: 3rem 1.25rem 5rem; background: var(--back); color: var(--text);
  font: 1.0625rem/1.6 ui-serif, Charter, "Iowan Old Style", Georgia, serif;
}
h1, h2, nav, pre, a, figcaption { font-family: ui-sans-serif, system-ui, sans-serif; }
h1 { margin: 0; font-size: clamp(1.9rem, 5vw, 3rem); line-height: 1.1; letter-spacing: -0.02em; }
header p { margin: .75rem 0 0; max-width: 44rem; color: var(--soft); }
nav { display: flex; flex-wrap: wrap; gap: .4rem; margin: 1.5rem 0 2.5rem; font-size: .875rem; }
nav a { padding: .2rem .8rem; border: 1px solid var(--line); border-radius: 2rem; background: var(--card); }
a { color: var(--accent); text-decoration: none; }
a:hover { text-decoration: underline; }
article {
  display: grid; grid-template-columns: minmax(0, 1fr) minmax(0, 1fr); margin: 0 0 2rem; overflow: hidden;
  border: 1px solid var(--line); border-radius: 1rem; background: var(--card); scroll-margin-top: 1rem;
}
figure { display: grid; place-items: center; margin: 0; padding: .5rem; background: #faf6ed; }
figure img { display: block; max-width: 100%; max-height: 40rem; height: auto; }
.text { display: flex; flex-direction: column; min-width: 0; padding: 1.5rem; border-left: 1px solid var(--line); }
h2 { margin: 0 0 .5rem; font-size: 1.375rem; line-height: 1.25; }
.text p { margin: 0 0 1rem; }
pre {
  margin: 0 0 1rem; padding: .8rem .75rem; max-height: 30rem; overflow: auto; white-space: pre-wrap; border: 1px solid var(--line);
  border-radius: .5rem; background: var(--back); font: .72rem/1.5 ui-monospace, Menlo, Consolas, monospace;
}
pre span { display: block; padding-left: 12ch; text-indent: -12ch; }
.files { font-size: .875rem; }
.graphs {
  grid-column: 1 / -1; display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 20rem), 1fr));
  border-top: 1px solid var(--line);
}
.graphs figure { align-content: space-between; padding: 1.25rem .5rem; background: none; }
figcaption { margin-top: .75rem; max-width: 28rem; font-size: .8125rem; line-height: 1.5; color: var(--soft); text-align: center; }
@media (max-width: 52rem) {
  article { grid-template-columns: minmax(0, 1fr); }
  .text { border-left: 0; border-top: 1px solid var(--line); padding: 1.25rem; }
}
%STYLE%</style>
<header>
<h1>If it compiles, it moves</h1>
<p>Planar mechanisms, declared in Rust, analysed and solved at compile time, and painted by the runtime’s own
rasteriser. Under each caption is what the compiler found out about the mechanism; below, its
links with the joints between them, and its loops in the order in which they are solved.</p>
</header>
"#;

/// The page of the studio, beside the folder of the gallery.
pub(crate) const STUDIO: &str = "page/index.html";

/// The page with these exhibits. It refers to the pictures beside it, and to the page of the studio, if there is one.
pub(crate) fn page<'a>(
    exhibits: impl Iterator<Item = &'a dyn Exhibit>,
    has_studio: bool,
) -> String {
    let (mut entries, mut articles) = (String::new(), String::new());
    for exhibit in exhibits {
        let [slug, title, caption, report] = [
            exhibit.slug(),
            exhibit.title(),
            exhibit.caption().trim(),
            exhibit.report().trim_end(),
        ]
        .map(escape);
        let moving = moving_file(exhibit.slug());
        let report: Vec<_> = report.lines().map(|line| format!("<span>{line}</span>")).collect();
        let report = report.concat();
        let graphs = exhibit.graphs().map_or(String::new(), |graphs| graphs_of(&slug, &graphs));
        let studio = exhibit.file().map_or(String::new(), |file| studio_of(file, has_studio));
        // Writing to a `String` cannot fail.
        let _ = writeln!(entries, "<a href=\"#{slug}\">{title}</a>");
        let _ = write!(
            articles,
            r#"<article id="{slug}">
<figure><picture>
<source srcset="{slug}.svg" media="(prefers-reduced-motion: reduce)">
<img src="{moving}" alt="{title}, moving" loading="lazy">
</picture></figure>
<div class="text">
<h2>{title}</h2>
<p>{caption}</p>
<pre>{report}</pre>
<p class="files">Still: <a href="{slug}.png">PNG</a>, <a href="{slug}.svg">SVG</a>. In motion: <a
href="{slug}.gif">GIF</a>, <a href="{moving}">SVG</a>.{studio}</p>
</div>
{graphs}</article>
"#
        );
    }
    let head = HEAD.replace("%STYLE%", graph_svg::STYLE);
    format!("{head}<nav>\n{entries}</nav>\n<main>\n{articles}</main>\n</html>\n")
}

/// The way to the studio, which opens a file of the gallery: its page, if that was built, or its command.
fn studio_of(file: &str, has_studio: bool) -> String {
    let file = escape(file);
    if has_studio {
        format!(" <a\nhref=\"../{STUDIO}?file={file}\">Open in the studio</a>.")
    } else {
        format!(
            " In the studio:\n<code>cargo mech edit examples/gallery/src/mechanisms/{file}</code>."
        )
    }
}

/// The name of the SVG of an exhibit that moves.
pub(crate) fn moving_file(slug: &str) -> String {
    format!("{slug}-moving.svg")
}

/// The names of the files that hold the graphs of an exhibit.
pub(crate) fn graph_files(slug: &str) -> [String; 2] {
    ["links", "loops"].map(|what| format!("{slug}-{what}.dot"))
}

/// Both graphs, side by side where there is room.
fn graphs_of(slug: &str, Graphs { links, loops }: &Graphs) -> String {
    let [links_file, loops_file] = graph_files(slug);
    let links_caption = links_caption(links);
    let loops_caption = "The loops, in rows by level, each with its unknown joints; arrows lead from what has to be known";
    let mut text = "<div class=\"graphs\">\n".to_owned();
    for (graph, caption, file) in
        [(links, links_caption.as_str(), links_file), (loops, loops_caption, loops_file)]
    {
        if graph.vertices.is_empty() {
            continue;
        }
        let link = format!("<a href=\"{file}\">DOT</a>");
        let svg = graph_svg::svg(graph).unwrap_or_else(|| {
            let count = graph.vertices.len();
            format!("<p>{count} are too many for a picture.</p>\n")
        });
        let _ = write!(
            text,
            "<figure>\n{svg}<figcaption>{caption} ({link}).</figcaption>\n</figure>\n"
        );
    }
    text + "</div>\n"
}

/// The explanation of the graphs.
fn links_caption(links: &Graph) -> String {
    let mut caption =
        "The links, and the joints between them: revolutes where nothing else is said".to_owned();
    if links.edges.iter().any(|edge| edge.motor) {
        caption += "; bold: a motor";
    }
    if links.edges.iter().any(|edge| edge.kind == EdgeKind::Arm) {
        caption += "; dashed: an arm";
    }
    caption
}
