#pragma once
#include "compute_pipeline.hpp"
#include "pipeline.hpp"
#include <map>
#include <memory>
#include <mutex>

namespace prelight::gpu {

/// What has been built for one device, shared by all renderers on it: a second renderer that draws as the first one
/// takes no time to compile. Objects are found by all that they are built from. Calls may come from several threads.
class PipelineLibrary {
public:
    /// Of the description, or what `make()` builds of it. What nobody uses any more is kept, up to `most_kept` in all.
    template <class Desc, class Make>
    std::shared_ptr<const BuiltPipeline> find(const Desc& desc, Make&& make) {
        const std::scoped_lock lock(mutex_);
        auto& built = std::get<std::map<Desc, std::shared_ptr<const BuiltPipeline>>>(built_);
        const auto found = built.find(desc);
        if (found != built.end())
            return found->second;
        if (built.size() >= most_kept)
            std::erase_if(built, [](const auto& one) { return one.second.use_count() == 1; });
        return built.emplace(desc, make()).first->second;
    }

    /// {binding, type} in order.
    using SetLayoutKey = std::vector<std::pair<uint32_t, VkDescriptorType>>;
    template <class Make>
    VkDescriptorSetLayout find_set_layout(const SetLayoutKey& key, Make&& make) {
        const std::scoped_lock lock(mutex_);
        const auto found = set_layouts_.find(key);
        return found != set_layouts_.end() ? found->second : set_layouts_.emplace(key, make()).first->second;
    }

private:
    static constexpr size_t most_kept = 2048;
    std::mutex mutex_;
    std::map<SetLayoutKey, UniqueSetLayout> set_layouts_; // pipelines' descriptions name them by their handles
    std::tuple<std::map<GraphicsPipelineDesc, std::shared_ptr<const BuiltPipeline>>,
               std::map<ComputePipelineDesc, std::shared_ptr<const BuiltPipeline>>>
        built_;
};

} // namespace prelight::gpu
