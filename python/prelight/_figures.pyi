# Types of what Renderer.stats holds: a part of _prelight.pyi, and no module of its own.
from typing import Final

class Spread:
    min: Final[float]
    median: Final[float]
    max: Final[float]

class PassStats:
    name: Final[str]
    gpu_ms: Final[Spread]
    cpu_ms: Final[Spread | None]
    bytes_read: Final[int]
    bytes_written: Final[int]

class SettingChoice:
    key: Final[str]
    asked: Final[str]
    taken: Final[str]
    why: Final[str]

class CreatedObjects:
    allocations: Final[int]
    pipelines: Final[int]
    buffers: Final[int]
    images: Final[int]
    descriptor_pools: Final[int]

class HostTimes:
    lights: Final[Spread]
    culling: Final[Spread]
    objects: Final[Spread]
    record: Final[Spread]

class ShadowStats:
    budget: Final[int]
    texels: Final[int]
    lights: Final[int]
    lights_reduced: Final[int]
    lights_without: Final[int]
    smallest: Final[int]
    largest: Final[int]
    tiles_drawn: Final[int]
    tiles_reused: Final[int]
    casters_drawn: Final[int]

class LightBufferStats:
    diffuse_scale: Final[float]
    specular_scale: Final[float]
    clipped_pixels: Final[int]

class InferredStats:
    layers: Final[int]
    layers_without_slot: Final[int]
    unmatched_pixels: Final[int]

class LayerStats:
    most: Final[int]
    mean: Final[float]
    exact: Final[int]
    approximate: Final[int]

class Stats:
    device: Final[str]
    driver: Final[str]
    settings: Final[dict[str, str]]
    choices: Final[list[SettingChoice]]
    shading: Final[str]
    notes: Final[list[str]]
    lights: Final[int]
    triangles: Final[int]
    triangles_drawn: Final[int]
    triangles_skipped: Final[int | None]
    draws: Final[int]
    draws_skipped: Final[int | None]
    frames: Final[int]
    wall_ms: Final[Spread]
    cpu_ms: Final[Spread]
    gpu_ms: Final[Spread]
    passes: Final[list[PassStats]]
    attachment_bytes: Final[int]
    attachment_bytes_unshared: Final[int]
    device_bytes: Final[int]
    device_bytes_peak: Final[int]
    updated_bytes: Final[int]
    frame_bytes: Final[int]
    created: Final[CreatedObjects]
    host_ms: Final[HostTimes | None]
    shadows: Final[ShadowStats | None]
    light_buffer: Final[LightBufferStats | None]
    inferred: Final[InferredStats | None]
    layers: Final[LayerStats | None]
    pairs_counted: Final[bool]
    pairs_evaluated: Final[int]
    pairs_contributing: Final[int]
