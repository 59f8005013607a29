#include <algorithm>
#include <cmath>
#include <image/luminance.hpp>
#include <prelight/exposure.hpp>

namespace prelight {
namespace {

constexpr double middle_grey = 0.18, white = 1, largest = 65504;
constexpr double darker_at_most = 2; ///< EV
constexpr double brightest_share = 0.02;
constexpr double far_below = 1.0 / 65536; ///< of the brightest: in no light at all, and in no mean of logarithms

} // namespace

std::optional<double> auto_exposure(const Image& linear, const std::vector<bool>& surface) {
    const bool any = std::find(surface.begin(), surface.end(), true) != surface.end();
    std::vector<double> lit;
    for (size_t i = 0; i < linear.pixels.size(); ++i)
        if (const double y = luminance(linear.pixels[i]); (!any || surface[i]) && y > 0) // no NaN
            lit.push_back(std::min(y, largest));
    if (lit.empty())
        return {};
    std::sort(lit.begin(), lit.end());
    const double bright = lit[size_t((1 - brightest_share) * double(lit.size() - 1))];
    double sum = 0, count = 0;
    for (const double y : lit)
        if (y > bright * far_below) {
            sum += std::log2(y);
            ++count;
        }
    const double to_grey = std::log2(middle_grey) - sum / count, to_white = std::log2(white / bright);
    const double ev = std::clamp(to_white, to_grey - darker_at_most, to_grey);
    return std::round(ev * 10) / 10 + 0.0; // no −0
}

Extremes find_extremes(const Image& display) {
    Extremes found;
    for (const glm::vec3& p : display.pixels) {
        const long code = std::lround(255 * std::clamp(std::max({p.r, p.g, p.b}), 0.0f, 1.0f));
        found.burnt += code >= 253;
        found.black += code < 1;
    }
    const double pixels = std::max<double>(double(display.pixels.size()), 1);
    return {found.burnt / pixels, found.black / pixels};
}

} // namespace prelight
