"""What the tests of the module share. They run small: scenes of few lights, pictures of a few thousand pixels."""
import contextlib
import functools
import os
import pathlib
import tempfile
import threading
import time

import numpy as np
import prelight

ROOT = pathlib.Path(__file__).resolve().parents[2]
# The program knows the layer of its own build; the library asks the loader.
os.environ.setdefault("VK_LAYER_PATH", str(ROOT / "build/release/share/prelight/layers"))
SIZE = {"width": 96, "height": 54}


@functools.cache
def device():
    """One for all tests, with validation: its messages are looked at when all have run (renderers_test.py)."""
    return prelight.Device("cpu", validate=True)


@functools.cache
def world():
    """Of the scene `lights` with 16 of them. Nobody changes it."""
    return prelight.make_scene("lights", lights=16).resolve()


def renderer(name="light-prepass", **options):
    return prelight.Renderer(name, None if name == "reference" else device(), **(SIZE | options))


def drawn(shown, camera=None, name="light-prepass", **options):
    with renderer(name, **options) as made:
        made.set_world(shown)
        made.render(camera)
        return made.read()


def address(array):
    return array.__array_interface__["data"][0]


@contextlib.contextmanager
def folder():
    with tempfile.TemporaryDirectory(prefix="prelight-python-") as path:
        yield pathlib.Path(path)


class Ticking:
    """Counts how often another Python thread runs meanwhile: with the GIL held it would not."""

    def __enter__(self):
        self.ticks, self.ends = 0, False
        self.thread = threading.Thread(target=self.tick)
        self.thread.start()
        return self

    def tick(self):
        while not self.ends:
            self.ticks += 1
            time.sleep(0.0005)

    def __exit__(self, *_):
        self.ends = True
        self.thread.join()


def resident_bytes():
    return int(pathlib.Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def quad():
    """Positions and indices of a square metre in the plane z = 0, seen from +Z."""
    return (np.array([[-.5, -.5, 0], [.5, -.5, 0], [.5, .5, 0], [-.5, .5, 0]], np.float32),
            np.array([[0, 1, 2], [0, 2, 3]], np.uint32))


def quad_scene(**material):
    scene = prelight.Scene("quad")
    mesh = scene.add_mesh(*quad(), material=scene.add_material(prelight.Material("paint", **material)), name="quad")
    scene.add_node(mesh, name="quad")
    scene.add_light(prelight.Light("directional", direction=(0, 0, -1), intensity=np.pi, name="sun"))
    scene.add_camera(prelight.Camera("orthographic", position=(0, 0, 2), ymag=.5, znear=0, zfar=10, name="front"))
    return scene
