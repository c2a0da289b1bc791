"""The page of the public names, from their docstrings: `python -m docs.api` writes `docs/api.md`.

griffe2md renders it, of the optional extra "docs". Whether the page is out of date is seen without it: the first line
holds digests of what the page is made of and of the page itself.
"""

from __future__ import annotations

import ast
import hashlib
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[1]
PAGE = Path(__file__).with_name("api.md")
PACKAGES = ("pool2d", "pool2d.game", "pool2d.opponent")
TITLE = "# The public names"
INTRODUCTION = """What `pool2d`, `pool2d.game` and `pool2d.opponent` export, made of the docstrings by
`python -m docs.api`, which needs the extra "docs": `pip install -e '.[docs]'`. The examples run as tests. Lengths are
in m, times in s, velocities in m/s, spins in rad/s, masses in kg; the angles of a shot are in degrees."""
ATTRIBUTE = re.compile(r"^- \[\*\*(\w+)\*\*\]\(#.*?\)(?: \(<code>.*</code>\))? \N{EN DASH} ", re.MULTILINE)
# What of a definition the page tells: signatures and docstrings, in the order of the source.
CONFIG: Any = {
    "filters": ["!^_"],
    "heading_level": 3,
    "members_order": "source",
    "merge_init_into_class": True,
    "show_bases": False,
    "show_if_no_docstring": False,
    "show_object_full_path": False,
    "show_root_full_path": False,
    "show_root_members_full_path": False,
    "show_signature_annotations": True,
    "signature_crossrefs": False,
    "summary": False,
}


def source_of(module: str) -> str:
    """The text of a module or package."""
    path = ROOT.joinpath(*module.split("."))
    file = path / "__init__.py" if path.is_dir() else path.with_suffix(".py")
    return file.read_text(encoding="utf-8")


def homes(package: str) -> dict[str, str]:
    """The module that defines each public name of a package, by name, from what is imported for type checkers."""
    blocks = [node.body for node in ast.parse(source_of(package)).body if isinstance(node, ast.If)]
    imports = [node for block in blocks for node in block if isinstance(node, ast.ImportFrom)]
    found = {alias.name: f"{package}.{node.module}" for node in imports for alias in node.names}
    return {name: found[name] for name in sorted(found, key=str.lower)}


def told(source: str, name: str) -> Iterator[str]:
    """What the page tells of a name that a module defines: signatures, fields and docstrings."""
    body = ast.parse(source).body
    for node, after in zip(body, [*body[1:], None], strict=True):
        if isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name) and node.target.id == name:
            yield ast.unparse(node.target)
            yield ast.unparse(after) if isinstance(after, ast.Expr) else ""
        elif isinstance(node, (ast.ClassDef, ast.FunctionDef)) and node.name == name:
            yield from _definition(node, source)


def _definition(node: ast.ClassDef | ast.FunctionDef, source: str) -> Iterator[str]:
    head = source.splitlines()[node.lineno - 1 : node.body[0].lineno - 1]
    yield " ".join(" ".join(head).split())
    yield ast.get_docstring(node) or ""
    for inner in node.body if isinstance(node, ast.ClassDef) else ():
        if isinstance(inner, ast.FunctionDef) and (inner.name == "__init__" or not inner.name.startswith("_")):
            yield from _definition(inner, source)
        elif isinstance(inner, ast.AnnAssign):
            yield ast.get_source_segment(source, inner) or ""


def digest(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def digest_of_sources() -> str:
    """A digest of all that the page is made of."""
    lines = [TITLE, INTRODUCTION]
    for package in PACKAGES:
        for name, module in homes(package).items():
            lines += [package, name, *told(source_of(module), name)]
    return digest("\n".join(lines))


def is_stale(page: str) -> bool:
    """Whether a page is not what the sources make today, or was changed by hand."""
    head, _, body = page.partition("\n")
    return head != _head(body)


def _head(body: str) -> str:
    return f"<!-- Made by `python -m docs.api` of {digest_of_sources()}; all below is {digest(body)}. -->"


def render() -> str:
    """The whole page; raises ImportError without griffe2md."""
    import griffe
    import griffe2md

    loader = griffe.GriffeLoader(search_paths=[ROOT], docstring_parser="google")
    loader.load("pool2d", submodules=True)
    loader.resolve_aliases(implicit=True)
    parts = ["", TITLE, INTRODUCTION]
    for package in PACKAGES:
        names = homes(package)
        parts += [f"## `{package}`", ", ".join(f"[`{name}`](#{anchor(package, name)})" for name in names)]
        for name, module in names.items():
            item = _readable(loader.modules_collection[f"{module}.{name}"])
            # Types stand in the signature; links to them would lead nowhere on this page.
            text = ATTRIBUTE.sub(r"- `\1`: ", griffe2md.render_object_docs(item, CONFIG))
            parts += [f'<a id="{anchor(package, name)}"></a>', text.strip()]
    body = re.sub(r"\n{3,}", "\n\n", "\n\n".join(parts).lstrip("\n")) + "\n"
    body = "\n".join(line.rstrip() for line in body.split("\n"))
    return _head(body) + "\n" + body


def _readable(item: Any) -> Any:
    """The definition without a table's content, and with the signature that a NamedTuple gets from its fields."""
    import griffe

    if item.is_attribute:
        item.value = None
    elif item.is_class and "NamedTuple" in map(str, item.bases):
        kind = griffe.ParameterKind.positional_or_keyword
        fields = [field for field in item.attributes.values() if field.annotation]
        parameters = [
            griffe.Parameter(field.name, annotation=field.annotation, default=field.value, kind=kind)
            for field in fields
        ]
        own = griffe.Parameter("self", kind=kind)
        item.set_member("__init__", griffe.Function("__init__", parameters=griffe.Parameters(own, *parameters)))
    return item


def anchor(package: str, name: str) -> str:
    return f"{package}.{name}"


if __name__ == "__main__":
    PAGE.write_text(render(), encoding="utf-8")
