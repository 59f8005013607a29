// FLIP for pictures of low dynamic range, written from
// P. Andersson, J. Nilsson, T. Akenine-Möller, M. Oskarsson, K. Åström, M. D. Fairchild,
// "FLIP: A Difference Evaluator for Alternating Images", Proc. ACM CGIT 3(2), 2020.
// Section and symbol names below are the paper's.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <image/plane_filter.hpp>
#include <numbers>
#include <prelight/error.hpp>
#include <prelight/metrics.hpp>

namespace prelight {
namespace {

constexpr double pi = std::numbers::pi;

// Section 4.1.1, table 1: contrast sensitivity functions, as sums of two Gaussians
// g(d) = Σ a_i √(π/b_i) exp(−π² d²/b_i), d in degrees of visual angle.
struct Csf {
    double a1, b1, a2, b2;
};
constexpr Csf csf_y{1, 0.0047, 0, 1e-5};
constexpr Csf csf_cx{1, 0.0053, 0, 1e-5};
constexpr Csf csf_cz{34.1, 0.04, 13.5, 0.025};

// Section 4.1.3: exponent of HyAB, and the two points of the piecewise error redistribution.
constexpr double qc = 0.7, pc = 0.4, pt = 0.95;
// Section 4.2: width of the feature detectors in degrees; exponent of the feature difference.
constexpr double w = 0.082, qf = 0.5;

/// Columns for R, G, B; sRGB primaries and D65 white (IEC 61966-2-1).
const glm::dmat3& rgb_to_xyz() {
    static const glm::dmat3 matrix(0.4124564, 0.2126729, 0.0193339, 0.3575761, 0.7151522, 0.1191920, 0.1804375,
                                   0.0721750, 0.9503041);
    return matrix;
}

glm::dvec3 white_xyz() { return rgb_to_xyz() * glm::dvec3(1); }

glm::dvec3 to_ycxcz(glm::dvec3 linear_rgb) {
    const glm::dvec3 xyz = rgb_to_xyz() * linear_rgb / white_xyz();
    return {116 * xyz.y - 16, 500 * (xyz.x - xyz.y), 200 * (xyz.y - xyz.z)};
}

glm::dvec3 from_ycxcz(glm::dvec3 ycxcz) {
    const double y = (ycxcz.x + 16) / 116;
    const glm::dvec3 xyz(y + ycxcz.y / 500, y, y - ycxcz.z / 200);
    static const glm::dmat3 inverse = glm::inverse(rgb_to_xyz());
    return inverse * (xyz * white_xyz());
}

/// CIE 1976 L*a*b* with Hunt's effect worked into a* and b* (section 4.1.2): × 0.01 L*.
glm::dvec3 to_hunt_lab(glm::dvec3 linear_rgb) {
    const glm::dvec3 xyz = rgb_to_xyz() * linear_rgb / white_xyz();
    constexpr double delta = 6.0 / 29;
    const auto f = [](double t) {
        return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29;
    };
    const double l = 116 * f(xyz.y) - 16;
    return {l, 0.01 * l * 500 * (f(xyz.x) - f(xyz.y)), 0.01 * l * 200 * (f(xyz.y) - f(xyz.z))};
}

/// Section 4.1.3: the HyAB distance, raised to qc.
double colour_distance(glm::dvec3 a, glm::dvec3 b) {
    const glm::dvec3 d = a - b;
    return std::pow(std::abs(d.x) + std::hypot(d.y, d.z), qc);
}

/// The same section: differences up to pc·cmax fill 0 … pt, the rare larger ones pt … 1. cmax is
/// the distance of green and blue, the largest of the sRGB gamut.
double redistributed(double distance) {
    static const double cmax = colour_distance(to_hunt_lab({0, 1, 0}), to_hunt_lab({0, 0, 1}));
    const double knee = pc * cmax;
    if (distance < knee)
        return distance * pt / knee;
    return std::min(pt + (distance - knee) / (cmax - knee) * (1 - pt), 1.0);
}

Plane csf_filtered(const Plane& plane, const Csf& csf, int radius, double pixels_per_degree) {
    Plane sum(plane.width, plane.height);
    double total = 0;
    for (const auto& [a, width] : {std::pair(csf.a1, csf.b1), {csf.a2, csf.b2}}) {
        const double b = width; // clang 14 captures no structured binding
        if (a == 0)
            continue;
        const Kernel kernel = make_kernel(radius, [&](int x) {
            const double degrees = x / pixels_per_degree;
            return std::exp(-pi * pi * degrees * degrees / b);
        });
        double weight = 0;
        for (const double value : kernel)
            weight += value;
        const double amplitude = a * std::sqrt(pi / b);
        total += amplitude * weight * weight; // sum of the two-dimensional kernel
        const Plane part = separable(plane, kernel, kernel);
        for (size_t i = 0; i < sum.values.size(); ++i)
            sum.values[i] += amplitude * part.values[i];
    }
    for (double& value : sum.values)
        value /= total;
    return sum;
}

struct Opponent {
    Plane y, cx, cz;
};

Opponent opponent_planes(const Image& srgb) {
    const Plane empty(srgb.width, srgb.height);
    Opponent planes{empty, empty, empty};
    for (size_t i = 0; i < srgb.pixels.size(); ++i) {
        glm::dvec3 linear{0};
        for (int channel = 0; channel < 3; ++channel)
            linear[channel] = srgb_decode(srgb.pixels[i][channel]);
        const glm::dvec3 value = to_ycxcz(linear);
        planes.y.values[i] = value.x;
        planes.cx.values[i] = value.y;
        planes.cz.values[i] = value.z;
    }
    return planes;
}

/// Section 4.1: what the eye makes of the colours at this viewing distance.
std::vector<glm::dvec3> perceived(const Opponent& planes, double pixels_per_degree) {
    // Three standard deviations of the widest Gaussian, σ = √(b/2)/π degrees.
    const double b_max = std::max({csf_y.b1, csf_cx.b1, csf_cz.b1, csf_cz.b2});
    const int radius = static_cast<int>(std::ceil(3 * std::sqrt(b_max / 2) / pi * pixels_per_degree));
    const Plane y = csf_filtered(planes.y, csf_y, radius, pixels_per_degree);
    const Plane cx = csf_filtered(planes.cx, csf_cx, radius, pixels_per_degree);
    const Plane cz = csf_filtered(planes.cz, csf_cz, radius, pixels_per_degree);
    std::vector<glm::dvec3> lab(y.values.size());
    for (size_t i = 0; i < lab.size(); ++i) {
        const glm::dvec3 rgb = from_ycxcz({y.values[i], cx.values[i], cz.values[i]});
        lab[i] = to_hunt_lab(glm::clamp(rgb, 0.0, 1.0));
    }
    return lab;
}

/// Section 4.2: strengths of edges and points, from derivatives of a Gaussian over luminance.
struct Features {
    std::vector<double> edge, point;
};

Features features(const Opponent& planes, double pixels_per_degree) {
    const double sigma = 0.5 * w * pixels_per_degree;
    const int radius = static_cast<int>(std::ceil(3 * sigma));
    const auto gauss = [&](int x) { return std::exp(-x * x / (2 * sigma * sigma)); };
    Kernel smooth = make_kernel(radius, gauss);
    Kernel first = make_kernel(radius, [&](int x) { return -x * gauss(x); });
    Kernel second = make_kernel(radius, [&](int x) { return (x * x / (sigma * sigma) - 1) * gauss(x); });
    // Positive weights sum to 1 and negative ones to −1, in two dimensions as in one.
    for (Kernel* kernel : {&smooth, &first, &second})
        normalise_signs(*kernel);

    Plane luminance = planes.y;
    for (double& value : luminance.values)
        value = (value + 16) / 116;
    const auto strength = [&](const Kernel& kernel) {
        const Plane x = separable(luminance, kernel, smooth);
        const Plane y = separable(luminance, smooth, kernel);
        std::vector<double> result(x.values.size());
        for (size_t i = 0; i < result.size(); ++i)
            result[i] = std::hypot(x.values[i], y.values[i]);
        return result;
    };
    return {strength(first), strength(second)};
}

} // namespace

Image flip_map(const Image& picture_srgb, const Image& reference_srgb, double pixels_per_degree) {
    if (picture_srgb.width != reference_srgb.width || picture_srgb.height != reference_srgb.height)
        throw Error(fmt::format("flip: picture: {}x{} pixels, the reference has {}x{}", picture_srgb.width,
                                picture_srgb.height, reference_srgb.width, reference_srgb.height));
    const Opponent picture = opponent_planes(picture_srgb);
    const Opponent reference = opponent_planes(reference_srgb);
    const auto picture_lab = perceived(picture, pixels_per_degree);
    const auto reference_lab = perceived(reference, pixels_per_degree);
    const Features picture_features = features(picture, pixels_per_degree);
    const Features reference_features = features(reference, pixels_per_degree);

    Image map(picture_srgb.width, picture_srgb.height);
    for (size_t i = 0; i < map.pixels.size(); ++i) {
        const double colour = redistributed(colour_distance(picture_lab[i], reference_lab[i]));
        const double feature = std::max(std::abs(picture_features.edge[i] - reference_features.edge[i]),
                                        std::abs(picture_features.point[i] - reference_features.point[i]));
        const double feature_difference = std::pow(feature / std::numbers::sqrt2, qf);
        // Section 4.3: features strengthen the colour difference.
        map.pixels[i] = glm::vec3(static_cast<float>(std::pow(colour, 1 - feature_difference)));
    }
    return map;
}

} // namespace prelight
