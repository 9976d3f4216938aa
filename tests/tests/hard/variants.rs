//! One mechanism, by many methods.

/// Declares a mechanism in both precisions and by each of the methods listed, and a test of each for each check. Before what else it
/// has, `four_bar` has the lengths of ground, crank, coupler and rocker; `slider_crank` those of crank and rod, and its guide's offset.
macro_rules! variants {
    ($(#[$about:meta])* $name:ident by $methods:tt four_bar [$ground:tt, $crank:tt, $coupler:tt, $rocker:tt]
        {$($more:tt)*} $($checks:tt)+) => {
        variants! {
            $(#[$about])*
            $name by $methods {
                ground { point a = (0, 0); point d = ($ground, 0); }
                link crank { point a = (0, 0); point b = ($crank, 0); }
                link coupler { point b = (0, 0); point c = ($coupler, 0); }
                link rocker { point d = (0, 0); point c = ($rocker, 0); }
                joint ja = revolute(ground.a, crank.a);
                joint jb = revolute(crank.b, coupler.b);
                joint jc = revolute(coupler.c, rocker.c);
                joint jd = revolute(ground.d, rocker.d);
                $($more)*
            } $($checks)+
        }
    };
    ($(#[$about:meta])* $name:ident by $methods:tt slider_crank [$crank:tt, $rod:tt, $offset:tt]
        {$($more:tt)*} $($checks:tt)+) => {
        variants! {
            $(#[$about])*
            $name by $methods {
                ground { point a = (0, 0); line way = (0, $offset) -> (1, 0); }
                link crank { point a = (0, 0); point b = ($crank, 0); }
                link rod { point b = (0, 0); point c = ($rod, 0); }
                link block { point c = (0, 0); line way = (0, 0) -> (1, 0); }
                joint ja = revolute(ground.a, crank.a);
                joint jb = revolute(crank.b, rod.b);
                joint jc = revolute(rod.c, block.c);
                joint x = prismatic(ground.way, block.way);
                $($more)*
            } $($checks)+
        }
    };
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
