"""The argument ``device`` without a card."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import carom
import pytest
from carom import device

SHOT = Path(__file__).resolve().parents[2] / "shots" / "stop_shot.json"


def test_the_default_is_this_machine() -> None:
    assert device.opened("cpu") is None


@pytest.mark.parametrize("name", ["gpu", "cuda:", "cuda:-1", "CUDA", "", None, 0])
def test_refuses_an_unknown_device(name: object) -> None:
    with pytest.raises(carom.InputError, match=r'device: .* write "cpu", "cuda" or "cuda:1"'):
        carom.simulate_batch([], device=name)


def test_without_a_kernel_the_error_says_how_to_get_one(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(device, "KERNEL", tmp_path / "carom.ptx.gz")
    shot = carom.Shot.load(SHOT)
    for play in (
        lambda: carom.simulate_batch([shot], device="cuda:17"),
        lambda: shot.batch(speed=[1.0], device="cuda:17"),
        lambda: shot.vary(carom.Noise.preset("club"), 2, device="cuda:17"),
        lambda: shot.evaluate(carom.Noise.preset("club"), 2, device="cuda:17"),
    ):
        with pytest.raises(carom.InputError, match="device: this installation has no kernel"):
            play()


def test_a_device_does_not_compute_contacts_of_a_sweep() -> None:
    pytest.importorskip("pyarrow")
    sweep = carom.Sweep.from_dict({"format": "carom-sweep/1", "shots": str(SHOT)})
    with pytest.raises(carom.InputError, match="device: a device does not compute the columns"):
        sweep.table(device="cuda")


def test_a_sweep_refuses_an_unknown_device(tmp_path: Path) -> None:
    sweep = carom.Sweep.from_dict(
        {
            "format": "carom-sweep/1",
            "shots": str(SHOT),
            "columns": ["events", "end_x"],
        }
    )
    with pytest.raises(carom.InputError, match="device: 'gpu' is no device"):
        sweep.run(tmp_path / "table", device="gpu")


def test_without_a_driver_the_error_says_what_is_missing(tmp_path: Path) -> None:
    # A folder in place of the library, so that a driver of this machine is not found.
    (tmp_path / "libcuda.so.1").mkdir()
    code = "from carom import _core; _core.CudaDevice(0, b'.version 7.0')"
    done = subprocess.run(
        [sys.executable, "-c", code],
        env=os.environ | {"LD_LIBRARY_PATH": str(tmp_path)},
        check=False,
        capture_output=True,
        text=True,
    )
    if done.returncode == 0:
        pytest.skip("this machine has a card and its driver")
    assert "InputError: device: " in done.stderr
    assert 'or device "cpu"' in done.stderr
