// A file that is either complete or unchanged: it is written under a temporary name beside its
// destination, and renamed at the end, when the disk has it.
//
//     Result<AtomicFile> draft = AtomicFile::begin("node5.dcf");
//     draft->write(bytes);
//     Result<void> done = draft->finish();     // without it, nothing has happened
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "canvoy/can/host/descriptor.hpp"
#include "canvoy/can/host/result.hpp"

namespace canvoy::host {

/// The writer. Several programs may write the same file at the same time: the last one to finish
/// replaces the others completely. A file that is not regular (a pipe, a device) is written
/// directly.
class AtomicFile {
 public:
  /// Begins to write. If `path` is a symbolic link, its target is replaced. Errors: those of the
  /// system.
  static Result<AtomicFile> begin(const std::string& path);
  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile& operator=(AtomicFile&&) = delete;
  /// Discards the file unless finish() was called.
  ~AtomicFile();

  /// Descriptor for writing directly.
  int descriptor() const { return file_.get(); }
  /// Appends bytes to the file. Errors: those of the system, such as a full disk; finish() is then
  /// useless.
  Result<void> write(std::span<const std::uint8_t> bytes);
  /// Renames the file. On success, it survives a loss of power, under its name.
  Result<void> finish();
  /// Like finish(), but for a file that is soon written again: it does not wait for the disk, and a
  /// loss of power may leave an older file.
  Result<void> replace();

 private:
  AtomicFile(std::string path, std::string place, std::string draft, Descriptor file);

  std::string path_;   ///< as in begin()
  std::string place_;  ///< without symbolic links
  std::string draft_;  ///< empty: written directly, or finished
  Descriptor file_;
};

}  // namespace canvoy::host
