"""Scenes: made, read, edited, saved; meshes of the caller's own."""
import gc
import unittest

import numpy as np
import prelight
from common import SIZE, address, drawn, folder, quad, quad_scene, renderer, world


class Meshes(unittest.TestCase):
    def test_a_square_of_paint(self):
        # A white diffuse square under pi lux, seen and lit head on: radiance is the base colour.
        scene = quad_scene(base_colour=(.2, .5, .1, 1), roughness=1)
        with renderer(shading="ggx", views=["albedo", "linear"], width=32, height=32, name="deferred") as made:
            made.set_world(scene.resolve())
            made.render("front")
            linear = made.read("linear")
            truth = made.reference().linear
        np.testing.assert_allclose(linear, truth, atol=2e-3)
        # 4 % of the light are reflected at the surface, a twentieth of that back to the eye.
        np.testing.assert_allclose(linear[16, 16], [.2, .5, .1], atol=.03)

    def test_arrays_are_views(self):
        scene = quad_scene()
        positions, indices = quad()
        primitive = scene.meshes[0].primitives[0]
        self.assertEqual(address(primitive.indices), address(scene.meshes[0].primitives[0].indices))
        self.assertFalse(primitive.positions.flags.writeable)
        np.testing.assert_array_equal(primitive.positions, positions[indices.ravel()])  # flat: vertices of its own each
        np.testing.assert_array_equal(primitive.normals, np.tile([0, 0, 1], (6, 1)))
        np.testing.assert_array_equal(primitive.indices, np.arange(6).reshape(2, 3))
        self.assertIsNone(primitive.texcoords)

    def test_a_view_stays_when_its_scene_grows_or_goes(self):
        scene = quad_scene()
        view = scene.meshes[0].primitives[0].positions
        before = view.copy()
        for i in range(20):
            scene.add_mesh(*quad(), name=str(i))
        np.testing.assert_array_equal(view, before)
        mesh = scene.meshes[0]
        del scene
        gc.collect()
        np.testing.assert_array_equal(view, before)
        self.assertEqual(mesh.name, "quad")

    def test_given_normals_share_vertices(self):
        scene = prelight.Scene()
        positions, indices = quad()
        mesh = scene.add_mesh(positions, indices.astype(np.int64), normals=np.tile([0, 0, 5.], (4, 1)),
                              texcoords=positions[:, :2] + .5, colours=np.ones((4, 4)))
        self.assertEqual(mesh.primitives[0].positions.shape, (4, 3))
        np.testing.assert_array_equal(mesh.primitives[0].normals, np.tile([0, 0, 1], (4, 1)))
        self.assertEqual(scene.materials[0].name, "white")

    def test_what_is_wrong_is_said_in_one_line(self):
        positions, indices = quad()
        nan = positions.copy()
        nan[2, 1] = np.nan
        for arguments, why in (
                ({"positions": positions[:, :2]}, r"positions: .*\(N, 3\) is needed, not \(4, 2\)"),
                ({"positions": positions[:0]}, "positions: there are none"),
                ({"positions": nan}, r"positions\[2\]: not finite"),
                ({"positions": "many"}, "positions: numbers"),
                ({"indices": indices.ravel()}, r"indices: .*\(M, 3\)"),
                ({"indices": indices + 1}, r"indices\[1\]: 4 is none of the 4 vertices"),
                ({"indices": indices.astype(np.int32) - 1}, r"indices\[0\]: -1 is none"),
                ({"indices": indices.astype(np.uint64) + 2**63}, r"indices\[0\]"),
                ({"indices": indices.astype(float)}, "indices: whole numbers"),
                ({"indices": indices[:0]}, "indices: there are none"),
                ({"normals": positions[:3]}, r"normals: .*\(4, 3\)"),
                ({"normals": positions * 0}, r"normals\[0\]: has no direction"),
                ({"texcoords": positions}, r"texcoords: .*\(4, 2\)"),
                ({"colours": np.full((4, 4), 2.)}, r"colours\[0\]: not in 0 ... 1"),
                ({"tangents": np.ones((4, 4))}, r"tangents\[0\]"),
                ({"material": prelight.Material()}, "material is not of this scene")):
            scene = prelight.Scene()
            with self.assertRaisesRegex(prelight.UsageError, why) as caught:
                scene.add_mesh(**({"positions": positions, "indices": indices} | arguments))
            self.assertNotIn("\n", str(caught.exception))
            self.assertEqual(len(scene.meshes), 0)

    def test_a_normal_map_needs_tangents(self):
        scene = quad_scene()
        scene.materials[0].normal_texture = scene.add_image(np.full((2, 2, 3), (128, 128, 255), np.uint8))
        with self.assertRaisesRegex(prelight.UsageError, 'mesh "quad": .*tangents'):
            scene.resolve()


class Materials(unittest.TestCase):
    def test_an_edit_shows(self):
        scene = quad_scene(base_colour=(1, 0, 0, 1))
        old = scene.resolve()
        scene.materials[0].base_colour = (0, 1, 0, 1)
        red, green = drawn(old, "front", width=8, height=8), drawn(scene.resolve(), "front", width=8, height=8)
        self.assertGreater(red[4, 4, 0], 2 * red[4, 4, 1])
        self.assertGreater(green[4, 4, 1], 2 * green[4, 4, 0])

    def test_a_texture_shows(self):
        scene = prelight.Scene()
        positions, indices = quad()
        halves = np.zeros((4, 4, 3), np.uint8)
        halves[:2, :, 0] = 255  # red above, blue below
        halves[2:, :, 2] = 255
        paint = scene.add_material(prelight.Material("picture", unlit=True))
        paint.base_colour_texture = scene.add_image(halves, "halves")
        scene.add_node(scene.add_mesh(positions, indices, normals=np.tile([0, 0, 1.], (4, 1)),
                                      texcoords=np.stack([positions[:, 0] + .5, .5 - positions[:, 1]], 1),
                                      material=paint))
        scene.add_camera(prelight.Camera("orthographic", position=(0, 0, 2), ymag=.5, znear=0, zfar=10))
        picture = drawn(scene.resolve(), width=16, height=16)
        self.assertGreater(picture[2, 8, 0], picture[2, 8, 2] + .3)
        self.assertGreater(picture[13, 8, 2], picture[13, 8, 0] + .3)
        self.assertEqual(scene.images, ["halves"])

    def test_out_of_range(self):
        for name, value, why in (("metallic", 2, "metallic"), ("base_colour", (1, 1, 1, 3), "base_colour"),
                                 ("emissive", (-1, 0, 0), "emissive"),
                                 ("base_colour_texture", 7, "7 is none of the scene's 0")):
            scene = quad_scene()
            setattr(scene.materials[0], name, value)
            with self.assertRaisesRegex(prelight.UsageError, f'material "paint": .*{why}'):
                scene.resolve()
        with self.assertRaisesRegex(prelight.UsageError, "base_colour: 4 numbers"):
            quad_scene().materials[0].base_colour = (1, 1, 1)
        with self.assertRaisesRegex(prelight.UsageError, 'AlphaMode: "glass" is none of opaque, mask, blend'):
            quad_scene().materials[0].alpha_mode = "glass"

    def test_shaders(self):
        self.assertIn("minnaert", prelight.material_shaders())
        scene = quad_scene()
        scene.assign_shader("paint", "minnaert")
        self.assertEqual(scene.materials[0].shader, "minnaert")
        plain, own = drawn(quad_scene().resolve(), width=8, height=8), drawn(scene.resolve(), width=8, height=8)
        self.assertFalse(np.array_equal(plain, own))
        with self.assertRaisesRegex(prelight.Error, "nothing"):
            scene.materials[0].parameters = {"nothing": 1}
        with self.assertRaises(prelight.UsageError):
            scene.assign_shader("chrome", "minnaert")
        with folder() as path:
            (path / "own.glsl").write_text("void surface() { no such thing }\n")
            with self.assertRaisesRegex(prelight.Error, r"own\.glsl"):
                scene.assign_shader("paint", path / "own.glsl")


class Trees(unittest.TestCase):
    def test_places(self):
        scene = prelight.Scene()
        up, aside = np.eye(4), np.eye(4)
        up[1, 3], aside[0, 3] = 2, 3
        parent = scene.add_node(matrix=up, name="parent")
        scene.add_node(scene.add_mesh(*quad()), matrix=aside, parent=parent)
        scene.add_light(prelight.Light("spot", position=(0, 0, 1), direction=(0, -3, 0), name="lamp"), parent=parent)
        scene.add_camera(prelight.Camera.look_at((0, 0, 5), (0, 0, 0), name="eye"), parent=parent)
        shown = scene.resolve()
        np.testing.assert_allclose(shown.instances[0].transform[:3, 3], [3, 2, 0])
        np.testing.assert_allclose(shown.lights[0].position, [0, 2, 1])
        np.testing.assert_allclose(shown.lights[0].direction, [0, -1, 0], atol=1e-12)
        np.testing.assert_allclose(shown.cameras[0].position, [0, 2, 5])
        np.testing.assert_allclose(shown.bounds, [[2.5, 1.5, 0], [3.5, 2.5, 0]])
        parent.matrix = np.eye(4)
        np.testing.assert_allclose(scene.resolve().bounds, [[2.5, -.5, 0], [3.5, .5, 0]])
        np.testing.assert_allclose(shown.bounds[0], [2.5, 1.5, 0])  # is what it was
        parent.visible = False
        self.assertEqual(len(scene.resolve().instances), 0)
        self.assertEqual(scene.nodes[0].children, [1, 2, 3])

    def test_wrong_matrices(self):
        scene = prelight.Scene()
        for wrong in (np.eye(3), np.full((4, 4), np.nan), np.diag([1, 1, 1, 2.]), "eye"):
            with self.assertRaisesRegex(prelight.UsageError, "matrix"):
                scene.add_node(matrix=wrong)
        other = prelight.Scene().add_node()
        with self.assertRaisesRegex(prelight.UsageError, "not of this scene"):
            scene.add_node(parent=other)
        self.assertEqual(len(scene.nodes), 0)

    def test_files(self):
        with folder() as path:
            quad_scene(base_colour=(0, 0, 1, 1)).save_glb(path / "quad.glb")
            scene = prelight.load_gltf(path / "quad.glb", strict=True)
            np.testing.assert_array_equal(drawn(scene.resolve(), width=16, height=16),
                                          drawn(quad_scene(base_colour=(0, 0, 1, 1)).resolve(), width=16, height=16))
            (path / "broken.glb").write_bytes(b"glTF" + bytes(20))
            with self.assertRaisesRegex(prelight.Error, r"broken\.glb: "):
                prelight.load_gltf(path / "broken.glb")
        with self.assertRaisesRegex(prelight.Error, "nowhere.glb"):
            prelight.load_gltf("nowhere.glb")

    def test_built_in(self):
        self.assertIn("city", [known.name for known in prelight.builtin_scenes()])
        self.assertEqual(len(world().lights), 16)
        with self.assertRaisesRegex(prelight.UsageError, "village"):
            prelight.make_scene("village")
        with self.assertRaises(prelight.UsageError):
            prelight.make_scene("lights", lights=0)


class Environments(unittest.TestCase):
    def test_an_array_lights(self):
        scene = prelight.Scene()
        scene.add_node(scene.add_mesh(*quad()))
        sky = np.zeros((8, 16, 3), np.float32)
        sky[..., 2] = .5
        scene.set_environment(sky)
        self.assertTrue(scene.is_lit)
        picture = drawn(scene.resolve(), width=16, height=16)
        self.assertGreater(picture[8, 8, 2], picture[8, 8, 0] + .2)
        scene.set_environment("studio", background=False)
        self.assertEqual(scene.environment, "studio")
        scene.set_environment(None)
        self.assertFalse(scene.is_lit)
        for wrong, why in ((sky[:, :8], "twice as wide"), (-sky, "below 0"), (sky * np.nan, "finite")):
            with self.assertRaisesRegex(prelight.UsageError, why):
                scene.set_environment(wrong)
        with self.assertRaisesRegex(prelight.Error, "nowhere.hdr"):
            scene.set_environment("nowhere.hdr")


if __name__ == "__main__":
    unittest.main()
