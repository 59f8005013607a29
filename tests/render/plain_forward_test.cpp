// The unit F of `bench --limit`: whatever is in view is drawn, with its textures, and nothing else.
#include "against_reference.hpp"
#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <prelight/scene_io.hpp>

namespace prelight {
namespace {

/// Everything lights itself by its base colour alone: F's picture is then that of the base colours.
struct Plain {
    explicit Plain(const char* name) : scene(make_scene(name, 4, 1)) {
        for (Material& material : scene.materials) {
            material.emissive = glm::vec3(0);
            material.unlit = false;
        }
        world = resolve(scene);
        world.ambient = glm::vec3(1);
    }
    Scene scene;
    World world;
};

RenderOptions options(std::vector<std::string> views) {
    RenderOptions options{.width = 320, .height = 180, .tonemap = Tonemap::none};
    options.views = std::move(views);
    return options;
}

/// F and multi-pass forward on one world.
class Both {
public:
    explicit Both(const World& world)
        : unit_(create_renderer("plain-forward", &test_device(), options({}))),
          forward_(create_renderer("multipass", &test_device(), options({"albedo"}))) {
        unit_->set_world(world);
        forward_->set_world(world);
    }

    /// Share of the pixels where F and the base colours of multi-pass forward differ by more than 2/255.
    double off_share(const PlacedCamera& camera) {
        unit_->render(camera);
        forward_->render(camera);
        const Image a = unit_->read("final"), b = forward_->read("albedo");
        size_t count = 0;
        for (size_t i = 0; i < a.pixels.size(); ++i) {
            const glm::vec3 d = glm::abs(a.pixels[i] - b.pixels[i]);
            count += std::max({d.r, d.g, d.b}) > 2.0f / 255;
        }
        return double(count) / double(a.pixels.size());
    }
    uint64_t draws() const { return unit_->stats().draws; }
    uint64_t all_draws() const { return forward_->stats().draws; }

private:
    std::unique_ptr<Renderer> unit_, forward_;
};

constexpr double shared_depth = 0.001; ///< pixels where two surfaces share a depth, and order decides

TEST(PlainForward, DrawsBaseColours) {
    const Plain plain("lights");
    EXPECT_LT(Both(plain.world).off_share(plain.world.cameras.at(0)), shared_depth);
    expect_validation_clean(test_device());
}

TEST(PlainForward, LeavesOutOnlyWhatIsOutOfView) {
    const Plain plain("city");
    Both both(plain.world);
    const PlacedCamera first = plain.world.cameras.at(0);
    for (const double turn : {0.0, 40.0, 130.0, 250.0}) {
        PlacedCamera camera = first;
        camera.axes = glm::dmat3(glm::rotate(glm::dmat4(1), glm::radians(turn), glm::dvec3(0, 1, 0))) * camera.axes;
        EXPECT_LT(both.off_share(camera), shared_depth) << turn;
        EXPECT_GT(both.draws(), 0u) << turn;
        EXPECT_LT(both.draws(), both.all_draws()) << turn;
    }
    PlacedCamera flat = first; // parallel rays
    flat.camera.kind = ProjectionKind::orthographic;
    flat.camera.ymag = 5;
    flat.camera.zfar = 80;
    EXPECT_LT(both.off_share(flat), shared_depth);
    expect_validation_clean(test_device());
}

TEST(PlainForward, IsNotOfferedToAnybody) {
    for (const RendererInfo& info : renderer_infos())
        EXPECT_NE(info.name, "plain-forward");
}

} // namespace
} // namespace prelight
