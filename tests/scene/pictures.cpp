#include "pictures.hpp"
#include <cstdio>
#include <cstdlib>
#include <jpeglib.h>
#include <zlib.h>

namespace prelight::test {
namespace {

void append(Bytes& out, uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8)
        out.push_back(uint8_t(value >> shift));
}

} // namespace

Bytes png_chunk(const std::string& type, const Bytes& content, bool truthful) {
    Bytes out;
    append(out, uint32_t(content.size()));
    out.insert(out.end(), type.begin(), type.end());
    out.insert(out.end(), content.begin(), content.end());
    append(out, uint32_t(crc32(0, out.data() + 4, uInt(out.size() - 4))) ^ (truthful ? 0u : 1u));
    return out;
}

Bytes RawPng::bytes() const {
    Bytes out{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    const auto add = [&out](const Bytes& chunk) { out.insert(out.end(), chunk.begin(), chunk.end()); };
    Bytes header;
    append(header, width);
    append(header, height);
    header.insert(header.end(), {bits, colour, 0, 0, uint8_t(interlaced)});
    add(png_chunk("IHDR", header));
    for (const auto& [type, content] : chunks)
        add(png_chunk(type, content, truthful));
    uLongf size = compressBound(uLong(lines.size()));
    Bytes packed(size);
    compress2(packed.data(), &size, lines.data(), uLong(lines.size()), 6);
    packed.resize(size);
    add(png_chunk("IDAT", packed));
    add(png_chunk("IEND", {}));
    return out;
}

Bytes unfiltered(const std::vector<Bytes>& rows) {
    Bytes out;
    for (const Bytes& row : rows) {
        out.push_back(0);
        out.insert(out.end(), row.begin(), row.end());
    }
    return out;
}

Bytes jpeg_of(uint32_t width, uint32_t height, const Bytes& samples, const JpegForm& form) {
    using Stored = JpegForm::Stored;
    jpeg_compress_struct jpeg{};
    jpeg_error_mgr errors{};
    jpeg.err = jpeg_std_error(&errors);
    jpeg_create_compress(&jpeg);
    unsigned char* out = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&jpeg, &out, &size);
    const bool inks = form.stored == Stored::cmyk || form.stored == Stored::ycck;
    jpeg.image_width = width;
    jpeg.image_height = height;
    jpeg.input_components = form.stored == Stored::grey ? 1 : inks ? 4 : 3;
    jpeg.in_color_space = form.stored == Stored::grey ? JCS_GRAYSCALE : inks ? JCS_CMYK : JCS_RGB;
    jpeg_set_defaults(&jpeg);
    jpeg_set_colorspace(&jpeg, form.stored == Stored::grey   ? JCS_GRAYSCALE
                               : form.stored == Stored::ycc  ? JCS_YCbCr
                               : form.stored == Stored::rgb  ? JCS_RGB
                               : form.stored == Stored::cmyk ? JCS_CMYK
                                                             : JCS_YCCK);
    jpeg_set_quality(&jpeg, form.quality, TRUE);
    for (int i = 0; i < jpeg.num_components; ++i)
        jpeg.comp_info[i].h_samp_factor = jpeg.comp_info[i].v_samp_factor = 1;
    jpeg.write_Adobe_marker = form.adobe_marker;
    jpeg.write_JFIF_header = form.jfif_marker && !inks;
    jpeg.arith_code = form.arithmetic;
    if (form.progressive)
        jpeg_simple_progression(&jpeg);
    jpeg_start_compress(&jpeg, TRUE);
    if (!form.exif.empty())
        jpeg_write_marker(&jpeg, JPEG_APP0 + 1, form.exif.data(), unsigned(form.exif.size()));
    Bytes row(size_t(width) * size_t(jpeg.input_components));
    for (uint32_t y = 0; y < height; ++y) {
        std::memcpy(row.data(), &samples[y * row.size()], row.size());
        JSAMPROW rows = row.data();
        jpeg_write_scanlines(&jpeg, &rows, 1);
    }
    jpeg_finish_compress(&jpeg);
    jpeg_destroy_compress(&jpeg);
    Bytes bytes(out, out + size);
    std::free(out);
    return bytes;
}

} // namespace prelight::test
