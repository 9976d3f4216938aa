//! x
use mech_runtime::mechanism;
macro_rules! fb { ($n:ident, [$($m:tt)*], $g:expr,$a:expr,$b:expr,$c:expr, [$($s:tt)*]) => {
mechanism! { struct $n; ground { point a=(0,0); point d=($g,0); } link crank { point a=(0,0); point b=($a,0); } link coupler { point b=(0,0); point c=($b,0);} link rocker { point d=(0,0); point c=($c,0);} 
 joint ja = revolute(ground.a, crank.a); joint jb = revolute(crank.b, coupler.b); joint jc = revolute(coupler.c, rocker.c); joint jd = revolute(ground.d, rocker.d); motor ja $($m)*; start { ja = 0 deg; $($s)* } } } }
fb!(Ranged, [in -30 deg ..= 100 deg], 4,1,3.5,3, [coupler near 50 deg;]);
fb!(Par0, [], 2,1,2,1, []);
fb!(Sq0, [], 1,1,1,1, []);
fb!(ParR, [in -30 deg ..= 400 deg], 2,1,2,1, []);
#[test] fn go() {
  println!("{}", Ranged::REPORT);
  let mut m = Ranged::new();
  println!("{:?} {:?}", m.move_to([3.0]), m.move_toward([-3.0]));
  let r = Ranged::range([1.0]).unwrap(); m.move_within(r); println!("{:?} {:?}", m.motors(), Ranged::range([2.0]));
  let mut m = Par0::new(); println!("{}", Par0::REPORT);
  for d in [0, 10, 90, 180, 200, 360, 380, 350, -30, 0] { let r=m.move_to([f64::from(d).to_radians()]); let b=m.rocker_c(); println!("{d} {r:?} {:.6} {:.6}", b.x, b.y); }
  let mut m = Sq0::new(); 
  for d in [0, 10, 90, 180, 200, 360, 380, 350, -30, 0] { let r=m.move_to([f64::from(d).to_radians()]); let b=m.rocker_c(); println!("sq {d} {r:?} {:.6} {:.6}", b.x, b.y); }
  let mut m = ParR::new(); for d in [0, 10, 90, 180, 200, 360] { m.move_within(ParR::range([f64::from(d).to_radians()]).unwrap()); let b=m.rocker_c(); println!("{d} {:.6} {:.6}", b.x, b.y); }
}
