"""Worlds: lights and cameras, in lists and as arrays."""
import unittest

import numpy as np
import prelight
from common import drawn, renderer, world


class Lights(unittest.TestCase):
    def setUp(self):
        self.world = prelight.make_scene("lights", lights=8).resolve()

    def test_a_list(self):
        lights = self.world.lights
        self.assertEqual(len(lights), 8)
        self.assertEqual([light.kind for light in lights[2:4]], [lights[2].kind, lights[3].kind])
        added = lights.append(prelight.Light("spot", position=(1, 2, 3), colour=(1, .5, 0), name="lamp"))
        added.intensity = 7  # is the one in the list
        self.assertEqual((len(lights), lights[-1].name, lights[8].intensity), (9, "lamp", 7))
        self.assertIs(lights[-1].kind, prelight.LightKind.SPOT)
        lights[0] = lights[-1]
        self.assertEqual(lights[0].name, "lamp")
        del lights[-1]
        self.assertEqual(len(self.world.lights), 8)
        with self.assertRaises(IndexError):
            lights[8]
        with self.assertRaises(IndexError):
            added.name  # no longer in the list
        self.world.lights = [prelight.Light()] * 3
        self.assertEqual(len(lights), 3)
        with self.assertRaises(TypeError):
            self.world.lights = [1]
        self.assertEqual(len(lights), 3)
        lights.extend(light for light in lights)
        self.assertEqual(len(lights), 6)
        lights.clear()
        self.assertEqual(len(lights), 0)

    def test_arrays(self):
        lights = self.world.lights
        lights.positions = lights.positions + [0, 1, 0]
        np.testing.assert_array_equal(lights.positions[3], lights[3].position)
        self.assertEqual((lights.positions.shape, lights.positions.dtype), ((8, 3), np.float64))
        lights.intensities = np.arange(8)
        lights.colours = np.full((8, 3), .5)
        lights.ranges = np.full(8, 9.)
        self.assertEqual((lights[5].intensity, lights[5].range, lights[5].colour.tolist()), (5, 9, [.5] * 3))
        with self.assertRaises(ValueError):
            lights.positions[0] = 1  # would change nothing
        for name, wrong in (("positions", np.zeros((7, 3))), ("intensities", np.zeros((8, 1))),
                            ("colours", np.zeros(8))):
            with self.assertRaisesRegex(prelight.UsageError, f"{name}: an array of shape"):
                setattr(lights, name, wrong)

    def test_out_of_range(self):
        for name, value in (("intensity", -1), ("intensity", np.nan), ("range", 0), ("colour", (1, -1, 0)),
                            ("shininess", 0), ("size", -1), ("falloff", "linear"), ("outer_cone", 2),
                            ("inner_cone", 1.5)):
            wrong = prelight.make_scene("lights", lights=4).resolve()
            wrong.lights = [prelight.Light("spot", name="lamp")]
            setattr(wrong.lights[0], name, value)
            with renderer() as made, self.assertRaisesRegex(prelight.UsageError, r'lights\[0\] "lamp": \w+'):
                made.set_world(wrong)
        with self.assertRaisesRegex(prelight.UsageError, "direction: has no direction"):
            prelight.Light(direction=(0, 0, 0))
        with self.assertRaisesRegex(prelight.UsageError, "position: not finite"):
            prelight.Light(position=(0, np.inf, 0))
        with self.assertRaises(TypeError):
            prelight.Light(brightness=3)

    def test_changes_of_all(self):
        self.world.scatter_lights(5, seed=3)
        self.assertEqual(len(self.world.lights), 13)
        before = self.world.lights.positions
        self.world.rotate_lights((0, 0, 0), np.pi / 2)
        np.testing.assert_allclose(self.world.lights.positions, before[:, [2, 1, 0]] * [1, 1, -1], atol=1e-12)
        self.world.randomize_lights(seed=2)
        self.assertGreater(len({light.kind for light in self.world.lights}), 1)


class Cameras(unittest.TestCase):
    def test_look_at(self):
        camera = prelight.Camera.look_at((3, 0, 0), (0, 0, 0), yfov=.5)
        np.testing.assert_allclose(camera.axes, [[0, 0, 1], [0, 1, 0], [-1, 0, 0]], atol=1e-12)
        with self.assertRaisesRegex(prelight.UsageError, "same point"):
            prelight.Camera.look_at((1, 1, 1), (1, 1, 1))
        with self.assertRaisesRegex(prelight.UsageError, "up"):
            prelight.Camera.look_at((0, 1, 0), (0, 0, 0))

    def test_by_name_and_number(self):
        shown = prelight.make_scene("lights", lights=4).resolve()
        shown.cameras.append(prelight.Camera.look_at((0, 4, 9), (0, 0, 0), name="mine"))
        number = len(shown.cameras) - 1
        by_name = drawn(shown, "mine")
        np.testing.assert_array_equal(by_name, drawn(shown, number))
        np.testing.assert_array_equal(by_name, drawn(shown, shown.cameras[-1]))
        self.assertFalse(np.array_equal(by_name, drawn(shown)))
        for wrong, kind in (("yours", prelight.UsageError), (9, prelight.UsageError), (1.5, TypeError)):
            with self.assertRaises(kind):
                drawn(shown, wrong)

    def test_out_of_range(self):
        for options, why in (({"yfov": 4}, "yfov"), ({"znear": 0}, "znear"), ({"zfar": .01}, "zfar"),
                             ({"kind": "orthographic"}, "infinite"), ({"axes": np.eye(3) * 2}, "axes"),
                             ({"axes": np.diag([1, 1, -1])}, "mirror")):
            with self.assertRaisesRegex(prelight.UsageError, why):
                drawn(world(), prelight.Camera(**options))

    def test_frames_all(self):
        scene = prelight.Scene()
        scene.add_node(scene.add_mesh([[0, 0, 0], [4, 0, 0], [0, 4, 0]], [[0, 1, 2]]))
        shown = scene.resolve()
        self.assertEqual(shown.cameras[0].name, "framed")
        np.testing.assert_array_equal(drawn(shown), drawn(shown, shown.frame(96 / 54)))
        with self.assertRaises(prelight.UsageError):
            shown.frame(0)


class Objects(unittest.TestCase):
    def test_moved_and_hidden(self):
        shown = prelight.make_scene("lights", lights=4).resolve()
        before = drawn(shown)
        for instance in shown.instances:
            moved = instance.transform.copy()
            moved[1, 3] += .5
            instance.transform = moved
        self.assertFalse(np.array_equal(before, drawn(shown)))
        for instance in shown.instances:
            instance.visible = False
        self.assertLess(drawn(shown).std(), .02)


if __name__ == "__main__":
    unittest.main()
