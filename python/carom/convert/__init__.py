"""Shots of other engines, converted to shots of this one.

made = carom.convert.pooltool("shot.msgpack")
made.shot.simulate()
made.left_out                      # sentences on what could not be converted
"""

from carom.convert._fastfiz import fastfiz, fastfiz_log
from carom.convert._made import Converted
from carom.convert._pooltool import pooltool

__all__ = ["Converted", "fastfiz", "fastfiz_log", "pooltool"]
