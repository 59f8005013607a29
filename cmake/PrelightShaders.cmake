# prelight_shaders(TARGET): compiles every shader below shaders/, in the variants that stand at its top, and embeds
# the SPIR-V in TARGET for gpu::find_shader(key).
# prelight_shaders(TARGET FOLDER FUNCTION): the shaders of another folder (a test's), for
# gpu::FUNCTION(key). They may include what lies in shaders/.

# Compiling takes minutes and a program that runs on the machine that builds. Another build of the same sources may have
# done it: for another compiler, or another machine.
set(PRELIGHT_SHADERS_OF "" CACHE PATH "A build folder that has the shaders compiled; empty: this build compiles them")

# prelight_embed_texts(TARGET HEADER FUNCTION STRIP FILE…): see embed_texts.cmake.
function(prelight_embed_texts TARGET HEADER FUNCTION STRIP)
    string(MAKE_C_IDENTIFIER ${FUNCTION} id)
    set(out ${CMAKE_CURRENT_BINARY_DIR}/${id}.cpp)
    add_custom_command(OUTPUT ${out}
        COMMAND ${CMAKE_COMMAND} -P ${PROJECT_SOURCE_DIR}/cmake/embed_texts.cmake
                ${out} ${HEADER} ${FUNCTION} ${STRIP} ${ARGN}
        DEPENDS ${ARGN} ${PROJECT_SOURCE_DIR}/cmake/embed_texts.cmake
        COMMENT "Texts ${FUNCTION}" VERBATIM)
    target_sources(${TARGET} PRIVATE ${out})
endfunction()

function(prelight_compiled_shaders TARGET FILE)
    target_sources(${TARGET} PRIVATE ${FILE})
    set_source_files_properties(${FILE} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON)
endfunction()

function(prelight_shaders TARGET)
    set(folder ${PROJECT_SOURCE_DIR}/shaders)
    set(function find_shader)
    if(ARGC GREATER 1)
        set(folder ${ARGV1})
        set(function ${ARGV2})
    endif()
    set(out ${CMAKE_CURRENT_BINARY_DIR}/shaders)
    if(PRELIGHT_SHADERS_OF)
        cmake_path(RELATIVE_PATH out BASE_DIRECTORY ${PROJECT_BINARY_DIR})
        cmake_path(ABSOLUTE_PATH out BASE_DIRECTORY ${PRELIGHT_SHADERS_OF})
        if(NOT EXISTS ${out}/${function}.cpp)
            message(FATAL_ERROR "Prelight: PRELIGHT_SHADERS_OF=${PRELIGHT_SHADERS_OF}: has no ${out}/${function}.cpp")
        endif()
        prelight_compiled_shaders(${TARGET} ${out}/${function}.cpp)
        return()
    endif()
    file(GLOB sources CONFIGURE_DEPENDS ${folder}/*.vert ${folder}/*.frag ${folder}/*.comp)
    file(GLOB materials CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/shaders/materials/*.glsl)
    # A file that comes in with an old time is a change of this list.
    file(CONFIGURE OUTPUT ${out}/${function}.list CONTENT "${sources};${materials}")
    add_custom_command(OUTPUT ${out}/${function}.cpp BYPRODUCTS ${out}/${function}.bin
        COMMAND compile_shaders ${folder} ${PROJECT_SOURCE_DIR}/shaders ${out} ${function}
        DEPENDS compile_shaders ${out}/${function}.list ${sources} ${materials} DEPFILE ${out}/${function}.d
        COMMENT "Shaders ${function}" VERBATIM)
    prelight_compiled_shaders(${TARGET} ${out}/${function}.cpp)
endfunction()
