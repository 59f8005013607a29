#include <scene/images/codecs.hpp>

namespace prelight::images {

Cost inspect_png(std::span<const uint8_t> bytes) {
    const PngReader reader(bytes);
    const uint64_t whole = reader.interlaced() ? uint64_t(reader.width()) * reader.height() * 4 : 0;
    return {reader.width(), reader.height(), reader.working_bytes(), whole};
}

TextureImage decode_png(std::span<const uint8_t> bytes, uint32_t halvings, Texels kind, std::vector<uint8_t> room) {
    PngReader reader(bytes);
    if (reader.interlaced()) {
        TextureImage whole{{}, reader.width(), reader.height(), std::move(room)};
        whole.rgba.resize(size_t(whole.width) * whole.height * 4);
        reader.read_all(whole.rgba.data());
        return halvings == 0 ? whole : scaled_down(whole, halvings, kind);
    }
    ScaledPicture picture(reader.width(), reader.height(), halvings, kind, std::move(room));
    for (uint32_t y = 0; y < reader.height(); ++y) {
        reader.read_row(picture.row());
        picture.row_done();
    }
    return picture.take();
}

} // namespace prelight::images
