#pragma once
#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <scene/gltf/draco_mesh.hpp>
#include <scene/gltf/kinds.hpp>

namespace prelight::gltf {

/// A primitive's vertices in the file: the values of attributes, for the vertices that its triangles use.
class Attributes {
public:
    Attributes(Document& document, Accessors& accessors, const Item& item);

    bool has(const std::string& name) const { return list_ && list_->has(name); }
    uint32_t vertices() const { return vertices_; }
    const std::vector<uint32_t>& used() const { return used_; }
    /// The vertices that count, or the file's Draco data, before anything is gathered.
    void set_used(std::vector<uint32_t> used) { used_ = std::move(used); }
    const DracoMesh& set_draco(Buffers& buffers, const Item& extension);
    /// As many as POSITION has.
    void count_vertices();

    /// Values whose kind fits the use, for each vertex of the file; null when there are none. A kind that glTF
    /// does not allow is told and read as Fit says; one that cannot be used is left out, or is an Error where the
    /// primitive is nothing without it.
    struct Values {
        const Elements* elements = nullptr;
        float divisor = 1;
        explicit operator bool() const { return elements != nullptr; }
        glm::vec4 vec(uint32_t vertex) const { return elements->vec(vertex) / divisor; }
    };
    Values find(const std::string& name, Semantic semantic);
    /// The same of a morph target's attribute.
    Values find_delta(const Item& target, const std::string& name, Semantic semantic) const;

    /// Of values that are floats side by side, as nearly all files have them: what `vec` gives.
    template <int width>
    static auto floats_of(const Values& values) {
        return [from = values.elements->base, stride = values.elements->stride](uint32_t vertex) {
            std::array<float, 4> value{};
            std::memcpy(value.data(), from + vertex * stride, width * sizeof(float));
            return glm::vec4(value[0], value[1], value[2], value[3]);
        };
    }

    /// Calls `store(place, value)` for each used vertex. A value that is not finite is stored as `instead`, and
    /// told as `repair` says (empty: by someone else). Returns the places of such values.
    template <class Store>
    std::vector<uint32_t> gather(const Item& item, const std::string& name, const Values& values, glm::vec4 instead,
                                 std::string_view repair, Store store) const {
        std::vector<uint32_t> bad;
        const auto each = [&](const auto& value_of) {
            for (uint32_t place = 0; place < used_.size(); ++place) {
                const glm::vec4 value = value_of(used_[place]);
                const bool good = is_finite(value);
                if (!good)
                    bad.push_back(place);
                store(place, good ? value : instead);
            }
        };
        const Elements& elements = *values.elements;
        const bool floats = elements.direct() && elements.component == Component::f32 && values.divisor == 1;
        if (floats && elements.width == 2)
            each(floats_of<2>(values));
        else if (floats && elements.width == 3)
            each(floats_of<3>(values));
        else if (floats && elements.width == 4)
            each(floats_of<4>(values));
        else
            each([&](uint32_t vertex) { return values.vec(vertex); });
        if (!bad.empty() && !repair.empty())
            item.warnings().add(fmt::format("not finite: {}", repair), item.label(),
                                fmt::format("{}: vertex {} is not finite; {}", name, used_[bad[0]], repair),
                                bad.size());
        return bad;
    }

private:
    static bool is_finite(const glm::vec4& v) {
        return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w);
    }
    Values fitting(const Item& item, const std::string& name, Semantic semantic, const Elements& found) const;

    Document& document_;
    Accessors& accessors_;
    const Item& item_;
    std::optional<Item> list_;
    bool quantized_;
    std::optional<DracoMesh> draco_;
    std::optional<Elements> draco_elements_; ///< of the attribute found last
    uint32_t vertices_ = 0;
    std::vector<uint32_t> used_;
};

} // namespace prelight::gltf
