#include "pictures.hpp"

#include "renderer_info.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <prelight/error.hpp>

namespace prelight::app {
namespace {

/// FNV-1a over size and 8-bit values, which is what the file would hold.
uint64_t hash_of(const Image& image) {
    uint64_t hash = 0xcbf29ce484222325u;
    const auto add = [&](uint64_t value) { hash = (hash ^ value) * 0x100000001b3u; };
    add(image.width);
    for (const glm::vec3& pixel : image.pixels)
        for (int channel = 0; channel < 3; ++channel)
            add(static_cast<uint64_t>(std::lround(std::clamp(pixel[channel], 0.0f, 1.0f) * 255)));
    return hash;
}

/// FLIP 0 … 1 as a colour, from black through violet, red and orange to pale yellow. The root lets
/// errors of a hundredth be seen.
glm::vec3 error_colour(float error) {
    static constexpr std::array<glm::vec3, 6> ramp{{{0.00f, 0.00f, 0.02f},
                                                    {0.25f, 0.08f, 0.43f},
                                                    {0.60f, 0.16f, 0.50f},
                                                    {0.91f, 0.30f, 0.36f},
                                                    {0.99f, 0.65f, 0.40f},
                                                    {0.99f, 0.99f, 0.78f}}};
    const float place = std::sqrt(std::clamp(error, 0.0f, 1.0f)) * (ramp.size() - 1);
    const size_t below = std::min(static_cast<size_t>(place), ramp.size() - 2);
    return glm::mix(ramp[below], ramp[below + 1], place - static_cast<float>(below));
}

/// The views that a person looks at: all but "linear", which no PNG can hold.
std::vector<std::string> views_to_show(const RendererInfo& info) {
    std::vector<std::string> views = info.views;
    std::erase(views, "linear");
    return views;
}

std::map<std::string, std::string> store_views(Renderer& renderer, const std::string& name,
                                               const std::vector<std::string>& views,
                                               PictureStore& store) {
    std::map<std::string, std::string> files;
    for (const std::string& view : views)
        files[view] = store.add(name + "-" + view, renderer.read(view));
    return files;
}

void take(RunReport& run, Device& device, const World& world, const PlacedCamera& camera,
          References& references, PictureStore& store) {
    RenderOptions options = run.options;
    options.count_pairs = true;
    const std::vector<std::string> views = views_to_show(run.info);
    options.views = views;
    options.views.emplace_back("linear"); // the difference is measured there
    if (std::ranges::find(run.info.settings, "texture-filter", &SettingInfo::key) !=
        run.info.settings.end())
        options.settings.emplace("texture-filter", "bilinear");
    const auto renderer = create_renderer(run.variant.renderer, &device, options);
    renderer->set_world(world);
    renderer->render(camera);
    run.stats = renderer->stats();

    const ReferenceForm form = reference_form(run.stats.shading, run.stats.settings);
    run.form = form_name(form);
    const References::Picture& reference = references.of(form);
    Image errors;
    run.difference =
        compare(renderer->read("linear"), reference.linear, reference.left_out, &errors);
    for (glm::vec3& pixel : errors.pixels)
        pixel = error_colour(pixel.r);
    run.pictures = store_views(*renderer, run.variant.name(), views, store);
    run.pictures["difference"] = store.add(run.variant.name() + "-difference", errors);
}

} // namespace

std::string PictureStore::add(const std::string& name, const Image& display) {
    const auto [known, is_new] = files_.try_emplace(hash_of(display));
    if (!is_new)
        return known->second;
    std::string file;
    for (const char c : name) // '@' and '=' would need escapes in an address
        file += std::isalnum(static_cast<unsigned char>(c)) || c == '.' ? c : '-';
    if (const int before = names_[file]++)
        file += fmt::format("-{}", before + 1);
    known->second = "pictures/" + file + ".png";
    folder_.write([&](const std::filesystem::path& folder) {
        save_png(display, folder / known->second);
    });
    return known->second;
}

void take_pictures(RunReport& run, Device& device, const World& world, const PlacedCamera& camera,
                   References& references, PictureStore& store) {
    try {
        take(run, device, world, camera, references, store);
    } catch (const UsageError& error) {
        run.error = error.what();
        run.wrong_usage = true;
    } catch (const Error& error) {
        run.error = error.what();
    }
}

void take_reference_pictures(Report& report, const World& world, const PlacedCamera& camera,
                             PictureStore& store) {
    const RendererInfo info = find_renderer("reference");
    RenderOptions options = report.command.options;
    options.views = views_to_show(info);
    const auto renderer = create_renderer(info.name, nullptr, options);
    renderer->set_world(world);
    renderer->render(camera);
    report.reference_ms = renderer->stats().wall_ms.median;
    report.reference_pictures = store_views(*renderer, "reference", options.views, store);
}

} // namespace prelight::app
