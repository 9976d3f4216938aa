//! Functions that are never called. Generated methods stand beside whatever the user has, and where a constant is called as one of
//! their parameters or variables, the compiler takes this to be a pattern. Methods that import these functions do not see it, and a
//! parameter may be called as a function is.

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
    accelerations
    along
    arrows
    blocked
    canvas
    columns
    direction
    each
    first
    forces
    found
    held
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
    length
    links
    load
    loads
    margins
    method
    moment
    motor
    motors
    moved
    overlay
    params
    phases
    picture
    points
    position
    rates
    reached
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
    velocity_ratio
    x
    y
}
