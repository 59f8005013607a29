#include <algorithm>
#include <cctype>
#include <cmath>
#include <fmt/format.h>
#include <prelight/error.hpp>
#include <prelight/scene_io.hpp>
#include <scene/check_environment.hpp>

namespace prelight {
namespace {

Image load_any(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    if (ending == ".hdr" || ending == ".pic")
        return load_hdr(path);
    if (ending == ".exr")
        return load_exr(path);
    if (ending != ".png")
        throw Error(fmt::format("{}: an environment map ends in .hdr, .exr or .png", path.string()));
    Image image = load_png(path);
    for (glm::vec3& pixel : image.pixels)
        for (int c = 0; c < 3; ++c)
            pixel[c] = srgb_decode(pixel[c]);
    return image;
}

/// `what` it is of an environment, for messages.
void check_map(const std::string& name, std::string_view what, const Image& image) {
    constexpr uint32_t widest = 16384;
    if (image.height == 0 || image.width != 2 * image.height)
        throw Error(fmt::format("{}: an environment {} is twice as wide as high, and this one has {}x{} pixels", name,
                                what, image.width, image.height));
    if (image.width > widest)
        throw Error(fmt::format("{}: an environment {} of {}x{} pixels: {} wide is the most", name, what, image.width,
                                image.height, widest));
    for (const glm::vec3& p : image.pixels)
        for (int c = 0; c < 3; ++c)
            if (!(p[c] >= 0) || !std::isfinite(p[c]))
                throw Error(fmt::format("{}: a pixel of the environment {} is negative or not finite", name, what));
}

} // namespace

Environment load_environment(const std::filesystem::path& path) {
    Environment environment{.name = path.string(), .image = load_any(path)};
    check_environment(environment);
    return environment;
}

void check_environment(const Environment& environment) {
    check_map(environment.name, "map", environment.image);
    if (!environment.backdrop.pixels.empty())
        check_map(environment.name, "backdrop", environment.backdrop);
    if (!(environment.intensity >= 0) || !std::isfinite(environment.intensity) || !std::isfinite(environment.rotation))
        throw Error(fmt::format("{}: the environment's intensity is negative, or it or its rotation is not finite",
                                environment.name));
}

} // namespace prelight
