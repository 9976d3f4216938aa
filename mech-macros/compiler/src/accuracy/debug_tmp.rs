use super::*;
#[test]
fn tmp() {
    let text = "struct SixBar;
    link crank; link coupler; link rocker; link rod; link driver;
    joint a = revolute(ground, crank) at (0, 0);
    joint b = revolute(crank, coupler) at (0.7, 1.2);
    joint c = revolute(coupler, rocker) at (3.6, 2.4);
    joint d = revolute(ground, rocker) at (4, 0);
    joint e = revolute(coupler, rod) at (2.2, 3.6);
    joint f = revolute(rod, driver) at (6.5, 1.8);
    joint g = revolute(ground, driver) at (6.4, 1.6);
    motor g by 1 deg;
    allow coupled;";
    let model = crate::syntax::parse(text.parse().unwrap()).model;
    let structure = crate::structure::analyse(&model).unwrap();
    let plan = crate::plan::plan(&model, &structure).unwrap();
    let choices = plan
        .loops()
        .map(|_| Choice::by(crate::model::Method::Exact))
        .collect();
    let judge = Judge::new(&model, &plan, choices);
    println!("{:?} {}", judge.on_loops, judge.is_stepped(0));
    let c = judge.candidates();
    let mut rivals: Vec<Rival> = c
        .iter()
        .flatten()
        .map(|c| Rival::new(c.program.clone()))
        .collect();
    let found = compare(&model, &plan, &judge.reference, &mut rivals);
    println!("{found:?}");
    for (c, r) in c.iter().flatten().zip(&rivals) {
        println!("{:?} {} {} {:?}", c.solver, c.weight, r.error(), r.worst);
    }
    let mut m = crate::evaluate::Machine::<f64>::new(&judge.reference);
    for k in 0..=36 {
        println!("{k} {:?}", m.move_to(&[f64::from(k * 10).to_radians()]));
    }
}
