# prelight_shaders(TARGET): compiles every shader below shaders/ with glslc, and the variants that
# shaders/variants.cmake lists, and embeds the SPIR-V in TARGET for gpu::find_shader(name).
# prelight_shaders(TARGET FOLDER FUNCTION): the shaders of another folder (a test's), for
# gpu::FUNCTION(name). They may include what lies in shaders/.
include(${CMAKE_SOURCE_DIR}/shaders/variants.cmake)

# prelight_embed_texts(TARGET HEADER FUNCTION STRIP FILE…): see embed_texts.cmake.
function(prelight_embed_texts TARGET HEADER FUNCTION STRIP)
    string(MAKE_C_IDENTIFIER ${FUNCTION} id)
    set(out ${CMAKE_CURRENT_BINARY_DIR}/${id}.cpp)
    add_custom_command(OUTPUT ${out}
        COMMAND ${CMAKE_COMMAND} -P ${CMAKE_SOURCE_DIR}/cmake/embed_texts.cmake
                ${out} ${HEADER} ${FUNCTION} ${STRIP} ${ARGN}
        DEPENDS ${ARGN} ${CMAKE_SOURCE_DIR}/cmake/embed_texts.cmake
        COMMENT "Texts ${FUNCTION}" VERBATIM)
    target_sources(${TARGET} PRIVATE ${out})
endfunction()

function(prelight_shaders TARGET)
    set(folder ${CMAKE_SOURCE_DIR}/shaders)
    set(function find_shader)
    set(jobs ${PRELIGHT_SHADER_VARIANTS})
    if(ARGC GREATER 1)
        set(folder ${ARGV1})
        set(function ${ARGV2})
        set(jobs)
    endif()
    file(GLOB sources CONFIGURE_DEPENDS ${folder}/*.vert ${folder}/*.frag ${folder}/*.comp)
    foreach(source IN LISTS sources)
        cmake_path(GET source FILENAME name)
        list(APPEND jobs "${name}|${name}|")
    endforeach()
    set(out ${CMAKE_CURRENT_BINARY_DIR}/shaders)
    file(MAKE_DIRECTORY ${out})
    foreach(material IN LISTS PRELIGHT_BUILT_IN_MATERIALS)
        file(MAKE_DIRECTORY ${out}/${material})
        file(CONFIGURE OUTPUT ${out}/materials/${material}/material.glsl
             CONTENT "#include \"materials/${material}.glsl\"\n")
    endforeach()
    set(table "")
    set(includes "")
    set(outputs "")
    foreach(job IN LISTS jobs)
        string(REPLACE "|" ";" parts "${job}")
        list(GET parts 0 name)
        list(GET parts 1 source)
        list(GET parts 2 defines)
        list(LENGTH parts length)
        set(material metallic_roughness)
        if(length GREATER 3)
            list(GET parts 3 material)
        endif()
        separate_arguments(defines)
        add_custom_command(OUTPUT ${out}/${name}.inc
            COMMAND Vulkan::glslc --target-env=vulkan1.3 -O -Werror -mfmt=num ${defines}
                    -I ${CMAKE_SOURCE_DIR}/shaders -I ${out}/materials/${material} -MD -MF ${out}/${name}.d -o ${out}/${name}.inc
                    ${folder}/${source}
            DEPENDS ${folder}/${source} DEPFILE ${out}/${name}.d
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

std::span<const uint32_t> @function@(std::string_view name) {
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
