//! The gallery with a mechanism written by hand.

mod four_bar;

use four_bar::FourBar;
use mech_gallery::{
    Curator, Easel, Error, Exhibit, FRAMES, Picture, Showcase, Swatches, animation,
};
use mech_runtime::files::FileError;
use mech_runtime::{Mechanism, Smooth, View};
use std::f64::consts::TAU;
use std::path::{Path, PathBuf};
use std::{fs, io, thread};

fn showcase() -> Showcase<FourBar> {
    Showcase {
        slug: "four-bar",
        title: "Four bars & a <rocker>",
        caption: "A crank turns, a rocker rocks, and the coupler between them draws a curve that no compass can draw.",
        file: None,
        source: "",
        move_to: FourBar::move_to,
        paint: |mechanism, scene| mechanism.draw(scene),
        motion: |phase| [phase * TAU],
        frames: FRAMES,
        still: 0.15,
    }
}

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join(name)
}

fn pictures(showcase: &Showcase<FourBar>) -> Vec<Picture> {
    let film = showcase.film().expect("it turns");
    let mut easel = Easel::for_film(&film).expect("it is seen");
    film.scenes().iter().map(|scene| easel.paint(scene)).collect()
}

/// All frames of a GIF as they are seen, and its number of repetitions.
fn decode(bytes: &[u8]) -> (Vec<Picture>, gif::Repeat) {
    let mut decoder = gif::DecodeOptions::new().read_info(bytes).expect("a GIF");
    let table = decoder.global_palette().expect("one table for all").to_vec();
    let (table, _) = table.as_chunks::<3>();
    let [width, height] = [decoder.width(), decoder.height()];
    let mut pixels = vec![[0; 4]; usize::from(width) * usize::from(height)];
    let mut pictures = Vec::new();
    while let Some(frame) = decoder.read_next_frame().expect("a frame") {
        assert_eq!((frame.palette.as_ref(), frame.delay), (None, 3));
        let rows = pixels.chunks_mut(width.into()).skip(frame.top.into());
        for (row, new) in rows.zip(frame.buffer.chunks(frame.width.into())) {
            for (pixel, &new) in row.iter_mut().skip(frame.left.into()).zip(new) {
                if frame.transparent != Some(new) {
                    let [red, green, blue] = table[usize::from(new)];
                    *pixel = [red, green, blue, 255];
                }
            }
        }
        pictures.push(Picture { width, height, pixels: pixels.clone() });
    }
    (pictures, decoder.repeat())
}

#[test]
fn files_and_page() {
    let folder = folder("files-and-page");
    let curator = Curator::new(vec![Box::new(showcase())], folder.clone());
    curator.serve([]).expect("all goes well");

    let page = fs::read_to_string(folder.join("index.html")).expect("a page");
    assert!(page.contains("Four bars &amp; a &lt;rocker&gt;"));
    assert!(page.contains("closed form &lt;RRR&gt; &amp; &quot;exact&quot;"));
    for file in [
        "src=\"four-bar-moving.svg",
        "href=\"four-bar.gif",
        "href=\"four-bar.png",
        "href=\"four-bar.svg",
    ] {
        assert!(page.contains(file), "{file}");
    }
    assert!(!page.contains("http") && !page.contains("//"));
    // Written by hand, it has no declaration to find graphs in, nor one for the studio.
    assert!(!page.contains("<svg") && !page.contains("studio"));

    let still = fs::read_to_string(folder.join("four-bar.svg")).expect("an SVG");
    assert!(still.contains("<title>Four bars &amp; a &lt;rocker&gt;</title>"));
    let moving = fs::read_to_string(folder.join("four-bar-moving.svg")).expect("an SVG");
    assert!(moving.contains(".move{animation:linear 2.7s infinite}"));
    for element in ["<circle", "<polygon"] {
        assert_eq!(moving.matches(element).count(), still.matches(element).count());
    }

    let painted = pictures(&showcase());
    let png = io::Cursor::new(fs::read(folder.join("four-bar.png")).expect("a PNG"));
    let mut reader = png::Decoder::new(png).read_info().expect("a PNG");
    let mut still = vec![0; reader.output_buffer_size().expect("a size")];
    reader.next_frame(&mut still).expect("its pixels");
    let colors = painted[13].pixels.iter();
    let colors = colors.flat_map(|&[red, green, blue, _]| [red, green, blue]);
    assert!(still.into_iter().eq(colors));

    let gif = fs::read(folder.join("four-bar.gif")).expect("a GIF");
    assert!(gif.len() < 1_500_000, "{} bytes", gif.len());
    let (seen, repeat) = decode(&gif);
    assert_eq!((seen.len(), repeat), (FRAMES, gif::Repeat::Infinite));
    for (seen, painted) in seen.iter().zip(&painted) {
        assert_eq!((seen.width, seen.height), (painted.width, painted.height));
        for (seen, painted) in seen.pixels.iter().zip(&painted.pixels) {
            let far = seen.iter().zip(painted).any(|(seen, painted)| seen.abs_diff(*painted) > 16);
            assert!(!far, "{painted:?} is seen as {seen:?}");
        }
    }
}

#[test]
fn graphs_hang_below() {
    let source = "
        mechanism! { pub struct Other; }
        mechanism! {
            pub struct FourBar;
            link crank; link coupler; link rocker;
            joint a = revolute(ground, crank) at (0, 0);
            joint b = revolute(crank, coupler) at (0, 1);
            joint c = revolute(coupler, rocker) at (3, 2);
            joint d = revolute(rocker, ground) at (3, 0);
            motor a;
        }";
    let folder = folder("graphs").join("gallery");
    let studio = folder.join("../page/index.html");
    let showcase = Showcase { file: Some("four_bar.rs"), source, frames: 2, ..showcase() };
    let curator = Curator::new(vec![Box::new(showcase)], folder.clone());
    let page = || {
        curator.serve([]).expect("all goes well");
        fs::read_to_string(folder.join("index.html")).expect("a page")
    };
    // No link leads to a page that was not built.
    assert!(page().contains("cargo mech edit examples/gallery/src/mechanisms/four_bar.rs"));
    fs::create_dir_all(studio.parent().expect("its folder")).expect("a folder");
    fs::write(&studio, "").expect("a page");
    let page = page();
    fs::remove_file(&studio).expect("it is there");
    assert_eq!(page.matches("<svg").count(), 2);
    assert!(page.contains(">coupler</text>") && page.contains(">loop 1</text>"));
    assert!(page.contains(r#"href="four-bar-links.dot""#));
    assert!(page.contains(r#"href="../page/index.html?file=four_bar.rs""#));
    let links = fs::read_to_string(folder.join("four-bar-links.dot")).expect("a graph");
    assert!(links.contains(r#"n0 -- n1 [label="a\nrevolute\nmotor", style=bold];"#));
    let loops = fs::read_to_string(folder.join("four-bar-loops.dot")).expect("a graph");
    assert!(loops.contains(r#"[label="loop 1\nb c d"]"#));
}

#[test]
fn strips_do_not_show() {
    // The same as the easel does, but all at once: in a picture too large for the stack of a test.
    const WIDTH: usize = 640;
    const HEIGHT: usize = 520;
    let at_once = || {
        let film = showcase().film().expect("it turns");
        let [low, high] = film.bounds().expect("it is seen");
        let mut whole = Smooth::<WIDTH, HEIGHT>::new();
        whole.look_at(View::fit(low, high, WIDTH, HEIGHT, 24.0));
        film.scenes()[33].draw(&mut whole);
        whole.pixels().as_flattened().to_vec()
    };
    let painter = thread::Builder::new().stack_size(1 << 26);
    let at_once = painter.spawn(at_once).expect("a thread").join();

    let film = showcase().film().expect("it turns");
    let mut easel = Easel::for_film(&film).expect("it is seen");
    let picture = easel.paint(&film.scenes()[33]);
    let size = [picture.width, picture.height].map(usize::from);
    assert_eq!(size, [WIDTH, HEIGHT]);
    for (one, other) in picture.pixels.iter().zip(at_once.expect("painted")) {
        // Places are rounded where they are: a pixel may be covered by one part in 255 more.
        let far = one.iter().zip(other).any(|(one, other)| one.abs_diff(other) > 2);
        assert!(!far, "{one:?} in place of {other:?}");
    }
}

#[test]
fn a_few_colors_stay_exact() {
    let pixels: Vec<_> = (0..=254).map(|level| [level, 0, 255 - level, 255]).collect();
    let picture = Picture { width: 255, height: 1, pixels };
    let swatches = Swatches::for_pictures(std::slice::from_ref(&picture));
    for &[red, green, blue, _] in &picture.pixels {
        let color = [red, green, blue];
        assert_eq!(swatches.colors()[usize::from(swatches.entry(color))], color);
        assert_eq!(swatches.palette().rgb(swatches.entry(color)), color);
    }
}

#[test]
fn a_picture_that_does_not_change_keeps_its_time() {
    let picture = Picture { width: 3, height: 2, pixels: vec![[9, 9, 9, 255]; 6] };
    let (seen, _) = decode(&animation(&vec![picture.clone(); 5]).expect("a GIF"));
    assert_eq!(seen, vec![picture; 5]);
}

#[test]
fn nothing_to_show() {
    assert!(Easel::for_film(&mech_gallery::Film::new(1.0)).is_none());
    assert!(matches!(animation(&[]), Err(FileError::Empty)));
    let torn = Picture { width: 3, height: 2, pixels: vec![[9, 9, 9, 255]; 5] };
    assert!(matches!(torn.png(), Err(FileError::Torn { .. })));
    assert!(matches!(animation(&[torn]), Err(FileError::Torn { .. })));
}

#[test]
fn a_blocked_mechanism_is_reported() {
    let beyond = Showcase { motion: |phase| [phase * 14.0], ..showcase() };
    let stuck = beyond.film().expect_err("it is blocked half way");
    assert_eq!(
        stuck.to_string(),
        "stuck at frame 45 of 90, with `a` = 7.0194, because the loop a, b, c, d does not close beyond [7.0]"
    );
    let folder = folder("blocked");
    let others = showcase();
    let curator = Curator::new(
        vec![
            Box::new(Showcase { slug: "beyond", ..beyond }),
            Box::new(Showcase { frames: 2, ..others }),
        ],
        folder.clone(),
    );
    let error = curator.serve([]).expect_err("one is missing");
    assert_eq!(error.to_string(), "the gallery lacks `beyond`");
    assert!(folder.join("four-bar.gif").is_file());
    let page = fs::read_to_string(folder.join("index.html")).expect("a page");
    assert!(!page.contains("beyond"));
}

#[test]
fn an_unknown_name_is_reported() {
    let curator = Curator::new(vec![Box::new(showcase())], folder("unknown"));
    let error = curator.serve(["five-bar".to_owned()]).expect_err("there is none");
    assert!(matches!(error, Error::Unknown { .. }));
    assert_eq!(error.to_string(), "no exhibit is called `five-bar`; there are `four-bar`");
    curator.serve(["--help".to_owned()]).expect("help is there");
}
