#pragma once
#include <prelight/error.hpp>
#include <prelight/renderer.hpp>

namespace prelight {

/// Of Renderer::share_world(). Throws Error where the other has none.
inline const World& world_to_share(const Renderer& other) {
    if (const World* const world = other.world())
        return *world;
    throw Error("renderer: share_world() with one that has no world");
}

} // namespace prelight
