#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>
#include <scene/gltf/extras.hpp>
#include <scene/gltf/node_extras.hpp>

namespace prelight::gltf {
namespace {

/// Why a decal or an emitter cannot be what it says.
struct Unfit : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A number within low … high.
float within(const Item& item, std::string_view key, float absent, double low, double high) {
    const double value = item.number(key, absent);
    // The float nearest to a limit may lie beyond it.
    if (!(value >= low - 1e-6 && value <= high + 1e-6))
        throw Unfit(fmt::format("{} is {}, outside {:.6g} … {:.6g}", key, value, low, high));
    return static_cast<float>(value);
}

/// Two numbers, the second not below the first.
void read_span(const Item& item, std::string_view key, float& from, float& to, double low, double high) {
    const auto span = item.numbers<2>(key, {from, to});
    if (!(span[0] >= low && span[1] >= span[0] && span[1] <= high + 1e-6))
        throw Unfit(fmt::format("{} is [{}, {}]: wanted are two numbers within {:.6g} … {:.6g}, the smaller first", key,
                                span[0], span[1], low, high));
    from = static_cast<float>(span[0]);
    to = static_cast<float>(span[1]);
}

void read_channels(const Item& item, Decal& decal) {
    if (!item.has("channels"))
        return;
    decal.colour = decal.normal = decal.roughness = false;
    for (const std::string& channel : item.texts("channels")) {
        bool* const known = channel == "colour"      ? &decal.colour
                            : channel == "normal"    ? &decal.normal
                            : channel == "roughness" ? &decal.roughness
                                                     : nullptr;
        if (!known)
            throw Unfit(fmt::format("channel \"{}\" is not known (colour, normal, roughness)", printable(channel)));
        *known = true;
    }
}

Decal read_decal(const Document& document, const Item& item, const Scene& scene) {
    Decal decal;
    decal.material = item.required_index("material", document.count(Table::materials));
    if (scene.materials[decal.material].shader)
        throw Unfit(fmt::format("material {} has a shader of its own, and decals know none", decal.material));
    decal.opacity = within(item, "opacity", 1, 0, 1);
    const double order = item.number("order", 0);
    if (!(std::abs(order) <= std::numeric_limits<int32_t>::max()) || order != std::floor(order))
        throw Unfit("order is not a whole number of 32 bits");
    decal.order = static_cast<int32_t>(order);
    read_span(item, "fade", decal.fade_from, decal.fade_to, 0, std::numbers::pi / 2);
    read_channels(item, decal);
    return decal;
}

std::vector<glm::vec3> read_colours(const Item& item, std::vector<glm::vec3> absent) {
    const auto found = item.find("colours");
    if (!found)
        return absent;
    constexpr size_t most = 64;
    const auto bad = [&] {
        throw Unfit(fmt::format("colours is not an array of 1 to {} times three numbers ≥ 0", most));
    };
    simdjson::dom::array list;
    if (found->get_array().get(list) || list.size() == 0 || list.size() > most)
        bad();
    std::vector<glm::vec3> out;
    for (const simdjson::dom::element& element : list) {
        simdjson::dom::array channels;
        if (element.get_array().get(channels) || channels.size() != 3)
            bad();
        glm::vec3& colour = out.emplace_back();
        int c = 0;
        for (const simdjson::dom::element& channel : channels) {
            double value = 0;
            if (channel.get_double().get(value) || !(value >= 0) || !std::isfinite(static_cast<float>(value)))
                bad();
            colour[c++] = static_cast<float>(value);
        }
    }
    return out;
}

/// 1 to 64 numbers from 0 to `high`.
std::vector<float> read_steps(const Item& item, std::string_view key, std::vector<float> absent, double high) {
    const auto found = item.find(key);
    if (!found)
        return absent;
    constexpr size_t most = 64;
    const auto bad = [&] {
        throw Unfit(fmt::format("{} is not an array of 1 to {} numbers within 0 … {:.6g}", key, most, high));
    };
    simdjson::dom::array list;
    if (found->get_array().get(list) || list.size() == 0 || list.size() > most)
        bad();
    std::vector<float> out;
    for (const simdjson::dom::element& element : list) {
        double value = 0;
        if (element.get_double().get(value) || !(value >= 0 && value <= high))
            bad();
        out.push_back(static_cast<float>(value));
    }
    return out;
}

Emitter read_emitter(Document& document, const Item& item) {
    constexpr uint64_t most = 65536;
    constexpr double far = 1e6; // metres, seconds, candela: beyond it nothing is meant
    Emitter out;
    const uint64_t count = item.integer_or("count", out.count);
    if (count < 1 || count > most)
        throw Unfit(fmt::format("count is {}, outside 1 … {}", count, most));
    out.count = static_cast<uint32_t>(count);
    // Each particle's light and octahedron in the world, and on its way there.
    document.charge(item.label(), count, 1024);
    out.seed = item.integer_or("seed", out.seed);
    read_span(item, "lifetime", out.lifetime_from, out.lifetime_to, 1e-3, far);
    read_span(item, "speed", out.speed_from, out.speed_to, 0, far);
    out.cone = within(item, "cone", out.cone, 0, std::numbers::pi);
    out.radius = within(item, "radius", out.radius, 0, far);
    out.gravity = within(item, "gravity", out.gravity, -far, far);
    out.drag = within(item, "drag", out.drag, 0, far);
    if (item.has("ground"))
        out.ground = within(item, "ground", 0, -far, far);
    if (out.ground && (out.drag > 0 || !(out.gravity > 0)))
        throw Unfit("ground goes with a gravity above 0 and without drag");
    out.bounce = within(item, "bounce", out.bounce, 0, 1);
    out.slip = within(item, "slip", out.slip, 0, 1);
    out.colours = read_colours(item, out.colours);
    out.intensity = within(item, "intensity", out.intensity, 0, far);
    out.range = within(item, "range", out.range, 1e-3, far);
    out.lights = item.flag("lights", true);
    out.size = within(item, "size", out.size, 0, far);
    out.streak = within(item, "streak", out.streak, 0, far);
    if (out.size > 0)
        out.material = item.required_index("material", document.count(Table::materials));
    out.casts_shadow = item.flag("castsShadow", false);
    const std::string shape = item.text("shape");
    if (shape == "billboard")
        out.shape = ParticleShape::billboard;
    else if (!shape.empty() && shape != "octahedron")
        throw Unfit(fmt::format("shape \"{}\" is not known (octahedron, billboard)", printable(shape)));
    out.sizes = read_steps(item, "sizes", out.sizes, far);
    out.opacities = read_steps(item, "opacities", out.opacities, 1);
    out.spin = within(item, "spin", out.spin, 0, far);
    return out;
}

} // namespace

void read_node_extras(Document& document, const Item& item, Node& node, Scene& scene) {
    const auto own = own_extras(item);
    if (!own)
        return;
    node.receives_decals = own->flag("receivesDecals", true);
    if (const auto decal = own->object("decal")) {
        document.charge(decal->label(), 1, sizeof(Decal) + 4 * sizeof(PlacedDecal));
        try {
            scene.decals.push_back(read_decal(document, *decal, scene));
            node.decal = static_cast<uint32_t>(scene.decals.size() - 1);
        } catch (const Unfit& reason) {
            decal->warn("{}; the decal is left out", reason.what());
        }
    }
    if (const auto emitter = own->object("emitter")) {
        try {
            scene.emitters.push_back(read_emitter(document, *emitter));
            node.emitter = static_cast<uint32_t>(scene.emitters.size() - 1);
        } catch (const Unfit& reason) {
            emitter->warn("{}; the emitter is left out", reason.what());
        }
    }
}

} // namespace prelight::gltf
