"""A player for carom's arena, carom-arena/1: it pots the easiest ball, aimed at the ghost ball.

carom arena check exec:"python3 player.py"
"""

import json
import math
import sys

match = {}  # what the referee said of the table, the balls and the pockets


def minus(a, b):
    """The vector from b to a."""
    return (a[0] - b[0], a[1] - b[1])


def is_clear(start, end, others, gap):
    """Whether no ball is nearer than gap to the way from start to end."""
    x, y = minus(end, start)
    for ball in others:
        u, v = minus(ball, start)
        along = min(max((u * x + v * y) / (x * x + y * y or 1.0), 0.0), 1.0)
        if math.hypot(u - along * x, v - along * y) < gap:
            return False
    return True


def places(request, others, radius):
    """Where the cue ball may be: where it lies, or free points of the region where it is placed."""
    if not request["in_hand"]:
        return [request["balls"][request["cue_ball"]]]
    (left, low), (right, high) = request["region"]["bounds"]
    xs = [(left + right) / 2 + (right - left) * n / 12 for n in range(-4, 5)]
    ys = [high - (high - low) * k / 20 for k in range(1, 10)]
    return [(x, y) for y in ys for x in xs if is_clear((x, y), (x, y), others, 2.05 * radius)]


def shot(request, attempt):
    """The easiest pot; without one a soft hit of a ball that is on."""
    calls, cue_id = request["calls"], request["cue_ball"]
    radius = match["balls"][cue_id]["radius"]
    balls = {ball: place for ball, place in request["balls"].items() if ball != cue_id}
    targets = request["on"] or list(balls)
    free = places(request, balls.values(), radius)
    cue, aim, ball, pocket, best = free[attempt % len(free)], balls[targets[0]], targets[0], None, 0
    speed = 8.0 if request["opening"] else 2.0
    for start in free if not request["opening"] and attempt == 0 else []:
        for target in targets:
            at = balls[target]
            others = [place for other, place in balls.items() if other != target]
            for hole in match["geometry"]["pockets"]:
                into = hole["center"]
                way = math.dist(at, into)
                ghost = [at[i] - 2 * radius * (into[i] - at[i]) / way for i in (0, 1)]
                (a, b), (c, d) = minus(ghost, start), minus(into, at)
                reach = math.hypot(a, b) or 1.0
                full = (a * c + b * d) / (reach * way)
                score = full / (0.3 + way) / (0.5 + reach)
                if full < 0.3 or score <= best or not is_clear(start, ghost, others, 2 * radius):
                    continue
                if is_clear(at, into, others, 2 * radius):
                    best, cue, aim, ball, pocket = score, start, ghost, target, hole["name"]
                    speed = min(1.0 + 0.7 * (reach + way) / full, 10.0)
    x, y = minus(aim, cue)
    answer = {"type": "play", "strike": {"speed": speed, "azimuth": math.atan2(y, x)}}
    if request["in_hand"]:
        answer["cue_ball"] = cue
    if "on" in calls:
        answer["call"] = {"kind": "on", "ball": ball}
    elif "pocket" in calls and pocket:
        answer["call"] = {"kind": "pocket", "ball": ball, "into": pocket}
    elif "nothing" not in calls:
        answer["call"] = {"kind": "safety"}
    return answer


request, attempt = {}, 0
for line in sys.stdin:
    message = json.loads(line)
    kind = message["type"]
    if kind == "hello":
        answer = {"type": "hello", "name": "ghost ball", "version": "1"}
    elif kind == "match":
        match, answer = message, {"type": "ready"}
    elif kind == "request" or (kind == "refused" and message["id"] == request.get("id")):
        request, attempt = (message, 0) if kind == "request" else (request, attempt + 1)
        if request["kind"] == "shot":
            answer = shot(request, attempt)
        else:
            answer = {"type": "choose", "choice": request["choices"][0]}
        answer["id"] = request["id"]
    else:
        continue
    print(json.dumps(answer), flush=True)
