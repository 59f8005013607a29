#include <cmath>
#include <scene/write/parts.hpp>

namespace prelight::write {
namespace {

Json perspective(const Camera& camera) {
    Json entry{{"yfov", camera.yfov}, {"znear", camera.znear}};
    if (std::isfinite(camera.zfar))
        entry["zfar"] = camera.zfar;
    return entry;
}

/// The picture's shape decides the width of the view: glTF's xmag is only a hint.
Json orthographic(const Camera& camera) {
    return {{"xmag", camera.ymag}, {"ymag", camera.ymag}, {"znear", camera.znear}, {"zfar", camera.zfar}};
}

bool valid(const Camera& camera) {
    if (camera.kind == ProjectionKind::perspective)
        return camera.yfov > 0 && std::isfinite(camera.yfov) && camera.znear > 0 && camera.zfar > camera.znear;
    return camera.ymag != 0 && std::isfinite(camera.ymag) && camera.znear >= 0 && camera.zfar > camera.znear &&
           std::isfinite(camera.zfar);
}

} // namespace

void add_cameras(const Scene& scene, Document& document) {
    for (size_t i = 0; i < scene.cameras.size(); ++i) {
        const Camera& camera = scene.cameras[i];
        if (!valid(camera))
            document.fail(label("camera", i, camera.name), "a value is out of range");
        Json entry = Json::object();
        set_name(entry, camera.name);
        const bool flat = camera.kind == ProjectionKind::orthographic;
        entry["type"] = flat ? "orthographic" : "perspective";
        entry[flat ? "orthographic" : "perspective"] = flat ? orthographic(camera) : perspective(camera);
        document.add("cameras", std::move(entry));
    }
}

} // namespace prelight::write
