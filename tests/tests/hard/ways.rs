//! One mechanism, many ways to compute it.

/// Declares a mechanism in both precisions and by each of the methods listed, and a test of each way for each check.
macro_rules! ways {
    ($(#[$about:meta])* $name:ident by $methods:tt $body:tt $checks:tt $(and by $more:tt $others:tt)*) => {
        $(#[$about])*
        mod $name {
            #[allow(unused_imports, reason = "a check may be a closure of its own")]
            use super::*;
            ways!(@each $methods $body $checks);
            $(ways!(@each $more $body $others);)*
        }
    };
    (@each [$($method:ident)*] $body:tt $checks:tt) => {
        $(ways!(@$method $body $checks);)*
    };
    (@exact $body:tt $checks:tt) => {
        ways!(@way exact_f64 f64 {exact} $body $checks);
        ways!(@way exact_f32 f32 {exact} $body $checks);
    };
    (@exact_f64 $body:tt $checks:tt) => { ways!(@way exact_f64 f64 {exact} $body $checks); };
    (@exact_f32 $body:tt $checks:tt) => { ways!(@way exact_f32 f32 {exact} $body $checks); };
    (@newton_f32 $body:tt $checks:tt) => { ways!(@way newton_f32 f32 {newton} $body $checks); };
    (@newton_f64 $body:tt $checks:tt) => { ways!(@way newton_f64 f64 {newton} $body $checks); };
    (@newton $body:tt $checks:tt) => {
        ways!(@way newton_f64 f64 {newton} $body $checks);
        ways!(@way newton_f32 f32 {newton} $body $checks);
    };
    (@newton_4 $body:tt $checks:tt) => {
        ways!(@way newton_4_f64 f64 {newton(4)} $body $checks);
        ways!(@way newton_4_f32 f32 {newton(4)} $body $checks);
    };
    (@linear $body:tt $checks:tt) => {
        ways!(@way linear_f64 f64 {linear} $body $checks);
        ways!(@way linear_f32 f32 {linear} $body $checks);
    };
    (@way $way:ident $scalar:ident {$($method:tt)*} {$($body:tt)*}
        {$($(#[$on:meta])* $check:ident: $with:expr;)*}) => {
        mod $way {
            use super::*;
            mech_runtime::mechanism! { struct Subject: $scalar; $($body)* method $($method)*; }
            const TEXT: &str = stringify!(struct Subject: $scalar; $($body)* method $($method)*;);
            $(
                $(#[$on])*
                #[test]
                fn $check() {
                    ($with)($crate::bed::Bed::<Subject>::new(TEXT));
                }
            )*
        }
    };
}
