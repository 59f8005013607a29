#!/usr/bin/env python3
"""Holds the code to one rule: what one operating system alone has stands in src/platform.

Elsewhere in src/, apps/, include/, python/ and tools/, and in the headers of src/platform, code includes C++'s own headers, the project's, and those of the
libraries below, and neither calls what only POSIX has, nor names its paths, nor asks which system it is built for.
Prints each line that does, and fails when there is one.
"""
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FOLDERS = ("src", "apps", "include", "python", "tools")
# Without <csignal>, whose signals are POSIX's.
STANDARD = set("""
    algorithm any array atomic barrier bit bitset cassert ccomplex cctype cerrno cfenv cfloat charconv chrono cinttypes climits
    clocale cmath codecvt compare complex concepts condition_variable coroutine csetjmp cstdarg cstddef cstdint cstdio
    cstdlib cstring ctime cuchar cwchar cwctype deque exception execution filesystem format forward_list fstream functional
    future initializer_list iomanip ios iosfwd iostream istream iterator latch limits list locale map memory memory_resource
    mutex new numbers numeric optional ostream queue random ranges ratio regex scoped_allocator semaphore set shared_mutex
    source_location span sstream stack stdexcept stop_token streambuf string string_view strstream syncstream system_error
    thread tuple type_traits typeindex typeinfo unordered_map unordered_set utility valarray variant vector version
    """.split())
LIBRARIES = ("CLI", "GLFW", "backends", "draco", "embree3", "fmt", "glm", "glslang", "half.h", "imgui.h", "imgui_impl_glfw.h", "jerror.h",
             "jpeglib.h", "libdeflate.h", "meshoptimizer.h", "nlohmann", "pybind11", "shaderc", "simdjson.h", "spirv-tools",
             "spng.h", "vulkan", "webp")
OWN = ("prelight", "shared", *(path.name for path in (ROOT / "src").iterdir() if path.is_dir()))
INCLUDE = re.compile(r"^\s*#\s*include\s*<([^>]+)>")
QUOTED = re.compile(r'^\s*#\s*include\s*"((?:sys/)?(?:unistd|fcntl|dlfcn|pthread|poll|signal|termios|mman|stat|wait|types)\.h)"')
# What the standard headers have besides the standard where the system is POSIX, and its paths and names.
CALL = re.compile(r"\b(setenv|unsetenv|putenv|mkstemp|mkdtemp|fileno|fdopen|popen|pclose|isatty|localtime_r|gmtime_r|"
                  r"clock_gettime|strerror_r|strsignal|getpid|gettid)\s*\(")
ENVIRONMENT = re.compile(r"\b(environ)\b")
PATH = re.compile(r'"/(proc|dev|sys|tmp|etc|usr)/')
SYSTEM = re.compile(r"^\s*#\s*(?:el)?if.*\b(__linux__|__gnu_linux__|__unix__|__GLIBC__|__APPLE__|_WIN32|_WIN64|_MSC_VER|__ANDROID__)\b")


def is_portable(header):
    first = header.split("/")[0]
    if "/" in header and first in OWN:
        return True
    return header in STANDARD or first in LIBRARIES or header.startswith("Imf")


def findings(text):
    """(line number, what is wrong there) of a file's text."""
    for number, line in enumerate(text.splitlines(), 1):
        include = INCLUDE.match(line)
        if include and not is_portable(include[1]):
            yield number, f"includes <{include[1]}>"
        code = re.sub(r"(?<!:)//.*", "", line)
        for pattern, what in ((QUOTED, "includes {}"), (ENVIRONMENT, "names {}"), (CALL, "calls {}()"), (PATH, "names a path in /{}"), (SYSTEM, "asks for {}")):
            if found := pattern.search(code):
                yield number, what.format(found[1])


def main():
    checked, bad = 0, 0
    for folder in FOLDERS:
        for file in sorted((ROOT / folder).rglob("*")):
            inner = file.relative_to(ROOT)
            hidden = inner.parts[:2] == ("src", "platform") and file.suffix == ".cpp"
            if file.suffix not in (".cpp", ".hpp", ".h") or hidden:
                continue
            checked += 1
            for line, what in findings(file.read_text()):
                print(f"{inner}:{line}: {what}: what one system alone has stands in the .cpp files of src/platform")
                bad += 1
    if not checked:
        sys.exit("no source file was found")
    sys.exit(bad != 0)


main()
