#include "program/render/image.h"

#include <png.h>

#include <ostream>
#include <stdexcept>

#include "core/replace_file.h"

namespace clearway::render {

namespace {

std::vector<char> encoded(const Image& image) {
    const std::vector<std::uint8_t> bytes = bytesOf(image);
    png_image header{};
    header.version = PNG_IMAGE_VERSION;
    header.width = static_cast<png_uint_32>(image.width);
    header.height = static_cast<png_uint_32>(image.height);
    header.format = PNG_FORMAT_RGB;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
    std::vector<char> png(size);
    if (!png_image_write_to_memory(&header, png.data(), &size, 0, bytes.data(), 0, nullptr)) {
        throw std::runtime_error(std::string("libpng cannot write the picture: ") + header.message);
    }
    png.resize(size);
    return png;
}

}  // namespace

std::vector<std::uint8_t> bytesOf(const Image& image) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(3 * image.pixels.size());
    for (const Colour& pixel : image.pixels) {
        const auto rgb = toSRgb(pixel);
        bytes.insert(bytes.end(), rgb.begin(), rgb.end());
    }
    return bytes;
}

void writePng(const Image& image, const std::string& file) {
    const std::vector<char> png = encoded(image);
    replaceFile(file, [&](std::ostream& stream) {
        stream.write(png.data(), static_cast<std::streamsize>(png.size()));
    });
}

}  // namespace clearway::render
