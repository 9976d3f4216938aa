//! Visitors of all mechanisms, each with its own type.

use crate::{
    Exhibited, andrews, antikythera, crane, diagram, excavator, four_bar, geared_piston, jansen,
    rocker_arm, skeleton, velocities, walker, watt,
};

/// A visitor of the mechanisms of the gallery.
pub trait Visitor {
    /// Visits a mechanism.
    fn visit<M: Exhibited>(&mut self);
}

/// Shows a visitor all mechanisms, or those of that name in a submodule of theirs.
macro_rules! visit_all {
    ($visitor:ident $(, $single:ident)?) => {
        $visitor.visit::<geared_piston::$($single::)?GearedPiston>();
        $visitor.visit::<diagram::$($single::)?PistonDiagram>();
        $visitor.visit::<four_bar::$($single::)?CrankRocker>();
        $visitor.visit::<velocities::$($single::)?CouplerCurve>();
        $visitor.visit::<watt::$($single::)?Watt>();
        $visitor.visit::<andrews::$($single::)?AndrewsSqueezer>();
        $visitor.visit::<jansen::$($single::)?JansenLeg>();
        $visitor.visit::<rocker_arm::$($single::)?RockerArm>();
        $visitor.visit::<crane::$($single::)?LuffingCrane>();
        $visitor.visit::<excavator::$($single::)?Excavator>();
        $visitor.visit::<walker::$($single::)?Walker>();
        $visitor.visit::<antikythera::$($single::)?Antikythera>();
        $visitor.visit::<skeleton::$($single::)?Skeleton>();
    };
}

/// Shows a visitor all mechanisms in double precision, in the order in which they hang.
pub fn visit_f64(visitor: &mut impl Visitor) {
    visit_all!(visitor);
}

/// Shows a visitor all mechanisms in single precision, in the same order.
pub fn visit_f32(visitor: &mut impl Visitor) {
    visit_all!(visitor, single);
}
