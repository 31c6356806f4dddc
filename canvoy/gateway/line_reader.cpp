#include "canvoy/gateway/line_reader.hpp"

#include <algorithm>

#include "canvoy/can/check_invariant.hpp"

namespace canvoy::gateway {

/// Part of a line that is too long to keep: enough for its sequence.
constexpr std::size_t kept_of_too_long = 16;

std::optional<Line> LineReader::next() {
  check_invariant(searched_ <= text_.size());
  const std::size_t end = text_.find('\n', searched_);
  if (end == std::string::npos) {
    searched_ = text_.size();
    skip_too_long();
    return std::nullopt;
  }
  Line line = take(end);
  text_.erase(0, end + 1);
  searched_ = 0;
  too_long_ = false;
  return line;
}

Line LineReader::take(std::size_t length) {
  Line line{text_.substr(0, length), too_long_};
  if (line.text.ends_with('\r')) line.text.pop_back();
  line.too_long = line.too_long || line.text.size() > length_max_;
  if (line.too_long) line.text.resize(std::min(line.text.size(), kept_of_too_long));
  return line;
}

/// A CR at the end may belong to the end of the line.
void LineReader::skip_too_long() {
  const std::size_t size = text_.size() - (text_.ends_with('\r') ? 1 : 0);
  if (!too_long_ && size <= length_max_) return;
  too_long_ = true;
  text_.resize(std::min(text_.size(), kept_of_too_long));
  searched_ = text_.size();
}

}  // namespace canvoy::gateway
