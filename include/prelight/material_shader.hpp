#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <prelight/export.hpp>
#include <prelight/material.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace prelight {

struct Scene;

/// A number, or up to four, that a material's file declares.
struct MaterialParameter {
    std::string name;           ///< as the file declares it
    uint32_t components = 1;    ///< 1 … 4
    glm::vec4 default_value{0}; ///< of its first `components`
    float low = 0;              ///< smallest value of each component
    float high = 1;             ///< largest value of each component
    std::string description;    ///< the comment beside it
    uint32_t offset = 0;        ///< bytes, in the std140 block of all
};

/// A texture that a material's file declares beside glTF's own.
struct MaterialTexture {
    /// What is read where a material has no such texture.
    enum class StandIn {
        white,    ///< 1 in all channels
        black,    ///< 0 in all channels
        flat,     ///< the normal map of a flat surface
        required, ///< nothing: such a material is refused
    };
    std::string name;                  ///< as the file declares it
    uint32_t slot = 0;                 ///< 0 … 7
    bool colour = false;               ///< sRGB-encoded in the file
    StandIn stand_in = StandIn::white; ///< what is read where a material has none
    std::string description;           ///< the comment beside it
};

/// A material's way to be shaded: one GLSL file with surface() and shade(), what it declares, and where it
/// came from. The language of these files: docs/materials.md.
struct MaterialShader {
    std::string name;                          ///< built-in: as `prelight materials` lists it; else the file's name
    std::string file;                          ///< for messages; empty: built-in
    std::string source;                        ///< GLSL
    std::string description;                   ///< its first comment
    std::vector<MaterialParameter> parameters; ///< that it declares, in its order
    std::vector<MaterialTexture> textures;     ///< that it declares, in its order
    uint32_t parameter_bytes = 0;              ///< of the std140 block with all parameters

    /// By name; null: there is none.
    PRELIGHT_API const MaterialParameter* find_parameter(std::string_view parameter) const;
    /// By name; null: there is none.
    PRELIGHT_API const MaterialTexture* find_texture(std::string_view texture) const;
};

/// Built-in ones, by name.
PRELIGHT_API const std::vector<std::shared_ptr<const MaterialShader>>& built_in_material_shaders();
/// Null: there is none of that name.
PRELIGHT_API std::shared_ptr<const MaterialShader> find_material_shader(std::string_view name);

/// Reads what `source` declares, not its code. Throws Error "FILE:LINE: REASON".
PRELIGHT_API std::shared_ptr<const MaterialShader> parse_material_shader(std::string name, std::string file,
                                                                         std::string source);
/// Reads a file, at most 1 MiB. Throws Error.
PRELIGHT_API std::shared_ptr<const MaterialShader> load_material_shader(const std::filesystem::path& file);
/// Compiles it, without optimising, for a pass that reads sums of light and for one that makes them, so that a
/// mistake is told before a scene is loaded. The passes that draw with it compile it when they are made. Throws
/// Error "FILE:LINE: REASON".
PRELIGHT_API void check_material_shader(const MaterialShader& shader);

/// Whether light comes through what it is on, so that it is drawn after all that is opaque (docs/transmission.md): the
/// built-in material `layered` with `transmission` above 0, whatever its textures say.
PRELIGHT_API bool transmits(const Material& material);

/// What of a material's parameters and textures does not fit its shader; nothing: all does.
PRELIGHT_API std::optional<std::string> material_fault(const Material& material);
/// Throws that as an Error that begins with `object`.
PRELIGHT_API void check_material(const Material& material, const std::string& object);

/// Gives all materials of that name the shader, and tangents to what they are on. Throws UsageError when there
/// is none of that name, Error when its parameters and textures do not fit.
PRELIGHT_API void assign_material_shader(Scene& scene, std::string_view material,
                                         std::shared_ptr<const MaterialShader> shader);

} // namespace prelight
