# prelight_shaders(TARGET): compiles every shader below shaders/ with glslc, and the variants that
# shaders/variants.cmake lists, and embeds the SPIR-V in TARGET for gpu::find_shader(name).
include(${CMAKE_SOURCE_DIR}/shaders/variants.cmake)

function(prelight_shaders TARGET)
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/shaders/*.vert
         ${CMAKE_SOURCE_DIR}/shaders/*.frag ${CMAKE_SOURCE_DIR}/shaders/*.comp)
    set(jobs ${PRELIGHT_SHADER_VARIANTS})
    foreach(source IN LISTS sources)
        cmake_path(GET source FILENAME name)
        list(APPEND jobs "${name}|${name}|")
    endforeach()
    set(out ${CMAKE_CURRENT_BINARY_DIR}/shaders)
    file(MAKE_DIRECTORY ${out})
    set(table "")
    set(includes "")
    set(outputs "")
    foreach(job IN LISTS jobs)
        string(REPLACE "|" ";" parts "${job}")
        list(GET parts 0 name)
        list(GET parts 1 source)
        list(GET parts 2 defines)
        separate_arguments(defines)
        add_custom_command(OUTPUT ${out}/${name}.inc
            COMMAND Vulkan::glslc --target-env=vulkan1.3 -O -Werror -mfmt=num ${defines}
                    -I ${CMAKE_SOURCE_DIR}/shaders -MD -MF ${out}/${name}.d -o ${out}/${name}.inc
                    ${CMAKE_SOURCE_DIR}/shaders/${source}
            DEPENDS ${CMAKE_SOURCE_DIR}/shaders/${source} DEPFILE ${out}/${name}.d
            COMMENT "Shader ${name}" VERBATIM)
        list(APPEND outputs ${out}/${name}.inc)
        string(MAKE_C_IDENTIFIER ${name} id)
        string(APPEND includes "static const uint32_t ${id}[] = {\n#include \"${name}.inc\"\n};\n")
        string(APPEND table "    {\"${name}\", ${id}},\n")
    endforeach()
    file(CONFIGURE OUTPUT ${out}/embedded.cpp CONTENT
"#include <gpu/shaders.hpp>
#include <string>
#include <utility>

namespace prelight::gpu {
namespace {
@includes@
const std::pair<std::string_view, std::span<const uint32_t>> table[] = {
@table@};
} // namespace

std::span<const uint32_t> find_shader(std::string_view name) {
    for (const auto& [known, code] : table)
        if (known == name)
            return code;
    throw Error(\"shader \" + std::string(name) + \": not embedded in this build\");
}
} // namespace prelight::gpu
" @ONLY)
    set_source_files_properties(${out}/embedded.cpp PROPERTIES OBJECT_DEPENDS "${outputs}")
    target_sources(${TARGET} PRIVATE ${out}/embedded.cpp)
    target_include_directories(${TARGET} PRIVATE ${out})
endfunction()
