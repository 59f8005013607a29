#include <algorithm>
#include <cmath>
#include <reference/behind.hpp>

namespace prelight::reference {
namespace {

/// The tent that is 1 at 0.
double tent(double x) { return std::max(1 - std::abs(x), 0.0); }

} // namespace

glm::dvec3 Behind::Level::texel(int x, int y) const {
    return texels[static_cast<size_t>(std::clamp(y, 0, height - 1)) * width + std::clamp(x, 0, width - 1)];
}

Behind::Level Behind::Level::halved() const {
    const auto sum = [](auto texel_at) {
        return (texel_at(-1) + 3.0 * texel_at(0) + 3.0 * texel_at(1) + texel_at(2)) / 8.0;
    };
    Level across{(width + 1) / 2, height, {}};
    for (int y = 0; y < across.height; ++y)
        for (int x = 0; x < across.width; ++x)
            across.texels.push_back(sum([&](int i) { return texel(2 * x + i, y); }));
    Level out{across.width, (height + 1) / 2, {}};
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x)
            out.texels.push_back(sum([&](int i) { return across.texel(x, 2 * y + i); }));
    return out;
}

glm::dvec3 Behind::Level::at(double x, double y) const {
    const int first_x = static_cast<int>(std::floor(x - 0.5)), first_y = static_cast<int>(std::floor(y - 0.5));
    glm::dvec3 sum(0);
    for (int j = first_y; j <= first_y + 1; ++j)
        for (int i = first_x; i <= first_x + 1; ++i)
            sum += tent(x - 0.5 - i) * tent(y - 0.5 - j) * texel(i, j);
    return sum;
}

Behind::Behind(const Image& picture) {
    Level& whole = levels_.emplace_back(Level{static_cast<int>(picture.width), static_cast<int>(picture.height), {}});
    whole.texels.assign(picture.pixels.begin(), picture.pixels.end());
    while (levels_.back().texels.size() > 1)
        levels_.push_back(levels_.back().halved());
}

glm::dvec3 Behind::at(glm::dvec2 place, double level) const {
    const double x = std::clamp(place.x, 0.0, static_cast<double>(levels_[0].width)),
                 y = std::clamp(place.y, 0.0, static_cast<double>(levels_[0].height));
    const double last = static_cast<double>(levels_.size() - 1);
    glm::dvec3 sum(0);
    for (size_t i = 0; i < levels_.size(); ++i)
        if (const double share = tent(std::clamp(level, 0.0, last) - static_cast<double>(i)); share > 0)
            sum += share * levels_[i].at(std::ldexp(x, -static_cast<int>(i)), std::ldexp(y, -static_cast<int>(i)));
    return sum;
}

} // namespace prelight::reference
