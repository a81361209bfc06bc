"""Options that belong together, as the fields of a dataclass."""

import inspect
from collections.abc import Callable
from dataclasses import fields, is_dataclass
from functools import wraps
from typing import Any


def with_options(command: Callable[..., None]) -> Callable[..., None]:
    """A command that typer gives the fields of its dataclass parameters, each as an option of its own.

    The fields carry `typer.Option` in their annotations, as parameters of a command do.
    """
    signature = inspect.signature(command, eval_str=True)
    groups: dict[str, Any] = {
        name: parameter.annotation
        for name, parameter in signature.parameters.items()
        if is_dataclass(parameter.annotation)
    }
    parameters: list[inspect.Parameter] = []
    for name, parameter in signature.parameters.items():
        parameters += (
            inspect.signature(groups[name], eval_str=True).parameters.values() if name in groups else [parameter]
        )

    @wraps(command)
    def from_options(**values: Any) -> None:
        for name, group in groups.items():
            values[name] = group(**{field.name: values.pop(field.name) for field in fields(group)})
        command(**values)

    keyword_only = [parameter.replace(kind=inspect.Parameter.KEYWORD_ONLY) for parameter in parameters]
    from_options.__signature__ = signature.replace(parameters=keyword_only)  # type: ignore[attr-defined]
    from_options.__annotations__ = {parameter.name: parameter.annotation for parameter in parameters}
    return from_options
