#pragma once
#include "command_line.hpp"

namespace CLI {
class App;
}

namespace prelight::app {

/// What `bench` is given as text, before it is checked. It takes a scene, a table's name or `report`, and
/// what goes with one does not go with the others.
class BenchArguments {
public:
    /// Adds the command. `this` must outlive the parsing.
    void add(CLI::App& app);
    /// After the parsing. Throws UsageError.
    BenchCommand command() const;

private:
    void take_scene(BenchCommand& command) const;
    void check_kind(BenchCommand::Kind kind) const;

    std::string what_, table_scene_, camera_, size_, msaa_, lights_, seed_ = "1", frames_, json_, device_ = "auto";
    std::string renderers_, light_counts_, shading_, time_, animation_, baseline_, output_;
    std::vector<std::string> settings_, files_;
    EnvironmentText environment_;
    SceneReadingText reading_;
    ViewText view_;
    bool limit_ = false, count_pairs_ = false, validate_ = false;
};

} // namespace prelight::app
