#pragma once

namespace prelight {

/// Relative luminance of a linear colour: ITU-R BT.709.
template <class Colour>
double luminance(const Colour& c) {
    return 0.2126 * double(c.r) + 0.7152 * double(c.g) + 0.0722 * double(c.b);
}

} // namespace prelight
