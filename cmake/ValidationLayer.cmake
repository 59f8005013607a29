# Debian's packaged validation layer (1.3.239) misses hazards on dynamic-rendering attachments; the
# one inside chromium-common sees them, but comes without a manifest. prelight_validation_layer() writes one into
# share/prelight/layers of the build folder, where programs of this build look for it (src/gpu/instance.cpp). Without
# the package there is none, and the loader's own search finds the packaged layer when that is installed.
set(PRELIGHT_VALIDATION_LAYER /usr/lib/chromium/libVkLayer_khronos_validation.so CACHE FILEPATH
    "Validation layer library to write a manifest for")

function(prelight_validation_layer)
    set(folder ${PROJECT_BINARY_DIR}/share/prelight/layers)
    set(manifest ${folder}/VkLayer_khronos_validation.json)
    if(NOT EXISTS ${PRELIGHT_VALIDATION_LAYER})
        file(REMOVE_RECURSE ${folder})
        return()
    endif()
    if(NOT EXISTS ${manifest} OR ${PRELIGHT_VALIDATION_LAYER} IS_NEWER_THAN ${manifest})
        # try_run remembers its result; a changed library has to be asked again.
        unset(prelight_layer_ran CACHE)
        unset(prelight_layer_built CACHE)
        try_run(prelight_layer_ran prelight_layer_built ${PROJECT_BINARY_DIR}/CMakeFiles/layer_manifest
            ${PROJECT_SOURCE_DIR}/cmake/write_layer_manifest.c
            CMAKE_FLAGS -DINCLUDE_DIRECTORIES=${Vulkan_INCLUDE_DIRS}
            LINK_LIBRARIES ${CMAKE_DL_LIBS}
            COMPILE_OUTPUT_VARIABLE compiled RUN_OUTPUT_VARIABLE text
            ARGS ${PRELIGHT_VALIDATION_LAYER})
        if(NOT prelight_layer_built OR NOT "${prelight_layer_ran}" STREQUAL "0")
            message(WARNING "No manifest for ${PRELIGHT_VALIDATION_LAYER}: ${compiled} ${text}")
            file(REMOVE ${manifest})
            return()
        endif()
        file(WRITE ${manifest} "${text}")
        message(STATUS "Validation layer: ${PRELIGHT_VALIDATION_LAYER}")
    endif()
endfunction()
prelight_validation_layer()
