#include "canvoy/formats/trace/trace_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <utility>

namespace canvoy::formats {

namespace {

host::Error temporary_failure(const std::string& path, int error) {
  return {path, std::strerror(error), "TMPDIR names a folder with room for the log"};
}

}  // namespace

host::Result<TemporaryTrace> TemporaryTrace::create() {
  const char* const wanted = std::getenv("TMPDIR");
  std::string path = wanted != nullptr && *wanted != '\0' ? wanted : "/tmp";
  path += "/canvoy-XXXXXX";
  host::Descriptor file{::mkostemp(path.data(), O_CLOEXEC)};
  if (!file) return temporary_failure(path, errno);
  return TemporaryTrace(std::move(path), std::move(file));
}

TemporaryTrace::TemporaryTrace(std::string path, host::Descriptor file)
    : path_(std::move(path)), file_(std::move(file)) {}

TemporaryTrace::TemporaryTrace(TemporaryTrace&& other) noexcept
    : path_(std::exchange(other.path_, {})), file_(std::move(other.file_)) {}

TemporaryTrace& TemporaryTrace::operator=(TemporaryTrace&& other) noexcept {
  std::swap(path_, other.path_);
  file_ = std::move(other.file_);
  return *this;
}

TemporaryTrace::~TemporaryTrace() {
  if (!path_.empty()) ::unlink(path_.c_str());
}

host::Result<void> TemporaryTrace::append(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file_.get(), bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return temporary_failure(path_, errno);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return {};
}

std::optional<std::string> path_of(int descriptor) {
  std::error_code none;
  const std::filesystem::path path =
      std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(descriptor), none);
  struct stat named {};
  struct stat opened {};
  const bool is_same = !none && ::stat(path.c_str(), &named) == 0 &&
                       ::fstat(descriptor, &opened) == 0 && S_ISREG(named.st_mode) &&
                       named.st_dev == opened.st_dev && named.st_ino == opened.st_ino;
  if (!is_same) return std::nullopt;
  return path.string();
}

host::Result<TraceFile> TraceFile::open(int descriptor) {
  TraceFile file;
  file.file_ = host::Descriptor{::fcntl(descriptor, F_DUPFD_CLOEXEC, 0)};
  struct stat status {};
  if (!file.file_ || ::fstat(descriptor, &status) != 0) {
    return host::Error{"the log", std::strerror(errno), "close other files"};
  }
  file.size_ = static_cast<std::uint64_t>(status.st_size);
  return file;
}

host::Result<TraceFile> TraceFile::of(TemporaryTrace copy) {
  host::Result<TraceFile> file = open(copy.descriptor());
  if (file) file->copy_.emplace(std::move(copy));
  return file;
}

std::string TraceFile::path() const {
  return file_ ? path_of(file_.get()).value_or("") : "";
}

std::size_t TraceFile::read(std::uint64_t at, std::span<char> into) const {
  if (at >= size_) return 0;
  if (!file_) {
    const std::string_view bytes = content_.substr(static_cast<std::size_t>(at), into.size());
    std::ranges::copy(bytes, into.begin());
    return bytes.size();
  }
  std::size_t done = 0;
  while (done < into.size()) {
    const ssize_t got =
        ::pread(file_.get(), into.data() + done, into.size() - done, static_cast<off_t>(at + done));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    done += static_cast<std::size_t>(got);
  }
  return done;
}

}  // namespace canvoy::formats
