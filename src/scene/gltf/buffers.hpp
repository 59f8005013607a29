#pragma once
#include <optional>
#include <scene/gltf/document.hpp>

namespace prelight::gltf {

/// The file's buffers and views of them, compressed views decoded at first use.
class Buffers {
public:
    /// Reads every buffer and checks every view against its buffer. Throws Error.
    explicit Buffers(Document& document);

    struct View {
        std::span<const uint8_t> bytes;
        uint32_t stride = 0; ///< bytes from one element to the next; 0: packed
    };
    /// `index` < count of bufferViews. Throws Error when a compressed view does not decode.
    const View& view(uint32_t index);

private:
    void read_buffer(uint32_t index);
    void check_view(uint32_t index);
    std::span<const uint8_t> range(const Item& item, const char* buffer_key) const;
    View decode_meshopt(const Item& extension);

    Document& document_;
    std::vector<std::optional<std::span<const uint8_t>>> buffers_; ///< empty: a fallback, no data
    std::vector<std::optional<View>> views_;                       ///< empty: not decoded yet
    std::vector<std::unique_ptr<Bytes>> decoded_;
};

} // namespace prelight::gltf
