//! `mech draw` and `mech film`: the interpreter shows what the generated code shows.

use crate::run::{FOUR_BAR, Folder, mech_in, repository, rust};
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
        let words = [
            "draw",
            &format!("{name}.rs"),
            "-o",
            output,
            "--size",
            "320x240",
            &at,
        ];
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
    for size in ["0", "x", "10x", "99999", "10x0"] {
        folder
            .mech(&format!("draw a.mech -o c.png --size {size}"))
            .refused(2);
    }
    assert_eq!(folder.names(), ["a.mech", "a.png", "b.png"]);
}

#[test]
fn looks_overlays_and_dark_ground_are_different_pictures() {
    let folder = Folder::new().with("a.mech", FOUR_BAR);
    let mut seen = Vec::new();
    for how in [
        "",
        "--look diagram",
        "--look shapes",
        "--overlay",
        "--night",
        "--at a=90",
    ] {
        folder
            .mech(&format!("draw a.mech -o a.svg --size 300 {how}"))
            .done();
        let text = folder.text("a.svg");
        assert!(text.contains("<title>FourBar</title>"), "{text}");
        assert!(!seen.contains(&text), "{how}");
        seen.push(text);
    }
}

#[test]
fn pictures_that_cannot_be_drawn() {
    let folder = Folder::new().with("a.mech", FOUR_BAR).with("a.rs", rust());
    let refusals = [
        (
            "draw a.mech -o a.bmp",
            2,
            "its name has to end in `.png`, `.svg`",
        ),
        (
            "film a.mech -o a.avi",
            2,
            "its name has to end in `.gif`, `.png`, `.apng`, `.svg`",
        ),
        (
            "draw a.mech -o a.png --at b=3",
            2,
            "has no motor `b`; it has `a`",
        ),
        ("draw a.mech -o a.png --at a=x", 2, "`x` is not a number"),
        (
            "draw a.mech -o a.png --at a",
            2,
            "expected a motor and its value",
        ),
        ("draw a.mech -o a.png --at a=inf", 2, "is not finite"),
        ("draw a.rs -m Loose -o a.png", 1, "there is no motor"),
        ("film a.mech -o a.gif --motor c", 2, "has no motor `c`"),
    ];
    for (words, code, text) in refusals {
        let refusal = folder.mech(words).refused(code);
        assert!(refusal.contains(text), "{words}: {refusal}");
    }
    assert_eq!(folder.names(), ["a.mech", "a.rs"]);
}

/// A rocker that is driven goes as far as its loop lets it.
fn rocker() -> String {
    FOUR_BAR.replace("motor a;", "motor d;")
}

#[test]
fn a_motor_with_limits_goes_to_and_fro() {
    let folder = Folder::new().with("a.mech", rocker());
    folder
        .mech("film a.mech -o a.gif --size 60 --seconds 1 --rate 8")
        .done();
    let refusal = folder.mech("draw a.mech -o a.png --at d=170").refused(1);
    assert!(refusal.contains("the loop of `a`, `b`, `c`"), "{refusal}");
    let refusal = folder
        .mech("film a.mech -o b.gif --from 0 --to 170")
        .refused(1);
    assert!(refusal.contains("motor `d` cannot come to "), "{refusal}");
    assert!(refusal.contains("; it can go from "), "{refusal}");
    assert_eq!(folder.names(), ["a.gif", "a.mech"]);
}

/// However short a trace is, and over how many turns a path closes: the picture has all of it.
#[test]
fn a_picture_has_whole_paths() {
    let text = |length: u32| format!("{FOUR_BAR} effects {{ trace coupler.tip {length}; }}");
    let folder = Folder::new()
        .with("short.mech", text(16))
        .with("long.mech", text(4096));
    let picture = |name: &str| {
        folder
            .mech(&format!("draw {name}.mech -o {name}.png"))
            .done();
        std::fs::read(folder.path(&format!("{name}.png"))).expect("a picture")
    };
    assert!(picture("short") == picture("long"));
    // It closes after two turns of the arm, and is as far from its centre on both sides of it then.
    let turns = "struct E; link arm; link planet { point tip = (4.5, 0); } joint a = revolute(ground, arm) at (0, 0);
        joint b = revolute(arm, planet) at (3, 0); joint g = gear(planet, ground, 20 : -30 on arm); motor a; look none;
        effects { trace planet.tip 64 color red; }";
    let folder = folder.with("turns.mech", turns);
    folder
        .mech("draw turns.mech -o turns.svg --size 200")
        .done();
    let svg = folder.text("turns.svg");
    let longest = svg
        .split('"')
        .map(|part| part.split([' ', ',', 'L']).count())
        .max();
    assert!(longest > Some(1440), "{longest:?}");
}

#[test]
fn films_of_all_kinds() {
    let traced = format!("{FOUR_BAR} effects {{ trace coupler.tip 256; }}");
    let folder = Folder::new().with("a.mech", traced);
    for (name, start) in [
        ("a.gif", &b"GIF89a"[..]),
        ("a.png", b"\x89PNG"),
        ("a.apng", b"\x89PNG"),
        ("a.svg", b"<svg "),
    ] {
        folder
            .mech(&format!(
                "film a.mech -o {name} --size 80 --seconds 1 --rate 5"
            ))
            .done();
        let bytes = std::fs::read(folder.path(name)).expect("a film");
        assert!(bytes.starts_with(start), "{name}");
    }
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
        folder
            .mech(&format!(
                "film a.mech -o {name} --size 60 --seconds 1 --rate 6 {to}"
            ))
            .done();
        std::fs::read(folder.path(name)).expect("a film")
    };
    assert!(film("a.gif", "") == film("b.gif", "--to 1080"));
    assert!(film("c.gif", "") != film("d.gif", "--to 360"));
}

#[test]
fn motors_follow_their_laws() {
    let law = FOUR_BAR.replace("motor a;", "motor a = 2 * PI * t;");
    let folder = Folder::new().with("a.mech", law);
    folder
        .mech("film a.mech -o a.gif --size 60 --seconds 1 --rate 4")
        .done();
    let table = folder.mech("table a.mech a velocity:a --steps 2").done();
    let rows: Vec<&str> = table.lines().collect();
    assert_eq!(rows[0], "t [s],a [deg],velocity:a [rad/s]");
    assert_eq!(rows[2], "0.5,180,6.283185307179586");
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
        (
            FOUR_BAR,
            "0.3 * sin(PI * t / 3) + 0.1 * sin(PI * t)",
            6,
            6,
            true,
        ),
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
        folder
            .mech(&format!("film a.mech -o b.gif {film} --to {film_to}"))
            .done();
        let read = |name: &str| std::fs::read(folder.path(name)).expect("a film");
        assert!(read("a.gif") == read("b.gif"), "{law}");
    }
}

#[test]
fn laws_that_something_stops_are_shown_for_a_while() {
    // The crank is longer than the way to the rocker lets it turn.
    let text = "struct Stuck; link crank; link rod; link rocker;
joint a = revolute(ground, crank) at (0, 0);
joint b = revolute(crank, rod) at (0, 3);
joint c = revolute(rod, rocker) at (4, 3);
joint d = revolute(ground, rocker) at (4, 1);
motor a = 0.2 * t;";
    let folder = Folder::new().with("a.mech", text);
    let film = folder.mech("film a.mech -o a.gif --size 60 --seconds 1 --rate 5");
    assert_eq!(film.code, Some(0), "{}", film.err);
    assert!(film.err.contains("from t = 0 to 1;"), "{}", film.err);
}
