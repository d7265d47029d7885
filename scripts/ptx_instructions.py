"""The C of single PTX instructions, for ``ptx_to_c.py``."""

from __future__ import annotations

import re
from collections.abc import Callable

SPECIAL = {
    "%tid.x": "ptx_tid",
    "%ctaid.x": "ptx_ctaid",
    "%ntid.x": "ptx_ntid",
    "%nctaid.x": "ptx_nctaid",
}

# `lt` is false for NaN, `ltu` true.
ORDERED = {"eq": "==", "lt": "<", "le": "<=", "gt": ">", "ge": ">="}
COMPARISONS = ORDERED | {"ne": "!="}
OPPOSITE = {"eq": "!=", "lt": ">=", "le": ">", "gt": "<=", "ge": "<"}
ARITHMETIC = {"add": "+", "sub": "-", "mul": "*", "div": "/", "and": "&", "or": "|", "xor": "^"}


class UnknownError(Exception):
    """An instruction that has no translation."""


def unsigned(kind: str) -> str:
    """The C type of a PTX type as bits: ``u64`` for ``f64``."""
    return "u" + kind[1:]


def name(symbol: str) -> str:
    """A symbol or label of PTX as a name of C."""
    return "ptx_" + symbol.replace("$", "_")


def split(operands: str) -> list[str]:
    """Operands at the commas outside brackets."""
    return [part.strip() for part in re.split(r",(?![^\[({]*[\])}])", operands) if part.strip()]


class Operands:
    """What the operands of a function's instructions mean."""

    def __init__(self, parameters: dict[str, str], result: str | None) -> None:
        # The C name of each parameter, a pointer to its bytes.
        self.parameters = parameters
        self.result = result
        self.targets: dict[str, list[str]] = {}

    def value(self, operand: str) -> str:
        """The bits of an operand."""
        if operand in SPECIAL:
            return SPECIAL[operand]
        if operand.startswith("%"):
            return operand[1:]
        if operand == "_":
            raise UnknownError(operand)
        if re.fullmatch(r"0[dD][0-9A-Fa-f]{16}", operand):
            return f"0x{operand[2:]}u"
        if re.fullmatch(r"0[fF][0-9A-Fa-f]{8}", operand):
            return f"0x{operand[2:]}u"
        if re.fullmatch(r"-?(0x[0-9A-Fa-f]+|\d+)", operand):
            return f"((u64){int(operand, 0) & 0xFFFF_FFFF_FFFF_FFFF:#x}u)"
        return f"(u64)(uintptr_t){name(operand)}"

    def address(self, operand: str) -> str:
        """The address in brackets, as a pointer."""
        base, _, offset = operand.strip("[]").partition("+")
        if base in self.parameters:
            pointer = self.parameters[base]
        elif base == self.result:
            pointer = "result"
        elif base.startswith("%"):
            pointer = f"ADDRESS({base[1:]})"
        else:
            pointer = f"(u8 *){name(base)}"
        return f"{pointer} + ({int(offset or '0', 0)})"


def memory(function: Operands, parts: list[str], operands: list[str]) -> str:
    """Loads and stores, of one value or of a vector."""
    kind = unsigned(parts[-1])
    is_load = parts[0] == "ld"
    values, place = operands if is_load else reversed(operands)
    size = int(kind[1:]) // 8
    each = [value.strip() for value in values.strip("{}").split(",")]
    known = {"ld", "st", "local", "global", "nc", "param", "v2", "v4", parts[-1]}
    if not known.issuperset(parts):
        raise UnknownError(".".join(parts))
    address = function.address(place)
    # All are read before one is written: a register may hold the address.
    temporaries = "".join(
        f"{kind} t{k}; memcpy(&t{k}, {address} + {k * size}, {size}); "
        if is_load
        else f"{kind} t{k} = ({kind}){function.value(value)}; "
        f"memcpy({address} + {k * size}, &t{k}, {size}); "
        for k, value in enumerate(each)
    )
    results = "".join(f"{value[1:]} = t{k}; " for k, value in enumerate(each)) if is_load else ""
    return f"{{ {temporaries}{results}}}"


def move(function: Operands, parts: list[str], operands: list[str]) -> str:
    """``mov``, also of the halves of a register, and the conversions of addresses."""
    to, source = operands
    if to.startswith("{") or source.startswith("{"):
        pieces = [
            piece.strip() for piece in (to if to.startswith("{") else source).strip("{}").split(",")
        ]
        width = int(parts[-1][1:]) // len(pieces)
        if to.startswith("{"):
            bits = function.value(source)
            taken = [
                f"{piece.lstrip('%')} = (u{width})((u64){bits} >> {k * width});"
                for k, piece in enumerate(pieces)
            ]
            return " ".join(taken)
        joined = " | ".join(
            f"(u64)(u{width}){function.value(piece)} << {k * width}"
            for k, piece in enumerate(pieces)
        )
        return f"{to[1:]} = {joined};"
    return f"{to[1:]} = {function.value(source)};"


def compare(function: Operands, parts: list[str], operands: list[str]) -> str:
    """``setp``."""
    _, comparison, kind = parts
    to, a, b = operands[0][1:], *map(function.value, operands[1:])
    if kind[0] != "f":
        bits = kind.replace("b", "u")
        return f"{to} = ({bits}){a} {COMPARISONS[comparison]} ({bits}){b};"
    x, y = f"{kind}({a})", f"{kind}({b})"
    if comparison in {"nan", "num"}:
        is_nan = f"({x} != {x} || {y} != {y})"
        return f"{to} = {is_nan if comparison == 'nan' else '!' + is_nan};"
    if comparison == "ne":
        return f"{to} = {x} < {y} || {x} > {y};"
    if comparison == "neu":
        return f"{to} = {x} != {y};"
    if comparison == "equ":
        return f"{to} = !({x} < {y} || {x} > {y});"
    if comparison.endswith("u"):
        return f"{to} = !({x} {OPPOSITE[comparison[:-1]]} {y});"
    return f"{to} = {x} {ORDERED[comparison]} {y};"


def arithmetic(function: Operands, parts: list[str], operands: list[str]) -> str:
    """Operations that C has an operator for."""
    operation, kind = parts[0], parts[-1]
    to, *values = operands[0][1:], *map(function.value, operands[1:])
    middle = parts[1:-1]
    if kind == "f64" and middle == ["rn"]:
        a, b = (f"f64({value})" for value in values)
        return f"{to} = b64({a} {ARITHMETIC[operation]} {b});"
    if kind[0] == "f":
        raise UnknownError(".".join(parts))
    if kind == "pred":
        a, b = values
        return f"{to} = {a} {ARITHMETIC[operation]} {b};"
    if middle == ["cc"] and operation == "add" and kind == "s64":
        a, b = values
        add = f"u128 t = (u128)(u64){a} + (u64){b}; {to} = (u64)t; carry = (u64)(t >> 64);"
        return f"{{ {add} }}"
    bits = unsigned(kind)
    if operation == "mul":
        return product(to, kind, middle, values)
    if middle or operation == "div":
        raise UnknownError(".".join(parts))
    a, b = values
    return f"{to} = ({bits})(({bits}){a} {ARITHMETIC[operation]} ({bits}){b});"


def product(to: str, kind: str, form: list[str], values: list[str]) -> str:
    """``mul`` of integers: the low or the high half, or both."""
    a, b = (f"({kind}){value}" for value in values)
    width = int(kind[1:])
    wide = "u128" if width == 64 else f"{kind[0]}{2 * width}"
    if width == 64 and kind[0] == "s" and form != ["lo"]:
        raise UnknownError("mul of s64")
    both = f"({wide}){a} * ({wide}){b}"
    if form == ["wide"]:
        return f"{to} = ({unsigned(wide)})({both});"
    if form == ["hi"]:
        return f"{to} = (u{width})(({both}) >> {width});"
    return f"{to} = (u{width})((u64)(u{width}){values[0]} * (u64)(u{width}){values[1]});"


def multiply_add(function: Operands, parts: list[str], operands: list[str]) -> str:
    """``mad.lo`` of integers."""
    _, form, kind = parts
    if form != "lo":
        raise UnknownError(".".join(parts))
    bits = unsigned(kind)
    to, a, b, c = operands[0][1:], *map(function.value, operands[1:])
    return f"{to} = ({bits})((u64)({bits}){a} * (u64)({bits}){b} + (u64)({bits}){c});"


def add_carry(function: Operands, parts: list[str], operands: list[str]) -> str:
    """``addc``, with and without the carry out."""
    to, a, b = operands[0][1:], *map(function.value, operands[1:])
    if parts[-1] not in {"s64", "u64"}:
        raise UnknownError(".".join(parts))
    out = " carry = (u64)(t >> 64);" if "cc" in parts else ""
    return f"{{ u128 t = (u128)(u64){a} + (u64){b} + carry; {to} = (u64)t;{out} }}"


def shift(function: Operands, parts: list[str], operands: list[str]) -> str:
    """Shifts; by the width or more they give 0, or the sign."""
    operation, kind = parts
    width, bits = int(kind[1:]), unsigned(kind)
    to, a, count = operands[0][1:], *map(function.value, operands[1:])
    if operation == "shl":
        return f"{to} = (u32){count} >= {width} ? 0 : ({bits})(({bits}){a} << (u32){count});"
    signed = kind[0] == "s"
    value = f"({kind if signed else bits}){a}"
    beyond = f"{value} >> {width - 1}" if signed else "0"
    return f"{to} = ({bits})((u32){count} >= {width} ? {beyond} : {value} >> (u32){count});"


def unary(function: Operands, parts: list[str], operands: list[str]) -> str:
    """``sqrt``, ``rcp``, ``abs``, ``neg``, ``not`` and ``popc``."""
    kind, to, a = parts[-1], operands[0][1:], function.value(operands[1])
    sign = "0x8000000000000000u" if kind == "f64" else "0x80000000u"
    forms = {
        "sqrt.rn.f64": f"b64(sqrt(f64({a})))",
        "rcp.rn.f64": f"b64(1.0 / f64({a}))",
        f"abs.f{kind[1:]}": f"{a} & ~{sign}",
        f"neg.f{kind[1:]}": f"{a} ^ {sign}",
        "not.pred": f"!{a}",
        f"not.b{kind[1:]}": f"({unsigned(kind)})~{a}",
        f"neg.s{kind[1:]}": f"({unsigned(kind)})-{a}",
        "popc.b64": f"(u32)__builtin_popcountll({a})",
        "popc.b32": f"(u32)__builtin_popcount({a})",
    }
    code = ".".join(parts)
    if code not in forms:
        raise UnknownError(code)
    return f"{to} = {forms[code]};"


def extreme(function: Operands, parts: list[str], operands: list[str]) -> str:
    """``min`` and ``max``."""
    operation, kind = parts
    to, a, b = operands[0][1:], *map(function.value, operands[1:])
    if kind == "f64":
        return f"{to} = b64({'least' if operation == 'min' else 'most'}(f64({a}), f64({b})));"
    if kind[0] == "f":
        raise UnknownError(".".join(parts))
    sign = "<" if operation == "min" else ">"
    return f"{to} = ({unsigned(kind)})(({kind}){a} {sign} ({kind}){b} ? ({kind}){a} : ({kind}){b});"


def convert(function: Operands, parts: list[str], operands: list[str]) -> str:
    """``cvt``."""
    to, a = operands[0][1:], function.value(operands[1])
    forms = {
        "cvt.rn.f32.f64": f"b32((float)f64({a}))",
        "cvt.f64.f32": f"b64((double)f32({a}))",
        "cvt.rzi.s32.f64": f"to_s32(f64({a}))",
        "cvt.rzi.u64.f64": f"to_u64(f64({a}))",
        "cvt.rn.f64.s32": f"b64((double)(s32){a})",
        "cvt.rn.f64.u32": f"b64((double)(u32){a})",
        "cvt.rn.f64.s64": f"b64((double)(s64){a})",
        "cvt.rn.f64.u64": f"b64((double)(u64){a})",
    }
    code = ".".join(parts)
    if code in forms:
        return f"{to} = {forms[code]};"
    if len(parts) == 3 and "f" not in parts[1] + parts[2]:
        return f"{to} = ({unsigned(parts[1])})({parts[1]})({parts[2]}){a};"
    raise UnknownError(code)


def select(function: Operands, _: list[str], operands: list[str]) -> str:
    """``selp``."""
    to, a, b, condition = operands[0][1:], *map(function.value, operands[1:])
    return f"{to} = {condition} ? {a} : {b};"


def copy_sign(function: Operands, _: list[str], operands: list[str]) -> str:
    """``copysign``: the sign of the first on the second."""
    to, a, b = operands[0][1:], *map(function.value, operands[1:])
    sign = "0x8000000000000000u"
    return f"{to} = ({a} & {sign}) | ({b} & ~{sign});"


def field(function: Operands, _: list[str], operands: list[str]) -> str:
    """``bfe`` of unsigned integers."""
    to, a, at, count = operands[0][1:], *map(function.value, operands[1:])
    return f"{to} = ((u64){a} >> {at}) & (((u64)1 << {count}) - 1);"


def call(function: Operands, _: list[str], operands: list[str]) -> str:
    """A call; parameters are passed as pointers to their bytes."""
    *result, callee, arguments = operands if operands[-1].startswith("(") else [*operands, "()"]
    passed = [function.parameters[argument] for argument in split(arguments.strip("()"))]
    to = function.parameters[result[0].strip("() ")] if result else "0"
    return f"{name(callee)}({', '.join([to, *passed])});"


def branch(_: Operands, __: list[str], operands: list[str]) -> str:
    """``bra``."""
    return f"goto {name(operands[0])};"


def branch_indexed(function: Operands, _: list[str], operands: list[str]) -> str:
    """``brx.idx``."""
    labels = function.targets[operands[1]]
    cases = " ".join(f"case {k}: goto {name(label)};" for k, label in enumerate(labels))
    return f"switch ({function.value(operands[0])}) {{ {cases} default: abort(); }}"


def stop(_: Operands, __: list[str], ___: list[str]) -> str:
    """``trap``, and the ``exit`` that the compiler puts behind it."""
    return "abort();"


def leave(_: Operands, __: list[str], ___: list[str]) -> str:
    """``ret``."""
    return "return;"


TRANSLATIONS: dict[str, Callable[[Operands, list[str], list[str]], str]] = (
    dict.fromkeys(("ld", "st"), memory)
    | dict.fromkeys(("mov", "cvta"), move)
    | dict.fromkeys(ARITHMETIC, arithmetic)
    | dict.fromkeys(("sqrt", "rcp", "abs", "neg", "not", "popc"), unary)
    | dict.fromkeys(("min", "max"), extreme)
    | dict.fromkeys(("shl", "shr"), shift)
    | dict.fromkeys(("trap", "exit"), stop)
    | {
        "setp": compare,
        "selp": select,
        "copysign": copy_sign,
        "cvt": convert,
        "bfe": field,
        "mad": multiply_add,
        "addc": add_carry,
        "call": call,
        "bra": branch,
        "brx": branch_indexed,
        "ret": leave,
    }
)
