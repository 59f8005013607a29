#pragma once
#include "references.hpp"
#include "report.hpp"
#include "report_folder.hpp"

namespace prelight::app {

/// Pictures of the report as PNG files. One that is there already is not written again: most
/// architectures share most buffers.
class PictureStore {
public:
    explicit PictureStore(ReportFolder& folder) : folder_(folder) {}
    /// The file that holds `display`, relative to the folder; a new one is named after `name`.
    std::string add(const std::string& name, const Image& display);

private:
    ReportFolder& folder_;
    std::map<uint64_t, std::string> files_; ///< by a hash of the picture
    std::map<std::string, int> names_;
};

/// Renders the variant's picture and buffers, counts its light × pixel pairs, and compares it with the
/// reference of its own form: fills `pictures`, `difference`, `form` and the pairs of `stats`.
/// Textures are read bilinearly from level 0 where the renderer has the setting, as the reference does.
/// `error` receives what the variant fails with. A preset that has no [ggx] is taken in [phong].
void take_pictures(RunReport& run, Device& device, const World& world, const PlacedCamera& camera,
                   References& references, PictureStore& store);

/// Fills `reference_pictures` and `reference_ms`.
void take_reference_pictures(Report& report, const World& world, const PlacedCamera& camera,
                             PictureStore& store);

} // namespace prelight::app
