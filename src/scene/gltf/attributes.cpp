#include <scene/gltf/attributes.hpp>

namespace prelight::gltf {

Attributes::Attributes(Document& document, Accessors& accessors, const Item& item)
    : document_(document), accessors_(accessors), item_(item), list_(item.object("attributes")),
      quantized_(document.uses("KHR_mesh_quantization")) {}

const DracoMesh& Attributes::set_draco(Buffers& buffers, const Item& extension) {
    draco_.emplace(document_, buffers, extension);
    vertices_ = draco_->points();
    return *draco_;
}

void Attributes::count_vertices() {
    vertices_ = accessors_.get(list_->required_index("POSITION", document_.count(Table::accessors))).count;
}

Attributes::Values Attributes::find(const std::string& name, Semantic semantic) {
    const auto accessor = list_->index(name, document_.count(Table::accessors));
    if (!accessor)
        return {};
    const Elements* found = nullptr;
    if (draco_) {
        const Item item = document_.item(Table::accessors, *accessor);
        document_.charge(item_.label(), vertices_, sizeof(uint32_t));
        draco_elements_ = draco_->attribute(name, item.flag("normalized"));
        if (draco_elements_)
            found = &*draco_elements_;
    }
    return fitting(item_, name, semantic, found ? *found : accessors_.get(*accessor));
}

Attributes::Values Attributes::find_delta(const Item& target, const std::string& name, Semantic semantic) const {
    const auto accessor = target.index(name, document_.count(Table::accessors));
    return accessor ? fitting(target, name, semantic, accessors_.get(*accessor)) : Values{};
}

Attributes::Values Attributes::fitting(const Item& item, const std::string& name, Semantic semantic,
                                       const Elements& found) const {
    const Fit fit = fit_attribute(found, semantic, quantized_);
    const bool needed = semantic == Semantic::position || semantic == Semantic::joints || semantic == Semantic::weights;
    if (!fit.usable && needed)
        item.fail(fmt::format("{}: {}", name, fit.warning));
    if (!fit.usable) {
        item.warn("{}: {}; it is left out", name, fit.warning);
        return {};
    }
    if (found.count != vertices_)
        item.fail(fmt::format("{}: has {} values for {} vertices", name, found.count, vertices_));
    if (!fit.warning.empty())
        item.warn("{}: {}", name, fit.warning);
    return {&found, fit.divisor};
}

} // namespace prelight::gltf
