# cmake -P embed_texts.cmake OUT.cpp HEADER FUNCTION STRIP FILE…
# Writes FUNCTION(), declared in HEADER: a list of {name, text}. A name is the file's path without the
# folder STRIP, and without ".glsl" where it lies in that folder itself.
math(EXPR last "${CMAKE_ARGC} - 1")
set(table "")
foreach(i RANGE 7 ${last})
    set(file "${CMAKE_ARGV${i}}")
    file(READ "${file}" text)
    file(RELATIVE_PATH name "${CMAKE_ARGV6}" "${file}")
    string(REGEX REPLACE "^([^/]*)\\.glsl$" "\\1" name "${name}")
    string(APPEND table "    {\"${name}\", R\"PRELIGHT(${text})PRELIGHT\"},\n")
endforeach()
string(REGEX MATCH "^(.*)::([a-z_]+)$" matched "${CMAKE_ARGV5}")
file(WRITE "${CMAKE_ARGV3}" "// Written by cmake/embed_texts.cmake.
#include <${CMAKE_ARGV4}>

namespace ${CMAKE_MATCH_1} {
namespace {
const std::pair<std::string_view, std::string_view> table[] = {
${table}};
} // namespace

std::span<const std::pair<std::string_view, std::string_view>> ${CMAKE_MATCH_2}() { return table; }
} // namespace ${CMAKE_MATCH_1}
")
