// Decoding by libpng and libjpeg, bounded in pixels.
#include "render/image.h"

#include <algorithm>
#include <cstdio>
#include <png.h>

#ifdef MESHWRIGHT_JPEG
#include <csetjmp>
#include <jpeglib.h>
#endif

#include "core/error.h"

namespace mw {
namespace {

constexpr size_t maxPixels = size_t(64) << 20;

void checkSize(size_t width, size_t height)
{
    if (width == 0 || height == 0 || width > 65535 || height > 65535 || width * height > maxPixels)
        throw Error("a picture has " + std::to_string(width) + " x " + std::to_string(height) + " pixels; at most 64 million are shown");
}

DecodedImage decodePng(std::span<const uint8_t> bytes)
{
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_memory(&png, bytes.data(), bytes.size())) throw Error(std::string("a PNG picture is broken: ") + png.message);
    try {
        checkSize(png.width, png.height);
    } catch (...) {
        png_image_free(&png);
        throw;
    }
    png.format = PNG_FORMAT_RGBA;
    DecodedImage out{int(png.width), int(png.height), std::vector<uint8_t>(PNG_IMAGE_SIZE(png))};
    if (!png_image_finish_read(&png, nullptr, out.rgba.data(), 0, nullptr)) throw Error(std::string("a PNG picture is broken: ") + png.message);
    return out;
}

#ifdef MESHWRIGHT_JPEG
struct JpegErrors {
    jpeg_error_mgr base;
    std::jmp_buf back;
    char text[JMSG_LENGTH_MAX];
};

/// libjpeg leaves by longjmp, so nothing in here owns memory. False: broken, see errors.text.
bool readJpeg(jpeg_decompress_struct& jpeg, JpegErrors& errors, std::span<const uint8_t> bytes, DecodedImage& out, std::vector<uint8_t>& row)
{
    if (setjmp(errors.back)) return false;
    jpeg_mem_src(&jpeg, bytes.data(), static_cast<unsigned long>(bytes.size()));
    jpeg_read_header(&jpeg, TRUE);
    checkSize(jpeg.image_width, jpeg.image_height);
    jpeg.out_color_space = JCS_RGB;
    jpeg_start_decompress(&jpeg);
    out.width = int(jpeg.output_width);
    out.height = int(jpeg.output_height);
    out.rgba.resize(size_t(out.width) * size_t(out.height) * 4);
    row.resize(size_t(out.width) * 3);
    while (jpeg.output_scanline < jpeg.output_height) {
        uint8_t* to = out.rgba.data() + size_t(jpeg.output_scanline) * size_t(out.width) * 4;
        JSAMPROW rows[1] = {row.data()};
        jpeg_read_scanlines(&jpeg, rows, 1);
        for (size_t x = 0; x < size_t(out.width); ++x, to += 4) {
            for (size_t k = 0; k < 3; ++k) to[k] = row[3 * x + k];
            to[3] = 255;
        }
    }
    jpeg_finish_decompress(&jpeg);
    return true;
}

DecodedImage decodeJpeg(std::span<const uint8_t> bytes)
{
    jpeg_decompress_struct jpeg{};
    JpegErrors errors{};
    jpeg.err = jpeg_std_error(&errors.base);
    errors.base.error_exit = [](j_common_ptr info) {
        auto* e = reinterpret_cast<JpegErrors*>(info->err);
        e->base.format_message(info, e->text);
        std::longjmp(e->back, 1);
    };
    errors.base.output_message = [](j_common_ptr) {};
    struct Guard {
        jpeg_decompress_struct& jpeg;
        ~Guard() { jpeg_destroy_decompress(&jpeg); }
    } guard{jpeg};
    jpeg_create_decompress(&jpeg);
    DecodedImage out;
    std::vector<uint8_t> row;
    if (!readJpeg(jpeg, errors, bytes, out, row)) throw Error(std::string("a JPEG picture is broken: ") + errors.text);
    return out;
}
#endif

const DecodedImage white{1, 1, {255, 255, 255, 255}};
const DecodedImage flat{1, 1, {128, 128, 255, 255}};  // for numbers: a normal map without bumps, half as rough

DecodedImage decodedOr(const std::vector<uint8_t>& bytes, const DecodedImage& otherwise)
{
    GLint most = 4096;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    try {
        DecodedImage image = decodeImage(bytes);
        if (image.width <= most && image.height <= most) return image;
    } catch (const Error&) {
        // Reading the file has warned about it; here the model is drawn without.
    }
    return otherwise;
}

}  // namespace

DecodedImage decodeImage(std::span<const uint8_t> bytes)
{
    constexpr uint8_t pngMagic[] = {0x89, 'P', 'N', 'G'};
    if (bytes.size() > 8 && std::equal(std::begin(pngMagic), std::end(pngMagic), bytes.begin())) return decodePng(bytes);
#ifdef MESHWRIGHT_JPEG
    if (bytes.size() > 8 && bytes[0] == 0xFF && bytes[1] == 0xD8) return decodeJpeg(bytes);
#endif
    throw Error("a picture is neither PNG nor JPEG; convert it");
}

size_t fillTexture(const DecodedImage& image, PictureSampling sampling)
{
    glTexImage2D(GL_TEXTURE_2D, 0, sampling.color ? GL_SRGB8_ALPHA8 : GL_RGBA8, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 image.rgba.data());
    glGenerateMipmap(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, sampling.repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, sampling.repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE);
    if (epoxy_has_gl_extension("GL_EXT_texture_filter_anisotropic")) {  // else what is seen at a slant is blurred both ways
        GLfloat most = 1;
        glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, &most);
        glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, std::min(most, 4.f));
    }
    return image.rgba.size() * 4 / 3;
}

GLuint imageTexture(GpuCache& cache, const std::shared_ptr<const std::vector<uint8_t>>& encoded, PictureSampling sampling)
{
    const uint64_t use = 1 + (sampling.repeat ? 1u : 0u) + (sampling.color ? 2u : 0u);
    return cache.picture({{encoded.get()}, use}, {encoded},
                         [&] { return fillTexture(decodedOr(*encoded, sampling.color ? white : flat), sampling); });
}

}  // namespace mw
