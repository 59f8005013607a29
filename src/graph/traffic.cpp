// What passes move, and what images take, by their formats.
#include "frame_graph.hpp"
#include <set>

namespace prelight::graph {

uint64_t FrameGraph::texels_bytes(ImageId image) const {
    const ImageDesc& desc = images_[image.index].desc;
    const auto& [extent, samples] = desc.raster;
    return uint64_t(extent.width) * extent.height * samples * texel_bytes(desc.format);
}

uint64_t FrameGraph::unshared_bytes() const {
    uint64_t sum = 0;
    for (uint32_t i = 0; i < images_.size(); ++i)
        if (images_[i].usage)
            sum += texels_bytes({i});
    return sum;
}

std::vector<PassTraffic> FrameGraph::traffic() const {
    std::vector<PassTraffic> all;
    for (const auto& pass : passes_) {
        std::set<uint32_t> read, written; // an image that is tested and sampled counts once
        for (const Pass::Attachment& colour : pass->colours_) {
            written.insert(colour.image.index);
            if (colour.load == Load::keep || pass->blends_)
                read.insert(colour.image.index);
        }
        if (pass->depth_ && pass->depth_writes_)
            written.insert(pass->depth_->image.index);
        if (pass->depth_ && pass->depth_->load == Load::keep)
            read.insert(pass->depth_->image.index);
        for (const auto& [binding, image] : pass->sampled_)
            read.insert(image.index);
        for (const auto& [binding, image] : pass->stored_)
            written.insert(image.index);
        PassTraffic& traffic = all.emplace_back();
        traffic.name = pass->name_;
        for (const uint32_t image : read)
            traffic.bytes_read += texels_bytes({image});
        for (const uint32_t image : written)
            traffic.bytes_written += texels_bytes({image});
    }
    return all;
}

} // namespace prelight::graph
