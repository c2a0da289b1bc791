"""A table as plain data, from which it is built again."""

from __future__ import annotations

import json

import pytest

from pool2d import InputError, load_table
from pool2d.table.preset import presets
from pool2d.table.table_data import as_data, table_of

# The table.


@pytest.mark.parametrize("name", presets())
def test_a_table_comes_back_from_its_data(name: str) -> None:
    table = load_table(name, {"cloth.mu_roll": 0.0123, "ball.law": "frictionless"}, ["worn-cloth"])
    back = table_of(json.loads(json.dumps(as_data(table))), "record")
    assert (back.source, back.title, back.set, back.conditions) == (
        table.source,
        table.title,
        table.set,
        ("worn-cloth",),
    )
    assert (back.knobs, back.base) == (table.knobs, table.base)
    assert back.furniture == table.furniture
    # Racks and groups are also drawn from in their order.
    assert list(back.furniture.racks) == list(table.furniture.racks)
    assert list(back.furniture.groups) == list(table.furniture.groups)
    assert back.boxes() == table.boxes() and back.geometry.outline == table.geometry.outline
    assert as_data(back) == as_data(table)


@pytest.mark.parametrize(
    "change",
    [
        {"title": "a\nb"}, {"title": 3}, {"knobs": {"cloth.mu_roll": "x"}}, {"knobs": {"x": 1}}, {"knobs": None},
        {"furniture": {"spots": {}}}, {"furniture": []}, {"furniture": {"outline": [{"x": 0.0, "y": 0.0}]}},
        {"set": {"cloth.mu_roll": 9e9}}, {"conditions": "worn"},
    ],
)  # fmt: skip
def test_the_data_of_no_table_is_refused(change: dict[str, object]) -> None:
    with pytest.raises(InputError, match=r"^record: "):
        table_of({**as_data(load_table("pool-7ft")), **change}, "record")
