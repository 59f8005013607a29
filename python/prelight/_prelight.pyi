# Types of the compiled module; its docstrings say units, spaces, shapes and errors. A test holds both together.
# Final: read-only. _Array, _Word: what is read is an array or a member, any array-like or word may be assigned.
import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from enum import StrEnum
from typing import Any, Final, Generic, TypeAlias, TypeVar, overload

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from prelight._figures import *

T = TypeVar("T")
Path: TypeAlias = str | os.PathLike[str]
Floats: TypeAlias = NDArray[np.float32]
Doubles: TypeAlias = NDArray[np.float64]
PictureLike: TypeAlias = Image | NDArray[Any]

class _Array(Generic[T]):
    def __get__(self, instance: object, owner: object) -> T: ...
    def __set__(self, instance: object, value: ArrayLike) -> None: ...

class _Word(Generic[T]):
    def __get__(self, instance: object, owner: object) -> T: ...
    def __set__(self, instance: object, value: str) -> None: ...

class _List(Generic[T]):
    def __len__(self) -> int: ...
    @overload
    def __getitem__(self, index: int) -> T: ...
    @overload
    def __getitem__(self, index: slice) -> list[T]: ...
    def __iter__(self) -> Iterator[T]: ...

class _EditableList(_List[T]):
    def __setitem__(self, index: int, value: T) -> None: ...
    def __delitem__(self, index: int) -> None: ...
    def append(self, value: T) -> T: ...
    def extend(self, values: Iterable[T]) -> None: ...
    def clear(self) -> None: ...

class Error(RuntimeError): ...
class DeviceLost(Error): ...
class UsageError(Error, ValueError): ...

class LightKind(StrEnum):
    DIRECTIONAL = "directional"
    POINT = "point"
    SPOT = "spot"

class Falloff(StrEnum):
    GLTF = "gltf"
    LINEAR = "linear"
    QUADRATIC = "quadratic"

class ProjectionKind(StrEnum):
    PERSPECTIVE = "perspective"
    ORTHOGRAPHIC = "orthographic"

class AlphaMode(StrEnum):
    OPAQUE = "opaque"
    MASK = "mask"
    BLEND = "blend"

class Shading(StrEnum):
    PHONG = "phong"
    GGX = "ggx"

class Tonemap(StrEnum):
    PBR_NEUTRAL = "pbr-neutral"
    ACES = "aces"
    NONE = "none"

def version() -> str: ...

# Pictures.

class Image:
    width: Final[int]
    height: Final[int]

class Comparison:
    psnr: Final[float]
    flip: Final[float]
    off_share: Final[float]
    block: Final[float]
    block_x: Final[int]
    block_y: Final[int]
    left_out_share: Final[float]

def save_png(picture: PictureLike, path: Path) -> None: ...
def save_exr(picture: PictureLike, path: Path) -> None: ...
def load_png(path: Path) -> Floats: ...
def load_exr(path: Path) -> Floats: ...
def load_hdr(path: Path) -> Floats: ...
def tonemap(linear: PictureLike, curve: str = ...) -> Floats: ...
def auto_exposure(linear: PictureLike) -> float | None: ...
def compare(picture: PictureLike, reference: PictureLike, left_out: ArrayLike | None = None) -> Comparison: ...
def flip_map(picture: PictureLike, reference: PictureLike, pixels_per_degree: float = 67.0) -> Floats: ...

# Cameras and lights.

class Camera:
    def __init__(self, kind: str = ..., *, position: ArrayLike = ..., axes: ArrayLike = ..., yfov: float = 0.87,
                 ymag: float = 1.0, znear: float = 0.1, zfar: float = ..., name: str = "") -> None: ...
    @staticmethod
    def look_at(eye: ArrayLike, target: ArrayLike, up: ArrayLike = ..., *, kind: str = ..., yfov: float = 0.87,
                ymag: float = 1.0, znear: float = 0.1, zfar: float = ..., name: str = "") -> Camera: ...
    name: str
    kind: _Word[ProjectionKind]
    yfov: float
    ymag: float
    znear: float
    zfar: float
    position: _Array[Doubles]
    axes: _Array[Doubles]

class CameraList(_EditableList[Camera]): ...

class Light:
    def __init__(self, kind: str = ..., *, position: ArrayLike = ..., direction: ArrayLike = ...,
                 colour: ArrayLike = ..., intensity: float = 1.0, range: float = ..., inner_cone: float = 0.0,
                 outer_cone: float = ..., shininess: float = 1.0, falloff: str = ..., casts_shadow: bool = True,
                 size: float = ..., name: str = "") -> None: ...
    def set_profile(self, path: Path, candela: bool = False) -> None: ...
    name: str
    kind: _Word[LightKind]
    position: _Array[Doubles]
    direction: _Array[Doubles]
    up: _Array[Doubles]
    colour: _Array[Floats]
    intensity: float
    range: float
    inner_cone: float
    outer_cone: float
    shininess: float
    falloff: _Word[Falloff]
    casts_shadow: bool
    size: float

class LightList(_EditableList[Light]):
    positions: _Array[Doubles]
    directions: _Array[Doubles]
    colours: _Array[Floats]
    intensities: _Array[Floats]
    ranges: _Array[Floats]

# Scenes and worlds.

class Material:
    def __init__(self, name: str = "", *, base_colour: ArrayLike = ..., metallic: float = 0.0, roughness: float = 1.0,
                 emissive: ArrayLike = ..., alpha_mode: str = ..., alpha_cutoff: float = 0.5,
                 double_sided: bool = False, unlit: bool = False) -> None: ...
    name: str
    base_colour: _Array[Floats]
    metallic: float
    roughness: float
    emissive: _Array[Floats]
    normal_scale: float
    occlusion_strength: float
    alpha_mode: _Word[AlphaMode]
    alpha_cutoff: float
    double_sided: bool
    unlit: bool
    base_colour_texture: int | None
    metallic_roughness_texture: int | None
    normal_texture: int | None
    occlusion_texture: int | None
    emissive_texture: int | None
    shader: Final[str | None]
    parameters: dict[str, Any]

class MaterialList(_List[Material]): ...

class Primitive:
    positions: Final[Floats]
    normals: Final[Floats]
    tangents: Final[Floats | None]
    texcoords: Final[Floats | None]
    colours: Final[Floats | None]
    indices: Final[NDArray[np.uint32]]
    material: Final[int]

class Mesh:
    name: str
    index: Final[int]
    primitives: Final[list[Primitive]]

class MeshList(_List[Mesh]): ...

class Node:
    name: str
    visible: bool
    matrix: _Array[Doubles]
    index: Final[int]
    mesh: Final[int | None]
    children: Final[list[int]]

class NodeList(_List[Node]): ...

class Instance:
    mesh: Final[int]
    node: Final[int]
    visible: bool
    transform: _Array[Doubles]

class InstanceList(_List[Instance]): ...

class World:
    @property
    def lights(self) -> LightList: ...
    @lights.setter
    def lights(self, lights: Iterable[Light]) -> None: ...
    @property
    def cameras(self) -> CameraList: ...
    @cameras.setter
    def cameras(self, cameras: Iterable[Camera]) -> None: ...
    instances: Final[InstanceList]
    ambient: _Array[Floats]
    bounds: Final[Doubles]
    triangles: Final[int]
    warnings: Final[list[str]]
    def frame(self, aspect: float, azimuth: float = 20.0, elevation: float = 15.0, fit: float = 0.8) -> Camera: ...
    def scatter_lights(self, count: int, seed: int = 1) -> None: ...
    def rotate_lights(self, centre: ArrayLike, angle: float) -> None: ...
    def randomize_lights(self, seed: int = 1) -> None: ...

class Scene:
    def __init__(self, name: str = "scene") -> None: ...
    name: Final[str]
    warnings: Final[list[str]]
    materials: Final[MaterialList]
    meshes: Final[MeshList]
    nodes: Final[NodeList]
    images: Final[list[str]]
    scenes: Final[list[str]]
    animations: Final[list[str]]
    is_lit: Final[bool]
    has_camera: Final[bool]
    ambient: _Array[Floats]
    environment: Final[str | None]
    def set_environment(self, environment: Path | PictureLike | None, *, intensity: float = 1.0, rotation: float = 0.0,
                        background: bool = True) -> None: ...
    def assign_shader(self, material: str, shader: Path) -> None: ...
    def resolve(self, scene: str | int | None = None, *, time: float | None = None, interval: float = ...,
                animation: str | int | None = None) -> World: ...
    def save_glb(self, path: Path) -> None: ...
    def add_material(self, material: Material) -> Material: ...
    def add_image(self, pixels: ArrayLike, name: str = "") -> int: ...
    def add_mesh(self, positions: ArrayLike, indices: ArrayLike, *, normals: ArrayLike | None = None,
                 texcoords: ArrayLike | None = None, colours: ArrayLike | None = None,
                 tangents: ArrayLike | None = None, material: Material | None = None, name: str = "") -> Mesh: ...
    def add_node(self, mesh: Mesh | None = None, *, matrix: ArrayLike | None = None, parent: Node | None = None,
                 name: str = "", visible: bool = True) -> Node: ...
    def add_light(self, light: Light, *, parent: Node | None = None) -> Node: ...
    def add_camera(self, camera: Camera, *, parent: Node | None = None) -> Node: ...

class BuiltinScene:
    name: Final[str]
    description: Final[str]
    default_lights: Final[int]

def builtin_scenes() -> list[BuiltinScene]: ...
def make_scene(name: str, lights: int | None = None, seed: int = 1) -> Scene: ...
def load_gltf(path: Path, *, strict: bool = False, memory_limit: int = 0) -> Scene: ...
def material_shaders() -> dict[str, str]: ...

# Devices and settings.

class DeviceInfo:
    index: Final[int]
    name: Final[str]
    driver: Final[str]
    type: Final[str]
    usable: Final[bool]
    why_not: Final[str]
    features: Final[list[str]]
    missing: Final[list[str]]
    chosen: Final[bool]

def devices() -> list[DeviceInfo]: ...

class Device:
    def __init__(self, select: str = "auto", *, validate: bool = False) -> None: ...
    name: Final[str]
    driver: Final[str]
    validation_messages: Final[list[str]]
    def has_samples(self, samples: int) -> bool: ...

class SettingNeed:
    key: Final[str]
    values: Final[list[str]]
    or_view: Final[str]

class SettingInfo:
    key: Final[str]
    values: Final[list[str]]
    default_value: Final[str]
    description: Final[str]
    needs: Final[list[SettingNeed]]

class RendererInfo:
    name: Final[str]
    description: Final[str]
    settings: Final[list[SettingInfo]]
    views: Final[list[str]]
    presets: Final[list[str]]
    preset_settings: Final[dict[str, dict[str, str]]]
    needs_device: Final[bool]

def renderers() -> list[RendererInfo]: ...

# Drawing.

class ReferencePicture:
    linear: Final[Floats]
    instance: Final[NDArray[np.uint32]]
    primitive: Final[NDArray[np.uint32]]
    position: Final[Doubles]
    normal: Final[Doubles]
    depth: Final[Doubles]
    left_out: Final[NDArray[np.bool_]]
    def display(self, curve: str = ...) -> Floats: ...

def render_reference(world: World, camera: Camera | str | int | None = None, *, width: int = 1280, height: int = 720,
                     exposure: float = 0.0, shading: str = ..., settings: Mapping[str, str | float] = ...,
                     msaa: int = 1) -> ReferencePicture: ...

class Renderer:
    def __init__(self, name: str = "light-prepass", device: Device | None = None, *, width: int = 1280,
                 height: int = 720, shading: str | None = None, tonemap: str = ..., exposure: float = 0.0,
                 msaa: int = 1, preset: str = "", settings: Mapping[str, str | float] = ...,
                 views: Sequence[str] = ..., count_pairs: bool = False, pass_cpu: bool = False) -> None: ...
    def set_world(self, world: World) -> None: ...
    def set_lights(self, lights: Iterable[Light]) -> None: ...
    def resize(self, width: int, height: int) -> None: ...
    def render(self, camera: Camera | str | int | None = None, frames: int = 1,
               progress: Callable[[int, int], object] | None = None) -> None: ...
    def read(self, view: str = "final", dtype: DTypeLike = "float32") -> NDArray[Any]: ...
    def reference(self) -> ReferencePicture: ...
    def close(self) -> None: ...
    def __enter__(self) -> Renderer: ...
    def __exit__(self, *args: object) -> None: ...
    stats: Final[Stats]
    max_lights: Final[int]
    name: Final[str]
    device: Final[Device | None]
    width: Final[int]
    height: Final[int]
