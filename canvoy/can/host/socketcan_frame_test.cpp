#include "canvoy/can/host/socketcan_frame.hpp"

#include <gtest/gtest.h>

namespace canvoy::host::socketcan_frame_test {
namespace {

// linux/can/error.h: class 004h is a problem of the controller with its status in data[1], 040h
// bus-off, 100h restarted.
Frame error_frame(std::uint32_t error_class, std::uint8_t status = 0) {
  Frame frame = Frame::data_frame(0, {0, status, 0, 0, 0, 0, 0, 0});
  frame.id = error_class;
  frame.flags = FrameFlags::error;
  return frame;
}

TEST(SocketCanFrame, TheKernelsFlagsStandInTheUpperBitsOfTheIdentifier) {
  EXPECT_EQ(to_kernel(Frame::data_frame(0x185, {1})).can_id, 0x185U);
  EXPECT_EQ(to_kernel(Frame::data_frame(0x12345678, {})).can_id, 0x92345678U);
  EXPECT_EQ(to_kernel(Frame::remote_frame(0x701, 1)).can_id, 0x40000701U);
  EXPECT_EQ(to_kernel(error_frame(0x40)).can_id, 0x20000040U);
}

TEST(SocketCanFrame, EveryKindComesBackAsItWas) {
  Frame small_extended = Frame::data_frame(0x12, {1, 2, 3});
  small_extended.flags = FrameFlags::extended;
  for (const Frame& frame : {Frame::data_frame(0x185, {0x1E, 0x2F}),
                             Frame::data_frame(0x1FFFFFFF, {1, 2, 3, 4, 5, 6, 7, 8}),
                             small_extended, Frame::remote_frame(0x701, 8),
                             Frame::remote_frame(0x12345678, 0), error_frame(0x4, 0x10)}) {
    EXPECT_EQ(from_kernel(to_kernel(frame)), frame);
  }
}

TEST(SocketCanFrame, DataBehindTheLengthAndOfARemoteFrameIsNotTaken) {
  can_frame raw{};
  raw.can_id = 0x40000123;
  raw.len = 2;
  raw.data[0] = 0xAA;
  EXPECT_EQ(from_kernel(raw), Frame::remote_frame(0x123, 2));
  raw.can_id = 0x123;
  raw.data[5] = 0xBB;
  EXPECT_EQ(from_kernel(raw), Frame::data_frame(0x123, {0xAA, 0x00}));
}

TEST(ErrorFrame, BusOffAndRestartedAreStates) {
  EXPECT_EQ(reported_state(error_frame(0x040)), BusState::bus_off);
  EXPECT_EQ(reported_state(error_frame(0x100)), BusState::error_active);
}

TEST(ErrorFrame, PassiveToReceiveOrToSendIsErrorPassive) {
  EXPECT_EQ(reported_state(error_frame(0x004, 0x10)), BusState::error_passive);
  EXPECT_EQ(reported_state(error_frame(0x004, 0x20)), BusState::error_passive);
  EXPECT_EQ(reported_state(error_frame(0x004, 0x34)), BusState::error_passive);
}

TEST(ErrorFrame, AWarningToReceiveOrToSendIsOne) {
  EXPECT_EQ(reported_state(error_frame(0x004, 0x04)), BusState::error_warning);
  EXPECT_EQ(reported_state(error_frame(0x004, 0x08)), BusState::error_warning);
  EXPECT_EQ(reported_state(error_frame(0x004, 0x0C)), BusState::error_warning);
}

TEST(ErrorFrame, ActiveAgainIsErrorActive) {
  EXPECT_EQ(reported_state(error_frame(0x004, 0x40)), BusState::error_active);
}

TEST(ErrorFrame, OtherErrorsAndOrdinaryFramesTellNoState) {
  EXPECT_EQ(reported_state(error_frame(0x020)), std::nullopt);
  EXPECT_EQ(reported_state(error_frame(0x088, 0x10)), std::nullopt);
  EXPECT_EQ(reported_state(error_frame(0x004, 0x01)), std::nullopt);
  EXPECT_EQ(reported_state(Frame::data_frame(0x040, {})), std::nullopt);
}

TEST(ErrorFrame, AnOverflowOfTheControllersReceiveBufferIsAnOverrun) {
  EXPECT_TRUE(reports_overrun(error_frame(0x004, 0x01)));
  EXPECT_FALSE(reports_overrun(error_frame(0x004, 0x02)));
  EXPECT_FALSE(reports_overrun(error_frame(0x008, 0x01)));
}

}  // namespace
}  // namespace canvoy::host::socketcan_frame_test
