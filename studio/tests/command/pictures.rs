//! `mech draw` and `mech film`: the interpreter shows what the generated code shows.

use crate::run::{FOUR_BAR, Folder, mech_in, numbers, repository};
use std::path::Path;

/// Width and height, and red, green and blue of all pixels.
pub(crate) fn pixels(path: &Path) -> ([u32; 2], Vec<u8>) {
    let file = std::fs::read(path).expect("a picture");
    let mut decoder = png::Decoder::new(std::io::Cursor::new(file));
    decoder.set_transformations(png::Transformations::EXPAND);
    let mut reader = decoder.read_info().expect("a PNG");
    let mut pixels = vec![0; reader.output_buffer_size().expect("a size")];
    let info = reader.next_frame(&mut pixels).expect("pixels");
    // Films are transparent.
    let samples = info.color_type.samples();
    assert!(samples >= 3, "{:?}", info.color_type);
    let colors = pixels.chunks_exact(samples);
    let colors = colors.flat_map(|pixel| [pixel[0], pixel[1], pixel[2]]);
    ([info.width, info.height], colors.collect())
}

#[test]
fn the_same_pixels_as_the_generated_code() {
    let folder = Folder::new();
    let output = folder.path("a.png");
    let output = output.to_str().expect("UTF-8");
    let gallery = repository("examples/gallery/src/mechanisms");
    // As far as the pictures of the generated code are moved from the start.
    let cases = [("watt", "a", 0.3_f64), ("geared_piston", "d", 1.0)];
    for (name, motor, angle) in cases {
        let at = format!("--at={motor}={}", angle.to_degrees());
        let words = ["draw", &format!("{name}.rs"), "-o", output, "--size", "320x240", &at];
        mech_in(&gallery, &words).done();
        let name = name.replace('_', "-");
        let expected = repository(&format!("tests/pictures/{name}-smooth.png"));
        assert!(pixels(&folder.path("a.png")) == pixels(&expected), "{name}");
    }
}

#[test]
fn pictures_have_the_size_that_is_asked_for() {
    let folder = Folder::new().with("a.mech", FOUR_BAR);
    folder.mech("draw a.mech -o a.png --size 200x100").done();
    assert_eq!(pixels(&folder.path("a.png")).0, [200, 100]);
    // A width alone has the height that fits.
    folder.mech("draw a.mech -o b.png --size 200").done();
    let [width, height] = pixels(&folder.path("b.png")).0;
    assert!(width == 200 && (80..=300).contains(&height), "{height}");
}

#[test]
fn looks_overlays_and_dark_ground_are_different_pictures() {
    let folder = Folder::new().with("a.mech", FOUR_BAR);
    let mut seen = Vec::new();
    for how in ["", "--look diagram", "--look shapes", "--overlay", "--night", "--at a=90"] {
        folder.mech(&format!("draw a.mech -o a.svg --size 300 {how}")).done();
        let text = folder.text("a.svg");
        assert!(text.contains("<title>FourBar</title>"), "{text}");
        assert!(!seen.contains(&text), "{how}");
        seen.push(text);
    }
}

/// However short a trace is, and over how many turns a path closes: the picture has all of it.
#[test]
fn a_picture_has_whole_paths() {
    let text = |length: u32| format!("{FOUR_BAR} effects {{ trace coupler.tip {length}; }}");
    let folder = Folder::new().with("short.mech", text(16)).with("long.mech", text(4096));
    let picture = |name: &str| {
        folder.mech(&format!("draw {name}.mech -o {name}.png")).done();
        std::fs::read(folder.path(&format!("{name}.png"))).expect("a picture")
    };
    assert!(picture("short") == picture("long"));
    // It closes after two turns of the arm, and is as far from its centre on both sides of it then.
    let turns = "struct E; link arm; link planet { point tip = (4.5, 0); } joint a = revolute(ground, arm) at (0, 0);
        joint b = revolute(arm, planet) at (3, 0); joint g = gear(planet, ground, 20 : -30 on arm); motor a; look none;
        effects { trace planet.tip 64 color red; }";
    let folder = folder.with("turns.mech", turns);
    folder.mech("draw turns.mech -o turns.svg --size 200").done();
    let svg = folder.text("turns.svg");
    let longest = svg.split('"').map(|part| part.split([' ', ',', 'L']).count()).max();
    assert!(longest > Some(1440), "{longest:?}");
}

#[test]
fn a_film_as_svg_moves() {
    let folder = Folder::new().with("a.mech", FOUR_BAR);
    folder.mech("film a.mech -o a.svg --seconds 1").done();
    assert!(folder.text("a.svg").contains("@keyframes"));
}

#[test]
fn wheels_turn_until_everything_is_back() {
    let text = "struct Gears; link pinion; link wheel { point pin = (1, 0); }
joint d = revolute(ground, pinion) at (-3, 0);
joint e = revolute(ground, wheel) at (0, 0);
joint mesh = gear(pinion, wheel, 20 : 60);
motor d;";
    let folder = Folder::new().with("a.mech", text);
    let film = |name: &str, to: &str| {
        folder.mech(&format!("film a.mech -o {name} --size 60 --seconds 1 --rate 6 {to}")).done();
        std::fs::read(folder.path(name)).expect("a film")
    };
    assert!(film("a.gif", "") == film("b.gif", "--to 1080"));
    assert!(film("c.gif", "") != film("d.gif", "--to 360"));
}

#[test]
fn laws_are_shown_until_all_is_back() {
    let gears = "struct Gears; link pinion; link wheel { point pin = (1, 0); }
joint a = revolute(ground, pinion) at (-3, 0);
joint e = revolute(ground, wheel) at (0, 0);
joint mesh = gear(pinion, wheel, 20 : 60);
motor a;";
    let slow = |text: &str, law: &str| text.replace("motor a;", &format!("motor a = {law};"));
    for (text, law, table_to, film_to, is_back) in [
        // A turn takes 4 s. The wheel is back after three.
        (FOUR_BAR, "PI * t / 2", 4, 4, true),
        (gears, "PI * t / 2", 4, 12, true),
        (FOUR_BAR, "0.3 * sin(PI * t / 3) + 0.1 * sin(PI * t)", 6, 6, true),
        // This never is back.
        (FOUR_BAR, "0.3 * t * t", 1, 1, false),
    ] {
        let folder = Folder::new().with("a.mech", slow(text, law));
        let table = folder.mech("table a.mech a --steps 2").done();
        let last = table.lines().last().unwrap_or_default();
        assert!(last.starts_with(&format!("{table_to},")), "{law}: {last}");
        let film = "--size 60 --seconds 1 --rate 5";
        let usual = folder.mech(&format!("film a.mech -o a.gif {film}"));
        assert_eq!(usual.code, Some(0), "{law}");
        let told = format!("from t = 0 to {film_to};");
        assert_eq!(usual.err.contains(&told), !is_back, "{law}: {}", usual.err);
        assert_eq!(usual.err.is_empty(), is_back, "{law}: {}", usual.err);
        folder.mech(&format!("film a.mech -o b.gif {film} --to {film_to}")).done();
        let read = |name: &str| std::fs::read(folder.path(name)).expect("a film");
        assert!(read("a.gif") == read("b.gif"), "{law}");
    }
}

#[test]
fn instant_centres_are_painted_where_they_are_measured() {
    let text = "struct M; link crank; link rod; link rocker;
joint o = revolute(ground, crank) at (0, 0); joint a = revolute(crank, rod) at (1, 0.5);
joint b = revolute(rod, rocker) at (4, 3); joint d = revolute(ground, rocker) at (5, 0); motor o;";
    let folder = Folder::new().with("a.mech", text);
    let words = "table a.mech centre(ground,rod) centre(crank,rocker) --from 20 --to 21 --steps 1";
    let row = &numbers(&folder.mech(words).done())[0];
    folder.mech("draw a.mech -o a.svg --look diagram --names --centres --at o=20").done();
    let svg = folder.text("a.svg");
    let part = |line: &str, name: &str| -> f64 {
        let (_, rest) = line.split_once(&format!(" {name}=\"")).expect("it is there");
        rest.split('"').next().and_then(|text| text.parse().ok()).expect("a number")
    };
    let circles =
        svg.split('<').filter(|one| one.starts_with("circle") && one.contains("r=\"3.5\""));
    let dots: Vec<[f64; 2]> = circles.map(|one| [part(one, "cx"), -part(one, "cy")]).collect();
    // The pins of the ground tell the scale.
    let scale = dots.iter().map(|[x, _]| *x).fold(0.0, f64::max) / 5.0;
    assert_eq!(dots.len(), 6, "{svg}");
    for centre in row[1..].chunks(2) {
        let is_there = |[x, y]: &[f64; 2]| {
            (x / scale - centre[0]).abs() < 1e-3 && (y / scale - centre[1]).abs() < 1e-3
        };
        assert!(dots.iter().any(is_there), "{dots:?} {centre:?}");
    }
    for name in ["o", "a", "b", "d", "crank", "rod", "rocker", "ground rod", "crank rocker"] {
        assert!(svg.contains(&format!(">{name}</text>")), "{name}");
    }
}
