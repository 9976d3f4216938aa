//! Graphs of what moves.

use crate::editor::Editor;
use crate::editor::colors::distinct;
use crate::editor::curves::Curves;
use crate::editor::playing::Playing;
use crate::editor::plotted::{Plotted, read_load};
use crate::editor::range::MotorRange;
use crate::editor::snapshot::Snapshot;
use crate::motion::Basis;
use crate::quantity::{self, Offer, Table, round_step, tick};
use eframe::egui::{self, Color32, Role, Sense, Stroke, Vec2, WidgetInfo};
use egui_plot::{GridInput, GridMark, Line, Plot, PlotPoint, Points, VLine};
use mech_compiler::model::LoadKind;

#[derive(Debug, Default)]
pub(in crate::editor) struct Plots {
    /// The typed name of a quantity, as for `mech plot`.
    typed: String,
}

/// The least height of a graph, in points of the window.
const LEAST: f32 = 170.0;

impl Plots {
    /// Shows the graphs, with a line at the present value of the motor.
    pub(in crate::editor) fn show(&mut self, editor: &mut Editor, ui: &mut egui::Ui) {
        let (playing, snapshot) = (&editor.sight.playing, &editor.analysis.snapshot);
        self.choose(&mut editor.plotted, &playing.ranges, snapshot, ui);
        if let Some(task) = editor.plotted.renew(playing, snapshot) {
            editor.give(task);
        }
        if editor.plotted.names.is_empty() {
            ui.weak("Add a quantity: a place, a rate or a force. It is drawn over the range of the motor, or over another quantity.");
            return;
        }
        let (playing, snapshot) = (&editor.sight.playing, &editor.analysis.snapshot);
        let plotted = &editor.plotted;
        let is_present = plotted.is_present(playing, snapshot);
        let mut scrubbed = None;
        if let Some(curves) = &plotted.curves {
            warnings(curves, is_present, playing.player.is_some(), ui);
            if let Ok(table) = &curves.table {
                let at = cursor(plotted, playing);
                egui::ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
                    scrubbed = graphs(table, is_present, at, ui);
                });
            }
        } else {
            ui.weak("measuring");
        }
        let meant = scrubbed.and_then(|at| meant(plotted, playing, at));
        if let Some((motor, value)) = meant {
            editor.sight.scrub(motor, value);
        }
    }

    fn choose(
        &mut self,
        plotted: &mut Plotted,
        ranges: &[MotorRange],
        snapshot: &Snapshot,
        ui: &mut egui::Ui,
    ) {
        let offers = offers(snapshot);
        ui.horizontal_wrapped(|ui| {
            ui.menu_button("Add", |ui| {
                if let Some(name) = offered(&offers, ui) {
                    plotted.plot(name);
                }
            })
            .response
            .on_hover_text("adds a quantity to the graphs");
            remove(plotted, ui);
            over(plotted, &offers, ui);
            let label = ui.label("Quantity");
            let edit = egui::TextEdit::singleline(&mut self.typed)
                .hint_text("velocity:coupler.tip.norm")
                .desired_width(180.0);
            let response = ui.add(edit).labelled_by(label.id);
            if response.lost_focus() && ui.input(|input| input.key_pressed(egui::Key::Enter)) {
                plotted.plot(&std::mem::take(&mut self.typed));
            }
            motor(plotted, ranges, ui);
            loads(plotted, snapshot, ui);
        });
    }
}

/// Everything that can be measured of a mechanism that moves.
fn offers(snapshot: &Snapshot) -> Vec<Offer> {
    let (Some(reading), Some(compiled)) = (&snapshot.reading, snapshot.compiled()) else {
        return Vec::new();
    };
    let has_loops = compiled.plan.loops().next().is_some();
    quantity::offers(&reading.model, has_loops)
}

/// The quantity that is chosen from a menu of all.
fn offered<'o>(offers: &'o [Offer], ui: &mut egui::Ui) -> Option<&'o str> {
    let mut chosen = None;
    let list = egui::ScrollArea::vertical().max_height(420.0);
    list.show(ui, |ui| {
        for offer in offers {
            ui.menu_button(format!("of {}", offer.of), |ui| {
                for name in &offer.names {
                    if ui.button(name).clicked() {
                        chosen = Some(name.as_str());
                        ui.close();
                    }
                }
            });
        }
    });
    chosen
}

/// Chooses over what is plotted: the motor, or another quantity.
fn over(plotted: &mut Plotted, offers: &[Offer], ui: &mut egui::Ui) {
    let title = plotted.over.as_deref().unwrap_or("the motor");
    ui.menu_button(format!("Over {title}"), |ui| {
        if ui.button("the motor").clicked() {
            plotted.over = None;
            ui.close();
        }
        if let Some(name) = offered(offers, ui) {
            plotted.over = Some(name.to_owned());
        }
    })
    .response
    .on_hover_text("what the graphs are drawn over; time is at 1 rad or unit per second");
}

/// Asks for the numbers of the loads that the text declares.
fn loads(plotted: &mut Plotted, snapshot: &Snapshot, ui: &mut egui::Ui) {
    let reading = snapshot.reading.iter();
    for load in reading.flat_map(|reading| &reading.model.actions.loads) {
        let hint = match load.kind {
            LoadKind::Force(_) => "0, 0",
            LoadKind::Torque(_) => "0",
        };
        let typed = plotted.loads.entry(load.name.clone()).or_default();
        let label = ui.label(format!("load {}", load.name));
        let wrong = read_load(&load.name, load.kind, typed).err();
        let mut edit = egui::TextEdit::singleline(typed).hint_text(hint).desired_width(70.0);
        if wrong.is_some() {
            edit = edit.text_color(ui.visuals().error_fg_color);
        }
        let help = wrong.unwrap_or_else(|| "what acts while plots and forces are shown".to_owned());
        ui.add(edit).labelled_by(label.id).on_hover_text(help);
    }
}

fn remove(plotted: &mut Plotted, ui: &mut egui::Ui) {
    if plotted.names.is_empty() {
        return;
    }
    ui.menu_button("Remove", |ui| {
        let mut removed = None;
        for name in &plotted.names {
            if ui.button(name).clicked() {
                removed = Some(name.clone());
            }
        }
        if let Some(removed) = removed {
            plotted.names.retain(|name| *name != removed);
            ui.close();
        }
    })
    .response
    .on_hover_text("takes a quantity out of the graphs");
}

/// Chooses the motor over which is plotted, if there are several.
fn motor(plotted: &mut Plotted, ranges: &[MotorRange], ui: &mut egui::Ui) {
    let Some((_, chosen)) = plotted.motor_of(ranges).filter(|_| ranges.len() > 1) else {
        return;
    };
    let mut chosen = chosen.to_owned();
    egui::ComboBox::from_label("moved motor").selected_text(&chosen).show_ui(ui, |ui| {
        for range in ranges {
            ui.selectable_value(&mut chosen, range.name.clone(), &range.name);
        }
    });
    if plotted.motor.as_ref() != Some(&chosen) {
        plotted.motor = Some(chosen);
    }
}

/// Shows which quantities are missing, and whether the graphs are of an earlier text.
fn warnings(curves: &Curves, is_present: bool, moves: bool, ui: &mut egui::Ui) {
    let red = ui.visuals().error_fg_color;
    if !moves {
        ui.colored_label(red, "The mechanism does not move; the graphs are of an earlier text.");
    } else if !is_present {
        ui.weak("The graphs are of an earlier text or pose; they are measured anew.");
    }
    let failed = curves.table.as_ref().err();
    for failure in curves.missing.iter().chain(failed) {
        ui.colored_label(red, failure.to_string());
    }
}

/// The value of the motor over which is plotted, as graphs show it.
fn cursor(plotted: &Plotted, playing: &Playing) -> Option<f64> {
    let (range, value) = plotted_motor(plotted, playing)?;
    Some(range.shown(value - whole_turns(range, value)))
}

fn plotted_motor<'p>(plotted: &Plotted, playing: &'p Playing) -> Option<(&'p MotorRange, f64)> {
    let (motor, _) = plotted.motor_of(&playing.ranges)?;
    let value = playing.player.as_ref()?.motors().get(motor)?;
    Some((&playing.ranges[motor], *value))
}

/// The turns that a motor has made beyond its range, where it goes round and round.
fn whole_turns(range: &MotorRange, value: f64) -> f64 {
    let [low, high] = range.ends;
    if range.basis == Basis::Round && !(low..=high).contains(&value) {
        let turn = high - low;
        ((value - low) / turn).floor() * turn
    } else {
        0.0
    }
}

/// The motor over which is plotted, and the value of it that is meant by one as graphs show it.
fn meant(plotted: &Plotted, playing: &Playing, at: f64) -> Option<(usize, f64)> {
    let (motor, _) = plotted.motor_of(&playing.ranges)?;
    let (range, now) = plotted_motor(plotted, playing)?;
    let [low, high] = range.ends;
    let value = range.meant(at).clamp(low, high) + whole_turns(range, now);
    Some((motor, value))
}

/// A graph for each unit, one below the other. The value of the motor is given to which a press on one leads.
fn graphs(table: &Table, is_present: bool, at: Option<f64>, ui: &mut egui::Ui) -> Option<f64> {
    let mut units: Vec<&str> = Vec::new();
    for (_, unit) in &table.columns[table.curves()] {
        if !units.contains(&unit.as_str()) {
            units.push(unit);
        }
    }
    let mut scrubbed = None;
    #[expect(clippy::cast_precision_loss, reason = "a few graphs")]
    let share = ui.available_height() / units.len().max(1) as f32;
    for unit in units {
        let columns = table.curves();
        let columns: Vec<usize> =
            columns.filter(|&number| table.columns[number].1 == unit).collect();
        #[expect(clippy::cast_precision_loss, reason = "a few curves")]
        let legend = 20.0 * columns.len() as f32 + 12.0;
        readings(table, &columns, is_present, at, ui);
        let height = (share - legend).clamp(LEAST, 320.0);
        scrubbed = scrubbed.or(graph(table, unit, &columns, is_present, at, height, ui));
    }
    scrubbed
}

/// The legend: each curve in its colour, with its value at the line. It stands above the graph, where it hides nothing.
fn readings(
    table: &Table,
    columns: &[usize],
    is_present: bool,
    at: Option<f64>,
    ui: &mut egui::Ui,
) {
    for &column in columns {
        let (name, unit) = &table.columns[column];
        let text = at.map_or(name.clone(), |at| {
            let value = value_at(table, column, at);
            let value =
                value.map_or("not determined".to_owned(), |value| format!("{value:.4} {unit}"));
            format!("{name} = {value}")
        });
        ui.horizontal(|ui| {
            let (rect, _) = ui.allocate_exact_size(Vec2::new(16.0, 14.0), Sense::hover());
            let line = Stroke::new(3.0, color(table, column, is_present));
            ui.painter().hline(rect.x_range(), rect.center().y, line);
            ui.label(text);
        });
    }
}

/// The colour of a curve; what is of an earlier text is grey.
fn color(table: &Table, column: usize, is_present: bool) -> Color32 {
    if is_present {
        distinct(column - table.curves().start)
    } else {
        Color32::GRAY.gamma_multiply(0.6)
    }
}

/// The value of a curve, between its steps in proportion.
fn value_at(table: &Table, column: usize, at: f64) -> Option<f64> {
    let place = |row: &[Option<f64>]| (*row.first()?).zip(*row.get(column)?);
    let rows: Vec<&Vec<Option<f64>>> = table.rows.iter().collect();
    let pair = rows.windows(2).find(|pair| {
        let ends = [pair[0][0], pair[1][0]];
        matches!(ends, [Some(low), Some(high)] if (low..=high).contains(&at))
    })?;
    let ((from, low), (to, high)) = (place(pair[0])?, place(pair[1])?);
    let part = if to > from { (at - from) / (to - from) } else { 0.0 };
    Some(low + (high - low) * part)
}

fn graph(
    table: &Table,
    unit: &str,
    columns: &[usize],
    is_present: bool,
    at: Option<f64>,
    height: f32,
    ui: &mut egui::Ui,
) -> Option<f64> {
    let (across, across_unit) = &table.columns[table.across];
    let cursor = at.and_then(|at| value_at(table, table.across, at));
    let ink = ui.visuals().strong_text_color();
    let mut plot = Plot::new(("graph", unit, across))
        .height(height)
        .allow_drag(false)
        .allow_zoom(false)
        .allow_scroll(false)
        .allow_boxed_zoom(false)
        .allow_axis_zoom_drag(false)
        .allow_double_click_reset(false)
        .x_axis_label(format!("{across} [{across_unit}]"))
        .y_axis_label(format!("[{unit}]"))
        .y_axis_min_width(46.0)
        .x_axis_formatter(|mark, _| tick(mark.value))
        .y_axis_formatter(|mark, _| tick(mark.value))
        .x_grid_spacer(|input| marks(&input, across_unit, 4))
        .y_grid_spacer(|input| marks(&input, unit, 6));
    if table.is_path(unit) {
        plot = plot.data_aspect(1.0);
    }
    let shown = plot.show(ui, |plot| {
        for &column in columns {
            let color = color(table, column, is_present);
            for (number, part) in parts(table, column).into_iter().enumerate() {
                let line = Line::new(table.columns[column].0.clone(), part).id((column, number));
                plot.line(line.color(color).width(2.0));
            }
        }
        if let Some(x) = cursor {
            plot.vline(VLine::new("", x).color(ink).width(1.5));
        }
        if table.across == 0 {
            return;
        }
        // A line may meet a curve several times there.
        for &column in columns {
            let y = at.and_then(|at| value_at(table, column, at));
            if let Some((x, y)) = cursor.zip(y) {
                let place = Points::new("", vec![[x, y]]).id(("place", column));
                plot.points(place.color(color(table, column, is_present)).radius(5.0));
            }
        }
    });
    let response = shown.response;
    response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, format!("graph of {unit}")));
    let is_pressed = response.dragged() || response.clicked();
    let pointer = response.interact_pointer_pos().filter(|_| is_pressed)?;
    if table.across == 0 {
        let PlotPoint { x, .. } = shown.transform.value_from_position(pointer);
        return Some(x);
    }
    nearest(table, columns, |point| {
        let place = shown.transform.position_from_point(&PlotPoint::from(point));
        place.distance_sq(pointer)
    })
}

/// The value of the motor where a curve has its least distance from something.
fn nearest(table: &Table, columns: &[usize], distance: impl Fn([f64; 2]) -> f32) -> Option<f64> {
    let mut found = None;
    for row in &table.rows {
        for &column in columns {
            let (Some(at), Some(x), Some(y)) = (row[0], row[table.across], row[column]) else {
                continue;
            };
            let far = distance([x, y]);
            if found.is_none_or(|(_, least)| far < least) {
                found = Some((at, far));
            }
        }
    }
    found.map(|(at, _)| at)
}

/// Lines at round numbers, at most so many and one, as in the graphs that `mech plot` writes.
fn marks(input: &GridInput, unit: &str, most: u32) -> Vec<GridMark> {
    let (low, high) = input.bounds;
    if !(low < high && high.is_finite() && low.is_finite()) {
        return Vec::new();
    }
    let step = round_step(&(low..high), unit, most);
    let first = (low / step).ceil();
    let values = (0..=most).map(|number| (first + f64::from(number)) * step);
    let marks = values.take_while(|value| *value <= high);
    marks.map(|value| GridMark { value, step_size: step }).collect()
}

/// The places of a curve; where it is not determined it is broken.
fn parts(table: &Table, column: usize) -> Vec<Vec<[f64; 2]>> {
    let mut parts = vec![Vec::new()];
    for row in &table.rows {
        match (row[table.across], row[column]) {
            (Some(x), Some(y)) => {
                if let Some(part) = parts.last_mut() {
                    part.push([x, y]);
                }
            }
            _ => parts.push(Vec::new()),
        }
    }
    parts.retain(|part| !part.is_empty());
    parts
}
