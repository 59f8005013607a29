#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wcast-qual"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wnon-virtual-dtor"
#pragma GCC diagnostic ignored "-Woverloaded-virtual"
#include <draco/compression/mesh/mesh_edgebreaker_decoder.h>
#include <draco/compression/mesh/mesh_sequential_decoder.h>
#include <draco/core/varint_decoding.h>
#pragma GCC diagnostic pop
#include <fmt/format.h>
#include <scene/gltf/draco_mesh.hpp>

namespace prelight::gltf {
namespace {

/// libdraco's decoder with a limit on memory: it allocates by counts from the data that it does not
/// prove, so each count is looked at before the part that allocates runs.
template <class Base>
class Bounded : public Base {
public:
    explicit Bounded(uint64_t limit) : limit_(limit) {}
    uint64_t taken() const { return taken_; }
    bool too_large() const { return too_large_; }

protected:
    bool DecodeConnectivity() override { return take(connectivity_bytes()) && Base::DecodeConnectivity(); }

    /// After the attributes' types are known, before their values are made.
    bool DecodeAllAttributes() override {
        const draco::PointCloud& cloud = *this->point_cloud();
        for (int32_t i = 0; i < cloud.num_attributes(); ++i) {
            const draco::PointAttribute& attribute = *cloud.attribute(i);
            // Values as integers, values in their own type, and the map from points to them.
            const uint64_t value =
                uint64_t(attribute.num_components()) * (8 + uint64_t(draco::DataTypeLength(attribute.data_type())));
            if (!take(uint64_t(cloud.num_points()) * (value + 8))) // < 2^32 · 2^13
                return false;
        }
        return Base::DecodeAllAttributes();
    }

private:
    bool take(uint64_t bytes) {
        too_large_ = too_large_ || bytes > limit_ - taken_;
        if (!too_large_)
            taken_ += bytes;
        return !too_large_;
    }

    /// Reads ahead in the connectivity's header (Draco bitstream 2.2) and says what decoding it
    /// takes.
    uint64_t connectivity_bytes() {
        draco::DecoderBuffer ahead = *this->buffer();
        if constexpr (std::is_same_v<Base, draco::MeshEdgebreakerDecoder>) {
            uint32_t vertices = 0, faces = 0, symbols = 0, splits = 0;
            uint8_t attributes = 0;
            if (!draco::DecodeVarint(&vertices, &ahead) || !draco::DecodeVarint(&faces, &ahead) ||
                !ahead.Decode(&attributes) || !draco::DecodeVarint(&symbols, &ahead) ||
                !draco::DecodeVarint(&splits, &ahead))
                return 0; // cut short: Base finds the same
            // Corner tables: two words a corner, and a table for each kind of attribute seams.
            return faces * (uint64_t(64) + uint64_t(40) * attributes) +
                   (uint64_t(vertices) + splits) * (uint64_t(16) + uint64_t(16) * attributes);
        } else {
            uint32_t faces = 0, points = 0;
            if (!draco::DecodeVarint(&faces, &ahead) || !draco::DecodeVarint(&points, &ahead))
                return 0;
            return faces * uint64_t(24) + points * uint64_t(8);
        }
    }

    uint64_t limit_, taken_ = 0;
    bool too_large_ = false;
};

struct Outcome {
    uint64_t taken = 0;
    bool too_large = false;
    std::string error; ///< empty: decoded
};

template <class Base>
Outcome run(std::span<const uint8_t> bytes, uint64_t limit, draco::Mesh& mesh) {
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const draco::DecoderOptions options;
    Bounded<Base> decoder(limit);
    const draco::Status status = decoder.Decode(options, &buffer, &mesh);
    return {decoder.taken(), decoder.too_large(), status.ok() ? "" : status.error_msg_string()};
}

std::optional<Component> component_of(draco::DataType type) {
    switch (type) {
    case draco::DT_INT8: return Component::i8;
    case draco::DT_UINT8: return Component::u8;
    case draco::DT_INT16: return Component::i16;
    case draco::DT_UINT16: return Component::u16;
    case draco::DT_UINT32: return Component::u32;
    case draco::DT_FLOAT32: return Component::f32;
    default: return {};
    }
}

} // namespace

struct DracoMesh::Decoded {
    draco::Mesh mesh;
};

DracoMesh::~DracoMesh() = default;

DracoMesh::DracoMesh(Document& document, Buffers& buffers, const Item& extension)
    : decoded_(std::make_unique<Decoded>()), extension_(extension) {
    const uint32_t view = extension.required_index("bufferView", document.count(Table::buffer_views));
    const std::span<const uint8_t> bytes = buffers.view(view).bytes;
    // For the time it takes: any number of primitives may name the same data.
    document.charge(extension.label(), bytes.size(), 1);
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    draco::DracoHeader header;
    if (!draco::PointCloudDecoder::DecodeHeader(&buffer, &header).ok())
        extension.fail("is not Draco data");
    if (header.encoder_type != draco::TRIANGULAR_MESH)
        extension.fail("is not a Draco mesh");
    if (header.version_major != 2 || header.version_minor != 2)
        extension.fail(fmt::format("Draco bitstream {}.{} is not 2.2", header.version_major, header.version_minor));
    const uint64_t limit = document.budget().left(Budget::Pool::geometry);
    const bool edgebreaker = header.encoder_method == draco::MESH_EDGEBREAKER_ENCODING;
    const Outcome outcome = edgebreaker ? run<draco::MeshEdgebreakerDecoder>(bytes, limit, decoded_->mesh)
                                        : run<draco::MeshSequentialDecoder>(bytes, limit, decoded_->mesh);
    if (outcome.too_large)
        extension.fail("needs more memory than a file of this size may take");
    if (!outcome.error.empty())
        extension.fail(fmt::format("does not decode ({})", printable(outcome.error)));
    loan_ = std::make_unique<Loan>(document.budget(), Budget::Pool::geometry, outcome.taken);
    const draco::Mesh& mesh = decoded_->mesh;
    for (draco::FaceIndex face(0); face < mesh.num_faces(); ++face)
        for (const draco::PointIndex& point : mesh.face(face))
            if (point.value() >= mesh.num_points())
                extension.fail(fmt::format("index {} is beyond its {} vertices", point.value(), mesh.num_points()));
}

uint32_t DracoMesh::points() const { return decoded_->mesh.num_points(); }
uint64_t DracoMesh::corners() const { return uint64_t(decoded_->mesh.num_faces()) * 3; }

std::vector<uint32_t> DracoMesh::indices() const {
    std::vector<uint32_t> out;
    out.reserve(corners());
    for (draco::FaceIndex face(0); face < decoded_->mesh.num_faces(); ++face)
        for (const draco::PointIndex& point : decoded_->mesh.face(face))
            out.push_back(point.value());
    return out;
}

std::optional<Elements> DracoMesh::attribute(const std::string& name, bool normalized) const {
    const auto attributes = extension_.object("attributes");
    const auto id = attributes ? attributes->integer(name) : std::nullopt;
    if (!id)
        return {};
    const draco::PointAttribute* attribute =
        *id <= 0xffffffffu ? decoded_->mesh.GetAttributeByUniqueId(uint32_t(*id)) : nullptr;
    if (!attribute)
        attributes->fail(fmt::format("{}: the Draco data has no attribute {}", name, *id));
    const auto component = component_of(attribute->data_type());
    const uint32_t width = uint32_t(attribute->num_components());
    if (!component || width < 1 || width > 4)
        attributes->fail(fmt::format("{}: its Draco type cannot be read", name));
    Elements elements;
    elements.label = attributes->label() + " " + name;
    elements.component = *component;
    elements.width = width;
    elements.normalized = normalized;
    elements.count = points();
    elements.stride = size_t(attribute->byte_stride());
    const draco::DataBuffer* data = attribute->buffer();
    const uint64_t size = uint64_t(width) * size_of(*component);
    elements.map.reserve(elements.count);
    for (uint32_t i = 0; i < elements.count; ++i) {
        if (!attribute->is_mapping_identity() && i >= attribute->indices_map_size())
            attributes->fail(fmt::format("{}: vertex {} has no value", name, i));
        const uint32_t value = attribute->mapped_index(draco::PointIndex(i)).value();
        const uint64_t at = uint64_t(attribute->byte_offset()) + value * uint64_t(elements.stride);
        if (value >= attribute->size() || !data || at + size > data->data_size())
            attributes->fail(fmt::format("{}: vertex {} has no value", name, i));
        elements.map.push_back(value);
    }
    if (elements.count > 0)
        elements.base = data->data() + attribute->byte_offset();
    return elements;
}

} // namespace prelight::gltf
