#pragma once
#include "against_reference.hpp"
#include <vector>

namespace prelight {

/// A renderer and what it is told.
struct Way {
    const char* renderer;
    std::map<std::string, std::string> settings;
};

/// Each renderer on a device once for each way in which it finds lights, with the form of the lighting model that all
/// of them run (model=nv).
std::vector<Shot> every_way(const Shot& shot);
/// With four samples a pixel, `width` pixels across.
Shot with_samples(Shot shot, uint32_t width = 256);
/// With a way's renderer, and its settings where the shot has none.
Shot in_way(Shot shot, const Way& way);
/// Renderer and settings, for a test's trace.
std::string name_of(const Shot& shot);
/// The same of a test's parameter, as GoogleTest takes names.
std::string way_name(const testing::TestParamInfo<Shot>& info);

/// Another number for each, the same at each run: so that tests drawn by lot go through other changes.
uint64_t seed_of(const Shot& shot);

} // namespace prelight
