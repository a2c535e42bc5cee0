# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Guards against a recipe for conda that ages: another version, a dependency too few or too many,
another lowest version than CMake and pip ask for. Where py-rattler-build is installed, it is
rendered."""

import re
from pathlib import Path

import pytest

yaml = pytest.importorskip("yaml")
tomllib = pytest.importorskip("tomllib")

ROOT = Path(__file__).parents[2]
RECIPE = ROOT / "packaging" / "conda" / "recipe.yaml"

# What CMake looks for, by the names of conda-forge. None: another part of the recipe, or tests.
CONDA = {
    "BLAS": "libblas",
    "Boost": "libboost-headers",
    "CLI11": "cli11",
    "Eigen3": "eigen",
    "FastFloat": "fast_float",
    "GTest": None,
    "LAPACK": "liblapack",
    "MPI": None,
    "NLopt": "nlopt",
    "PkgConfig": None,
    "TBB": "tbb-devel",
    "benchmark": None,
    "fmt": "fmt",
    "hdf5": "hdf5",
    "metis.h": "metis",
    "minizip": "minizip",
    "nlohmann_json": "nlohmann_json",
    "pugixml": "pugixml",
    "rapidcheck": None,
    "valijson/validator.hpp": "valijson",
}

# What is there for the work of pip, and has no lowest version.
TOOLS = {"pip": "", "python": ""}


@pytest.fixture
def recipe():
    return yaml.safe_load(RECIPE.read_text(encoding="utf-8"))


@pytest.fixture
def project():
    return tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))


def bounds(requirements):
    """Lowest versions by package of 'name', 'name >=version' and 'name * build'."""
    found = {}
    for one in requirements:
        name, least = re.fullmatch(r"([\w-]+)\s*(?:>=([\d.]+)|\* \*\w+)?", one).groups("")
        found[name] = least
    return found


def required_by_cmake():
    texts = [(ROOT / "cmake" / f"{name}.cmake").read_text() for name in ("dependencies", "metis")]
    text = re.sub(r"#.*", "", "\n".join(texts))
    found = {}
    for name, least in re.findall(r"find_package\((\w+)(?: ([\d.]+))?", text):
        found.setdefault(name, least)  # the first: Eigen is looked for by two
    found |= dict.fromkeys(re.findall(r"pkg_check_modules\(\w+ REQUIRED \w+ (\w+)\)", text), "")
    return found | dict.fromkeys(re.findall(r"find_path\(\w+ ([\w./]+)", text), "")


def test_the_version_is_cmakes(recipe):
    version = re.search(r"project\(taut VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())
    assert recipe["context"]["version"] == version[1]


def test_the_libraries_are_those_that_cmake_looks_for(recipe, project):
    required = {CONDA[name]: least for name, least in required_by_cmake().items() if CONDA[name]}
    required |= bounds(project["build-system"]["requires"]) | TOOLS
    assert bounds(recipe["requirements"]["host"]) == required


def test_python_and_cmake_are_those_of_pip(recipe, project):
    run = bounds(recipe["requirements"]["run"])
    ours = [*project["project"]["dependencies"], "python " + project["project"]["requires-python"]]
    assert run == bounds(ours) | {"libblas": ""}
    override = project["tool"]["scikit-build"]["overrides"][0]["cmake"]["version"]
    assert "cmake " + override in recipe["requirements"]["build"]


def test_options_of_the_build_are_there(recipe):
    options = re.findall(r"-C cmake\.define\.(TAUT_\w+)", recipe["build"]["script"][0])
    text = (ROOT / "cmake" / "options.cmake").read_text()
    assert options
    assert not [one for one in options if one not in text]


def test_the_recipe_is_rendered_for_conda():
    rattler = pytest.importorskip("rattler_build", reason="py-rattler-build is not installed")
    compilers = {"cxx_compiler": ["gxx"], "rust_compiler": ["rust"]}
    variants = {"python": ["3.12"], "c_stdlib": ["sysroot"], "c_stdlib_version": ["2.28"]}
    platform = rattler.PlatformConfig(target_platform="linux-64")
    (rendered,) = rattler.Stage0Recipe.from_file(RECIPE).render(
        rattler.VariantConfig(variants | compilers), rattler.RenderConfig(platform=platform)
    )
    assert rendered.recipe.package.name == "taut"
