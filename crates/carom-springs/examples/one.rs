//! debug
use carom::Shot;
use carom_springs::build::{Springs, network};
use carom_springs::impact::resolve;
use carom_springs::judge::CaseKind;
use carom_springs::motion::Settings;
fn main() {
    let a: Vec<String> = std::env::args().collect();
    let kind = CaseKind::all().into_iter().find(|k| k.name() == a[1]).unwrap();
    for seed in a[2].parse::<u64>().unwrap()..a[3].parse::<u64>().unwrap() {
        let shot = Shot::from_json(&kind.shot_file(seed)).unwrap();
        let n = network(&shot, &Springs { walls: a.len() < 5, ..Springs::USUAL });
        let t = std::time::Instant::now(); let s = if std::env::var("FINE").is_ok() { Settings::FINE } else { Settings::USUAL };
        let i = std::panic::catch_unwind(|| resolve(&n, &s, 2e-3));
        match i { Ok(Some(i)) => println!("{seed}: balls {} contacts {} steps {} evals {} sweeps {} pauses {} {:?} {:?}", n.balls.len(), n.contacts.len(), i.steps, i.evaluations, i.sweeps, i.pauses.len(), i.pauses.iter().map(|p| (p.0*1e6) as i64).collect::<Vec<_>>(), t.elapsed()),
          _ => println!("{seed}: balls {} fails {:?}", n.balls.len(), t.elapsed()) }
    }
}
