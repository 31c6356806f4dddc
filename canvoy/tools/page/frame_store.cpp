#include "canvoy/tools/page/frame_store.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>

#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools {

namespace {

constexpr std::size_t block_bytes = FrameStore::block_frames * sizeof(StoredFrame);

std::string temporary_folder() {
  const char* const named = std::getenv("TMPDIR");
  return named != nullptr && *named != '\0' ? named : "/tmp";
}

[[noreturn]] void refuse_file(std::string_view what) {
  throw Failure(fmt::format("{}: frames of a long log cannot be {}: {}", temporary_folder(), what,
                            std::strerror(errno)));
}

/// The file has no name from the start, or its name was removed.
host::Descriptor nameless_file() {
  const std::string folder = temporary_folder();
  constexpr mode_t of_owner = 0600;
  int file = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, of_owner);
  if (file < 0) {
    std::string name = folder + "/canvoy-XXXXXX";
    file = ::mkostemp(name.data(), O_CLOEXEC);
    if (file >= 0) ::unlink(name.c_str());
  }
  if (file < 0) refuse_file("kept");
  return host::Descriptor(file);
}

}  // namespace

void FrameStore::add(const StoredFrame& frame) {
  if (last_.empty()) begins_.push_back(frame.time);
  last_.push_back(frame);
  index_.add(frame.bus(), frame.frame);
  ++size_;
  if (last_.size() < block_frames) return;
  index_.end_block();
  if (blocks_.size() < blocks_in_memory_) {
    blocks_.push_back(std::move(last_));
    last_ = {};
  } else {
    spill(last_);
    last_.clear();
  }
}

void FrameStore::clear() {
  size_ = 0;
  blocks_.clear();
  last_.clear();
  begins_.clear();
  index_ = {};
  file_ = host::Descriptor();
}

void FrameStore::spill(const Block& block) {
  if (!file_) file_ = nameless_file();
  const auto* from = reinterpret_cast<const char*>(block.data());
  for (std::size_t left = block_bytes; left != 0;) {
    const ssize_t written = ::write(file_.get(), from, left);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) refuse_file("kept");
    from += written;
    left -= static_cast<std::size_t>(written);
  }
}

void FrameStore::load(std::size_t number, Block& into) const {
  into.resize(block_frames);
  auto* to = reinterpret_cast<char*>(into.data());
  auto place = static_cast<off_t>((number - blocks_in_memory_) * block_bytes);
  for (std::size_t left = block_bytes; left != 0;) {
    const ssize_t read = ::pread(file_.get(), to, left, place);
    if (read < 0 && errno == EINTR) continue;
    if (read <= 0) refuse_file("read");
    to += read;
    place += read;
    left -= static_cast<std::size_t>(read);
  }
}

std::uint64_t FrameStore::first_after(Time when) const {
  const auto block = std::ranges::upper_bound(begins_, when);
  if (block == begins_.begin()) return 0;
  const auto first = static_cast<std::uint64_t>(block - begins_.begin() - 1) * block_frames;
  const std::uint64_t end = std::min(size_, first + block_frames);
  FrameCursor cursor(*this);
  std::uint64_t number = first;
  for (std::uint64_t count = end - first; count != 0;) {
    const std::uint64_t half = count / 2;
    if (cursor.at(number + half).time <= when) {
      number += half + 1;
      count -= half + 1;
    } else {
      count = half;
    }
  }
  return number;
}

const StoredFrame& FrameCursor::at(std::uint64_t number) {
  const std::size_t block = number / FrameStore::block_frames;
  const std::size_t place = number % FrameStore::block_frames;
  if (block < store_.blocks_.size()) return store_.blocks_[block][place];
  if (block + 1 == store_.begins_.size() && !store_.last_.empty()) return store_.last_[place];
  if (loaded_ != block) store_.load(block, block_);
  loaded_ = block;
  return block_[place];
}

}  // namespace canvoy::tools
