#include "light_culling_choice.hpp"
#include <gpu/context.hpp>
#include <prelight/error.hpp>

namespace prelight {

void choose_light_culling(Settings& settings, const Device& device) {
    const bool measures = !settings.is("light-lists", "built");
    if (!settings.is("light-culling", "auto")) {
        if (measures && !settings.is("light-culling", "tiles"))
            throw UsageError("--set light-lists=" + settings.get("light-lists") + ": is for light-culling=tiles, not " +
                             settings.get("light-culling"));
        return;
    }
    const bool lists = dynamic_cast<const gpu::Context&>(device).features().shuffle_lanes > 0;
    const bool blended = settings.all().contains("light-writes") && settings.is("light-writes", "blended");
    settings.resolve("light-culling", lists && !blended ? "tiles" : "volumes");
}

} // namespace prelight
