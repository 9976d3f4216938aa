//! Traces of what has no path, or is no point, or is too long to be kept; methods that would have one name.

use mech_runtime::mechanism;

mechanism! {
    struct Crank;

    ground { point o = (0.0, 0.0); }
    link crank {
        point shaft = (0.0, 0.0);
        point pin = (1.0, 0.0);
        point pin_trace = (2.0, 0.0);
        line edge = (0.0, 0.0) -> (1.0, 0.0);
    }
    joint a = revolute(ground.o, crank.shaft);

    motor a;
    effects {
        trace crank.pim 256;
        trace crnak.pin 256;
        trace crank.pin 0;
        trace crank.pin 1e9;
        trace crank.pin;
        trace crank.edge 256;
        trace crank 256;
        trace ground.o 256;
        trace crank.pin 256 color 300;
        trace crank.shaft 256;
        trace crank.shaft 64;
        trace crank.pin 256;
        overlai;
        overlay;
        overlay;
    }
}

fn main() {}
