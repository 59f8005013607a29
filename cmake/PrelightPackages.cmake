# Who packages what Prelight is built with, and under which name; "-": nobody there, as far as is known. The names of
# Debian 12 are those of scripts/packages.txt and tried; the others are given as far as is known.
#   NAME             Debian                  Fedora                  Arch              Homebrew         vcpkg
set(prelight_packages
    "glm             libglm-dev              glm-devel               glm               glm              glm"
    "vulkan          libvulkan-dev           vulkan-loader-devel     vulkan-devel      vulkan-loader    vulkan"
    "fmt             libfmt-dev              fmt-devel               fmt               fmt              fmt"
    "simdjson        libsimdjson-dev         simdjson-devel          simdjson          simdjson         simdjson"
    "draco           libdraco-dev            draco-devel             draco             draco            draco"
    "meshoptimizer   libmeshoptimizer-dev    meshoptimizer-devel     meshoptimizer     meshoptimizer    meshoptimizer"
    "embree-3        libembree-dev           embree3-devel           -                 -                embree3"
    "openexr         libopenexr-dev          openexr-devel           openexr           openexr          openexr"
    "spng            libspng-dev             libspng-devel           libspng           libspng          libspng"
    "deflate         libdeflate-dev          libdeflate-devel        libdeflate        libdeflate       libdeflate"
    "jpeg            libjpeg62-turbo-dev     libjpeg-turbo-devel     libjpeg-turbo     jpeg-turbo       libjpeg-turbo"
    "webp            libwebp-dev             libwebp-devel           libwebp           webp             libwebp"
    "shaderc         libshaderc-dev          libshaderc-devel        shaderc           shaderc          shaderc"
    "glslang         glslang-dev             glslang-devel           glslang           glslang          glslang"
    "spirv-tools     spirv-tools             spirv-tools-devel       spirv-tools       spirv-tools      spirv-tools"
    "json            nlohmann-json3-dev      json-devel              nlohmann-json     nlohmann-json    nlohmann-json"
    "cli11           libcli11-dev            cli11-devel             cli11             cli11            cli11"
    "glfw            libglfw3-dev            glfw-devel              glfw              glfw             glfw3"
    "imgui           libimgui-dev            -                       -                 -                imgui"
    "pybind11        pybind11-dev            pybind11-devel          pybind11          pybind11         pybind11"
    "python          python3-dev             python3-devel           python            python           python3"
    "gtest           libgmock-dev            gmock-devel             gtest             googletest       gtest"
    "zlib            zlib1g-dev              zlib-devel              zlib              zlib             zlib"
    "glslangValidator glslang-tools          glslang                 glslang           glslang          glslang"
    "doxygen         doxygen                 doxygen                 doxygen           doxygen          -")

# prelight_missing_line(NAME OUT): "Prelight: fmt is missing or too old: libfmt-dev (Debian), fmt-devel (Fedora), …"
function(prelight_missing_line NAME OUT)
    set(names)
    foreach(row IN LISTS prelight_packages)
        string(REGEX REPLACE " +" ";" row "${row}")
        list(POP_FRONT row name)
        if(NOT name STREQUAL NAME)
            continue()
        endif()
        foreach(system Debian Fedora Arch Homebrew vcpkg)
            list(POP_FRONT row package)
            if(NOT package STREQUAL "-")
                list(APPEND names "${package} (${system})")
            endif()
        endforeach()
    endforeach()
    list(JOIN names ", " names)
    set(${OUT} "Prelight: ${NAME} is missing or too old: ${names}" PARENT_SCOPE)
endfunction()
