#include "canvoy/can/simulated/fault_confinement.hpp"

#include <gtest/gtest.h>

namespace canvoy::fault_confinement_test {
namespace {

void transmit_errors(ErrorCounters& counters, int times) {
  for (int i = 0; i < times; ++i) counters.transmit_error();
}

TEST(ErrorCounters, MakeAControllerErrorPassiveAtOneHundredAndTwentyEightTransmitErrors) {
  ErrorCounters counters;
  transmit_errors(counters, 15);
  EXPECT_EQ(counters.transmit(), 120);
  EXPECT_EQ(counters.state(), BusState::error_warning);
  counters.transmit_error();
  EXPECT_EQ(counters.transmit(), 128);
  EXPECT_EQ(counters.state(), BusState::error_passive);
}

TEST(ErrorCounters, MakeAControllerErrorPassiveAtOneHundredAndTwentyEightReceiveErrors) {
  ErrorCounters counters;
  for (int i = 0; i < 127; ++i) counters.receive_error();
  EXPECT_EQ(counters.state(), BusState::error_warning);
  counters.receive_error();
  EXPECT_EQ(counters.state(), BusState::error_passive);
}

TEST(ErrorCounters, WarnFromNinetySixTransmitErrors) {
  ErrorCounters counters;
  transmit_errors(counters, 11);
  EXPECT_EQ(counters.transmit(), 88);
  EXPECT_EQ(counters.state(), BusState::error_active);
  counters.transmit_error();
  EXPECT_EQ(counters.transmit(), 96);
  EXPECT_EQ(counters.state(), BusState::error_warning);
  counters.transmitted();
  EXPECT_EQ(counters.state(), BusState::error_active);
}

TEST(ErrorCounters, WarnFromNinetySixReceiveErrors) {
  ErrorCounters counters;
  for (int i = 0; i < 95; ++i) counters.receive_error();
  EXPECT_EQ(counters.state(), BusState::error_active);
  counters.receive_error();
  EXPECT_EQ(counters.state(), BusState::error_warning);
  counters.received();
  EXPECT_EQ(counters.state(), BusState::error_active);
}

TEST(ErrorCounters, GoBusOffAtTwoHundredAndFiftySixTransmitErrorsOnly) {
  ErrorCounters counters;
  transmit_errors(counters, 31);
  EXPECT_EQ(counters.state(), BusState::error_passive);
  counters.transmit_error();
  EXPECT_EQ(counters.state(), BusState::bus_off);

  ErrorCounters receiver;
  for (int i = 0; i < 1000; ++i) receiver.receive_error_alone();
  EXPECT_EQ(receiver.state(), BusState::error_passive);
}

TEST(ErrorCounters, DoNotCountAMissingAcknowledgementWhenErrorPassive) {
  ErrorCounters counters;
  for (int i = 0; i < 1000; ++i) counters.acknowledgement_missing();
  EXPECT_EQ(counters.transmit(), 128);
  EXPECT_EQ(counters.state(), BusState::error_passive);
}

TEST(ErrorCounters, CountEightForTheReceiverThatSawTheErrorFirst) {
  ErrorCounters counters;
  counters.receive_error();
  counters.receive_error_alone();
  EXPECT_EQ(counters.receive(), 9);
}

TEST(ErrorCounters, CountDownByOneForEachFrameThatGoesWellButNotBelowZero) {
  ErrorCounters counters;
  counters.transmit_error();
  for (int i = 0; i < 7; ++i) counters.transmitted();
  EXPECT_EQ(counters.transmit(), 1);
  counters.transmitted();
  counters.transmitted();
  EXPECT_EQ(counters.transmit(), 0);
  counters.receive_error();
  counters.received();
  counters.received();
  EXPECT_EQ(counters.receive(), 0);
}

TEST(ErrorCounters, BringAnErrorPassiveReceiverBackWithOneGoodFrame) {
  ErrorCounters counters;
  for (int i = 0; i < 25; ++i) counters.receive_error_alone();
  ASSERT_EQ(counters.receive(), 200);
  counters.received();
  EXPECT_GE(counters.receive(), 119);
  EXPECT_LE(counters.receive(), 127);
  EXPECT_EQ(counters.state(), BusState::error_warning);
}

TEST(ErrorCounters, StandStillInBusOffUntilRestarted) {
  ErrorCounters counters;
  transmit_errors(counters, 40);
  EXPECT_EQ(counters.transmit(), 256);
  counters.transmitted();
  counters.receive_error();
  EXPECT_EQ(counters.state(), BusState::bus_off);
  EXPECT_EQ(counters.receive(), 0);
  counters.restart();
  EXPECT_EQ(counters.state(), BusState::error_active);
  EXPECT_EQ(counters.transmit(), 0);
}

}  // namespace
}  // namespace canvoy::fault_confinement_test
