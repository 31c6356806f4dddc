// zlib in pieces, of logs that are compressed, or have compressed parts.
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
  enum class Of : std::uint8_t { gzip, zlib };
  enum class State : std::uint8_t { goes_on, ended, damaged };
  struct Step {
    std::size_t taken = 0;  ///< of the compressed bytes
    std::size_t made = 0;
    State state = State::goes_on;
  };

  explicit Inflater(Of of);
  Inflater(Inflater&&) noexcept;
  Inflater& operator=(Inflater&&) noexcept;
  ~Inflater();

  /// As far as the bytes, or the room in `into`, reach.
  Step run(std::string_view bytes, std::span<char> into);
  /// For another piece of compressed data.
  void begin_again();

 private:
  struct Stream;
  std::unique_ptr<Stream> stream_;
};

/// Compresses by gzip, with its fastest level: logs are many bytes that are much alike.
class Deflater {
 public:
  Deflater();
  Deflater(const Deflater&) = delete;
  Deflater& operator=(const Deflater&) = delete;
  ~Deflater();

  /// What becomes of `bytes`, until the next call; all that was given so far can be read of it.
  /// `last`: nothing follows.
  std::string_view run(std::string_view bytes, bool last);

 private:
  struct Stream;
  std::unique_ptr<Stream> stream_;
  std::string room_;
};

}  // namespace canvoy::formats
