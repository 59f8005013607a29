#pragma once
#include <prelight/scene.hpp>

/// A tree of cards with an alpha mask over a lawn, by day.
prelight::Scene make_leaves();

/// A fence of bars and sagging cables, 8 to 24 mm thick and metres away, before a wall.
prelight::Scene make_wires();
