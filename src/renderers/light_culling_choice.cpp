#include "light_culling_choice.hpp"
#include <gpu/context.hpp>

namespace prelight {

void choose_light_culling(Settings& settings, const Device& device) {
    if (!settings.is("light-culling", "auto"))
        return;
    const bool lists = dynamic_cast<const gpu::Context&>(device).features().shuffle_lanes > 0;
    const bool blended = settings.all().contains("light-writes") && settings.is("light-writes", "blended");
    settings.resolve("light-culling", lists && !blended ? "tiles" : "volumes");
}

} // namespace prelight
