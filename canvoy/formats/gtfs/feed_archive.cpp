#include "canvoy/formats/gtfs/feed_archive.hpp"

#include <zip.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

namespace canvoy::gtfs {

namespace {

using host::Error;
using host::Result;

std::string system_text(int code) {
  return std::generic_category().message(code);
}

Error no_zip(const std::string& name, zip_error_t& error) {
  Error told{name, std::string("no zip archive that can be read: ") + zip_error_strerror(&error),
             "give a folder or a zip file with the .txt files of a GTFS feed"};
  zip_error_fini(&error);
  return told;
}

}  // namespace

void CloseFile::operator()(std::FILE* file) const {
  // A file that was only read has nothing to lose.
  static_cast<void>(std::fclose(file));
}
void CloseZipFile::operator()(::zip_file* file) const {
  zip_fclose(file);
}
void CloseZip::operator()(::zip* archive) const {
  zip_discard(archive);
}

Result<std::size_t> FeedFile::read(std::span<char> room) {
  Result<std::size_t> done = read_some(room);
  if (!done) return done;
  count_ += *done;
  if (count_ > file_bytes_max) return wrong("more than 16 GiB; it is no timetable");
  return done;
}

Result<std::size_t> FeedFile::read_some(std::span<char> room) {
  if (auto* const file = std::get_if<std::unique_ptr<std::FILE, CloseFile>>(&source_)) {
    const std::size_t count = std::fread(room.data(), 1, room.size(), file->get());
    if (count == 0 && std::ferror(file->get()) != 0) return wrong(system_text(errno));
    return count;
  }
  if (auto* const file = std::get_if<std::unique_ptr<::zip_file, CloseZipFile>>(&source_)) {
    const zip_int64_t count = zip_fread(file->get(), room.data(), room.size());
    if (count < 0) return wrong(zip_file_strerror(file->get()));
    return static_cast<std::size_t>(count);
  }
  if (auto* const text = std::get_if<std::string_view>(&source_)) {
    const std::size_t count = std::min(room.size(), text->size());
    std::copy_n(text->begin(), count, room.begin());
    text->remove_prefix(count);
    return count;
  }
  return std::size_t{0};
}

Result<FeedArchive> FeedArchive::open(const std::string& path) {
  std::error_code problem;
  const auto status = std::filesystem::status(path, problem);
  if (!std::filesystem::exists(status)) {
    return Error{path, problem ? problem.message() : system_text(ENOENT), {}};
  }
  if (std::filesystem::is_directory(status)) return FeedArchive(path, Folder{});
  int code = 0;
  zip_t* const archive = zip_open(path.c_str(), ZIP_RDONLY, &code);
  if (archive == nullptr) {
    zip_error_t error;
    zip_error_init_with_code(&error, code);
    return no_zip(path, error);
  }
  return FeedArchive(path, std::unique_ptr<::zip, CloseZip>(archive));
}

Result<FeedArchive> FeedArchive::of_zip(std::span<const std::uint8_t> bytes, std::string name) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* const source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  if (source == nullptr) return no_zip(name, error);
  zip_t* const archive = zip_open_from_source(source, ZIP_RDONLY, &error);
  if (archive == nullptr) {
    zip_source_free(source);
    return no_zip(name, error);
  }
  zip_error_fini(&error);
  return FeedArchive(std::move(name), std::unique_ptr<::zip, CloseZip>(archive));
}

FeedArchive FeedArchive::of_texts(Texts texts, std::string name) {
  return {std::move(name), std::make_unique<Texts>(std::move(texts))};
}

Result<FeedFile> FeedArchive::file(std::string_view name) const {
  std::string shown = name_ + "/" + std::string(name);
  if (std::holds_alternative<Folder>(content_)) return file_of_folder(shown);
  if (const auto* const archive = std::get_if<std::unique_ptr<::zip, CloseZip>>(&content_)) {
    return file_of_zip(archive->get(), std::string(name), std::move(shown));
  }
  const Texts& texts = **std::get_if<std::unique_ptr<Texts>>(&content_);
  const auto found = texts.find(name);
  if (found == texts.end()) return FeedFile(std::move(shown), std::monostate{});
  return FeedFile(std::move(shown), std::string_view(found->second));
}

Result<FeedFile> FeedArchive::file_of_folder(const std::string& path) const {
  std::error_code problem;
  const auto status = std::filesystem::status(path, problem);
  if (!std::filesystem::exists(status)) return FeedFile(path, std::monostate{});
  // Reading a pipe would block.
  if (!std::filesystem::is_regular_file(status)) return Error{path, "no plain file", {}};
  std::FILE* const file = std::fopen(path.c_str(), "rb");
  if (file == nullptr) return Error{path, system_text(errno), {}};
  return FeedFile(path, std::unique_ptr<std::FILE, CloseFile>(file));
}

Result<FeedFile> FeedArchive::file_of_zip(::zip* archive, const std::string& file,
                                          std::string shown) const {
  zip_int64_t index = zip_name_locate(archive, file.c_str(), 0);
  // Some archives contain the folder with its files.
  if (index < 0) index = zip_name_locate(archive, file.c_str(), ZIP_FL_NODIR);
  if (index < 0) return FeedFile(std::move(shown), std::monostate{});
  zip_file_t* const opened = zip_fopen_index(archive, static_cast<zip_uint64_t>(index), 0);
  if (opened == nullptr) return Error{std::move(shown), zip_strerror(archive), {}};
  return FeedFile(std::move(shown), std::unique_ptr<::zip_file, CloseZipFile>(opened));
}

}  // namespace canvoy::gtfs
