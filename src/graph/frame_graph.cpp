#include "frame_graph.hpp"
#include <algorithm>
#include <cstring>
#include <fmt/format.h>
#include <gpu/check.hpp>
#include <parallel/parallel_for.hpp>
#include <prelight/error.hpp>
#include <shared/bindings.h>
#include <shared/raster.h>
#include <utility>

namespace prelight::graph {

void Pass::use(ImageId image, const Access& access) {
    const auto same =
        std::find_if(images_.begin(), images_.end(), [&](const ImageUse& use) { return use.image == image; });
    if (same == images_.end())
        images_.push_back({image, access});
    else
        same->access |= access;
}

Pass& Pass::colour(ImageId image, Load load, std::array<float, 4> clear) {
    colours_.push_back({image, load, clear});
    use(image, Access::colour());
    return *this;
}

Pass& Pass::blends() {
    blends_ = true;
    return *this;
}

Pass& Pass::depth_write(ImageId image, Load load, float clear) {
    depth_ = Attachment{image, load, {clear}};
    depth_writes_ = true;
    use(image, Access::depth_write());
    return *this;
}

Pass& Pass::depth_test(ImageId image) {
    depth_ = Attachment{image, Load::keep, {}};
    use(image, Access::depth_test());
    return *this;
}

Pass& Pass::stencil(ImageId image) {
    depth_ = Attachment{image, Load::keep, {}};
    stencil_ = true;
    use(image, Access::stencil_write());
    return *this;
}

Pass& Pass::keeps_stencil(Load load) {
    stencil_ = true;
    stencil_load_ = load;
    return *this;
}

Pass& Pass::sample_stencil(uint32_t binding, ImageId image) {
    stencils_.push_back(binding);
    return sample(binding, image);
}

Pass& Pass::sample(uint32_t binding, ImageId image) {
    sampled_.emplace_back(binding, image);
    return *this; // the access depends on the format: added by FrameGraph::compile
}

Pass& Pass::draws_between(uint32_t binding, ImageId image) {
    between_ = image;
    sample(binding, image);
    Access access = Access::depth_write();
    access.layout = Access::sampled(true).layout; // so the pass finds and leaves it
    use(image, access);
    return *this;
}

Pass& Pass::store(uint32_t binding, ImageId image) {
    stored_.emplace_back(binding, image);
    use(image, Access::storage_image());
    return *this;
}

Pass& Pass::sample_bits(uint32_t binding, ImageId image) {
    bits_.push_back(binding);
    return sample(binding, image);
}

Pass& Pass::storage(uint32_t binding, BufferId buffer, bool writes) {
    storages_.emplace_back(binding, buffer);
    buffers_.push_back({buffer, Access::storage(writes)});
    return *this;
}

Pass& Pass::indirect(BufferId buffer) {
    buffers_.push_back({buffer, Access::indirect()});
    return *this;
}

Pass& Pass::indices(BufferId buffer) {
    buffers_.push_back({buffer, Access::indices()});
    return *this;
}

Pass& Pass::condition(BufferId buffer) {
    buffers_.push_back({buffer, Access::condition()});
    return *this;
}

Pass& Pass::copy_to(BufferId buffer) {
    buffers_.push_back({buffer, Access::copied_to()});
    return *this;
}

Pass& Pass::before_rendering(std::function<void(const PassContext&)> callback) {
    before_rendering_ = std::move(callback);
    return *this;
}

Pass& Pass::raster(const gpu::Raster& raster) {
    raster_ = raster;
    return *this;
}

Pass& Pass::always() {
    always_ = true;
    return *this;
}

Pass& Pass::prepare(std::function<void(const PassInterface&)> callback) {
    prepare_ = std::move(callback);
    return *this;
}

Pass& Pass::record(std::function<void(const PassContext&)> callback) {
    record_ = std::move(callback);
    return *this;
}

ImageId FrameGraph::image(std::string name, const ImageDesc& desc) {
    GraphImage image;
    image.name = std::move(name);
    image.desc = desc;
    images_.push_back(std::move(image));
    return {static_cast<uint32_t>(images_.size() - 1)};
}

ImageId FrameGraph::external_image(std::string name, const ImageDesc& desc) {
    return external_ = image(std::move(name), desc);
}

ImageId FrameGraph::image(std::string name, const gpu::Raster& raster, std::span<const VkFormat> formats) {
    for (const VkFormat format : formats) {
        const VkFormatFeatureFlags target =
            is_depth(format) ? VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT : VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT;
        if (!context_.supports(format, target | VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT))
            continue;
        if (format != formats.front())
            note(fmt::format("{}: {} is no target on {}, {} is taken", name, format_name(formats.front()),
                             context_.name(), format_name(format)));
        return image(std::move(name), {format, raster});
    }
    throw Error(fmt::format("{}: {} has no format for it", context_.name(), name));
}

void FrameGraph::note(const std::string& line) {
    if (std::find(notes_.begin(), notes_.end(), line) == notes_.end())
        notes_.push_back(line);
}

BufferId FrameGraph::add_buffer(std::string name, const gpu::PerFrame<VkBuffer>& handles) {
    const auto known = std::find_if(buffers_.begin(), buffers_.end(),
                                    [&](const GraphBuffer& buffer) { return buffer.handles == handles; });
    if (known != buffers_.end())
        return {static_cast<uint32_t>(known - buffers_.begin())};
    buffers_.push_back({std::move(name), handles});
    return {static_cast<uint32_t>(buffers_.size() - 1)};
}

BufferId FrameGraph::buffer(std::string name, const gpu::Buffer& buffer) {
    gpu::PerFrame<VkBuffer> handles;
    handles.fill(buffer.handle());
    return add_buffer(std::move(name), handles);
}

BufferId FrameGraph::buffer(std::string name, const gpu::PerFrame<gpu::Buffer>& buffers) {
    gpu::PerFrame<VkBuffer> handles;
    for (uint32_t slot = 0; slot < gpu::frames_in_flight; ++slot)
        handles[slot] = buffers[slot].handle();
    return add_buffer(std::move(name), handles);
}

void FrameGraph::rebind(BufferId id, const gpu::Buffer& buffer) {
    buffers_[id.index].handles.fill(buffer.handle());
    for (std::vector<BufferId>& slot : stale_)
        slot.push_back(id);
}

void FrameGraph::retire(gpu::Buffer buffer) { retired_.push_back({frame_, std::move(buffer)}); }

void FrameGraph::bind_anew(BufferId id, uint32_t slot) {
    for (const auto& pass : passes_) {
        std::vector<gpu::Binding> bindings;
        for (const auto& [binding, used] : pass->storages_)
            if (used.index == id.index)
                bindings.push_back(gpu::Binding::storage(binding, buffers_[id.index].handles[slot]));
        pass->sets_.update(context_, slot, bindings);
    }
}

Pass& FrameGraph::pass(std::string name) { return *passes_.emplace_back(std::make_unique<Pass>(std::move(name))); }

void FrameGraph::persist(ImageId image) { images_[image.index].persistent = true; }

void FrameGraph::keep(ImageId image) { images_[image.index].kept = true; }

Access FrameGraph::sampled_access(const Pass& pass, ImageId image) const {
    Access access = Access::sampled(is_depth(images_[image.index].desc.format));
    if (pass.stencil_ && pass.depth_->image == image)
        access.layout = Access::stencil_write().layout; // the pass holds its stencil for writing
    for (const auto& [binding, stored] : pass.stored_)
        if (stored == image)
            access.layout = Access::storage_image().layout;
    return access;
}

void FrameGraph::compile() {
    for (const auto& pass : passes_)
        for (const auto& [binding, image] : pass->sampled_)
            pass->use(image, sampled_access(*pass, image));
    cull_passes();
    find_lifetimes();
    create_images();
    place_images();
    create_views();
    derive_barriers();
    begin_persistent_images();
    prepare_passes();
    if (passes_.empty())
        return;

    VkQueryPoolCreateInfo info{VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO};
    info.queryType = VK_QUERY_TYPE_TIMESTAMP;
    info.queryCount = first_query(gpu::frames_in_flight);
    VkQueryPool pool = VK_NULL_HANDLE;
    gpu::check(vkCreateQueryPool(context_.device(), &info, nullptr, &pool), "timestamps");
    queries_ = {context_.device(), pool};
    context_.set_name(VK_OBJECT_TYPE_QUERY_POOL, reinterpret_cast<uint64_t>(pool), "pass timestamps");
}

void FrameGraph::cull_passes() {
    std::vector<bool> needed(images_.size());
    for (size_t i = 0; i < images_.size(); ++i)
        needed[i] = images_[i].kept || external_ == ImageId{static_cast<uint32_t>(i)};
    for (auto it = passes_.rbegin(); it != passes_.rend(); ++it) {
        Pass& pass = **it;
        pass.alive_ =
            pass.always_ ||
            std::any_of(pass.images_.begin(), pass.images_.end(),
                        [&](const Pass::ImageUse& use) { return use.access.writes && needed[use.image.index]; }) ||
            std::any_of(pass.buffers_.begin(), pass.buffers_.end(),
                        [](const Pass::BufferUse& use) { return use.access.writes; });
        if (pass.alive_)
            for (const Pass::ImageUse& use : pass.images_)
                needed[use.image.index] = true;
    }
    std::erase_if(passes_, [](const auto& pass) { return !pass->alive_; });
}

std::vector<gpu::Binding> FrameGraph::bindings(const Pass& pass, uint32_t slot) const {
    std::vector<gpu::Binding> bindings;
    for (const auto& [binding, image] : pass.sampled_) {
        bindings.push_back(
            gpu::Binding::sampled(binding, sampled_view(pass, binding, image), sampled_access(pass, image).layout));
    }
    for (const auto& [binding, image] : pass.stored_)
        bindings.push_back(gpu::Binding::storage_image(binding, images_[image.index].view));
    for (const auto& [binding, buffer] : pass.storages_)
        bindings.push_back(gpu::Binding::storage(binding, buffers_[buffer.index].handles[slot]));
    return bindings;
}

VkImageView FrameGraph::sampled_view(const Pass& pass, uint32_t binding, ImageId image) const {
    if (std::find(pass.bits_.begin(), pass.bits_.end(), binding) != pass.bits_.end())
        return images_[image.index].bits_view;
    if (std::find(pass.stencils_.begin(), pass.stencils_.end(), binding) != pass.stencils_.end())
        return images_[image.index].stencil_only_view;
    return sampled_view(image);
}

VkImageView FrameGraph::sampled_view(ImageId id) const {
    const GraphImage& image = images_[id.index];
    return has_stencil(image.desc.format) ? image.depth_only_view : image.view;
}

gpu::Raster FrameGraph::raster_of(const Pass& pass) const {
    return pass.raster_ ? *pass.raster_ : pass.target() ? raster(*pass.target()) : gpu::Raster{};
}

void FrameGraph::write_rasters() {
    raster_stride_ = std::max<uint64_t>(sizeof(shared::RasterConstants),
                                        context_.limits().minUniformBufferOffsetAlignment); // both powers of two
    std::vector<std::byte> bytes(raster_stride_ * std::max<size_t>(passes_.size(), 1));
    for (size_t p = 0; p < passes_.size(); ++p) {
        const VkExtent2D extent = raster_of(*passes_[p]).extent;
        const glm::dvec2 size(extent.width, extent.height);
        const shared::RasterConstants constants{glm::vec4(size, 1.0 / glm::max(size, 1.0))};
        std::memcpy(&bytes[p * raster_stride_], &constants, sizeof constants);
    }
    rasters_ = gpu::make_device_buffer(context_, "rasters", bytes, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
}

void FrameGraph::prepare_passes() {
    write_rasters();
    std::vector<PassInterface> interfaces;
    for (size_t p = 0; p < passes_.size(); ++p) {
        const auto& pass = passes_[p];
        std::vector<std::vector<gpu::Binding>> sets;
        for (uint32_t slot = 0; slot < gpu::frames_in_flight; ++slot) {
            sets.push_back(bindings(*pass, slot));
            sets.back().push_back(gpu::Binding::uniform(INPUT_RASTER, rasters_.handle(), p * raster_stride_,
                                                        sizeof(shared::RasterConstants)));
        }
        pass->layout_ = gpu::make_set_layout(context_, pass->name_, sets[0]);
        pass->sets_ = gpu::DescriptorSets(context_, pass->name_, pass->layout_, sets);

        PassInterface interface {
            .inputs = pass->layout_, .attachments = {}
        };
        for (const Pass::Attachment& attachment : pass->colours_)
            interface.attachments.colours.push_back(desc(attachment.image).format);
        if (pass->depth_)
            interface.attachments.depth = desc(pass->depth_->image).format;
        if (pass->stencil_)
            interface.attachments.stencil = interface.attachments.depth;
        if (pass->target())
            interface.attachments.samples = raster(*pass->target()).samples;
        interfaces.push_back(std::move(interface));
    }
    // Drivers take most of the time here, to compile pipelines.
    parallel_for(static_cast<uint32_t>(passes_.size()), [&](uint32_t p) {
        if (passes_[p]->prepare_)
            passes_[p]->prepare_(interfaces[p]);
    });
}

} // namespace prelight::graph
