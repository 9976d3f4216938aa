//! The struct may have the name of anything that the generated code imports.

mod position {
    mech_runtime::mechanism! {
        pub struct Position;
        ground { point o = (0, 0); }
        link l { point p = (0, 0); }
        joint a = revolute(ground.o, l.p);
        motor a;
    }
}

mod mechanism {
    mech_runtime::mechanism! {
        pub struct Mechanism;
        ground { point o = (0, 0); }
        link l { point p = (0, 0); }
        joint a = revolute(ground.o, l.p);
        motor a;
    }
}

mod pose {
    mech_runtime::mechanism! {
        pub struct Pose: f32;
        ground { point o = (0, 0); }
        link l { point p = (0, 0); }
        joint a = revolute(ground.o, l.p);
        motor a;
    }
}

fn main() {
    assert!(position::Position::new().move_to([1.0]).is_ok());
    assert!(mechanism::Mechanism::new().move_to([1.0]).is_ok());
    assert!(pose::Pose::new().move_to([1.0]).is_ok());
}
