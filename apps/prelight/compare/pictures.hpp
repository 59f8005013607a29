#pragma once
#include "kept_steps.hpp"
#include "references.hpp"
#include "report.hpp"
#include "report_folder.hpp"

namespace prelight::app {

/// Pictures of the report as PNG files. One that is there already is not written again: most
/// architectures share most buffers.
class PictureStore {
public:
    /// Takes over what a process before had stored, if all of it is there.
    PictureStore(ReportFolder& folder, KeptSteps& kept);
    /// The file that holds `display`, relative to the folder; a new one is named after `name`.
    std::string add(const std::string& name, const Image& display);

    /// Notes which files there are, for KeptSteps.
    void keep();

private:
    bool restore(const nlohmann::json& state);

    ReportFolder& folder_;
    KeptSteps& kept_;
    std::map<uint64_t, std::string> files_; ///< by a hash of the picture
    std::map<std::string, int> names_;
};

/// take_pictures(), or what a process before has found out; keeps what is new.
void take_or_find_pictures(RunReport& run, Device& device, const World& world, const PlacedCamera& camera,
                           References& references, PictureStore& store, KeptSteps& kept);

/// Renders the variant's picture and buffers, counts its light × pixel pairs, and compares it with the
/// reference of its own form: fills `pictures`, `difference`, `form` and the pairs of `stats`.
/// Textures are read bilinearly from level 0 where the renderer has the setting, as the reference does.
/// `error` receives what the variant fails with. A preset that has no [ggx] is taken in [phong].
void take_pictures(RunReport& run, Device& device, const World& world, const PlacedCamera& camera,
                   References& references, PictureStore& store);

/// Fills `reference_pictures` and `reference_ms`, or finds them.
void take_reference_pictures(Report& report, const World& world, const PlacedCamera& camera, PictureStore& store,
                             KeptSteps& kept);

} // namespace prelight::app
