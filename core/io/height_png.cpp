// PNG through libpng: any kind in, to the last bit; 16 bits grey out.
#include <algorithm>
#include <cmath>
#include <png.h>

#include "core/io/height_picture_data.h"

namespace mw {

namespace {

// Deflate makes at most 1032 bytes of one.
constexpr uint64_t largestExpansion = 1100;

/// libpng calls this and must not get control back; what it allocated is freed by the destructors below.
[[noreturn]] void fail(png_structp png, png_const_charp message)
{
    throw Error(*static_cast<const std::string*>(png_get_error_ptr(png)),
                std::string("the PNG is damaged (") + message + "); get it again or save it again");
}
void ignore(png_structp, png_const_charp) {}

struct Source {
    const char *at, *end;
};

void read(png_structp png, png_bytep to, size_t n)
{
    auto& s = *static_cast<Source*>(png_get_io_ptr(png));
    if (size_t(s.end - s.at) < n) png_error(png, "cut short");
    std::copy_n(s.at, n, reinterpret_cast<char*>(to));
    s.at += n;
}

struct Reader {
    std::string file;
    Source source;
    png_structp png = nullptr;
    png_infop info = nullptr;

    Reader(const FileBytes& bytes, const std::string& name) : file(name), source{bytes.begin(), bytes.end()}
    {
        png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &file, fail, ignore);
        if (png) info = png_create_info_struct(png);
        if (!info) throw Error(file, "there is not enough memory to read it");
        png_set_user_limits(png, HeightMap::largestSize, HeightMap::largestSize);
        png_set_chunk_malloc_max(png, 8u << 20);
        png_set_read_fn(png, &source, read);
    }
    ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;
};

/// Rows of samples of one kind, as they come from libpng.
struct Rows {
    uint32_t width = 0;
    int channels = 0;
    bool wide = false;  // 16 bits
    bool colours = false;

    size_t bytes() const { return size_t(width) * size_t(channels) * (wide ? 2 : 1); }
    void heights(const uint8_t* row, float* out)
    {
        const auto part = [&](size_t i) { return wide ? (row[2 * i] << 8 | row[2 * i + 1]) / 65535.0 : row[i] / 255.0; };
        for (size_t x = 0; x < width; ++x) {
            if (channels == 1) {
                out[x] = float(part(x));
                continue;
            }
            const double r = part(3 * x), g = part(3 * x + 1), b = part(3 * x + 2);
            colours = colours || r != g || g != b;
            out[x] = luma(r, g, b);
        }
    }
};

/// Palettes become colours, few bits 8, alpha goes.
Rows prepare(Reader& r, int bits, int type)
{
    if (type == PNG_COLOR_TYPE_PALETTE) png_set_palette_to_rgb(r.png);
    if (type == PNG_COLOR_TYPE_GRAY && bits < 8) png_set_expand_gray_1_2_4_to_8(r.png);
    if (type & PNG_COLOR_MASK_ALPHA || png_get_valid(r.png, r.info, PNG_INFO_tRNS)) png_set_strip_alpha(r.png);
    Rows rows;
    rows.width = png_get_image_width(r.png, r.info);
    rows.wide = bits == 16;
    rows.channels = type == PNG_COLOR_TYPE_GRAY || type == PNG_COLOR_TYPE_GRAY_ALPHA ? 1 : 3;
    return rows;
}

void decode(Reader& r, Rows rows, int passes, HeightPicture& out, Progress* progress)
{
    const size_t kept = passes == 1 ? 1 : out.height;  // of an interlaced picture rows come several times
    Array<uint8_t> buffer(rows.bytes() * kept, 0);
    for (int pass = 0; pass < passes; ++pass)
        for (uint32_t y = 0; y < out.height; ++y) {
            if (progress && y % 64 == 0) progress->at((float(pass) + float(y) / float(out.height)) / float(passes));
            uint8_t* row = buffer.data() + (passes == 1 ? 0 : y * rows.bytes());
            png_read_row(r.png, row, nullptr);
            if (pass + 1 == passes) rows.heights(row, out.heights.data() + size_t(y) * out.width);
        }
    if (rows.colours) out.warnings.push_back(colourWarning());
}

struct Writer {
    std::string file;
    png_structp png = nullptr;
    png_infop info = nullptr;

    Writer(OutputFile& out, const std::string& name) : file(name)
    {
        png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &file, fail, ignore);
        if (png) info = png_create_info_struct(png);
        if (!info) throw Error(file, "there is not enough memory to write it");
        png_set_write_fn(
            png, &out, [](png_structp p, png_bytep bytes, size_t n) { static_cast<OutputFile*>(png_get_io_ptr(p))->write(bytes, n); }, nullptr);
    }
    ~Writer() { png_destroy_write_struct(&png, &info); }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;
};

}  // namespace

HeightPicture readPng(const FileBytes& bytes, const std::string& file, Progress* progress)
{
    Reader r(bytes, file);
    png_read_info(r.png, r.info);
    HeightPicture out;
    int bits = 0, type = 0;
    png_get_IHDR(r.png, r.info, &out.width, &out.height, &bits, &type, nullptr, nullptr, nullptr);
    checkPictureSize(out.width, out.height, file);
    const uint64_t told = uint64_t(png_get_rowbytes(r.png, r.info)) * out.height;
    if (told > largestExpansion * bytes.size())
        throw Error(file, "announces " + std::to_string(out.width) + " x " + std::to_string(out.height) + " pixels, far more than its " +
                              std::to_string(bytes.size()) + " bytes can hold; get it again");
    const Rows rows = prepare(r, bits, type);
    const int passes = png_set_interlace_handling(r.png);
    png_read_update_info(r.png, r.info);
    if (png_get_rowbytes(r.png, r.info) != rows.bytes()) throw Error(file, "is a kind of PNG that is not known; save it as 8 or 16 bits grey");
    out.heights.resize(size_t(out.width) * out.height);
    decode(r, rows, passes, out, progress);
    out.format = "PNG, " + std::to_string(bits) + (bits == 1 ? " bit" : " bits");
    return out;
}

void writePng(const HeightMap& map, OutputFile& out, const std::string& file, Progress* progress)
{
    Writer w(out, file);
    png_set_IHDR(w.png, w.info, map.width(), map.height(), 16, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_set_compression_level(w.png, 3);  // a fifth of the time of 6, a few per cent more bytes
    png_set_filter(w.png, PNG_FILTER_TYPE_DEFAULT, PNG_FILTER_SUB | PNG_FILTER_UP);
    png_write_info(w.png, w.info);
    Array<uint8_t> row(size_t(map.width()) * 2);
    for (uint32_t y = 0; y < map.height(); ++y) {
        if (progress && y % 64 == 0) progress->at(float(y) / float(map.height()));
        for (uint32_t x = 0; x < map.width(); ++x) {
            const auto v = uint32_t(std::lround(double(map.at(x, y)) * 65535));
            row[2 * x] = uint8_t(v >> 8);
            row[2 * x + 1] = uint8_t(v);
        }
        png_write_row(w.png, row.data());
    }
    png_write_end(w.png, w.info);
}

}  // namespace mw
