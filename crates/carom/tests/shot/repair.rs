//! Balls that overlap by little are moved apart.

use carom::format::{Node, repaired};

/// A rectangle with these balls.
fn file(balls: &[(&str, [f64; 2])]) -> Node {
    let ball = |(id, place): &(&str, [f64; 2])| {
        Node::object([("id", (*id).into()), ("position", Node::list(*place))])
    };
    Node::object([
        ("format", "carom-shot/1".into()),
        ("table", "wpa-9ft".into()),
        ("balls", Node::List(balls.iter().map(ball).collect())),
    ])
}

#[test]
fn a_mirrored_layout_has_a_mirrored_repair() {
    // Three balls in a bent row, each too close to the next.
    let width = 1.27;
    let row = [[0.5, 0.6], [0.557, 0.6], [0.6, 0.637]];
    let by = |mirror: bool| {
        let place = |[x, y]: [f64; 2]| [if mirror { width - x } else { x }, y];
        let balls = [("a", place(row[0])), ("b", place(row[1])), ("c", place(row[2]))];
        repaired(&file(&balls), 1e-3).expect("small overlaps").1
    };
    let (one, other) = (by(false), by(true));
    assert_eq!(one.len(), 3);
    for (ball, mirrored) in one.iter().zip(&other) {
        assert!((ball.by[0] + mirrored.by[0]).abs() < 1e-12, "{ball:?} {mirrored:?}");
        assert!((ball.by[1] - mirrored.by[1]).abs() < 1e-12, "{ball:?} {mirrored:?}");
    }
}

#[test]
fn the_displacement_is_the_smallest() {
    // Two overlapping balls share the overlap; a third at the side of one takes no part.
    let overlap = 1e-4;
    let balls = [("a", [0.5, 0.6]), ("b", [0.5 + 0.05715 - overlap, 0.6]), ("c", [0.5, 0.7])];
    let (_, moved) = repaired(&file(&balls), 1e-3).expect("a small overlap");
    let square: f64 = moved.iter().flat_map(|ball| ball.by).map(|x| x * x).sum();
    assert!((square - 0.5 * overlap * overlap).abs() < 1e-15, "{moved:?}");
    assert_eq!(moved.iter().map(|ball| ball.id.as_str()).collect::<Vec<_>>(), ["a", "b"]);
}

#[test]
fn a_layout_of_touching_balls_is_not_changed() {
    let balls = [("a", [0.5, 0.6]), ("b", [0.55715, 0.6])];
    let (node, moved) = repaired(&file(&balls), 1e-3).expect("no overlap");
    assert!(moved.is_empty());
    assert_eq!(node, file(&balls));
}
