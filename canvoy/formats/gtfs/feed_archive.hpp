// A GTFS feed as files: a folder, a zip archive, or texts in memory. Each file is read in pieces.
//
//     host::Result<FeedArchive> archive = FeedArchive::open("feed.zip");
//     host::Result<FeedFile> stops = archive->file("stops.txt");
//     host::Result<std::size_t> count = stops->read(buffer);
//     for (; count && *count != 0; count = stops->read(buffer)) use(buffer, *count);
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "canvoy/can/host/result.hpp"

struct zip;
struct zip_file;

namespace canvoy::gtfs {

/// Maximum number of bytes read from a file; a longer unpacked file is not a timetable.
inline constexpr std::uint64_t file_bytes_max = 16ULL << 30;

/// For std::unique_ptr.
struct CloseFile {
  void operator()(std::FILE* file) const;
};
/// For std::unique_ptr.
struct CloseZipFile {
  void operator()(::zip_file* file) const;
};
/// For std::unique_ptr.
struct CloseZip {
  void operator()(::zip* archive) const;
};

/// One file of a feed. The archive must outlive it.
class FeedFile {
 public:
  /// Reads the next bytes; returns their number, 0 at the end. Errors: those of the system or the
  /// archive.
  host::Result<std::size_t> read(std::span<char> room);
  /// False for a file that the feed does not have.
  bool is_there() const { return !std::holds_alternative<std::monostate>(source_); }
  /// Name for messages: `feed.zip/stops.txt`.
  const std::string& name() const { return name_; }

 private:
  friend class FeedArchive;
  using Source = std::variant<std::monostate, std::unique_ptr<std::FILE, CloseFile>,
                              std::unique_ptr<::zip_file, CloseZipFile>, std::string_view>;
  FeedFile(std::string name, Source source) : name_(std::move(name)), source_(std::move(source)) {}
  host::Result<std::size_t> read_some(std::span<char> room);
  host::Error wrong(std::string what) const { return {name_, std::move(what), {}}; }

  std::string name_;
  Source source_;
  std::uint64_t count_ = 0;
};

class FeedArchive {
 public:
  /// Opens a folder or a zip archive. Errors: it is neither, or cannot be read.
  static host::Result<FeedArchive> open(const std::string& path);
  /// Opens the bytes of a zip archive, which must outlive this. `name` stands for it in errors.
  static host::Result<FeedArchive> of_zip(std::span<const std::uint8_t> bytes, std::string name);
  /// Makes an archive of texts by file name.
  static FeedArchive of_texts(std::map<std::string, std::string, std::less<>> texts,
                              std::string name = "feed");

  /// Opens a file. A missing file is not an error: is_there() is false. In a zip archive the file
  /// may be in a folder.
  host::Result<FeedFile> file(std::string_view name) const;
  /// Name for messages: the path, or what was given.
  const std::string& name() const { return name_; }

 private:
  using Texts = std::map<std::string, std::string, std::less<>>;
  struct Folder {};
  using Content = std::variant<Folder, std::unique_ptr<::zip, CloseZip>, std::unique_ptr<Texts>>;
  FeedArchive(std::string name, Content content)
      : name_(std::move(name)), content_(std::move(content)) {}
  host::Result<FeedFile> file_of_folder(const std::string& path) const;
  host::Result<FeedFile> file_of_zip(::zip* archive, const std::string& file,
                                     std::string shown) const;

  std::string name_;
  Content content_;
};

}  // namespace canvoy::gtfs
