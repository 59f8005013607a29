// Anti-aliasing of pictures that are known to the last bit, over depth that is.
#include "devices.hpp"
#include "programs.hpp"
#include "world_view.hpp"
#include <algorithm>
#include <cmath>
#include <passes/edge_blur.hpp>
#include <passes/smaa.hpp>
#include <prelight/image.hpp>
#include <random>
#include <reference/worlds.hpp>

namespace prelight {
namespace {

constexpr int picture_width = 144, picture_height = 112;
using PictureTexels = std::vector<glm::vec4>;
using PictureBytes = std::vector<std::array<uint8_t, 4>>;

size_t index_of(int x, int y) { return static_cast<size_t>(y * picture_width + x); }

PictureTexels make_texels(const auto& at) {
    PictureTexels all(size_t(picture_width) * picture_height);
    for (int y = 0; y < picture_height; ++y)
        for (int x = 0; x < picture_width; ++x)
            all[index_of(x, y)] = glm::vec4(at(x, y));
    return all;
}

/// A wall ten metres away, which is one plane.
PictureTexels wall() {
    return make_texels([](int, int) { return 10.0f; });
}

struct Filtered {
    PictureBytes before, after;
};

enum class Filter { smaa, edge_blur };

class PostFilters : public OnEachDevice {
protected:
    /// `picture` as shaders write it, `depth` in metres; without normals.
    Filtered filter(const PictureTexels& picture, const PictureTexels& depth, Filter which,
                    VkFormat format = VK_FORMAT_R8G8B8A8_UNORM) {
        TestWorld test; // a frame wants a world; these passes look at its camera alone
        test.add(square(1));
        WorldView on_device(context(), test.world, {.raster = {{picture_width, picture_height}}});
        resident::View& view = on_device.view;
        view.update(front_camera(5));
        graph::FrameGraph graph(context());
        const auto upload = [&](const char* name, const PictureTexels& texels, VkFormat as) {
            gpu::Buffer& buffer = buffers_.emplace_back(context(), name, texels.size() * sizeof(glm::vec4),
                                                        VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, gpu::BufferPlace::upload);
            std::copy(texels.begin(), texels.end(), buffer.mapped<glm::vec4>());
            const graph::ImageId image = graph.image(name, {as, {picture_width, picture_height}});
            graph::Pass& pass = graph.pass(name);
            pass.colour(image, graph::Load::discard).storage(0, graph.buffer(name, buffer), false);
            run_program(pass, context(), "from_buffer.frag", {picture_width});
            return image;
        };
        const graph::ImageId colour = upload("picture", picture, format),
                             metres = upload("depth", depth, VK_FORMAT_R32_SFLOAT);
        const passes::SurfaceBuffers surface{.format = {.depth = passes::DepthSource::r32f},
                                             .depth = metres,
                                             .depth_source = metres,
                                             .normal = metres,
                                             .roughness = metres};
        const passes::Smaa smaa(context());
        const graph::ImageId smooth = which == Filter::smaa ? smaa.add(graph, view, surface, colour)
                                                            : passes::edge_blur_pass(graph, view, surface, colour);
        graph.keep(colour);
        graph.keep(smooth);
        graph.compile();
        run_frame(context(), graph);
        return {texels<PictureBytes::value_type>(graph, colour), texels<PictureBytes::value_type>(graph, smooth)};
    }

private:
    std::vector<gpu::Buffer> buffers_;
};

/// Lines, discs and specks of any colour.
PictureTexels confetti(unsigned seed) {
    std::mt19937 random(seed);
    const auto number = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    PictureTexels picture(size_t(picture_width) * picture_height, glm::vec4(0.2f, 0.3f, 0.4f, 1));
    for (int shape = 0; shape < 60; ++shape) {
        const glm::vec4 colour(number(0, 1), number(0, 1), number(0, 1), number(0, 1));
        const double cx = number(0, picture_width), cy = number(0, picture_height), angle = number(0, 6.3);
        const double across = number(0.3, 6), along = shape % 3 == 0 ? across : number(1, 50);
        for (int y = 0; y < picture_height; ++y)
            for (int x = 0; x < picture_width; ++x) {
                const double dx = x - cx, dy = y - cy;
                const double u = (dx * std::cos(angle) + dy * std::sin(angle)) / along,
                             v = (dy * std::cos(angle) - dx * std::sin(angle)) / across;
                if (shape % 3 == 0 ? u * u + v * v < 1 : std::max(std::abs(u), std::abs(v)) < 1)
                    picture[index_of(x, y)] = colour;
            }
    }
    return picture;
}

/// Depth that goes with it: what is brighter is nearer.
PictureTexels depth_of(const PictureTexels& picture) {
    PictureTexels depth;
    for (const glm::vec4& colour : picture)
        depth.emplace_back(10 + 3 * std::floor(4 * colour.r));
    return depth;
}

struct HalfPlane {
    double degrees;   ///< its edge from the rows
    double shift = 0; ///< across the edge, pixels

    /// Pixels from the edge to this place, positive in the white half.
    double inside(double x, double y) const {
        const double angle = glm::radians(degrees);
        return (x - picture_width / 2.0) * std::sin(angle) - (y - picture_height / 2.0) * std::cos(angle) - shift;
    }
    /// The white share of a pixel, in closed form.
    double coverage(int x, int y) const {
        const double s = std::abs(std::sin(glm::radians(degrees))), c = std::abs(std::cos(glm::radians(degrees)));
        const double from_centre = inside(x + 0.5, y + 0.5), far = std::abs(from_centre);
        double larger = 1; // of the two parts
        if (far <= std::abs(s - c) / 2)
            larger = 0.5 + far / std::max(s, c);
        else if (far < (s + c) / 2)
            larger = 1 - std::pow((s + c) / 2 - far, 2) / (2 * s * c);
        return from_centre > 0 ? larger : 1 - larger;
    }
    PictureTexels picture() const {
        return make_texels([&](int x, int y) {
            const bool in = inside(x + 0.5, y + 0.5) > 0;
            return glm::vec4(in, in, in, in);
        });
    }
};

/// Squared errors of linear light, of the pixels that the edge crosses, a line's length from the borders.
struct EdgeError {
    double sum = 0;
    int count = 0;

    void add(const PictureBytes& picture, const HalfPlane& half) {
        for (int y = 34; y < picture_height - 34; ++y)
            for (int x = 34; x < picture_width - 34; ++x) {
                const double covered = half.coverage(x, y);
                if (covered == 0 || covered == 1)
                    continue;
                sum += std::pow(static_cast<double>(srgb_decode(picture[index_of(x, y)][0] / 255.0f)) - covered, 2);
                ++count;
            }
    }
    double rms() const { return std::sqrt(sum / count); }
};

struct Slope {
    double degrees;
    double factor; ///< by which SMAA divides the error at least
};

TEST_P(PostFilters, SmaaComesCloseToTheCoverageOfHalfPlanes) {
    for (const Slope& slope : {Slope{2, 20},
                               {5, 10},
                               {12, 5},
                               {25, 2.5},
                               {35, 3.5},
                               {45, 1.3},
                               {55, 3.5},
                               {70, 2.5},
                               {85, 10},
                               {92, 20},
                               {135, 1.3}}) {
        EdgeError without, with;
        for (const double shift : {0.01, 0.21, 0.41, 0.61}) {
            const HalfPlane half{slope.degrees, shift};
            const Filtered got = filter(half.picture(), wall(), Filter::smaa);
            without.add(got.before, half);
            with.add(got.after, half);
        }
        EXPECT_GE(with.count, 160);
        std::printf("    %3g degrees: RMS %.3f without, %.3f with: %.1f times less\n", slope.degrees, without.rms(),
                    with.rms(), without.rms() / with.rms());
        EXPECT_GT(without.rms(), slope.factor * with.rms()) << slope.degrees << " degrees";
    }
}

// A device that encodes finds the same edges and mixes the same light.
TEST_P(PostFilters, DoTheSameInAnImageThatTheDeviceEncodes) {
    const PictureTexels encoded = confetti(5), depth = depth_of(encoded);
    PictureTexels linear = encoded;
    for (glm::vec4& colour : linear)
        for (int c = 0; c < 3; ++c)
            colour[c] = srgb_decode(std::round(255 * colour[c]) / 255);
    for (const Filter which : {Filter::smaa, Filter::edge_blur}) {
        const Filtered ours = filter(encoded, depth, which),
                       theirs = filter(linear, depth, which, VK_FORMAT_R8G8B8A8_SRGB);
        size_t off = 0;
        for (size_t i = 0; i < ours.after.size(); ++i)
            for (size_t c = 0; c < 4; ++c)
                off += std::abs(ours.after[i][c] - theirs.after[i][c]) > 2; // drivers encode with an error
        EXPECT_LE(off, 4u);                                                 // an edge whose contrast is the threshold
    }
}

// An edge of half transparency is as smooth as one of white light.
TEST_P(PostFilters, MixAlphaLikeLight) {
    const HalfPlane half{20};
    for (const Filter which : {Filter::smaa, Filter::edge_blur}) {
        const PictureTexels depth =
            make_texels([&](int x, int y) { return half.inside(x + 0.5, y + 0.5) > 0 ? 10.0f : 20.0f; });
        const Filtered got = filter(half.picture(), depth, which);
        size_t between = 0;
        for (const auto& texel : got.after) {
            const double light = 255 * srgb_decode(texel[0] / 255.0f), alpha = texel[3];
            ASSERT_NEAR(light, alpha, 2);
            between += texel[3] > 10 && texel[3] < 245;
        }
        EXPECT_GT(between, 50u);
    }
}

TEST_P(PostFilters, OfAMirroredPictureAreItsMirroredResult) {
    const auto mirrored = [](const auto& picture, bool upside_down) {
        auto other = picture;
        for (int y = 0; y < picture_height; ++y)
            for (int x = 0; x < picture_width; ++x)
                other[index_of(x, y)] =
                    picture[upside_down ? index_of(x, picture_height - 1 - y) : index_of(picture_width - 1 - x, y)];
        return other;
    };
    for (const Filter which : {Filter::smaa, Filter::edge_blur})
        for (unsigned seed = 1; seed <= 3; ++seed) {
            const PictureTexels picture = confetti(seed), depth = depth_of(picture);
            const PictureBytes straight = filter(picture, depth, which).after;
            for (const bool upside_down : {false, true}) {
                const PictureBytes other =
                    filter(mirrored(picture, upside_down), mirrored(depth, upside_down), which).after;
                const PictureBytes expected = mirrored(straight, upside_down);
                size_t differ = 0;
                for (size_t i = 0; i < other.size(); ++i)
                    for (size_t c = 0; c < 4; ++c) {
                        differ += other[i][c] != expected[i][c];
                        ASSERT_NEAR(other[i][c], expected[i][c], 1) << i % picture_width << ", " << i / picture_width;
                    }
                EXPECT_LE(differ, which == Filter::smaa ? 0u : 64u); // sums of three round by their order
            }
        }
}

TEST_P(PostFilters, LeavePixelsAwayFromEdgesAlone) {
    const PictureTexels picture = confetti(7), depth = depth_of(picture);
    const Filtered smaa = filter(picture, depth, Filter::smaa), blur = filter(picture, depth, Filter::edge_blur);
    size_t changed = 0, blurred = 0;
    for (int y = 1; y < picture_height - 1; ++y)
        for (int x = 1; x < picture_width - 1; ++x) {
            const size_t at = index_of(x, y);
            bool contrast = false, step = false;
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) {
                    const size_t other = index_of(x + dx, y + dy);
                    step |= depth[at] != depth[other];
                    for (int c = 0; c < 3 && (dx == 0 || dy == 0); ++c)
                        contrast |= std::abs(smaa.before[at][size_t(c)] - smaa.before[other][size_t(c)]) >= 25;
                }
            if (!contrast) {
                ASSERT_EQ(smaa.after[at], smaa.before[at]) << x << ", " << y;
            }
            if (!step) {
                ASSERT_EQ(blur.after[at], blur.before[at]) << x << ", " << y;
            }
            changed += smaa.after[at] != smaa.before[at];
            blurred += blur.after[at] != blur.before[at];
        }
    EXPECT_GT(changed, 1000u);
    EXPECT_GT(blurred, 1000u);
}

TEST_P(PostFilters, LeaveAPictureWithoutEdgesAlone) {
    const PictureTexels gradient =
        make_texels([](int x, int y) { return glm::vec4(x / 144.0f, y / 112.0f, 0.5f, x / 144.0f); });
    // A floor seen at a flat angle: depth changes much from row to row, and is a plane all the same.
    const PictureTexels floor = make_texels([](int, int y) { return y > 40 ? 100.0f / (y - 40) : 0.0f; });
    for (const Filter which : {Filter::smaa, Filter::edge_blur})
        for (const VkFormat format : {VK_FORMAT_R8G8B8A8_UNORM, VK_FORMAT_R8G8B8A8_SRGB}) {
            const Filtered on_wall = filter(gradient, wall(), which, format),
                           on_floor = filter(gradient, floor, which, format);
            EXPECT_TRUE(on_wall.after == on_wall.before);
            for (int y = 0; y < picture_height; ++y)
                for (int x = 0; x < picture_width && std::abs(y - 40) > 1; ++x) // but for the horizon
                    ASSERT_EQ(on_floor.after[index_of(x, y)], on_floor.before[index_of(x, y)]) << x << ", " << y;
        }
}

// Predication: faint edges count where geometry has one.
TEST_P(PostFilters, SmaaSeesFainterEdgesWhereDepthSteps) {
    const HalfPlane half{10};
    const auto in = [&](int x, int y) { return half.inside(x + 0.5, y + 0.5) > 0; };
    const PictureTexels faint = make_texels([&](int x, int y) { return in(x, y) ? 0.65f : 0.5f; });
    const Filtered flat = filter(faint, wall(), Filter::smaa);
    EXPECT_TRUE(flat.after == flat.before);
    const Filtered stepped =
        filter(faint, make_texels([&](int x, int y) { return in(x, y) ? 10.0f : 11.0f; }), Filter::smaa);
    EXPECT_TRUE(stepped.after != stepped.before);
}

INSTANTIATE_TEST_SUITE_P(Drivers, PostFilters, testing::Values(Driver::lavapipe, Driver::swiftshader), driver_name);

} // namespace
} // namespace prelight
