#!/usr/bin/env python3
"""How far two architectures are from the truth, over the number of lights.

    python3 examples/python/error_over_lights.py [-o FILE.png] [--size WxH] [--counts N,N,...]

Renders the scene `lights` with each number of lights, casts the same picture by rays, prints a table and plots it. The
light pre-pass has a packed light buffer here, half floats that every light is added to; deferred shading has its own.
"""
from __future__ import annotations

import argparse

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import prelight

ARCHITECTURES: dict[str, dict[str, str]] = {
    "light-prepass": {"light-buffer": "packed-rgba16f", "model": "mono"},
    "deferred": {},
}


def errors(name: str, settings: dict[str, str], counts: list[int], size: tuple[int, int]) -> list[prelight.Comparison]:
    width, height = size
    found = []
    with prelight.Renderer(name, width=width, height=height, settings=settings, views=["linear"]) as renderer:
        for count in counts:
            renderer.set_world(prelight.make_scene("lights", lights=count).resolve())
            renderer.render()
            truth = renderer.reference()  # the same camera, and the same form of the lighting model
            found.append(prelight.compare(renderer.read("linear"), truth.linear, truth.left_out))
            print(f"{name:14} {count:5} lights: PSNR {found[-1].psnr:6.2f} dB, FLIP {found[-1].flip:.5f}")
    return found


def main() -> None:
    parser = argparse.ArgumentParser(description="PSNR and FLIP against the reference, over the number of lights")
    parser.add_argument("-o", "--output", default="error_over_lights.png")
    parser.add_argument("--size", default="160x90", metavar="WxH")
    parser.add_argument("--counts", default="16,64,256,1024", metavar="N,N,...")
    given = parser.parse_args()
    width, height = map(int, given.size.split("x"))
    counts = [int(count) for count in given.counts.split(",")]

    figure, (above, below) = plt.subplots(2, sharex=True, figsize=(7, 6))
    for name, settings in ARCHITECTURES.items():
        found = errors(name, settings, counts, (width, height))
        above.plot(counts, [each.psnr for each in found], "o-", label=name)
        below.plot(counts, [each.flip for each in found], "o-", label=name)
    above.set(ylabel="PSNR (dB), more is better", xscale="log")
    below.set(ylabel="mean FLIP, less is better", xlabel="lights")
    below.set_xticks(counts, [str(count) for count in counts])
    above.legend()
    figure.savefig(given.output, dpi=120)


if __name__ == "__main__":
    main()
