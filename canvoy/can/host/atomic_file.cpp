#include "canvoy/can/host/atomic_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <utility>

namespace canvoy::host {

namespace {

Error failed(const std::string& path, int error) {
  return {path, std::strerror(error), "check the path"};
}

std::string folder_of(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? std::string() : path.substr(0, slash + 1);
}

/// Target of `path` after all links. A link to a missing file is the position of a new file.
std::string resolved(std::string path) {
  constexpr int links_max = 40;  // limit of the kernel
  std::error_code no_link;
  for (int i = 0; i < links_max; ++i) {
    const std::filesystem::path target = std::filesystem::read_symlink(path, no_link);
    if (no_link) break;
    path = (std::filesystem::path(path).parent_path() / target).string();
  }
  return path;
}

/// A new file, with a name that no other file has; short, so that any valid file name can be
/// written.
Descriptor create_beside(const std::string& path, std::string& draft) {
  static std::atomic<unsigned> count{0};
  constexpr int tries_max = 100;  // leftovers of earlier processes
  for (int i = 0; i < tries_max; ++i) {
    draft = folder_of(path) + ".canvoy-" + std::to_string(::getpid()) + '-' +
            std::to_string(count++) + ".part";
    Descriptor file{::open(draft.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666)};
    if (file || errno != EEXIST) return file;
  }
  return {};
}

/// Synchronises a file; some file systems have nothing to synchronise.
bool synchronise(int file) {
  return ::fsync(file) == 0 || errno == EINVAL || errno == EROFS;
}

void synchronise_folder(const std::string& path) {
  const std::string folder = folder_of(path);
  const Descriptor opened{
      ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)};
  if (opened) ::fsync(opened.get());
}

}  // namespace

Result<AtomicFile> AtomicFile::begin(const std::string& path) {
  const std::string place = resolved(path);
  struct stat status {};
  const bool is_there = ::stat(place.c_str(), &status) == 0;
  if (is_there && !S_ISREG(status.st_mode)) {
    Descriptor file{::open(place.c_str(), O_WRONLY | O_CLOEXEC)};
    if (!file) return failed(path, errno);
    return AtomicFile(path, place, "", std::move(file));
  }
  // A user without write permission may not replace the file either.
  if (is_there && ::access(place.c_str(), W_OK) != 0) return failed(path, errno);
  std::string draft;
  Descriptor file = create_beside(place, draft);
  if (!file) return failed(path, errno);
  if (is_there) static_cast<void>(::fchmod(file.get(), status.st_mode & 07777));
  return AtomicFile(path, place, std::move(draft), std::move(file));
}

AtomicFile::AtomicFile(std::string path, std::string place, std::string draft, Descriptor file)
    : path_(std::move(path)),
      place_(std::move(place)),
      draft_(std::move(draft)),
      file_(std::move(file)) {}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : path_(std::move(other.path_)),
      place_(std::move(other.place_)),
      draft_(std::exchange(other.draft_, {})),
      file_(std::move(other.file_)) {}

AtomicFile::~AtomicFile() {
  if (!draft_.empty()) ::unlink(draft_.c_str());
}

Result<void> AtomicFile::write(std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file_.get(), bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return failed(path_, errno);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return {};
}

Result<void> AtomicFile::finish() {
  if (draft_.empty()) return {};
  if (!synchronise(file_.get())) return failed(path_, errno);
  Result<void> replaced = replace();
  if (replaced) synchronise_folder(place_);
  return replaced;
}

Result<void> AtomicFile::replace() {
  if (draft_.empty()) return {};
  if (::rename(draft_.c_str(), place_.c_str()) != 0) return failed(path_, errno);
  draft_.clear();
  return {};
}

}  // namespace canvoy::host
