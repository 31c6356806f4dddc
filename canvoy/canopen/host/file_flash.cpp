#include "canvoy/canopen/host/file_flash.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

namespace canvoy::host {

namespace {

using Head = std::array<char, FileFlash::head_size>;

/// A line of text, so that the file explains itself.
Head head_of(const FileFlash::Geometry& geometry) {
  Head head{};
  head.fill(' ');
  const int length = std::snprintf(head.data(), head.size(), "canvoy flash 1: %u x %u bytes",
                                   geometry.sectors, geometry.sector_size);
  head[static_cast<std::size_t>(length)] = ' ';
  head.back() = '\n';
  return head;
}

Error failed(const std::string& path, int error, const std::string& remedy = "") {
  return {path, std::strerror(error), remedy};
}

bool write_all(int file, const void* data, std::size_t size, off_t at) {
  const auto* bytes = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t written = ::pwrite(file, bytes, size, at);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes += written;
    at += written;
    size -= static_cast<std::size_t>(written);
  }
  return true;
}

std::string folder_of(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  if (slash == std::string::npos) return ".";
  return slash == 0 ? "/" : path.substr(0, slash);
}

/// Makes the new name in the folder survive a loss of power, too.
void sync_folder(const std::string& path) {
  const Descriptor folder(::open(folder_of(path).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder) ::fsync(folder.get());
}

bool fill(int file, const FileFlash::Geometry& geometry) {
  const Head head = head_of(geometry);
  const std::vector<unsigned char> erased(std::size_t{geometry.sectors} * geometry.sector_size,
                                          0xFF);
  return write_all(file, head.data(), head.size(), 0) &&
         write_all(file, erased.data(), erased.size(), head.size()) && ::fsync(file) == 0;
}

/// Writes to another name first: the file is complete or absent.
Result<void> create(const std::string& path, const FileFlash::Geometry& geometry) {
  std::string draft = path + ".XXXXXX";
  const Descriptor file(::mkostemp(draft.data(), O_CLOEXEC));
  if (!file) return failed(path, errno, "give a file in a folder that is there and can be written");
  const bool done = fill(file.get(), geometry) && ::fchmod(file.get(), 0644) == 0 &&
                    ::link(draft.c_str(), path.c_str()) == 0;
  const int error = errno;
  ::unlink(draft.c_str());
  // Another process may have made it at the same time.
  if (!done && error != EEXIST) return failed(path, error, "is there room on the disk?");
  sync_folder(path);
  return {};
}

Result<void> check(const Descriptor& file, const std::string& path,
                   const FileFlash::Geometry& geometry) {
  struct stat status {};
  if (::fstat(file.get(), &status) != 0) return failed(path, errno);
  Head head{};
  const bool is_ours =
      S_ISREG(status.st_mode) &&
      ::pread(file.get(), head.data(), head.size(), 0) == static_cast<ssize_t>(head.size()) &&
      head == head_of(geometry);
  if (is_ours) return {};
  return Error{path, "it is no store of this kind of device, and is left as it is",
               "give the name of a new file"};
}

}  // namespace

Result<std::unique_ptr<FileFlash>> FileFlash::open(const std::string& path,
                                                   const Geometry& geometry) {
  Descriptor file(::open(path.c_str(), O_RDWR | O_CLOEXEC));
  if (!file && errno == ENOENT) {
    const Result<void> created = create(path, geometry);
    if (!created) return created.error();
    file = Descriptor(::open(path.c_str(), O_RDWR | O_CLOEXEC));
  }
  if (!file) return failed(path, errno, "give a file that can be read and written");
  const Result<void> checked = check(file, path, geometry);
  if (!checked) return checked.error();
  if (::flock(file.get(), LOCK_EX | LOCK_NB) != 0) {
    return Error{path, "another device has it open", "give each device a file of its own"};
  }
  return std::unique_ptr<FileFlash>(new FileFlash(std::move(file), geometry));
}

FileFlash::FileFlash(Descriptor file, const Geometry& geometry)
    : file_(std::move(file)), geometry_(geometry) {
  flash_.sector_size = geometry.sector_size;
  flash_.erase = decltype(Flash::erase)::to<&FileFlash::erase>(*this);
  flash_.program = decltype(Flash::program)::to<&FileFlash::program>(*this);
  flash_.read = decltype(Flash::read)::to<&FileFlash::read>(*this);
  flash_.sync = decltype(Flash::sync)::to<&FileFlash::sync>(*this);
}

bool FileFlash::is_inside(std::uint32_t address, std::size_t size) const {
  const std::uint64_t all = std::uint64_t{geometry_.sectors} * geometry_.sector_size;
  return address <= all && size <= all - address;
}

FlashState FileFlash::erase(std::uint32_t address) {
  const std::vector<std::uint8_t> erased(geometry_.sector_size, 0xFF);
  return program(address, erased);
}

FlashState FileFlash::program(std::uint32_t address, std::span<const std::uint8_t> bytes) {
  const bool done = is_inside(address, bytes.size()) &&
                    write_all(file_.get(), bytes.data(), bytes.size(), off_t{head_size} + address);
  return done ? FlashState::done : FlashState::failed;
}

/// The missing part of a shortened file reads as zeros, which no checksum accepts.
bool FileFlash::read(std::uint32_t address, std::span<std::uint8_t> bytes) {
  if (!is_inside(address, bytes.size())) return false;
  std::ranges::fill(bytes, std::uint8_t{0});
  return ::pread(file_.get(), bytes.data(), bytes.size(), off_t{head_size} + address) >= 0;
}

FlashState FileFlash::sync() {
  return ::fdatasync(file_.get()) == 0 ? FlashState::done : FlashState::failed;
}

}  // namespace canvoy::host
