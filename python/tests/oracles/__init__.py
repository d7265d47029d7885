"""Two simulations written independently of the engine, to be compared with it event by event.

`stepping` integrates the force laws through time; `precise` solves the event times with 50 digits.
Both read a `carom-shot/1` dict and name events as `carom-trace/1` does. They share no code with the
engine, but three inputs come from it: the geometry of tables with pockets (`carom.tables()`), the
state after a strike (from the trace; `laws.strike` checks it in tests of its own), and the
documented rules for slow contacts (the constants at the top of `laws`). The numbers of the physics
presets are copied in `presets`.

Covered models: all of balls and cushions with fits of restitution and friction, clings, slate,
rolling resistance in bands of speed, and the cue with tip restitution or efficiency and with
squirt. `springs` solves the contact with a tangential spring stretch by stretch, and `friction`
integrates Mathavan's two models with exact Coulomb friction.

Not covered: contacts of several bodies at once (`crates/carom-springs` judges those), sharp points,
the straight edges of pocket mouths, and in `friction` a contact that slips again after it held. On
tables with pockets `precise` ends where a ball falls into a pocket, flies over the jaws or touches
an edge in flight; `stepping` goes on.
"""
