#include "canvoy/text/service_words.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "canvoy/profiles/registry.hpp"

namespace canvoy::text::service_words_test {
namespace {

TEST(ServiceWords, OfAPdoAreItsNumberAndDirection) {
  EXPECT_EQ(pdo_service({.number = 3}), "TPDO3");
  EXPECT_EQ(pdo_service({.direction = PdoInfo::Direction::receive, .number = 512}), "RPDO512");
  EXPECT_EQ(pdo_service({}), "PDO");
}

/// Data and remote frames of any length, some of which are SDO that teach.
Frame any_frame(std::mt19937& random) {
  const auto id = static_cast<std::uint32_t>(random() % 0x800);
  const auto length = static_cast<std::uint8_t>(random() % 9);
  if (random() % 8 == 0) return Frame::remote_frame(id, length);
  Frame frame = Frame::data_frame(id, {});
  frame.length = length;
  for (std::size_t i = 0; i < length; ++i) frame.data[i] = static_cast<std::uint8_t>(random() % 3);
  return frame;
}

/// The device types are those of CiA 418 and CiA 447: with a car, the mesh of SDO channels, sleep
/// messages and ISO-TP have CAN-IDs.
TEST(ServiceWords, ArePossibleIfADecoderFindsThem) {
  for (const char* name : {"", "418", "447-3", "852"}) {
    SCOPED_TRACE(name);
    FrameDecoder decoder;
    const Profile* const profile = find_profile(std::string_view(name));
    if (profile != nullptr) decoder.network().assume_profile(*profile);
    std::mt19937 random(11);
    for (int i = 0; i < 100'000; ++i) {
      const Frame frame = any_frame(random);
      const std::vector<PossibleWords> possible = possible_words(decoder.network(), frame.id);
      const FrameWords& words = decoder.decode(frame);
      ASSERT_TRUE(std::ranges::any_of(possible,
                                      [&words](const PossibleWords& each) {
                                        return each.service == words.service &&
                                               each.node == words.node &&
                                               each.client == words.client;
                                      }))
          << std::hex << frame.id << " " << words.service << " of " << unsigned{words.node};
    }
  }
}

}  // namespace
}  // namespace canvoy::text::service_words_test
