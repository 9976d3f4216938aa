//! Plots, exports, examples and arrows, as far as they are measured. The rest is `scripts/plots.txt`.

use super::user::User;
use mech_studio::editor::ArrowKind;
use std::fs;
use std::path::PathBuf;

const FOUR_BAR: &str = include_str!("scripts/plotted.mech");

/// A folder of its own for what a test writes.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("mech-plots-{}-{name}", std::process::id()));
        fs::create_dir_all(&path).expect("a folder");
        Self(path)
    }

    fn file(&self, name: &str) -> String {
        self.0.join(name).display().to_string()
    }

    /// Returns the file that `mech` writes.
    fn mech(&self, words: &[&str]) -> Vec<u8> {
        self.mech_of(FOUR_BAR, words)
    }

    /// Returns the file that `mech` writes for a text.
    fn mech_of(&self, source: &str, words: &[&str]) -> Vec<u8> {
        let text = self.file("text.mech");
        fs::write(&text, source).expect("the text");
        let answer = self.file(words[words.len() - 1]);
        let mut all = vec!["mech".to_owned(), words[0].to_owned(), text];
        all.extend(words[1..words.len() - 1].iter().map(|word| (*word).to_owned()));
        all.extend(["-o".to_owned(), answer.clone()]);
        let mut console = mech_studio::Console::to(std::io::sink(), std::io::sink());
        mech_studio::run(all.into_iter().map(Into::into), &mut console);
        fs::read(answer).expect("what mech wrote")
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// Somebody who plots two quantities of a four-bar linkage.
fn plotting() -> User {
    let mut user = User::with_text(FOUR_BAR);
    user.click_on("Plots");
    for name in ["d", "velocity:coupler.tip.norm"] {
        user.enter("Quantity", name);
    }
    user
}

#[test]
fn a_table_is_what_mech_writes_and_what_the_graph_says() {
    let mut user = plotting();
    assert!(user.sees("graph of deg") && user.sees("graph of unit/s"));
    let folder = Folder::new("table");
    let path = folder.file("window.csv");
    user.export("Table as CSV", &path);
    let written = fs::read_to_string(&path).unwrap_or_else(|_| panic!("{}", user.said()));
    let table = folder.mech(&["table", "d", "velocity:coupler.tip.norm", "mech.csv"]);
    assert_eq!(written.as_bytes(), table);
    // The graphs say the same numbers where the motor stands.
    for row in [0, 90, 217] {
        let cells: Vec<f64> = written
            .lines()
            .nth(row + 1)
            .expect("a row")
            .split(',')
            .map(|cell| cell.parse().expect("a number"))
            .collect();
        user.scrub(cells[0].to_radians());
        assert!(user.sees(&format!("d = {:.4} deg", cells[1])), "{row}: {}", user.labels());
        assert!(user.sees(&format!("velocity:coupler.tip.norm = {:.4} unit/s", cells[2])), "{row}");
    }
}

#[test]
fn a_quantity_is_plotted_over_another() {
    let mut user = User::with_text(FOUR_BAR);
    user.click_on("Plots");
    user.enter("Quantity", "coupler.tip.y");
    user.click_on("Over the motor");
    user.click_on_beginning("of point coupler.tip");
    user.click_on("coupler.tip.x");
    assert!(user.sees("Over coupler.tip.x"), "{}", user.labels());
    let folder = Folder::new("over");
    let path = folder.file("window.csv");
    user.export("Table as CSV", &path);
    let written = fs::read_to_string(&path).unwrap_or_else(|_| panic!("{}", user.said()));
    let table = folder.mech(&["table", "coupler.tip.y", "--over=coupler.tip.x", "mech.csv"]);
    assert_eq!(written.as_bytes(), table);
    // The legend says where it is at the pose, and a press leads to the nearest place of the curve.
    let row = written.lines().nth(91).expect("a row");
    let (_, y) = row.split_once(',').expect("two numbers");
    let y: f64 = y.parse().expect("a number");
    user.scrub(90_f64.to_radians());
    assert!(user.sees(&format!("coupler.tip.y = {y:.4} unit")), "{}", user.labels());
    for at in [[0.1, 0.1], [0.9, 0.9]] {
        user.click_within("graph of unit", at);
        let [motor] = user.editor().player().expect("it moves").motors() else {
            panic!("one motor");
        };
        // One of the rows: whole degrees.
        let degrees = motor.to_degrees();
        assert!((degrees - degrees.round()).abs() < 1e-9, "{degrees}");
    }
    // It goes back to being over the motor.
    user.click_on("Over coupler.tip.x");
    user.click_on("the motor");
    assert!(user.sees("Over the motor"));
}

#[test]
fn exports_are_what_mech_writes() {
    let mut user = User::with_text(FOUR_BAR);
    let folder = Folder::new("exports");
    let kinds = [
        ("Picture as PNG", "draw", "png"),
        ("Picture as SVG", "draw", "svg"),
        ("Film as moving SVG", "film", "svg"),
        ("Plots as SVG", "plot", "svg"),
    ];
    for (name, command, ending) in kinds {
        let path = folder.file(&format!("window-{command}.{ending}"));
        user.export(name, &path);
        let written = fs::read(&path).unwrap_or_else(|_| panic!("{}", user.said()));
        let expected = folder.mech(&[command, &format!("mech-{command}.{ending}")]);
        assert_eq!(written, expected, "{name}");
    }
    let path = folder.file("four_bar.rs");
    user.export("Rust source", &path);
    let document = mech_studio::Document::of(mech_studio::Source::new(
        &path,
        fs::read_to_string(&path).expect("the source"),
    ));
    let reading =
        document.analyse(document.choose(None).expect("a mechanism")).expect("it is read");
    assert!(reading.result.is_ok());
    user.export("Picture as PNG", &folder.file("nowhere/picture.png"));
    assert!(user.editor().notice().is_some_and(|notice| notice.is_refusal), "{}", user.said());
}

#[test]
fn every_example_opens_and_plays() {
    let mut user = User::new();
    user.click_on("File");
    let before = user.names();
    user.click_on_beginning("Examples");
    let mut names = user.names();
    names.retain(|name| !before.contains(name));
    assert_eq!(names.len(), 12, "{names:#?}");
    user.click_on("File");
    for name in names {
        let (_, name) = name.split_once(' ').expect("what it is, and its name");
        user.click_on("File");
        user.click_on_beginning("Examples");
        user.click_on(name);
        assert!(!user.text().contains("mechanism!"), "{}", user.text());
        user.click_on("Play");
        user.wait(30);
        let player = user.editor().player();
        let player = player.unwrap_or_else(|| panic!("{name}: {}", user.said()));
        let is_moving = player.plays() && !player.mechanism().is_at_start();
        assert!(is_moving, "{name}: {}", user.said());
    }
}

#[test]
fn arrows_are_what_the_path_says() {
    let mut user = User::with_text(FOUR_BAR);
    user.show("Velocities");
    user.show("Accelerations");
    user.show("Forces");
    let at = 1.0;
    let step = 1e-4;
    let mut places = |value| -> Vec<[f64; 2]> {
        user.scrub(value);
        let arrows = user.editor().arrows();
        let velocities = arrows.iter().filter(|arrow| arrow.kind == ArrowKind::Velocity);
        velocities.map(|arrow| arrow.place).collect()
    };
    let places = [at - step, at + step, at].map(&mut places);
    let arrows = user.editor().arrows();
    let of = |kind| arrows.iter().filter(move |arrow| arrow.kind == kind);
    assert!(of(ArrowKind::Velocity).count() >= 3);
    for (number, (velocity, acceleration)) in
        of(ArrowKind::Velocity).zip(of(ArrowKind::Acceleration)).enumerate()
    {
        for part in 0..2 {
            let [before, after, here] = places.each_ref().map(|places| places[number][part]);
            let speed = (after - before) / (2.0 * step);
            let change = (after - 2.0 * here + before) / (step * step);
            assert!((velocity.vector[part] - speed).abs() < 1e-6, "{velocity:?} {speed}");
            assert!((acceleration.vector[part] - change).abs() < 1e-4, "{acceleration:?} {change}");
        }
    }
}

#[test]
fn what_a_lecture_constructs_is_shown_at_the_present_pose() {
    let text = FOUR_BAR
        .replace("motor a;", "motor a;\nload push = force(coupler.tip);\neffects { force; }");
    let mut user = User::with_text(&text);
    let has = |user: &User, words: &str| {
        let texts = user.editor().constructed();
        texts.iter().any(|text| text == words)
    };
    assert!(user.editor().constructed().is_empty());
    user.show("Instant centres");
    assert!(has(&user, "ground coupler"), "{:?}", user.editor().constructed());
    user.show("Velocity polygon");
    user.show("Acceleration polygon");
    assert!(has(&user, "velocities, a at 1 rad/s"));
    assert!(has(&user, "accelerations, a at 1 rad/s"));
    // Nothing pushes yet.
    user.show("Free bodies");
    assert!(!has(&user, "coupler"));
    user.click_on("Plots");
    user.enter("load push", "3, -40");
    assert!(has(&user, "coupler"), "{:?}", user.editor().constructed());
    assert!(has(&user, "push 40.11"), "{:?}", user.editor().constructed());
    for name in ["Instant centres", "Velocity polygon", "Acceleration polygon", "Free bodies"] {
        user.show(name);
    }
    assert!(user.editor().constructed().is_empty());
    user.show("Inflection circles");
    assert!(user.editor().constructed().is_empty(), "no link is selected");
    let ends = user.ends_of("coupler");
    user.click([0, 1].map(|part| f64::midpoint(ends[0][part], ends[1][part])));
    assert!(has(&user, "inflection circle of coupler"), "{:?}", user.editor().selection());
    user.show("Inflection circles");
    user.show("Centrodes");
    for name in ["fixed centrode of coupler", "moving centrode of coupler"] {
        assert!(has(&user, name), "{:?}", user.editor().constructed());
    }
    user.show("Centrodes");
    assert!(user.editor().constructed().is_empty());
}

#[test]
fn a_load_acts_in_plots_and_arrows() {
    let text = FOUR_BAR
        .replace("motor a;", "motor a;\nload push = force(coupler.tip);\neffects { force; }");
    let mut user = User::with_text(&text);
    user.click_on("Plots");
    user.enter("Quantity", "torque:a");
    user.show("Forces");
    assert!(user.editor().arrows().is_empty(), "nothing acts yet");
    user.enter("load push", "3, -40");
    assert_eq!(user.editor().arrows().len(), 4, "{}", user.said());
    let folder = Folder::new("load");
    let path = folder.file("window.csv");
    user.export("Table as CSV", &path);
    let written = fs::read_to_string(&path).unwrap_or_else(|_| panic!("{}", user.said()));
    let table = folder.mech_of(&text, &["table", "torque:a", "--load=push=3,-40", "mech.csv"]);
    assert_eq!(written.as_bytes(), table);
    user.scrub(0.0);
    let first = written.lines().nth(1).and_then(|line| line.split(',').nth(1));
    let first: f64 = first.and_then(|cell| cell.parse().ok()).expect("a number");
    assert!(
        first != 0.0 && user.sees(&format!("torque:a at rest = {first:.4}")),
        "{first}\n{}",
        user.labels()
    );

    // A load that cannot be read counts as nothing.
    user.enter("load push", "x");
    assert!(user.editor().arrows().is_empty(), "{}", user.said());
}
