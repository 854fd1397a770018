"""scikit-build-core, told the licence of what it builds: GSL, where it is asked for, is under the GPL."""
from __future__ import annotations

import os
from typing import Any, Optional

import scikit_build_core.build as build
from scikit_build_core.build import (build_editable, build_sdist, get_requires_for_build_editable,  # noqa: F401
                                     get_requires_for_build_sdist, get_requires_for_build_wheel)

Settings = Optional[dict[str, Any]]


def _note_licence(settings: Settings) -> None:
    chosen = [value for key, value in (settings or {}).items() if key.endswith("cmake.define.KYVADLO_WITH_GSL")]
    with_gsl = bool(chosen) and str(chosen[-1]).upper() in ("ON", "1", "TRUE", "YES")
    os.environ["KYVADLO_LICENCE"] = "MIT AND GPL-3.0-or-later" if with_gsl else "MIT"


def dynamic_metadata(field: str, settings: Optional[dict[str, Any]] = None, *_: Any) -> str:
    """Says the licence to scikit-build-core (tool.scikit-build.metadata)."""
    assert field == "license"
    return os.environ.get("KYVADLO_LICENCE", "MIT")


def prepare_metadata_for_build_wheel(directory: str, settings: Settings = None) -> str:
    _note_licence(settings)
    return build.prepare_metadata_for_build_wheel(directory, settings)


def build_wheel(directory: str, settings: Settings = None, metadata: Optional[str] = None) -> str:
    _note_licence(settings)
    return build.build_wheel(directory, settings, metadata)
