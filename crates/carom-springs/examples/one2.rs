//! debug
use carom::Shot;
use carom_springs::build::Springs;
use carom_springs::judge::{CaseKind, integrated, played};
use carom_springs::motion::Settings;
fn main() {
    let a: Vec<String> = std::env::args().collect();
    let kind = CaseKind::all().into_iter().find(|k| k.name() == a[1]).unwrap();
    let file = kind.shot_file(a[2].parse().unwrap());
    if a.len() > 4 { println!("{file}"); }
    let shot = Shot::from_json(&file).unwrap();
    let p = played(&shot).unwrap();
    let i = integrated(&shot, &Springs { walls: a[3] == "w", keeps_normals: a[3] == "f", ..Springs::USUAL }, &Settings::USUAL).unwrap();
    for (t, n) in &i.pauses {
        println!("pause {:.1} us", t * 1e6);
        for (b, (e, o)) in p.balls.iter().zip(&n.balls).enumerate() { println!("  {b} {:9.5?} {:9.5?}", e.velocity.as_slice(), o.velocity.as_slice()); }
    }
}
