#pragma once
#include "resources.hpp"
#include <array>
#include <functional>
#include <gpu/buffer.hpp>
#include <gpu/descriptors.hpp>
#include <gpu/frames_in_flight.hpp>
#include <gpu/shown_image.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace prelight::graph {

/// What a pass knows when its pipelines are made: the layout of descriptor set `inputs` (one binding
/// for each sample() and storage(), and INPUT_RASTER), and what its attachments are.
struct PassInterface {
    VkDescriptorSetLayout inputs = VK_NULL_HANDLE;
    gpu::Attachments attachments; ///< a stencil format only with stencil()
};

/// What a pass gets when it records a frame. Inside, dynamic rendering has begun when the pass has
/// attachments; viewport and scissor cover them.
struct PassContext {
    VkCommandBuffer commands = VK_NULL_HANDLE;
    VkDescriptorSet inputs = VK_NULL_HANDLE;
    VkExtent2D extent{};
    uint32_t slot = 0;      ///< gpu::FrameTurn::slot
    bool one_pixel = false; ///< a warm-up: a dispatch whose result only the picture needs may be one group
    /// Draws into the image of Pass::draws_between(): the pass's own attachments are left and come back after it, and
    /// what is drawn is seen by all later draws. State that is bound is lost.
    std::function<void(const std::function<void()>&)> between{};
};

/// One pass: what it reads, what it writes, how it records. Barriers, layouts, load and store
/// operations, lifetimes and labels follow from the declarations.
class Pass {
public:
    explicit Pass(std::string name) : name_(std::move(name)) {}
    /// Colour attachments in the order of the shader's outputs.
    Pass& colour(ImageId image, Load load, std::array<float, 4> clear = {});
    /// The draws blend: what the colour attachments held is read as well (for traffic()).
    Pass& blends();
    /// Depth attachment, cleared to 0: reversed depth, the far end. Or to another value, 0 … 1.
    Pass& depth_write(ImageId image, Load load = Load::clear, float clear = 0);
    /// Depth test without writing; the same image may be sampled too.
    Pass& depth_test(ImageId image);
    /// Depth test as above with the image's stencil beside it, cleared to 0 and lost after the pass.
    Pass& stencil(ImageId image);
    /// What the draws leave in the stencil of the pass's depth image stays for passes after it; with depth_write(), or
    /// after stencil().
    Pass& keeps_stencil(Load load);
    /// texelFetch of an image at `binding` of the inputs set.
    Pass& sample(uint32_t binding, ImageId image);
    /// A compute pass writes the image at `binding` of the inputs set. It holds what it held before; the
    /// same image may be sampled too, at another binding.
    Pass& store(uint32_t binding, ImageId image);
    /// The same for an RGBA16F image as two unsigned integers a texel, for unpackHalf2x16: a software
    /// device fetches them in less than half of the time, for it converts half floats one by one.
    Pass& sample_bits(uint32_t binding, ImageId image);
    /// The stencil of an image, unsigned integers.
    Pass& sample_stencil(uint32_t binding, ImageId image);
    /// Storage buffer at `binding` of the inputs set.
    Pass& storage(uint32_t binding, BufferId buffer, bool writes);
    /// The buffer holds commands of indirect draws or dispatches.
    Pass& indirect(BufferId buffer);
    /// The buffer holds indices, bound as such.
    Pass& indices(BufferId buffer);
    /// The buffer holds what conditional rendering asks.
    Pass& condition(BufferId buffer);
    /// The pass copies into the buffer, or fills it.
    Pass& copy_to(BufferId buffer);
    /// A depth image that the pass draws into between its own draws (PassContext::between), and samples at `binding`.
    Pass& draws_between(uint32_t binding, ImageId image);
    /// What the shader finds as `raster` in set `inputs`: that of the images which it reads or writes by pixel. Without
    /// it, the attachments'; a pass that has none, and names none, has an empty one.
    Pass& raster(const gpu::Raster& raster);
    /// The pass stays even where nothing that the graph knows needs it.
    Pass& always();
    /// Makes what the pass draws with; called in any thread, beside other passes'.
    Pass& prepare(std::function<void(const PassInterface&)> callback);
    /// Commands that may not stand inside of rendering, recorded before it begins.
    Pass& before_rendering(std::function<void(const PassContext&)> callback);
    Pass& record(std::function<void(const PassContext&)> callback);
    const std::string& name() const { return name_; }

private:
    friend class FrameGraph;
    struct Attachment {
        ImageId image;
        Load load = Load::discard;
        std::array<float, 4> clear{};
    };
    struct ImageUse {
        ImageId image;
        Access access;
    };
    struct BufferUse {
        BufferId buffer;
        Access access;
    };
    struct BufferBarrier {
        BufferId buffer;
        VkBufferMemoryBarrier2 barrier; ///< without its buffer: each slot may have another
    };
    void use(ImageId image, const Access& access);
    /// The attachment whose raster is that of all.
    std::optional<ImageId> target() const {
        return !colours_.empty() ? std::optional(colours_[0].image)
               : depth_          ? std::optional(depth_->image)
                                 : std::nullopt;
    }

    std::string name_;
    std::vector<Attachment> colours_;
    std::optional<Attachment> depth_;
    std::optional<ImageId> between_;
    bool depth_writes_ = false;
    bool stencil_ = false;
    std::optional<Load> stencil_load_; ///< keeps_stencil()
    bool blends_ = false;
    bool always_ = false;
    std::vector<ImageUse> images_;
    std::vector<BufferUse> buffers_;
    std::vector<std::pair<uint32_t, ImageId>> sampled_, stored_;
    std::vector<uint32_t> bits_;     ///< bindings of `sampled_` that sample_bits() made
    std::vector<uint32_t> stencils_; ///< and sample_stencil()
    std::vector<std::pair<uint32_t, BufferId>> storages_;
    std::optional<gpu::Raster> raster_; ///< raster()
    std::function<void(const PassInterface&)> prepare_;
    std::function<void(const PassContext&)> before_rendering_, record_;

    // Set by FrameGraph::compile.
    bool alive_ = true;
    std::vector<VkImageMemoryBarrier2> image_barriers_;
    std::vector<BufferBarrier> buffer_barriers_;
    VkDescriptorSetLayout layout_ = VK_NULL_HANDLE;
    gpu::DescriptorSets sets_; ///< one a slot
};

/// What a pass moves by the formats of its images: each image it reads and each it writes counts
/// once with all its texels, however often the pass touches them. Buffers and textures of materials
/// are not in it.
struct PassTraffic {
    std::string name;
    uint64_t bytes_read = 0, bytes_written = 0;
};

/// An image of somebody else's, for one frame.
struct ExternalImage {
    VkImage image = VK_NULL_HANDLE;
    VkImageView view = VK_NULL_HANDLE;
    VkImageLayout before = VK_IMAGE_LAYOUT_UNDEFINED, after = VK_IMAGE_LAYOUT_UNDEFINED;
};

/// Passes in the order in which they were added, compiled once and recorded once a frame.
/// Images belong to the graph and share memory where their lifetimes do not meet.
class FrameGraph {
public:
    explicit FrameGraph(const gpu::Context& context) : context_(context) {}
    FrameGraph(const FrameGraph&) = delete;
    FrameGraph& operator=(const FrameGraph&) = delete;

    ImageId image(std::string name, const ImageDesc& desc);
    /// A colour or depth image in the first of `formats` that the device can draw into and sample;
    /// notes() names what was missing. Throws Error when it has none of them.
    ImageId image(std::string name, const gpu::Raster& raster, std::span<const VkFormat> formats);
    ImageId image(std::string name, const gpu::Raster& raster, std::initializer_list<VkFormat> formats) {
        return image(std::move(name), raster, std::span(formats.begin(), formats.size()));
    }
    /// A colour image that bind() brings for each frame, for one pass that draws all of it; one in a graph. In a frame
    /// without one that pass draws nothing.
    ImageId external_image(std::string name, const ImageDesc& desc);
    /// For the frame that is recorded next, and all until the next call.
    void bind(const std::optional<ExternalImage>& image) { bound_ = image; }
    /// What is not as asked for, one line each.
    const std::vector<std::string>& notes() const { return notes_; }
    /// Adds a line to notes(), once.
    void note(const std::string& line);
    /// A buffer of the caller's, alive as long as the graph; host writes before a frame are seen. The same buffer
    /// has the same id, whoever asks.
    BufferId buffer(std::string name, const gpu::Buffer& buffer);
    /// A buffer for each frame in flight, alive as long as the graph: for what the host writes before a
    /// frame, or reads after it, while the device may be busy with another frame.
    BufferId buffer(std::string name, const gpu::PerFrame<gpu::Buffer>& buffers);
    /// Puts another buffer of the caller's in the place of `id`, in barriers and descriptor sets: for
    /// buffers that grow. Earlier frames that are still in flight keep the old one: see retire().
    void rebind(BufferId id, const gpu::Buffer& buffer);
    /// Keeps a buffer alive until no frame in flight can use it any more.
    void retire(gpu::Buffer buffer);
    /// Called at the start of each recording, where rebind() and retire() are allowed.
    void before_frame(std::function<void()> callback) {
        before_frame_.push_back([callback = std::move(callback)](const gpu::FrameTurn&) { callback(); });
    }
    void before_frame(std::function<void(const gpu::FrameTurn&)> callback) {
        before_frame_.push_back(std::move(callback));
    }
    Pass& pass(std::string name);
    /// The image's content stays for read_back() after the frame.
    void keep(ImageId image);
    /// The image's content stays for the next frame, for passes that draw some of it anew. Before the first a colour
    /// image is 0, a depth image undefined. It shares memory with none.
    void persist(ImageId image);
    const ImageDesc& desc(ImageId image) const { return images_[image.index].desc; }
    gpu::Raster raster(ImageId image) const { return desc(image).raster; }
    const std::string& name(ImageId image) const { return images_[image.index].name; }
    /// Of a compiled graph: as shaders sample it, its depth alone where it has stencil too.
    VkImageView sampled_view(ImageId image) const;

    /// Removes passes that nothing needs, places the images, derives the barriers, makes descriptor
    /// sets and lets each pass make its pipelines. Throws Error.
    void compile();
    /// Records one frame, with a debug label and two timestamps for each pass. Without a turn the
    /// device must be done with the frame before.
    void record(VkCommandBuffer commands, const gpu::FrameTurn& turn = {}) { record(commands, turn, false); }
    /// One frame pass by pass, each in a command buffer of its own: record_begin(), then
    /// record_pass() with 0 … passes() − 1, submitted in this order. For timing each alone.
    void record_begin(const gpu::FrameTurn& turn = {});
    void record_pass(VkCommandBuffer commands, size_t index);
    /// Living passes.
    size_t passes() const { return passes_.size(); }
    /// Records a frame whose draws touch one pixel: every pipeline is compiled after it, for software
    /// devices compile at the first draw.
    void record_warm_up(VkCommandBuffer commands, const gpu::FrameTurn& turn = {}) { record(commands, turn, true); }
    /// Device time of each living pass in the slot's last frame, milliseconds; the frame must be done.
    std::vector<std::pair<std::string, double>> pass_times(uint32_t slot = 0) const;
    /// Bytes each living pass reads and writes in a frame, in the passes' order.
    std::vector<PassTraffic> traffic() const;
    /// Texels of a kept image, row by row, tightly packed. Submits and waits.
    std::vector<std::byte> read_back(ImageId image) const;
    /// The same in the memory that the device copied it into.
    gpu::Buffer read_back_buffer(ImageId image) const;
    /// A kept image of four bytes a texel as a frame leaves it, for whoever shows it; until the graph is gone.
    gpu::ShownImage shown(ImageId image) const;
    /// Memory that all images share, after aliasing.
    uint64_t memory_bytes() const { return memory_.size(); }
    /// What they would take if none shared memory with another: texels times bytes of a texel.
    uint64_t unshared_bytes() const;

private:
    struct GraphImage {
        std::string name;
        ImageDesc desc;
        bool kept = false;
        bool persistent = false;
        bool as_bits = false; ///< some pass reads it by sample_bits()
        VkImageUsageFlags usage = 0;
        uint32_t first = 0xffffffffu,
                 last = 0; ///< living passes; last is huge when kept, and so are both ends when it persists
        VkMemoryRequirements requirements{};
        uint64_t offset = 0;
        gpu::UniqueImage image;
        gpu::UniqueImageView view;            ///< as an attachment
        gpu::UniqueImageView depth_only_view; ///< for shaders, where the format has stencil too
        gpu::UniqueImageView stencil_only_view;
        gpu::UniqueImageView bits_view; ///< for sample_bits()
        Access final_access;
    };
    struct GraphBuffer {
        std::string name;
        gpu::PerFrame<VkBuffer> handles{};
    };
    struct Retired {
        uint64_t frame = 0; ///< the first that does without it
        gpu::Buffer buffer;
    };
    BufferId add_buffer(std::string name, const gpu::PerFrame<VkBuffer>& handles);
    void cull_passes();
    void find_lifetimes();
    void create_images();
    void place_images();
    void create_views();
    void begin_persistent_images() const;
    gpu::UniqueImageView create_view(const GraphImage& image, VkImageAspectFlags aspects, VkFormat format) const;
    VkImageView sampled_view(const Pass& pass, uint32_t binding, ImageId image) const;
    void derive_barriers();
    void derive_image_barriers(GraphImage& image, uint32_t index);
    bool draws_external(const Pass& pass) const { return external_ && pass.target() == external_; }
    /// The bound image's way between the caller's uses and the graph's.
    void turn_external(VkCommandBuffer commands, bool begins) const;
    void derive_buffer_barriers(uint32_t index);
    Access everything_that_shares_memory(const GraphImage& image) const;
    gpu::Raster raster_of(const Pass& pass) const;
    void write_rasters();
    void prepare_passes();
    std::vector<gpu::Binding> bindings(const Pass& pass, uint32_t slot) const;
    void bind_anew(BufferId id, uint32_t slot);
    uint32_t first_query(uint32_t slot) const { return static_cast<uint32_t>(slot * 2 * passes_.size()); }
    void record(VkCommandBuffer commands, const gpu::FrameTurn& turn, bool one_pixel);
    void record_pass(VkCommandBuffer commands, uint32_t index, bool one_pixel) const;
    void record_end(VkCommandBuffer commands) const;
    void barrier(VkCommandBuffer commands, const std::vector<VkImageMemoryBarrier2>& images,
                 const std::vector<Pass::BufferBarrier>& buffers) const;
    void begin_rendering(VkCommandBuffer commands, uint32_t pass_index, VkExtent2D extent, bool again = false) const;
    void draw_between(VkCommandBuffer commands, uint32_t pass_index, VkExtent2D drawn,
                      const std::function<void()>& draw) const;
    Access sampled_access(const Pass& pass, ImageId image) const;
    uint64_t texels_bytes(ImageId image) const;
    bool needed_after(ImageId image, uint32_t pass_index) const;

    const gpu::Context& context_;
    std::vector<std::string> notes_;
    std::vector<GraphImage> images_;
    std::vector<GraphBuffer> buffers_;
    std::vector<std::unique_ptr<Pass>> passes_;
    ImageId external_;
    std::optional<ExternalImage> bound_;
    std::vector<Pass::BufferBarrier> host_barriers_; ///< at the frame's end
    std::vector<std::function<void(const gpu::FrameTurn&)>> before_frame_;
    gpu::FrameTurn turn_;                        ///< of the frame that is recorded
    uint64_t frame_ = 0;                         ///< its number, from 1
    gpu::PerFrame<std::vector<BufferId>> stale_; ///< rebound, and not yet in the slot's sets
    std::vector<Retired> retired_;
    gpu::Allocation memory_;
    gpu::Buffer rasters_;        ///< RasterConstants of the living passes
    uint64_t raster_stride_ = 0; ///< bytes
    gpu::UniqueQueryPool queries_;
};

} // namespace prelight::graph
