// A player for carom's arena, carom-arena/1: it pots the easiest ball, aimed at the ghost ball.
// rustc --edition 2021 -O player.rs && carom arena check exec:./player
use std::collections::BTreeMap;
use std::io::BufRead;
/// A value of a message; true, false and null are texts.
#[derive(Clone, Default)]
struct Json { fields: BTreeMap<String, Json>, items: Vec<Json>, text: String, number: f64 }
type Point = [f64; 2];
impl Json {
    fn at(&self, key: &str) -> &Json { &self.fields[key] }
    fn has(&self, word: &str) -> bool { self.items.iter().any(|item| item.text == word) }
    fn point(&self) -> Point { [self.items[0].number, self.items[1].number] }
}
fn read(rest: &mut std::iter::Peekable<std::str::Chars>) -> Json {
    let mut value = Json::default();
    let is_gap = |c: &char| " ,:".contains(*c);
    while rest.next_if(is_gap).is_some() {}
    if rest.next_if_eq(&'"').is_some() {
        while let Some(c) = rest.next().filter(|c| *c != '"') {
            value.text.push(if c == '\\' { rest.next().unwrap_or(c) } else { c });
        }
    } else if let Some(open) = rest.next_if(|c| "{[".contains(*c)) {
        while { while rest.next_if(is_gap).is_some() {} rest.next_if(|c| "}]".contains(*c)).is_none() } {
            let item = read(rest);
            if open == '{' { value.fields.insert(item.text, read(rest)); } else { value.items.push(item); }
        }
    } else {
        while let Some(c) = rest.next_if(|c| !" ,:]}".contains(*c)) { value.text.push(c); }
        value.number = value.text.parse().unwrap_or_default();
    }
    value
}
fn minus(a: Point, b: Point) -> Point { [a[0] - b[0], a[1] - b[1]] }
fn dot(a: Point, b: Point) -> f64 { a[0] * b[0] + a[1] * b[1] }
fn length(a: Point) -> f64 { a[0].hypot(a[1]) }
/// Whether no ball but those two is nearer than `gap` to the way from `start` to `end`.
fn is_clear([start, end]: [Point; 2], balls: &BTreeMap<&str, Point>, but: [&str; 2], gap: f64) -> bool {
    balls.iter().filter(|(id, _)| !but.contains(id)).all(|(_, place)| {
        let (way, to) = (minus(end, start), minus(*place, start));
        let along = (dot(to, way) / dot(way, way).max(1e-12)).clamp(0.0, 1.0);
        length(minus(to, [along * way[0], along * way[1]])) >= gap
    })
}
/// The first choice; or the easiest pot, and without one a soft hit of a ball that is on.
fn answer(game: &Json, request: &Json, attempt: usize) -> String {
    if let Some(c) = request.fields.get("choices") { return format!(r#""type": "choose", "choice": "{}""#, c.items[0].text); }
    let (cue_id, on, calls) = (request.at("cue_ball").text.as_str(), &request.at("on"), &request.at("calls"));
    let radius = game.at("balls").at(cue_id).at("radius").number;
    let (opening, in_hand) = (request.at("opening").text == "true", request.at("in_hand").text != "null");
    let balls: BTreeMap<&str, Point> = request.at("balls").fields.iter().map(|(k, v)| (&**k, v.point())).collect();
    let places: Vec<Point> = if in_hand {
        let [low, high] = [0, 1].map(|k| request.at("region").at("bounds").items[k].point());
        let (size, middle) = (minus(high, low), 0.5 * (low[0] + high[0]));
        let grid = (0..81).map(|k| (f64::from(k % 9 - 4) / 12.0, f64::from(k / 9 + 1) / 20.0));
        let free = grid.map(|(x, y)| [middle + x * size[0], high[1] - y * size[1]]);
        free.filter(|at| is_clear([*at, *at], &balls, [cue_id; 2], 2.05 * radius)).collect()
    } else { vec![balls[cue_id]] };
    let is_target = |id: &&str| *id != cue_id && (on.items.is_empty() || on.has(id));
    let targets: Vec<&str> = balls.keys().copied().filter(is_target).collect();
    let (mut cue, mut aim) = (places[attempt % places.len()], balls[targets[0]]);
    let (mut target, mut pocket, mut best, mut speed) = (targets[0], "", 0.0, if opening { 8.0 } else { 2.0 });
    for from in places.into_iter().filter(|_| !opening && attempt == 0) { for id in &targets { for hole in &game.at("geometry").at("pockets").items {
        let (at, into) = (balls[id], hole.at("center").point());
        let way = minus(into, at);
        let ghost = [0, 1].map(|k| at[k] - 2.0 * radius * way[k] / length(way));
        let reach = minus(ghost, from);
        let full = dot(reach, way) / (length(reach) * length(way));
        let score = full / (0.3 + length(way)) / (0.5 + length(reach));
        let is_free = |way| is_clear(way, &balls, [cue_id, id], 2.0 * radius);
        if full > 0.3 && score > best && is_free([from, ghost]) && is_free([at, into]) {
            (best, cue, aim, target, pocket) = (score, from, ghost, id, &hole.at("name").text);
            speed = (1.0 + 0.7 * (length(reach) + length(way)) / full).min(10.0);
        }
    } } }
    let azimuth = minus(aim, cue)[1].atan2(minus(aim, cue)[0]);
    let place = if in_hand { format!(r#", "cue_ball": {cue:?}"#) } else { String::new() };
    let call = if calls.has("on") { format!(r#", "call": {{"kind": "on", "ball": "{target}"}}"#) }
    else if calls.has("pocket") && best > 0.0 {
        format!(r#", "call": {{"kind": "pocket", "ball": "{target}", "into": "{pocket}"}}"#)
    } else if calls.has("nothing") { String::new() } else { r#", "call": {"kind": "safety"}"#.into() };
    format!(r#""type": "play", "strike": {{"speed": {speed}, "azimuth": {azimuth}}}{place}{call}"#)
}
fn main() {
    let (mut game, mut request, mut attempt) = (Json::default(), Json::default(), 0);
    for line in std::io::stdin().lock().lines().map_while(Result::ok) {
        let message = read(&mut line.chars().peekable());
        let kind = message.at("type").text.clone();
        attempt = if kind == "refused" { attempt + 1 } else { 0 };
        if kind == "refused" && message.at("id").number != request.at("id").number { continue; }
        match kind.as_str() {
            "hello" => println!(r#"{{"type": "hello", "name": "ghost ball", "version": "1"}}"#),
            "match" => { game = message; println!(r#"{{"type": "ready"}}"#); }
            "request" | "refused" => {
                if kind == "request" { request = message; }
                println!(r#"{{"id": {}, {}}}"#, request.at("id").number, answer(&game, &request, attempt));
            }
            _ => {}
        }
    }
}
