#pragma once
#include <memory>
#include <scene/gltf/accessors.hpp>

namespace prelight::gltf {

/// A primitive's KHR_draco_mesh_compression data, decoded by libdraco and checked again afterwards.
class DracoMesh {
public:
    /// Throws Error naming the extension's object.
    DracoMesh(Document& document, Buffers& buffers, const Item& extension);
    ~DracoMesh();

    uint32_t points() const;
    uint64_t corners() const; ///< length of indices()
    /// Triangle list; every index < points().
    std::vector<uint32_t> indices() const;
    /// The attribute's values for each point; nothing when the extension does not hold `name`. They
    /// live as long as this object. `normalized` is the accessor's.
    std::optional<Elements> attribute(const std::string& name, bool normalized) const;

private:
    struct Decoded;
    std::unique_ptr<Decoded> decoded_;
    Item extension_;
    std::unique_ptr<Loan> loan_;
};

} // namespace prelight::gltf
