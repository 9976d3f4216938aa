//! Pictures of the gallery's mechanisms, compared pixel for pixel with those in `tests/pictures`, which somebody has looked at.
//!
//! `UPDATE_PICTURES=1 cargo test --release -p mech-tests --test generated pictures` makes them anew.

use mech_gallery::{
    andrews::AndrewsSqueezer, crane::LuffingCrane, four_bar::CrankRocker,
    geared_piston::GearedPiston, jansen::JansenLeg, velocities::CouplerCurve, watt::Watt,
};
use mech_runtime::overlay::Arrows;
use mech_runtime::{
    Canvas, Frame, HeapFrame, HeapSmooth, Mechanism, Overlay, Palette, Smooth, View,
};
use std::path::PathBuf;

const W: usize = 320;
const H: usize = 240;

fn file(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(format!("pictures/{name}.png"))
}

/// Red, green and blue of a file's pixels.
fn read(name: &str) -> Vec<u8> {
    let bytes = std::fs::read(file(name)).expect("the picture is in the repository");
    let mut decoder = png::Decoder::new(std::io::Cursor::new(bytes));
    decoder.set_transformations(png::Transformations::EXPAND);
    let mut reader = decoder.read_info().expect("a PNG");
    let mut pixels = vec![0; reader.output_buffer_size().expect("a size")];
    let info = reader.next_frame(&mut pixels).expect("pixels");
    assert_eq!(
        (info.width as usize, info.height as usize, info.color_type),
        (W, H, png::ColorType::Rgb)
    );
    pixels
}

fn compare(name: &str, file_of_it: &[u8], pixels: &[u8]) {
    if std::env::var_os("UPDATE_PICTURES").is_some() {
        std::fs::write(file(name), file_of_it).expect("the folder is there");
    }
    let expected = read(name);
    let off = expected.iter().zip(pixels).position(|(expected, is)| expected != is);
    if let Some(place) = off {
        let pixel = place / 3;
        let (x, y) = (pixel % W, pixel / W);
        panic!(
            "`{name}` differs first at {x}, {y}; if that is as it should be, look at it after `UPDATE_PICTURES=1`"
        );
    }
    assert_eq!(expected.len(), pixels.len());
}

/// Paints it in both qualities, in arrays and on the heap.
fn looks(name: &str, view: View, paint: &Paint<'_>) {
    let mut frame = Box::new(Frame::<W, H>::new());
    frame.look_at(view);
    paint.on(&mut *frame);
    let mut heap = HeapFrame::new(W, H).expect("it is small");
    heap.look_at(view);
    paint.on(&mut heap);
    assert!(heap.pixels() == frame.pixels().as_flattened(), "{name}");
    let rgb = |entry: &u8| frame.palette().rgb(*entry);
    let pixels: Vec<u8> = frame.pixels().as_flattened().iter().flat_map(rgb).collect();
    compare(name, &frame.png().expect("a PNG"), &pixels);
    let mut smooth = Box::new(Smooth::<W, H>::new());
    smooth.look_at(view);
    paint.on(&mut *smooth);
    let mut heap = HeapSmooth::new(W, H).expect("it is small");
    heap.look_at(view);
    paint.on(&mut heap);
    assert!(heap.pixels() == smooth.pixels().as_flattened(), "{name}");
    let pixels = smooth.pixels().as_flattened().iter().flat_map(|[r, g, b, _]| [*r, *g, *b]);
    let pixels: Vec<u8> = pixels.collect();
    compare(&format!("{name}-smooth"), &smooth.png().expect("a PNG"), &pixels);
}

/// Something that can be painted on either canvas.
enum Paint<'m> {
    Piston(&'m GearedPiston),
    FourBar(&'m CrankRocker),
    Watt(&'m Watt),
    Andrews(&'m AndrewsSqueezer),
    Jansen(&'m JansenLeg),
    Crane(&'m LuffingCrane),
    Curve(&'m CouplerCurve),
}

impl Paint<'_> {
    fn on(&self, canvas: &mut impl Canvas<f64>) {
        match self {
            Self::Piston(piston) => piston.draw(canvas),
            Self::FourBar(four_bar) => four_bar.draw(canvas),
            Self::Watt(watt) => watt.draw(canvas),
            Self::Andrews(squeezer) => squeezer.draw(canvas),
            Self::Jansen(leg) => leg.draw(canvas),
            Self::Crane(crane) => crane.draw(canvas),
            Self::Curve(curve) => {
                curve.draw(canvas);
                curve.draw_overlay(canvas, &Overlay::new().links(true));
                curve.draw_velocities(canvas, &Arrows::new(0.4, Palette::RED));
                canvas.text([0.0, -1.0], "ω = 1, α = 0 (60°)", Palette::INK);
            }
        }
    }
}

/// As it is after a part of a turn.
fn moved<M: Mechanism<Scalar = f64, Motors = [f64; 1]>>(angle: f64) -> M {
    let mut mechanism = M::new();
    let [start] = mechanism.motors();
    let moved = mechanism.move_toward([start + angle]);
    assert!(moved.is_ok(), "it is a number");
    mechanism
}

#[test]
fn pictures_are_as_they_were() {
    let piston: GearedPiston = moved(1.0);
    looks("geared-piston", GearedPiston::view(W, H), &Paint::Piston(&piston));
    let four_bar: CrankRocker = moved(0.7);
    looks("four-bar", CrankRocker::view(W, H), &Paint::FourBar(&four_bar));
    let watt: Watt = moved(0.3);
    looks("watt", Watt::view(W, H), &Paint::Watt(&watt));
    let squeezer: AndrewsSqueezer = moved(1.2);
    looks("andrews", AndrewsSqueezer::view(W, H), &Paint::Andrews(&squeezer));
    let leg: JansenLeg = moved(2.0);
    looks("jansen", JansenLeg::view(W, H), &Paint::Jansen(&leg));
    let crane: LuffingCrane = moved(0.2);
    looks("crane", LuffingCrane::view(W, H), &Paint::Crane(&crane));
    let mut curve = CouplerCurve::new();
    for step in 0..200 {
        let angle = 0.025 * f64::from(step);
        curve.move_with([angle], [1.0], [0.0]).expect("it turns");
    }
    looks("curve", CouplerCurve::view(W, H), &Paint::Curve(&curve));
}
