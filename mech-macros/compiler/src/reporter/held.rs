//! There is less freedom than there are motors.

use super::Words;
use super::wording::one_of;
use crate::model::{JointId, JointKind, LinkId, MotorId};
use crate::repair::{Offers, Repair};

impl Words<'_> {
    pub(super) fn blocked(
        &self,
        motor: MotorId,
        part: &[LinkId],
        joints: &[JointId],
        offers: &Offers,
    ) -> String {
        let motor = self.joint(self.model.motor(motor).joint);
        let links = self.moving_links(part);
        let (form, them) = if links.len() == 1 { ("is", "it") } else { ("form", "them") };
        let rigid = if part.contains(&LinkId::GROUND) { "`ground`" } else { "each other" };
        format!(
            "motor {motor} is blocked: {} {form} a part that cannot move (mobility 0)\nnote: {} {them} rigidly to {rigid}{}",
            self.links(&links),
            self.the_joints(joints, ["holds", "hold"]),
            self.help_or_pairs(offers)
        )
    }

    pub(super) fn too_many(&self, motor: MotorId, among: &[MotorId], offers: &Offers) -> String {
        let joint = |id: MotorId| self.model.motor(id).joint;
        let others: Vec<JointId> =
            among.iter().filter(|&&id| id != motor).map(|&id| joint(id)).collect();
        let determine = if others.len() == 1 { "determines" } else { "determine" };
        format!(
            "motor {} is one too many: {} already {determine} what moves there{}",
            self.joint(joint(motor)),
            self.motors(&others),
            self.help_or_pairs(offers)
        )
    }

    pub(super) fn overdetermined(
        &self,
        joints: &[JointId],
        is_mobile: bool,
        offers: &Offers,
    ) -> String {
        let rolls = |&joint: &JointId| self.model.joint(joint).kind.rolls();
        let cam = |&joint: &JointId| matches!(self.model.joint(joint).kind, JointKind::Cam { .. });
        let sizes = if joints.iter().any(cam) {
            "lengths and laws"
        } else if joints.iter().all(rolls) {
            "ratios"
        } else {
            "lengths"
        };
        let bolted = self.bolting_note(joints).unwrap_or_default();
        let help = if bolted.is_empty() {
            self.help_or_pairs(offers)
        } else {
            self.help(offers).replacen("help: ", "help: or ", 1)
        };
        if is_mobile {
            return format!(
                "{} too many: the mechanism still moves, but only because its {sizes} match exactly{bolted}{help}",
                self.the_joints(joints, ["is one", "are"]),
            );
        }
        let hold = self.the_joints(joints, ["holds", "hold"]);
        format!(
            "{hold} the same parts more than once: these fit together only if all {sizes} match exactly{bolted}{help}"
        )
    }

    pub(super) fn rigid(&self, offers: &Offers) -> String {
        if self.model.declared_links().next().is_none() {
            return "there is no link: a mechanism has at least one, besides the ground\nhelp: declare one with a joint and a motor, as \
                `link arm; joint a = revolute(ground, arm) at (0, 0); motor a;`"
                .to_owned();
        }
        format!(
            "nothing can move: the joints hold all links rigidly to `ground` (mobility 0){}",
            self.help_or_pairs(offers)
        )
    }

    /// If joints that hold each other are all between the same two links: that these should be one.
    fn bolting_note(&self, joints: &[JointId]) -> Option<String> {
        let pair = |joint: JointId| {
            let (a, b) = self.model.ends(joint);
            (a.min(b), a.max(b))
        };
        let (a, b) = pair(*joints.first()?);
        let declared = [a, b].iter().all(|&link| self.model.link(link).die.is_none());
        let same = joints.len() > 1 && joints.iter().all(|&joint| pair(joint) == (a, b));
        (declared && same).then(|| {
            format!(
                "\nnote: they hold {} still on {}\nhelp: make one link of the two, or join them by one `weld`",
                self.link(b),
                self.link(a)
            )
        })
    }

    /// There is more freedom than there are motors.
    pub(super) fn undetermined(&self, freedom: usize, free: &[JointId], offers: &Offers) -> String {
        let missing =
            if freedom == 1 { "one motor is".to_owned() } else { format!("{freedom} motors are") };
        format!(
            "{} free when all motors are held: {missing} missing{}{}",
            self.the_joints(free, ["stays", "stay"]),
            self.pins_that_turn(free),
            self.motor_help(offers)
        )
    }

    pub(super) fn on_one_pin(&self, link: LinkId, joints: &[JointId], offers: &Offers) -> String {
        let help = match self.help_or_pairs(offers) {
            none if none.is_empty() => "\nhelp: place one of them elsewhere".to_owned(),
            help => help,
        };
        format!(
            "link {} turns freely: {} at one place{help}",
            self.link(link),
            self.the_joints(joints, ["is", "are"]),
        )
    }

    /// Slots whose pins stay free to turn, though a motor drives their displacement: both joints of a slot have its name.
    fn pins_that_turn(&self, free: &[JointId]) -> String {
        let driven = |&pin: &JointId| {
            let joint = self.model.joint(pin);
            let mut motors = self.model.motors.iter();
            let slide = motors.find(|motor| self.model.joint(motor.joint).name == joint.name)?;
            joint.hidden.then_some((pin, slide.joint))
        };
        let Some((pin, slide)) = free.iter().find_map(driven) else {
            return String::new();
        };
        let name = self.joint(slide);
        let (body, _) = self.model.ends(pin);
        let (guide, _) = self.model.ends(slide);
        let note = format!(
            "\nnote: motor {name} drives the way of slot {name}; nothing holds the angle of its pin"
        );
        if !self.is_drawn(slide) {
            return format!(
                "{note}\nhelp: join the same two links by a `prismatic`, so that they only slide"
            );
        }
        format!(
            "{note}\nhelp: write `prismatic` for `slot`, so that {} and {} only slide",
            self.link(body),
            self.link(guide)
        )
    }

    pub(super) fn no_motor(
        &self,
        freedom: usize,
        candidates: &[JointId],
        offers: &Offers,
    ) -> String {
        let needs = if freedom == 1 { "one motor".to_owned() } else { format!("{freedom} motors") };
        let nothing = offers.single.is_empty()
            && offers.elsewhere.is_empty()
            && offers.coupled.is_empty()
            && offers.pairs.is_empty();
        let alone = if nothing && !candidates.is_empty() {
            // Counting finds no freedom: it moves because its lengths match.
            let names = candidates.iter().map(|&joint| self.joint(joint));
            let joints = one_of(&names.collect::<Vec<_>>());
            format!("\nhelp: add a motor on {joints}, and `allow redundant;`")
        } else {
            String::new()
        };
        format!("there is no motor: the mechanism needs {needs}{}{alone}", self.motor_help(offers))
    }

    /// Where motors would do; if some would only under a condition, that the others would without.
    fn motor_help(&self, offers: &Offers) -> String {
        let help = self.help(offers);
        let adds = |repair: &Repair| matches!(repair, Repair::AddMotors(_));
        if offers.coupled.is_empty() || !offers.single.iter().any(adds) {
            return help;
        }
        // The first line is that of the motors that need nothing else.
        match help.match_indices('\n').nth(1) {
            Some((end, _)) => {
                let (first, rest) = help.split_at(end);
                format!("{first}: then all is solved loop by loop{rest}")
            }
            None => help,
        }
    }
}
