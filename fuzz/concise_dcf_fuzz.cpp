// Arbitrary bytes as a concise DCF: nothing beyond their end is read, and an accepted one is read
// completely, entry by entry, to the last byte.
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "canvoy/canopen/manager/concise_dcf.hpp"
#include "fuzz/require.hpp"

namespace canvoy {
namespace {

using fuzz::require;

class Content {
 public:
  explicit Content(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  ByteSource source() {
    return {static_cast<std::uint32_t>(bytes_.size()),
            decltype(ByteSource::read)::to<&Content::read>(*this)};
  }

 private:
  AbortCode read(std::uint32_t offset, std::span<std::uint8_t> to) {
    require(offset <= bytes_.size() && to.size() <= bytes_.size() - offset);
    std::copy_n(bytes_.begin() + offset, to.size(), to.begin());
    return AbortCode::none;
  }
  std::span<const std::uint8_t> bytes_;
};

void run(std::span<const std::uint8_t> bytes) {
  Content content(bytes);
  const Result<std::uint32_t> checked = check_concise_dcf(content.source());
  ConciseDcf dcf;
  AbortCode answer = dcf.open(content.source());
  std::size_t read = 4;
  std::uint32_t entries = 0;
  while (answer == AbortCode::none && !dcf.at_end()) {
    const auto item = dcf.next();
    answer = item.abort();
    if (!item) break;
    std::vector<std::uint8_t> value(item->size);
    require(dcf.read(*item, 0, value) == AbortCode::none);
    require(dcf.read(*item, 1, value) != AbortCode::none);
    read += 7 + value.size();
    ++entries;
  }
  require(bool(checked) == (answer == AbortCode::none));
  require(!checked || (*checked == entries && read == bytes.size()));
}

}  // namespace
}  // namespace canvoy

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  canvoy::run({data, size});
  return 0;
}
