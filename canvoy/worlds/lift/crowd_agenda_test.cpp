#include "canvoy/worlds/lift/crowd_agenda.hpp"

#include <gtest/gtest.h>

namespace canvoy::lift::crowd_agenda_test {
namespace {

TEST(CrowdAgendaTest, WhatIsDueComesByItsTimeAndOfOneTimeAsItWasPlanned) {
  CrowdAgenda sut;
  EXPECT_EQ(sut.deadline(), never);
  EXPECT_FALSE(sut.take(Time(1h)));
  sut.plan({.when = Time(3s), .who = 1});
  sut.plan({.when = Time(2s), .who = 2});
  sut.plan({.when = Time(3s), .who = 3});
  sut.plan({.when = Time(2s), .who = 4});
  EXPECT_EQ(sut.deadline(), Time(2s));
  EXPECT_FALSE(sut.take(Time(2s) - 1us));
  for (const PassengerId who : {2U, 4U, 1U, 3U}) {
    const auto due = sut.take(Time(3s));
    ASSERT_TRUE(due);
    EXPECT_EQ(due->who, who);
  }
  EXPECT_FALSE(sut.take(Time(3s)));
}

}  // namespace
}  // namespace canvoy::lift::crowd_agenda_test
