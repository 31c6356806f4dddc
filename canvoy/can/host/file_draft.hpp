// A file that is there whole, or as it was before: it is written under a name of its own beside the
// place where it belongs, and put there at the end, when the disk has it.
//
//     Result<FileDraft> draft = FileDraft::begin("node5.dcf");
//     draft->write(bytes);
//     Result<void> done = draft->finish();     // without it, nothing has happened
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "canvoy/can/host/descriptor.hpp"
#include "canvoy/can/host/result.hpp"

namespace canvoy::host {

/// Several programs may write the same file at the same time: the last that finishes is there,
/// whole. What is no plain file (a pipe, a device) is written directly.
class FileDraft {
 public:
  /// Where `path` is a symbolic link, its target is replaced. Errors: what the system says.
  static Result<FileDraft> begin(const std::string& path);
  FileDraft(FileDraft&& other) noexcept;
  FileDraft& operator=(FileDraft&&) = delete;
  /// Without finish(), nothing is left of it.
  ~FileDraft();

  /// The descriptor that is written to, for who does it himself.
  int descriptor() const { return file_.get(); }
  Result<void> write(std::span<const std::uint8_t> bytes);
  /// When it succeeds, the file outlives a loss of power, under its name.
  Result<void> finish();
  /// The same for what is soon written anew: it does not wait for the disk, and a loss of power may
  /// leave an older one.
  Result<void> replace();

 private:
  FileDraft(std::string path, std::string place, std::string draft, Descriptor file);

  std::string path_;   ///< as the user wrote it
  std::string place_;  ///< without symbolic links
  std::string draft_;  ///< empty: written directly, or done
  Descriptor file_;
};

}  // namespace canvoy::host
