//! Several contacts in one instant that share balls, as when a ball runs into two touching ones.
//!
//! Taking the pairs one after another would make the result depend on their order and break the
//! symmetry of a rack. Here every contact that approaches acts at once:
//!
//! * **Normal impulses** p ≥ 0 by Newton's law at each contact: w′ ≤ −e·w, with equality where
//!   p > 0 (a linear complementarity problem; Moreau 1988). The energy changes by
//!   −½Σ p(1 − e)w ≤ 0. It is solved by projected Jacobi iteration, scaled by the row sums of the
//!   contacts' inverse-mass matrix, which bounds it from above, so that it converges; every sweep
//!   looks at all contacts alike, so the solution does not know their order.
//! * **Friction** by the pair's own law, with the normal impulse found and the slip that the
//!   normal impulses leave. All of it is scaled down together where the contacts of a ball would
//!   otherwise overdo it and raise the energy.
//!
//! Contacts that touch without approach take no part: if a neighbour's impact drives them
//! together they are the next event, at the same instant. `mathavan-2014` has no many-ball form
//! and acts here with its friction and restitution as `frictional` does.

use super::contact::Contact;
use super::{compliant, frictional};
use crate::math::Vec3;
use crate::physics::{BallBall, BallBallModel, Cloth};
use crate::resolve::{Body, restitution};

/// Most contacts that are resolved together; a frozen snooker rack has 30. More are taken in
/// pairs, in their order.
pub const MAX_CONTACTS: usize = 48;

/// Most balls in a group; more are taken in pairs, like contacts.
pub const MAX_BODIES: usize = 32;

/// Sweeps of the iteration at most. Two or three contacts need one to a hundred; what is left
/// after this many is still an approach, and so the next event.
const MAX_SWEEPS: usize = 2000;

/// Relative change of the impulses at which the iteration ends: a few roundings.
const CONVERGED: f64 = 4.0 * f64::EPSILON;

/// One contact of the group.
#[derive(Clone, Copy)]
struct Link {
    a: usize,
    b: usize,
    contact: Contact,
    restitution: f64,
    /// 1/m*, 1/kg.
    inverse_mass: f64,
    /// Σ of the absolute inverse masses with all contacts that share a ball, 1/kg.
    row_sum: f64,
    /// Normal impulse p, N·s.
    impulse: f64,
}

/// Resolves the `contacts` (indices into `bodies`, and the unit vector from the first ball's
/// centre to the second's) as one impact. A single contact is [`super::resolve`].
pub fn resolve_group(
    law: &BallBall,
    cloth: &Cloth,
    gravity: f64,
    bodies: &mut [Body],
    contacts: &[(u8, u8, Vec3)],
) {
    if contacts.len() == 1 || contacts.len() > MAX_CONTACTS || bodies.len() > MAX_BODIES {
        for &(a, b, normal) in contacts {
            if let Ok([a, b]) = bodies.get_disjoint_mut([usize::from(a), usize::from(b)]) {
                super::resolve(law, cloth, gravity, normal, a, b);
            }
        }
        return;
    }
    let mut store = [None; MAX_CONTACTS];
    let mut count = 0;
    for &(a, b, normal) in contacts {
        let (a, b) = (usize::from(a), usize::from(b));
        let contact = Contact::between(normal, &bodies[a], &bodies[b]);
        if contact.approach > 0.0 {
            store[count] = Some(Link {
                a,
                b,
                contact,
                restitution: restitution::effective(law.restitution, contact.approach),
                inverse_mass: 1.0 / bodies[a].mass + 1.0 / bodies[b].mass,
                row_sum: 0.0,
                impulse: 0.0,
            });
            count += 1;
        }
    }
    let Some(&Some(filler)) = store.first() else { return };
    let mut links = store.map(|link| link.unwrap_or(filler));
    let links = &mut links[..count];

    sum_rows(links, bodies);
    find_normal_impulses(links, bodies);
    let push = total(bodies, links.iter().map(|l| (l, l.impulse * l.inverse_mass, Vec3::ZERO)));
    add(bodies, &push, 1.0);
    if law.model != BallBallModel::Elastic {
        rub(law, links, bodies);
    }
}

/// How the impulse of `of` changes the approach at `at`, 1/kg.
fn coupling(at: &Link, of: &Link, bodies: &[Body]) -> f64 {
    let cosine = at.contact.normal.dot(of.contact.normal);
    let shared = |i: usize, j: usize, sign: f64| {
        if i == j { sign * cosine / bodies[i].mass } else { 0.0 }
    };
    shared(at.a, of.a, 1.0)
        + shared(at.b, of.b, 1.0)
        + (shared(at.a, of.b, -1.0) + shared(at.b, of.a, -1.0))
}

fn sum_rows(links: &mut [Link], bodies: &[Body]) {
    for k in 0..links.len() {
        links[k].row_sum = links.iter().map(|other| coupling(&links[k], other, bodies).abs()).sum();
    }
}

fn find_normal_impulses(links: &mut [Link], bodies: &[Body]) {
    // The velocity that the impulses give each ball, summed from zero in every sweep, so that
    // mirrored ones cancel to the bit.
    let mut pushed = [Vec3::ZERO; MAX_BODIES];
    for _ in 0..MAX_SWEEPS {
        pushed[..bodies.len()].fill(Vec3::ZERO);
        for link in links.iter() {
            let along = link.impulse * link.inverse_mass;
            pushed[link.a] -= link.contact.normal * (along * link.contact.share_a);
            pushed[link.b] += link.contact.normal * (along * link.contact.share_b);
        }
        let (mut largest, mut change) = (0.0_f64, 0.0_f64);
        for link in links.iter_mut() {
            let given = (pushed[link.a] - pushed[link.b]).dot(link.contact.normal);
            let excess = (1.0 + link.restitution) * link.contact.approach + given;
            let impulse = (link.impulse + excess / link.row_sum).max(0.0);
            change = change.max((impulse - link.impulse).abs());
            largest = largest.max(impulse);
            link.impulse = impulse;
        }
        if change <= CONVERGED * largest {
            return;
        }
    }
}

/// Friction at all contacts, with the slip that the normal impulses have left.
fn rub(law: &BallBall, links: &mut [Link], bodies: &mut [Body]) {
    let mut frictions = [Vec3::ZERO; MAX_CONTACTS];
    let mut work = 0.0;
    for (link, friction) in links.iter_mut().zip(&mut frictions) {
        link.contact = Contact::between(link.contact.normal, &bodies[link.a], &bodies[link.b]);
        let along = link.impulse * link.inverse_mass;
        *friction = match law.model {
            BallBallModel::Compliant => {
                compliant::friction(law, &link.contact, along, link.restitution)
            }
            _ => frictional::friction(law, &link.contact, along),
        };
        work += friction.dot(link.contact.slip) / link.inverse_mass;
    }
    let rubbed = total(bodies, links.iter().zip(&frictions).map(|(l, &f)| (l, 0.0, f)));
    let cost: f64 = rubbed[..bodies.len()].iter().map(kinetic_energy).sum();
    // Of the share λ the energy takes −λ·work + λ²·cost.
    add(bodies, &rubbed, if cost > work { work / cost } else { 1.0 });
}

/// What all impulses together (along n and tangential, per m*) change. Summed from zero, so that
/// mirrored impulses cancel to the bit.
fn total<'a>(
    bodies: &[Body],
    impulses: impl Iterator<Item = (&'a Link, f64, Vec3)>,
) -> [Body; MAX_BODIES] {
    let still = Body { velocity: Vec3::ZERO, angular_velocity: Vec3::ZERO, mass: 1.0, radius: 1.0 };
    let mut sum = [still; MAX_BODIES];
    for (sum, body) in sum.iter_mut().zip(bodies) {
        *sum = Body { mass: body.mass, radius: body.radius, ..still };
    }
    for (link, along, tangential) in impulses {
        if let Ok([a, b]) = sum.get_disjoint_mut([link.a, link.b]) {
            link.contact.apply(along, tangential, a, b);
        }
    }
    sum
}

fn add(bodies: &mut [Body], changes: &[Body; MAX_BODIES], share: f64) {
    for (body, change) in bodies.iter_mut().zip(changes) {
        body.velocity += change.velocity * share;
        body.angular_velocity += change.angular_velocity * share;
    }
}

fn kinetic_energy(body: &Body) -> f64 {
    0.5 * body.mass * body.velocity.length_squared()
        + 0.2 * body.mass * body.radius * body.radius * body.angular_velocity.length_squared()
}

#[cfg(test)]
mod tests {
    use super::resolve_group;
    use crate::math::{Vec3, cos, radians, sin, sqrt};
    use crate::physics::{BallBallModel, Physics};
    use crate::resolve::Body;

    fn ball(velocity: Vec3) -> Body {
        Body { velocity, angular_velocity: Vec3::ZERO, mass: 0.17, radius: 0.028575 }
    }

    fn at(angle: f64) -> Vec3 {
        Vec3::new(sin(radians(angle)), cos(radians(angle)), 0.0)
    }

    fn play(physics: &Physics, bodies: &mut [Body], contacts: &[(u8, u8, Vec3)]) {
        resolve_group(&physics.ball_ball, &physics.cloth, physics.gravity, bodies, contacts);
    }

    #[test]
    fn a_ball_into_two_touching_balls_bounces_back_with_a_fifth_of_its_speed() {
        let mut bodies = [ball(Vec3::new(0.0, 1.0, 0.0)), ball(Vec3::ZERO), ball(Vec3::ZERO)];
        play(&Physics::ideal(), &mut bodies, &[(0, 1, at(30.0)), (0, 2, at(-30.0))]);
        assert!((bodies[0].velocity.y + 0.2).abs() < 1e-15);
        assert_eq!(bodies[0].velocity.x, 0.0);
        for body in &bodies[1..] {
            assert!((body.velocity.length() - 0.4 * sqrt(3.0)).abs() < 1e-15);
        }
    }

    #[test]
    fn mirrored_contacts_give_mirrored_results_to_the_bit_in_any_order() {
        let mut cue = ball(Vec3::new(0.0, 3.0, 0.0));
        cue.angular_velocity = Vec3::new(-40.0, 0.0, 0.0);
        let start = [cue, ball(Vec3::ZERO), ball(Vec3::ZERO)];
        let (right, left) = (at(30.0), Vec3 { x: -at(30.0).x, ..at(30.0) });
        for model in [BallBallModel::Frictional, BallBallModel::Compliant] {
            let mut physics = Physics::pool();
            physics.ball_ball.model = model;
            let (mut one, mut two) = (start, start);
            play(&physics, &mut one, &[(0, 1, right), (0, 2, left)]);
            play(&physics, &mut two, &[(2, 0, -left), (0, 1, right)]);
            assert_eq!(one, two);
            let (a, b) = (one[1], one[2]);
            assert_eq!(Vec3 { x: -a.velocity.x, ..a.velocity }, b.velocity);
            let spin = a.angular_velocity;
            assert_eq!(Vec3::new(spin.x, -spin.y, -spin.z), b.angular_velocity);
            assert_eq!(one[0].velocity.x, 0.0);
            assert_eq!((one[0].angular_velocity.y, one[0].angular_velocity.z), (0.0, 0.0));
            assert!(a.angular_velocity.length() > 0.0);
        }
    }

    #[test]
    fn a_ball_between_two_that_close_in_on_it_leaves_both_contacts_parting() {
        let mut bodies =
            [ball(Vec3::new(1.0, 0.0, 0.0)), ball(Vec3::ZERO), ball(Vec3::new(-2.0, 0.0, 0.0))];
        let x = Vec3::new(1.0, 0.0, 0.0);
        play(&Physics::ideal(), &mut bodies, &[(0, 1, x), (1, 2, x)]);
        let v = bodies.map(|b| b.velocity.x);
        assert!((v[1] - v[0] - 1.0).abs() < 1e-14 && (v[2] - v[1] - 2.0).abs() < 1e-14, "{v:?}");
        assert!((v[0] + v[1] + v[2] + 1.0).abs() < 1e-14);
    }

    #[test]
    fn one_contact_is_the_pairs_own_law() {
        let physics = Physics::pool();
        let mut group = [ball(Vec3::new(0.3, 2.0, 0.0)), ball(Vec3::new(0.1, 0.0, 0.0))];
        let [mut a, mut b] = group;
        play(&physics, &mut group, &[(0, 1, at(20.0))]);
        crate::resolve::ball_ball::resolve(
            &physics.ball_ball,
            &physics.cloth,
            physics.gravity,
            at(20.0),
            &mut a,
            &mut b,
        );
        assert_eq!(group, [a, b]);
    }
}
