#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstdio> // before jpeglib.h, which wants FILE
#include <fmt/format.h>
#include <jerror.h>
#include <jpeglib.h>
#include <scene/images/codecs.hpp>
#include <string>

namespace prelight::images {
namespace {

/// A progressive JPEG walks the whole picture once a scan, and a scan may be a few bytes long.
constexpr int max_scans = 100;
constexpr uint64_t working_constant = uint64_t(1) << 20; ///< tables, and rows beside those that depend on the width
constexpr uint64_t working_row = 256;                    ///< bytes a pixel of width: a few rows of blocks

DecodeError damaged(const std::string& reason) {
    return DecodeError(fmt::format("does not decode (JPEG: {})", reason));
}

/// Warnings of libjpeg after which the picture is still whole; after all others it has filled something in.
bool harmless(int code) {
    return code == JWRN_EXTRANEOUS_DATA || code == JWRN_ADOBE_XFORM || code == JWRN_JFIF_MAJOR ||
           code == JWRN_BOGUS_ICC || code == JWRN_TOO_MUCH_DATA || code == JWRN_BOGUS_PROGRESSION;
}

class JpegReader {
public:
    /// Reads the header. `bytes` outlive it.
    explicit JpegReader(std::span<const uint8_t> bytes) {
        jpeg_.err = jpeg_std_error(&errors_.manager);
        errors_.manager.error_exit = fail;
        errors_.manager.emit_message = warn;
        errors_.manager.output_message = [](j_common_ptr) {};
        jpeg_.client_data = this;
        progress_.progress_monitor = watch;
        try {
            guarded([&] {
                jpeg_create_decompress(&jpeg_);
                jpeg_.progress = &progress_;
                jpeg_mem_src(&jpeg_, bytes.data(), static_cast<unsigned long>(bytes.size()));
                jpeg_read_header(&jpeg_, TRUE);
            });
            check_header(bytes.size());
        } catch (...) {
            jpeg_destroy_decompress(&jpeg_);
            throw;
        }
    }
    ~JpegReader() { jpeg_destroy_decompress(&jpeg_); }
    JpegReader(const JpegReader&) = delete;
    JpegReader& operator=(const JpegReader&) = delete;

    uint32_t width() const { return jpeg_.image_width; }
    uint32_t height() const { return jpeg_.image_height; }

    /// Of a picture in several scans all coefficients are kept, two bytes each.
    uint64_t working_bytes() {
        uint64_t coefficients = 0;
        if (jpeg_has_multiple_scans(&jpeg_))
            for (int i = 0; i < jpeg_.num_components; ++i) {
                const auto& component = jpeg_.comp_info[i];
                const auto padded = [](uint64_t blocks, int factor) { return blocks + uint64_t(factor); };
                coefficients += padded(component.width_in_blocks, component.h_samp_factor) *
                                padded(component.height_in_blocks, component.v_samp_factor) * DCTSIZE2 * sizeof(JCOEF);
            }
        return coefficients + working_constant + working_row * width();
    }

    void start() {
        jpeg_.mem->max_memory_to_use = static_cast<long>(working_bytes());
        // Four components are inks; libjpeg turns YCCK into CMYK and no further.
        jpeg_.out_color_space = jpeg_.num_components == 4 ? JCS_CMYK : JCS_EXT_RGBA;
        guarded([&] { jpeg_start_decompress(&jpeg_); });
        if (jpeg_.output_components != 4)
            throw damaged("its colours are not read");
    }

    void read_row(uint8_t* rgba) {
        guarded([&] {
            JSAMPROW row = rgba;
            jpeg_read_scanlines(&jpeg_, &row, 1);
        });
        if (jpeg_.num_components == 4)
            inks_to_rgba(rgba);
    }

    /// What is wrong may show at the end only.
    void finish() {
        guarded([&] { jpeg_finish_decompress(&jpeg_); });
    }

private:
    struct Errors {
        jpeg_error_mgr manager; ///< first: libjpeg knows this part alone
        std::jmp_buf jump;
    };

    static JpegReader& of(j_common_ptr jpeg) { return *static_cast<JpegReader*>(jpeg->client_data); }

    /// libjpeg reports by leaving: nothing in between may have a destructor.
    [[noreturn]] static void fail(j_common_ptr jpeg) {
        (*jpeg->err->format_message)(jpeg, of(jpeg).reason_.data());
        std::longjmp(of(jpeg).errors_.jump, 1);
    }
    static void warn(j_common_ptr jpeg, int level) {
        if (level < 0 && !harmless(jpeg->err->msg_code))
            fail(jpeg);
    }
    static void watch(j_common_ptr jpeg) {
        if (reinterpret_cast<j_decompress_ptr>(jpeg)->input_scan_number <= max_scans)
            return;
        std::snprintf(of(jpeg).reason_.data(), of(jpeg).reason_.size(), "it has more than %d scans", max_scans);
        std::longjmp(of(jpeg).errors_.jump, 1);
    }

    template <class Call>
    void guarded(const Call& call) {
        if (setjmp(errors_.jump) != 0)
            throw damaged(reason_.data());
        call();
    }

    bool named_cmyk() const {
        constexpr std::array names{'C', 'M', 'Y', 'K'};
        for (size_t i = 0; i < names.size(); ++i)
            if (jpeg_.comp_info[i].component_id != names[i])
                return false;
        return true;
    }

    void check_header(size_t size) const {
        check_picture_size(width(), height());
        if (jpeg_.num_components != 1 && jpeg_.num_components != 3 && jpeg_.num_components != 4)
            throw damaged(fmt::format("{} components are neither grey, RGB nor CMYK", jpeg_.num_components));
        // libjpeg takes inks without a mark for CMYK, whatever they are. Their names tell.
        if (jpeg_.num_components == 4 && !jpeg_.saw_Adobe_marker && !named_cmyk())
            throw damaged("it does not say whether its four components are CMYK or YCCK");
        // A Huffman code has a bit at least, and each 8 × 8 block one. So a header that lies takes no memory.
        if (!jpeg_.arith_code && uint64_t(width()) * height() > uint64_t(size) * 8 * DCTSIZE2)
            throw damaged("its data are too short for its size");
    }

    /// Inks over white paper, without a colour profile. Adobe's programs write them inverted, and mark it.
    void inks_to_rgba(uint8_t* row) const {
        const bool inverted = jpeg_.saw_Adobe_marker;
        for (uint8_t *p = row, *end = row + size_t(width()) * 4; p != end; p += 4) {
            const auto paper = [&](int c) {
                return uint32_t(inverted ? p[c] : 255 - p[c]);
            }; // what an ink lets through
            const uint32_t black = paper(3);
            for (int c = 0; c < 3; ++c)
                p[c] = static_cast<uint8_t>((paper(c) * black + 127) / 255);
            p[3] = 255;
        }
    }

    jpeg_decompress_struct jpeg_{};
    Errors errors_{};
    jpeg_progress_mgr progress_{};
    std::array<char, JMSG_LENGTH_MAX> reason_{};
};

} // namespace

Cost inspect_jpeg(std::span<const uint8_t> bytes) {
    JpegReader reader(bytes);
    return {reader.width(), reader.height(), reader.working_bytes()};
}

TextureImage decode_jpeg(std::span<const uint8_t> bytes, uint32_t halvings, Texels kind, std::vector<uint8_t> room) {
    JpegReader reader(bytes);
    reader.start();
    ScaledPicture picture(reader.width(), reader.height(), halvings, kind, std::move(room));
    for (uint32_t y = 0; y < reader.height(); ++y) {
        reader.read_row(picture.row());
        picture.row_done();
    }
    reader.finish();
    return picture.take();
}

} // namespace prelight::images
