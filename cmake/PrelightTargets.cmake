# prelight_target(NAME FOLDER… [EXCEPT FOLDER]): one static library of every .cpp below the folders, with the
# project's warnings. A new source file needs no edit of a build file.
# How this project compiles, which is nobody else's business: prelight_flags for all, prelight_options for the library and
# what looks into it.
add_library(prelight_flags INTERFACE)
target_compile_options(prelight_flags INTERFACE
    -Wall -Wextra -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Wcast-qual -Wunused
    -Woverloaded-virtual -Wno-missing-field-initializers)
# Some libraries ask for it: given to all, so that all can share precompiled headers.
target_compile_options(prelight_flags INTERFACE -pthread)
if(PROJECT_IS_TOP_LEVEL) # another compiler's new warning is no reason that somebody's project does not build
    target_compile_options(prelight_flags INTERFACE -Werror)
endif()
if(PRELIGHT_SANITIZE)
    target_compile_options(prelight_flags INTERFACE -fsanitize=${PRELIGHT_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(prelight_flags INTERFACE -fsanitize=${PRELIGHT_SANITIZE})
endif()
add_library(prelight_options INTERFACE)
target_link_libraries(prelight_options INTERFACE prelight_flags)
target_compile_definitions(prelight_options INTERFACE GLM_FORCE_DEPTH_ZERO_TO_ONE GLM_ENABLE_EXPERIMENTAL)

# What most files include of other people's headers, parsed once for all targets with the same flags. None of the project's own:
# a change in one would compile everything again. CMAKE_DISABLE_PRECOMPILE_HEADERS=ON tells whether each
# file still includes what it uses.
set(PRELIGHT_PRECOMPILED <algorithm> <array> <bit> <chrono> <cmath> <cstdint> <cstdlib> <cstring> <filesystem>
    <fstream> <functional> <limits> <map> <memory> <numbers> <optional> <random> <set> <span> <string> <string_view>
    <thread> <tuple> <unordered_map> <utility> <variant> <vector>
    <fmt/format.h> <fmt/ranges.h>
    <glm/glm.hpp> <glm/gtc/quaternion.hpp> <glm/gtc/type_ptr.hpp> <glm/gtc/constants.hpp> <glm/gtc/packing.hpp>
    <glm/ext/matrix_transform.hpp> <glm/ext/matrix_clip_space.hpp>)
# GCC 12 warns of its own std::string (bug 105329) where that comes from a precompiled header.
target_compile_options(prelight_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict$<SEMICOLON>-Wno-array-bounds>)
# Warns of braces left out around a struct's only member, which GCC has no warning for.
target_compile_options(prelight_flags INTERFACE $<$<CXX_COMPILER_ID:Clang,AppleClang>:-Wno-missing-braces>)
if(CCACHE)
    add_compile_options(-fpch-preprocess) # else ccache does not know what a precompiled header holds
endif()

# Most of a file's compile time is the same headers' templates again: the files of a folder are compiled together. Names that a
# file keeps for itself must then differ from those of the other files in its folder, and an error says where they don't.
set(unity_default ON) # who only uses the library compiles it once
if(PROJECT_IS_TOP_LEVEL)
    set(unity_default OFF)
endif()
option(PRELIGHT_UNITY "Compile the files of a folder together: 3 times less to compile, but all of a folder after each change"
       ${unity_default})
if(PRELIGHT_UNITY)
    target_compile_options(prelight_flags INTERFACE -Wno-shadow) # sees another file's names
endif()

# prelight_unity(TARGET [MOST]): a folder's files together, or, where they are very many, MOST of them at a time.
function(prelight_unity TARGET)
    if(NOT PRELIGHT_UNITY)
        return()
    endif()
    if(ARGC GREATER 1)
        set_target_properties(${TARGET} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${ARGV1})
        return()
    endif()
    get_target_property(sources ${TARGET} SOURCES)
    foreach(source IN LISTS sources)
        cmake_path(GET source PARENT_PATH folder)
        cmake_path(RELATIVE_PATH folder BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
        string(MAKE_C_IDENTIFIER ${folder} group)
        set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group})
    endforeach()
    set_target_properties(${TARGET} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()

# prelight_sources(OUT FOLDER… [EXCEPT FOLDER]): every .cpp below the folders.
function(prelight_sources OUT)
    cmake_parse_arguments(PARSE_ARGV 1 given "" EXCEPT "")
    set(all)
    foreach(folder IN LISTS given_UNPARSED_ARGUMENTS)
        file(GLOB_RECURSE found CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.cpp)
        list(APPEND all ${found})
    endforeach()
    if(given_EXCEPT)
        file(GLOB_RECURSE left_out CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${given_EXCEPT}/*.cpp)
        list(REMOVE_ITEM all ${left_out})
    endif()
    set(${OUT} ${all} PARENT_SCOPE)
endfunction()

function(prelight_target NAME)
    prelight_sources(sources ${ARGN})
    add_library(${NAME} STATIC ${sources})
    target_include_directories(${NAME} PUBLIC ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/src
                                              ${PROJECT_SOURCE_DIR}/shaders)
    target_link_libraries(${NAME} PUBLIC prelight_options)
    prelight_library_flags(${NAME})
    if(NOT TARGET prelight_precompiled)
        prelight_precompile(prelight_precompiled)
        prelight_library_flags(prelight_precompiled)
    endif()
    target_precompile_headers(${NAME} REUSE_FROM prelight_precompiled)
    prelight_unity(${NAME})
endfunction()

# Compiled once for the archive and the shared library. Only what PRELIGHT_API marks can be seen from outside of the
# latter, and nobody replaces it: calls within the library go straight there, as in a program.
function(prelight_library_flags TARGET)
    set_target_properties(${TARGET} PROPERTIES POSITION_INDEPENDENT_CODE ON
        CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
    target_compile_options(${TARGET} PRIVATE -fno-semantic-interposition)
endfunction()

# prelight_precompile(NAME HEADER…): a target of nothing but precompiled headers, these beside PRELIGHT_PRECOMPILED, for
# target_precompile_headers(… REUSE_FROM NAME) of targets with the same flags.
function(prelight_precompile NAME)
    set(source ${CMAKE_CURRENT_BINARY_DIR}/${NAME}.cpp)
    file(CONFIGURE OUTPUT ${source} CONTENT "")
    add_library(${NAME} OBJECT ${source})
    target_link_libraries(${NAME} PRIVATE prelight_options prelight::glm prelight::fmt)
    target_precompile_headers(${NAME} PRIVATE ${PRELIGHT_PRECOMPILED} ${ARGN})
endfunction()
