#include "canvoy/tools/cli/png_file.hpp"

#include <png.h>

#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/value_file.hpp"

namespace canvoy::tools {

void write_png(const std::string& path, const Picture& picture) {
  if (picture.width() == 0 || picture.height() == 0) {
    throw Failure(path + ": the picture is empty; print something first");
  }
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(picture.width());
  image.height = static_cast<png_uint_32>(picture.height());
  image.format = PNG_FORMAT_RGB;
  // Room for an incompressible picture.
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::vector<std::uint8_t> bytes(size);
  const void* const dots = picture.bytes().data();
  if (png_image_write_to_memory(&image, bytes.data(), &size, 0, dots, 0, nullptr) == 0) {
    throw Failure(path + ": " + image.message);
  }
  bytes.resize(size);
  write_value_file(path, bytes);
}

}  // namespace canvoy::tools
