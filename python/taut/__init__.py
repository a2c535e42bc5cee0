# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Estimates length and tension of each cable of a tensioned net from one survey.

    net = taut.CableNet.load("net.json")
    survey = taut.read_survey(net, "survey.csv")
    found = taut.identify(net, survey)
    print(found, found.to_dataframe())
    plan = taut.plan(found, stroke=0.02)

All numbers are SI: m, N, rad, K. Nodes and edges are numbered from 0.
"""

from functools import partial
from importlib import import_module

from taut import _taut, calls, notebook
from taut._taut import *  # noqa: F403
from taut._taut import __version__
from taut.page import app  # noqa: F401
from taut.surveys import read_survey  # noqa: F401

for _name, _of in vars(_taut).items():
    if not _name.startswith("_") and hasattr(_of, "__nb_signature__"):
        globals()[_name] = calls.naming_arguments(_of)
    elif not _name.startswith("_") and isinstance(_of, type):
        calls.naming_arguments_of_methods(_of)


_taut.Identification._repr_mimebundle_ = notebook.mimebundle
_taut.Plan._repr_mimebundle_ = notebook.mimebundle


class Sampler(_taut.Sampler):
    __doc__ = _taut.Sampler.__doc__
    __init__ = calls.naming_arguments(_taut.Sampler.__init__, "Sampler")

    def __new__(cls, *args, **kwargs):
        self = super().__new__(cls)
        self._made_of = args, kwargs
        return self

    def __reduce__(self):
        args, kwargs = self._made_of
        return partial(type(self), **kwargs), args


__all__ = [name for name in dir() if not name.startswith("_")]
__all__ = [
    name
    for name in __all__
    if name not in ("import_module", "partial", "calls", "page", "surveys", "notebook")
]
__all__ += ["__version__", "gradients"]  # noqa: F405 - gp and plot take packages that are optional


def __getattr__(name):
    """Imports the modules that need more than NumPy when they are first used."""
    if name in ("gp", "gradients", "lines", "plot"):
        return import_module(f"taut.{name}")
    raise AttributeError(f"module 'taut' has no attribute {name!r}")
