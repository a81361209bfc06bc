"""MDF logs (ASAM, versions 3 and 4) through asammdf; each channel keeps the time base of its group.

A conversion formula is a text in the log, of which nothing but arithmetic is done. asammdf gives raw numbers, without a
word, where numexpr refuses a formula; or, where sympy is installed, has sympy run it as Python. So no formula is left
to it: here it is parsed, not executed, and its tree is worked out node by node.
"""

import ast
import mmap
import operator
import weakref
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pipeline.rig_logs.source import CsvOptions, Entry, Limits, Source, UnreadableLogError, ranges, unique_names

_LONGEST = 1000
_OPERATORS: dict[type[ast.AST], Callable[..., Any]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.Pow: operator.pow,
    ast.USub: operator.neg,
    ast.UAdd: operator.pos,
    ast.Lt: operator.lt,
    ast.LtE: operator.le,
    ast.Gt: operator.gt,
    ast.GtE: operator.ge,
}
_SAME = ("sin", "cos", "tan", "sinh", "cosh", "tanh", "exp", "log", "log10", "sqrt", "abs", "floor", "ceil")
_FUNCTIONS: dict[str, Callable[..., Any]] = {name: getattr(np, name) for name in _SAME} | {
    **{prefix + name: getattr(np, f"arc{name}") for name in ("sin", "cos", "tan") for prefix in ("a", "arc")},
    **{"ln": np.log, "pow": np.power},
}


def formula_of(conversion: Any) -> str | None:
    """The formula of a channel's conversion, "" for one hidden within a table of conversions; None without any."""
    if conversion is None:
        return None
    text = str(getattr(conversion, "formula", "") or "")
    if text:
        return text
    inner = (getattr(conversion, "referenced_blocks", None) or {}).values()
    return "" if any(formula_of(block) is not None for block in inner if hasattr(block, "conversion_type")) else None


def convert(formula: str, raw: NDArray[Any]) -> NDArray[np.float64]:
    """Work out a formula in X (or X1) for raw samples, in float64.

    Raises
    ------
    ValueError
        It is no arithmetic of numbers, X and the usual functions.

    Notes
    -----
    Letters count the same in both cases, since asammdf has turned every x in the text into X, also that of exp.
    """
    if len(formula) > _LONGEST:
        raise ValueError(f"it has {len(formula)} characters, more than {_LONGEST}")
    values = np.asarray(raw, dtype=np.float64)
    try:
        tree = ast.parse(formula.strip().lower(), mode="eval")
        with np.errstate(all="ignore"):  # what has no value is NaN, as a missing sample is
            result = _worked_out(tree.body, values)
    except (SyntaxError, RecursionError, MemoryError, TypeError, OverflowError) as error:
        raise ValueError(f"it cannot be worked out ({type(error).__name__})") from error
    return np.broadcast_to(np.asarray(result, dtype=np.float64), values.shape)


def _worked_out(node: ast.AST, x: NDArray[np.float64]) -> Any:
    def of(inner: ast.AST) -> Any:
        return _worked_out(inner, x)

    match node:
        case ast.Constant(value=int() | float() as number):
            return np.float64(number)
        case ast.Name(id="x" | "x1"):
            return x
        case ast.BinOp(left=left, op=op, right=right) if type(op) in _OPERATORS:
            return _OPERATORS[type(op)](of(left), of(right))
        case ast.UnaryOp(op=op, operand=operand) if type(op) in _OPERATORS:
            return _OPERATORS[type(op)](of(operand))
        case ast.Compare(left=left, ops=[op], comparators=[right]) if type(op) in _OPERATORS:
            return np.asarray(_OPERATORS[type(op)](of(left), of(right)), dtype=np.float64)
        case ast.Call(func=ast.Name(id=name), args=arguments, keywords=[]) if name in _FUNCTIONS:
            return _FUNCTIONS[name](*map(of, arguments))
    raise ValueError(f"{ast.unparse(node)[:40]!r} is no arithmetic that is known here")


_ADVICE = "export the channel with its physical values"


class MdfSource:
    """An MDF log. No channel is brought onto another one's raster, so no sample is invented."""

    def __init__(self, path: Path) -> None:
        from asammdf import MDF
        from asammdf.blocks import mdf_v4, v2_v3_blocks, v4_blocks

        for blocks in (v2_v3_blocks, v4_blocks):
            vars(blocks)["lambdify"] = None  # sympy's: it would run a formula in the log as Python
        # From 200 MiB on, asammdf 8.8 takes a path that reads whole channels for any slice, and fails for slices.
        vars(mdf_v4)["validate_blocks"] = lambda *_: False
        try:
            self._mdf = MDF(path)
        except Exception as error:  # asammdf lets errors of many kinds through on damaged files
            raise UnreadableLogError(f"truncated or damaged (asammdf: {type(error).__name__}: {error})") from error
        weakref.finalize(self, self._mdf.close).atexit = False  # its objects refer to each other, and would wait
        self.format = f"MDF {self._mdf.version}"
        self.notes: list[str] = []
        self.texts: dict[str, str] = {}
        self._places: dict[str, tuple[int, int]] = {}
        self._entries: list[Entry] = []
        self._list()

    def entries(self) -> list[Entry]:
        """Every channel whose samples are real numbers."""
        return self._entries

    def parts(self, names: Sequence[str]) -> Iterator[tuple[str, NDArray[Any]]]:
        """The samples of some channels in their physical units, NaN where the log marks them invalid."""
        for name in names:
            group, index = self._places[name]
            expected = int(self._mdf.groups[group].channel_group.cycles_nr)
            held = 0
            for first, last in ranges(expected):
                samples = self._samples(name, group, index, first, last - first)
                held += len(samples)
                yield name, samples
                self._let_go()
            if held != expected:
                raise UnreadableLogError(f"channel {name!r} has {held} of {expected} samples: truncated")

    def _let_go(self) -> None:
        """Give back the pages of the log that were read; asammdf maps all of it."""
        mapped = getattr(self._mdf._mdf, "_file", None)
        if isinstance(mapped, mmap.mmap):
            with suppress(OSError):  # it is an advice
                mapped.madvise(mmap.MADV_DONTNEED)

    def _samples(self, name: str, group: int, index: int, first: int, count: int) -> NDArray[Any]:
        is_master = index == self._mdf.masters_db.get(group)
        formula = formula_of(self._mdf.groups[group].channels[index].conversion)
        if formula == "" or (formula and is_master):
            raise UnreadableLogError(f"channel {name!r}: is converted by formulas in a way that is not read; {_ADVICE}")
        try:
            if is_master:
                samples: NDArray[Any] = self._mdf.get_master(group, record_offset=first, record_count=count)
                invalid: NDArray[Any] | None = None
            else:
                samples, invalid = self._mdf.get(
                    group=group,
                    index=index,
                    samples_only=True,
                    raw=formula is not None,
                    ignore_invalidation_bits=True,
                    record_offset=first,
                    record_count=count,
                )
        except Exception as error:
            raise UnreadableLogError(f"channel {name!r}: {type(error).__name__}: {error}") from error
        if samples.ndim != 1 or samples.dtype.kind not in "fiub":
            raise UnreadableLogError(f"channel {name!r} holds no plain numbers ({samples.dtype})")
        if formula:
            try:
                samples = convert(formula, samples)
            except ValueError as error:
                said = f"channel {name!r}: the log's conversion formula {formula[:60]!r}: {error}; {_ADVICE}"
                raise UnreadableLogError(said) from error
        if invalid is not None and np.any(invalid):
            samples = np.where(np.asarray(invalid, dtype=np.bool_), np.nan, samples)
        return np.asarray(samples)

    def _list(self) -> None:
        listed: list[tuple[str, int, int, Any]] = []
        groups: list[Any] = self._mdf.groups
        for group, content in enumerate(groups):
            listed += [(channel.name, group, index, channel) for index, channel in enumerate(content.channels)]
        names = unique_names([name for name, *_ in listed])
        masters = {
            group: name
            for name, (_, group, index, _) in zip(names, listed, strict=True)
            if index == self._mdf.masters_db.get(group)
        }
        for name, (_, group, index, channel) in zip(names, listed, strict=True):
            kind = _number_type(channel, self._mdf.version)
            if kind is None:
                continue
            count = int(self._mdf.groups[group].channel_group.cycles_nr)
            master = masters.get(group)
            unit = channel.unit or (getattr(channel.conversion, "unit", "") if channel.conversion else "")
            self._places[name] = (group, index)
            self._entries.append(Entry(name, unit or "", kind, count, None if name == master else master))


_KINDS_4 = {0: "uint", 1: "uint", 2: "int", 3: "int", 4: "float", 5: "float"}
_KINDS_3 = {
    **dict.fromkeys((0, 9, 13), "uint"),
    **dict.fromkeys((1, 10, 14), "int"),
    **dict.fromkeys((2, 3, 11, 12, 15, 16), "float"),
}


def _number_type(channel: Any, version: str) -> str | None:
    """The type of the stored numbers, None for texts, byte arrays, dates and structures."""
    kind = (_KINDS_4 if version >= "4" else _KINDS_3).get(channel.data_type)
    return f"{kind}{channel.bit_count}" if kind else None


def open_log(path: Path, csv: CsvOptions, limits: Limits) -> Source:
    """The log as `pipeline.rig_logs.child` opens it."""
    return MdfSource(path)
