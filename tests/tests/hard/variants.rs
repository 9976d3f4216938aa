//! One mechanism, by many methods.

/// Declares a mechanism in both precisions and by each of the methods listed, and a test of each for each check.
macro_rules! variants {
    ($(#[$about:meta])* $name:ident by $methods:tt $body:tt $checks:tt $(and by $more:tt $others:tt)*) => {
        $(#[$about])*
        mod $name {
            #[allow(unused_imports, reason = "a check may be a closure of its own")]
            use super::*;
            variants!(@each $methods $body $checks);
            $(variants!(@each $more $body $others);)*
        }
    };
    (@each [$($method:ident)*] $body:tt $checks:tt) => {
        $(variants!(@$method $body $checks);)*
    };
    (@exact $body:tt $checks:tt) => {
        variants!(@variant exact_f64 f64 {exact} $body $checks);
        variants!(@variant exact_f32 f32 {exact} $body $checks);
    };
    (@exact_f64 $body:tt $checks:tt) => { variants!(@variant exact_f64 f64 {exact} $body $checks); };
    (@exact_f32 $body:tt $checks:tt) => { variants!(@variant exact_f32 f32 {exact} $body $checks); };
    (@newton_f32 $body:tt $checks:tt) => { variants!(@variant newton_f32 f32 {newton} $body $checks); };
    (@newton_f64 $body:tt $checks:tt) => { variants!(@variant newton_f64 f64 {newton} $body $checks); };
    (@newton $body:tt $checks:tt) => {
        variants!(@variant newton_f64 f64 {newton} $body $checks);
        variants!(@variant newton_f32 f32 {newton} $body $checks);
    };
    (@newton_3 $body:tt $checks:tt) => {
        variants!(@variant newton_3_f64 f64 {newton(3)} $body $checks);
        variants!(@variant newton_3_f32 f32 {newton(3)} $body $checks);
    };
    (@newton_4 $body:tt $checks:tt) => {
        variants!(@variant newton_4_f64 f64 {newton(4)} $body $checks);
        variants!(@variant newton_4_f32 f32 {newton(4)} $body $checks);
    };
    (@linear $body:tt $checks:tt) => {
        variants!(@variant linear_f64 f64 {linear} $body $checks);
        variants!(@variant linear_f32 f32 {linear} $body $checks);
    };
    (@variant $variant:ident $scalar:ident {$($method:tt)*} {$($body:tt)*}
        {$($(#[$on:meta])* $check:ident: $with:expr;)*}) => {
        mod $variant {
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
