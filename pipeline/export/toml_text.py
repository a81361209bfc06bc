"""Settings as TOML: tables of texts, numbers, truth values and lists, which is all that they hold."""

import json
from collections.abc import Mapping
from typing import Any


def toml_text(document: Mapping[str, Any]) -> str:
    """The document as TOML; keys without a value (None) are left out.

    Parameters
    ----------
    document : mapping
        JSON values. Sub-mappings become tables, mappings within those inline tables.
    """
    lines = [f"{key} = {_value(value)}" for key, value in document.items() if not isinstance(value, Mapping | None)]
    for key, value in document.items():
        if isinstance(value, Mapping) and any(entry is not None for entry in value.values()):
            lines += ["", f"[{key}]"]
            lines += [f"{name} = {_value(entry)}" for name, entry in value.items() if entry is not None]
    return "\n".join(lines) + "\n"


def _value(value: Any) -> str:
    if isinstance(value, Mapping):
        inside = ", ".join(f"{key} = {_value(entry)}" for key, entry in value.items() if entry is not None)
        return f"{{ {inside} }}" if inside else "{}"
    if isinstance(value, list | tuple):
        return f"[{', '.join(map(_value, value))}]"
    # Texts, numbers and truth values are written alike in JSON and TOML, but for one control character.
    return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
