//! Diagrams: symbols stand where their joints are and roll on each other without slipping; arrows are velocities.

use mech_compiler::Compiled;
use mech_compiler::evaluate::Machine;
use mech_compiler::model::{LinkId, Measure, Model};
use mech_compiler::symbols::{moving_points, symbols};
use mech_runtime::overlay::{self, Arrows};
use mech_runtime::{Canvas, Outline, Overlay, Pose};
use mech_test_support::{dot, folder, mechanisms};

include!(concat!(env!("OUT_DIR"), "/overlay.rs"));

type Vector = [f64; 2];
type Spot = overlay::Spot<f64, LinkId>;
type Symbol = overlay::Symbol<f64, LinkId>;

/// The diagram of a mechanism at its start.
fn diagram(model: &Model, compiled: &Compiled) -> Vec<Symbol> {
    let symbols = symbols(model, &compiled.structure, |_| true);
    let at_start = |symbol: mech_compiler::symbols::Symbol| symbol.try_map(Measure::at_start, Some);
    symbols.into_iter().filter_map(at_start).collect()
}

/// All mechanisms of the zoo.
fn zoo() -> Vec<(Model, Compiled)> {
    let texts = folder("../tests/subjects/zoo").into_iter();
    texts.flat_map(|case| mechanisms(&case.text)).collect()
}

/// Where everything is at a moment, and a little before and after it.
struct Moment {
    stored: Vec<LinkId>,
    poses: [Vec<[f64; 4]>; 3],
    step: f64,
}

impl Moment {
    /// The start, with every motor moving on at its own rate.
    fn of(compiled: &Compiled) -> Self {
        let step = 1e-6;
        let program = &compiled.program;
        let poses = [-step, 0.0, step].map(|shift| {
            let mut machine = Machine::<f64>::new(program);
            let start = machine.position().motors.clone();
            let motors: Vec<f64> =
                (0..).zip(&start).map(|(n, at)| at + shift * (1.0 + 0.3 * f64::from(n))).collect();
            machine.move_to(&motors).expect("it moves");
            machine.position().poses.clone()
        });
        let stored = program.stored.clone();
        Self { stored, poses, step }
    }

    fn pose(&self, time: usize, link: LinkId) -> Pose<f64> {
        let place = self.stored.binary_search(&link);
        place.map_or(Pose::identity(), |place| self.poses[time][place].into())
    }

    fn place(&self, spot: Spot) -> Vector {
        self.pose(1, spot.link).apply(spot.at)
    }

    /// A direction of a link, in the scene.
    fn direction(&self, link: LinkId, direction: Vector) -> Vector {
        self.pose(1, link).turn(direction)
    }

    /// The velocity of the point of a link that is at a place in the scene.
    fn velocity(&self, link: LinkId, place: Vector) -> Vector {
        let own = self.pose(1, link).relative(place);
        let [before, after] = [0, 2].map(|time| self.pose(time, link).apply(own));
        [0, 1].map(|part| (after[part] - before[part]) / (2.0 * self.step))
    }
}

fn away([x, y]: Vector, [u, v]: Vector, length: f64) -> Vector {
    [x + length * u, y + length * v]
}

#[track_caller]
fn near(found: f64, expected: f64, what: &str) {
    assert!(
        (found - expected).abs() < 1e-7 * (1.0 + expected.abs()),
        "{what}: {found}, not {expected}"
    );
}

/// Two wheels touch in one point, and move there as one.
fn gears_mesh(name: &str, moment: &Moment, wheels: [(Spot, f64); 2]) {
    let [(a, first), (b, second)] = wheels;
    let (p, q) = (moment.place(a), moment.place(b));
    let offset = [q[0] - p[0], q[1] - p[1]];
    let distance = dot(offset, offset).sqrt();
    let unit = offset.map(|part| part / distance);
    let inside = distance < first.max(second);
    let touching = if inside { (first - second).abs() } else { first + second };
    near(touching, distance, name);
    let side = if inside && first < second { -1.0 } else { 1.0 };
    let contact = away(p, unit, side * first);
    let [u, v] = [a, b].map(|spot| moment.velocity(spot.link, contact));
    near(u[0], v[0], name);
    near(u[1], v[1], name);
    let still = dot(u, u) + moment.velocity(a.link, p).iter().map(|part| part.abs()).sum::<f64>();
    assert!(still > 1e-6, "{name} stands still: this shows nothing");
}

/// A bar moves along its line as its pinion does where they touch.
fn racks_mesh(
    name: &str,
    moment: &Moment,
    (pinion, radius): (Spot, f64),
    (bar, along): (Spot, Vector),
) {
    let direction = moment.direction(bar.link, along);
    let [u, v] = direction;
    let contact = away(moment.place(pinion), [v, -u], radius);
    let [a, b] = [pinion, bar].map(|spot| dot(moment.velocity(spot.link, contact), direction));
    near(a, b, name);
}

/// A belt leaves one wheel as fast as it comes to the other.
fn belts_run(name: &str, moment: &Moment, centers: [Spot; 2], radii: [f64; 2]) {
    let rims = [0, 1].map(|end| {
        let center = moment.place(centers[end]);
        let rim = away(center, [0.0, 1.0], radii[end]);
        let (rim, hub) =
            (moment.velocity(centers[end].link, rim), moment.velocity(centers[end].link, center));
        rim[0] - hub[0]
    });
    near(rims[0], rims[1], name);
}

#[test]
fn what_rolls_in_a_diagram_does_not_slip() {
    let (mut gears, mut racks, mut belts) = (0, 0, 0);
    for (model, compiled) in zoo() {
        let name = &model.name;
        let moment = Moment::of(&compiled);
        let symbols = diagram(&model, &compiled);
        let rolling: Vec<&Symbol> = symbols
            .iter()
            .filter(|symbol| {
                matches!(symbol, Symbol::Wheel { .. } | Symbol::Belt { .. } | Symbol::Rack { .. })
            })
            .collect();
        let mut remaining = &rolling[..];
        while let Some((first, after)) = remaining.split_first() {
            match (first, after) {
                (
                    Symbol::Wheel { .. },
                    [Symbol::Wheel { .. }, Symbol::Belt { centers, radii }, more @ ..],
                ) => {
                    belts_run(name, &moment, *centers, *radii);
                    belts += 1;
                    remaining = more;
                }
                (
                    Symbol::Wheel { center, radius },
                    [Symbol::Wheel { center: other, radius: size }, more @ ..],
                ) => {
                    gears_mesh(name, &moment, [(*center, *radius), (*other, *size)]);
                    gears += 1;
                    remaining = more;
                }
                (
                    Symbol::Wheel { .. },
                    [Symbol::Rack { pinion, radius, bar, along }, more @ ..],
                ) => {
                    racks_mesh(name, &moment, (*pinion, *radius), (*bar, *along));
                    racks += 1;
                    remaining = more;
                }
                _ => panic!("{name}: {remaining:?}"),
            }
        }
    }
    assert!(gears >= 9 && racks >= 3 && belts >= 1, "{gears}, {racks}, {belts}");
}

#[test]
fn every_pin_has_one_symbol_and_every_moving_one_an_arrow() {
    for (model, compiled) in zoo() {
        let name = &model.name;
        let moment = Moment::of(&compiled);
        let symbols = diagram(&model, &compiled);
        let pivots: Vec<Spot> = symbols
            .iter()
            .filter_map(|symbol| match symbol {
                Symbol::Pivot(spot) => Some(*spot),
                _ => None,
            })
            .collect();
        assert_eq!(pivots.len(), compiled.structure.pins.len(), "{name}");
        let arrows = moving_points(&model, &compiled.structure, |_| true);
        let near = |one: Vector, other: Vector| (one[0] - other[0]).hypot(one[1] - other[1]) < 1e-9;
        for (pin, pivot) in compiled.structure.pins.iter().zip(&pivots) {
            let place = moment.place(*pivot);
            for (link, axis) in &pin.members {
                let at = model.axis(*axis).at;
                if model.link(*link).die.is_none() {
                    let found = moment.place(Spot { link: *link, at });
                    assert!(near(found, place), "{name}: {found:?}, {place:?}");
                }
            }
            let fixed = pin.axis_of(LinkId::GROUND).is_some();
            assert_eq!(pivot.link == LinkId::GROUND, fixed, "{name}");
            let of_pin = arrows.iter().filter(|spot| {
                pin.members
                    .iter()
                    .any(|(link, axis)| spot.link == *link && spot.at == model.axis(*axis).place())
            });
            assert_eq!(of_pin.count(), usize::from(!fixed), "{name}");
        }
        let motors = symbols
            .iter()
            .filter(|symbol| matches!(symbol, Symbol::RotaryMotor(_) | Symbol::LinearMotor { .. }));
        assert_eq!(motors.count(), model.motors.len(), "{name}");
        let slides = symbols.iter().filter(|symbol| matches!(symbol, Symbol::Slide { .. }));
        let prismatic = model
            .joints
            .iter()
            .filter(|joint| matches!(joint.kind, mech_compiler::model::JointKind::Prismatic(..)));
        assert_eq!(slides.count(), prismatic.count(), "{name}");
    }
}

#[test]
fn blocks_lie_on_the_lines_of_their_guides() {
    let mut count = 0;
    for (model, compiled) in zoo() {
        let moment = Moment::of(&compiled);
        for symbol in diagram(&model, &compiled) {
            if let Symbol::Slide { guide, along, block } = symbol {
                let (from, to) = (moment.place(guide), moment.place(block));
                let [u, v] = moment.direction(guide.link, along);
                near(dot([to[0] - from[0], to[1] - from[1]], [-v, u]), 0.0, &model.name);
                count += 1;
            }
        }
    }
    assert!(count > 10, "{count}");
}

/// Notes what is painted.
#[derive(Default)]
struct Recorder {
    circles: Vec<Vector>,
    polygons: Vec<Vec<Vector>>,
}

impl<T: mech_runtime::Scalar> Canvas<T> for Recorder {
    fn fill(&mut self, outline: Outline<T>, pose: Pose<T>, _: u8) {
        let seen = |point: [T; 2]| {
            let place = pose.apply(point);
            place.map(|part| mech_runtime::Real::to_f64(part))
        };
        match outline {
            Outline::Circle { center, .. } => self.circles.push(seen(center)),
            Outline::Polygon(points) | Outline::Line { points, .. } => {
                let points = points.iter().map(|&point| seen(point));
                self.polygons.push(points.collect());
            }
            _ => {}
        }
    }

    fn text(&mut self, _: [T; 2], _: &str, _: u8) {}

    fn scale(&self) -> T {
        mech_runtime::Real::from_f64(1000.0)
    }
}

impl Recorder {
    /// The tips of all arrows: heads are triangles that begin with them.
    fn tips(&self) -> Vec<Vector> {
        let heads = self.polygons.iter().filter(|corners| corners.len() == 3);
        heads.map(|corners| corners[0]).collect()
    }
}

#[test]
fn arrows_are_velocities_and_accelerations() {
    let rates =
        |four_bar: &FourBar| [four_bar.crank_pin_velocity(), four_bar.coupler_tip_velocity()];
    let mut four_bar = FourBar::new();
    let (turn, rate, second, step) = (0.7, 1.3, -0.4, 1e-5);
    let at = |time: f64| {
        let mut four_bar = FourBar::new();
        let angle = turn + rate * time + 0.5 * second * time * time;
        four_bar.move_with([angle], [rate + second * time], [second]).expect("it turns");
        four_bar
    };
    four_bar.move_with([turn], [rate], [second]).expect("it turns");
    let (before, after) = (at(-step), at(step));
    let (mut velocities, mut accelerations) = (Recorder::default(), Recorder::default());
    four_bar.draw_velocities(&mut velocities, &Arrows::new(0.5, 2));
    four_bar.draw_accelerations(&mut accelerations, &Arrows::new(0.25, 2));
    let tips = [velocities.tips(), accelerations.tips()];
    assert_eq!(
        tips.each_ref().map(Vec::len),
        [3, 3],
        "the crank's pin, the coupler's tip, the rocker's pin"
    );
    let points = [four_bar.crank_pin(), four_bar.coupler_tip()];
    let ends = [&before, &after].map(|four_bar| [four_bar.crank_pin(), four_bar.coupler_tip()]);
    for (number, point) in points.into_iter().enumerate() {
        let moved = (ends[1][number] - ends[0][number]) / (2.0 * step);
        let faster = (rates(&after)[number] - rates(&before)[number]) / (2.0 * step);
        for (tips, vector) in tips.iter().zip([moved * 0.5, faster * 0.25]) {
            let tip = point + vector;
            let found = tips.iter().any(|found| (found[0] - tip.x).hypot(found[1] - tip.y) < 1e-7);
            assert!(found, "{tip} in {tips:?}");
        }
    }
}

#[test]
fn what_is_not_shown_is_not_in_the_diagram() {
    let mut part = Part::new();
    part.move_with([0.7], [1.0]).expect("it turns");
    let mut recorder = Recorder::default();
    part.draw_overlay(&mut recorder, &Overlay::new());
    let mut places = recorder.circles.clone();
    places.dedup();
    assert_eq!(places.len(), 3, "the shafts of crank and rocker, the crank's pin: {places:?}");
    let mut arrows = Recorder::default();
    part.draw_velocities(&mut arrows, &Arrows::new(1.0, 2));
    assert_eq!(arrows.tips().len(), 1, "the coupler's points are not known");
    part.move_to([0.8]).expect("it turns");
    let mut still = Recorder::default();
    part.draw_velocities(&mut still, &Arrows::new(1.0, 2));
    assert!(still.polygons.is_empty(), "it stands still");
}

#[test]
fn springs_and_dampers_end_at_their_points_and_lie_side_by_side() {
    let mut suspension = Suspension::new();
    for angle in [0.0, 0.3, -0.4] {
        suspension.move_to([angle]).expect("it turns");
        let mut recorder = Recorder::default();
        suspension.draw_overlay(&mut recorder, &Overlay::new().motors(false));
        let strut = suspension.arm_strut();
        let ([x, y], [u, v]) = ([strut.x, strut.y], [1.0 - strut.x, 1.0 - strut.y]);
        let length = u.hypot(v);
        // Ahead of the strut and to the left of the line to the seat, in pixels.
        let seen = |at: &Vector| {
            let (dx, dy) = (1_000.0 * (at[0] - x), 1_000.0 * (at[1] - y));
            [(dx * u + dy * v) / length, (dy * u - dx * v) / length]
        };
        let places: Vec<Vector> = recorder.polygons.iter().flatten().map(seen).collect();
        let between = |at: &&Vector| (10.0..1_000.0 * length - 10.0).contains(&at[0]);
        let beside: Vec<f64> = places.iter().filter(between).map(|at| at[1]).collect();
        let (left, right) = (
            beside.iter().filter(|side| (2.0..15.0).contains(*side)).count(),
            beside.iter().filter(|side| (-15.0..-2.0).contains(*side)).count(),
        );
        assert!(left >= 12 && right >= 8, "a zigzag {left}, a cylinder {right}");
        for end in [0.0, 1_000.0 * length] {
            let touching = places.iter().filter(|at| (at[0] - end).hypot(at[1]) < 1.5);
            assert!(touching.count() >= 2, "a spring and a damper at {end}");
        }
    }
}

#[test]
fn a_diagram_has_a_circle_at_every_pin() {
    let mut four_bar = FourBar::new();
    four_bar.move_to([1.0]).expect("it turns");
    let mut recorder = Recorder::default();
    four_bar.draw_overlay(&mut recorder, &Overlay::new().links(true));
    let (pin, tip) = (four_bar.crank_pin(), four_bar.coupler_tip());
    for [x, y] in [[0.0, 0.0], [4.0, 0.0], [pin.x, pin.y], [tip.x, tip.y]] {
        let found = recorder.circles.iter().any(|at| (at[0] - x).hypot(at[1] - y) < 1e-12);
        assert!(found, "{x}, {y} in {:?}", recorder.circles);
    }
}
