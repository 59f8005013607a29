#include <array>
#include <scene/procedural/city_neon.hpp>
#include <scene/procedural/city_plan.hpp>
#include <scene/procedural/city_textures.hpp>
#include <string_view>

namespace prelight::city {
namespace {

struct Word {
    std::string_view text;
    Glow letters, border;
};

/// A blade sign at right angles to the wall: letters on both faces, a border tube, lights around
/// it. `side`: +1 on the wall at +x, −1 on the one at −x.
void blade(Plan& plan, const Word& word, float side, float z, float base) {
    constexpr float letter = 0.62f, step = 0.80f, half = 0.36f, thick = 0.11f;
    const float height = step * static_cast<float>(word.text.size()) + 0.35f;
    const glm::vec3 centre(side * (house_line - 0.95f), base, z);
    MeshBuilder b;
    b.frame.origin = centre;
    b.use(Surface::board, glm::vec3(0.025f, 0.025f, 0.035f));
    b.box({-half, 0, -thick}, {half, height, thick});
    b.use(Surface::metal);
    for (const float y : {0.3f, height - 0.3f}) {
        const float wall = side * 0.97f, edge = side * (half - 0.01f);
        b.cone({edge, y, 0}, {wall, y, 0}, 0.035f, 0.035f, 8);
    }
    for (const float facing : {1.0f, -1.0f}) {
        b.frame.s = {facing, 0, 0};
        b.frame.d = {0, 0, facing};
        b.use(word.letters);
        for (size_t i = 0; i < word.text.size(); ++i)
            neon_letter(b, word.text[i],
                        {-letter / 4, height - 0.15f - step * static_cast<float>(i + 1) + 0.09f, thick + 0.045f},
                        letter, 0.026f);
        b.use(word.border);
        constexpr float w = half - 0.05f;
        const std::array<glm::vec3, 5> ring{{{-w, 0.05f, thick + 0.035f},
                                             {w, 0.05f, thick + 0.035f},
                                             {w, height - 0.05f, thick + 0.035f},
                                             {-w, height - 0.05f, thick + 0.035f},
                                             {-w, 0.05f, thick + 0.035f}}};
        b.tube(ring, 0.017f, 6);
    }
    const auto lights = static_cast<uint32_t>(word.text.size() / 3 + 1);
    for (uint32_t i = 0; i < lights; ++i)
        for (const float facing : {1.0f, -1.0f}) {
            const float y = height * (static_cast<float>(i) + 0.5f) / static_cast<float>(lights);
            const Glow colour = i % 3 == 2 ? word.border : word.letters;
            plan.add_point(Rank::neon, centre + glm::vec3(-side * 0.45f, y, facing * 0.6f), glow_colour(colour), 7,
                           6.5f);
        }
    // One that reaches across the street: its streak on the wet asphalt is seen from afar.
    plan.add_point(Rank::neon, centre + glm::vec3(-side * 1.4f, height / 2, 0), glow_colour(word.letters), 19, 28);
    plan.build(b, "blade sign", centre);
}

/// A line of tube along a façade's cornice.
void edge_tube(Plan& plan, float side, float z0, float z1, float y, Glow colour) {
    MeshBuilder b;
    b.use(colour);
    const float x = side * (house_line - 0.30f);
    b.cone({x, y, z0}, {x, y, z1}, 0.025f, 0.025f, 8);
    const auto lights = static_cast<uint32_t>(std::abs(z1 - z0) / 2.2f) + 1;
    for (uint32_t i = 0; i < lights; ++i) {
        const float z = glm::mix(z0, z1, (static_cast<float>(i) + 0.5f) / static_cast<float>(lights));
        plan.add_point(Rank::neon, {x - side * 0.25f, y, z}, glow_colour(colour), 2.2f, 4.2f);
    }
    plan.build(b, "light line");
}

/// The town's name over the street: two girders between the houses with letters towards +z.
void arch(Plan& plan, std::string_view text, float z, float y) {
    constexpr float letter = 1.5f, girder = 0.09f, reach = house_line;
    const float half = neon_width(text, letter) / 2;
    MeshBuilder b;
    b.frame.origin = {0, y, z};
    b.use(Surface::metal);
    for (const float at : {-0.35f, letter + 0.35f})
        b.box({-reach, at - girder, -girder}, {reach, at + girder, girder}, top | bottom | front | back);
    const auto bays = static_cast<uint32_t>(2 * reach / 1.7f);
    for (uint32_t i = 0; i < bays; ++i) { // lattice
        const float a = -reach + 2 * reach * static_cast<float>(i) / static_cast<float>(bays);
        const float c = -reach + 2 * reach * static_cast<float>(i + 1) / static_cast<float>(bays);
        const bool rising = i % 2 == 0;
        b.cone({a, rising ? -0.35f : letter + 0.35f, 0}, {c, rising ? letter + 0.35f : -0.35f, 0}, 0.025f, 0.025f, 6);
    }
    b.use(Glow::cyan);
    neon_row(b, text, {-half, 0, 0.14f}, letter, 0.05f);
    b.use(Glow::magenta);
    for (const float at : {-0.28f, letter + 0.28f})
        b.cone({-half - 0.6f, at, 0.13f}, {half + 0.6f, at, 0.13f}, 0.03f, 0.03f, 8);
    for (uint32_t i = 0; i < text.size(); ++i) {
        const float s = 2 * half * ((static_cast<float>(i) + 0.5f) / static_cast<float>(text.size()) - 0.5f);
        plan.add_point(Rank::neon, {s, y + (i % 2 == 0 ? 0.2f : 1.3f), z + (i % 2 == 0 ? 0.7f : -0.7f)},
                       glow_colour(i % 4 < 2 ? Glow::cyan : Glow::magenta), 12, i % 4 == 0 ? 34.0f : 10.0f);
    }
    plan.build(b, "arch", {0, y, z});
}

} // namespace

void add_signs(Plan& plan) {
    static constexpr std::array<Word, 14> words{{{"HOTEL", Glow::red, Glow::amber},
                                                 {"RAMEN", Glow::pink, Glow::cyan},
                                                 {"BAR", Glow::cyan, Glow::magenta},
                                                 {"JAZZ", Glow::blue, Glow::violet},
                                                 {"CINEMA", Glow::amber, Glow::red},
                                                 {"CAFE", Glow::green, Glow::yellow},
                                                 {"CLUB", Glow::magenta, Glow::blue},
                                                 {"BOOKS", Glow::yellow, Glow::green},
                                                 {"24H", Glow::cool_white, Glow::red},
                                                 {"ARCADE", Glow::violet, Glow::cyan},
                                                 {"NOODLES", Glow::orange, Glow::pink},
                                                 {"DISCO", Glow::pink, Glow::violet},
                                                 {"PIZZA", Glow::green, Glow::red},
                                                 {"LUX", Glow::cyan, Glow::blue}}};
    arch(plan, "PRELIGHT", cross_z - cross_line - 1.5f, 8.6f);
    const uint32_t shift = plan.random.below(words.size());
    for (const float side : {-1.0f, 1.0f}) {
        uint32_t next = shift + (side > 0 ? words.size() / 2 : 0);
        for (float z = 9 - side * 1.7f; z > street_far + 8; z -= plan.uniform(6.0f, 9.5f)) {
            if (std::abs(z - cross_z) < cross_line + 1)
                continue;
            blade(plan, words[next++ % words.size()], side, z, plan.uniform(4.5f, 6.5f));
        }
    }
    for (const float side : {-1.0f, 1.0f})
        for (float z = 4; z > street_far + 20; z -= plan.uniform(22, 30)) {
            const float end = z - plan.uniform(7, 10);
            if (std::abs(z - cross_z) < cross_line + 11)
                continue;
            edge_tube(plan, side, z, end, 4.47f,
                      static_cast<Glow>(static_cast<uint32_t>(Glow::pink) + plan.random.below(6)));
        }
}

} // namespace prelight::city
