use mech_runtime::mechanism;
mechanism! { struct Par; ground { point a=(0,0); point d=(2,0); } link crank { point a=(0,0); point b=(1,0); } link coupler { point b=(0,0); point c=(2,0);} link rocker { point d=(0,0); point c=(1,0);}
joint ja = revolute(ground.a, crank.a); joint jb = revolute(crank.b, coupler.b); joint jc = revolute(coupler.c, rocker.c); joint jd = revolute(ground.d, rocker.d); motor ja; start { ja = 60 deg; rocker near 60 deg; } }
mechanism! { struct Anti; ground { point a=(0,0); point d=(2,0); } link crank { point a=(0,0); point b=(1,0); } link coupler { point b=(0,0); point c=(2,0);} link rocker { point d=(0,0); point c=(1,0);}
joint ja = revolute(ground.a, crank.a); joint jb = revolute(crank.b, coupler.b); joint jc = revolute(coupler.c, rocker.c); joint jd = revolute(ground.d, rocker.d); motor ja; start { ja = 60 deg; rocker near -60 deg; } }
mechanism! { struct Kite; ground { point a=(0,0); point d=(1,0); } link crank { point a=(0,0); point b=(1,0); } link coupler { point b=(0,0); point c=(2,0);} link rocker { point d=(0,0); point c=(2,0);}
joint ja = revolute(ground.a, crank.a); joint jb = revolute(crank.b, coupler.b); joint jc = revolute(coupler.c, rocker.c); joint jd = revolute(ground.d, rocker.d); motor ja; start { ja = 60 deg; rocker near 50 deg; } }
mechanism! { struct Rocker; ground { point a=(0,0); point d=(4,0); } link crank { point a=(0,0); point b=(1,0); } link coupler { point b=(0,0); point c=(2,0);} link rocker { point d=(0,0); point c=(1.5,0);}
joint ja = revolute(ground.a, crank.a); joint jb = revolute(crank.b, coupler.b); joint jc = revolute(coupler.c, rocker.c); joint jd = revolute(ground.d, rocker.d); motor ja; start { ja = 0 deg; rocker near 120 deg; } }
#[test]
fn par() {
    println!("{}", Par::REPORT);
    for step in [1.0f64, 7.0, 30.0, 45.0, 90.0, 120.0] {
        let mut m = Par::new();
        let mut worst = 0.0f64;
        let mut deg = 60.0f64;
        while deg < 36000.0 {
            deg += step;
            let t = deg.to_radians();
            m.move_to([t]).unwrap();
            let b = m.rocker_c();
            let e = ((b.x - 2.0 - t.cos()).abs()).max((b.y - t.sin()).abs());
            if e > 1e-9 {
                println!("{step} {deg} {e}");
                break;
            }
            worst = worst.max(e);
        }
        println!("par step {step} {worst:e}");
    }
    let mut m = Anti::new();
    for deg in (60..=800).step_by(20) {
        m.move_to([f64::from(deg).to_radians()]).unwrap();
        let b = m.rocker_c();
        print!("{deg}:({:.3},{:.3}) ", b.x, b.y);
    }
    println!();
    let mut m = Kite::new();
    for deg in (60..=800).step_by(20) {
        m.move_to([f64::from(deg).to_radians()]).unwrap();
        let b = m.rocker_c();
        print!("{deg}:({:.7},{:.7}) ", b.x, b.y);
    }
    println!();
    let mut m = Rocker::new();
    println!("{:?}", m.move_to([2.0]));
    println!("{:?}", m.move_toward([2.0]));
    println!("{:?}", m.move_to([-2.0]));
    println!("{:?}", m.move_to([6.0]));
    println!(
        "{:?} {:e}",
        m.motors(),
        m.motors()[0] - 0.93508504139359448457
    );
}
