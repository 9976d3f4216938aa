//! The terminal view, in a pseudo-terminal of 80 columns and 24 rows that `script` of util-linux makes.

use crate::gallery::{mechanism, path, picture};
use mech_runtime::overlay::Spot;
use mech_studio::play::half_blocks::{Depth, lines};
use mech_studio::play::{Control, Player};
use std::io::{Read, Write};
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, Instant};

const COLUMNS: usize = 80;
const ROWS: usize = 24;

/// A place of the screen: the letter, its colour and that of its background.
type Cell = (char, [u8; 3], [u8; 3]);

/// The screen of a terminal that understands all that is written here.
#[derive(Clone, Debug, PartialEq)]
struct Screen {
    cells: Vec<Vec<Cell>>,
    row: usize,
    column: usize,
    colors: [[u8; 3]; 2],
}

impl Screen {
    fn new() -> Self {
        Self {
            cells: vec![vec![(' ', [0; 3], [0; 3]); COLUMNS]; ROWS],
            row: 0,
            column: 0,
            colors: [[0; 3]; 2],
        }
    }

    fn after(text: &str) -> Self {
        let mut screen = Self::new();
        let mut rest = text.chars();
        while let Some(letter) = rest.next() {
            match letter {
                '\x1b' => {
                    if rest.next() == Some('[') {
                        let parameters: String =
                            rest.clone().take_while(|c| !c.is_ascii_alphabetic()).collect();
                        let last = rest.nth(parameters.chars().count());
                        screen.control(&parameters, last);
                    }
                }
                '\r' => screen.column = 0,
                '\n' => screen.row += 1,
                letter => {
                    let [color, background] = screen.colors;
                    let row = screen.cells.get_mut(screen.row);
                    // Lines are not wrapped.
                    if let Some(cell) = row.and_then(|row| row.get_mut(screen.column)) {
                        *cell = (letter, color, background);
                    }
                    screen.column += 1;
                }
            }
        }
        screen
    }

    fn control(&mut self, parameters: &str, last: Option<char>) {
        let numbers: Vec<usize> =
            parameters.split(';').map(|number| number.parse().unwrap_or(0)).collect();
        match (last, &numbers[..]) {
            (Some('H'), [row, column]) => (self.row, self.column) = (row - 1, column - 1),
            (Some('K'), _) => {
                for cell in self.cells[self.row].iter_mut().skip(self.column) {
                    *cell = (' ', [0; 3], [0; 3]);
                }
            }
            (Some('m'), [0]) => self.colors = [[0; 3]; 2],
            (Some('m'), [38, 2, front @ .., 48, 2, r, g, b]) => {
                let byte = |&number: &usize| u8::try_from(number).expect("a byte");
                let [x, y, z] = front else {
                    panic!("three channels");
                };
                self.colors = [[x, y, z].map(byte), [r, g, b].map(byte)];
            }
            (Some('h' | 'l'), _) => {}
            other => panic!("nobody knows {parameters}{other:?}"),
        }
    }

    fn line(&self, row: usize) -> String {
        let text: String = self.cells[row].iter().map(|cell| cell.0).collect();
        text.trim_end().to_owned()
    }
}

/// The player in a terminal of its own.
struct Session {
    script: Child,
    keys: ChildStdin,
    written: Arc<Mutex<Vec<u8>>>,
}

impl Session {
    fn start(file: &str, arguments: &str) -> Self {
        let mech = env!("CARGO_BIN_EXE_mech");
        let file = path(file);
        let line = format!(
            "stty rows {ROWS} cols {COLUMNS}; exec {mech} play '{}' {arguments}",
            file.display()
        );
        let mut script = Command::new("script")
            .args(["-qfec", &line, "/dev/null"])
            .env("COLORTERM", "truecolor")
            .env("TERM", "xterm-256color")
            .env_remove("DISPLAY")
            .env_remove("WAYLAND_DISPLAY")
            .env_remove("WAYLAND_SOCKET")
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("`script` of util-linux makes a pseudo-terminal");
        let keys = script.stdin.take().expect("piped");
        let mut output = script.stdout.take().expect("piped");
        let written = Arc::new(Mutex::new(Vec::new()));
        let reader = Arc::clone(&written);
        thread::spawn(move || {
            let mut bytes = [0; 4096];
            while let Ok(count @ 1..) = output.read(&mut bytes) {
                reader.lock().expect("not poisoned").extend_from_slice(&bytes[..count]);
            }
        });
        Self { script, keys, written }
    }

    fn written(&self) -> String {
        let bytes = self.written.lock().expect("not poisoned").clone();
        String::from_utf8_lossy(&bytes).into_owned()
    }

    fn screen(&self) -> Screen {
        let text = self.written();
        // Only whole pictures.
        let end = text.rfind("\x1b[?2026l").unwrap_or(0);
        Screen::after(&text[..end])
    }

    fn press(&mut self, keys: &str) {
        self.keys.write_all(keys.as_bytes()).expect("it listens");
        self.keys.flush().expect("it listens");
    }

    /// Waits until the screen is as it should be.
    fn until(&self, what: &str, is_so: impl Fn(&Screen) -> bool) -> Screen {
        let begin = Instant::now();
        loop {
            let screen = self.screen();
            if is_so(&screen) {
                return screen;
            }
            let lines: Vec<String> = (0..ROWS).map(|row| screen.line(row)).collect();
            assert!(begin.elapsed() < Duration::from_secs(20), "not {what}:\n{}", lines.join("\n"));
            thread::sleep(Duration::from_millis(20));
        }
    }

    /// Waits for its end; whether it ended well.
    fn end(mut self) -> (bool, String) {
        let begin = Instant::now();
        loop {
            if let Some(status) = self.script.try_wait().expect("it can be asked") {
                thread::sleep(Duration::from_millis(50));
                return (status.success(), self.written());
            }
            assert!(begin.elapsed() < Duration::from_secs(20), "it does not end");
            thread::sleep(Duration::from_millis(20));
        }
    }
}

impl Drop for Session {
    /// Whatever failed, nothing goes on playing.
    fn drop(&mut self) {
        let _ = self.script.kill();
        let _ = self.script.wait();
    }
}

/// Whether the terminal is left as it was found.
fn is_restored(written: &str) -> bool {
    let (_, after) = written.rsplit_once("\x1b[?1049h").expect("another screen");
    ["\x1b[?1049l", "\x1b[?25h", "\x1b[?7h", "\x1b[?1000l"]
        .iter()
        .all(|sequence| after.contains(sequence))
}

#[test]
fn plays_in_a_terminal() {
    let mut session = Session::start("four_bar", "--terminal");
    let status = |screen: &Screen| screen.line(ROWS - 2);
    let first = session.until("playing", |screen| status(screen).contains("playing own motion"));
    assert!(status(&first).starts_with("CrankRocker · a "), "{}", status(&first));
    assert_eq!(first.line(ROWS - 1), "h help · q quit");
    session.until("moving", |screen| screen.cells != first.cells);

    // Paused at the start: the very pixels of the painter, two in each character.
    session.press(" r");
    let paused =
        session.until("paused at the start", |screen| status(screen).contains("a 0.0° · paused"));
    thread::sleep(Duration::from_millis(300));
    assert_eq!(session.screen().cells, paused.cells);
    let size = [COLUMNS, 2 * (ROWS - 2)];
    let player = Player::new(mechanism("four_bar"), Vec::new(), size);
    let picture = picture(&player);
    for (row, cells) in paused.cells.iter().take(ROWS - 2).enumerate() {
        for (column, &(letter, above, below)) in cells.iter().enumerate() {
            let pixel = |row: usize| {
                let [r, g, b, _] = picture.pixels()[row * COLUMNS + column];
                [r, g, b]
            };
            assert_eq!((letter, above, below), ('▀', pixel(2 * row), pixel(2 * row + 1)));
        }
    }

    // A step, by the key that the help names.
    session.press("\x1b[C");
    session.until("a step on", |screen| status(screen).contains("a 3.0° · paused"));
    // The mouse: the middle of the rocker is somewhere in the picture; pressed, moved and let go.
    let rocker = Spot { link: 3, at: [1.5, 0.0] };
    let [x, y] = player.pixel(rocker).expect("it is there");
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "in 80 by 24")]
    let (column, row) = (x as usize + 1, (y / 2.0) as usize + 1);
    session.press(&format!("\x1b[<0;{column};{row}M"));
    session.press(&format!("\x1b[<32;{};{row}M\x1b[<0;{};{row}m", column + 6, column + 6));
    session.until("dragged", |screen| !status(screen).contains(" a 3.0°"));
    session.press("h");
    session.until("help", |screen| (0..ROWS).any(|row| screen.line(row).contains("day or night")));
    session.press("q");
    let (is_well, written) = session.end();
    assert!(is_well && is_restored(&written));
}

#[test]
fn stops_at_a_limit_in_a_terminal_and_by_ctrl_c() {
    let mut session = Session::start("crane", "--terminal");
    session.press("\t++");
    session.until("stopped", |screen| {
        // The sentence takes two lines.
        screen.line(ROWS - 3).contains("motor `luff` stopped at 82.")
            && screen.line(ROWS - 2).ends_with("does not close there")
    });
    session.press("\x03");
    let (is_well, written) = session.end();
    assert!(is_well && is_restored(&written));
}

#[test]
fn without_a_display_the_terminal_is_offered() {
    let mut session = Session::start("watt", "");
    let begin = Instant::now();
    while !session.written().contains("play in this terminal instead") {
        assert!(begin.elapsed() < Duration::from_secs(20), "{}", session.written());
        thread::sleep(Duration::from_millis(20));
    }
    assert!(session.written().starts_with("there is no display: "), "{}", session.written());
    session.press("\r");
    session.until("playing", |screen| screen.line(ROWS - 2).contains("playing own motion"));
    session.press("q");
    let (is_well, written) = session.end();
    assert!(is_well && is_restored(&written));

    let mut session = Session::start("watt", "");
    session.press("n\r");
    let (is_well, written) = session.end();
    assert!(is_well && !written.contains("\x1b["), "{written}");
}

#[test]
fn without_a_terminal_and_a_display_it_says_so() {
    for arguments in [&["--terminal"][..], &[]] {
        let output = Command::new(env!("CARGO_BIN_EXE_mech"))
            .arg("play")
            .arg(path("four_bar"))
            .args(arguments)
            .env_remove("DISPLAY")
            .env_remove("WAYLAND_DISPLAY")
            .env_remove("WAYLAND_SOCKET")
            .stdin(Stdio::null())
            .output()
            .expect("it runs");
        assert_eq!(output.status.code(), Some(2));
        let error = String::from_utf8(output.stderr).expect("text");
        assert!(error.starts_with("error: ") && error.lines().count() == 1, "{error}");
        assert!(error.contains("--terminal") && error.contains("--picture FILE"), "{error}");
        // Advice that was tried in vain is not given again.
        let advises = error.contains("play in a terminal with `--terminal`");
        assert_eq!(advises, arguments.is_empty(), "{error}");
    }
}

#[test]
fn without_true_color_there_are_256() {
    let mut player = Player::new(mechanism("crane"), Vec::new(), [40, 20]);
    player.obey(Control::DayOrNight);
    let text = lines(&picture(&player), Depth::Cube);
    assert_eq!(text.len(), 10);
    for line in text {
        assert_eq!(line.matches('▀').count(), 40);
        assert!(line.contains("\x1b[38;5;") && !line.contains(";2;"), "{line}");
    }
}
