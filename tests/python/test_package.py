# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Guards against a package that stalls, leaks, crashes or cannot be stopped."""

import builtins
import contextlib
import gc
import inspect
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import numpy as np
import pytest
import taut
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st


def test_the_version_is_the_programs():
    program = shutil.which("taut", path=Path(sys.executable).parent)
    assert program, "the program comes with the package"
    said = subprocess.run([program, "--version"], capture_output=True, text=True, check=True)
    assert taut.__version__ in said.stdout


def test_the_page_for_browsers_is_written_or_missed_in_words(tmp_path):
    try:
        page = taut.app()
    except FileNotFoundError as error:
        missing = str(error)
    else:
        missing = ""
        written = taut.app(tmp_path / "page.html")
        assert written.read_bytes() == page.read_bytes()
        assert b"<title>taut</title>" in written.read_bytes()
        with pytest.raises(OSError, match="own page"):
            taut.app(page)
    assert not missing or "make app" in missing


def test_importing_brings_nothing_but_numpy():
    code = "import sys, taut; print([m for m in sys.modules])"
    said = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    for module in ("pandas", "sklearn", "matplotlib", "compas", "jax", "torch", "scipy"):
        assert f"'{module}'" not in said.stdout


@pytest.mark.parametrize(("module", "package"), [("plot", "matplotlib"), ("gp", "sklearn")])
def test_a_module_without_its_package_says_what_to_install(module, package):
    code = f"import sys, taut; sys.modules['{package}'] = None; taut.{module}"
    said = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    last = said.stderr.splitlines()[-1]
    assert last.startswith(f"ImportError: taut.{module} needs ")
    assert last.endswith(f": pip install 'taut[{module}]'")


def test_all_names_are_there_and_documented():
    for name in taut.__all__:
        public = getattr(taut, name)
        assert public.__doc__ or not callable(public), name
    for of in (taut.Identification, taut.Plan, taut.PredictedPrecision):
        for name in [name for name in dir(of) if not name.startswith("_")]:
            assert getattr(of, name).__doc__, f"{of.__name__}.{name}"


def test_stubs_declare_all_names():
    stub = (Path(taut.__file__).parent / "_taut.pyi").read_text()
    declared = set(re.findall(r"^(?:class|def) (\w+)", stub, re.MULTILINE))
    missing = {
        name
        for name in dir(taut._taut)
        if not name.startswith("__") and callable(getattr(taut._taut, name))
    } - declared
    assert not missing
    assert (Path(taut.__file__).parent / "py.typed").exists()


def test_a_type_checker_takes_the_stubs_and_finds_a_wrong_argument(tmp_path):
    pytest.importorskip("mypy")
    program = tmp_path / "program.py"
    program.write_text(
        "import taut\n"
        "net = taut.CableNet.load('net.json')\n"
        "survey = taut.read_survey(net, net.nodes, noise='1mm')\n"
        "found = taut.identify(net, survey, prior='uniform:2mm')\n"
        "print(found.findings[0]['kind'], found.length_deviation.max())\n"
        "print(found.to_dataframe()['length_deviation'].max())\n"
        "form, pullback = taut.gradients.form_vjp(net, net.unstressed_lengths)\n"
        "limits = {'ridge': (2e3, 5e3)}\n"
        "taut.plan(found, tension=limits, stroke={3: (-0.01, 0.005)})\n"
        "print(pullback(form).sum(), taut.gp.MultiOutputGP().fit(form, form).n_iter_)\n"
        "plan: taut.Plan = taut.plan(net)\n"
    )
    of_package = Path(__file__).parents[2] / "pyproject.toml"
    mypy = [sys.executable, "-m", "mypy", "--no-error-summary"]
    for command, expected in [
        ([*mypy, "--strict", program], ["program.py:11"]),
        ([*mypy, "--config-file", of_package, "-p", "taut"], []),
    ]:
        said = subprocess.run(command, capture_output=True, text=True, check=False, cwd=tmp_path)
        errors = [line for line in said.stdout.splitlines() if ": error:" in line]
        assert [line.split(": error:")[0] for line in errors] == expected, said.stdout + said.stderr


def test_all_public_types_are_known_to_pyright():
    pytest.importorskip("pyright")
    command = [sys.executable, "-m", "pyright", "--verifytypes", "taut"]
    command += ["--ignoreexternal", "--outputjson"]
    path = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    said = subprocess.run(
        command, capture_output=True, text=True, check=False, env=os.environ | {"PATH": path}
    )
    assert said.stdout, said.stderr
    symbols = json.loads(said.stdout)["typeCompleteness"]["symbols"]
    unknown = [one["name"] for one in symbols if one["isExported"] and not one["isTypeKnown"]]
    assert len(symbols) > 100
    # These derive from classes of packages that have no types, or are not there.
    assert set(unknown) <= {"taut.gp.MultiOutputGP", "taut.forms_torch.NoThird"}


def test_signatures_can_be_inspected_and_hide_no_function():
    functions = [
        getattr(taut, name)
        for name in taut.__all__
        if callable(getattr(taut, name)) and not inspect.isclass(getattr(taut, name))
    ]
    assert len(functions) > 20
    hidden = {"taut", *dir(builtins), *taut.__all__} - {"threads", "tensions"}
    for function in functions:
        assert hidden.isdisjoint(inspect.signature(function).parameters), function.__name__
    of_inspect = inspect.signature(taut.inspect)
    assert list(of_inspect.parameters) == ["net", "targets", "noise", "prior", "uncertain"]
    assert of_inspect.parameters["noise"].default == 0.5e-3
    assert of_inspect.parameters["noise"].annotation == "float | str"
    assert of_inspect.parameters["net"].default is inspect.Parameter.empty
    assert of_inspect.return_annotation.endswith("PredictedPrecision")


def test_signatures_of_constructors_and_methods_can_be_inspected():
    seen = 0
    for of in [getattr(taut, name) for name in taut.__all__]:
        if not inspect.isclass(of) or issubclass(of, BaseException):
            continue
        for name, method in inspect.getmembers(of, callable):
            if not name.startswith("_"):
                assert inspect.signature(method).return_annotation, method
                seen += 1
    assert seen > 40
    assert list(inspect.signature(taut.CableNet).parameters)[:2] == ["nodes", "supports"]
    net = taut.hypar(3, 3)
    assert list(inspect.signature(net.with_lengths).parameters) == ["unstressed_lengths"]
    with pytest.raises(TypeError, match=r"CableNet.save: path: is missing"):
        net.save()
    with pytest.raises(TypeError, match=r"CableNet.save: path: got int 3, expected"):
        net.save(3)


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda net: taut.CableNet(net.nodes, net.supports), "CableNet: edges: is missing"),
        (lambda net: taut.CableNet([], [], [], 1e5, [], breaking=3), "breaking: .* breaking_load"),
        (lambda net: taut.TensionLaw([0, 1], [0, 1], 3), "TensionLaw: name: got int 3, .* str"),
        (lambda net: taut.EquilibriumSolver(3), "EquilibriumSolver: net: got int 3, .* CableNet"),
        (lambda net: taut.FormSensitivity(net), "FormSensitivity: unstressed_lengths: is missing"),
    ],
)
def test_constructors_name_the_argument(call, words):
    with pytest.raises(TypeError, match=words):
        call(taut.hypar(3, 3))


def test_constructors_convert_numbers():
    assert taut.EquilibriumSolver(taut.hypar(3, 3), relative_tolerance=1)


@pytest.mark.skipif(os.name != "posix", reason="signals of POSIX")
def test_ctrl_c_ends_long_work():
    code = (
        "import sys, taut\n"
        "net = taut.hilo_quarter()\n"
        "print('begun', flush=True)\n"
        "try:\n"
        "    taut.Sampler(net).draw(1_000_000)\n"
        "except KeyboardInterrupt:\n"
        "    print('stopped')\n"
        "print(len(taut.Sampler(net).draw(1)))\n"
    )
    with subprocess.Popen(
        [sys.executable, "-c", code], stdout=subprocess.PIPE, text=True
    ) as process:
        assert process.stdout.readline() == "begun\n"
        time.sleep(0.5)
        process.send_signal(signal.SIGINT)
        rest, _ = process.communicate(timeout=30)
    assert rest == "stopped\n1\n"


def resident():
    """Memory of this process [bytes]."""
    return int(Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")


@pytest.mark.skipif(not Path("/proc/self/statm").exists(), reason="memory as Linux reports it")
def test_memory_is_given_back():
    net = taut.hypar(5, 5)
    columns = taut.simulate_survey(net, net.nodes, noise=1e-3, seed=1)

    def round_trip():
        copy = taut.CableNet.from_json(net.to_json())
        survey = taut.read_survey(copy, columns)
        found = taut.identify(copy, survey, draws=200)
        views = [found.tension, found.form, copy.nodes, found.length_draws]
        with pytest.raises(ValueError, match="prior"):
            taut.identify(copy, survey, prior="no prior")
        return views

    for _ in range(5):
        round_trip()
    gc.collect()
    before = resident()
    for _ in range(40):
        round_trip()
    gc.collect()
    # One survey's samples are some 0.3 MB, of which 40 would be left behind.
    assert resident() - before < 4e6


anything = st.one_of(
    st.none(),
    st.booleans(),
    st.integers(),
    st.floats(),
    st.text(max_size=5),
    st.binary(max_size=5),
    st.lists(st.one_of(st.integers(), st.floats(), st.text(max_size=3)), max_size=6),
    st.lists(st.lists(st.floats(), min_size=3, max_size=3), max_size=6),
    st.lists(st.lists(st.integers(-2, 6), min_size=2, max_size=2), max_size=6),
    st.dictionaries(st.text(max_size=2), st.lists(st.floats(), max_size=3), max_size=3),
    st.just(np.array(["a"])),
    st.just(np.array([object()])),
    st.just(np.zeros((2, 3, 4))),
    st.just(np.array([[1, 2]], dtype=">i2")),
    st.just(np.ma.masked_array([1.0], mask=[True])),
    st.just(float),
)
refused = (ValueError, TypeError, OverflowError, OSError, IndexError, MemoryError)
without_deadline = settings(
    database=None,
    deadline=None,
    derandomize=True,
    max_examples=300,
    suppress_health_check=[HealthCheck.function_scoped_fixture],
)


@without_deadline
@given(anything, anything, anything, anything, anything)
def test_a_net_of_anything_is_valid_or_refused(nodes, supports, edges, stiffness, lengths):
    try:
        net = taut.CableNet(nodes, supports, edges, stiffness, lengths)
    except refused:
        return
    assert np.isfinite(net.nodes).all()


VERSION = taut.__version__
calls = [
    lambda net, a, b: taut.solve_equilibrium(net, a),
    lambda net, a, b: taut.EquilibriumSolver(net).solve(net.unstressed_lengths, a),
    lambda net, a, b: taut.FormSensitivity(net, a, b),
    lambda net, a, b: taut.FormSensitivity(net, net.unstressed_lengths, net.nodes).columns(a),
    lambda net, a, b: taut.tensions(net, a, b),
    lambda net, a, b: taut.read_survey(net, a, ids=b),
    lambda net, a, b: taut.read_survey(net, {"x": a, "y": a, "z": b}),
    lambda net, a, b: taut.read_survey(net, a, noise=b),
    lambda net, a, b: taut.inspect(net, targets=a),
    lambda net, a, b: taut.Sampler(net, a, b),
    lambda net, a, b: taut.CableNet.from_json(a),
    lambda net, a, b: taut._taut._fit_processes(a, b),
    lambda net, a, b: taut.form_from_force_densities(a, [0], b, 1.0),
    lambda net, a, b: taut.unstressed_lengths_for(a, b, 1.0),
    lambda net, a, b: taut.simulate_survey(net, a, noise=b),
    lambda net, a, b: net.with_lengths(a),
    lambda net, a, b: net.node_id(a) + net.edge_id(b),
    lambda net, a, b: taut.Survey.__new__(taut.Survey).__setstate__((a, b)),
    lambda net, a, b: taut.Equilibrium.__new__(taut.Equilibrium).__setstate__((VERSION, a)),
]


@without_deadline
@given(st.sampled_from(calls), anything, anything)
def test_the_interpreter_survives_any_argument(call, first, second):
    net = taut.hypar(2, 2)
    with contextlib.suppress(refused):
        call(net, first, second)


def test_an_array_that_changes_during_a_call_has_no_effect(net):
    lengths = np.array(net.unstressed_lengths)
    expected = taut.solve_equilibrium(net, lengths).form
    done = threading.Event()

    def change():
        while not done.is_set():
            lengths[:] = np.nan
            lengths[:] = net.unstressed_lengths

    thread = threading.Thread(target=change)
    thread.start()
    try:
        for _ in range(50):
            try:
                form = taut.solve_equilibrium(net, lengths).form
            except ValueError:
                continue
            assert np.array_equal(form, expected)
    finally:
        done.set()
        thread.join()
