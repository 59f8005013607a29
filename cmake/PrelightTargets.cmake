# prelight_target(NAME FOLDERS... ): one static library of every .cpp below the folders, with the
# project's warnings. A new source file needs no edit of a build file.
add_library(prelight_options INTERFACE)
target_compile_options(prelight_options INTERFACE
    -Wall -Wextra -Werror -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Wcast-qual -Wunused
    -Woverloaded-virtual -Wno-missing-field-initializers)
target_compile_definitions(prelight_options INTERFACE GLM_FORCE_DEPTH_ZERO_TO_ONE
    GLM_FORCE_CTOR_INIT GLM_ENABLE_EXPERIMENTAL)
if(PRELIGHT_SANITIZE)
    target_compile_options(prelight_options INTERFACE -fsanitize=${PRELIGHT_SANITIZE} -fno-omit-frame-pointer)
    target_link_options(prelight_options INTERFACE -fsanitize=${PRELIGHT_SANITIZE})
endif()

function(prelight_sources OUT)
    set(all)
    foreach(folder IN LISTS ARGN)
        file(GLOB_RECURSE found CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.cpp)
        list(APPEND all ${found})
    endforeach()
    set(${OUT} ${all} PARENT_SCOPE)
endfunction()

function(prelight_target NAME)
    prelight_sources(sources ${ARGN})
    add_library(${NAME} STATIC ${sources})
    target_include_directories(${NAME} PUBLIC ${CMAKE_SOURCE_DIR}/include ${CMAKE_SOURCE_DIR}/src
                                              ${CMAKE_SOURCE_DIR}/shaders)
    target_link_libraries(${NAME} PUBLIC prelight_options)
endfunction()
