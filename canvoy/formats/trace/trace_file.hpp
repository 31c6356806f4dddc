// Logs that are read from any place of the file: the file itself, or a copy of what came through a
// pipe or was compressed. And files that stand in where what is written goes through a pipe.
//
//     host::Result<TraceFile> file = TraceFile::open(descriptor.get());
//     file->read(4096, into);
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "canvoy/can/host/descriptor.hpp"
#include "canvoy/can/host/result.hpp"

namespace canvoy::formats {

/// A file in the folder for temporary ones (`TMPDIR`), gone with its last user.
class TemporaryTrace {
 public:
  /// An empty file of a name of its own. Errors: what the system says.
  static host::Result<TemporaryTrace> create();
  TemporaryTrace(TemporaryTrace&& other) noexcept;
  TemporaryTrace& operator=(TemporaryTrace&& other) noexcept;
  ~TemporaryTrace();

  /// Its name, with the folder.
  const std::string& path() const { return path_; }
  /// Open as long as this lives.
  int descriptor() const { return file_.get(); }
  /// All of the bytes, or an error.
  host::Result<void> append(std::string_view bytes);

 private:
  TemporaryTrace(std::string path, host::Descriptor file);

  std::string path_;
  host::Descriptor file_;
};

/// The path of an open file, where it is a plain one that still has a name.
std::optional<std::string> path_of(int descriptor);

class TraceFile {
 public:
  TraceFile() = default;
  /// Memory, which has to outlive it.
  explicit TraceFile(std::string_view content) : content_(content), size_(content.size()) {}
  /// A copy of the descriptor of a plain file.
  static host::Result<TraceFile> open(int descriptor);
  /// What was collected, which is kept as long as this.
  static host::Result<TraceFile> of(TemporaryTrace copy);

  std::uint64_t size() const { return size_; }
  /// From the byte `at` on: as many as fit, less at the end of the file, 0 where it cannot be read.
  std::size_t read(std::uint64_t at, std::span<char> into) const;
  /// Empty where it is a file.
  std::string_view content() const { return content_; }
  /// Empty where it is memory, or a file whose name is gone.
  std::string path() const;

 private:
  std::string_view content_;
  host::Descriptor file_;
  std::optional<TemporaryTrace> copy_;
  std::uint64_t size_ = 0;
};

}  // namespace canvoy::formats
