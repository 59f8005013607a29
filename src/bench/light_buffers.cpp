#include "light_wall.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <image/luminance.hpp>
#include <prelight/bench_light_buffers.hpp>
#include <prelight/renderer.hpp>

namespace prelight {
namespace {

using Specular = ReferenceForm::Specular;

struct Row {
    const char* name;
    const char* light_buffer;
    const char* specular;
    Specular way;
    uint32_t bytes;
    double scale = 1;
};
constexpr Row rows[] = {
    {"RGBA16F pair", "rgba16f", "stored", Specular::stored, 16},
    {"R11G11B10F pair", "r11g11b10f", "stored", Specular::stored, 8},
    {"RGB10A2 pair", "rgb10a2", "stored", Specular::stored, 8},
    {"RGBA8 pair", "rgba8", "stored", Specular::stored, 8},
    {"RGBA8 pair, 4 x headroom", "rgba8", "stored", Specular::stored, 8, 4},
    {"RGBA16F packed", "packed-rgba16f", "stored", Specular::stored, 8},
    {"RGBA8 packed", "packed-rgba8", "stored", Specular::stored, 4},
    {"LUV, RGBA16F", "packed-rgba16f", "luv", Specular::luv, 8},
    {"LUV, RGBA8", "packed-rgba8", "luv", Specular::luv, 4},
    {"fifth channel, RGBA16F", "packed-rgba16f", "fifth-channel", Specular::fifth_channel, 10},
    {"fifth channel, RGBA8", "packed-rgba8", "fifth-channel", Specular::fifth_channel, 5},
    {"luminance, RGBA16F", "packed-rgba16f", "luminance", Specular::luminance, 8},
    {"luminance, RGBA8", "packed-rgba8", "luminance", Specular::luminance, 4},
    {"bent rule, RGBA16F", "packed-rgba16f", "bent", Specular::bent, 8},
    {"bent rule, RGBA8", "packed-rgba8", "bent", Specular::bent, 4},
};

/// Adds up errors against reference values.
class Errors {
public:
    void add(double value, double reference) {
        const double error = value - reference;
        squares_ += error * error;
        most_ = std::max(most_, std::abs(error));
        sum_ += error;
        reference_ += reference;
        ++count_;
    }
    LightSumError result() const {
        const double mean = reference_ / count_;
        return {std::sqrt(squares_ / count_) / mean, most_ / mean, sum_ / count_ / mean};
    }

private:
    double squares_ = 0, most_ = 0, sum_ = 0, reference_ = 0, count_ = 0;
};

LightSumError colour_error(const Image& picture, const Image& reference) {
    Errors errors;
    for (size_t i = 0; i < picture.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c)
            errors.add(double(picture.pixels[i][c]), double(reference.pixels[i][c]));
    return errors.result();
}

LightSumError luminance_error(const Image& picture, const Image& reference) {
    Errors errors;
    for (size_t i = 0; i < picture.pixels.size(); ++i)
        errors.add(luminance(picture.pixels[i]), luminance(reference.pixels[i]));
    return errors.result();
}

LightBufferFigures measure(Device& device, const bench::LightWall& wall, const Row& row, const char* writes,
                           const LightBufferBench& options) {
    std::map<std::string, std::string> settings{
        {"normals", "oct32"},     {"light-culling", "fullscreen"}, {"light-buffer", row.light_buffer},
        {"light-writes", writes}, {"light-sums", "target"},        {"specular", row.specular}};
    if (!settings["light-buffer"].ends_with('f')) // floats need no scale
        settings["light-scale"] = fmt::format("{}", row.scale);
    const auto renderer = create_renderer("light-prepass", &device,
                                          {.width = options.width,
                                           .height = options.height,
                                           .shading = Shading::phong,
                                           .settings = std::move(settings),
                                           .views = {"diffuse-sum", "specular-sum"}});
    renderer->set_world(wall.world());
    renderer->render(wall.camera());
    const Image specular = renderer->read("specular-sum");
    return {.name = row.name,
            .light_buffer = row.light_buffer,
            .specular_way = row.specular,
            .writes = writes,
            .scale = row.scale,
            .bytes = row.bytes,
            .overlap = static_cast<uint32_t>(wall.world().lights.size()),
            .diffuse = colour_error(renderer->read("diffuse-sum"), wall.diffuse()),
            .specular = luminance_error(specular, wall.specular(Specular::stored)),
            .rounding = luminance_error(specular, wall.specular(row.way))};
}

} // namespace

std::vector<LightBufferFigures> bench_light_buffers(Device& device, const LightBufferBench& options) {
    std::vector<std::unique_ptr<bench::LightWall>> walls;
    for (const uint32_t overlap : options.overlaps)
        walls.push_back(std::make_unique<bench::LightWall>(overlap, options.width, options.height));
    std::vector<LightBufferFigures> all;
    for (const Row& row : rows)
        for (const char* writes : {"blended", "once"}) {
            if (row.way == Specular::luv && writes == std::string_view("blended"))
                continue; // chromaticity does not add up
            std::vector<LightBufferFigures> figures;
            for (const auto& wall : walls)
                figures.push_back(measure(device, *wall, row, writes, options));
            if (options.done)
                options.done(figures);
            all.insert(all.end(), figures.begin(), figures.end());
        }
    return all;
}

} // namespace prelight
