#include <algorithm>
#include <cstring>
#include <fmt/format.h>
#include <scene/gltf/accessors.hpp>

namespace prelight::gltf {
namespace {

template <class T>
T load(const uint8_t* bytes) { // data from a file is not aligned
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return value;
}

/// glTF 2.0, 3.6.2.2: normalised integers; the signed minimum means −1 like its neighbour.
float to_float(const uint8_t* bytes, Component component, bool normalized) {
    switch (component) {
    case Component::i8: {
        const auto v = float(load<int8_t>(bytes));
        return normalized ? std::max(v / 127.f, -1.f) : v;
    }
    case Component::u8: {
        const auto v = float(*bytes);
        return normalized ? v / 255.f : v;
    }
    case Component::i16: {
        const auto v = float(load<int16_t>(bytes));
        return normalized ? std::max(v / 32767.f, -1.f) : v;
    }
    case Component::u16: {
        const auto v = float(load<uint16_t>(bytes));
        return normalized ? v / 65535.f : v;
    }
    case Component::u32: return float(load<uint32_t>(bytes));
    case Component::f32: return load<float>(bytes);
    }
    return 0;
}

Component component_of(const Item& item) {
    const uint64_t type = item.required_integer("componentType");
    if (type < 5120 || type > 5126 || type == 5124)
        item.fail(fmt::format("componentType {} is not known", type));
    return Component(type);
}

/// Sets width and columns from the accessor's type.
void read_type(const Item& item, Elements& elements) {
    struct Type {
        const char* name;
        uint32_t width, columns;
    };
    constexpr std::array<Type, 7> types{{{"SCALAR", 1, 1},
                                         {"VEC2", 2, 1},
                                         {"VEC3", 3, 1},
                                         {"VEC4", 4, 1},
                                         {"MAT2", 2, 2},
                                         {"MAT3", 3, 3},
                                         {"MAT4", 4, 4}}};
    const std::string name = item.text("type");
    const auto found = std::find_if(types.begin(), types.end(), [&](const Type& type) { return type.name == name; });
    if (found == types.end())
        item.fail(fmt::format("type \"{}\" is not known", printable(name)));
    elements.width = found->width;
    elements.columns = found->columns;
    const uint32_t packed = elements.width * size_of(elements.component);
    elements.column_stride = found->columns > 1 ? (packed + 3) & ~3u : packed;
}

/// Bytes of one element.
size_t size_of(const Elements& elements) { return size_t(elements.columns) * elements.column_stride; }

} // namespace

uint32_t size_of(Component component) {
    switch (component) {
    case Component::i8:
    case Component::u8: return 1;
    case Component::i16:
    case Component::u16: return 2;
    default: return 4;
    }
}

const uint8_t* Elements::at(uint32_t element) const {
    if (!sparse.empty()) {
        const auto found = std::lower_bound(sparse.begin(), sparse.end(), element);
        if (found != sparse.end() && *found == element)
            return sparse_values + size_t(found - sparse.begin()) * columns * column_stride;
    }
    if (!base)
        return nullptr;
    return base + (map.empty() ? element : map[element]) * stride;
}

glm::vec4 Elements::column(uint32_t element, uint32_t column) const {
    glm::vec4 out(0);
    if (const uint8_t* bytes = at(element))
        for (uint32_t c = 0; c < width; ++c)
            out[int(c)] = to_float(bytes + column * column_stride + c * size_of(component), component, normalized);
    return out;
}

uint32_t Elements::index(uint32_t element) const {
    const uint8_t* bytes = at(element);
    if (!bytes)
        return 0;
    switch (size_of(component)) {
    case 1: return *bytes;
    case 2: return load<uint16_t>(bytes);
    default: return load<uint32_t>(bytes);
    }
}

Accessors::Accessors(Document& document, Buffers& buffers) : document_(document), buffers_(buffers) {
    document.charge("accessors", document.count(Table::accessors), sizeof(opened_[0]));
    opened_.resize(document.count(Table::accessors));
}

const Elements& Accessors::get(uint32_t index) {
    const Elements& elements = get_any(index);
    if (elements.columns > 1)
        gltf::fail(document_.file(), elements.label, "holds matrices, which cannot be used here");
    return elements;
}

const Elements& Accessors::get_any(uint32_t index) {
    if (!opened_[index]) {
        const Item item = document_.item(Table::accessors, index);
        document_.charge(item.label(), 1, sizeof(Elements) + 64);
        opened_[index] = std::make_unique<Elements>(open(item));
    }
    return *opened_[index];
}

/// Proves that `count` elements of `size` bytes lie in the view; sets the stride where it is 0.
const uint8_t* Accessors::locate(const Item& item, uint32_t view_index, uint64_t offset, uint64_t count, uint64_t size,
                                 size_t& stride) {
    const Buffers::View& view = buffers_.view(view_index);
    if (stride == 0)
        stride = view.stride != 0 ? view.stride : size;
    if (stride < size)
        item.fail(fmt::format("its elements of {} bytes overlap (byteStride {})", size, stride));
    const uint64_t length = view.bytes.size();
    // Subtractions only, each of a number proven smaller: nothing here can overflow.
    if (offset > length || size > length - offset || (count - 1) > (length - offset - size) / stride)
        item.fail(fmt::format("{} elements of {} bytes from byte {} lie beyond bufferView {} "
                              "({} bytes)",
                              count, size, offset, view_index, length));
    return view.bytes.data() + offset;
}

Elements Accessors::open(const Item& item) {
    Elements elements;
    elements.label = item.label();
    elements.component = component_of(item);
    read_type(item, elements);
    elements.normalized = item.flag("normalized");
    const uint64_t count = item.required_integer("count");
    if (count == 0 || count >= 0xffffffffu)
        item.fail(fmt::format("count {} is out of range", count));
    elements.count = uint32_t(count);
    if (const auto view = item.index("bufferView", document_.count(Table::buffer_views)))
        elements.base =
            locate(item, *view, item.integer_or("byteOffset", 0), count, size_of(elements), elements.stride);
    open_sparse(item, elements);
    return elements;
}

void Accessors::open_sparse(const Item& item, Elements& elements) {
    const auto sparse = item.object("sparse");
    if (!sparse)
        return;
    const auto indices = sparse->object("indices"), values = sparse->object("values");
    if (!indices || !values)
        sparse->fail("indices or values are missing");
    const uint64_t count = sparse->required_integer("count");
    if (count == 0 || count > elements.count)
        sparse->fail(fmt::format("count {} is not 1 … {}", count, elements.count));
    Elements places;
    places.component = component_of(*indices);
    if (places.component != Component::u8 && places.component != Component::u16 && places.component != Component::u32)
        indices->fail("componentType is not unsigned");
    const size_t views = document_.count(Table::buffer_views);
    places.stride = size_of(places.component); // packed by definition
    places.base = locate(*indices, indices->required_index("bufferView", views), indices->integer_or("byteOffset", 0),
                         count, places.stride, places.stride);
    size_t stride = size_of(elements);
    elements.sparse_values = locate(*values, values->required_index("bufferView", views),
                                    values->integer_or("byteOffset", 0), count, stride, stride);
    document_.charge(sparse->label(), count, sizeof(uint32_t));
    elements.sparse.reserve(count);
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t place = places.index(i);
        if (place >= elements.count)
            sparse->fail(fmt::format("index {} is beyond its {} elements", place, elements.count));
        if (i > 0 && place <= elements.sparse.back())
            sparse->fail(fmt::format("index {} does not increase", place));
        elements.sparse.push_back(place);
    }
}

} // namespace prelight::gltf
