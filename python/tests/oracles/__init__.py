"""Two simulations written independently of the engine, to be compared with it event by event.

`stepping` integrates the force laws through time; `precise` solves the event times with 50 digits.
Both read a `carom-shot/1` dict and name events as `carom-trace/1` does. They share no code with the
engine, but three inputs come from it: the geometry of tables with pockets (`carom.tables()`), the
state after a strike (from the trace; `laws.strike` checks it in a test of its own), and the
documented rules for slow contacts (the constants at the top of `laws`).

Covered models: `elastic` and `frictional` balls, `restitution` and `han-2005` cushions, slate, and
a cue with tip restitution. Not covered: `compliant` and `mathavan-2014` balls, `mathavan-2010` and
`stronge` cushions, rolling resistance in speed bands, drawn cling, contacts of several balls at
once, squirt, tip efficiency, sharp points, and the straight edges of pocket mouths.
"""
