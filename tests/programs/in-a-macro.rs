//! A mechanism made by a macro of the user's, with a name and a length of its choice.

macro_rules! arm {
    ($name:ident, $length:expr, $first:ident) => {
        mech_runtime::mechanism! {
            pub struct $name;
            const LENGTH = $length;
            ground { point base = (0.0, 0.0); }
            link $first { point shoulder = (0.0, 0.0); point hand = (LENGTH, 0.0); }
            joint turn = revolute(ground.base, $first.shoulder);
            motor turn;
        }
    };
}

arm!(Short, 1.0, forearm);
arm!(Long, 2.0 * 3.0, boom);

fn main() {
    assert_eq!(Short::new().forearm_hand().x, 1.0);
    assert_eq!(Long::new().boom_hand().x, 6.0);
}
