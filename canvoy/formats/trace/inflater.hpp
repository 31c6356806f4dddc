// zlib in pieces, for logs that are compressed or have compressed parts.
//
//     Inflater inflater(Inflater::Of::gzip);
//     const Inflater::Step step = inflater.run(compressed, into);
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace canvoy::formats {

class Inflater {
 public:
  /// Form of the compressed data.
  enum class Of : std::uint8_t { gzip, zlib };
  /// Whether more can follow.
  enum class State : std::uint8_t { goes_on, ended, damaged };
  /// What a run has done.
  struct Step {
    std::size_t taken = 0;         ///< number of compressed bytes used
    std::size_t made = 0;          ///< number of bytes decompressed
    State state = State::goes_on;  ///< after `ended` and `damaged` only begin_again() helps
  };

  /// Begins a stream.
  explicit Inflater(Of of);
  Inflater(Inflater&&) noexcept;
  Inflater& operator=(Inflater&&) noexcept;
  ~Inflater();

  /// Decompresses as far as `bytes`, or the room in `into`, allows.
  Step run(std::string_view bytes, std::span<char> into);
  /// Starts another stream of compressed data.
  void begin_again();

 private:
  struct Stream;
  std::unique_ptr<Stream> stream_;
};

/// Compresses with gzip at its fastest level: logs are large and repetitive.
class Deflater {
 public:
  Deflater();
  ~Deflater();

  /// Compressed form of `bytes`, valid until the next call; a reader can decompress all bytes given
  /// so far. `last`: nothing follows.
  std::string_view run(std::string_view bytes, bool last);

 private:
  struct Stream;
  std::unique_ptr<Stream> stream_;
  std::string room_;
};

}  // namespace canvoy::formats
