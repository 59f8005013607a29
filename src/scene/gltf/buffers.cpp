#include <fmt/format.h>
#include <meshoptimizer.h>
#include <scene/gltf/buffers.hpp>
#include <scene/gltf/uri.hpp>

namespace prelight::gltf {
namespace {
constexpr const char* meshopt = "EXT_meshopt_compression";
} // namespace

Buffers::Buffers(Document& document) : document_(document) {
    document.charge("bufferViews", document.count(Table::buffer_views), sizeof(views_[0]));
    document.charge("buffers", document.count(Table::buffers), sizeof(buffers_[0]));
    for (uint32_t i = 0; i < document.count(Table::buffers); ++i)
        read_buffer(i);
    views_.resize(document.count(Table::buffer_views));
    for (uint32_t i = 0; i < views_.size(); ++i)
        check_view(i);
}

void Buffers::read_buffer(uint32_t index) {
    const Item item = document_.item(Table::buffers, index);
    const uint64_t length = item.required_integer("byteLength");
    std::span<const uint8_t> bytes;
    if (item.has("uri")) {
        try {
            bytes = document_.read_uri(item.text("uri"), item.label());
        } catch (const UriError& error) {
            item.fail(error.what());
        }
    } else if (index == 0 && !document_.binary_chunk().empty()) {
        bytes = document_.binary_chunk();
    } else {
        // No data: right for the fallback of compressed views, and harmless while nothing reads it.
        buffers_.emplace_back();
        return;
    }
    if (length > bytes.size())
        item.fail(fmt::format("byteLength is {}, but there are {} bytes", length, bytes.size()));
    buffers_.emplace_back(bytes.first(length));
}

std::span<const uint8_t> Buffers::range(const Item& item, const char* buffer_key) const {
    const uint32_t buffer = item.required_index(buffer_key, buffers_.size());
    const uint64_t offset = item.integer_or("byteOffset", 0);
    const uint64_t length = item.required_integer("byteLength");
    if (!buffers_[buffer])
        item.fail(fmt::format("buffer {} has no data", buffer));
    const std::span<const uint8_t> bytes = *buffers_[buffer];
    if (offset > bytes.size() || length > bytes.size() - offset)
        item.fail(
            fmt::format("its bytes {} + {} lie beyond buffer {} ({} bytes)", offset, length, buffer, bytes.size()));
    return bytes.subspan(offset, length);
}

void Buffers::check_view(uint32_t index) {
    const Item item = document_.item(Table::buffer_views, index);
    if (item.extension(meshopt))
        return;
    View view;
    view.bytes = range(item, "buffer");
    const uint64_t stride = item.integer_or("byteStride", 0);
    if (item.has("byteStride") && (stride < 4 || stride > 252))
        item.fail(fmt::format("byteStride {} is not 4 … 252", stride));
    view.stride = uint32_t(stride);
    views_[index] = view;
}

const Buffers::View& Buffers::view(uint32_t index) {
    if (!views_[index]) {
        const Item item = document_.item(Table::buffer_views, index);
        views_[index] = decode_meshopt(*item.extension(meshopt));
    }
    return *views_[index];
}

Buffers::View Buffers::decode_meshopt(const Item& extension) {
    const std::span<const uint8_t> source = range(extension, "buffer");
    const uint64_t count = extension.required_integer("count");
    const uint64_t stride = extension.required_integer("byteStride");
    const std::string mode = extension.text("mode"), filter = extension.text("filter");
    const bool attributes = mode == "ATTRIBUTES";
    if (!attributes && mode != "TRIANGLES" && mode != "INDICES")
        extension.fail(fmt::format("mode \"{}\" is not known", printable(mode)));
    // The decoder's own preconditions, which it only asserts.
    if (attributes ? stride < 4 || stride > 256 || stride % 4 != 0 : stride != 2 && stride != 4)
        extension.fail(fmt::format("byteStride {} does not fit mode {}", stride, mode));
    if (mode == "TRIANGLES" && count % 3 != 0)
        extension.fail(fmt::format("count {} is not a multiple of 3", count));
    document_.charge(extension.label(), count, stride);
    Bytes& out = *decoded_.emplace_back(std::make_unique<Bytes>(count * stride));
    int error = 0;
    if (attributes)
        error = meshopt_decodeVertexBuffer(out.data(), count, stride, source.data(), source.size());
    else if (mode == "TRIANGLES")
        error = meshopt_decodeIndexBuffer(out.data(), count, stride, source.data(), source.size());
    else
        error = meshopt_decodeIndexSequence(out.data(), count, stride, source.data(), source.size());
    if (error != 0)
        extension.fail("its data does not decode");
    if (filter.empty() || filter == "NONE")
        return {out, uint32_t(stride)};
    if (!attributes)
        extension.fail(fmt::format("filter \"{}\" needs mode ATTRIBUTES", printable(filter)));
    if (filter == "OCTAHEDRAL" && (stride == 4 || stride == 8))
        meshopt_decodeFilterOct(out.data(), count, stride);
    else if (filter == "QUATERNION" && stride == 8)
        meshopt_decodeFilterQuat(out.data(), count, stride);
    else if (filter == "EXPONENTIAL")
        meshopt_decodeFilterExp(out.data(), count, stride);
    else
        extension.fail(
            fmt::format("filter \"{}\" is not known or does not fit byteStride {}", printable(filter), stride));
    return {out, uint32_t(stride)};
}

} // namespace prelight::gltf
