"""`pool2d fit SHOTS`: a preset that names its evidence, pictures, and what is said where that cannot be."""

from __future__ import annotations

import sys
from pathlib import Path

import pygame
import pytest

from pool2d import load_table
from pool2d.cli import main
from pool2d.fit.knob_fit import KnobFit
from pool2d.fit.made_tracks import to_csv
from pool2d.fit.tracked_fit import TrackedFit

from ..fit.known_shots import TABLE, alone
from .cli_runs import Capture, refusal

KNOBS = ("--knobs", "cushion.restitution", "--workers", "1", "--size", "320x180")


@pytest.fixture(scope="module")
def text() -> str:
    """The tracks of four shots."""
    return to_csv(one.seen.shot for one in alone(TABLE.with_knobs({"cushion.restitution": 0.85}), 4))


@pytest.fixture
def tracks(tmp_path: Path, text: str) -> str:
    path = tmp_path / "shots.csv"
    path.write_text(text)
    return str(path)


def test_a_preset_comes_out_with_its_evidence_and_pictures(tracks: str, tmp_path: Path, capsys: Capture) -> None:
    assert main(["fit", tracks, *KNOBS]) == 0
    told = capsys.readouterr()
    assert told.err == ""
    lines = told.out.splitlines()
    assert [line.split()[:3] for line in lines[1:5]] == [
        ["0", "fitted", lines[1].split()[2]],
        ["1", "held", "back"],
        ["2", "fitted", lines[3].split()[2]],
        ["3", "held", "back"],
    ]
    assert lines[6].startswith("cushion.restitution") and " +- " in lines[6]
    assert lines[7].startswith("2 shots fitted: median error 0.05")
    assert lines[8].startswith("2 shots held back: median error 0.05") and "before" in lines[8]
    preset = tmp_path / "shots-fitted.toml"
    assert load_table(preset).knobs.cushion.restitution == pytest.approx(0.85, abs=0.003)
    said = preset.read_text()
    assert "# Fitted to 2 of 4 tracked shots on 20" in said
    assert "--knobs cushion.restitution" in said
    assert "# 2 shots held back: median error" in said
    assert f"was {TABLE.knobs.cushion.restitution:g}" in said
    for what in ("median", "worst"):
        assert pygame.image.load(tmp_path / f"shots-fitted-{what}.png").get_size() == (320, 180)


def test_a_preset_of_ones_own_is_known_by_its_name(
    tracks: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Capture
) -> None:
    monkeypatch.setenv("POOL2D_DATA", str(tmp_path / "data"))
    assert main(["fit", tracks, *KNOBS, "--out", "mine", "--set", "cloth.mu_roll=0.0044"]) == 0
    table = load_table("mine")
    assert table.title == "Carom, 10 ft, fitted"
    assert table.knobs.cloth.mu_roll == 0.0044
    assert (tmp_path / "mine-worst.png").exists()
    assert "--table mine" in capsys.readouterr().out


def test_ctrl_c_keeps_what_there_is(
    tracks: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Capture
) -> None:
    real = KnobFit.run

    def broken(self: KnobFit) -> None:
        def stop(stage: int) -> None:
            raise KeyboardInterrupt

        real(self, stop)

    monkeypatch.setattr(KnobFit, "run", broken)
    assert main(["fit", tracks, *KNOBS]) == 130
    told = capsys.readouterr()
    assert "interrupted; the best so far is kept" in told.err
    preset = tmp_path / "shots-fitted.toml"
    assert load_table(preset).knobs.cushion.restitution == pytest.approx(0.85, abs=0.01)
    assert "Interrupted" in preset.read_text()


def test_ctrl_c_at_the_start_writes_nothing(
    tracks: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Capture
) -> None:
    def stop(*arguments: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(TrackedFit, "run", stop)
    assert main(["fit", tracks, *KNOBS]) == 130
    assert capsys.readouterr().err == "pool2d: interrupted before any knob was turned; nothing is written\n"
    assert [path.name for path in tmp_path.iterdir()] == ["shots.csv"]


def test_shots_that_cannot_be_fitted_are_told(
    tracks: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Capture
) -> None:
    with open(tracks, "a") as file:
        file.write("still,0,cue,1,1\nstill,1,cue,1,1\n")
        file.writelines(f"away,{i / 50},cue,{9 + i / 50},1\n" for i in range(9))
    monkeypatch.setattr(TrackedFit, "run", lambda *arguments: (_ for _ in ()).throw(KeyboardInterrupt))
    assert main(["fit", tracks, *KNOBS]) == 130
    told = capsys.readouterr().err.splitlines()
    assert told[0].endswith("shots.csv: shot still is left out: no ball moves")
    assert told[1].endswith("shots.csv: shot away is left out: a ball stands where none can")


def test_without_scipy_it_says_what_to_install(tracks: str, monkeypatch: pytest.MonkeyPatch, capsys: Capture) -> None:
    monkeypatch.setitem(sys.modules, "scipy", None)
    assert (
        refusal(capsys, "fit", tracks) == "pool2d: pool2d fit: needs scipy, of the extra fit: pip install 'pool2d[fit]'"
    )


@pytest.mark.parametrize(
    ("words", "told"),
    [
        ((), "needed are SHOTS"),
        (("SHOTS", "--knobs", "cloth.mu_rol"), "--knobs = 'cloth.mu_rol': unknown; did you mean cloth.mu_roll?"),
        (("SHOTS", "--noise", "0"), "--noise = 0.0: allowed is a number from 0.01 to 100 mm"),
        (("SHOTS", "--out", "none/a.toml"), "there is no such folder"),
        (("SHOTS", "--out", "a/b"), "allowed is a plain file name"),
        (("SHOTS", "--out", "carom-10ft"), "allowed is another name than a shipped preset's"),
        (("SHOTS", "--workers", "0"), "--workers = 0.0: allowed is a number from 1 to 60 processes"),
        (("SHOTS", "--table", "caram-10ft"), "did you mean carom-10ft?"),
        (("SHOTS", "--make", "b.csv"), "do not go together"),
        (("none.csv",), "none.csv: cannot be read"),
        (("--make", "made.txt"), "ends in .csv"),
        (("--make", "made.csv", "--count", "0"), "--count = 0.0: allowed is a number from 1 to 1000 shots"),
    ],
)
def test_what_cannot_be_is_told(
    words: tuple[str, ...], told: str, tracks: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Capture
) -> None:
    monkeypatch.chdir(tmp_path)
    assert told in refusal(capsys, "fit", *(tracks if word == "SHOTS" else word for word in words))


def test_shots_are_made_and_read_again(tmp_path: Path, capsys: Capture) -> None:
    path = tmp_path / "made.csv"
    assert main(["fit", "--make", str(path), "--count", "2", "--table", "pool-9ft", "--seed", "3"]) == 0
    assert capsys.readouterr().out == f"{path}: 2 shots made on pool-9ft\n"
    assert path.read_text().startswith("shot,time,ball,x,y\n1,0.0000,cue,")
    assert "is there already" in refusal(capsys, "fit", "--make", str(path))
