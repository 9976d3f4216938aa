//! Mechanisms to be proved.

use crate::program::Program;
use crate::syntax::parse;
use crate::{Compiled, compile};
use proc_macro2::{TokenStream, TokenTree};
use std::f64::consts::TAU;
use std::fmt::Write;

/// The range of a motor that makes whole turns.
pub(super) const TURN: [(f64, f64); 1] = [(0.0, TAU)];

pub(super) fn program(text: TokenStream) -> Program {
    let parsed = parse(text);
    assert!(parsed.errors.is_empty(), "{:#?}", parsed.errors);
    match compile(&parsed.model) {
        Ok(Compiled { program, .. }) => program,
        Err(diagnoses) => panic!("{diagnoses:#?}"),
    }
}

pub(super) fn tokens(text: &str) -> TokenStream {
    text.parse().expect("the text is made of tokens")
}

/// The mechanism declared in an exhibit of the gallery.
pub(super) fn exhibit(name: &str) -> Program {
    let path =
        format!("{}/../../examples/gallery/src/mechanisms/{name}.rs", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).expect("the gallery is in its place");
    let trees: Vec<TokenTree> = tokens(&text).into_iter().collect();
    let body = trees.windows(3).find_map(|trees| match trees {
        [TokenTree::Ident(name), TokenTree::Punct(_), TokenTree::Group(body)]
            if name == "mechanism" =>
        {
            Some(body.stream())
        }
        _ => None,
    });
    program(body.expect("an exhibit has a mechanism"))
}

/// Ground, crank, coupler and rocker by their lengths, the ground's line turned by an angle.
pub(super) fn four_bar(
    [ground, crank, coupler, rocker]: [f64; 4],
    tilt: f64,
    start: f64,
    near: f64,
) -> Program {
    let (sin, cos) = tilt.sin_cos();
    let (x, y) = (ground * cos, ground * sin);
    program(tokens(&format!(
        "struct FourBar;
        ground {{ point a = (0, 0); point d = ({x:?}, {y:?}); }}
        link crank {{ point a = (0, 0); point b = ({crank:?}, 0); }}
        link coupler {{ point b = (0, 0); point c = ({coupler:?}, 0); }}
        link rocker {{ point d = (0, 0); point c = ({rocker:?}, 0); }}
        joint a = revolute(ground.a, crank.a);
        joint b = revolute(crank.b, coupler.b);
        joint c = revolute(coupler.c, rocker.c);
        joint d = revolute(ground.d, rocker.d);
        motor a;
        start {{ a = {start:?}; rocker near {near:?}; }}"
    )))
}

pub(super) fn slider_crank(crank: f64, rod: f64) -> Program {
    program(tokens(&format!(
        "struct SliderCrank;
        ground {{ point a = (0, 0); line bore = (0, 0) -> (1, 0); }}
        link crank {{ point a = (0, 0); point b = ({crank:?}, 0); }}
        link rod {{ point b = (0, 0); point c = ({rod:?}, 0); }}
        link piston {{ point c = (0, 0); line axis = (0, 0) -> (1, 0); }}
        joint a = revolute(ground.a, crank.a);
        joint b = revolute(crank.b, rod.b);
        joint c = revolute(rod.c, piston.c);
        joint h = prismatic(ground.bore, piston.axis);
        motor a;
        start {{ a = 0; rod near 0; }}"
    )))
}

/// Four-bars in a row, each driven by the rocker of the one before it: as in the tests of the whole house.
pub(super) fn chain(loops: usize) -> Program {
    let mut text = "struct Chain; link crank;".to_owned();
    let mut joints = "joint m = revolute(ground, crank) at (0, 0); motor m;".to_owned();
    let (mut input, mut pin) = ("crank".to_owned(), [0.3, 1.0]);
    let mut along = 0.0;
    for number in 0..loops {
        along += 3.0;
        let (top, [x, y]) = (along + 0.3, pin);
        write!(text, "link coupler_{number}; link rocker_{number};")
            .expect("a string takes any text");
        write!(
            joints,
            "joint a_{number} = revolute({input}, coupler_{number}) at ({x:?}, {y:?});
            joint b_{number} = revolute(coupler_{number}, rocker_{number}) at ({top:?}, 1.6);
            joint c_{number} = revolute(ground, rocker_{number}) at ({along:?}, 0);"
        )
        .expect("a string takes any text");
        (input, pin) = (format!("rocker_{number}"), [along + 0.2, 1.0]);
    }
    program(tokens(&(text + &joints)))
}
