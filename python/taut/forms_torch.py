# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""The five functions of forms.py as functions of torch.autograd."""

from typing import Any

import torch

from taut.forms import ALONG, NAMES, NO_THIRD, Forms, transposed

__all__ = ["FUNCTIONS", "torch"]

FUNCTIONS: dict[str, Any] = {}


class NoThird(torch.autograd.Function):
    """The lengths of a second derivative. A derivative by them raises, and only where it is asked
    for: backward() of the second derivative itself is also called for that of a cotangent."""

    generate_vmap_rule = True

    @staticmethod
    def forward(lengths: Any) -> Any:
        return lengths.clone()

    @staticmethod
    def setup_context(context: Any, inputs: Any, output: Any) -> None:
        pass

    @staticmethod
    def backward(context: Any, cotangent: Any) -> Any:
        raise NotImplementedError(NO_THIRD)

    @staticmethod
    def jvp(context: Any, tangent: Any) -> Any:
        raise NotImplementedError(NO_THIRD)


def _apply(name: str, forms: Forms, lengths: Any, *linear: Any) -> Any:
    if name not in ALONG:
        lengths = NoThird.apply(lengths)
    return FUNCTIONS[name].apply(forms, lengths, *linear)


def _define(name: str) -> None:
    class Function(torch.autograd.Function):
        @staticmethod
        def forward(forms: Forms, *arguments: Any) -> Any:
            lengths = arguments[0]
            result = forms.each(name, *(one.detach().cpu().double().numpy() for one in arguments))
            return torch.as_tensor(result, dtype=lengths.dtype, device=lengths.device)

        @staticmethod
        def setup_context(context: Any, inputs: Any, output: Any) -> None:  # noqa: ARG004 - its name is given
            context.forms, *arguments = inputs
            context.save_for_backward(*arguments)
            context.save_for_forward(*arguments)
            context.set_materialize_grads(False)

        @staticmethod
        def backward(context: Any, cotangent: Any) -> Any:
            lengths, *linear = context.saved_tensors
            _, of_lengths, *wanted = context.needs_input_grad
            results: list[Any] = [None] * (2 + len(linear))
            if cotangent is None:
                return tuple(results)
            if of_lengths and name not in ALONG:
                results[1] = torch.zeros_like(lengths)  # for NoThird
            elif of_lengths:
                other, arguments = transposed(ALONG[name], len(linear), cotangent, linear)
                results[1] = _apply(other, context.forms, lengths, *arguments)
            for i, is_wanted in enumerate(wanted):
                if is_wanted:
                    other, arguments = transposed(name, i, cotangent, linear)
                    results[2 + i] = _apply(other, context.forms, lengths, *arguments)
            return tuple(results)

        @staticmethod
        def jvp(context: Any, _: Any, of_lengths: Any, *tangents: Any) -> Any:
            lengths, *linear = context.saved_tensors
            terms = [
                _apply(name, context.forms, lengths, *linear[:i], tangent, *linear[i + 1 :])
                for i, tangent in enumerate(tangents)
                if tangent is not None
            ]
            if of_lengths is not None:
                terms.append(_apply(ALONG[name], context.forms, lengths, *linear, of_lengths))
            return sum(terms[1:], terms[0]) if terms else None

        @staticmethod
        def vmap(info: Any, axes: Any, forms: Forms, *arguments: Any) -> tuple[Any, int]:
            same = [
                one.expand(info.batch_size, *one.shape) if axis is None else one.movedim(axis, 0)
                for one, axis in zip(arguments, axes[1:])
            ]
            return _apply(name, forms, *same), 0

    FUNCTIONS[name] = Function


for _name in NAMES:
    _define(_name)
