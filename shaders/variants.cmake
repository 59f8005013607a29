# Shaders compiled a second time with other outputs: NAME|SOURCE|DEFINES[|MATERIAL]. Only for what a
# specialisation constant cannot do: an output without a target is an error. MATERIAL: a file of
# shaders/materials/, what `#include "material.glsl"` means; metallic_roughness where none is named.
set(PRELIGHT_SHADER_VARIANTS
    "depth_normal+roughness.frag|depth_normal.frag|-DROUGHNESS_TARGET=1"
    "depth_normal+depth.frag|depth_normal.frag|-DDEPTH_TARGET=1"
    "depth_normal+roughness+depth.frag|depth_normal.frag|-DROUGHNESS_TARGET=1 -DDEPTH_TARGET=2"
    "depth_normal+stencil.frag|depth_normal.frag|-DSTENCIL_ROUGHNESS"
    "depth_normal+stencil+depth.frag|depth_normal.frag|-DSTENCIL_ROUGHNESS -DDEPTH_TARGET=1"
    "linear_depth.frag|depth_normal.frag|-DNO_NORMAL_TARGET -DDEPTH_TARGET=0"
    "surface+motion.vert|surface.vert|-DMOTION"
    "gbuffer_fill+occlusion.frag|gbuffer_fill.frag|-DOCCLUSION"
    # Casters of shadows: push constants that say where the light is.
    "depth_only+shadow.vert|depth_only.vert|-DSHADOW_TILE"
    "surface+shadow.vert|surface.vert|-DSHADOW_TILE -DNO_WORLD -DNO_NORMAL"
    # Nor can another type of texture be a constant, or an input that is not there.
    "material_metallic_roughness.frag|material.frag|"
    "material_metallic_roughness+bits.frag|material.frag|-DLIGHT_BITS"
    "material_metallic_roughness+weighted.frag|material.frag|-DONLY_WEIGHTED"
    "material_metallic_roughness+weighted+bits.frag|material.frag|-DONLY_WEIGHTED -DLIGHT_BITS"
    "material_blinn_phong.frag|material.frag|-DONLY_WEIGHTED|blinn_phong"
    "material_blinn_phong+bits.frag|material.frag|-DONLY_WEIGHTED -DLIGHT_BITS|blinn_phong"
    "material_metallic_roughness+pair.frag|material.frag|-DLIGHT_PAIR"
    "material_metallic_roughness+weighted+pair.frag|material.frag|-DONLY_WEIGHTED -DLIGHT_PAIR"
    "material_blinn_phong+pair.frag|material.frag|-DONLY_WEIGHTED -DLIGHT_PAIR|blinn_phong"
    "view+pair.frag|view.frag|-DLIGHT_PAIR"
    "light_list+pair.comp|light_list.comp|-DLIGHT_PAIR"
    "trim_test+depth.comp|trim_test.comp|-DBY_DEPTH"
    "light+packed.frag|light.frag|-DONE_TARGET"
    "light+count.frag|light.frag|-DCOUNT_TARGET"
    "light+deferred.frag|light.frag|-DDEFERRED_TARGET"
    "light_ambient+packed.frag|light_ambient.frag|-DONE_TARGET"
    "light_list+packed.frag|light_list.frag|-DONE_TARGET"
    "light_list+count.frag|light_list.frag|-DCOUNT_TARGET"
    "light_list+deferred.frag|light_list.frag|-DDEFERRED_TARGET"
    "light_list+packed.comp|light_list.comp|-DONE_TARGET"
    "light_list_clear+packed.comp|light_list_clear.comp|-DONE_TARGET"
    "light_list_clear+count.comp|light_list_clear.comp|-DONE_TARGET"
    "light_list_clear+pair.comp|light_list_clear.comp|-DLIGHT_PAIR"
    "light_list+count.comp|light_list.comp|-DCOUNT_TARGET"
    "light_list+deferred.comp|light_list.comp|-DDEFERRED_TARGET"
    # Rounds after the first, which add to what is there.
    "light_list+added.comp|light_list.comp|-DADDED"
    "light_list+packed+added.comp|light_list.comp|-DONE_TARGET -DADDED"
    "light_list+pair+added.comp|light_list.comp|-DLIGHT_PAIR -DADDED"
    "light_list+count+added.comp|light_list.comp|-DCOUNT_TARGET -DADDED"
    # Cells in the world instead of on the screen: no depth buffer is bound.
    "light_lists_coarse+grid.comp|light_lists_coarse.comp|-DGRID_CELLS"
    "light_lists_scatter+grid.comp|light_lists_scatter.comp|-DGRID_CELLS"
    "light_lists_candidates+grid.comp|light_lists_candidates.comp|-DGRID_CELLS"
    "light_lists_cells+grid.comp|light_lists_cells.comp|-DGRID_CELLS"
    "light_peaks+deferred.comp|light_peaks.comp|-DDEFERRED_TARGET -DSMALL_PICTURE"
    "light_loop+packed.frag|light_loop.frag|-DONE_TARGET"
    "light_loop+count.frag|light_loop.frag|-DCOUNT_TARGET"
    "plain_forward+textured.vert|plain_forward.vert|-DTEXTURED"
    "plain_forward+textured.frag|plain_forward.frag|-DTEXTURED")

# The same again with shadows: what evaluates lights reads the atlas too.
set(shadowed
    "light.frag|light.frag|"
    "light_list.frag|light_list.frag|"
    "light_list.comp|light_list.comp|"
    "light_loop.frag|light_loop.frag|"
    "light_peaks.comp|light_peaks.comp|"
    "forward.frag|forward.frag|"
    "forward_grid.frag|forward_grid.frag|"
    ${PRELIGHT_SHADER_VARIANTS})
list(FILTER shadowed INCLUDE REGEX "^(light|light_list|light_loop|light_peaks|forward|forward_grid)(\\+packed|\\+pair|\\+deferred)?(\\+added)?\\.(frag|comp)")
list(TRANSFORM shadowed REPLACE "^([^|.]*)(\\.[a-z]+)" "\\1+shadows\\2")
list(TRANSFORM shadowed APPEND " -DSHADOWS")

# The same again where stencil holds the roughness of surfaces: unsigned integers.
set(stencilled
    "light.frag|light.frag|"
    "light_list.frag|light_list.frag|"
    "light_list.comp|light_list.comp|"
    "light_loop.frag|light_loop.frag|"
    "light_peaks.comp|light_peaks.comp|"
    "light_lists_perfect.comp|light_lists_perfect.comp|"
    "view.frag|view.frag|"
    ${PRELIGHT_SHADER_VARIANTS} ${shadowed})
list(FILTER stencilled INCLUDE REGEX "^(light|light_list|light_loop|light_peaks|light_lists_perfect|view)(\\+packed|\\+pair|\\+count)?(\\+added)?(\\+shadows)?\\.(frag|comp)")
list(FILTER stencilled EXCLUDE REGEX "^view\\+pair")
list(TRANSFORM stencilled REPLACE "^([^|.]*)(\\.[a-z]+)" "\\1+stencil\\2")
list(TRANSFORM stencilled APPEND " -DSTENCIL_ROUGHNESS")

# The same again for objects that decals reach: they read the decal buffer.
set(decorated
    "depth_normal.frag|depth_normal.frag|"
    "gbuffer_fill.frag|gbuffer_fill.frag|"
    "forward_base.frag|forward_base.frag|"
    "forward.frag|forward.frag|"
    "forward_grid.frag|forward_grid.frag|"
    ${PRELIGHT_SHADER_VARIANTS} ${shadowed})
set(decorated_stages "^(depth_normal(\\+roughness|\\+stencil)?|material[^|/]*|gbuffer_fill(\\+occlusion)?|forward(_grid)?(\\+shadows)?|forward_base)\\.frag")
list(FILTER decorated INCLUDE REGEX "${decorated_stages}")
list(TRANSFORM decorated REPLACE "^([^|]*)\\.frag" "\\1+decals.frag")
list(TRANSFORM decorated REPLACE "^([^|]*\\|[^|]*\\|[^|]*)" "\\1 -DDECALS")

# The same again for materials without textures, whose triangles need neither texture coordinates nor
# tangents.
set(untextured
    "depth_normal.frag|depth_normal.frag|"
    ${PRELIGHT_SHADER_VARIANTS})
list(FILTER untextured INCLUDE REGEX "^(depth_normal|material_)")
list(TRANSFORM untextured REPLACE "^([^|]*)\\.frag" "\\1+untextured.frag")
list(TRANSFORM untextured REPLACE "^([^|]*\\|[^|]*\\|[^|]*)" "\\1 -DNO_TEXTURES")
list(APPEND PRELIGHT_SHADER_VARIANTS ${untextured} ${shadowed} ${stencilled} ${decorated})

# The vertex shaders that go with all of these: passes::SurfaceDraws picks them.
foreach(world "" "+noworld")
    foreach(normal "" "+nonormal")
        foreach(textures "" "+untextured")
            set(left_out "${world}${normal}${textures}")
            set(defines "${left_out}")
            string(REPLACE "+noworld" "-DNO_WORLD " defines "${defines}")
            string(REPLACE "+nonormal" "-DNO_NORMAL " defines "${defines}")
            string(REPLACE "+untextured" "-DNO_TEXTURES" defines "${defines}")
            if(left_out)
                list(APPEND PRELIGHT_SHADER_VARIANTS "surface${left_out}.vert|surface.vert|${defines}")
            endif()
        endforeach()
    endforeach()
endforeach()

# What is compiled with each material that an object may choose: built-in ones here, as FOLDER/NAME where
# FOLDER is the material's file; a user's own when it is loaded (src/materials/compile.cpp).
set(PRELIGHT_MATERIAL_STAGES
    "depth_normal.frag|depth_normal.frag|"
    "depth_normal+roughness.frag|depth_normal.frag|-DROUGHNESS_TARGET=1"
    "depth_normal+depth.frag|depth_normal.frag|-DDEPTH_TARGET=1"
    "depth_normal+roughness+depth.frag|depth_normal.frag|-DROUGHNESS_TARGET=1 -DDEPTH_TARGET=2"
    "depth_normal+stencil.frag|depth_normal.frag|-DSTENCIL_ROUGHNESS"
    "depth_normal+stencil+depth.frag|depth_normal.frag|-DSTENCIL_ROUGHNESS -DDEPTH_TARGET=1"
    "linear_depth.frag|depth_normal.frag|-DNO_NORMAL_TARGET -DDEPTH_TARGET=0"
    "depth_mask.frag|depth_mask.frag|"
    "material.frag|material.frag|"
    "material+bits.frag|material.frag|-DLIGHT_BITS"
    "material+pair.frag|material.frag|-DLIGHT_PAIR"
    # With what nearby surfaces let through of ambient light.
    "material+occlusion.frag|material.frag|-DOCCLUSION"
    "material+bits+occlusion.frag|material.frag|-DLIGHT_BITS -DOCCLUSION"
    "material+pair+occlusion.frag|material.frag|-DLIGHT_PAIR -DOCCLUSION"
    "gbuffer_fill.frag|gbuffer_fill.frag|"
    "gbuffer_fill+occlusion.frag|gbuffer_fill.frag|-DOCCLUSION"
    "forward_base.frag|forward_base.frag|"
    "forward.frag|forward.frag|"
    "forward+shadows.frag|forward.frag|-DSHADOWS"
    "forward_grid.frag|forward_grid.frag|"
    "forward_grid+shadows.frag|forward_grid.frag|-DSHADOWS")
set(decorated ${PRELIGHT_MATERIAL_STAGES})
list(FILTER decorated INCLUDE REGEX "${decorated_stages}")
list(TRANSFORM decorated REPLACE "^([^|]*)\\.frag" "\\1+decals.frag")
list(TRANSFORM decorated APPEND " -DDECALS")
list(APPEND PRELIGHT_MATERIAL_STAGES ${decorated})
list(TRANSFORM PRELIGHT_MATERIAL_STAGES APPEND " -DOWN_MATERIAL")
file(GLOB materials CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_LIST_DIR}/materials
     ${CMAKE_CURRENT_LIST_DIR}/materials/*.glsl)
list(TRANSFORM materials REPLACE "\\.glsl$" "")
set(PRELIGHT_BUILT_IN_MATERIALS ${materials})
foreach(material IN LISTS materials)
    foreach(stage IN LISTS PRELIGHT_MATERIAL_STAGES)
        list(APPEND PRELIGHT_SHADER_VARIANTS "${material}/${stage}|${material}")
    endforeach()
endforeach()
