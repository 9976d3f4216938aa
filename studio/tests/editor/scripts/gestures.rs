//! The gestures of scripts: each verb is a method of `User`, of the editor within a frame, or a change on the disk.

use super::judges::offers;
use super::words::Words;
use super::{Scene, Texts};
use crate::user::User;
use eframe::egui::{Key, Modifiers};
use mech_studio::editor::{Editor, Item, Tool};
use mech_studio::{Command, Workspace};
use std::time::Duration;
use std::{fs, thread};

impl Scene {
    /// Does what a verb says. Returns whether it is a gesture.
    pub(super) fn does(&mut self, verb: &str, words: &mut Words<'_>) -> Result<bool, String> {
        if let Some(user) = self.begun(verb, words)? {
            let noted = &mut self.texts.noted;
            noted.insert("start".to_owned(), user.text().to_owned());
            self.user = Some(user);
            return Ok(true);
        }
        if on_disk(&self.texts, verb, words)? {
            return Ok(true);
        }
        let Self { user, texts, .. } = self;
        match (verb, user) {
            ("crash", user) => *user = None,
            (_, None) => return Ok(false),
            ("note", Some(user)) => {
                texts.noted.insert(words.text()?, user.text().to_owned());
            }
            ("note-offers", Some(user)) => {
                texts.noted.insert(words.text()?, offers(user).join("\n"));
            }
            ("copy", Some(user)) => {
                texts.noted.insert("copied".to_owned(), user.copy());
            }
            ("paste", Some(user)) => user.paste(&texts.take(words)?),
            ("retype", Some(user)) => user.type_all(&texts.take(words)?),
            ("at-once", Some(user)) => at_once(user, texts, words.block.unwrap_or_default())?,
            (_, Some(user)) => {
                let is_gesture = by_pointer(user, verb, words)?
                    || by_keys(user, verb, words)?
                    || by_name(user, verb, words)?;
                return Ok(is_gesture);
            }
        }
        Ok(true)
    }

    /// Somebody who begins before a window, as a verb says. The window before is no more.
    fn begun(&mut self, verb: &str, words: &mut Words<'_>) -> Result<Option<User>, String> {
        let text = |words: &mut Words| self.texts.take(words);
        let user = match verb {
            "new" => User::new(),
            "unnamed" => User::without_file(),
            "text" => User::with_text(&text(words)?),
            "file" => User::with_file(&words.text()?, &text(words)?),
            "browser" => {
                let text = text(words)?;
                let mut user = User::in_browser();
                user.at_once(|editor| editor.type_text(&text));
                user.settle();
                user
            }
            "reopen" => {
                self.user = None;
                User::at_file(words.text()?.as_ref())
            }
            _ => return Ok(None),
        };
        Ok(Some(user))
    }
}

/// Does what other programs do with files.
fn on_disk(texts: &Texts, verb: &str, words: &mut Words<'_>) -> Result<bool, String> {
    let file = |words: &mut Words| Ok::<_, String>(texts.folder.0.join(words.text()?));
    let done = match verb {
        "make-folder" => fs::create_dir(file(words)?),
        "delete-file" => fs::remove_file(file(words)?),
        "write-file" => fs::write(file(words)?, texts.take(words)?),
        // Another file takes its place, as many editors do it.
        "replace-file" => {
            let (file, text) = (file(words)?, texts.take(words)?);
            let draft = file.with_extension("new");
            fs::write(&draft, text).and_then(|()| fs::rename(&draft, file))
        }
        _ => return Ok(false),
    };
    done.map_err(|error| error.to_string())?;
    Ok(true)
}

/// At places of the scene.
fn by_pointer(user: &mut User, verb: &str, words: &mut Words<'_>) -> Result<bool, String> {
    match verb {
        "at" => {
            for place in words.all(Words::place)? {
                user.click(place);
            }
        }
        "shift-at" => user.click_with_shift(words.place()?),
        "near" => user.click_near(words.place()?),
        "drag" => user.drag(words.place()?, words.place()?),
        "alt-drag" => user.drag_with(Modifiers::ALT, words.place()?, words.place()?),
        "ctrl-drag" => user.drag_with(Modifiers::COMMAND, words.place()?, words.place()?),
        "move" => user.move_handle(words.place()?, words.place()?),
        "rush" => user.rush(words.place()?, words.place()?),
        "hold" => user.hold(words.place()?, words.place()?),
        "let-go" => user.let_go(words.place()?),
        "click-within" => user.click_within(&words.text()?, words.place()?),
        _ => return Ok(false),
    }
    Ok(true)
}

/// By keys, and by what is no gesture.
fn by_keys(user: &mut User, verb: &str, words: &mut Words<'_>) -> Result<bool, String> {
    match verb {
        "key" => {
            for key in words.all(Words::key)? {
                user.key(key);
            }
        }
        "shortcut" => {
            let with_shift = words.takes("shift");
            user.shortcut(words.key()?, with_shift);
        }
        "undo" => user.shortcut(Key::Z, false),
        "redo" => user.shortcut(Key::Z, true),
        "copy-and-paste" => user.copy_and_paste(),
        "type" => user.type_text(&words.text()?),
        "wait" => user.wait(words.number()?),
        "settle" => user.settle(),
        "scrub" => user.scrub(words.number()?),
        "pause" => thread::sleep(Duration::from_millis(words.number()?)),
        "come-back" => user.focus_window(),
        _ => return Ok(false),
    }
    Ok(true)
}

/// With what has a name in the window.
fn by_name(user: &mut User, verb: &str, words: &mut Words<'_>) -> Result<bool, String> {
    match verb {
        "click" => user.click_on(&words.text()?),
        "click-beginning" => user.click_on_beginning(&words.text()?),
        "focus" => user.focus(&words.text()?),
        "enter" => user.enter(&words.text()?, &words.text()?),
        "put" => {
            user.focus(&words.text()?);
            user.shortcut(Key::A, false);
            user.type_text(&words.text()?);
            user.key(Key::Enter);
        }
        "fill" => user.fill(&words.text()?),
        "open" => user.open(&words.text()?),
        "show" => user.show(&words.text()?),
        "mend" => user.mend(words.number()?),
        "drop" => user.drop_file(words.text()?.as_ref()),
        _ => return Ok(false),
    }
    Ok(true)
}

/// Several things before the window is shown again.
fn at_once(user: &mut User, texts: &Texts, block: &str) -> Result<(), String> {
    let mut done = Ok(());
    user.at_once(|editor| {
        done = block.lines().try_for_each(|line| {
            let mut words = Words::of(line, None)?;
            within_frame(editor, texts, &mut words)?;
            words.end()
        });
    });
    done
}

fn within_frame(editor: &mut Editor, texts: &Texts, words: &mut Words<'_>) -> Result<(), String> {
    match &*words.text()? {
        "link" => editor.perform(Command::Link { name: words.text()? }),
        "type" => editor.type_text(&texts.take(words)?),
        "open" => editor.open(Workspace::unsaved(words.text()?, texts.take(words)?.as_str())),
        "say" => editor.say(&words.text()?),
        "choose-bar" => editor.choose(Tool::Bar),
        "select" => editor.select(Some(words.item()?), false),
        "select-too" => editor.select(Some(words.item()?), true),
        "remove" => editor.remove_selected(),
        "undo" => editor.undo(),
        "redo" => editor.redo(),
        "grasp" => editor.begin_drag(&Item::Axis(words.text()?), false),
        "lead" => editor.drag_to(words.place()?),
        "release" => editor.end_drag(),
        other => return Err(format!("nobody knows how to {other} within a frame")),
    }
    Ok(())
}
