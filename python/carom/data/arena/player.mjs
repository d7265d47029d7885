// A player for carom's arena, carom-arena/1: it pots the easiest ball, aimed at the ghost ball.
//
//     carom arena check exec:"node player.mjs"
//     carom match exec:"node player.mjs" level-1 --game nine-ball --pairs 2 --out match

import { createInterface } from "node:readline";

let match = {}; // what the referee said of the table, the balls and the pockets
let request = {};
let attempt = 0;

const minus = (a, b) => [a[0] - b[0], a[1] - b[1]];
const distance = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]);

// Whether no ball is nearer than gap to the way from start to end.
function isClear(start, end, others, gap) {
  const [x, y] = minus(end, start);
  return others.every((ball) => {
    const [u, v] = minus(ball, start);
    const along = Math.min(Math.max((u * x + v * y) / (x * x + y * y || 1), 0), 1);
    return Math.hypot(u - along * x, v - along * y) >= gap;
  });
}

// Where the cue ball may be: where it lies, or free points of the region in which it is placed.
function places({ balls, cue_ball, in_hand, region }, radius) {
  if (!in_hand) return [balls[cue_ball]];
  const [[left, low], [right, high]] = region.bounds;
  const others = Object.keys(balls).filter((ball) => ball !== cue_ball);
  const found = [];
  for (let k = 1; k < 10; k++) {
    for (let n = -4; n < 5; n++) {
      const place = [(left + right) / 2 + ((right - left) * n) / 12, high - ((high - low) * k) / 20];
      if (others.every((ball) => distance(place, balls[ball]) > 2.05 * radius)) found.push(place);
    }
  }
  return found;
}

// The easiest pot; without one a soft hit of a ball that is on.
function shot() {
  const { balls, calls, cue_ball: cueBall, opening } = request;
  const radius = match.balls[cueBall].radius;
  const onTable = Object.keys(balls).filter((ball) => ball !== cueBall);
  const targets = request.on.length ? request.on : onTable;
  const free = places(request, radius);
  let best = { score: -1, cue: free[attempt % free.length], aim: balls[targets[0]], ball: targets[0], speed: 2 };
  for (const cue of opening || attempt > 0 ? [] : free) {
    for (const ball of targets) {
      const at = balls[ball];
      const others = onTable.filter((other) => other !== ball).map((other) => balls[other]);
      for (const { name, center } of match.geometry.pockets) {
        const way = distance(at, center);
        const ghost = at.map((x, i) => x - (2 * radius * (center[i] - x)) / way);
        const [[a, b], [c, d]] = [minus(ghost, cue), minus(center, at)];
        const reach = Math.hypot(a, b) || 1;
        const fullness = (a * c + b * d) / (reach * way);
        const score = fullness / (0.3 + way) / (0.5 + reach);
        if (fullness < 0.3 || score <= best.score) continue;
        if (!isClear(cue, ghost, others, 2 * radius) || !isClear(at, center, others, 2 * radius)) continue;
        best = { score, cue, aim: ghost, ball, pocket: name, speed: 1 + (0.7 * (reach + way)) / fullness };
      }
    }
  }
  const [x, y] = minus(best.aim, best.cue);
  const speed = opening ? 8 : Math.min(best.speed, 10);
  const answer = { type: "play", strike: { speed, azimuth: Math.atan2(y, x) } };
  if (request.in_hand) answer.cue_ball = best.cue;
  if (calls.includes("on")) answer.call = { kind: "on", ball: best.ball };
  else if (calls.includes("pocket") && best.pocket) answer.call = { kind: "pocket", ball: best.ball, into: best.pocket };
  else if (!calls.includes("nothing")) answer.call = { kind: "safety" };
  return answer;
}

function answerTo(message) {
  if (message.type === "hello") return { type: "hello", name: "ghost ball", version: "1" };
  if (message.type === "match") {
    match = message;
    return { type: "ready" };
  }
  const isRefused = message.type === "refused" && message.id === request.id;
  if (message.type !== "request" && !isRefused) return undefined;
  [request, attempt] = isRefused ? [request, attempt + 1] : [message, 0];
  const answer = request.kind === "shot" ? shot() : { type: "choose", choice: request.choices[0] };
  return { ...answer, id: request.id };
}

for await (const line of createInterface({ input: process.stdin })) {
  const answer = answerTo(JSON.parse(line));
  if (answer) process.stdout.write(`${JSON.stringify(answer)}\n`);
}
