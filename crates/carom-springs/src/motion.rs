//! The equations of motion of a network.
//!
//! The state holds, for every ball, its displacement, its velocity and Rω; then the cue's speed and
//! the compression at the tip; then the pull of every compliant contact.
//!
//! Every contact closes, turns or opens, and this is constant during a step. The instant at which a
//! compression stops growing or falling is located, and the integration starts again there.
//!
//! Two forces of the model are not functions of the state. Where a compression neither grows nor
//! falls, the normal force is any between e²F and F, and where a rigid contact does not slip, the
//! friction is any up to μF. Such a force has the value that keeps the contact so. Here it is the
//! value that would end approach or slip exponentially, within the time [`Settings::settling`]: all
//! of these forces are found together, by projected Gauss–Seidel iteration. For a contact that
//! moves, this gives the model's own force, so nothing is smoothed, and the equations do not become
//! stiff.
//!
//! Units are the fastest speed, the heaviest mass, and the shortest contact's time (m*²/(k²V))^(1/5).

use std::cell::RefCell;

use differential_equations::ode::ODE;

use crate::Vector;
use crate::law::Law;
use crate::network::{Network, Sides};

/// How accurately a network is integrated.
#[derive(Clone, Copy, Debug)]
pub struct Settings {
    /// Error of a step, in units of the fastest speed.
    pub tolerance: f64,
    /// The time in which approach and slip end where they can, as a share of the contact's own
    /// (m*²/(k²V))^(1/5). A contact lasts 3.2 of these.
    pub settling: f64,
}

impl Settings {
    /// An error of about 1e-5.
    pub const USUAL: Self = Self { tolerance: 4e-8, settling: 0.01 };
    /// An error of about 1e-6, in about three times the time.
    pub const FINE: Self = Self { tolerance: 2e-9, settling: 0.003 };
}

/// Forces are found to this accuracy, in units of mass·speed/time.
const FORCE_ACCURACY: f64 = 1e-7;
/// The most sweeps of the iteration. Warm starts need a few.
const MAX_SWEEPS: usize = 60;
/// A bound that is exceeded by this factor needs no further look in the same evaluation.
const CLEARLY: f64 = 3.0;
/// A contact with less than this speed counts as none, in units of the fastest speed.
pub const WEAK: f64 = 5e-6;
/// A contact has turned when its approach has this size, in units of the fastest speed.
const TURNED: f64 = 1e-6;
/// A sliding contact sticks again when its pull is this share below its bound.
const RELEASED: f64 = 1e-3;
/// A pull that exceeds its bound by this share is a change of the state.
const LIMITED: f64 = 1e-4;
/// Below this compression (in units of length) a compliant contact's pull is held by μF alone.
const SHALLOW: f64 = 1e-3;

/// The units of a network.
#[derive(Clone, Copy, Debug)]
pub struct Units {
    /// m/s.
    pub speed: f64,
    /// kg.
    pub mass: f64,
    /// s.
    pub time: f64,
}

impl Units {
    /// m.
    pub fn length(&self) -> f64 {
        self.speed * self.time
    }
}

/// A contact in these units.
#[derive(Clone, Copy, Debug)]
struct Link {
    sides: Sides,
    law: Law,
    stiffness: f64,
    /// 1/m* along the normal, and across it.
    mobility: f64,
    across: f64,
    settling: f64,
    grip: f64,
    rough: bool,
    /// Where the pull is in the state.
    pull_at: Option<usize>,
}

/// What a contact's compression does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Phase {
    /// It grows; the force is F.
    #[default]
    Closing,
    /// It stops. The force is between e²F and F.
    Turning,
    /// It falls; the force is e²F.
    Opening,
}

/// What a contact has had so far, and the forces found last.
#[derive(Clone, Copy, Debug, Default)]
struct Memory {
    /// Fastest approach and slip.
    approach: f64,
    slip: f64,
    /// Normal force, and friction on the first ball.
    force: f64,
    rub: Vector,
    phase: Phase,
    /// Whether a compliant contact slides.
    slides: bool,
}

/// A contact that carries a force at this instant.
#[derive(Clone, Copy, Debug)]
struct Pressed {
    link: usize,
    normal: Vector,
    approach: f64,
    slip: Vector,
    depth: f64,
    /// F.
    closing: f64,
    least: f64,
    most: f64,
    friction: f64,
    force: f64,
    rub: Vector,
    /// The pull of a compliant contact, on the first ball.
    pull: Vector,
    settled: bool,
}

#[derive(Clone, Debug, Default)]
struct Work {
    pressed: Vec<Pressed>,
    push: Vec<Vector>,
    turn: Vec<Vector>,
    cue: f64,
    memory: Vec<Memory>,
    sweeps: u64,
}

/// The equations of a network.
#[derive(Debug)]
pub struct Equations {
    /// The units.
    pub units: Units,
    settings: Settings,
    links: Vec<Link>,
    /// 1/mass, radius and first position of every ball.
    mobility: Vec<f64>,
    radius: Vec<f64>,
    place: Vec<Vector>,
    /// Whether the lines of centres follow the centres.
    turns: bool,
    cue_mobility: f64,
    size: usize,
    work: RefCell<Work>,
}

fn vector(state: &[f64], at: usize) -> Vector {
    Vector::new(state[at], state[at + 1], state[at + 2])
}

fn store(state: &mut [f64], at: usize, v: Vector) {
    state[at..at + 3].copy_from_slice(v.as_slice());
}

impl Equations {
    /// The equations of `network`, and its state at the start. `None` if nothing moves.
    pub fn of(network: &Network, settings: &Settings) -> Option<(Self, Vec<f64>)> {
        let speed = network.fastest();
        let mass = network.balls.iter().map(|ball| ball.mass).fold(0.0, f64::max);
        // (m*²/(k²V))^(1/5)
        let own_time = |mobility: f64, stiffness: f64| {
            (1.0 / (mobility * mobility * stiffness * stiffness * speed)).powf(0.2)
        };
        let time = network
            .contacts
            .iter()
            .map(|contact| own_time(network.mobility(contact), contact.stiffness))
            .fold(f64::INFINITY, f64::min);
        if speed <= 0.0 || !time.is_finite() {
            return None;
        }
        let units = Units { speed, mass, time };
        let n = network.balls.len();
        let mut size = 9 * n + 2;
        let links = network
            .contacts
            .iter()
            .map(|contact| {
                let mobility = network.mobility(contact);
                let rough = !contact.law.friction.is_none();
                let pull_at = (rough && contact.law.frequency_ratio.is_some()).then(|| {
                    size += 3;
                    size - 3
                });
                let sides = match contact.sides {
                    Sides::Wall { ball, normal, gap, measured } => {
                        Sides::Wall { ball, normal, gap: gap / units.length(), measured }
                    }
                    other => other,
                };
                Link {
                    sides,
                    law: contact.law,
                    stiffness: contact.stiffness * units.length().powf(1.5) * time / (mass * speed),
                    mobility: mobility * mass,
                    across: 3.5 * mobility * mass,
                    settling: settings.settling * own_time(mobility, contact.stiffness) / time,
                    grip: contact.law.grip(),
                    rough,
                    pull_at,
                }
            })
            .collect::<Vec<_>>();
        let mut state = vec![0.0; size];
        for (k, ball) in network.balls.iter().enumerate() {
            store(&mut state, 9 * k + 3, ball.velocity / speed);
            store(&mut state, 9 * k + 6, ball.spin * (ball.radius / speed));
        }
        state[9 * n] = network.cue.map_or(0.0, |cue| cue.speed / speed);
        let work = Work {
            push: vec![Vector::zeros(); n],
            turn: vec![Vector::zeros(); n],
            memory: vec![Memory::default(); links.len()],
            ..Work::default()
        };
        let motion = Self {
            units,
            settings: *settings,
            links,
            mobility: network.balls.iter().map(|ball| mass / ball.mass).collect(),
            radius: network.balls.iter().map(|ball| ball.radius / units.length()).collect(),
            place: network.balls.iter().map(|ball| ball.position / units.length()).collect(),
            turns: !network.keeps_normals,
            cue_mobility: network.cue.map_or(0.0, |cue| mass / cue.mass),
            size,
            work: RefCell::new(work),
        };
        Some((motion, state))
    }

    /// How accurately it is integrated.
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// From a's centre to b's.
    fn way(&self, a: usize, b: usize, state: &[f64]) -> Vector {
        let place = self.place[b] - self.place[a];
        let moved = vector(state, 9 * b) - vector(state, 9 * a);
        if self.turns {
            return place + moved;
        }
        let normal = place.normalize();
        place + normal * moved.dot(&normal)
    }

    fn cue_at(&self) -> usize {
        9 * self.mobility.len()
    }

    /// Normal, compression, approach and slip of a contact; `None` for the normal's sake if two
    /// balls are clearly apart.
    fn geometry(&self, link: &Link, state: &[f64]) -> Option<(Vector, f64, f64, Vector)> {
        match link.sides {
            Sides::Balls { a, b } => {
                let way = self.way(a, b, state);
                let (reach, square) = (self.radius[a] + self.radius[b], way.norm_squared());
                if square > reach * reach {
                    return None;
                }
                let distance = square.sqrt();
                let normal = way / distance;
                let relative = vector(state, 9 * a + 3) - vector(state, 9 * b + 3);
                let approach = relative.dot(&normal);
                let surface = vector(state, 9 * a + 6) + vector(state, 9 * b + 6);
                let slip = relative - normal * approach + surface.cross(&normal);
                Some((normal, reach - distance, approach, slip))
            }
            Sides::Wall { ball, normal, gap, .. } => {
                let depth = vector(state, 9 * ball).dot(&normal) - gap;
                let velocity = vector(state, 9 * ball + 3);
                let approach = velocity.dot(&normal);
                let slip =
                    velocity - normal * approach + vector(state, 9 * ball + 6).cross(&normal);
                Some((normal, depth, approach, slip))
            }
            Sides::Tip { ball, launch, turn } => {
                let at = self.cue_at();
                let approach = state[at]
                    - launch.dot(&vector(state, 9 * ball + 3))
                    - turn.dot(&vector(state, 9 * ball + 6));
                Some((launch, state[at + 1], approach, Vector::zeros()))
            }
        }
    }

    /// The speed at which a contact's restitution is taken.
    fn measured(&self, link: &Link, state: &[f64], approach: f64) -> f64 {
        match link.sides {
            Sides::Wall { ball, measured, .. } => vector(state, 9 * ball + 3).dot(&measured),
            _ => approach,
        }
    }

    /// Whether no contact carries a force that would change a speed noticeably.
    pub fn is_free(&self, state: &[f64]) -> bool {
        let work = self.work.borrow();
        self.links.iter().zip(&work.memory).all(|(link, memory)| {
            let Some((_, depth, approach, _)) = self.geometry(link, state) else { return true };
            let e = match memory.phase {
                Phase::Closing => 1.0,
                _ => link.law.restitution.at(memory.approach * self.units.speed),
            };
            depth <= 0.0
                || approach <= WEAK
                    && link.spring(depth.max(0.0)) * e * e + approach * approach < WEAK * WEAK
                || e == 0.0 && approach <= WEAK
        })
    }

    /// To be called after every step: notes the fastest approach and slip of every compressed
    /// contact, and limits the pulls. Returns whether the state or the equations have changed.
    pub fn finish_step(&self, state: &mut [f64]) -> bool {
        let work = &mut *self.work.borrow_mut();
        let mut changed = false;
        for (link, memory) in self.links.iter().zip(&mut work.memory) {
            let pressed = self.geometry(link, state).filter(|(_, depth, ..)| *depth > 0.0);
            let force = if pressed.is_some() { memory.force } else { 0.0 };
            let weak = pressed.is_none_or(|(_, depth, approach, _)| link.is_weak(depth, approach));
            if let Some((_, depth, approach, slip)) = pressed {
                memory.approach = memory.approach.max(self.measured(link, state, approach));
                memory.slip = memory.slip.max(slip.norm());
                let closing = link.stiffness * depth * depth.sqrt();
                if memory.phase == Phase::Turning {
                    if approach > TURNED && force == closing {
                        memory.phase = Phase::Closing;
                    } else if approach < -TURNED && force < closing {
                        memory.phase = Phase::Opening;
                    }
                }
            } else {
                memory.phase = Phase::Closing;
            }
            let Some(at) = link.pull_at else { continue };
            let (bound, pull) = (self.friction(link, memory) * force, vector(state, at));
            let size = pull.norm();
            let slides = size > bound || memory.slides && size > (1.0 - RELEASED) * bound;
            if size > bound && size > 0.0 {
                store(state, at, pull * (bound / size));
                changed |= !weak && size > bound * (1.0 + LIMITED);
            }
            changed |= !weak && slides != memory.slides;
            memory.slides = slides;
        }
        changed
    }

    /// The approach speed of a contact, compressed or not.
    pub fn approach(&self, contact: usize, state: &[f64]) -> f64 {
        let link = &self.links[contact];
        if let Sides::Balls { a, b } = link.sides {
            let way = self.way(a, b, state);
            let relative = vector(state, 9 * a + 3) - vector(state, 9 * b + 3);
            return relative.dot(&way) / way.norm();
        }
        self.geometry(link, state).map_or(0.0, |(_, _, approach, _)| approach)
    }

    /// Writes into `turned` the contacts whose compression has begun to fall or to grow against
    /// their phase.
    pub fn find_turned(&self, state: &[f64], turned: &mut Vec<usize>) {
        let work = self.work.borrow();
        turned.clear();
        turned.extend((0..self.links.len()).filter(|&k| {
            let link = &self.links[k];
            let Some((_, depth, approach, _)) = self.geometry(link, state) else { return false };
            let against = match work.memory[k].phase {
                Phase::Closing => approach < 0.0,
                Phase::Turning => false,
                Phase::Opening => approach > 0.0,
            };
            let can_turn = depth > 0.0 && !link.law.restitution.is_lossless();
            against && can_turn && !link.is_weak(depth, approach)
        }));
    }

    /// Lets those of `contacts` turn whose compression no longer follows their phase.
    pub fn turn(&self, contacts: &[usize], state: &[f64]) {
        let mut work = self.work.borrow_mut();
        for &k in contacts {
            let (approach, memory) = (self.approach(k, state), &mut work.memory[k]);
            let along = if memory.phase == Phase::Opening { -approach } else { approach };
            if along < TURNED {
                memory.phase = Phase::Turning;
            }
        }
    }

    /// Finds the forces in a state that is not the end of a step.
    pub fn refresh(&self, state: &[f64]) {
        let work = &mut *self.work.borrow_mut();
        self.press(state, work);
        self.balance(work);
    }

    fn friction(&self, link: &Link, memory: &Memory) -> f64 {
        link.law.friction.at(memory.slip * self.units.speed)
    }

    /// The number of sweeps so far, for studies of the cost.
    pub fn sweeps(&self) -> u64 {
        self.work.borrow().sweeps
    }

    /// The time until a free network has its next contact; `None` if nothing approaches.
    pub fn next_contact(&self, state: &[f64], slowest: f64) -> Option<f64> {
        let mut next = f64::INFINITY;
        for link in &self.links {
            let time = match link.sides {
                Sides::Balls { a, b } => {
                    let way = self.way(a, b, state);
                    let relative = vector(state, 9 * a + 3) - vector(state, 9 * b + 3);
                    let reach = self.radius[a] + self.radius[b];
                    // |way − relative·t| = reach.
                    let closing = way.dot(&relative);
                    let square = relative.norm_squared();
                    let gap = way.norm_squared() - reach * reach;
                    let radicand = closing * closing - square * gap;
                    if closing <= slowest * reach || radicand <= 0.0 {
                        continue;
                    }
                    gap.max(0.0) / (closing + radicand.sqrt())
                }
                _ => {
                    let Some((_, depth, approach, _)) = self.geometry(link, state) else {
                        continue;
                    };
                    if approach <= slowest {
                        continue;
                    }
                    (-depth).max(0.0) / approach
                }
            };
            next = next.min(time);
        }
        next.is_finite().then_some(next)
    }

    /// Moves a free network on by `time`.
    pub fn drift(&self, state: &mut [f64], time: f64) {
        for k in 0..self.mobility.len() {
            let place = vector(state, 9 * k) + vector(state, 9 * k + 3) * time;
            store(state, 9 * k, place);
        }
        let at = self.cue_at();
        for link in &self.links {
            if let Sides::Tip { .. } = link.sides
                && let Some((_, _, approach, _)) = self.geometry(link, state)
            {
                state[at + 1] += approach * time;
            }
            if let Some(pull) = link.pull_at {
                store(state, pull, Vector::zeros());
            }
        }
    }

    /// The network in this state.
    pub fn network(&self, start: &Network, state: &[f64]) -> Network {
        let mut network = start.clone();
        for (k, ball) in network.balls.iter_mut().enumerate() {
            ball.position += vector(state, 9 * k) * self.units.length();
            ball.velocity = vector(state, 9 * k + 3) * self.units.speed;
            ball.spin = vector(state, 9 * k + 6) * (self.units.speed / ball.radius);
        }
        if let Some(cue) = &mut network.cue {
            cue.speed = state[self.cue_at()] * self.units.speed;
        }
        network
    }

    /// Finds the compressed contacts, and the bounds of their forces.
    fn press(&self, state: &[f64], work: &mut Work) {
        work.pressed.clear();
        for (k, link) in self.links.iter().enumerate() {
            let memory = &work.memory[k];
            let Some((normal, depth, approach, slip)) = self.geometry(link, state) else {
                continue;
            };
            if depth <= 0.0 {
                continue;
            }
            let fastest = self.measured(link, state, approach).max(memory.approach);
            let e = link.law.restitution.at(fastest * self.units.speed);
            let closing = link.stiffness * depth * depth.sqrt();
            let (least, most) = match memory.phase {
                Phase::Closing => (closing, closing),
                Phase::Turning => (e * e * closing, closing),
                Phase::Opening => (e * e * closing, e * e * closing),
            };
            let mut pressed = Pressed {
                link: k,
                normal,
                approach,
                slip,
                depth,
                closing,
                least,
                most,
                friction: 0.0,
                force: memory.force.clamp(least, most),
                rub: Vector::zeros(),
                pull: Vector::zeros(),
                settled: false,
            };
            if link.rough {
                let fastest = slip.norm().max(memory.slip);
                pressed.friction = link.law.friction.at(fastest * self.units.speed);
                if let Some(at) = link.pull_at {
                    let pull = vector(state, at);
                    pressed.pull = normal * pull.dot(&normal) - pull;
                } else {
                    pressed.rub = memory.rub - normal * memory.rub.dot(&normal);
                }
                pressed.hold(link);
            }
            work.pressed.push(pressed);
        }
    }

    fn relative(&self, work: &Work, pressed: &Pressed) -> f64 {
        match self.links[pressed.link].sides {
            Sides::Balls { a, b } => (work.push[a] - work.push[b]).dot(&pressed.normal),
            Sides::Wall { ball, .. } => work.push[ball].dot(&pressed.normal),
            Sides::Tip { ball, launch, turn } => {
                work.cue - launch.dot(&work.push[ball]) - turn.dot(&work.turn[ball])
            }
        }
    }

    fn slipping(&self, work: &Work, pressed: &Pressed) -> Vector {
        let n = pressed.normal;
        let (relative, surface) = match self.links[pressed.link].sides {
            Sides::Balls { a, b } => (work.push[a] - work.push[b], work.turn[a] + work.turn[b]),
            Sides::Wall { ball, .. } => (work.push[ball], work.turn[ball]),
            Sides::Tip { .. } => return Vector::zeros(),
        };
        relative - n * relative.dot(&n) + surface.cross(&n)
    }

    /// Adds a force along the normal, and friction on the first ball.
    fn add(&self, work: &mut Work, pressed: &Pressed, force: f64, rub: Vector) {
        let n = pressed.normal;
        match self.links[pressed.link].sides {
            Sides::Balls { a, b } => {
                let (push, turn) = (rub - n * force, n.cross(&rub) * 2.5);
                work.push[a] += push * self.mobility[a];
                work.push[b] -= push * self.mobility[b];
                work.turn[a] += turn * self.mobility[a];
                work.turn[b] += turn * self.mobility[b];
            }
            Sides::Wall { ball, .. } => {
                work.push[ball] += (rub - n * force) * self.mobility[ball];
                work.turn[ball] += n.cross(&rub) * (2.5 * self.mobility[ball]);
            }
            Sides::Tip { ball, launch, turn } => {
                work.push[ball] += launch * (force * self.mobility[ball]);
                work.turn[ball] += turn * (2.5 * force * self.mobility[ball]);
                work.cue -= force * self.cue_mobility;
            }
        }
    }

    /// One step of the iteration for one contact. Returns the change of its forces.
    fn relax(&self, work: &mut Work, k: usize) -> f64 {
        let mut pressed = work.pressed[k];
        let link = &self.links[pressed.link];
        let (force, rub) = (pressed.force, pressed.rub);
        let mut settled = true;
        if pressed.least < pressed.most {
            let wanted = force
                + (self.relative(work, &pressed) + pressed.approach / link.settling)
                    / link.mobility;
            pressed.force = wanted.clamp(pressed.least, pressed.most);
            let span = CLEARLY * pressed.most;
            settled = wanted > pressed.most + span || wanted < pressed.least - span;
        }
        if link.rough {
            if link.pull_at.is_none() {
                let most = pressed.friction * pressed.force;
                let stop = pressed.slip / (link.settling * link.across);
                let excess = stop.norm() / most.max(1e-300);
                // A fast slip alone gives the direction.
                let share = (0.5 * (CLEARLY - excess)).clamp(0.0, 1.0);
                let mut wanted = -stop;
                if share > 0.0 {
                    wanted += (pressed.rub - self.slipping(work, &pressed) / link.across) * share;
                    settled = false;
                }
                pressed.rub = wanted;
            }
            pressed.hold(link);
        }
        pressed.settled = settled;
        let (more, along) = (pressed.force - force, pressed.rub - rub);
        work.pressed[k] = pressed;
        if more != 0.0 || along != Vector::zeros() {
            self.add(work, &pressed, more, along);
        }
        more.abs() + along.norm()
    }

    /// Finds all forces, and the accelerations by them.
    fn balance(&self, work: &mut Work) {
        work.push.fill(Vector::zeros());
        work.turn.fill(Vector::zeros());
        work.cue = 0.0;
        for k in 0..work.pressed.len() {
            let pressed = work.pressed[k];
            self.add(work, &pressed, pressed.force, pressed.rub);
        }
        for sweep in 0..MAX_SWEEPS {
            let mut change: f64 = 0.0;
            for k in 0..work.pressed.len() {
                let pressed = &work.pressed[k];
                let link = &self.links[pressed.link];
                let is_free = pressed.least < pressed.most || link.rough && link.pull_at.is_none();
                if is_free && !(sweep > 1 && pressed.settled) {
                    change = change.max(self.relax(work, k));
                }
            }
            work.sweeps += 1;
            if change < FORCE_ACCURACY {
                break;
            }
        }
        for pressed in &work.pressed {
            let memory = &mut work.memory[pressed.link];
            (memory.force, memory.rub) = (pressed.force, pressed.rub);
        }
    }

    /// The rate of a compliant contact's pull on the second ball.
    fn pull_rate(pressed: &Pressed, link: &Link, pull: Vector, slides: bool) -> Vector {
        let Pressed { approach, depth, closing, most, least, force, .. } = *pressed;
        let mut rate = pressed.slip * (link.grip * link.stiffness * depth.sqrt());
        if approach < 0.0 {
            rate += pull * (approach / (2.0 * depth.max(SHALLOW)));
        }
        let size = pull.norm();
        if !slides || size == 0.0 {
            return rate;
        }
        // The contact slides: the pull follows the bound, and falls below it where the slip turns.
        let along = pull / size;
        let share = if force == most || force == least { force / closing } else { 0.0 };
        let growth = 1.5 * link.stiffness * depth.sqrt() * approach * share * pressed.friction;
        rate - along * (rate.dot(&along) - growth).max(0.0)
    }

    fn rates(&self, state: &[f64], rates: &mut [f64]) {
        let work = &mut *self.work.borrow_mut();
        self.press(state, work);
        self.balance(work);
        rates.fill(0.0);
        for k in 0..self.mobility.len() {
            store(rates, 9 * k, vector(state, 9 * k + 3));
            store(rates, 9 * k + 3, work.push[k]);
            store(rates, 9 * k + 6, work.turn[k]);
        }
        rates[self.cue_at()] = work.cue;
        let mut pressed = work.pressed.iter().peekable();
        for (k, link) in self.links.iter().enumerate() {
            let pressed = pressed.next_if(|pressed| pressed.link == k);
            if let Sides::Tip { .. } = link.sides
                && let Some((_, _, approach, _)) = self.geometry(link, state)
            {
                rates[self.cue_at() + 1] = approach;
            }
            if let Some(at) = link.pull_at {
                let pull = vector(state, at);
                let slides = work.memory[k].slides;
                let rate = pressed.map(|pressed| Self::pull_rate(pressed, link, pull, slides));
                store(rates, at, rate.unwrap_or_default());
            }
        }
    }
}

impl Link {
    /// The square of the speed with which a contact would part without losses.
    fn spring(&self, depth: f64) -> f64 {
        0.8 * self.stiffness * self.mobility * depth * depth * depth.sqrt()
    }

    /// Whether a compression is too weak to change a speed noticeably.
    fn is_weak(&self, depth: f64, approach: f64) -> bool {
        self.spring(depth) + approach * approach < WEAK * WEAK
    }
}

impl Pressed {
    /// Limits friction to μF.
    fn hold(&mut self, link: &Link) {
        if link.pull_at.is_some() {
            self.rub = self.pull;
        }
        let (most, size) = (self.friction * self.force, self.rub.norm());
        if size > most {
            self.rub *= most / size;
        }
    }
}

impl ODE<f64, Vec<f64>> for Equations {
    fn diff(&self, _time: f64, state: &Vec<f64>, rates: &mut Vec<f64>) {
        debug_assert_eq!(state.len(), self.size, "the state belongs to other equations");
        self.rates(state, rates);
    }
}
