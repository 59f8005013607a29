#!/usr/bin/env python3
"""Prints the numbers that lighting_test.cpp expects: the equations of docs/lighting-model.md once
more, for one point, in another language and in glTF's own form (D, G, F and the 4·NL·NV divisor).
No test runs it; run it by hand when the model changes."""
from math import pi, sqrt, inf


class V(tuple):
    def __new__(cls, *x):
        return super().__new__(cls, x)

    def __add__(self, o):
        return V(*(a + b for a, b in zip(self, vec(o))))

    def __sub__(self, o):
        return V(*(a - b for a, b in zip(self, vec(o))))

    def __mul__(self, o):
        return V(*(a * b for a, b in zip(self, vec(o))))

    __radd__ = __add__
    __rmul__ = __mul__

    def __rsub__(self, o):
        return vec(o) - self


def vec(x):
    return x if isinstance(x, V) else V(x, x, x)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def unit(a):
    return a * (1 / sqrt(dot(a, a)))


def lum(c):
    return dot(c, (0.2126, 0.7152, 0.0722))


# position, colour, intensity, range, shininess; the surface is at the origin.
LIGHTS = [(V(0.5, 1, 1.5), V(1, 0.8, 0.6), 10, 5, 0.02),
          (V(-1.2, -0.4, 0.8), V(0.2, 0.5, 1), 6, inf, 0.01)]
N, VIEW = V(0, 0, 1), unit(V(3, 0, 1))
BASE, METALLIC, ROUGHNESS, AMBIENT = V(0.8, 0.4, 0.2), 0.3, 0.4, V(0.1, 0.2, 0.3)

a = ROUGHNESS ** 2
c = BASE * (1 - METALLIC)
f0 = vec(0.04) * (1 - METALLIC) + BASE * METALLIC
nv = dot(N, VIEW)


def show(name, value):
    print(f"{name:28}", ", ".join(f"{x:.9f}" for x in value))


def incident():
    for position, colour, intensity, reach, shininess in LIGHTS:
        d = sqrt(dot(position, position))
        window = max(0, 1 - (d / reach) ** 4)
        yield unit(position), colour * (intensity * window / d ** 2), shininess


def g1(x):
    return 2 * x / (x + sqrt(a * a + (1 - a * a) * x * x))


def schlick(s):
    return f0 + (1 - f0) * s


E, S, full = vec(0), vec(0), vec(0)
e_weight = s_weight = 0
for to_light, radiance, _ in incident():
    h = unit(to_light + VIEW)
    nl, nh, s = dot(N, to_light), dot(N, h), (1 - dot(VIEW, h)) ** 5
    d = a * a / (pi * (nh * nh * (a * a - 1) + 1) ** 2)
    e = radiance * nl
    spec = e * (d * g1(nl) * g1(nv) / (4 * nl * nv))
    E, S = E + e, S + spec
    e_weight += lum(e) * s
    s_weight += lum(spec) * s
    full += c * (1 / pi) * (1 - schlick(s)) * e + schlick(s) * spec


def split(diffuse_light, sd, ss, specular_light):
    return c * (1 / pi) * (1 - schlick(sd)) * diffuse_light + schlick(ss) * specular_light


at_nv = (1 - nv) ** 5
lit = E + pi * AMBIENT
show("full", full)
show("weighted", split(E, e_weight / lum(E), s_weight / lum(S), S))
show("nv", split(E, at_nv, at_nv, S))
show("mono", split(E, at_nv, at_nv, vec(lum(S))))
show("ambient, material", AMBIENT * (c + f0))
show("full, ambient light", full + c * AMBIENT * (1 - f0))
show("weighted, ambient light", split(lit, e_weight / lum(lit), s_weight / lum(S), S))
show("nv, ambient light", split(lit, at_nv, at_nv, S))
for gate in ("factor", "step"):
    for vector in ("half", "reflection"):
        diffuse, specular = vec(0), vec(0)
        for to_light, radiance, shininess in incident():
            nl = dot(N, to_light)
            x = dot(N, unit(to_light + VIEW)) if vector == "half" else \
                max(0, dot(2 * nl * N - to_light, VIEW))
            diffuse += radiance * nl
            specular += radiance * ((nl if gate == "factor" else 1) *
                                    x ** (shininess * (2 / (a * a) - 2)))
        show(f"phong {gate} {vector}", c * diffuse + f0 * specular)
        show(f"phong {gate} {vector} mono", c * diffuse + f0 * lum(specular))
show("phong ambient, light", c * AMBIENT)
# The ways of equations 8.5.4 to 8.5.7, with ambient light as a light: only the fifth channel has none.
MN, EXPOSURE = 2 / (a * a) - 2, 2 ** -1.35
diffuse = AMBIENT
channel4 = channel5 = 0
for to_light, radiance, shininess in incident():
    nl = dot(N, to_light)
    diffuse += radiance * nl
    channel4 += lum(radiance) * nl * dot(N, unit(to_light + VIEW)) ** shininess
    channel5 += lum(radiance) * nl
for way, base, back in (("luminance", channel4 / lum(diffuse), lum(diffuse)),
                        ("fifth", channel4 / channel5, channel5),
                        ("bent", channel4 * EXPOSURE, 1 / EXPOSURE)):
    show(f"phong {way}", c * diffuse + f0 * (min(base, 1) ** MN * back))
diffuse, specular, full = vec(0), vec(0), vec(0)
for to_light, radiance, shininess in incident():
    h = unit(to_light + VIEW)
    nl, nh = dot(N, to_light), dot(N, h)
    d = a * a / (pi * (nh * nh * (a * a - 1) + 1) ** 2)
    f = lum(f0) + (1 - lum(f0)) * (1 - dot(VIEW, h)) ** 5
    full += radiance * nl * (c * ((1 - f) / pi) + f * (d * g1(nl) * g1(nv) / (4 * nl * nv)))
    diffuse += radiance * nl
    specular += radiance * (nl * nh ** (shininess * (2 / (a * a) - 2)))
show("full, grey reflectance", full)
show("phong, grey reflectance", c * diffuse + lum(f0) * specular)
