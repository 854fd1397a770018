"""What doc/python.md and the notebook show runs, and draws the pictures that are shown; docstrings and types are right."""
import doctest
import json
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import kyvadlo.functions
import kyvadlo.orbit
import kyvadlo.scenes

TOP = Path(__file__).resolve().parents[2]
PAGE = TOP/"doc"/"python.md"
BLOCKS = re.findall(r"^```python\n(.*?)^```$", PAGE.read_text(encoding="utf-8"), re.M | re.S) if PAGE.exists() else []
pyplot = pytest.importorskip("matplotlib.pyplot")
pyplot.switch_backend("agg")


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    yield
    pyplot.close("all")


@pytest.mark.skipif(not BLOCKS, reason="only a clone has the page")
def test_the_page_has_a_first_picture_in_six_lines_and_a_gallery_of_five():
    assert len(BLOCKS[0].splitlines()) + 1 <= 6 and "savefig" in BLOCKS[0]   # with the line of pip
    gallery = [block for block in BLOCKS[1:] if "savefig" in block]
    assert len(gallery) == 5 and all(len(block.splitlines()) <= 15 for block in gallery)


@pytest.mark.parametrize("block", BLOCKS)
def test_block_of_the_page(block, tmp_path):
    exec(compile(block, "doc/python.md", "exec"), {})
    drawn = list(tmp_path.glob("*.png"))
    assert len(drawn) == block.count("savefig")
    for picture in drawn:
        stored = TOP/"doc"/"pictures"/f"python_{picture.name.replace('python_', '')}"
        ours, theirs = pyplot.imread(stored), pyplot.imread(picture)
        assert abs(np.array(ours.shape[:2])/theirs.shape[:2] - 1).max() < 0.05
        # Fonts and lines differ from one matplotlib to another: shares of the ink in 8 by 8 fields.
        assert np.abs(ink(ours) - ink(theirs)).max() < 0.05, picture.name


def ink(picture):
    dark = 1 - picture[..., :3].mean(axis=2)
    return np.array([[field.mean() for field in np.array_split(row, 8, axis=1)] for row in np.array_split(dark, 8)])


@pytest.mark.skipif(not BLOCKS, reason="only a clone has the notebook")
def test_the_notebook_runs():
    notebook = json.loads((TOP/"examples"/"python"/"tour.ipynb").read_text(encoding="utf-8"))
    cells = ["".join(cell["source"]) for cell in notebook["cells"] if cell["cell_type"] == "code"]
    assert len(cells) >= 4 and not any(cell.get("outputs") for cell in notebook["cells"])
    space = {}
    for cell in cells:
        exec(compile(cell, "tour.ipynb", "exec"), space)


@pytest.mark.parametrize("module", [kyvadlo.functions, kyvadlo.orbit, kyvadlo.scenes])
def test_examples_of_docstrings(module):
    texts = {name: getattr(module, name).__doc__ for name in kyvadlo.functions.__all__} if module is kyvadlo.functions else {}
    module.__test__ = texts
    tried = doctest.testmod(module)
    assert tried.failed == 0 and tried.attempted > 4 + len(texts)


def test_types():
    pytest.importorskip("mypy")
    Path("use.py").write_text("import kyvadlo\norbit: kyvadlo.Orbit = kyvadlo.Orbit.from_heights(1.0, 9.8, 0.3, -0.8)\n"
                              "period: float = orbit.period\nkyvadlo.ellipk([0.1, 0.2])\nwrong: str = orbit.period\n")
    for what, expected in ((["-p", "kyvadlo"], "Success"), (["use.py"], r"use.py:5: error: .*\nFound 1 error")):
        checked = subprocess.run([sys.executable, "-m", "mypy", "--strict", *what], capture_output=True, text=True, check=False)
        assert re.match(expected, checked.stdout), checked.stdout
