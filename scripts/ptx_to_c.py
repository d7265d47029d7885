"""Translate PTX to C, so that a graphics card's program can be tested without a card.

``ptx_to_c.py KERNEL.ptx OUT.c`` writes one C function for each function of the PTX. Every register
is an unsigned integer of its width, and every PTX instruction becomes one C statement; compiled
with ``-ffp-contract=off``, each operation on doubles rounds on its own, as PTX asks with ``.rn``.
An instruction that this program does not know is an error. Barriers, shared memory and other means
of threads to exchange data are among these, so the threads of a launch can run one after the other:
a caller sets ``ptx_tid``, ``ptx_ctaid``, ``ptx_ntid`` and ``ptx_nctaid``, and calls
``ptx_<kernel>`` with pointers to its arguments.

Semantics: NVIDIA, Parallel Thread Execution ISA, version 7.0.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from pathlib import Path

from ptx_instructions import TRANSLATIONS, Operands, UnknownError, name, split, unsigned

PRELUDE = """\
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
typedef uint8_t u8; typedef uint16_t u16; typedef uint32_t u32; typedef uint64_t u64;
typedef int8_t s8; typedef int16_t s16; typedef int32_t s32; typedef int64_t s64;
typedef unsigned __int128 u128;
__thread u32 ptx_tid, ptx_ctaid, ptx_ntid = 1, ptx_nctaid = 1;
#define ADDRESS(x) ((u8 *)(uintptr_t)(x))
static inline double f64(u64 bits) { double x; memcpy(&x, &bits, 8); return x; }
static inline u64 b64(double x) { u64 bits; memcpy(&bits, &x, 8); return bits; }
static inline float f32(u32 bits) { float x; memcpy(&x, &bits, 4); return x; }
static inline u32 b32(float x) { u32 bits; memcpy(&bits, &x, 4); return bits; }
/* The other operand if one is NaN; -0 is less than +0. */
static inline double least(double a, double b) {
  if (a != a) return b;
  if (b != b) return a;
  return a < b || (a == b && signbit(a)) ? a : b;
}
static inline double most(double a, double b) {
  if (a != a) return b;
  if (b != b) return a;
  return a > b || (a == b && signbit(b)) ? a : b;
}
/* Towards zero, limited to the range; NaN becomes the lowest bit pattern with the sign bit. */
static inline u32 to_s32(double x) {
  if (x != x || x <= -2147483648.0) return 0x80000000u;
  return x >= 2147483647.0 ? 0x7fffffffu : (u32)(s32)x;
}
static inline u64 to_u64(double x) {
  if (x != x) return 0x8000000000000000u;
  if (x <= 0.0) return 0;
  return x >= 18446744073709551616.0 ? ~(u64)0 : (u64)x;
}
"""


def statements(text: str) -> Iterator[str]:
    """The statements of a function's body: braces, labels with their colon, and instructions."""
    depth, start = 0, 0
    for match in re.finditer(r'"[^"]*"|[{};:]', text):
        mark, end = match.group(), match.end()
        before = text[start : match.start()].strip()
        # Braces of operands, as in `{%r1, %r2}`, follow a name or a comma.
        if mark == "{" and before:
            depth += 1
        elif mark == "}" and depth:
            depth -= 1
        elif mark in "{}":
            yield mark
            start = end
        elif mark == ":":
            yield before + ":"
            start = end
        elif mark == ";":
            yield before
            start = end


class Function(Operands):
    """A function of the PTX."""

    def statement(self, text: str) -> str:
        """The C of a statement."""
        if text in {"{", "}"}:
            return text
        if text.endswith(":"):
            return f"{name(text[:-1])}:;"
        if text.startswith("."):
            return self.directive(text)
        guard = re.match(r"@(!?)%(\w+)\s+(.*)", text, re.DOTALL)
        if guard:
            return f"if ({guard[1]}{guard[2]}) {{ {self.instruction(guard[3])} }}"
        return self.instruction(text)

    def directive(self, text: str) -> str:
        """A declaration."""
        if text.startswith((".pragma", ".loc ")):
            return ""
        register = re.fullmatch(r"\.reg\s+\.(\w+)\s+%?([\w$]+)(?:<(\d+)>)?", text)
        if register:
            kind, stem, count = register.groups()
            names = [f"{stem}{k}" for k in range(int(count))] if count else [stem]
            c_type = "u8" if kind == "pred" else unsigned(kind)
            return f"{c_type} " + ", ".join(f"{one} = 0" for one in names) + ";"
        memory = re.fullmatch(
            r"\.(local|param)\s+(?:\.align\s+(\d+)\s+)?\.b(\d+)\s+([\w$]+)(?:\[(\d+)\])?", text
        )
        if memory:
            space, align, bits, symbol, count = memory.groups()
            size = int(bits) // 8 * int(count or 1)
            if space == "param":
                self.parameters[symbol] = name(symbol)
            return f"_Alignas({align or 16}) u8 {name(symbol)}[{size}];"
        raise UnknownError(text)

    def instruction(self, text: str) -> str:
        """The C of an instruction without its guard."""
        code, _, rest = text.replace("\n", " ").replace("\t", " ").partition(" ")
        operands = split(rest)
        parts = code.split(".")
        translate = TRANSLATIONS.get(parts[0])
        if translate is None:
            raise UnknownError(text)
        return translate(self, parts, operands)


FUNCTION = re.compile(
    r"^(?:\.visible\s+|\.weak\s+)*\.(?P<kind>func|entry)\s*(?:\(\s*(?P<result>[^)]*)\))?\s*(?P<name>[\w$]+)\s*"
    r"(?:\((?P<parameters>[^)]*)\))?\s*(?:\.noreturn\s*)?(?P<end>[;{])",
    re.MULTILINE,
)
GLOBAL = re.compile(
    r"^(?:\.visible\s+)?\.(?:global|const)\s+\.align\s+(?P<align>\d+)\s+\.[bus](?P<bits>\d+)\s+(?P<name>[\w$]+)"
    r"(?:\[(?P<count>\d+)\])?(?:\s*=\s*\{(?P<values>[^}]*)\})?;",
    re.MULTILINE,
)
DECLARED = re.compile(
    r"\.param\s+(?:\.align\s+\d+\s+)?\.[bus]\d+\s+(?:\.ptr\s+(?:\.global\s+)?\.align\s+\d+\s+)?"
    r"(?P<name>[\w$]+)(?:\[\d+\])?"
)


def declared(parameter: str) -> str:
    """The name of a declared parameter."""
    match = DECLARED.fullmatch(parameter.strip())
    if match is None:
        raise UnknownError(parameter)
    return match["name"]


def closing(text: str, start: int) -> int:
    """The place of the brace that closes the one before ``start``."""
    depth = 1
    for match in re.compile(r"[{}]").finditer(text, start):
        depth += 1 if match.group() == "{" else -1
        if depth == 0:
            return match.start()
    raise UnknownError("a function without end")


def translate(ptx: str) -> str:
    """The C of a PTX file.

    Raises:
        UnknownError: An instruction or a directive has no translation.
    """
    ptx = re.sub(r"//[^\n]*", "", ptx)
    lines = [PRELUDE]
    for match in GLOBAL.finditer(ptx):
        values = match["values"] or "0"
        if re.search(r"[A-Za-z_$]", re.sub(r"0x[0-9A-Fa-f]+", "", values)):
            raise UnknownError(f"addresses in {match['name']}")
        lines.append(
            f"static _Alignas({match['align']}) u{match['bits']} {name(match['name'])}"
            f"[{match['count'] or 1}] = {{{values}}};"
        )
    prototypes: dict[str, str] = {}
    bodies: list[str] = []
    for match in FUNCTION.finditer(ptx):
        parameters = {
            declared(one): f"argument{k}" for k, one in enumerate(split(match["parameters"] or ""))
        }
        result = declared(match["result"]) if match["result"] else None
        scope = "" if match["kind"] == "entry" else "static "
        signature = ", ".join(["u8 *result", *(f"u8 *{one}" for one in parameters.values())])
        prototypes[match["name"]] = f"{scope}void {name(match['name'])}({signature})"
        if match["end"] == "{":
            text = ptx[match.end() : closing(ptx, match.end())]
            function = Function(parameters, result)
            bodies.append(body(prototypes[match["name"]], function, text))
    return "\n".join([*lines, *(f"{one};" for one in prototypes.values()), *bodies, ""])


def body(head: str, function: Function, text: str) -> str:
    """The C of a function."""
    lists = re.compile(r"([\w$]+):\s*\.branchtargets\s+([^;]*);")
    for label, labels in lists.findall(text):
        function.targets[label] = split(labels)
    lines = [function.statement(one) for one in statements(lists.sub("", text)) if one]
    return "\n".join([f"{head} {{", "u64 carry = 0; (void)carry; (void)result;", *lines, "}"])


def main(arguments: list[str]) -> int:
    """Translate a file."""
    source, target = map(Path, arguments)
    target.write_text(translate(source.read_text(encoding="ascii")), encoding="ascii")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
