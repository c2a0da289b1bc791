"""The small changes that can be made to a source, one at a time: `sites` gives them all.

What cannot matter to a user is left alone: docstrings, type hints, texts of errors, `__repr__`, and whether a
comparison of floats counts the boundary in.
"""

from __future__ import annotations

import ast
from typing import NamedTuple

_ARITHMETIC: dict[type[ast.operator], tuple[str, str]] = {
    ast.Add: ("+", "-"), ast.Sub: ("-", "+"), ast.Mult: ("*", "/"), ast.Div: ("/", "*"),
    ast.FloorDiv: ("//", "*"), ast.Mod: ("%", "*"), ast.Pow: ("**", "*"),
}  # fmt: skip
_COMPARISONS: dict[type[ast.cmpop], tuple[str, str]] = {
    ast.Lt: ("<", ">="), ast.LtE: ("<=", ">"), ast.Gt: (">", "<="), ast.GtE: (">=", "<"), ast.Eq: ("==", "!="),
    ast.NotEq: ("!=", "=="), ast.Is: ("is", "is not"), ast.IsNot: ("is not", "is"), ast.In: ("in", "not in"),
    ast.NotIn: ("not in", "in"),
}  # fmt: skip
_BOUNDARIES = {"<": "<=", "<=": "<", ">": ">=", ">=": ">"}
_BUILT_IN = {"min": "max", "max": "min", "any": "all", "all": "any"}
_NAMES = {**_BUILT_IN, "sin": "cos", "cos": "sin", "floor": "ceil", "ceil": "floor"}
_SYMMETRIC = {"min", "max", "hypot", "isinstance", "isclose", "dist", "maximum", "minimum"}
# Arguments that say how carefully or how fast something is done, not what.
_MANNERS = {"strict", "maxsize", "frozen", "slots", "encoding", "parents", "daemon"}
_EMPTY = {"list": "[]", "dict": "{}", "set": "set()"}


class Change(NamedTuple):
    """One difference: from byte `start` to `end` of the source `new` stands for `old`.

    `reach` holds the lines by which to find who executes it; none where that is whoever imports the module.
    """

    line: int
    start: int
    end: int
    old: str
    new: str
    reach: tuple[int, ...]

    def __str__(self) -> str:
        return f"{_short(self.old)}  ->  {_short(self.new)}"

    def made(self, source: bytes) -> bytes | None:
        """The source with the change; None where it still means the same, or nothing."""
        changed = source[: self.start] + self.new.encode() + source[self.end :]
        try:
            return changed if ast.dump(ast.parse(changed)) != ast.dump(ast.parse(source)) else None
        except SyntaxError:
            return None


def _short(text: str) -> str:
    return text if len(text := " ".join(text.split())) <= 70 else f"{text[:67]}..."


def sites(source: bytes) -> list[Change]:
    """Every change, in the order of the source."""
    return sorted(_Walk(source).changes)


class _Walk(ast.NodeVisitor):
    """Gathers the changes of one source."""

    def __init__(self, source: bytes) -> None:
        self.source = source
        self.changes: list[Change] = []
        self._starts = [0]
        for line in source.splitlines(keepends=True):
            self._starts.append(self._starts[-1] + len(line))
        self._functions: list[ast.FunctionDef | ast.AsyncFunctionDef] = []
        self._statement: ast.stmt | None = None
        self.visit(ast.parse(source))

    def visit(self, node: ast.AST) -> None:
        if isinstance(node, ast.stmt):
            if _idle(node):
                return
            self._statement = node
            self._leave_out(node)
        super().visit(node)

    # What is passed over.

    def visit_FunctionDef(self, node: ast.FunctionDef) -> None:
        for default in (*node.args.defaults, *(each for each in node.args.kw_defaults if each)):
            self.visit(default)
        self._functions.append(node)
        for statement in node.body:
            self.visit(statement)
        self._functions.pop()

    def visit_ClassDef(self, node: ast.ClassDef) -> None:
        for statement in node.body:
            self.visit(statement)

    def visit_AnnAssign(self, node: ast.AnnAssign) -> None:
        if node.value:
            self.visit(node.value)

    def visit_Raise(self, node: ast.Raise) -> None:
        pass

    def visit_FormattedValue(self, node: ast.FormattedValue) -> None:
        pass

    def visit_keyword(self, node: ast.keyword) -> None:
        if node.arg not in _MANNERS:
            self.generic_visit(node)

    # What is changed.

    def visit_BinOp(self, node: ast.BinOp) -> None:
        if type(node.op) in _ARITHMETIC:
            self._between(node.left, node.right, *_ARITHMETIC[type(node.op)])
        self.generic_visit(node)

    def visit_AugAssign(self, node: ast.AugAssign) -> None:
        if type(node.op) in _ARITHMETIC:
            old, new = _ARITHMETIC[type(node.op)]
            self._between(node.target, node.value, f"{old}=", f"{new}=")
        self.generic_visit(node)

    def visit_Compare(self, node: ast.Compare) -> None:
        terms = [node.left, *node.comparators]
        for i, operator in enumerate(node.ops):
            old, new = _COMPARISONS[type(operator)]
            self._between(terms[i], terms[i + 1], old, new)
            if old in _BOUNDARIES and any(map(_counts, terms[i : i + 2])):
                self._between(terms[i], terms[i + 1], old, _BOUNDARIES[old])
        self.generic_visit(node)

    def visit_BoolOp(self, node: ast.BoolOp) -> None:
        words = ("and", "or") if isinstance(node.op, ast.And) else ("or", "and")
        for i in range(len(node.values) - 1):
            self._between(node.values[i], node.values[i + 1], *words)
        self.generic_visit(node)

    def visit_UnaryOp(self, node: ast.UnaryOp) -> None:
        if isinstance(node.op, ast.USub | ast.Not):
            self._replace(node, f"({self._text(node.operand)})")
        self.generic_visit(node)

    def visit_Constant(self, node: ast.Constant) -> None:
        value = node.value
        if isinstance(value, bool):
            self._replace(node, repr(not value))
        elif isinstance(value, int):
            self._replace(node, repr(value + 1))
        elif isinstance(value, float):
            self._replace(node, repr(2.0 * value if value else 1.0))

    def visit_Call(self, node: ast.Call) -> None:
        name = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")
        if name in _NAMES and (isinstance(node.func, ast.Attribute) or name in _BUILT_IN):
            end = self._span(node.func)[1]
            self._put(node, end - len(name), end, name, _NAMES[name])
        first = node.args[:2]
        if len(first) == 2 and name not in _SYMMETRIC and not any(isinstance(each, ast.Starred) for each in first):
            (a, b), (c, d) = map(self._span, first)
            old = self.source[a:d].decode()
            self._put(node, a, d, old, self._text(first[1]) + self.source[b:c].decode() + self._text(first[0]))
        self.generic_visit(node)

    def visit_If(self, node: ast.If) -> None:
        self._negate(node.test)
        self.generic_visit(node)

    def visit_IfExp(self, node: ast.IfExp) -> None:
        self._negate(node.test)
        self.generic_visit(node)

    def visit_Return(self, node: ast.Return) -> None:
        """Another value of the type that the function says it returns."""
        hint = self._functions[-1].returns
        said, value = ast.unparse(hint) if hint else "", node.value
        if value and not isinstance(value, ast.Constant):
            if said == "bool":
                self._negate(value)
            elif said in ("int", "float"):
                self._replace(value, f"-({self._text(value)})")
            elif said.endswith("| None"):
                self._replace(value, "None")
            elif (kind := said.partition("[")[0]) in _EMPTY:
                self._replace(value, _EMPTY[kind])
        self.generic_visit(node)

    def _negate(self, condition: ast.expr) -> None:
        # A comparison is turned about by itself.
        if not isinstance(condition, ast.Compare):
            self._replace(condition, f"not ({self._text(condition)})")

    def _leave_out(self, node: ast.stmt) -> None:
        """A statement that does something is not done."""
        begun = bool(self._functions) and self._functions[-1].name == "__init__"
        target = node.targets[0] if isinstance(node, ast.Assign) else None
        done = (
            isinstance(node, ast.AugAssign | ast.Break | ast.Continue | ast.Raise)
            or (isinstance(node, ast.Expr) and isinstance(node.value, ast.Call))
            or (isinstance(target, ast.Attribute | ast.Subscript) and not begun)
            or (isinstance(node, ast.Return) and node.value is None)
        )
        if done:
            self._replace(node, "pass")

    # How.

    def _span(self, node: ast.expr | ast.stmt) -> tuple[int, int]:
        assert node.end_lineno is not None and node.end_col_offset is not None
        return self._starts[node.lineno - 1] + node.col_offset, self._starts[node.end_lineno - 1] + node.end_col_offset

    def _text(self, node: ast.expr) -> str:
        start, end = self._span(node)
        return self.source[start:end].decode()

    def _replace(self, node: ast.expr | ast.stmt, new: str) -> None:
        start, end = self._span(node)
        self._put(node, start, end, self.source[start:end].decode(), new)

    def _between(self, left: ast.expr, right: ast.expr, old: str, new: str) -> None:
        """Replace the operator between two terms."""
        start, end = self._span(left)[1], self._span(right)[0]
        between = self.source[start:end].decode()
        if between.strip(" \n()") == old:
            a, b = self._span(left)[0], self._span(right)[1]
            whole = self.source[a:b].decode()
            at = len(self.source[a:start].decode()) + between.index(old)
            self._put(left, a, b, whole, whole[:at] + new + whole[at + len(old) :])

    def _put(self, node: ast.expr | ast.stmt, start: int, end: int, old: str, new: str) -> None:
        reach = (node.lineno, self._statement.lineno) if self._functions and self._statement else ()
        self.changes.append(Change(node.lineno, start, end, old, new, reach))


def _counts(node: ast.expr) -> bool:
    """Whether a term is certainly a whole number, so that the boundary matters."""
    if isinstance(node, ast.Call):
        return isinstance(node.func, ast.Name) and node.func.id == "len"
    return isinstance(node, ast.Constant) and type(node.value) is int


def _idle(node: ast.stmt) -> bool:
    """Whether a statement does nothing that a user could notice."""
    if isinstance(node, ast.FunctionDef):
        return node.name in ("__repr__", "__hash__")
    if isinstance(node, ast.If):
        return ast.unparse(node.test) in ("TYPE_CHECKING", "__name__ == '__main__'")
    if isinstance(node, ast.Assign):
        return ast.unparse(node.targets[0]) in ("__slots__", "__all__")
    return isinstance(node, ast.Assert | ast.Import | ast.ImportFrom)
