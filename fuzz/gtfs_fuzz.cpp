// Arbitrary bytes as the files of a GTFS feed, in sequence with a line `== name` before each, or as
// a zip archive: a feed that is read is consistent, and an error is one line.
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>

#include "canvoy/formats/gtfs/feed_reader.hpp"
#include "canvoy/formats/plain_text.hpp"
#include "fuzz/require.hpp"

namespace {

using namespace canvoy::gtfs;
using canvoy::fuzz::require;

std::map<std::string, std::string, std::less<>> texts_of(std::string_view input) {
  std::map<std::string, std::string, std::less<>> texts;
  std::string* text = nullptr;
  while (!input.empty()) {
    const std::size_t end = std::min(input.find('\n'), input.size() - 1) + 1;
    const std::string_view line = input.substr(0, end);
    input.remove_prefix(end);
    if (line.starts_with("== ")) {
      text = &texts[std::string(line.substr(3, line.size() - 4))];
    } else if (text != nullptr) {
      *text += line;
    }
  }
  return texts;
}

void check_trip(const Feed& feed, const Trip& trip) {
  require(trip.shape == none || trip.shape < feed.shapes.size());
  require(feed.service(trip.service) != nullptr);
  TimeOfDay before{};
  for (std::size_t i = 0; i < trip.calls.size(); ++i) {
    const Call& call = trip.calls[i];
    require(call.stop < feed.stops.size());
    require(i == 0 || trip.calls[i - 1].sequence < call.sequence);
    if (!call.arrival) continue;
    require(before <= *call.arrival && *call.arrival <= *call.departure);
    before = *call.departure;
  }
}

void check(const FeedArchive& archive) {
  const canvoy::host::Result<Feed> feed = read_feed(archive, "r");
  if (!feed) {
    const std::string line = feed.error().line();
    require(!line.empty() && canvoy::formats::is_plain_text(line));
    return;
  }
  for (const Trip& trip : feed->trips) check_trip(*feed, trip);
  for (const Stop& stop : feed->stops) {
    require(stop.latitude >= -90 && stop.latitude <= 90);
    require(stop.longitude >= -180 && stop.longitude <= 180);
    require(canvoy::formats::is_plain_text(stop.name));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  check(
      FeedArchive::of_texts(texts_of(std::string_view(reinterpret_cast<const char*>(data), size))));
  const auto zipped = FeedArchive::of_zip(std::span(data, size), "feed.zip");
  if (zipped) check(*zipped);
  return 0;
}
