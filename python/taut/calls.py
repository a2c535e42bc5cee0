# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Functions of the compiled module as those of Python: they can be handed to other processes, and
what they cannot take is told by the argument's name."""

from __future__ import annotations

import ast
import difflib
import functools
import re

TYPES = {"str": str, "bool": bool}


def _fits(value, annotation: ast.expr):
    """Whether a value is of a type as a stub writes it; None where that takes a closer look."""
    if isinstance(annotation, ast.BinOp):
        both = [_fits(value, annotation.left), _fits(value, annotation.right)]
        return True if True in both else None if None in both else False
    if isinstance(annotation, ast.Subscript):
        return None
    name = ast.unparse(annotation).rpartition(".")[2]
    if name in ("ArrayLike", "object"):
        return True
    if name == "int" and hasattr(value, "__index__"):
        return None  # it may be too large, or negative
    if name == "float":
        return hasattr(value, "__float__") or hasattr(value, "__index__")
    if name in TYPES:
        return isinstance(value, TYPES[name])
    return type(value).__name__.removesuffix("Type") == name


def _listed(annotation):
    return re.sub(r"\b[\w.]+\.(\w+)", r"\1", ast.unparse(annotation))


def _got(value):
    name = type(value).__name__
    return f"{name} {value}" if isinstance(value, int) else name


def misfit(function, args, kwargs) -> str:
    """What is wrong with the arguments of a call that a function of nanobind has refused."""
    head = re.sub(r"\\\d+", "...", function.__nb_signature__[0][0])
    told = ast.parse(f"{head}: ...").body[0].args
    expected = {one.arg: one.annotation for one in [*told.args, *told.kwonlyargs]}
    if len(args) > len(told.args):
        names = ", ".join(one.arg for one in told.args)
        return f"got {len(args)} arguments without a name, expected at most {names}"
    for name in [name for name in kwargs if name not in expected]:
        near = difflib.get_close_matches(name, expected, n=1)
        return f"{name}: is no argument, expected {' or '.join(near or expected)}"
    given = dict(zip(expected, args))  # noqa: B905 - args are the first of all
    for name in [name for name in kwargs if name in given]:
        return f"{name}: is given twice"
    given |= kwargs
    for one in told.args[: len(told.args) - len(told.defaults)]:
        if one.arg not in given:
            return f"{one.arg}: is missing, expected {_listed(one.annotation)}"
    fits = {name: _fits(value, expected[name]) for name, value in given.items()}
    wrong = [name for name in given if fits[name] is False]
    wrong = wrong or [name for name in given if fits[name] is None] or list(given)
    return "; ".join(
        f"{name}: got {_got(given[name])}, expected {_listed(expected[name])}" for name in wrong
    )


def naming_arguments(function, name=None):
    """The same function, which tells what it cannot take by the argument's name."""
    refused = f"{function.__name__}(): incompatible function arguments"

    @functools.wraps(function)
    def call(*args, **kwargs):
        try:
            return function(*args, **kwargs)
        except TypeError as error:
            if not str(error).startswith(refused):
                raise
            raise TypeError(f"{call.__name__}: {misfit(function, args, kwargs)}") from None

    call.__module__ = "taut"
    call.__name__ = call.__qualname__ = name or function.__name__
    return call
