"""Two simulations that share nothing with the engine, to be compared with it event by event.

`stepping` integrates the force laws through time; `precise` solves the event times with 50 digits.
Both read a `carom-shot/1` dict and answer in the words of `carom-trace/1`.
"""
