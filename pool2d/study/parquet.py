"""Results as a Parquet file, where pyarrow is installed."""

from __future__ import annotations

import csv
import os
from pathlib import Path
from typing import Any

from ..errors import InputError

_KEY = b"pool2d study"
_TEXTS = ("study", "struck", "first", "error", "scenario")
_WHOLE = ("shot", "potted", "off", "events")
_YES_NO = ("scratch", "miscue")


def check(path: Path) -> None:
    """Raises InputError where pyarrow is missing."""
    try:
        import pyarrow  # noqa: F401
    except ImportError:
        allowed = "Parquet needs pyarrow, of the extra parquet; without it allowed is a name that ends in .csv"
        raise InputError(str(path), "", None, allowed) from None


def stamp_of(path: Path) -> str:
    """The name of the study that a Parquet file holds; "" where it is none of ours. Raises InputError."""
    import pyarrow.parquet

    try:
        metadata = pyarrow.parquet.read_schema(path).metadata or {}
    except (OSError, pyarrow.ArrowException) as error:
        raise InputError(str(path), "", None, f"cannot be read as Parquet: {str(error).splitlines()[0]}") from error
    return str(metadata.get(_KEY, b"").decode(errors="replace"))


def write(source: Path, target: Path, stamp: str) -> None:
    """Make a Parquet file of a CSV file of results, some rows at a time, whole or not at all."""
    import pyarrow.csv
    import pyarrow.parquet

    with open(source, encoding="utf-8", newline="") as file:
        names = next(csv.reader(file))
    convert = pyarrow.csv.ConvertOptions(
        column_types={name: _type(pyarrow, name) for name in names}, null_values=[""], strings_can_be_null=False
    )
    draft = target.with_name(f".{target.name}.draft")
    try:
        with pyarrow.csv.open_csv(source, convert_options=convert) as reader:
            schema = reader.schema.with_metadata({_KEY: stamp})
            with pyarrow.parquet.ParquetWriter(draft, schema) as writer:
                for batch in reader:
                    writer.write_batch(batch)
        os.replace(draft, target)
    except OSError as error:
        raise InputError(str(target), "", None, f"cannot be written: {error.strerror or error}") from error
    finally:
        draft.unlink(missing_ok=True)


def _type(arrow: Any, name: str) -> Any:
    """What the values of a column are. Of a ball's columns only what stands behind the last dot tells it."""
    of_ball = name.rpartition(".")[2] if "." in name else ""
    if name in _TEXTS or of_ball == "pocket":
        return arrow.string()
    if name in _YES_NO or of_ball == "off":
        return arrow.bool_()
    return arrow.int64() if name in _WHOLE or of_ball == "cushions" else arrow.float64()
