#include "boxes.hpp"
#include "words.hpp"
#include <prelight/material_shader.hpp>

namespace prelight::python {
namespace {

using MaterialEntry = Entry<Material>;

template <TextureRef Material::*Texture>
void texture_field(py::class_<MaterialEntry>& made, const char* name, const char* doc) {
    made.def_property(
        name,
        [](const MaterialEntry& entry) -> std::optional<uint32_t> {
            const TextureRef& texture = entry.get().*Texture;
            return texture ? std::optional(texture.image) : std::nullopt;
        },
        [](MaterialEntry& entry, std::optional<uint32_t> image) {
            if (image)
                (entry.edit().*Texture).image = *image;
            else
                entry.edit().*Texture = {};
        },
        doc);
}

py::dict parameters_of(const Material& material) {
    py::dict parameters;
    for (const auto& [name, value] : material.parameters) {
        const MaterialParameter* declared = material.shader ? material.shader->find_parameter(name) : nullptr;
        const auto components = py::ssize_t(declared ? declared->components : 4);
        parameters[py::str(name)] = read_only(py::array_t<float>(components, &value[0]));
    }
    return parameters;
}

void set_parameters(Material& material, const py::dict& given) {
    std::map<std::string, glm::vec4> parameters;
    for (const auto& [key, value] : given) {
        const auto name = py::str(key).cast<std::string>();
        const auto numbers = to_array<float>({py::reinterpret_borrow<py::object>(value)}, "parameter " + name);
        if (numbers.size() < 1 || numbers.size() > 4 || numbers.ndim() > 1)
            throw UsageError("parameter " + name + ": one to four numbers are needed, not shape " + shape_of(numbers));
        glm::vec4& parameter = parameters.emplace(name, glm::vec4(0)).first->second;
        for (py::ssize_t i = 0; i < numbers.size(); ++i)
            parameter[int(i)] = numbers.data()[i];
    }
    Material changed = material;
    changed.parameters = std::move(parameters);
    check_material(changed, "material \"" + changed.name + "\"");
    material = std::move(changed);
}

void check_one(const Scene& scene, const Material& m) {
    const auto refuse = [&](const std::string& why) { throw UsageError("material \"" + m.name + "\": " + why); };
    const auto share = [](float value) { return value >= 0 && value <= 1; };
    const auto amount = [](float value) { return value >= 0 && std::isfinite(value); };
    if (!(amount(m.base_colour.x) && amount(m.base_colour.y) && amount(m.base_colour.z) && share(m.base_colour.w)))
        refuse("base_colour is not three finite numbers of 0 or more, and alpha in 0 ... 1");
    if (!share(m.metallic) || !share(m.roughness) || !share(m.occlusion_strength))
        refuse("metallic, roughness or occlusion_strength is not in 0 ... 1");
    if (!(amount(m.emissive.x) && amount(m.emissive.y) && amount(m.emissive.z)))
        refuse("emissive is not three finite numbers of 0 or more");
    if (!amount(m.alpha_cutoff) || !std::isfinite(m.normal_scale))
        refuse("alpha_cutoff or normal_scale is not a finite number");
    for (const TextureRef* texture : {&m.base_colour_texture, &m.metallic_roughness_texture, &m.normal_texture,
                                      &m.occlusion_texture, &m.emissive_texture})
        if (*texture && texture->image >= scene.images.size())
            refuse("texture " + std::to_string(texture->image) + " is none of the scene's " +
                   std::to_string(scene.images.size()) + " images");
}

/// What a shader reads of a vertex must be there.
void check_tangents(const Scene& scene) {
    for (const Mesh& mesh : scene.meshes)
        for (const Primitive& primitive : mesh.primitives)
            if (scene.materials.at(primitive.material).normal_texture && primitive.tangents.empty())
                throw UsageError("mesh \"" + mesh.name + "\": material \"" + scene.materials[primitive.material].name +
                                 "\" has a normal map, which needs tangents: give them to add_mesh()");
}

} // namespace

void check_scene(const Scene& scene) {
    for (const Material& material : scene.materials)
        check_one(scene, material);
    check_tangents(scene);
}

void bind_materials(py::module_& module) {
    py::class_<MaterialEntry> material(
        module, "Material",
        "glTF's metallic-roughness material. Textures are numbers of the scene's images: base "
        "colour and emissive ones hold sRGB, the others are linear.");
    material.def(py::init([](std::string name, const ArrayLike& base_colour, float metallic, float roughness,
                             const ArrayLike& emissive, AlphaMode alpha_mode, float alpha_cutoff, bool double_sided,
                             bool unlit) {
                     return MaterialEntry(Material{.name = std::move(name),
                                                   .base_colour = to_vector<glm::vec4>(base_colour, "base_colour"),
                                                   .metallic = metallic,
                                                   .roughness = roughness,
                                                   .emissive = to_vector<glm::vec3>(emissive, "emissive"),
                                                   .alpha_mode = alpha_mode,
                                                   .alpha_cutoff = alpha_cutoff,
                                                   .double_sided = double_sided,
                                                   .unlit = unlit});
                 }),
                 py::arg("name") = "", py::kw_only(), py::arg("base_colour") = ArrayLike{py::make_tuple(1, 1, 1, 1)},
                 py::arg("metallic") = 0.0f, py::arg("roughness") = 1.0f,
                 py::arg("emissive") = ArrayLike{py::make_tuple(0, 0, 0)}, py::arg("alpha_mode") = AlphaMode::opaque,
                 py::arg("alpha_cutoff") = 0.5f, py::arg("double_sided") = false, py::arg("unlit") = false);
    field(
        material, "name", [](auto& m) -> auto& { return m.name; }, "For messages, and Scene.assign_shader().");
    vector_field(
        material, "base_colour", [](auto& m) -> auto& { return m.base_colour; }, "(4,) float32, linear RGBA.");
    field(
        material, "metallic", [](auto& m) -> auto& { return m.metallic; }, "0 ... 1.");
    field(
        material, "roughness", [](auto& m) -> auto& { return m.roughness; }, "Perceptual, 0 ... 1.");
    vector_field(
        material, "emissive", [](auto& m) -> auto& { return m.emissive; }, "(3,) float32, linear RGB, 0 or more.");
    field(
        material, "normal_scale", [](auto& m) -> auto& { return m.normal_scale; },
        "Factor on the normal map's X and Y.");
    field(
        material, "occlusion_strength", [](auto& m) -> auto& { return m.occlusion_strength; },
        "0 ... 1, on ambient light only.");
    field(
        material, "alpha_mode", [](auto& m) -> auto& { return m.alpha_mode; }, "opaque, mask or blend.");
    field(
        material, "alpha_cutoff", [](auto& m) -> auto& { return m.alpha_cutoff; },
        "Of mask: a surface with less alpha is not there.");
    field(
        material, "double_sided", [](auto& m) -> auto& { return m.double_sided; }, "Whether its back shows.");
    field(
        material, "unlit", [](auto& m) -> auto& { return m.unlit; }, "Shows its base colour, without light.");
    texture_field<&Material::base_colour_texture>(material, "base_colour_texture", "Number of an image, or None.");
    texture_field<&Material::metallic_roughness_texture>(material, "metallic_roughness_texture",
                                                         "Number of an image (G roughness, B metallic), or None.");
    texture_field<&Material::normal_texture>(material, "normal_texture",
                                             "Number of an image (tangent space, +Y up), or None.");
    texture_field<&Material::occlusion_texture>(material, "occlusion_texture", "Number of an image (R), or None.");
    texture_field<&Material::emissive_texture>(material, "emissive_texture", "Number of an image, or None.");
    material.def_property_readonly(
        "shader",
        [](const MaterialEntry& entry) {
            return entry.get().shader ? std::optional(entry.get().shader->name) : std::nullopt;
        },
        "Name of its shader (Scene.assign_shader), or None: the renderer's own.");
    material.def_property(
        "parameters", [](const MaterialEntry& entry) { return parameters_of(entry.get()); },
        [](MaterialEntry& entry, const py::dict& given) { set_parameters(entry.edit(), given); },
        "Of its shader, by name: one to four numbers each. Assign a whole dict to change them.");
    material.def("__repr__", [](const MaterialEntry& entry) {
        const Material& m = entry.get();
        return py::str(
                   "Material({!r}, base_colour=({:.4g}, {:.4g}, {:.4g}, {:.4g}), metallic={:.4g}, roughness={:.4g})")
            .format(m.name, m.base_colour.x, m.base_colour.y, m.base_colour.z, m.base_colour.w, m.metallic,
                    m.roughness);
    });
    bind_entries<Material>(module, "MaterialList", "The materials of a scene; Scene.add_material() adds one.");
    module.def(
        "material_shaders",
        [] {
            std::map<std::string, std::string> described;
            for (const auto& shader : built_in_material_shaders())
                described[shader->name] = shader->description;
            return described;
        },
        "The built-in shaders of materials: name and what it is for.");
}

} // namespace prelight::python
