"""Prelight: scenes with very many lights, from Python.

    scene = prelight.make_scene("city", lights=256)
    picture = prelight.render(scene, width=640, height=360)
    prelight.save_png(picture, "city.png")

Lengths are metres, angles radians, colours linear Rec. 709. The world is right-handed, +Y is up. Matrices are numpy's:
rows, for column vectors. Pictures are arrays (height, width, 3), rows from the top.
"""
from __future__ import annotations

from typing import TYPE_CHECKING

from prelight import _prelight
from prelight._prelight import *

if TYPE_CHECKING:
    from typing import Any

    from numpy.typing import DTypeLike, NDArray

__version__: str = _prelight.version()


def render(scene: Scene | World, camera: Camera | str | int | None = None, *, renderer: str = "light-prepass",
           device: Device | None = None, view: str = "final", dtype: DTypeLike = "float32",
           **options: Any) -> NDArray[Any]:
    """One picture: (height, width, 3), read-only.

    camera, view and dtype are those of Renderer.render() and Renderer.read(); renderer, device and options (width,
    height, settings, ...) those of Renderer(). For many pictures keep a Renderer.
    """
    world = scene.resolve() if isinstance(scene, Scene) else scene
    views = list(options.pop("views", ()))
    if view != "final" and view not in views:
        views.append(view)
    with Renderer(renderer, device, views=views, **options) as made:
        made.set_world(world)
        made.render(camera)
        return made.read(view, dtype)
