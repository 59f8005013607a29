#pragma once
#include <deque>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <image/compare_pixels.hpp>
#include <map>
#include <prelight/device.hpp>
#include <prelight/metrics.hpp>
#include <prelight/reference.hpp>
#include <prelight/renderer.hpp>
#include <string>
#include <vector>

namespace prelight {

/// One picture of a renderer and the reference that it is judged against.
struct Shot {
    const World* world = nullptr;
    PlacedCamera camera;
    uint32_t width = 320, height = 180;
    double exposure = 0;
    Shading shading = Shading::ggx;
    std::map<std::string, std::string> settings;
    std::string renderer = "light-prepass";
    uint32_t samples = 1; ///< a pixel
};

/// A form of the lighting model that a test runs with, by its name.
struct Form {
    const char* name;
    Shading shading;
    std::map<std::string, std::string> settings;
};
void PrintTo(const Form& form, std::ostream* out);

/// What every renderer on a device is called.
inline const std::vector<std::string> device_renderers{"light-prepass", "deferred", "z-prepass", "multipass"};

/// Bounds of docs/measuring.md for a picture against the reference of its own form of the model.
struct Bound {
    double psnr = 55;         ///< dB
    double off_share = 0.001; ///< pixels off by more than 2/255
    double block = 1;         ///< 16×16 block means, in 1/255
    double left_out = 0.1;
};
inline constexpr Bound half_float_bound{};
/// Blended with scale 2, at most 4 lights on a pixel.
inline constexpr Bound rgba8_bound{.psnr = 40, .off_share = 1, .block = 255};

/// The device of all tests in this process, with core and synchronization validation: a software one, unless
/// PRELIGHT_TEST_DEVICE names another, and PRELIGHT_TEST_VALIDATION=off.
Device& test_device();
/// A second one of all tests, on SwiftShader, with the same validation; null when it is not installed.
Device* swiftshader_device();

/// The reference's form that belongs to the settings of a shot.
ReferenceForm form_of(const Shot& shot);
/// What render_linear() asks of the shot's renderer.
RenderOptions options_of(const Shot& shot);
Image render_linear(Device& device, const Shot& shot);
/// One of the renderer's other pictures.
Image view_of(const Shot& shot, const char* view, Device& device = test_device());

struct Rendered {
    Image linear;
    Stats stats;
};
/// With exactly these options.
Rendered render_with(const World& world, const PlacedCamera& camera, const RenderOptions& options,
                     const std::string& renderer = "light-prepass");
/// What finds out which triangles and objects show asks for opaque ones, and must leave the picture as it is: in the
/// renderers that have every way to, whatever the shot's own.
void expect_same_with_less_geometry(Shot shot);
/// With pairs of lights and pixels counted.
Rendered render_counting_pairs(const Shot& shot, uint32_t frames = 1);

/// Renders both and compares; texture filtering is bilinear on level 0 in both unless the settings name another.
Comparison against_reference(Device& device, const Shot& shot);
/// Picture, reference and twenty times their difference, into the folder PRELIGHT_TEST_PICTURES.
void save_when_wanted(const Image& picture, const ReferencePicture& reference);
/// EXPECTs the bound, printing the figures.
void expect_within(const Comparison& comparison, const Bound& bound);
/// EXPECTs the bound, printing the figures; no validation message may have come.
void expect_agrees(const Shot& shot, const Bound& bound = half_float_bound);
/// Of the pixels of a shot with several samples a pixel that show more than one surface, by themselves.
struct EdgeBound {
    size_t pixels = 1000; ///< at least so many that the reference can judge
    double psnr = 50;
};
/// EXPECTs both bounds of a picture of a shot with several samples a pixel, edge pixels being part of the first.
/// `reference`: of the shot's form.
void expect_within_on_edges(const Image& picture, const ReferencePicture& reference,
                            const Bound& bound = half_float_bound, const EdgeBound& edges = {});

/// References of shots of one world, camera and size, each form's and exposure's once.
class References {
public:
    const ReferencePicture& of(const Shot& shot);
    /// As expect_agrees().
    void expect_agrees(const Shot& shot, const Bound& bound = half_float_bound);

private:
    struct Known {
        ReferenceForm form;
        double exposure;
        ReferencePicture picture;
    };
    std::deque<Known> known_; // addresses stay
};

/// Fails the test when the device's validation has said anything since the last call.
void expect_validation_clean(Device& device);

} // namespace prelight
