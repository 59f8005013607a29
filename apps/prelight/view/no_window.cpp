#include "window_run.hpp"

#include <prelight/error.hpp>

namespace prelight::app::viewer {

void run_window(const ViewCommand&) {
    throw Error("view: this build has no window (it was made without GLFW and Dear ImGui); --play FILE -o PICTURE goes "
                "without");
}

} // namespace prelight::app::viewer
