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
        if (scene.ambient[c] >= 0 && std::isfinite(scene.ambient[c]))
            continue;
        own.warn("ambient holds {}, which is negative or too large; 0 is used", ambient[size_t(c)]);
        scene.ambient[c] = 0;
    }
}

void read_environment(const Document& document, const Item& own, Textures& textures, Scene& scene) {
    const auto object = own.object("environment");
    if (!object)
        return;
    /// Nothing, with a warning, where there is no such picture or it has another shape.
    const auto take = [&](uint32_t index, std::string_view what) {
        std::optional<TextureImage> picture = textures.take(index);
        if (picture && picture->width != 2 * picture->height) {
            object->warn("an environment {} is twice as wide as high, and this one has {}x{} pixels; it is left out",
                         what, picture->width, picture->height);
            picture.reset();
        }
        return picture;
    };
    const auto picture = take(object->required_index("source", document.count(Table::images)), "map");
    if (!picture)
        return;
    Environment environment{.name = picture->name, .image = from_picture(*picture)};
    if (const auto index = object->index("backdrop", document.count(Table::images)))
        if (const auto backdrop = take(*index, "backdrop"))
            environment.backdrop = from_picture(*backdrop);
    environment.intensity = object->real_within("intensity", 1, 0, std::numeric_limits<float>::max());
    environment.rotation = object->number("rotation", 0);
    environment.background = object->flag("background", true);
    scene.environment = std::make_shared<Environment>(std::move(environment));
}

float above_zero(const Item& own, const char* key, float absent) {
    const float value = own.real(key, absent);
    if (value > 0)
        return value;
    own.warn("{} {} is not above 0; {} is used", key, value, absent);
    return absent;
}

void read_light(const Item& own, Light& light) {
    const std::string falloff = own.text("falloff");
    if (falloff == "linear")
        light.falloff = Falloff::linear;
    else if (falloff == "quadratic")
        light.falloff = Falloff::quadratic;
    else if (!falloff.empty())
        own.warn("falloff \"{}\" is not known; glTF's own is used", printable(falloff));
    if (light.falloff != Falloff::gltf && !std::isfinite(light.range)) {
        own.warn("falloff {} needs a range; glTF's own is used", falloff);
        light.falloff = Falloff::gltf;
    }
    light.shininess = above_zero(own, "shininess", 1);
    light.casts_shadow = own.flag("castsShadow", true);
    light.size = above_zero(own, "size", light.size);
}

/// A cookie or profile that the light cannot throw is taken away.
void check_distribution(const Item& item, const Scene& scene, Light& light) {
    if (const auto fault = light_fault(scene, light)) {
        item.warn("{}; it shines without", *fault);
        light.cookie = no_cookie;
        light.profile.reset();
    }
}

} // namespace

std::optional<Item> own_extras(const Item& item) {
    const auto extras = item.find("extras");
    if (!extras || !extras->is_object())
        return {};
    return Item(item.warnings(), item.label() + " extras", *extras).object("prelight");
}

void read_extras(Document& document, Buffers& buffers, Textures& textures, const Places& lights, Scene& scene) {
    if (const auto own = own_extras(document.root())) {
        read_ambient(*own, scene);
        read_environment(document, *own, textures, scene);
    }
    LightDistributions distributions(document, buffers, textures);
    for (size_t i = 0; i < lights.size(); ++i) {
        const Item item = document.item(Table::lights, i);
        const auto own = lights[i] ? own_extras(item) : std::nullopt;
        if (!own)
            continue;
        Light& light = scene.lights[*lights[i]];
        read_light(*own, light);
        distributions.read(*own, light);
        check_distribution(item, scene, light);
    }
}

} // namespace prelight::gltf
