//! Functions that are never called. Generated methods stand beside the user's items. A constant of the user with the name of a parameter or
//! variable would be a pattern. Methods that import these functions do not see that constant, and a parameter may share a function's name.

/// A function of each name.
macro_rules! functions {
    ($($name:ident)*) => {
        $(
            /// Only its name is needed.
            pub const fn $name() {}
        )*
    };
}

functions! {
    acceleration
    accelerations
    along
    arrows
    at
    before
    beside
    blocked
    canvas
    columns
    direction
    each
    first
    forces
    found
    free
    given
    held
    here
    index
    inertia
    influence
    influence_coefficients
    inside
    instance
    instances
    is_direction
    is_finite
    joints
    last
    led
    length
    links
    load
    loads
    margins
    mechanism
    method
    moment
    motor
    motors
    moved
    overlay
    params
    phases
    picture
    place
    points
    position
    rates
    reached
    refuse
    simulated
    slides
    stop
    t
    target
    there
    time
    torques
    value
    values
    velocities
    velocity
    velocity_ratio
    wanted
    x
    y
}
