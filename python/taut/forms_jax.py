# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""The five functions of forms.py as primitives of JAX."""

from functools import reduce
from typing import Any

import jax
import jax.numpy as jnp
from jax.extend.core import Primitive
from jax.interpreters import ad, batching, mlir

from taut.forms import ALONG, NAMES, NO_THIRD, Forms, transposed

__all__ = ["PRIMITIVES", "jnp"]

PRIMITIVES: dict[str, Any] = {}


def _bind(name: str, *arguments: Any, forms: Forms) -> Any:
    return PRIMITIVES[name].bind(*arguments, forms=forms)


def _define(name: str) -> None:
    primitive = PRIMITIVES[name] = Primitive(f"taut_form_{name}")

    def shape(lengths: Any, *_: Any, forms: Forms) -> Any:
        return jax.ShapeDtypeStruct(lengths.shape[:-1] + forms.shape(name), lengths.dtype)

    def solved(*arguments: Any, forms: Forms) -> Any:
        return forms.each(name, *arguments).astype(arguments[0].dtype)

    def called_back(*arguments: Any, forms: Forms) -> Any:
        return jax.pure_callback(
            lambda *arrays: solved(*arrays, forms=forms), shape(*arguments, forms=forms), *arguments
        )

    def moved(primals: Any, tangents: Any, *, forms: Forms) -> Any:
        of_lengths, *linear = tangents
        terms = [
            _bind(name, *primals[: i + 1], tangent, *primals[i + 2 :], forms=forms)
            for i, tangent in enumerate(linear)
            if type(tangent) is not ad.Zero
        ]
        if type(of_lengths) is not ad.Zero:
            if name not in ALONG:
                raise NotImplementedError(NO_THIRD)
            terms.append(_bind(ALONG[name], *primals, of_lengths, forms=forms))
        return _bind(name, *primals, forms=forms), reduce(ad.add_jaxvals, terms)

    def pulled_back(cotangent: Any, lengths: Any, *linear: Any, forms: Forms) -> list[Any]:
        def by(i: int) -> Any:
            if type(cotangent) is ad.Zero or not ad.is_undefined_primal(linear[i]):
                return None
            other, arguments = transposed(name, i, cotangent, linear)
            return _bind(other, lengths, *arguments, forms=forms)

        return [None, *map(by, range(len(linear)))]

    def batched(arguments: Any, axes: Any, *, forms: Forms) -> tuple[Any, int]:
        pairs = list(zip(arguments, axes))
        size = next(one.shape[axis] for one, axis in pairs if axis is not None)
        same = [
            jnp.moveaxis(one, axis, 0)
            if axis is not None
            else jnp.broadcast_to(one, (size, *one.shape))
            for one, axis in pairs
        ]
        return _bind(name, *same, forms=forms), 0

    primitive.def_impl(lambda *arguments, forms: jnp.asarray(solved(*arguments, forms=forms)))
    primitive.def_abstract_eval(
        lambda *arguments, forms: jax.core.ShapedArray(
            (to := shape(*arguments, forms=forms)).shape, to.dtype
        )
    )
    mlir.register_lowering(primitive, mlir.lower_fun(called_back, multiple_results=False))
    ad.primitive_jvps[primitive] = moved
    if name != "value":
        ad.primitive_transposes[primitive] = pulled_back
    batching.primitive_batchers[primitive] = batched


for _name in NAMES:
    _define(_name)
