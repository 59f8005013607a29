"""Builds the module with CMake (python/CMakeLists.txt): for `pip install .`; pyproject.toml has the rest."""
import os
import pathlib
import re
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent
BUILD = pathlib.Path(os.environ.get("PRELIGHT_BUILD", ROOT / "build" / "python"))


def version():
    text = (ROOT / "include/prelight/version.hpp").read_text()
    parts = ("MAJOR", "MINOR", "PATCH")
    return ".".join(re.search(rf"^#define PRELIGHT_VERSION_{part} (\d+)$", text, re.M)[1] for part in parts)


class CMakeBuild(build_ext):
    def build_extension(self, extension):
        build = BUILD / f"cmake-{sys.implementation.cache_tag}"
        folder = pathlib.Path(self.get_ext_fullpath(extension.name)).resolve().parent.parent
        options = [f"-DPython_EXECUTABLE={sys.executable}", "-DCMAKE_BUILD_TYPE=Release"]
        try:
            import pybind11
            options.append(f"-Dpybind11_DIR={pybind11.get_cmake_dir()}")
        except ImportError:  # without Python's package of it CMake looks for itself
            pass
        options += os.environ.get("CMAKE_ARGS", "").split()
        subprocess.run(["cmake", "-S", ROOT / "python", "-B", build, *options], check=True)
        subprocess.run(["cmake", "--build", build, "--parallel"], check=True)
        subprocess.run(["cmake", "--install", build, "--prefix", folder], check=True)


BUILD.mkdir(parents=True, exist_ok=True)
setup(version=version(),
      package_dir={"": "python"},
      packages=["prelight"],
      package_data={"prelight": ["py.typed", "*.pyi"]},
      ext_modules=[Extension("prelight._prelight", [])],
      cmdclass={"build_ext": CMakeBuild},
      options={"build": {"build_base": str(BUILD)}, "egg_info": {"egg_base": str(BUILD)}},
      zip_safe=False)
