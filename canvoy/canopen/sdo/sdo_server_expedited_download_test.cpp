// SDO server, expedited download (CiA 301, 7.2.4.3.3).
#include <gtest/gtest.h>

#include "canvoy/canopen/testing/sdo_server_node.hpp"

namespace canvoy::sdo_server_expedited_download_test {
namespace {

class SdoServerExpeditedDownload : public SdoServerNode {};

TEST_F(SdoServerExpeditedDownload, ADownloadOfOneToFourBytesIsConfirmedInOneFrame) {
  ask("2F 01 20 00 11 00 00 00", "60 01 20 00 00 00 00 00");
  ask("2B 02 20 00 11 22 00 00", "60 02 20 00 00 00 00 00");
  ask("27 03 20 00 11 22 33 00", "60 03 20 00 00 00 00 00");
  ask("23 04 20 00 11 22 33 44", "60 04 20 00 00 00 00 00");
  EXPECT_EQ(value(0x2001), (Bytes{0x11}));
  EXPECT_EQ(value(0x2002), (Bytes{0x11, 0x22}));
  EXPECT_EQ(value(0x2003), (Bytes{0x11, 0x22, 0x33}));
  EXPECT_EQ(value(0x2004), (Bytes{0x11, 0x22, 0x33, 0x44}));
}

TEST_F(SdoServerExpeditedDownload, AnExpeditedDownloadWithoutSizeHasTheLengthOfTheEntry) {
  ask("22 01 20 00 11 AA AA AA", "60 01 20 00 00 00 00 00");
  ask("22 02 20 00 11 22 AA AA", "60 02 20 00 00 00 00 00");
  ask("2E 03 20 00 11 22 33 AA", "60 03 20 00 00 00 00 00");  // n is ignored without s
  ask("22 04 20 00 11 22 33 44", "60 04 20 00 00 00 00 00");
  ask("22 20 20 00 61 62 63 00", "60 20 20 00 00 00 00 00");
  EXPECT_EQ(value(0x2001), (Bytes{0x11}));
  EXPECT_EQ(value(0x2002), (Bytes{0x11, 0x22}));
  EXPECT_EQ(value(0x2003), (Bytes{0x11, 0x22, 0x33}));
  EXPECT_EQ(value(0x2004), (Bytes{0x11, 0x22, 0x33, 0x44}));
  EXPECT_EQ(value(0x2020), (Bytes{'a', 'b', 'c'}));
}

TEST_F(SdoServerExpeditedDownload, AnExpeditedDownloadOfAnotherLengthIsAborted) {
  ask("2B 01 20 00 11 22 00 00", "80 01 20 00 12 00 07 06");
  ask("23 02 20 00 11 22 00 00", "80 02 20 00 12 00 07 06");
  ask("2F 02 20 00 11 00 00 00", "80 02 20 00 13 00 07 06");
  ask("27 04 20 00 11 22 33 00", "80 04 20 00 13 00 07 06");
  ask("23 05 20 00 11 22 33 44", "80 05 20 00 13 00 07 06");
  ask("22 08 20 00 11 22 33 44", "80 08 20 00 13 00 07 06");
  ask("23 20 20 00 61 62 63 64", "80 20 20 00 12 00 07 06");
  EXPECT_EQ(value(0x2002), (Bytes{0, 0}));
}

TEST_F(SdoServerExpeditedDownload, ADownloadToWhatIsNotThereIsAborted) {
  ask("2F 99 20 00 00 00 00 00", "80 99 20 00 00 00 02 06");
  ask("2F 01 20 01 00 00 00 00", "80 01 20 01 11 00 09 06");
  ask("21 99 20 00 08 00 00 00", "80 99 20 00 00 00 02 06");
  ask("21 08 20 01 08 00 00 00", "80 08 20 01 11 00 09 06");
}

TEST_F(SdoServerExpeditedDownload, ADownloadToAReadOnlyEntryIsAborted) {
  ask("2B 12 20 00 00 00 00 00", "80 12 20 00 02 00 01 06");
  ask("21 13 20 00 0B 00 00 00", "80 13 20 00 02 00 01 06");
  ask("21 31 20 00 0B 00 00 00", "80 31 20 00 02 00 01 06");
  EXPECT_EQ(value(0x2012), (Bytes{0x34, 0x12}));
}

TEST_F(SdoServerExpeditedDownload, ADownloadOutOfTheRangeIsAborted) {
  ask("2F 10 20 00 15 00 00 00", "80 10 20 00 31 00 09 06");
  ask("2F 10 20 00 F5 00 00 00", "80 10 20 00 32 00 09 06");
  ask("2F 10 20 00 14 00 00 00", "60 10 20 00 00 00 00 00");
  ask("2F 10 20 00 F6 00 00 00", "60 10 20 00 00 00 00 00");
}

TEST_F(SdoServerExpeditedDownload, AHookMayRefuseADownload) {
  auto refuse = [](const Entry&, std::span<const std::uint8_t>) { return AbortCode::device_state; };
  Hook hook{.first = 0x2001, .last = 0x2008};
  hook.before_write = decltype(hook.before_write)::of(refuse);
  wire.node.dictionary().attach(hook);
  ask("2F 01 20 00 11 00 00 00", "80 01 20 00 22 00 00 08");
  ask("21 08 20 00 08 00 00 00", "60 08 20 00 00 00 00 00");
  ask("00 01 02 03 04 05 06 07", "20 00 00 00 00 00 00 00");
  ask("1D 08 00 00 00 00 00 00", "80 08 20 00 22 00 00 08");
  EXPECT_EQ(value(0x2008), Bytes(8));
}

TEST_F(SdoServerExpeditedDownload, AShortDomainMayBeDownloadedExpedited) {
  ask("2B 30 20 00 11 22 00 00", "60 30 20 00 00 00 00 00");
  EXPECT_EQ(domain.content, (Bytes{0x11, 0x22}));
  ask("22 30 20 00 11 22 33 44", "60 30 20 00 00 00 00 00");
  EXPECT_EQ(domain.content, (Bytes{0x11, 0x22, 0x33, 0x44}));
}

}  // namespace
}  // namespace canvoy::sdo_server_expedited_download_test
