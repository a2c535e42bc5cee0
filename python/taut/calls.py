# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Functions of the compiled module as functions of Python, which other processes can take. Errors
name the argument, and arguments of version 0.2 are taken under their old names."""

from __future__ import annotations

import ast
import difflib
import functools
import inspect
import json
import math
import operator
import re
import reprlib
import warnings
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from typing import Any, TypeVar, cast

Function = TypeVar("Function", bound=Callable[..., Any])

TYPES: dict[str, type] = {"str": str, "bool": bool}
NUMBERS: dict[str, Callable[[Any], float]] = {"int": operator.index, "float": math.fabs}

#: Arguments of version 0.2 and their names since. The old ones go with 0.4.
RENAMED = {
    "law": "prior",
    "readings": "forces",
    "unknowns": "uncertain",
    "further": "suggest_adjustable",
    "survey_first": "suggest_targets",
    "taut": "taut_edges",
    "slack": "slack_edges",
}


def _fits(value: Any, annotation: ast.expr | None) -> bool | None:
    """Whether a value is of a type as a stub writes it; None where that cannot be seen."""
    if isinstance(annotation, ast.BinOp):
        both = [_fits(value, annotation.left), _fits(value, annotation.right)]
        return True if True in both else None if None in both else False
    if isinstance(annotation, ast.Subscript):
        return _parts_fit(value, annotation)
    if annotation is None:
        return None
    name = ast.unparse(annotation).rpartition(".")[2]
    if name in ("ArrayLike", "Any", "object"):
        return True
    if name in NUMBERS:
        try:
            number = NUMBERS[name](value)
        except (TypeError, ValueError, OverflowError):
            return False
        # Which integers are too large, and whether they may be negative, is not seen.
        return True if name == "float" or 0 <= number < 2**31 else None
    if name in TYPES:
        return isinstance(value, TYPES[name])
    return name in [one.__name__.removesuffix("Type") for one in type(value).__mro__]


def _parts_fit(value: Any, annotation: ast.Subscript) -> bool | None:
    """The same of a Sequence[...], tuple[...] or Mapping[...]."""
    kind = ast.unparse(annotation.value).rpartition(".")[2]
    parts = annotation.slice.elts if isinstance(annotation.slice, ast.Tuple) else [annotation.slice]
    if kind not in ("Sequence", "tuple", "Mapping"):
        return None
    if isinstance(value, (str, bytes)) or isinstance(value, Mapping) != (kind == "Mapping"):
        return False
    if not isinstance(value, (Sequence, Mapping)):
        return None if hasattr(value, "__getitem__") else False
    if kind == "tuple" and len(value) != len(parts):
        return False
    rows: Iterable[Any] = [value]
    if kind != "tuple":
        rows = value.items() if isinstance(value, Mapping) else ((one,) for one in value)
    result: bool | None = True
    for one, part in (pair for row in rows for pair in zip(row, parts)):
        fits = _fits(one, part)
        if fits is False:
            return False
        result = result and fits
    return result


def _listed(annotation: ast.expr | None) -> str:
    return re.sub(r"\b[\w.]+\.(\w+)", r"\1", ast.unparse(annotation)) if annotation else ""


def _got(value: object) -> str:
    name = type(value).__name__
    if name in TYPES and not isinstance(value, TYPES[name]):
        name = f"{type(value).__module__}.{name}"
    is_short = isinstance(value, (int, list, tuple, dict))
    return f"{name} {reprlib.repr(value)}" if is_short else name


def _arguments(function: Any) -> tuple[ast.arguments, dict[str, ast.expr | None]]:
    """The arguments of a function of nanobind, and the annotations of all by their names."""
    head = re.sub(r"\\\d+", "...", function.__nb_signature__[0][0])
    arguments = cast("ast.FunctionDef", ast.parse(f"{head}: ...").body[0]).args
    arguments.args = [one for one in arguments.args if one.arg != "self"]
    return arguments, {one.arg: one.annotation for one in arguments.args + arguments.kwonlyargs}


def signature_of(function: Any) -> inspect.Signature:
    """What inspect.signature() says of a function or method of nanobind."""
    head, _, defaults = function.__nb_signature__[0]
    arguments, annotations = _arguments(function)
    of_self = [inspect.Parameter("self", inspect.Parameter.POSITIONAL_ONLY)]
    given = iter(defaults or ())
    kinds = inspect.Parameter
    first = arguments.args
    optional = len(arguments.defaults)
    of_first = [*[None] * (len(first) - optional), *arguments.defaults]

    def default_of(written: ast.expr | None) -> Any:
        if written is None:
            return kinds.empty
        # A stub of our own has the value itself, where nanobind has only a place for it.
        is_place = isinstance(written, ast.Constant) and written.value is ...
        return next(given) if is_place else ast.literal_eval(written)

    parameters = [
        kinds(
            one.arg,
            kind,
            default=default_of(default),
            annotation=ast.unparse(annotations[one.arg] or ast.Name("object")),
        )
        for ones, of_ones, kind in (
            (first, of_first, kinds.POSITIONAL_OR_KEYWORD),
            (arguments.kwonlyargs, arguments.kw_defaults, kinds.KEYWORD_ONLY),
        )
        for one, default in zip(ones, of_ones)
    ]
    if _is_method(function):
        parameters = of_self + parameters
    return inspect.Signature(parameters, return_annotation=head.rpartition(" -> ")[2])


def _is_method(function: Any) -> bool:
    return bool(re.match(r"def \w+\(self\b", function.__nb_signature__[0][0]))


def misfit(function: Any, args: tuple[Any, ...], kwargs: dict[str, Any]) -> str:
    """What is wrong with the arguments of a call that a function of nanobind has refused."""
    arguments, expected = _arguments(function)
    if len(args) > len(arguments.args):
        names = ", ".join(one.arg for one in arguments.args)
        return f"got {len(args)} arguments without a name, expected at most {names}"
    for name in [name for name in kwargs if name not in expected]:
        near = difflib.get_close_matches(name, expected, n=1)
        return f"{name}: is no argument, expected {' or '.join(near or expected)}"
    given = dict(zip(expected, args))
    for name in [name for name in kwargs if name in given]:
        return f"{name}: is given twice"
    given |= kwargs
    for one in arguments.args[: len(arguments.args) - len(arguments.defaults)]:
        if one.arg not in given:
            return f"{one.arg}: is missing, expected {_listed(one.annotation)}"
    fits = {name: _fits(value, expected[name]) for name, value in given.items()}
    wrong = [name for name in given if fits[name] is False]
    wrong = wrong or [name for name in given if fits[name] is None]
    if not wrong:
        names = ", ".join(f"{name}: {_listed(expected[name])}" for name in given)
        return f"arguments of a wrong type, expected {names}"
    texts = [
        f"{name}: got {_got(given[name])}, expected {_listed(expected[name])}" for name in wrong
    ]
    if all(fits[name] is None and isinstance(given[name], int) for name in wrong):
        texts[-1] += ", of 0 or more, and not so large"
    return "; ".join(texts)


def _with_new_names(
    name: str, kwargs: dict[str, Any], expected: Collection[str], renamed: dict[str, str]
) -> dict[str, Any]:
    """Arguments under their names of this version, with a warning for each old one."""
    for old in [old for old in kwargs if old not in expected and renamed.get(old) in expected]:
        new, value = renamed[old], kwargs.pop(old)
        if new in kwargs:
            raise TypeError(f"{name}: {old}: is the old name of {new}, which is given, too")
        note = f"{name}: {old} is now {new}"
        if old == "unknowns":  # these and nothing else
            note += "=['none', ...]"
            value = None if value is None else ["none", *value]
        warnings.warn(note, DeprecationWarning, stacklevel=3)
        if value is not None:
            kwargs[new] = value
    return kwargs


def taking_old_names(**renamed: str) -> Callable[[Function], Function]:
    """The same function of Python, which takes these arguments under their old names, too."""

    def of(function: Function) -> Function:
        expected = inspect.signature(function).parameters

        @functools.wraps(function)
        def call(*args: Any, **kwargs: Any) -> Any:
            kwargs = _with_new_names(function.__name__, kwargs, expected, renamed)
            return function(*args, **kwargs)

        return cast("Function", call)

    return of


def naming_arguments(function: Function, name: str | None = None) -> Function:
    """The same function: its errors name the argument, and it takes the names of RENAMED."""
    refused = f"{function.__name__}(): incompatible function arguments"
    is_method = _is_method(function)

    @functools.wraps(function)
    def call(*args: Any, **kwargs: Any) -> Any:
        if not RENAMED.keys().isdisjoint(kwargs):
            kwargs = _with_new_names(call.__name__, kwargs, _arguments(function)[1], RENAMED)
        try:
            return function(*args, **kwargs)
        except TypeError as error:
            if not str(error).startswith(refused):
                raise
            wrong = misfit(function, args[is_method:], kwargs)
            raise TypeError(f"{call.__name__}: {wrong}") from None

    call.__module__ = "taut"
    call.__signature__ = signature_of(function)  # type: ignore[attr-defined]
    call.__name__ = call.__qualname__ = name or function.__name__
    return cast("Function", call)


def json_of(data: Mapping[str, Any]) -> str:
    """A dict as JSON, with arrays as lists."""
    try:
        return json.dumps(data, default=operator.methodcaller("tolist"), allow_nan=False)
    except (AttributeError, TypeError, ValueError) as error:
        raise TypeError(f"data: is no JSON: {error}") from None


def refuse(of: type, args: tuple[Any, ...], kwargs: dict[str, Any]) -> None:
    """Raises what a class says to arguments that its constructor does not take."""
    raise TypeError(f"{of.__name__}: {misfit(vars(of)['__init__'], args, kwargs)}")


def naming_arguments_of_methods(of: type) -> None:
    """Does the same to the methods of a class of nanobind; its constructor can be inspected."""
    for name, method in list(vars(of).items()):
        signatures = getattr(method, "__nb_signature__", ())
        is_constructor = name == "__init__"
        if not signatures:
            continue
        if not is_constructor and (len(signatures) > 1 or name.startswith("__")):
            continue
        if not _is_method(method):
            setattr(of, name, staticmethod(naming_arguments(method, f"{of.__name__}.{name}")))
        elif is_constructor:
            signature = signature_of(method)
            parameters = list(signature.parameters.values())[1:]
            of.__signature__ = signature.replace(  # type: ignore[attr-defined]
                parameters=parameters, return_annotation=of.__name__
            )
        else:
            setattr(of, name, naming_arguments(method, f"{of.__name__}.{name}"))
