"""Pictures: whose memory they are, files, measures."""
import gc
import subprocess
import unittest

import numpy as np
import prelight
from common import ROOT, SIZE, address, drawn, folder, renderer, resident_bytes, world


class Memory(unittest.TestCase):
    def test_an_array_shows_the_memory_of_its_base(self):
        picture = drawn(world())
        self.assertEqual((picture.shape, picture.dtype), ((SIZE["height"], SIZE["width"], 3), np.float32))
        self.assertIsInstance(picture.base, prelight.Image)
        self.assertEqual((picture.base.width, picture.base.height), (SIZE["width"], SIZE["height"]))
        self.assertFalse(picture.flags.owndata)
        self.assertTrue(picture.flags.c_contiguous)
        other = np.asarray(picture.base)
        self.assertEqual(address(other), address(picture))
        self.assertTrue(np.shares_memory(picture[3:5, ::2].base, picture))

    def test_nobody_writes_into_it(self):
        for dtype in ("float32", "uint8"):
            with renderer() as made:
                made.set_world(world())
                made.render()
                picture = made.read(dtype=dtype)
            with self.assertRaises(ValueError):
                picture[0, 0, 0] = 1
            with self.assertRaises(ValueError):
                picture.flags.writeable = True
            picture.copy()[0, 0, 0] = 1
        with self.assertRaises(ValueError):
            np.asarray(drawn(world()).base)[0, 0, 0] = 1

    def test_it_outlives_everything_that_made_it(self):
        scene = prelight.make_scene("lights", lights=16)
        made = renderer(views=["normal"])
        made.set_world(scene.resolve())
        made.render()
        truth = made.reference()
        pictures = [made.read("final"), made.read("linear"), made.read("normal"), made.read("final", np.uint8),
                    truth.linear, truth.depth, truth.position, truth.instance, truth.left_out, truth.display()]
        pictures.append(prelight.tonemap(pictures[1]))
        copies = [picture.copy() for picture in pictures]
        made.close()
        del made, truth, scene
        gc.collect()
        rubbish = [np.full((54, 96, 3), 7, np.float32) for _ in range(50)]  # would lie where freed pictures lay
        for picture, copy in zip(pictures, copies):
            np.testing.assert_array_equal(picture, copy)
        self.assertEqual(len(rubbish), 50)

    def test_it_goes_with_its_array(self):
        with renderer(width=640, height=360) as made:
            made.set_world(world())
            made.render()
            for _ in range(3):
                made.read()
            before = resident_bytes()
            for _ in range(40):  # 110 MB, if they stayed
                made.read()
                made.read(dtype="uint8")
            self.assertLess(resident_bytes() - before, 30e6)


class SamePictures(unittest.TestCase):
    def test_as_the_program_draws(self):
        with folder() as path:
            subprocess.run([ROOT / "build/release/prelight", "render", "lights", "--lights", "16", "--size", "96x54",
                            "--msaa", "1", "-o", path / "program.png"], check=True, capture_output=True)
            program = np.rint(prelight.load_png(path / "program.png") * 255).astype(np.uint8)
        with renderer() as made:
            made.set_world(world())
            made.render()
            np.testing.assert_array_equal(made.read(dtype="uint8"), program)

    def test_bytes_are_floats_rounded(self):
        with renderer() as made:
            made.set_world(world())
            made.render()
            rounded = np.floor(made.read() * np.float32(255) + .5).astype(np.uint8)
            np.testing.assert_array_equal(made.read(dtype=np.uint8), rounded)

    def test_linear_is_what_final_was_made_of(self):
        with renderer(views=["linear"]) as made:
            made.set_world(world())
            made.render()
            np.testing.assert_allclose(prelight.tonemap(made.read("linear")), made.read(), atol=1.5 / 255)
            self.assertGreater(made.read().std(), .05)


class Files(unittest.TestCase):
    def test_they_come_back(self):
        rows, columns = np.mgrid[0:5, 0:7].astype(np.float32)
        picture = np.stack([rows / 5, columns / 7, rows * 0 + .25], axis=2)
        with folder() as path:
            prelight.save_png(picture, path / "a.png")
            np.testing.assert_allclose(prelight.load_png(path / "a.png"), picture, atol=.5 / 255 + 1e-6)
            prelight.save_png(np.rint(picture * 255).astype(np.uint8), str(path / "b.png"))
            self.assertEqual((path / "a.png").read_bytes(), (path / "b.png").read_bytes())
            prelight.save_exr(picture[::-1] * 50, path / "c.exr")
            np.testing.assert_allclose(prelight.load_exr(path / "c.exr"), picture[::-1] * 50, rtol=1e-3)
            with self.assertRaisesRegex(prelight.Error, r"nowhere/a\.png"):
                prelight.save_png(picture, path / "nowhere" / "a.png")
            with self.assertRaisesRegex(prelight.Error, r"a\.png: .*EXR"):
                prelight.load_exr(path / "a.png")

    def test_what_is_no_picture_is_refused(self):
        for wrong, why in ((np.zeros((4, 4)), r"\(height, width, 3\) is needed, not \(4, 4\)"),
                           (np.zeros((4, 4, 4)), "4, 4, 4"), (np.zeros((0, 4, 3)), "0, 4, 3"), ("text", "picture"),
                           (np.zeros((2, 2, 3), np.int32), "int32"), (None, "NoneType")):
            with self.assertRaisesRegex(prelight.UsageError, why):
                prelight.save_png(wrong, "/nowhere/picture.png")


class Measures(unittest.TestCase):
    def test_figures(self):
        truth = np.linspace(.1, .9, 64 * 48 * 3, dtype=np.float32).reshape(48, 64, 3)
        same = prelight.compare(truth, truth)
        self.assertEqual((same.psnr, same.off_share, same.flip), (np.inf, 0, 0))
        other = truth.copy()
        other[10:20, 10:20] += .1
        figures = prelight.compare(other, truth)
        scale = 1 / np.quantile(truth, .99)
        error = np.mean((np.clip(other * scale, 0, 1) - np.clip(truth * scale, 0, 1)) ** 2, dtype=np.float64)
        self.assertAlmostEqual(figures.psnr, 10 * np.log10(1 / error), delta=.05)
        self.assertAlmostEqual(figures.off_share, 100 / (48 * 64), delta=1e-6)
        self.assertTrue(0 < figures.flip < .1)
        left_out = np.zeros((48, 64), bool)
        left_out[10:20, 10:20] = True
        rest = prelight.compare(other, truth, left_out)
        self.assertEqual(rest.psnr, np.inf)
        self.assertAlmostEqual(rest.left_out_share, 100 / (48 * 64))

    def test_maps(self):
        black, white = np.zeros((16, 16, 3), np.float32), np.ones((16, 16, 3), np.float32)
        self.assertLess(prelight.flip_map(black, black).max(), 1e-6)
        self.assertGreater(prelight.flip_map(black, white).mean(), .8)

    def test_wrong_shapes(self):
        picture = np.ones((4, 6, 3), np.float32)
        with self.assertRaisesRegex(prelight.UsageError, "left_out"):
            prelight.compare(picture, picture, np.zeros((6, 4), bool))
        with self.assertRaises(prelight.Error):
            prelight.compare(picture, picture[:2])
        with self.assertRaisesRegex(prelight.Error, "NaN"):
            prelight.compare(picture * np.nan, picture)
        with self.assertRaises(prelight.UsageError):
            prelight.flip_map(picture, picture[:2])

    def test_exposure(self):
        grey = np.full((8, 8, 3), .18, np.float32)
        self.assertAlmostEqual(prelight.auto_exposure(grey), 0)
        self.assertAlmostEqual(prelight.auto_exposure(grey / 4), 2)
        self.assertIsNone(prelight.auto_exposure(grey * 0))


if __name__ == "__main__":
    unittest.main()
