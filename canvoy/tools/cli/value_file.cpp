#include "canvoy/tools/cli/value_file.hpp"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <system_error>

#include "canvoy/can/host/atomic_file.hpp"
#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools {

namespace {

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

[[noreturn]] void fail(const std::string& path, int error) {
  throw Failure(fmt::format("{}: {}; check the path", path, std::strerror(error)));
}

File open(const std::string& path, const char* mode) {
  File file(std::fopen(path.c_str(), mode));
  if (file == nullptr) fail(path, errno);
  return file;
}

}  // namespace

std::vector<std::uint8_t> read_value_file(const std::string& path) {
  // A file that cannot be examined cannot be opened either, with a better error.
  std::error_code unseen;
  if (std::filesystem::is_directory(path, unseen)) fail(path, EISDIR);
  const File file = open(path, "rb");
  std::vector<std::uint8_t> bytes;
  std::array<std::uint8_t, 65'536> piece;
  while (const std::size_t size = std::fread(piece.data(), 1, piece.size(), file.get())) {
    bytes.insert(bytes.end(), piece.begin(), piece.begin() + static_cast<std::ptrdiff_t>(size));
    if (bytes.size() > value_max) {
      throw Failure(
          fmt::format("{}: longer than {} bytes; is it the right file?", path, value_max));
    }
  }
  if (std::ferror(file.get()) != 0) fail(path, errno);
  return bytes;
}

void write_value_file(const std::string& path, std::span<const std::uint8_t> bytes) {
  host::AtomicFile draft = value_or_throw(host::AtomicFile::begin(path));
  ok_or_throw(draft.write(bytes));
  ok_or_throw(draft.finish());
}

}  // namespace canvoy::tools
