#include "pictures.hpp"

#include "output.hpp"
#include "renderer_info.hpp"
#include "stats_state.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>
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

using Json = nlohmann::json;

/// What take_pictures() fills.
Json state_of(const RunReport& run) {
    const Comparison& d = run.difference;
    return {{"error", run.error},
            {"wrong_usage", run.wrong_usage},
            {"shading", run.options.shading ? Json(static_cast<int>(*run.options.shading)) : Json(nullptr)},
            {"form", run.form},
            {"psnr", std::isfinite(d.psnr) ? Json(d.psnr) : Json(nullptr)},
            {"flip", d.flip},
            {"off_share", d.off_share},
            {"block", {d.block, d.block_x, d.block_y}},
            {"left_out_share", d.left_out_share},
            {"pictures", run.pictures},
            {"stats", stats_state(run.stats)}};
}

void take_state(RunReport& run, const Json& state) {
    run.error = state.at("error");
    run.wrong_usage = state.at("wrong_usage");
    if (const Json& shading = state.at("shading"); !shading.is_null())
        run.options.shading = static_cast<Shading>(shading.get<int>());
    run.form = state.at("form");
    const Json& psnr = state.at("psnr");
    run.difference = {.psnr = psnr.is_null() ? std::numeric_limits<double>::infinity() : psnr.get<double>(),
                      .flip = state.at("flip"),
                      .off_share = state.at("off_share"),
                      .block = state.at("block").at(0),
                      .block_x = state.at("block").at(1),
                      .block_y = state.at("block").at(2),
                      .left_out_share = state.at("left_out_share")};
    run.pictures = state.at("pictures").get<std::map<std::string, std::string>>();
    run.stats = stats_from_state(state.at("stats"));
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
                                               const std::vector<std::string>& views, PictureStore& store) {
    std::map<std::string, std::string> files;
    for (const std::string& view : views)
        files[view] = store.add(name + "-" + view, renderer.read(view));
    return files;
}

void take(RunReport& run, Device& device, const World& world, const PlacedCamera& camera, References& references,
          PictureStore& store) {
    // As it is timed: a view among the pictures may be all that a setting has an effect on.
    create_renderer(run.variant.renderer, &device, run.options);
    RenderOptions options = run.options;
    options.count_pairs = true;
    const std::vector<std::string> views = views_to_show(run.info);
    options.views = views;
    options.views.emplace_back("linear"); // the difference is measured there
    if (std::ranges::find(run.info.settings, "texture-filter", &SettingInfo::key) != run.info.settings.end())
        options.settings.emplace("texture-filter", "bilinear");
    const auto renderer = create_renderer(run.variant.renderer, &device, options);
    renderer->set_world(world);
    renderer->render(camera);
    run.stats = renderer->stats();

    const ReferenceForm form = reference_form(run.stats.shading, run.stats.settings, options.msaa);
    run.form = form_name(form);
    const References::Picture& reference = references.of(form);
    Image errors;
    run.difference = compare(renderer->read("linear"), reference.linear, reference.left_out, &errors);
    for (glm::vec3& pixel : errors.pixels)
        pixel = error_colour(pixel.r);
    run.pictures = store_views(*renderer, run.variant.name(), views, store);
    run.pictures["difference"] = store.add(run.variant.name() + "-difference", errors);
}

} // namespace

PictureStore::PictureStore(ReportFolder& folder, KeptSteps& kept) : folder_(folder), kept_(kept) {
    const Json* state = kept.find("pictures");
    if (!state || restore(*state))
        return;
    kept.forget(); // the steps speak of pictures that are not there
    files_.clear();
    names_.clear();
}

bool PictureStore::restore(const Json& state) {
    for (const auto& [hash, file] : state.at("files").items()) {
        const std::string name = file.get<std::string>();
        const std::optional<std::string> bytes = kept_.find_file(name.substr(name.rfind('/') + 1));
        if (!bytes)
            return false;
        folder_.write([&](const std::filesystem::path& folder) { save_text(*bytes, folder / name); });
        files_[std::stoull(hash)] = name;
    }
    names_ = state.at("names").get<std::map<std::string, int>>();
    return true;
}

void PictureStore::keep() {
    Json files = Json::object();
    for (const auto& [hash, file] : files_)
        files[std::to_string(hash)] = file;
    kept_.keep("pictures", {{"files", std::move(files)}, {"names", names_}});
}

std::string PictureStore::add(const std::string& name, const Image& display) {
    const auto known = files_.try_emplace(hash_of(display));
    std::string& picture = known.first->second;
    if (!known.second)
        return picture;
    std::string file;
    for (const char c : name) // '@' and '=' would need escapes in an address
        file += std::isalnum(static_cast<unsigned char>(c)) || c == '.' ? c : '-';
    if (const int before = names_[file]++)
        file += fmt::format("-{}", before + 1);
    picture = "pictures/" + file + ".png";
    folder_.write([&](const std::filesystem::path& folder) {
        save_png(display, folder / picture);
        kept_.keep_file(file + ".png", folder / picture);
    });
    return picture;
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

void take_or_find_pictures(RunReport& run, Device& device, const World& world, const PlacedCamera& camera,
                           References& references, PictureStore& store, KeptSteps& kept) {
    const std::string step = "picture of " + run.variant.name();
    if (const Json* state = kept.find(step))
        return take_state(run, *state);
    take_pictures(run, device, world, camera, references, store);
    if (!run.error.empty() && !run.wrong_usage)
        return; // another run may have more luck
    store.keep();
    kept.keep(step, state_of(run));
}

void take_reference_pictures(Report& report, const World& world, const PlacedCamera& camera, PictureStore& store,
                             KeptSteps& kept) {
    if (const Json* state = kept.find("reference")) {
        report.reference_ms = state->at("ms");
        report.reference_pictures = state->at("pictures").get<std::map<std::string, std::string>>();
        return;
    }
    const RendererInfo info = find_renderer("reference");
    RenderOptions options = report.command.options;
    options.views = views_to_show(info);
    const auto renderer = create_renderer(info.name, nullptr, options);
    renderer->set_world(world);
    renderer->render(camera);
    report.reference_ms = renderer->stats().wall_ms.median;
    report.reference_pictures = store_views(*renderer, "reference", options.views, store);
    store.keep();
    kept.keep("reference", {{"ms", report.reference_ms}, {"pictures", report.reference_pictures}});
}

} // namespace prelight::app
