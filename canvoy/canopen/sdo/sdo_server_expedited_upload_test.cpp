// SDO server, expedited upload (CiA 301, 7.2.4.3.6).
#include <gtest/gtest.h>

#include "canvoy/canopen/testing/sdo_server_node.hpp"

namespace canvoy::sdo_server_expedited_upload_test {
namespace {

class SdoServerExpeditedUpload : public SdoServerNode {};

TEST_F(SdoServerExpeditedUpload,
       AnUploadOfOneToFourBytesIsAnsweredInOneFrameThatTellsHowManyAreUnused) {
  set_value(wire.node, 0x2001, Bytes{0x11});
  set_value(wire.node, 0x2002, Bytes{0x11, 0x22});
  set_value(wire.node, 0x2003, Bytes{0x11, 0x22, 0x33});
  set_value(wire.node, 0x2004, Bytes{0x11, 0x22, 0x33, 0x44});
  ask("40 01 20 00 00 00 00 00", "4F 01 20 00 11 00 00 00");
  ask("40 02 20 00 00 00 00 00", "4B 02 20 00 11 22 00 00");
  ask("40 03 20 00 00 00 00 00", "47 03 20 00 11 22 33 00");
  ask("40 04 20 00 00 00 00 00", "43 04 20 00 11 22 33 44");
  EXPECT_FALSE(sut.busy());
}

TEST_F(SdoServerExpeditedUpload, AStringOfUpToFourBytesIsUploadedExpeditedToo) {
  set_value(wire.node, 0x2020, Bytes{'a', 'b'});
  ask("40 20 20 00 00 00 00 00", "4B 20 20 00 61 62 00 00");
}

TEST_F(SdoServerExpeditedUpload, EachSubIndexOfAnArrayHasItsOwnValue) {
  ask("2B 09 20 01 01 00 00 00", "60 09 20 01 00 00 00 00");
  ask("2B 09 20 03 FD FF 00 00", "60 09 20 03 00 00 00 00");
  ask("40 09 20 00 00 00 00 00", "4F 09 20 00 03 00 00 00");
  ask("40 09 20 01 00 00 00 00", "4B 09 20 01 01 00 00 00");
  ask("40 09 20 02 00 00 00 00", "4B 09 20 02 00 00 00 00");
  ask("40 09 20 03 00 00 00 00", "4B 09 20 03 FD FF 00 00");
}

TEST_F(SdoServerExpeditedUpload, ReservedBitsOfARequestDoNotMatter) {
  ask("5F 00 10 00 FF FF FF FF", "43 00 10 00 A2 01 02 00");
  ask("3B 02 20 00 34 12 FF FF", "60 02 20 00 00 00 00 00");  // bit 4
  EXPECT_EQ(value(0x2002), (Bytes{0x34, 0x12}));
}

TEST_F(SdoServerExpeditedUpload, AnUploadOfWhatIsNotThereIsAborted) {
  ask("40 99 20 00 00 00 00 00", "80 99 20 00 00 00 02 06");
  ask("40 00 00 00 00 00 00 00", "80 00 00 00 00 00 02 06");
  ask("40 FF FF FF 00 00 00 00", "80 FF FF FF 00 00 02 06");
  ask("40 09 20 04 00 00 00 00", "80 09 20 04 11 00 09 06");
  ask("40 00 10 01 00 00 00 00", "80 00 10 01 11 00 09 06");
}

TEST_F(SdoServerExpeditedUpload, AnUploadOfAWriteOnlyEntryIsAborted) {
  ask("40 11 20 00 00 00 00 00", "80 11 20 00 01 00 01 06");
  ask("40 32 20 00 00 00 00 00", "80 32 20 00 01 00 01 06");
}

TEST_F(SdoServerExpeditedUpload, AHookRefreshesAValueBeforeItIsUploadedOrRefuses) {
  auto refresh = [&](const Entry& entry) {
    if (value(0x2001) == Bytes{0xFF}) return AbortCode::no_data;
    wire.node.dictionary().set(entry, Bytes{0x42, 0x00});
    return AbortCode::none;
  };
  Hook hook{.first = 0x2002, .last = 0x2002};
  hook.before_read = decltype(hook.before_read)::of(refresh);
  wire.node.dictionary().attach(hook);
  ask("40 02 20 00 00 00 00 00", "4B 02 20 00 42 00 00 00");
  set_value(wire.node, 0x2001, Bytes{0xFF});
  ask("40 02 20 00 00 00 00 00", "80 02 20 00 24 00 00 08");
}

}  // namespace
}  // namespace canvoy::sdo_server_expedited_upload_test
