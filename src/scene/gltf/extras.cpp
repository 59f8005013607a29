#include <cmath>
#include <fmt/format.h>
#include <prelight/light_distribution.hpp>
#include <scene/environment_codes.hpp>
#include <scene/gltf/extras.hpp>
#include <scene/gltf/light_distributions.hpp>

namespace prelight::gltf {
namespace {

void read_ambient(const Item& own, Scene& scene) {
    const auto ambient = own.numbers<3>("ambient", {0, 0, 0});
    for (int c = 0; c < 3; ++c) {
        scene.ambient[c] = float(ambient[size_t(c)]);
        if (!(scene.ambient[c] >= 0) || !std::isfinite(scene.ambient[c]))
            own.fail("ambient is negative or too large");
    }
}

void read_environment(const Document& document, const Item& own, Textures& textures, Scene& scene) {
    const auto object = own.object("environment");
    if (!object)
        return;
    const auto take = [&](uint32_t index, std::string_view what) {
        TextureImage picture = textures.take(index);
        if (picture.width != 2 * picture.height)
            object->fail(fmt::format("an environment {} is twice as wide as high, and this one has {}x{} pixels", what,
                                     picture.width, picture.height));
        return picture;
    };
    const TextureImage picture = take(object->required_index("source", document.count(Table::images)), "map");
    Environment environment{.name = picture.name, .image = from_picture(picture)};
    if (const auto backdrop = object->index("backdrop", document.count(Table::images)))
        environment.backdrop = from_picture(take(*backdrop, "backdrop"));
    environment.intensity = object->real("intensity", 1);
    environment.rotation = object->number("rotation", 0);
    environment.background = object->flag("background", true);
    if (!(environment.intensity >= 0))
        object->fail("intensity is negative");
    scene.environment = std::make_shared<Environment>(std::move(environment));
}

void read_light(const Item& own, Light& light) {
    const std::string falloff = own.text("falloff");
    if (falloff == "linear")
        light.falloff = Falloff::linear;
    else if (falloff == "quadratic")
        light.falloff = Falloff::quadratic;
    else if (!falloff.empty())
        own.fail(fmt::format("falloff \"{}\" is not known", printable(falloff)));
    if (light.falloff != Falloff::gltf && !std::isfinite(light.range))
        own.fail(fmt::format("falloff {} needs a range", falloff));
    light.shininess = own.real("shininess", 1);
    if (!(light.shininess > 0))
        own.fail("shininess is not above 0");
    light.casts_shadow = own.flag("castsShadow", true);
    light.size = own.real("size", light.size);
}

} // namespace

std::optional<Item> own_extras(const Item& item) {
    const auto extras = item.find("extras");
    if (!extras || !extras->is_object())
        return {};
    return Item(item.file(), item.label() + " extras", *extras).object("prelight");
}

void read_extras(Document& document, Buffers& buffers, Textures& textures, Scene& scene) {
    if (const auto own = own_extras(document.root())) {
        read_ambient(*own, scene);
        read_environment(document, *own, textures, scene);
    }
    LightDistributions distributions(document, buffers, textures);
    for (size_t i = 0; i < scene.lights.size(); ++i)
        if (const auto own = own_extras(document.item(Table::lights, i))) {
            read_light(*own, scene.lights[i]);
            distributions.read(*own, scene.lights[i]);
            check_light(scene, scene.lights[i], fmt::format("{}: {}", document.file(), document.label(Table::lights, i)));
        }
}

} // namespace prelight::gltf
