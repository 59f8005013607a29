#pragma once
#include "first_sight.hpp"
#include "sequence/sequence_command.hpp"
#include "variant.hpp"
#include "view_choice.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <prelight/renderer.hpp>
#include <string>
#include <variant>
#include <vector>

namespace prelight::app {

/// A buffer of the frame and the file that receives it (`--view NAME=FILE`).
struct ViewFile {
    std::string view;
    std::filesystem::path file;
};

/// What becomes of stairs along edges: open_session().
enum class Edges {
    as_told,  ///< something was said of samples or anti-aliasing
    samples,  ///< nothing was, of a picture
    filtered, ///< nothing was, of many, which are to take little longer
};

/// `prelight render`
struct RenderCommand {
    bool quiet = false; ///< set_quiet()
    std::string scene;  ///< a file, or the name of a built-in scene
    /// After the first; the outputs' names then hold {name}.
    std::vector<std::string> more_scenes{};
    std::filesystem::path output;
    std::string view = "final"; ///< the buffer that `output` receives
    std::vector<ViewFile> more_views;
    std::string renderer = "light-prepass";
    RenderOptions options;
    std::string camera;           ///< name or index; empty: the scene's first
    std::optional<Moment> moment; ///< absent: the scene at rest
    std::string animation;        ///< name or index; empty: all
    uint32_t frames = 1;
    std::optional<uint32_t> lights;
    uint64_t seed = 1;
    std::string device = "auto";
    bool validate = false;
    bool watch = false;
    std::filesystem::path stats; ///< empty: none
    /// `--material NAME=FILE`, in the order given.
    std::vector<std::pair<std::string, std::filesystem::path>> materials;
    EnvironmentChoice environment;
    SceneReading reading;
    std::optional<Framing> framing;                 ///< absent: the scene's camera
    ExposureChoice exposure = ExposureChoice::open; ///< whether options.exposure holds
    Edges edges = Edges::as_told;
};

/// `prelight sequence`: what `render` makes of each of many moments.
struct SequenceCommand {
    RenderCommand render; ///< `output` and the files of `more_views` are patterns; no moment, no `frames`, no `watch`
    SequenceOptions sequence;
};

/// `prelight view`
struct ViewCommand {
    RenderCommand render;               ///< at the start; `output`: the picture of --play, or empty
    std::filesystem::path record, play; ///< empty: none
    std::optional<uint32_t> steps;      ///< of --play; absent: up to the last event
    std::optional<double> scale;        ///< absent: auto
};

/// `prelight compare`
struct CompareCommand {
    bool quiet = false;
    std::string scene;     ///< a file, or the name of a built-in scene
    std::string arguments; ///< the whole command line
    std::filesystem::path folder;
    RenderOptions options;        ///< what all variants share
    std::string camera;           ///< name or index; empty: the scene's first
    std::optional<Moment> moment; ///< absent: the scene at rest
    std::string animation;        ///< name or index; empty: all
    uint32_t frames = 5;          ///< timed frames of each variant
    std::optional<uint32_t> lights;
    uint64_t seed = 1;
    std::string device = "auto";
    bool validate = false;
    std::vector<Variant> variants;      ///< empty: the standard ones
    std::vector<uint32_t> light_counts; ///< rising; may be empty
    double frame_limit = 1;             ///< seconds; a slower frame ends a variant's series of light counts
    std::optional<double> budget;       ///< seconds; absent: as long as it takes
    EnvironmentChoice environment;
    SceneReading reading;
    std::optional<Framing> framing;                 ///< absent: the scene's camera
    ExposureChoice exposure = ExposureChoice::open; ///< whether options.exposure holds
};

/// `prelight make`
struct MakeCommand {
    bool quiet = false;
    std::string scene;
    std::filesystem::path output;
    std::optional<uint32_t> lights;
    uint64_t seed = 1;
};

/// `prelight info`
struct InfoCommand {
    std::string scene; ///< a file, or the name of a built-in scene
    std::optional<uint32_t> lights;
    uint64_t seed = 1;
    SceneReading reading;
    bool json = false;
};

/// `prelight devices`
struct DevicesCommand {};

/// `prelight materials [NAME]`
struct MaterialsCommand {
    std::string name; ///< empty: all
};

/// `prelight renderers [NAME]`
struct RenderersCommand {
    std::string name; ///< empty: all, one line each
};

/// `prelight bench WHAT`: figures, measured here and now; or a page of figures that were.
struct BenchCommand {
    enum class Kind { table, scene, report };
    Kind kind = Kind::table;
    bool quiet = false;
    std::string what; ///< table: one of bench_names()
    std::string scene = "spheres";
    std::string camera;             ///< name or index; empty: the scene's first
    uint32_t width = 0, height = 0; ///< table: 0 is the bench's own
    std::optional<uint32_t> lights;
    std::optional<uint32_t> frames; ///< that are timed; absent: the bench's own
    uint64_t seed = 1;
    std::string device = "auto";
    bool validate = false;
    std::filesystem::path json; ///< empty: none

    // Of Kind::scene.
    RenderOptions options;              ///< what all contenders share; settings: those of --set
    std::vector<Variant> variants;      ///< empty: light-prepass and deferred
    std::vector<uint32_t> light_counts; ///< rising; empty: the scene's own number
    std::optional<Moment> moment;       ///< absent: the scene at rest
    std::string animation;              ///< name or index; empty: all
    bool limit = false;
    std::optional<double> budget;   ///< seconds; absent: as long as it takes
    std::filesystem::path baseline; ///< empty: none
    EnvironmentChoice environment;
    SceneReading reading;
    std::optional<Framing> framing; ///< absent: the scene's camera

    // Of Kind::report.
    std::vector<std::filesystem::path> files;
    std::filesystem::path output;
};

/// `help`, `--help`, `--version`: text that goes to stdout, and nothing else to do.
struct PrintCommand {
    std::string text;
};

using Command = std::variant<RenderCommand, SequenceCommand, ViewCommand, CompareCommand, BenchCommand, MakeCommand,
                             InfoCommand, DevicesCommand, RenderersCommand, MaterialsCommand, PrintCommand>;

/// Throws UsageError with one line that names the argument and the reason.
Command parse_command_line(int argc, const char* const* argv);

/// Whether it was given --quiet.
bool wants_quiet(const Command& command);

} // namespace prelight::app
