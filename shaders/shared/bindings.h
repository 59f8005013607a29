// Numbers of descriptor sets, bindings, vertex locations and specialisation constants: the one place.
#ifndef PRELIGHT_BINDINGS_H
#define PRELIGHT_BINDINGS_H

#define SET_FRAME 0
#define FRAME_CONSTANTS 0
#define FRAME_LIGHTS 1
#define FRAME_LIGHT_ORDER 3
#define FRAME_LIGHT_BOUNDS 4
// only of frames with shadows
#define FRAME_SHADOWS 5
#define FRAME_SHADOW_SAMPLER 6
// of lights that send more in some directions: cookies, profiles
#define FRAME_DISTRIBUTIONS 7
#define FRAME_DISTRIBUTION_LEVELS 8
#define FRAME_DISTRIBUTION_MAPS 9
// FRAME_LIGHTS as texels
#define FRAME_LIGHT_TEXELS 10
#define FRAME_SHADOW_TEXELS 11 // and FRAME_SHADOWS
// and the next two: uniform buffers that no shader has (docs/notes/software-devices.md#uniform-buffers)
#define FRAME_UNREAD 12

#define SET_INPUTS 1
#define INPUT_RASTER 63  // in every pass
// light pass
#define INPUT_DEPTH 0
#define INPUT_NORMAL 1
#define INPUT_ROUGHNESS 2
#define INPUT_PAIR_COUNTERS 3
#define INPUT_MATERIAL 4  // deferred shading: RT2; views: the light buffer's pair
#define INPUT_ALBEDO 5    // and RT3
// with samples of edge pixels: the pixel's one surface
#define INPUT_PIXEL_DEPTH 6
#define INPUT_PIXEL_NORMAL 7
// material pass
#define INPUT_DIFFUSE_LIGHT 0
#define INPUT_SPECULAR_LIGHT 1
// tone mapping
#define INPUT_COLOUR 0
// layers of blended surfaces
#define INPUT_LAYER_COUNTS 1
#define INPUT_K_BUFFER 35
#define INPUT_DEPTH_BEHIND 17 // of what is opaque, behind soft ones
// weighted blended surfaces
#define INPUT_BLENDED_SUM 0
#define INPUT_BLENDED_WEIGHT 1
// inferred lighting: surfaces and depth at the light's resolution, and how many pixels found none that fits
#define INPUT_SURFACE_IDS 47
#define INPUT_LIGHT_DEPTH 35
#define INPUT_UNMATCHED 39
// transmissive surfaces: what lies behind them
#define INPUT_BEHIND 14
#define INPUT_BEHIND_TARGET 15
#define BEHIND_GROUP 8 // texels along a side of the work groups that make its levels
// several samples a pixel: which pixels are edges, where their samples' light lies, and that light
#define INPUT_EDGES 0
#define INPUT_SAMPLE_DEPTH 46
#define INPUT_EDGE_FLAGS 45 // the same where 0 is another
#define INPUT_EDGE_TARGET 58
#define INPUT_EDGE_PIXELS 59
#define INPUT_EDGE_COUNTS 60
#define INPUT_SAMPLE_DIFFUSE 61
#define INPUT_SAMPLE_SPECULAR 62

// Of the window's own shaders (window_picture.frag, ui.vert, ui.frag), which have one set
#define WINDOW_PICTURE 0
#define UI_TEXTURE 0
#define UI_POSITION 0
#define UI_TEXCOORD 1
#define UI_COLOUR 2

// light lists
#define INPUT_LIGHT_CELLS 8
#define INPUT_LIGHT_ENTRIES 9
#define INPUT_COARSE_CELLS 10
#define INPUT_LIGHT_MASKS 11
#define INPUT_DEPTH_SLICES 12
#define INPUT_LIST_TOTAL 13
// light lists walked by a compute pass
#define INPUT_LIGHT_TARGET 16
#define INPUT_SECOND_LIGHT_TARGET 17
#define INPUT_COLOUR_BEFORE 18
#define INPUT_LIT_BLOCKS 19
#define INPUT_LIT_BEFORE 20
#define INPUT_STALE_BLOCKS 21
#define INPUT_SECOND_BEFORE 22
// index trimming on the device
#define INPUT_TRIM_DRAWS 20
#define INPUT_TRIM_GROUPS 21
#define INPUT_TRIM_OBJECTS 22
#define INPUT_TRIM_POSITIONS 23
#define INPUT_TRIM_SOURCE 24
#define INPUT_TRIM_SOURCE_COMMANDS 25
#define INPUT_TRIM_MASKS 26
#define INPUT_TRIM_INDICES 27
#define INPUT_TRIM_COMMANDS 28
#define INPUT_TRIM_COUNTS 29
// shadows, of the shaders that are compiled with SHADOWS
#define INPUT_SHADOW_ATLAS 24
#define INPUT_SHADOW_TRANSMITTANCE 25
#define INPUT_SHADOW_EXTREMES 26
// the decal buffer, of the shaders that are compiled with DECALS
#define INPUT_DECAL_COLOUR 40
#define INPUT_DECAL_NORMAL 41
#define INPUT_DECAL_ROUGHNESS 42
#define INPUT_DECAL_METALLIC 43
// ambient occlusion, of what is compiled with OCCLUSION
#define INPUT_OCCLUSION 32
#define INPUT_AMBIENT_LIGHT 33
#define INPUT_MIRRORED_LIGHT 34
// the scale of fixed-point light buffers
#define INPUT_LIGHT_HISTOGRAM 36
#define INPUT_LIGHT_SCALE 37
#define INPUT_FRAME_CONSTANTS 38
// deformation of skins and morph targets
#define INPUT_DEFORM_BASE 48
#define INPUT_DEFORM_INFLUENCES 49
#define INPUT_DEFORM_TARGETS 50
#define INPUT_DEFORM_STATE 51
#define INPUT_DEFORM_POSITIONS 52
#define INPUT_DEFORM_PREVIOUS 53
#define INPUT_DEFORM_ATTRIBUTES 54
#define INPUT_DEFORM_JOBS 55
#define INPUT_DEFORM_GROUPS 56
// motion blur
#define INPUT_MOTION_TILES 57
#define MOTION_TILE 40  // pixels along an axis; the longest motion that blurs
// anti-aliasing of the finished picture, which is INPUT_COLOUR_BEFORE
#define INPUT_SMAA_EDGES 58
#define INPUT_SMAA_WEIGHTS 59
#define INPUT_SMAA_AREAS 60

// measuring how targets store normals and depths: passes of their own, without a frame
#define SET_BENCH 0
#define BENCH_VALUES 0
#define BENCH_STORED 0
#define BENCH_WIDTH 1024  // pixels a row, one value each

#define SET_MATERIAL 2
#define MATERIAL_CONSTANTS 0
#define MATERIAL_BASE_COLOUR 1
#define MATERIAL_METALLIC_ROUGHNESS 2
#define MATERIAL_NORMAL 3
#define MATERIAL_OCCLUSION 4
#define MATERIAL_EMISSIVE 5
#define MATERIAL_OWN_TEXTURE 6  // and the next ones: textures that a material's shader declares
#define MATERIAL_OWN_TEXTURES 8
#define MATERIAL_ENVIRONMENT 14
#define MATERIAL_PARAMETERS 15
#define MATERIAL_ENVIRONMENT_LIGHT 16
#define MATERIAL_SKY 17  // the environment as it came, for the background
#define MATERIAL_REFLECTANCE 18  // of a mirror, by N·V and roughness
#define MATERIAL_TEXTURES 13  // of the standard and a shader's own: what MaterialConstants knows of

// Decals of a blended object.
#define SET_LAYER_DECALS 3
#define LAYER_DECAL_LIST 0
#define LAYER_DECAL_MAPS 1  // base colour, metallic-roughness and normals of the first, of the second …

#define VERTEX_POSITION 0
#define VERTEX_NORMAL 1
#define VERTEX_TANGENT 2
#define VERTEX_TEXCOORD_0 3
#define VERTEX_TEXCOORD_1 4
#define VERTEX_COLOUR 5
#define VERTEX_PREVIOUS_POSITION 6
#define VERTEX_SMOOTH_GROUP 6 // in the place of the previous position, which it never comes with
// The object's ObjectData, once an instance: 3 locations each.
#define VERTEX_WORLD_ROW 7
#define VERTEX_NORMAL_ROW 10
#define VERTEX_PREVIOUS_WORLD_ROW 13

// Specialisation constants: specialise rather than branch, for on a software device both sides of an
// `if` run.
#define CONSTANT_MATERIAL_FEATURES 0
#define CONSTANT_NORMAL_ENCODING 1
#define CONSTANT_NORMAL_SPACE 2
#define CONSTANT_DEPTH_SOURCE 3
#define CONSTANT_POSITION_FROM_RAY 4
#define CONSTANT_SHADING 5
#define CONSTANT_MODEL 6
#define CONSTANT_PACKED_LIGHT 7
#define CONSTANT_SPECULAR_STEP_GATE 8
#define CONSTANT_REFLECTION_VECTOR 9
#define CONSTANT_COUNT_PAIRS 10
#define CONSTANT_LIGHT_OUTPUT 11
#define CONSTANT_LIGHT_KINDS 12
#define CONSTANT_MATERIAL_OUTPUT 13
#define CONSTANT_AMBIENT_AS_LIGHT 14
#define CONSTANT_TONEMAP 15
#define CONSTANT_VIEW 16
#define CONSTANT_VOLUME 17
#define CONSTANT_FORWARD_BASE 18
#define CONSTANT_RECTANGLE_FAR_SIDE 19
#define CONSTANT_LIST_TILE_SIZE 30
#define CONSTANT_LIST_SLICED 31
#define CONSTANT_LIST_FILL 33
#define CONSTANT_LIST_COARSE 37
#define CONSTANT_LIST_TRIM 38
#define CONSTANT_LIST_TRIM_LIGHTS 29
#define CONSTANT_LIST_MASKED 39
#define CONSTANT_LIST_ROWS 34
#define CONSTANT_LIST_GROUP_ROWS 35
#define CONSTANT_LIST_LANES 32
#define CONSTANT_AMBIENT_TOO 36
#define CONSTANT_SPECULAR_WAY 40
#define CONSTANT_LIGHT_STORAGE 41
#define CONSTANT_GBUFFER 42
#define CONSTANT_CLIPPED_LIGHT 43
#define CONSTANT_TARGET_ENCODES 50
#define CONSTANT_TRIM_SUBPIXEL_BITS 60
#define CONSTANT_TRIM_BY_DEPTH 61
#define CONSTANT_TRIM_AGAIN 62
#define CONSTANT_SHADOW_FILTER 51
#define CONSTANT_SHADOWS_TRANSMIT 52
#define CONSTANT_SHADOW_EXTREMES 109
#define CONSTANT_SHADOWS_AT_PIXEL 53
#define CONSTANT_SPECULAR_ANTIALIASING 70
#define CONSTANT_SAMPLES 71
#define CONSTANT_STORED_ENCODED 72
#define CONSTANT_EVERY_EDGE 73
#define CONSTANT_EDGE_TILES 74
#define CONSTANT_EDGE_ROW 75
#define CONSTANT_EDGE_FIRST_ROW 78
#define CONSTANT_LIGHTS_AS_TEXELS 76
#define CONSTANT_POST_DEPTH_COVERAGE 77
#define CONSTANT_OCCLUSION_RADIUS 80
#define CONSTANT_OCCLUSION_SCALE 81
#define CONSTANT_OCCLUSION_AXIS 82
#define CONSTANT_LIGHT_CODES 90
#define CONSTANT_LIGHTS_BLENDED 91
#define CONSTANT_CLIPPING_FIRST 92
#define CONSTANT_CLIPPING_SECOND 93
#define CONSTANT_LIGHT_MOST 94
#define CONSTANT_LIGHT_SAMPLE_STEP 95
#define CONSTANT_HAS_NORMALS 100
#define CONSTANT_FIRST_LAYER 101
#define CONSTANT_BEHIND_LAST_LEVEL 102
#define CONSTANT_BEHIND_COPIES 103
#define CONSTANT_K_BUFFER_SLOTS 104
#define CONSTANT_K_BUFFER_SLOT 105
#define CONSTANT_HALF_SAMPLES 106
#define CONSTANT_RESOLVED 107
#define CONSTANT_VIEW_SAMPLE 110
#define CONSTANT_TARGET_CONVERSION 108

// Values of those constants.
#define FEATURE_BASE_COLOUR_TEXTURE 1u
#define FEATURE_METALLIC_ROUGHNESS_TEXTURE 2u
#define FEATURE_NORMAL_TEXTURE 4u
#define FEATURE_OCCLUSION_TEXTURE 8u
#define FEATURE_EMISSIVE_TEXTURE 16u
#define FEATURE_ALPHA_MASK 32u
#define FEATURE_UNLIT 64u
#define FEATURE_ENVIRONMENT 128u
#define FEATURE_OWN_TEXTURE 256u  // times 2 for each slot
#define FEATURE_DECALS 65536u     // of an object, not of its material: decals reach it
#define FEATURE_BLENDED 131072u   // of an object: drawn over what is behind it (alphaMode BLEND)
#define FEATURE_TRANSMISSIVE 262144u // of an object: the picture behind it comes through
#define FEATURE_SOFT 524288u      // of a blended object: it fades before what is opaque behind it
#define FEATURE_FACING 1048576u   // of an object: its vertices stand from their positions in the viewer's plane

// Kinds of lights that a frame may hold; shaders leave out what the others need.
#define LIGHT_KIND_SPOT 1u
#define LIGHT_KIND_DIRECTIONAL 2u
#define LIGHT_KIND_OTHER_FALLOFF 4u
#define LIGHT_KIND_DISTRIBUTION 8u
#define LIGHT_KINDS_ALL 15u

// LightData::kind: which falloff, whether its position is a direction, and from the shift on a number.
#define LIGHT_FALLOFF_MASK 3u
#define LIGHT_FALLOFF_GLTF 0u
#define LIGHT_FALLOFF_LINEAR 1u
#define LIGHT_FALLOFF_QUADRATIC 2u
#define LIGHT_DIRECTIONAL 4u
#define LIGHT_DISTRIBUTION_SHIFT 3

// What a cookie is.
#define COOKIE_NONE 0
#define COOKIE_SPOT 1
#define COOKIE_SPHERE 2
#define COOKIE_CUBE 3

// What becomes of display-encoded values on their way into a target.
#define TARGET_AS_IT_IS 0
#define TARGET_DECODE 1  // the target encodes them again
#define TARGET_ENCODE 2  // the buffer's own image has decoded them

// Which of a pixel's samples count, and as what.
#define RESOLVED_ALL 0
#define RESOLVED_HALVES 1  // shared/half_samples.h: blended surfaces over what is opaque
#define RESOLVED_OPAQUE 2  // of them those that show what is opaque
#define RESOLVED_SAMPLE 3  // and so on: only the first, only the second …

#define NORMAL_OCT24 0
#define NORMAL_OCT32 1
#define NORMAL_RGB10A2 2
#define NORMAL_RGB8 3
#define NORMAL_SPHERICAL 4
#define NORMAL_OCT16 5
#define NORMAL_XY16F 6

#define DEPTH_ATTACHMENT 0
#define DEPTH_R32F 1
#define DEPTH_R16F 2
#define DEPTH_RGBA8 3

#define GBUFFER_NONE 0  // light pre-pass
#define GBUFFER_WIDE 1
#define GBUFFER_KILLZONE2 2

#define SHADING_PHONG 0
#define SHADING_GGX 1

#define MODEL_WEIGHTED 0
#define MODEL_NV 1
#define MODEL_MONO 2
#define MODEL_FULL 3

// How a material's own shininess is come by.
#define SPECULAR_STORED 0
#define SPECULAR_LUV 1
#define SPECULAR_FIFTH_CHANNEL 2
#define SPECULAR_LUMINANCE 3
#define SPECULAR_BENT 4

// What the light buffer's targets hold: the shader rounds to it, for drivers round differently.
#define STORAGE_FLOAT16 0
#define STORAGE_UNORM8 1
#define STORAGE_UNORM10 2
#define STORAGE_FLOAT11 3

// What is done to lists for measuring.
#define LIST_TRIM_MARK 0  // lights that contribute to no pixel of their tile
#define LIST_TRIM_KEEP 1  // the others only
#define LIST_TRIM_EMPTY 2

#define LIGHT_OUTPUT_LIGHT 0
#define LIGHT_OUTPUT_COUNT 1

#define MATERIAL_OUTPUT_SHADED 0
#define MATERIAL_OUTPUT_ALBEDO 1
#define MATERIAL_OUTPUT_DIFFUSE_SUM 2
#define MATERIAL_OUTPUT_SPECULAR_SUM 3
#define MATERIAL_OUTPUT_UNMATCHED 4  // white where the light's resolution has no sample that fits

#define VOLUME_SPHERE 0
#define VOLUME_CONE 1
#define VOLUME_BOX 2

#define SHADOW_FILTER_HARD 0
#define SHADOW_FILTER_PCF 1
#define SHADOW_FILTER_CONTACT 2

#define TONEMAP_PBR_NEUTRAL 0
#define TONEMAP_ACES 1
#define TONEMAP_NONE 2    // clamped and sRGB-encoded
#define TONEMAP_LINEAR 3  // scene-linear light as it is, for passes that come after

#define VIEW_DEPTH 0
#define VIEW_NORMAL 1
#define VIEW_ROUGHNESS 2
#define VIEW_LIGHT 3
#define VIEW_LIGHT_ALPHA 4
#define VIEW_COUNT 5
#define VIEW_COLOUR 6
#define VIEW_LIGHT_LUV 7
#define VIEW_ALBEDO 8
#define VIEW_SPECULAR 9
#define VIEW_MOTION 10
#define VIEW_SECOND_LIGHT 11  // the other half of a pair
#define VIEW_OCCLUSION 16
#define VIEW_SPECULAR_LIGHT 17  // light by the specular scale
#define VIEW_SUN_OCCLUSION 18
#define VIEW_EDGES 19  // how many surfaces an edge pixel has
#define VIEW_LAYERS 20

#endif
