#include "canvoy/formats/trace/inflater.hpp"

#include <zlib.h>

#include <new>
#include <utility>

namespace canvoy::formats {

struct Inflater::Stream {
  z_stream state{};
};

Inflater::Inflater(Of of) : stream_(std::make_unique<Stream>()) {
  constexpr int gzip_header = 16;
  const int window = of == Of::gzip ? gzip_header + MAX_WBITS : MAX_WBITS;
  if (::inflateInit2(&stream_->state, window) != Z_OK) throw std::bad_alloc();
}

Inflater::Inflater(Inflater&&) noexcept = default;
Inflater& Inflater::operator=(Inflater&& other) noexcept {
  std::swap(stream_, other.stream_);
  return *this;
}

Inflater::~Inflater() {
  if (stream_ != nullptr) ::inflateEnd(&stream_->state);
}

Inflater::Step Inflater::run(std::string_view bytes, std::span<char> into) {
  z_stream& state = stream_->state;
  // zlib does not write to this memory.
  state.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  state.avail_in = static_cast<uInt>(bytes.size());
  state.next_out = reinterpret_cast<Bytef*>(into.data());
  state.avail_out = static_cast<uInt>(into.size());
  const int result = ::inflate(&state, Z_NO_FLUSH);
  Step step{bytes.size() - state.avail_in, into.size() - state.avail_out, State::damaged};
  if (result == Z_STREAM_END) step.state = State::ended;
  if (result == Z_OK || result == Z_BUF_ERROR) step.state = State::goes_on;
  return step;
}

void Inflater::begin_again() {
  ::inflateReset(&stream_->state);
}

struct Deflater::Stream {
  z_stream state{};
};

Deflater::Deflater() : stream_(std::make_unique<Stream>()) {
  constexpr int gzip_header = 16;
  constexpr int memory_level = 8;
  if (::deflateInit2(&stream_->state, Z_BEST_SPEED, Z_DEFLATED, gzip_header + MAX_WBITS,
                     memory_level, Z_DEFAULT_STRATEGY) != Z_OK) {
    throw std::bad_alloc();
  }
}

Deflater::~Deflater() {
  ::deflateEnd(&stream_->state);
}

std::string_view Deflater::run(std::string_view bytes, bool last) {
  constexpr std::size_t step = std::size_t{64} * 1024;
  z_stream& state = stream_->state;
  state.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  state.avail_in = static_cast<uInt>(bytes.size());
  std::size_t made = 0;
  do {
    room_.resize(made + step);
    state.next_out = reinterpret_cast<Bytef*>(room_.data() + made);
    state.avail_out = step;
    ::deflate(&state, last ? Z_FINISH : Z_SYNC_FLUSH);
    made += step - state.avail_out;
  } while (state.avail_out == 0);
  return std::string_view(room_).substr(0, made);
}

}  // namespace canvoy::formats
