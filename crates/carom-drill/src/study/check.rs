//! Simulates what a study shows: its shots, their variations, and the solutions of its tasks.

use carom::format::Node;
use carom::{Error, ErrorKind, ShotFile, Trace};

use super::judge::{TaskVerdict, judge};
use super::read::with_strike;
use super::{Chapter, Study, TreeShot};

/// What was found in a chapter.
#[derive(Clone, Debug)]
pub struct ChapterReport {
    /// Its title.
    pub title: String,
    /// How many shots were simulated.
    pub shots: usize,
    /// How the solution of its task stands to the goal; none without a solution.
    pub solution: Option<TaskVerdict>,
    /// Shots that cannot be played, and a solution that does not meet its goal, each with its place.
    pub faults: Vec<Error>,
}

impl ChapterReport {
    /// As JSON and Python have it.
    pub fn to_node(&self) -> Node {
        Node::object([
            ("title", self.title.as_str().into()),
            ("shots", (self.shots as u32).into()),
            ("solution", self.solution.map_or(Node::Null, TaskVerdict::to_node)),
            ("faults", Node::list(self.faults.iter().map(|fault| Node::Text(fault.to_string())))),
        ])
    }
}

impl Study {
    /// Simulates the shots of every chapter, and judges the solutions of its tasks.
    pub fn check(&self) -> Vec<ChapterReport> {
        let chapters = self.chapters.iter().enumerate();
        chapters.map(|(index, chapter)| check(chapter, &format!("chapters[{index}]"))).collect()
    }
}

fn check(chapter: &Chapter, place: &str) -> ChapterReport {
    let Chapter { title, shot, tree, task, .. } = chapter;
    let mut report =
        ChapterReport { title: title.clone(), shots: 0, solution: None, faults: Vec::new() };
    report.simulate(shot, &format!("{place}.shot"));
    let mut ends: Vec<Option<Node>> = Vec::new();
    for (index, one) in tree.iter().enumerate() {
        let place = format!("{place}.tree[{index}]");
        let end = report.played(shot, one, &ends, &place);
        ends.push(end);
    }
    if let Some(task) = task
        && let Some(solution) = &task.solution
    {
        let place = format!("{place}.task.solution");
        if let Some(trace) = report.simulate(solution, &place) {
            match judge(&trace, &task.goal) {
                Ok(verdict) => {
                    report.solution = Some(verdict);
                    report.faults.extend(unmet(verdict, &place));
                }
                Err(error) => report.faults.push(error),
            }
        }
    }
    report
}

impl ChapterReport {
    /// The trace of a shot; none if it cannot be simulated.
    fn simulate(&mut self, shot: &ShotFile, place: &str) -> Option<Trace> {
        match shot.simulate() {
            Ok(trace) => {
                // A position without a strike has no events.
                self.shots += usize::from(trace.events().len() > 0);
                Some(trace)
            }
            Err(error) => {
                let what = error.to_string();
                self.faults.push(error.kind().at(place, what, ""));
                None
            }
        }
    }

    /// Plays a shot of a tree. Returns its position after it; none if nothing can follow.
    fn played(
        &mut self,
        shot: &ShotFile,
        TreeShot { after, strike, .. }: &TreeShot,
        ends: &[Option<Node>],
        place: &str,
    ) -> Option<Node> {
        let from = match after {
            None => without_extras(shot),
            Some(earlier) => {
                let Some(end) = &ends[*earlier] else {
                    let what = format!("no shot can follow tree[{earlier}]");
                    let remedy = "remove it, or play it from another shot";
                    self.faults.push(ErrorKind::NoPlay.at(format!("{place}.after"), what, remedy));
                    return None;
                };
                end.clone()
            }
        };
        let read = ShotFile::from_node(with_strike(&from, strike));
        let read = read.map_err(|error| error.inside(place));
        match read {
            Ok(shot) => {
                let trace = self.simulate(&shot, place)?;
                position_after(&from, &trace)
            }
            Err(error) => {
                self.faults.push(error);
                None
            }
        }
    }
}

/// The position of a shot's file, without what is drawn and filmed.
fn without_extras(shot: &ShotFile) -> Node {
    let mut file = shot.to_node().into_owned();
    for key in ["strike", "marks", "track"] {
        file.remove(key);
    }
    file
}

/// The position with the balls where a shot left them; none without balls.
fn position_after(from: &Node, trace: &Trace) -> Option<Node> {
    let outcome = trace.outcome();
    let Some(Node::List(entries)) = from.get("balls") else { return None };
    let mut left = Vec::new();
    for (index, (entry, state)) in entries.iter().zip(trace.last()).enumerate() {
        let ball = index as u16;
        let is_potted = outcome.pocketed.iter().any(|(one, _)| *one == ball);
        if is_potted || outcome.off_table.contains(&ball) {
            continue;
        }
        let mut kept =
            Node::object([("position", Node::list([state.position.x, state.position.y]))]);
        for key in ["id", "mass", "radius"] {
            if let Some(value) = entry.get(key) {
                kept.set(key, value.clone());
            }
        }
        left.push(kept);
    }
    if left.is_empty() {
        return None;
    }
    let mut after = from.clone();
    after.set("balls", Node::List(left));
    Some(after)
}

/// The fault of a solution that does not meet its goal.
fn unmet(verdict: TaskVerdict, place: &str) -> Option<Error> {
    let what = match verdict {
        TaskVerdict::Met => return None,
        TaskVerdict::CueBallLost => String::from("it loses the cue ball"),
        TaskVerdict::Missed { condition, distance: None } => {
            format!("it does not meet goal[{condition}]")
        }
        TaskVerdict::Missed { condition, distance: Some(distance) } => format!(
            "it does not meet goal[{condition}]: the ball stops {distance:.3} m outside the area"
        ),
    };
    Some(ErrorKind::Mismatch.at(place, what, "change the strike or the goal"))
}
