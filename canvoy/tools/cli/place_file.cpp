#include "canvoy/tools/cli/place_file.hpp"

#include <fmt/format.h>

#include "canvoy/devices/cia447/navigation/place_line.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/value_file.hpp"

namespace canvoy::tools {

PlaceFile::PlaceFile(const std::string& path) {
  const std::vector<std::uint8_t> bytes = read_value_file(path);
  text_.assign(bytes.begin(), bytes.end());
  std::string_view rest = text_;
  for (unsigned number = 1; !rest.empty(); ++number) {
    const std::size_t end = rest.find('\n');
    const cia447::PlaceLine line = cia447::parse_place_line(rest.substr(0, end));
    if (line.error != cia447::PlaceLineError::none) {
      throw Failure(fmt::format("{} line {}: {}", path, number, cia447::text_of(line.error)));
    }
    if (line.has_place) places_.push_back(line.place);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  }
  if (places_.empty()) {
    throw Failure(
        fmt::format("{}: there are no places; write one a line: "
                    "latitude longitude | street | city | country",
                    path));
  }
}

}  // namespace canvoy::tools
