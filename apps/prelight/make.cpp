#include "commands.hpp"
#include "log.hpp"
#include "output.hpp"
#include "scene_source.hpp"

#include <fmt/format.h>
#include <prelight/scene_io.hpp>

namespace prelight::app {

void run(const MakeCommand& command) {
    const Scene scene = make_builtin(command.scene, command.lights, command.seed);
    check_writable(command.output);
    const WriteGuard guard;
    save_glb(scene, command.output);
    tell(fmt::format("{}: {}, {} lights, seed {}", command.output.string(), command.scene, scene.lights.size(),
                     command.seed));
}

} // namespace prelight::app
