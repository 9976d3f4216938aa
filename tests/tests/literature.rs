//! Mechanisms of the literature, and its tables in `literature/`: numbers that nobody of this project made.
//! `PMKS_Verification` is a collection of what three independent programs agree on.

use mech_runtime::mechanism;

/// The rows of a table. Lines with `#` say where it is from, and what its columns are.
pub(crate) fn rows<const N: usize>(table: &str) -> Vec<[f64; N]> {
    let lines = table.lines().filter(|line| !line.starts_with('#'));
    let row = |line: &str| {
        let numbers = line.split_whitespace().map(str::parse);
        let numbers: Vec<f64> = numbers.collect::<Result<_, _>>().expect("numbers");
        numbers.try_into().expect("so many columns")
    };
    let rows: Vec<[f64; N]> = lines.map(row).collect();
    assert!(rows.len() > 2, "{} rows are no table", rows.len());
    rows
}

mechanism! {
    /// The four-bar of the tables.
    pub(crate) struct FourBar;
    link crank;
    link coupler { point end = (4.23, 3.029); }
    link rocker { point end = (4.23, 3.029); }
    joint a = revolute(ground, crank) at (0, 0);
    joint b = revolute(crank, coupler) at (1.52, 0);
    joint c = revolute(coupler, rocker) at (4.23, 3.029);
    joint d = revolute(ground, rocker) at (4.572, 0);
    motor a;
    effects { velocity; acceleration; }
}

mechanism! {
    /// The slider-crank of the tables.
    pub(crate) struct SliderCrank;
    link crank;
    link rod { point end = (-0.97, 10.01); }
    link block;
    joint a = revolute(ground, crank) at (13.79, 10.01);
    joint b = revolute(crank, rod) at (13.79, 13.82);
    joint c = revolute(rod, block) at (-0.97, 10.01);
    joint x = prismatic(ground, block) at (-0.97, 10.01) along (1, 0);
    motor a;
    effects { velocity; acceleration; }
}

mechanism! {
    /// The slider-crank with a tracer point of the tables.
    pub(crate) struct Tracer;
    link crank;
    link rod { point end = (12, 0); point tracer = (20, 2); }
    link block;
    joint a = revolute(ground, crank) at (0, 0);
    joint b = revolute(crank, rod) at (4, 2);
    joint c = revolute(rod, block) at (12, 0);
    joint x = prismatic(ground, block) at (12, 0) along (1, 0);
    motor a;
    effects { acceleration; }
}

mechanism! {
    /// Andrews' squeezer with its masses, its spring and no gravity.
    pub(crate) struct Andrews;
    const RR = 0.007; const D = 0.028; const SS = 0.035; const E = 0.02; const ZT = 0.04; const ZF = 0.02; const U = 0.04;
    ground { point o = (0, 0); point a = (-0.06934, -0.00227); point b = (-0.03635, 0.03273); point c = (0.014, 0.072); }
    link k1 { point o = (0, 0); point tip = (RR, 0); mass 0.04325 at (0.00092, 0) inertia 2.194e-6; }
    link k2 { point tip = (0, 0); point e = (-D, 0); mass 0.00365 at (-0.0115, 0) inertia 4.410e-7; }
    link k3 {
        point b = (0, 0); point e = (0, -SS); point d = (0.02, -0.018);
        mass 0.02373 at (0.01043, -0.01874) inertia 5.255e-6;
    }
    link k4 { point e = (0, -E); point knee = (0, 0); mass 0.00706 at (0, 0.01421 - E) inertia 5.667e-7; }
    link k5 { point a = (0, 0); point knee = (ZT, 0); mass 0.07050 at (0.02308, 0.00916) inertia 1.169e-5; }
    link k6 { point e = (ZF, 0); point knee = (0, 0); mass 0.00706 at (ZF - 0.01421, 0) inertia 5.667e-7; }
    link k7 { point a = (0, 0); point knee = (0, -U); mass 0.05498 at (-0.00449, -0.01228) inertia 1.912e-5; }
    joint beta = revolute(ground.o, k1.o);
    joint theta = revolute(k1.tip, k2.tip);
    joint gamma = revolute(ground.b, k3.b);
    joint e3 = revolute(k2.e, k3.e);
    joint delta = revolute(ground.a, k5.a);
    joint phi = revolute(k5.knee, k4.knee);
    joint e4 = revolute(k2.e, k4.e);
    joint epsilon = revolute(ground.a, k7.a);
    joint omega = revolute(k7.knee, k6.knee);
    joint e6 = revolute(k2.e, k6.e);
    motor beta;
    start {
        beta = -0.0617138900142764964;
        k2 near -0.06; k5 near 0.49; k7 near 1.23;
    }
    spring coil = linear(k3.d, ground.c) stiffness 4530 rest 0.07785;
    effects { velocity; acceleration; dynamics; }
}
