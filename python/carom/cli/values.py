"""Values of options that consist of several numbers."""

from __future__ import annotations

from carom.errors import InputError


def numbers(name: str, text: str, separator: str, shape: str, count: int = 3) -> list[float]:
    """The numbers in the value of an option.

    Args:
        name: The option, without its dashes.
        text: Its value.
        separator: What is between two numbers.
        shape: The form of the value, for the error message, such as ``X,Y,R``.
        count: How many numbers it has.

    Raises:
        InputError: It does not have this form.
    """
    try:
        found = [float(part) for part in text.split(separator)]
    except ValueError:
        found = []
    if len(found) != count:
        raise InputError(
            "wrong-count", f"--{name}", f"{text!r} is not {shape}", f"write {count} numbers"
        )
    return found
