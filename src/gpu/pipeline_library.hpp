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
    /// Of the description, or what `make()` builds of it, beside what other threads build meanwhile. What nobody uses
    /// any more is kept, up to `most_kept` in all.
    template <class Desc, class Make>
    std::shared_ptr<const BuiltPipeline> find(const Desc& desc, Make&& make) {
        auto& all = std::get<std::map<Desc, std::shared_ptr<Entry>>>(built_);
        const std::shared_ptr<Entry> entry = find_entry(all, desc);
        const std::scoped_lock lock(entry->mutex);
        if (!entry->built)
            entry->built = make();
        return entry->built;
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

    struct Entry {
        std::mutex mutex; ///< held while it is built: others who want the same wait for it
        std::shared_ptr<const BuiltPipeline> built;
    };
    template <class Desc>
    std::shared_ptr<Entry> find_entry(std::map<Desc, std::shared_ptr<Entry>>& all, const Desc& desc) {
        const std::scoped_lock lock(mutex_);
        const auto found = all.find(desc);
        if (found != all.end())
            return found->second;
        if (all.size() >= most_kept) // an entry that a thread holds has two users
            std::erase_if(
                all, [](const auto& one) { return one.second.use_count() == 1 && one.second->built.use_count() <= 1; });
        return all.emplace(desc, std::make_shared<Entry>()).first->second;
    }

    std::mutex mutex_;
    std::map<SetLayoutKey, UniqueSetLayout> set_layouts_; // pipelines' descriptions name them by their handles
    std::tuple<std::map<GraphicsPipelineDesc, std::shared_ptr<Entry>>,
               std::map<ComputePipelineDesc, std::shared_ptr<Entry>>>
        built_;
};

} // namespace prelight::gpu
