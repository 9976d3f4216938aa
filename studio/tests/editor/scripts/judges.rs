//! The judges of scripts: each verb judges what the window shows, the text, or the disk.

use super::words::Words;
use super::{Line, Scene, Texts};
use crate::user::User;
use eframe::egui::Key;
use mech_studio::editor::{ArrowKind, Drawing};
use mech_studio::play::Player;
use similar::TextDiff;
use std::fmt::Debug;
use std::fs;

/// Whether a judge holds, and the value that it found.
struct Finding {
    is_so: bool,
    found: String,
}

impl Finding {
    fn of(is_so: bool, found: impl Debug) -> Self {
        let found = format!("{found:?}");
        Self { is_so, found }
    }

    fn equal<T: PartialEq + Debug>(found: &T, expected: &T) -> Self {
        Self::of(found == expected, found)
    }

    /// Compares a text with the expected one; the finding shows the differences.
    fn text(found: &str, expected: &str) -> Self {
        let changes = TextDiff::from_lines(expected, found);
        Self { is_so: found == expected, found: changes.unified_diff().to_string() }
    }
}

impl Scene {
    pub(super) fn judge(&mut self, mut words: Words<'_>, line: &Line) -> Result<(), String> {
        let texts = &self.texts;
        if let Some(user) = &mut self.user {
            if words.takes("until") {
                finding(Some(user), texts, &words)?;
                let is_so = |user: &User| {
                    let finding = finding(Some(user), texts, &words);
                    finding.is_ok_and(|finding| finding.is_so)
                };
                user.wait_until("it is never so", is_so);
                return Ok(());
            }
            if by_doing(user, &mut words)? {
                return words.end();
            }
        }
        let is_expected = !words.takes("not");
        let user = self.user.as_ref();
        let Finding { is_so, found } = finding(user, texts, &words)?;
        if is_so == is_expected {
            return Ok(());
        }
        let text = user.map_or("", User::text);
        if line.text == "is" {
            self.renewed.insert(line.number, text.to_owned());
        }
        let said = user.map_or_else(String::new, User::said);
        Err(format!("found:\n{found}\n{said}"))
    }
}

/// Judges what comes of something that is done. Returns whether the word is such a judge.
fn by_doing(user: &mut User, words: &mut Words<'_>) -> Result<bool, String> {
    if words.takes("plays") {
        plays(user);
    } else if words.takes("mended") {
        is_mended(user, &words.text()?);
    } else if words.takes("closes") {
        assert!(closes(user, words)?, "it stays open: {}", user.said());
    } else if words.takes("stays") {
        assert!(!closes(user, words)?, "it is closed: {}", user.said());
    } else if words.takes("ends-by") {
        assert!(user.ends_by(&words.text()?), "{}", user.said());
    } else {
        return Ok(false);
    }
    Ok(true)
}

/// Closes the window by the click that a line names, or as the system does it. Returns whether it is closed.
fn closes(user: &mut User, words: &mut Words<'_>) -> Result<bool, String> {
    if words.is_at_end() {
        return Ok(user.close());
    }
    Ok(user.closes_by(&words.text()?))
}

fn motors(user: &User) -> Vec<f64> {
    let player = user.editor().player();
    player.map_or_else(Vec::new, |player| player.motors().to_vec())
}

/// The motors move by themselves.
fn plays(user: &mut User) {
    let start = motors(user);
    user.key(Key::Space);
    user.wait(20);
    assert_ne!(start, motors(user), "it does not play:\n{}", user.said());
}

/// It does not move; one of the first two repairs says what a teacher would; a click on it, and it moves.
fn is_mended(user: &mut User, repair: &str) {
    let said = user.said();
    assert!(user.editor().player().is_none(), "it moves: {said}");
    assert!(!user.editor().messages().is_empty(), "{said}");
    user.click_on_beginning("Diagnoses");
    let offered = offers(user);
    let mut first = offered.iter().take(2);
    let index = first.position(|words| words.contains(repair));
    let index = index.unwrap_or_else(|| panic!("{offered:#?}\n{said}"));
    user.click_on_beginning(&format!("Repair {}: ", index + 1));
    let is_moving = user.editor().player().is_some();
    assert!(is_moving, "it does not move:\n{}", user.said());
    plays(user);
}

pub(super) fn offers(user: &User) -> Vec<String> {
    let offered = user.editor().mendings().iter();
    offered.map(|mending| mending.words.clone()).collect()
}

fn is_near(one: [f64; 2], other: [f64; 2], tolerance: f64) -> bool {
    (one[0] - other[0]).hypot(one[1] - other[1]) < tolerance
}

/// Finds what the words of a judge ask for.
fn finding(user: Option<&User>, texts: &Texts, words: &Words<'_>) -> Result<Finding, String> {
    let mut words = words.clone();
    let verb = words.text()?;
    let mut found = of_disk(texts, &verb, &mut words)?;
    if found.is_none() {
        let user = user.ok_or("nobody is there")?;
        found = of_text(user, texts, &verb, &mut words)?;
        if found.is_none() {
            found = of_drawing(user, &verb, &mut words)?;
        }
        if found.is_none() {
            found = of_editor(user, &verb, &mut words)?;
        }
    }
    words.end()?;
    found.ok_or_else(|| format!("{verb} is no verb"))
}

/// Of the files in the folder.
fn of_disk(texts: &Texts, verb: &str, words: &mut Words<'_>) -> Result<Option<Finding>, String> {
    let names = texts.folder.names();
    let finding = match verb {
        "on-disk" => {
            let found = fs::read(texts.folder.0.join(words.text()?));
            let found = found.map_err(|error| error.to_string())?;
            let found = String::from_utf8_lossy(&found);
            Finding::text(&found, &texts.take(words)?)
        }
        "files" => Finding::equal(&names, &words.all(Words::text)?),
        "has-file" => Finding::of(names.contains(&words.text()?), names),
        _ => return Ok(None),
    };
    Ok(Some(finding))
}

/// Of the text, and of those before it.
fn of_text(
    user: &User,
    texts: &Texts,
    verb: &str,
    words: &mut Words<'_>,
) -> Result<Option<Finding>, String> {
    let text = user.text();
    let made = user.editor().workspace().history().made().iter();
    let made: Vec<String> = made.map(|step| step.text.clone()).collect();
    let finding = match verb {
        "is" => Finding::text(text, &texts.take(words)?),
        "has" => Finding::of(text.contains(&words.text()?), text),
        "begins" => Finding::of(text.starts_with(&words.text()?), text),
        "ends" => Finding::of(text.ends_with(&words.text()?), text),
        "times" => {
            let expected = words.number()?;
            Finding::equal(&text.matches(&words.text()?).count(), &expected)
        }
        "offers-are" => Finding::text(&offers(user).join("\n"), &texts.take(words)?),
        "steps" => Finding::equal(&made.len(), &words.number()?),
        "history" => Finding::equal(&made, &words.all(|words| texts.take(words))?),
        _ => return Ok(None),
    };
    Ok(Some(finding))
}

/// Of what is drawn, and how it moves.
fn of_drawing(user: &User, verb: &str, words: &mut Words<'_>) -> Result<Option<Finding>, String> {
    let player = user.editor().player();
    let finding = match verb {
        "moves" => Finding::of(player.is_some(), "nothing that moves"),
        "runs" => Finding::of(player.is_some_and(Player::plays), player.map(Player::plays)),
        "motors" => Finding::equal(&motors(user).len(), &words.number()?),
        "motor-above" => {
            let (limit, motors) = (words.number()?, motors(user));
            Finding::of(motors.first().is_some_and(|motor| *motor > limit), motors)
        }
        "motor-below" => {
            let (limit, motors) = (words.number()?, motors(user));
            Finding::of(motors.first().is_some_and(|motor| *motor < limit), motors)
        }
        "joint" | "point" => {
            let found = user.scene_place_of(&format!("{verb} {}", words.text()?));
            let place = words.place()?;
            Finding::of(found.is_some_and(|found| is_near(found, place, 1e-9)), found)
        }
        "bar" => {
            let found = user.ends_of(&words.text()?);
            let ends = [words.place()?, words.place()?];
            let is_there = |end: &[f64; 2]| found.iter().any(|one| is_near(*one, *end, 1e-6));
            Finding::of(ends.iter().all(is_there), found)
        }
        "dashes" => Finding::of(user.sees_dashes(words.place()?, words.place()?), "dashes"),
        "ring" => Finding::of(user.sees_ring(words.place()?), "rings"),
        "beside" => {
            let pair = |words: &mut Words| Ok((words.text()?, words.place()?));
            beside(user, &words.all(pair)?)
        }
        // The first is farther to the right.
        "farther" => {
            let places = [words.text()?, words.text()?].map(|name| user.scene_place_of(&name));
            let [one, other] = places.map(|place| place.map_or(f64::NAN, |place| place[0]));
            Finding::of(one > other, [one, other])
        }
        "as-compiled" => {
            let again = User::with_file(&words.text()?, user.text());
            let [found, expected] = [user, &again].map(|user| {
                let handles = user.editor().drawing().into_iter().flat_map(Drawing::handles);
                handles.map(|handle| format!("{handle:?}")).collect::<Vec<_>>()
            });
            Finding::of(!found.is_empty() && found == expected, found)
        }
        "handles" => Finding::equal(&user.handles(), &words.all(Words::text)?),
        "drawn" => Finding::of(user.editor().drawing().is_some(), "drawings"),
        _ => return Ok(None),
    };
    Ok(Some(finding))
}

/// Whether copies are right of where these were, and below, all by one step: not far, but seen.
fn beside(user: &User, copies: &[(String, [f64; 2])]) -> Finding {
    let steps = copies.iter().map(|(copy, [x, y])| {
        let found = user.scene_place_of(copy).unwrap_or([f64::NAN; 2]);
        let pixels = user.pixel(found).x - user.pixel([*x, *y]).x;
        (found[0] - x, y - found[1], pixels)
    });
    let steps: Vec<_> = steps.collect();
    let is_one = steps.iter().all(|(right, down, pixels)| {
        let is_seen = *pixels > 8.0 && *pixels < 200.0;
        (right - down).abs() < 1e-9 && (right - steps[0].0).abs() < 1e-9 && is_seen
    });
    Finding::of(is_one, steps)
}

/// Of what is told, offered and selected.
fn of_editor(user: &User, verb: &str, words: &mut Words<'_>) -> Result<Option<Finding>, String> {
    let (editor, notice) = (user.editor(), user.editor().notice());
    let finding = match verb {
        "tells" => Finding::of(user.tells(&words.text()?), notice),
        "refused" => {
            let is_refusal = notice.is_some_and(|notice| notice.is_refusal);
            Finding::of(is_refusal && user.tells(&words.text()?), notice)
        }
        "sees" => Finding::of(user.sees(&words.text()?), user.labels()),
        "offers" => {
            let (part, offers) = (words.text()?, offers(user));
            Finding::of(offers.iter().any(|offer| offer.contains(&part)), offers)
        }
        "first-offer" => {
            let (first, offers) = (words.text()?, offers(user));
            Finding::of(offers.first() == Some(&first), offers)
        }
        "messages" => Finding::equal(&editor.messages().len(), &words.number()?),
        "readable" => Finding::of(editor.is_readable(), editor.messages()),
        "busy" => Finding::of(editor.is_busy(), "idleness"),
        "changed" => Finding::of(editor.workspace().is_changed(), "no changes"),
        "path" => Finding::equal(&editor.workspace().path().display().to_string(), &words.text()?),
        "mechanism" => Finding::equal(&editor.workspace().index(), &words.number()?),
        "selected" => Finding::equal(&editor.selection().len(), &words.number()?),
        "gestures" => Finding::equal(&user.gestures(), &words.number()?),
        "forces" => {
            let arrows = editor.arrows().into_iter();
            let forces = arrows.filter(|arrow| arrow.kind == ArrowKind::Force);
            Finding::equal(&forces.count(), &words.number()?)
        }
        "arrows" => Finding::equal(&editor.arrows().len(), &words.number()?),
        _ => return Ok(None),
    };
    Ok(Some(finding))
}
