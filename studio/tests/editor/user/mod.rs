//! Somebody who uses the studio, and counts the gestures.

mod pointer;

use eframe::egui::accesskit::Role;
use eframe::egui::{
    DroppedFile, Event, Key, Modifiers, OutputCommand, Pos2, Rect, Shape, Vec2, ViewportCommand,
    ViewportEvent, ViewportId,
};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};
use mech_studio::Workspace;
use mech_studio::editor::{Drawing, Editor, Studio};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// A file that is dropped on the window.
#[derive(Debug)]
struct Dropped(PathBuf);

impl DroppedFile for Dropped {
    fn path(&self) -> &Path {
        &self.0
    }

    fn bytes(&self) -> Result<Vec<u8>, String> {
        std::fs::read(&self.0).map_err(|error| error.to_string())
    }
}

pub(crate) struct User {
    harness: Harness<'static, Studio>,
    gestures: usize,
    modifiers: Modifiers,
}

impl User {
    /// Before a window of usual size, with an empty text.
    pub(crate) fn new() -> Self {
        Self::with_text("")
    }

    /// Before this text.
    pub(crate) fn with_text(text: &str) -> Self {
        Self::with_file("test.mech", text)
    }

    /// Before a file of this name with this text, which nobody has written.
    pub(crate) fn with_file(name: &str, text: &str) -> Self {
        Self::before_window([1280.0, 800.0], name, text)
    }

    /// Before an empty text that nobody has named.
    pub(crate) fn without_file() -> Self {
        let editor = Editor::immediate(Workspace::default());
        Self::before_studio([1280.0, 800.0], Studio::new(editor))
    }

    /// With a telephone, on which nothing is written yet.
    pub(crate) fn with_telephone() -> Self {
        Self::before_window([390.0, 760.0], "test.mech", "")
    }

    fn before_window(size: [f32; 2], name: &str, text: &str) -> Self {
        let editor = Editor::immediate(Workspace::unsaved(name, text));
        Self::before_studio(size, Studio::new(editor))
    }

    /// With the page in a browser, which has no threads.
    pub(crate) fn in_browser() -> Self {
        let editor = Editor::in_pieces(Workspace::unsaved("test.mech", ""));
        let mut user = Self::before_studio([1280.0, 800.0], Studio::new(editor));
        user.settle();
        user
    }

    /// At a computer, where the analysis goes on beside the window.
    pub(crate) fn with_threads() -> Self {
        let editor = Editor::new(Workspace::unsaved("test.mech", ""), || {});
        let mut user = Self::before_studio([1280.0, 800.0], Studio::new(editor));
        user.settle();
        user
    }

    /// Waits until the analysis is done, however it goes, and shown.
    pub(crate) fn settle(&mut self) {
        self.wait_until("it is not done", |user| !user.editor().is_busy());
        self.wait(2);
    }

    /// Before a file on the disk, which is watched; its text is kept while it is not saved. What has no file is kept in a folder beside it.
    pub(crate) fn at_file(path: &Path) -> Self {
        let workspace = if path.exists() {
            Workspace::open(path, None).expect("it can be read")
        } else {
            Workspace::unsaved(path, "")
        };
        let editor = Editor::immediate(workspace);
        Self::before_studio(
            [1280.0, 800.0],
            Studio::guarded(editor, path.with_file_name("unnamed"), || {}),
        )
    }

    fn before_studio(size: [f32; 2], studio: Studio) -> Self {
        let mut harness = Harness::builder()
            .with_size(size)
            .with_step_dt(1.0 / 60.0)
            .build_ui_state(|ui, studio: &mut Studio| studio.show(ui), studio);
        harness.run_steps(2);
        Self { harness, gestures: 0, modifiers: Modifiers::NONE }
    }

    /// Does several things before the window is shown again.
    pub(crate) fn at_once(&mut self, act: impl FnOnce(&mut Editor)) {
        act(self.harness.state_mut().editor_mut());
    }

    /// Returns the number of gestures that were made: clicks, drags and keys.
    pub(crate) fn gestures(&self) -> usize {
        self.gestures
    }

    pub(crate) fn editor(&self) -> &Editor {
        self.harness.state().editor()
    }

    pub(crate) fn text(&self) -> &str {
        self.editor().workspace().text()
    }

    /// Where a place of the scene is seen in the window.
    pub(crate) fn pixel(&self, place: [f64; 2]) -> Pos2 {
        let canvas = self.harness.get_by_label("drawing").rect();
        let [x, y] = self.editor().sight().camera().pixel(place);
        #[expect(clippy::cast_possible_truncation, reason = "pixels of a window")]
        let from = Vec2::new(x as f32, y as f32);
        canvas.min + from
    }

    /// Clicks what has this name: a button, a handle.
    #[track_caller]
    pub(crate) fn click_on(&mut self, label: &str) {
        self.harness.get_by_label(label).click();
        self.harness.run_steps(3);
        self.gestures += 1;
    }

    /// Clicks the one whose name begins with this.
    #[track_caller]
    pub(crate) fn click_on_beginning(&mut self, label: &str) {
        let found = |node: &egui_kittest::kittest::AccessKitNode<'_>| {
            node.label().is_some_and(|name| name.starts_with(label))
        };
        self.harness.get_by(found).click();
        self.harness.run_steps(3);
        self.gestures += 1;
    }

    /// All that may help to see what went wrong.
    pub(crate) fn said(&self) -> String {
        let editor = self.editor();
        format!("{:?}\n{:#?}\n{}", editor.notice(), editor.messages(), self.text())
    }

    /// Whether what was told last has these words.
    pub(crate) fn tells(&self, words: &str) -> bool {
        let notice = self.editor().notice();
        notice.is_some_and(|notice| notice.text.contains(words))
    }

    /// Whether something of this name is in the window.
    pub(crate) fn sees(&self, label: &str) -> bool {
        self.harness.query_all_by_label_contains(label).next().is_some()
    }

    /// Whether a line of dashes goes from one place of the scene to another.
    pub(crate) fn sees_dashes(&self, from: [f64; 2], to: [f64; 2]) -> bool {
        let [from, to] = [from, to].map(|place| self.pixel(place));
        let way = to - from;
        let is_on_it = |point: &Pos2| {
            let part = (*point - from).dot(way) / way.length_sq();
            (0.0..=1.0).contains(&part) && point.distance(from + part * way) < 1.0
        };
        let shapes = self.harness.output().shapes.iter();
        let dashes = shapes.filter_map(|clipped| match &clipped.shape {
            Shape::LineSegment { points, .. } => Some(points),
            _ => None,
        });
        let on_it = dashes.filter(|points| points.iter().all(is_on_it));
        let lengths = on_it.map(|[one, other]| one.distance(*other));
        (0.4..0.9).contains(&(lengths.sum::<f32>() / way.length()))
    }

    /// Whether a ring of the size of a pin is about a place of the scene.
    pub(crate) fn sees_ring(&self, place: [f64; 2]) -> bool {
        let center = self.pixel(place);
        let mut shapes = self.harness.output().shapes.iter();
        shapes.any(|clipped| match &clipped.shape {
            Shape::Circle(ring) => ring.center.distance(center) < 1.0 && ring.radius > 5.0,
            _ => false,
        })
    }

    /// Where something of this name is in the window.
    #[track_caller]
    pub(crate) fn place_of(&self, label: &str) -> Rect {
        self.harness.get_by_label(label).rect()
    }

    /// The names of all joints, points and lines that are seen, as a reader tells them.
    pub(crate) fn handles(&self) -> Vec<String> {
        let canvas = self.place_of("drawing").shrink(12.0);
        let handles = self.editor().drawing().into_iter().flat_map(Drawing::handles);
        let seen = handles.filter(|handle| canvas.contains(self.pixel(handle.place)));
        seen.map(|handle| handle.item.to_string()).collect()
    }

    /// Where a handle is in the scene.
    pub(crate) fn scene_place_of(&self, label: &str) -> Option<[f64; 2]> {
        let mut handles = self.editor().drawing()?.handles();
        let found = handles.find(|handle| handle.item.to_string() == label);
        found.map(|handle| handle.place)
    }

    /// Where the points and joints of a link are drawn in the scene.
    pub(crate) fn ends_of(&self, link: &str) -> Vec<[f64; 2]> {
        let drawing = self.editor().drawing();
        drawing.and_then(|drawing| drawing.places_of(link)).unwrap_or_default()
    }

    /// Makes a repair that is offered, by its number from 1.
    pub(crate) fn mend(&mut self, number: usize) {
        self.click_on_beginning("Diagnoses");
        self.click_on_beginning(&format!("Repair {number}:"));
        self.click_on("Text");
    }

    /// Presses a key with Ctrl, perhaps with Shift.
    pub(crate) fn shortcut(&mut self, key: Key, with_shift: bool) {
        let modifiers =
            if with_shift { Modifiers::COMMAND | Modifiers::SHIFT } else { Modifiers::COMMAND };
        self.harness.key_press_modifiers(modifiers, key);
        self.harness.run_steps(2);
        self.gestures += 1;
    }

    /// Copies what is selected, and pastes it.
    pub(crate) fn copy_and_paste(&mut self) {
        self.harness.event(Event::Copy);
        self.harness.run_steps(1);
        self.harness.event(Event::Paste(String::new()));
        self.harness.run_steps(2);
        self.gestures += 2;
    }

    /// Copies what is selected. Returns what the clipboard has then.
    pub(crate) fn copy(&mut self) -> String {
        self.harness.event(Event::Copy);
        let mut copied = String::new();
        for _ in 0..2 {
            self.harness.run_steps(1);
            for command in &self.harness.output().platform_output.commands {
                if let OutputCommand::CopyText(text) = command {
                    copied.clone_from(text);
                }
            }
        }
        copied
    }

    pub(crate) fn paste(&mut self, text: &str) {
        self.harness.event(Event::Paste(text.to_owned()));
        self.harness.run_steps(3);
    }

    /// Lets the keys go to what has this name.
    pub(crate) fn focus(&mut self, label: &str) {
        self.harness.get_by_label(label).focus();
        self.harness.run_steps(2);
    }

    pub(crate) fn type_text(&mut self, text: &str) {
        self.harness.event(Event::Text(text.to_owned()));
        self.harness.run_steps(2);
        self.gestures += 1;
    }

    pub(crate) fn key(&mut self, key: Key) {
        self.modifiers = Modifiers::NONE;
        self.harness.event(Event::ModifiersChanged(self.modifiers));
        self.harness.key_press(key);
        self.harness.run_steps(2);
        self.gestures += 1;
    }

    /// Waits until something is so, or for far too long.
    #[track_caller]
    pub(crate) fn wait_until(&mut self, what: &str, is_so: impl Fn(&Self) -> bool) {
        let begin = Instant::now();
        while !is_so(self) {
            assert!(begin.elapsed() < Duration::from_secs(30), "{what}: {}", self.said());
            std::thread::sleep(Duration::from_millis(5));
            self.harness.run_steps(1);
        }
    }

    pub(crate) fn drop_file(&mut self, path: &Path) {
        let dropped = Arc::new(Dropped(path.to_owned()));
        self.harness.input_mut().dropped_files.push(dropped);
        self.harness.run_steps(3);
        self.gestures += 1;
    }

    /// Comes back to the window from another one.
    pub(crate) fn focus_window(&mut self) {
        self.harness.event(Event::WindowFocused(true));
        self.harness.run_steps(2);
    }

    /// Wants to close the window. Returns whether it is closed.
    pub(crate) fn close(&mut self) -> bool {
        let viewports = &mut self.harness.input_mut().viewports;
        let viewport = viewports.entry(ViewportId::ROOT).or_default();
        viewport.events.push(ViewportEvent::Close);
        self.harness.run_steps(1);
        let is_closed = !self.has_said(&ViewportCommand::CancelClose);
        self.harness.run_steps(1);
        is_closed
    }

    /// Clicks what has this name. Returns whether that closes the window.
    pub(crate) fn closes_by(&mut self, label: &str) -> bool {
        self.harness.get_by_label(label).click();
        let mut is_closed = false;
        for _ in 0..3 {
            self.harness.run_steps(1);
            is_closed |= self.has_said(&ViewportCommand::Close);
        }
        // The window wants to be closed once more then.
        is_closed && self.close()
    }

    /// Says a line. Returns whether that closes the window.
    #[track_caller]
    pub(crate) fn ends_by(&mut self, line: &str) -> bool {
        self.harness.state_mut().editor_mut().say(line);
        self.harness.run_steps(1);
        self.has_said(&ViewportCommand::Close)
    }

    fn has_said(&self, command: &ViewportCommand) -> bool {
        let mut viewports = self.harness.output().viewport_output.values();
        viewports.any(|viewport| viewport.commands.contains(command))
    }

    pub(crate) fn wait(&mut self, pictures: usize) {
        self.harness.run_steps(pictures);
    }

    /// Types into the field of this name, and presses Enter.
    #[track_caller]
    pub(crate) fn enter(&mut self, label: &str, text: &str) {
        let field =
            |node: &egui_kittest::kittest::AccessKitNode<'_>| node.role() == Role::TextInput;
        self.harness.get_by(|node| field(node) && node.label().as_deref() == Some(label)).focus();
        self.harness.run_steps(2);
        self.type_text(text);
        self.key(Key::Enter);
    }

    /// Replaces the whole text, as somebody does who types.
    pub(crate) fn type_all(&mut self, text: &str) {
        self.harness.state_mut().editor_mut().type_text(text);
        self.harness.run_steps(3);
    }

    /// Moves the first motor to a value in radians or scene units.
    pub(crate) fn scrub(&mut self, value: f64) {
        self.harness.state_mut().editor_mut().sight_mut().scrub(0, value);
        self.harness.run_steps(2);
    }

    /// Writes what the menu calls so to a file.
    #[track_caller]
    pub(crate) fn export(&mut self, kind: &str, path: &str) {
        self.click_on("File");
        self.click_on_beginning("Export");
        self.click_on(kind);
        self.fill(path);
        self.click_on("Write");
    }

    #[track_caller]
    pub(crate) fn open(&mut self, path: &str) {
        self.click_on("File");
        self.click_on_beginning("Open");
        self.fill(path);
        self.key(Key::Enter);
    }

    /// Types a number into the field of this name.
    #[track_caller]
    pub(crate) fn enter_number(&mut self, label: &str, number: &str) {
        let field = |node: &egui_kittest::kittest::AccessKitNode<'_>| {
            node.role() == Role::SpinButton
                && node.labelled_by().any(|by| by.value().as_deref() == Some(label))
        };
        self.harness.get_by(field).click();
        self.harness.run_steps(2);
        self.fill(number);
        self.key(Key::Enter);
    }

    /// Names a file where one is asked for.
    #[track_caller]
    pub(crate) fn fill(&mut self, path: &str) {
        self.wait(2);
        self.harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
        self.wait(1);
        self.type_text(path);
    }

    /// Switches something of the menu View on or off.
    #[track_caller]
    pub(crate) fn show(&mut self, name: &str) {
        self.click_on("View");
        self.click_on_beginning(name);
    }

    /// The names of all that is in the window.
    pub(crate) fn labels(&self) -> String {
        let all = self.harness.query_all_by(|node| node.label().is_some());
        let labels: Vec<String> = all.filter_map(|node| node.accesskit_node().label()).collect();
        labels.join("\n")
    }

    /// Lists the roles and names of all widgets that have a name.
    pub(crate) fn names(&self) -> Vec<String> {
        let all = self.harness.query_all_by(|node| node.label().is_some());
        let name = |node: egui_kittest::Node<'_>| {
            let node = node.accesskit_node();
            format!("{:?} {}", node.role(), node.label().unwrap_or_default())
        };
        all.map(name).collect()
    }

    #[track_caller]
    pub(crate) fn open_menu_of(&mut self, label: &str) {
        self.harness.get_by_label(label).click_secondary();
        self.harness.run_steps(3);
    }
}
