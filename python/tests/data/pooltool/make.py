"""Writes the systems of this folder to the current folder, with pooltool-billiards 0.6.0."""

import math

import pooltool as pt

# A ball on the left half of the table, cut into the top right pocket.
CUE, OBJECT = (0.45, 0.6), (0.62, 1.2)
balls = {
    "cue": pt.Ball.create("cue", xy=CUE),
    "1": pt.Ball.create("1", xy=OBJECT),
    "2": pt.Ball.create("2", xy=(0.2, 1.7)),
}
pot = pt.System(cue=pt.Cue(cue_ball_id="cue"), table=pt.Table.default(), balls=balls)
way = pot.table.pockets["rt"].center[:2] - OBJECT
ghost = OBJECT - way / math.hypot(*way) * 2 * balls["1"].params.R
phi = math.degrees(math.atan2(ghost[1] - CUE[1], ghost[0] - CUE[0]))
pot.strike(V0=2.2, phi=phi, theta=4.0, a=0.1, b=-0.15)
pot.save("pot.json")
pt.simulate(pot, inplace=True)
pot.save("pot_simulated.msgpack", drop_continuized_history=True)

for name, game in (("snooker", pt.GameType.SNOOKER), ("three_cushion", pt.GameType.THREECUSHION)):
    table = pt.Table.from_game_type(game)
    system = pt.System(cue=pt.Cue(cue_ball_id="white"), table=table, balls=pt.get_rack(game, table))
    system.strike(V0=3.0, phi=80.0, b=0.2)
    system.save(f"{name}.json")
