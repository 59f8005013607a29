#pragma once
#include <filesystem>
#include <prelight/material_shader.hpp>
#include <prelight/scene.hpp>
#include <string>
#include <vector>

namespace prelight::app {

/// What `--material NAME=FILE` names, as it last worked.
class OwnMaterials {
public:
    using Files = std::vector<std::pair<std::string, std::filesystem::path>>;
    /// Reads what they declare. Throws Error: a mistake in one of them.
    explicit OwnMaterials(const Files& files);
    /// Compiles them once, for their mistakes. Throws Error.
    void check() const;
    /// Reads them again. One with a mistake stays as it was; the mistakes come back, one line each.
    std::vector<std::string> take_changes();
    /// Gives them to the scene's materials. Throws UsageError for a name that the scene does not have.
    void assign(Scene& scene) const;

private:
    const Files& files_;
    std::vector<std::shared_ptr<const MaterialShader>> shaders_; ///< as files_
};

} // namespace prelight::app
