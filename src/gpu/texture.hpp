#pragma once
#include "uploader.hpp"
#include <prelight/image.hpp>
#include <prelight/scene.hpp>
#include <span>

namespace prelight::gpu {

enum class TextureEncoding {
    srgb8, ///< colours
    linear8,
    half, ///< linear values as half floats: lavapipe filters 8-bit linear textures in 8-bit fixed
          ///< point, too coarse for normals that are compared with the reference
};

/// A sampled RGBA picture with its full chain of mip maps.
class Texture {
public:
    /// Uploads `image` and makes its mip maps by averaging (in linear light when sRGB); all of it is
    /// there when `uploader` has finished. Throws Error naming the image when it exceeds the device's
    /// limit.
    Texture(const Context& context, MemoryPool& pool, Uploader& uploader, const TextureImage& image,
            TextureEncoding encoding);
    /// Level by level as given, `image` and the `smaller` ones: each half as wide and high as the one before, at
    /// least 1.
    Texture(const Context& context, MemoryPool& pool, Uploader& uploader, const TextureImage& image,
            std::span<const TextureImage> smaller, TextureEncoding encoding);
    /// Half floats, level by level as given: each half as wide and high as the one before, at least 1.
    Texture(const Context& context, MemoryPool& pool, Uploader& uploader, const std::string& name,
            const std::vector<Image>& levels);
    VkImage image() const { return image_; }
    VkImageView view() const { return view_; }

private:
    /// Records the copy of one whole level; the device finds it where transfers read.
    void copy_level(const Uploader& uploader, const Uploader::Staging& staging, uint32_t level, VkExtent2D size) const;
    void make(const Context& context, MemoryPool& pool, const std::string& name, VkFormat format, uint32_t width,
              uint32_t height, uint32_t levels);
    /// For fragment and compute shaders.
    void finish(VkCommandBuffer commands, VkImageLayout from, uint32_t levels) const;
    void fill(Uploader& uploader, const TextureImage& image, TextureEncoding encoding, uint32_t levels) const;
    UniqueImage image_;
    UniqueImageView view_;
};

/// How textures are filtered.
enum class TextureFilter {
    trilinear,   ///< as the scene's sampler says
    anisotropic, ///< likewise, with anisotropy where the sampler is linear throughout and the device has it
    bilinear,    ///< bilinear on level 0, whatever the sampler says: for comparing with the reference
};
/// For shadow maps: 1 where the value compared is at least what is stored, bilinear between texels where the device
/// filters the format so.
UniqueSampler make_compare_sampler(const Context& context, VkFormat format);
UniqueSampler make_sampler(const Context& context, const Sampler& sampler, TextureFilter filter);

} // namespace prelight::gpu
