"""Shots of other engines as shot files of this one.

made = carom.convert.pooltool("shot.msgpack")
made.shot.simulate()
made.left_out                      # what could not be carried over, in sentences
"""

from carom.convert._fastfiz import fastfiz
from carom.convert._made import Converted
from carom.convert._pooltool import pooltool

__all__ = ["Converted", "fastfiz", "pooltool"]
