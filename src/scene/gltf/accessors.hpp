#pragma once
#include <glm/vec4.hpp>
#include <scene/gltf/buffers.hpp>

namespace prelight::gltf {

/// glTF's component types (OpenGL's numbers).
enum class Component : uint16_t { i8 = 5120, u8 = 5121, i16 = 5122, u16 = 5123, u32 = 5125, f32 = 5126 };
uint32_t size_of(Component component); ///< bytes

/// Checked elements to read: `count` elements of `width` components, which surely lie in memory
/// that outlives the view. Filled from an accessor or from a decoded Draco attribute.
struct Elements {
    std::string label;             ///< for messages
    const uint8_t* base = nullptr; ///< null: all zero before `sparse`
    size_t stride = 0;             ///< bytes
    uint32_t count = 0;
    uint32_t width = 1;         ///< components, 1 … 4; of a matrix: rows
    uint32_t columns = 1;       ///< of a matrix: as many as rows
    uint32_t column_stride = 0; ///< bytes; a matrix's columns begin at multiples of 4
    Component component = Component::f32;
    bool normalized = false;                ///< integers mean 0 … 1 or −1 … 1
    std::vector<uint32_t> map;              ///< element → place in `base`; empty: the same (Draco)
    std::vector<uint32_t> sparse;           ///< replaced elements, increasing
    const uint8_t* sparse_values = nullptr; ///< packed

    const uint8_t* at(uint32_t element) const; ///< null: zero
    /// at() is base + element · stride, whichever it is.
    bool direct() const { return base && map.empty() && sparse.empty(); }
    /// Element as floats; components it does not have are 0.
    glm::vec4 vec(uint32_t element) const { return column(element, 0); }
    /// Column of a matrix.
    glm::vec4 column(uint32_t element, uint32_t column) const;
    uint32_t index(uint32_t element) const; ///< for integer scalars
};

/// The file's accessors, each checked when it is first used.
class Accessors {
public:
    Accessors(Document& document, Buffers& buffers);
    /// `index` < count of accessors. Throws Error when the accessor does not fit its view or holds
    /// matrices.
    const Elements& get(uint32_t index);
    /// The same for any type.
    const Elements& get_any(uint32_t index);

private:
    Elements open(const Item& item);
    const uint8_t* locate(const Item& item, uint32_t view, uint64_t offset, uint64_t count, uint64_t size,
                          size_t& stride);
    void open_sparse(const Item& item, Elements& elements);

    Document& document_;
    Buffers& buffers_;
    std::vector<std::unique_ptr<Elements>> opened_;
};

} // namespace prelight::gltf
