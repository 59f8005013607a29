"""Renderers: what they draw, what of it may change, figures, threads, Ctrl-C."""
import contextlib
import io
import os
import re
import shutil
import signal
import subprocess
import sys
import threading
import unittest

import numpy as np
import prelight
from common import ROOT, SIZE, Ticking, device, drawn, folder, quad, renderer, world


class Pictures(unittest.TestCase):
    def test_each_architecture_agrees_with_the_reference(self):
        infos = {info.name: info for info in prelight.renderers()}
        self.assertEqual(set(infos), {"light-prepass", "inferred", "deferred", "z-prepass", "multipass", "reference"})
        for name in ("light-prepass", "deferred", "z-prepass", "multipass"):
            with renderer(name, views=["linear"]) as made:
                made.set_world(world())
                made.render()
                truth = made.reference()
                figures = prelight.compare(made.read("linear"), truth.linear, truth.left_out)
            self.assertGreater(figures.psnr, 55, name)
            self.assertLess(figures.left_out_share, .5, name)

    def test_the_reference_is_one_itself(self):
        with renderer("reference") as made:
            self.assertIsNone(made.device)
            made.set_world(world())
            made.render()
            other = prelight.render_reference(world(), settings=made.stats.settings, **SIZE)
            np.testing.assert_array_equal(made.read("linear"), made.reference().linear)
            np.testing.assert_array_equal(made.read("linear"), other.linear)
        self.assertEqual(other.depth.shape, (SIZE["height"], SIZE["width"]))
        hit = other.instance != 0xffffffff
        np.testing.assert_array_equal(np.isinf(other.depth), ~hit)
        np.testing.assert_allclose(np.linalg.norm(other.normal[hit], axis=1), 1, atol=1e-6)
        camera = world().cameras[0]
        along = (other.position[hit] - camera.position) @ -camera.axes[:, 2]
        np.testing.assert_allclose(along, other.depth[hit], rtol=1e-9)

    def test_one_call(self):
        np.testing.assert_array_equal(prelight.render(world(), device=device(), **SIZE), drawn(world()))
        normals = prelight.render(world(), device=device(), view="normal", dtype="uint8", **SIZE)
        self.assertEqual((normals.shape, normals.dtype), ((SIZE["height"], SIZE["width"], 3), np.uint8))


class Changes(unittest.TestCase):
    def test_other_lights(self):
        shown = prelight.make_scene("lights", lights=16).resolve()
        with renderer() as made:
            made.set_world(shown)
            made.render()
            before = made.read()
            lamp = prelight.Light(position=(0, 2, 0), colour=(1, .2, .1), intensity=30, range=8)
            made.set_lights([*shown.lights, lamp])
            made.render()
            more = made.read()
            self.assertGreater(more.mean(), before.mean())
            made.set_world(shown)  # its own lights again
            made.render()
            np.testing.assert_array_equal(made.read(), before)
            shown.lights.append(lamp)
            made.set_world(shown)
            made.render()
            np.testing.assert_array_equal(made.read(), more)

    def test_a_world_of_the_same_scene_is_updated(self):
        scene = prelight.make_scene("motion")
        with renderer() as made:
            made.set_world(scene.resolve(time=0))
            for time in (.2, .4, .7):  # both frames in flight stage an update before
                made.render()
                made.set_world(scene.resolve(time=time))
            made.render()
            self.assertEqual(made.stats.created.buffers + made.stats.created.images, 0)
            moved = made.read()
        np.testing.assert_array_equal(moved, drawn(scene.resolve(time=.7)))
        self.assertFalse(np.array_equal(moved, drawn(scene.resolve(time=0))))

    def test_what_the_caller_does_afterwards_does_not_matter(self):
        scene = prelight.make_scene("lights", lights=16)
        shown = scene.resolve()
        with renderer() as made:
            made.set_world(shown)
            shown.lights.clear()
            scene.materials[0].base_colour = (1, 0, 0, 1)
            del shown, scene
            made.render()
            np.testing.assert_array_equal(made.read(), drawn(world()))

    def test_another_size(self):
        with renderer() as made:
            made.set_world(world())
            made.render()
            made.resize(64, 48)
            with self.assertRaises(prelight.UsageError):
                made.read()
            made.render()
            np.testing.assert_array_equal(made.read(), drawn(world(), width=64, height=48))
            self.assertEqual((made.width, made.height), (64, 48))

    def test_order(self):
        made = renderer()
        for early in (made.render, made.read, made.reference, lambda: made.set_lights([])):
            with self.assertRaisesRegex(prelight.UsageError, "comes before"):
                early()
        with made:
            pass
        for late in (made.render, lambda: made.stats, lambda: made.set_world(world())):
            with self.assertRaisesRegex(prelight.UsageError, "closed"):
                late()


class Settings(unittest.TestCase):
    def test_in_force(self):
        with renderer(settings={"normals": "oct32", "light_culling": "volumes", "light-buffer": "rgb10a2"}) as made:
            made.set_world(world())
            made.render()
            self.assertEqual(made.stats.settings["light-culling"], "volumes")
            self.assertEqual(made.stats.settings["normals"], "oct32")
            self.assertIsNotNone(made.stats.light_buffer)
        with renderer(settings={"shadows": True, "shadow-budget": 1}) as made:
            self.assertEqual(made.stats.settings["shadows"], "on")

    def test_wrong_ones(self):
        for options, why in (({"settings": {"colour": "red"}}, "colour"), ({"settings": {"normals": "oct3"}}, "oct3"),
                             ({"preset": "engels"}, "engels"), ({"views": ["normals"]}, "normals"),
                             ({"shading": "toon"}, "toon"), ({"msaa": 3}, "3"), ({"name": "raster"}, "raster"),
                             ({"exposure": np.inf}, "exposure")):
            with self.assertRaisesRegex(prelight.UsageError, why) as caught:
                renderer(**options)
            self.assertIsInstance(caught.exception, ValueError)
            self.assertNotIn("\n", str(caught.exception))
        with self.assertRaises(prelight.Error):
            renderer(width=0)
        with self.assertRaises(TypeError):
            renderer(settings={"normals": ["oct32"]})
        with self.assertRaisesRegex(prelight.Error, "no such device"):
            prelight.Device("no such device")

    def test_listed(self):
        info = next(info for info in prelight.renderers() if info.name == "light-prepass")
        self.assertIn("engel", info.presets)
        self.assertIn("final", info.views)
        normals = next(setting for setting in info.settings if setting.key == "normals")
        self.assertIn(normals.default_value, normals.values)


class Frames(unittest.TestCase):
    def test_figures_and_progress(self):
        told = []
        with renderer(count_pairs=True, pass_cpu=True) as made:
            made.set_world(world())
            made.render(frames=3, progress=lambda done, frames: told.append((done, frames)))
            stats = made.stats
        self.assertEqual(told, [(1, 3), (2, 3), (3, 3)])
        self.assertEqual((stats.frames, stats.lights), (3, 16))
        self.assertTrue(0 < stats.wall_ms.min <= stats.wall_ms.median <= stats.wall_ms.max)
        self.assertIn("light", [each.name for each in stats.passes])
        self.assertIsNotNone(stats.passes[0].cpu_ms)
        self.assertTrue(stats.pairs_counted and stats.pairs_evaluated >= stats.pairs_contributing > 0)
        self.assertIs(stats.shading, prelight.Shading.GGX)

    def test_an_error_of_progress_ends_it(self):
        def stop(done, _):
            if done == 2:
                raise RuntimeError("enough")
        with renderer() as made:
            made.set_world(world())
            with self.assertRaisesRegex(RuntimeError, "enough"):
                made.render(frames=1000, progress=stop)
            self.assertEqual(made.stats.frames, 2)

    def test_ctrl_c_ends_it_between_two(self):
        with renderer() as made:
            made.set_world(world())
            threading.Timer(.2, os.kill, (os.getpid(), signal.SIGINT)).start()
            with self.assertRaises(KeyboardInterrupt):
                made.render(frames=1_000_000)
            made.render()  # and it still draws
            np.testing.assert_array_equal(made.read(), drawn(world()))


class Threads(unittest.TestCase):
    def ticks(self, work):
        with Ticking() as other:
            before = other.ticks
            work()
            return other.ticks - before

    def test_others_run_meanwhile(self):
        picture = np.random.default_rng(1).random((360, 640, 3), np.float32)
        with renderer(width=640, height=360) as made:
            for work in (lambda: made.set_world(world()), made.render, made.read, made.reference,
                         lambda: prelight.compare(picture, picture), lambda: prelight.flip_map(picture, picture),
                         lambda: prelight.make_scene("spheres"), lambda: prelight.tonemap(picture)):
                # Those that take a moment. With the GIL held there would be one tick at most.
                self.assertTrue(any(self.ticks(work) > 2 for _ in range(4)))

    def test_two_at_a_time(self):
        alone = {name: drawn(world(), name=name) for name in ("light-prepass", "deferred")}
        made = {name: renderer(name) for name in alone}
        seen, wrong = [], []

        def work(name):
            try:
                for _ in range(6):
                    made[name].set_world(world())
                    made[name].render()
                    picture = made[name].read()
                    (seen if np.array_equal(picture, alone[name]) else wrong).append(name)
            except Exception as error:  # of a thread nobody would see
                wrong.append(error)
        threads = [threading.Thread(target=work, args=(name,)) for name in alone]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual((wrong, len(seen)), ([], 12))


class Programs(unittest.TestCase):
    def test_the_example(self):
        with folder() as path:
            ran = subprocess.run([sys.executable, ROOT / "examples/python/error_over_lights.py", "--size", "64x36",
                                  "--counts", "16,64", "-o", path / "plot.png"],
                                 capture_output=True, text=True, cwd=path)
            self.assertEqual((ran.returncode, ran.stderr), (0, ""))
            figures = [float(line.split("PSNR")[1].split()[0]) for line in ran.stdout.splitlines()]
            self.assertEqual(len(figures), 4)
            self.assertGreater(min(figures), 40)
            self.assertGreater(prelight.load_png(path / "plot.png").std(), .1)

    def test_the_manual(self):
        # What docs/python.md shows, one block after another, with less to draw.
        text = (ROOT / "docs/python.md").read_text()
        for much, little in (('"city", lights=256', '"lights", lights=8'),
                             ("width=640, height=360", "width=64, height=36"), ("24, endpoint", "2, endpoint")):
            self.assertIn(much, text)
            text = text.replace(much, little)
        blocks = re.findall(r"^```python\n(.*?)^```", text, re.M | re.S)
        self.assertEqual(len(blocks), 4)
        positions, indices = quad()
        names = {"positions": positions, "indices": indices, "uv": positions[:, :2]}
        with folder() as path, contextlib.chdir(path), contextlib.redirect_stdout(io.StringIO()):
            for block in blocks[:3]:
                exec(block, names)
            self.assertEqual(sorted(file.name for file in path.iterdir()), ["city.png", "mine.glb"])
            names["renderer"] = renderer()
            names["renderer"].set_world(world())
            names["renderer"].render()
            exec(blocks[3], names)

    def test_the_types(self):
        if not shutil.which("mypy", path="/usr/bin"):
            self.skipTest("mypy is missing")
        with folder() as path:
            # numpy's own stubs take ten times as long as all else.
            (path / "mypy.ini").write_text("[mypy]\nstrict = True\n[mypy-numpy.*,matplotlib.*]\n"
                                           "ignore_missing_imports = True\nfollow_imports = skip\n"
                                           "follow_imports_for_stubs = True\n")
            (path / "wrong.py").write_text("import prelight\nprelight.Light(brightness=3)\nprelight.version().width\n"
                                           "prelight.Image().width = 3\n")
            ran = subprocess.run(["/usr/bin/mypy", "--config-file", path / "mypy.ini", "--cache-dir", path / "cache",
                                  ROOT / "python/prelight", ROOT / "examples/python/error_over_lights.py",
                                  path / "wrong.py"],
                                 capture_output=True, text=True, env=os.environ | {"MYPYPATH": str(ROOT / "python")})
            lines = [line for line in ran.stdout.splitlines() if ": error: " in line]
            self.assertEqual([re.search(r"(\w+\.pyi?):(\d+)", line).groups() for line in lines],
                             [("wrong.py", "2"), ("wrong.py", "3"), ("wrong.py", "4")], ran.stdout)

    def test_the_end_of_the_interpreter(self):
        # Everything is alive when it ends, a thread draws, and nothing is waited for.
        code = ("import prelight, threading\n"
                "r = prelight.Renderer(width=64, height=36)\n"
                "r.set_world(prelight.make_scene('lights', lights=4).resolve())\n"
                "r.render(); kept = r.read()\n"
                "threading.Thread(target=lambda: r.render(frames=10**6), daemon=True).start()\n"
                "print(kept.shape)\n")
        ran = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60)
        self.assertEqual((ran.returncode, ran.stdout, ran.stderr), (0, "(36, 64, 3)\n", ""))


class Validation(unittest.TestCase):
    @classmethod
    def tearDownClass(cls):
        messages = device().validation_messages
        if messages:
            raise AssertionError(messages[0])

    def test_device(self):
        drawn(world(), settings={"shadows": "on"})
        self.assertEqual(device().validation_messages, [])
        self.assertTrue(device().has_samples(1))
        self.assertTrue(any(known.chosen for known in prelight.devices()))


if __name__ == "__main__":
    unittest.main()
