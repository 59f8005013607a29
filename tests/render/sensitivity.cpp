#include "sensitivity.hpp"
#include <bench/through_target.hpp>
#include <cmath>

namespace prelight {
namespace {

ReferencePicture reference_of(const Shot& shot) {
    return render_reference(*shot.world, shot.camera, shot.width, shot.height, shot.exposure, form_of(shot));
}

/// Changes each instance (its transform and its mesh's normals), compares, and changes it back.
template <class Change>
double mean_square(Garden& garden, const Shot& shot, const ReferencePicture& before, Change change) {
    const std::vector<Mesh> meshes = garden.scene.meshes;
    const std::vector<Instance> instances = garden.world.instances;
    for (Instance& instance : garden.world.instances)
        change(instance, garden.scene.meshes[instance.mesh].primitives[0].normals);
    const Comparison c = compare_pixels(reference_of(shot).linear, before.linear, before.left_out());
    garden.scene.meshes = meshes;
    garden.world.instances = instances;
    return std::pow(10, -c.psnr / 10);
}

void turn(std::vector<glm::vec3>& normals, const glm::dmat3& by) {
    for (glm::vec3& n : normals)
        n = glm::vec3(by * glm::dvec3(n));
}

Bound from_mean_square(double of_format) {
    return {
        .psnr = -10 * std::log10(of_format + std::pow(10, -half_float_bound.psnr / 10)), .off_share = 1, .block = 255};
}

} // namespace

double largest_angle(const passes::NormalEncodingInfo& encoding) {
    const std::vector<glm::vec4> directions = bench::directions(1 << 18);
    const auto through = bench::through_normal_target(dynamic_cast<gpu::Context&>(test_device()), encoding, directions);
    double largest = 0;
    for (size_t i = 0; i < directions.size(); ++i) {
        const glm::dvec3 a(directions[i]), b(through.decoded[i]);
        largest = std::max(largest, std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
    }
    return glm::degrees(largest);
}

Bound bound_for_normals(Garden& garden, const Shot& shot, double degrees) {
    constexpr double small = 0.1; // degrees
    const ReferencePicture before = reference_of(shot);
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 about(0);
        about[axis] = 1;
        const glm::dmat3 rotation(glm::rotate(glm::dmat4(1), glm::radians(small), about));
        sum += mean_square(garden, shot, before, [&](Instance& instance, std::vector<glm::vec3>& normals) {
            // World normals are the inverse transpose's; turned there, and back.
            const glm::dmat3 m(instance.transform);
            turn(normals, glm::transpose(m) * rotation * glm::transpose(glm::inverse(m)));
        });
    }
    return from_mean_square(sum * std::pow(degrees / small, 2));
}

Bound bound_for_depth(Garden& garden, const Shot& shot, double relative) {
    constexpr double small = 1e-4;
    const glm::dvec3 eye = shot.camera.position;
    const glm::dvec3 forward = -shot.camera.axes[2];
    // Along rays that meet in the eye everything grows; along parallel ones only depth does.
    const glm::dmat3 grow = shot.camera.camera.kind == ProjectionKind::perspective
                                ? glm::dmat3(1 + small)
                                : glm::dmat3(1) + small * glm::outerProduct(forward, forward);
    const glm::dmat4 move = glm::translate(glm::dmat4(1), eye) * glm::dmat4(grow) * glm::translate(glm::dmat4(1), -eye);
    const double square =
        mean_square(garden, shot, reference_of(shot), [&](Instance& instance, std::vector<glm::vec3>& normals) {
            const glm::dmat3 before(instance.transform);
            instance.transform = move * instance.transform;
            turn(normals, glm::transpose(glm::dmat3(instance.transform)) * glm::transpose(glm::inverse(before)));
        });
    return from_mean_square(square * std::pow(relative / small, 2));
}

} // namespace prelight
