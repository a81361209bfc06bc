"""Where a variable of a Python kernel must be declared in a language with block scope, and what never changes."""

import ast
from collections import Counter


def assigned(function: ast.FunctionDef) -> Counter[str]:
    """How often each local name is assigned, loop variables included."""
    return Counter(
        node.id for node in ast.walk(function) if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store)
    )


def declarations(function: ast.FunctionDef) -> dict[int, list[str]]:
    """Names that come into being at a statement (by its `id`): the first of the innermost block that holds them all.

    Loop variables are left out: a loop declares its own.
    """
    loops = {
        node.target.id for node in ast.walk(function) if isinstance(node, ast.For) and isinstance(node.target, ast.Name)
    }
    found: dict[int, list[str]] = {}
    for name in [name for name in assigned(function) if name not in loops]:
        found.setdefault(id(_first(function.body, name)), []).append(name)
    return found


def mentions(node: ast.AST, name: str) -> bool:
    """Whether the name occurs."""
    return any(isinstance(each, ast.Name) and each.id == name for each in ast.walk(node))


def _first(block: list[ast.stmt], name: str) -> ast.stmt:
    inside = [statement for statement in block if mentions(statement, name)]
    if len(inside) == 1 and isinstance(inside[0], ast.For | ast.If):
        only = inside[0]
        header = only.iter if isinstance(only, ast.For) else only.test
        own = isinstance(only, ast.For) and mentions(only.target, name)
        blocks = [body for body in (only.body, only.orelse) if any(mentions(each, name) for each in body)]
        if not own and not mentions(header, name) and len(blocks) == 1:
            return _first(blocks[0], name)
    return inside[0]
