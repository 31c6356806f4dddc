// A device that shows a text on a terminal, at its wire (CiA 447-3, 4.2.9.17 to 4.2.9.26): node 5
// asks node 6 on 345h and is answered on 2C5h.
#include "canvoy/devices/cia447/terminal/display_writer.hpp"

#include <gtest/gtest.h>

#include <optional>

#include "canvoy/devices/cia447/car_bench_test.hpp"
#include "canvoy/devices/cia447/taxi_alarm/taxi_alarm_unit.hpp"

namespace canvoy::cia447::display_writer_test {
namespace {

class Writer : public testing::Test {
 public:
  Writer()
      : bench_(only_unit<TaxiAlarmKind>, [this](Site& site) {
          site.watch(Callback<void(CarNetwork&, Node&)>::to<&Writer::made>(*this));
        }) {
    bench_.cable.run_for(2s);
    bench_.cable.clear();
  }
  /// Its client has a timer of the node.
  ~Writer() override { writer_.reset(); }

  void show(const char* text) {
    writer_->show(text);
    bench_.cable.run_for(1ms);
  }
  std::string asked() { return bench_.cable.last(0x345); }
  void answer(const char* data) { bench_.cable.send(std::string("2C5#") + data); }
  Cable& cable() { return bench_.cable; }
  DisplayWriter& writer() { return *writer_; }

 private:
  void made(CarNetwork& network, Node& /*node*/) {
    writer_.emplace(network, DisplayWriter::Settings{.terminal = 6, .display = display});
  }

  static constexpr TerminalDisplay display = TerminalDisplay::display_1;
  std::optional<DisplayWriter> writer_;
  CarBench bench_;
};

constexpr const char* lock = "345#2F 98 60 00 FD 00 00 00";
constexpr const char* locked = "60 98 60 00 00 00 00 00";
constexpr const char* release = "345#2F 98 60 00 FC 00 00 00";
constexpr const char* abc = "345#27 99 60 00 61 62 63 00";
constexpr const char* text_taken = "60 99 60 00 00 00 00 00";

TEST_F(Writer, LocksTheDisplayAndWritesItsText) {
  show("abc");
  EXPECT_EQ(asked(), lock);
  EXPECT_FALSE(writer().is_shown());
  answer(locked);
  cable().run_for(1ms);
  EXPECT_EQ(asked(), abc);
  answer(text_taken);
  EXPECT_TRUE(writer().is_shown());
  cable().clear();
  cable().run_for(1s);
  EXPECT_EQ(asked(), "") << "all is said";
  show("ab");
  EXPECT_EQ(asked(), "345#2B 99 60 00 61 62 00 00") << "it is still locked";
}

/// It may have heard nothing of this device for three seconds, and this device of it: one of the
/// two frames came in time.
TEST_F(Writer, TellsItAnewSinceATerminalMayHaveLostItsHolder) {
  show("abc");
  answer(locked);
  cable().run_for(1ms);
  answer(text_taken);
  cable().clear();
  cable().run_for(1999ms);
  EXPECT_EQ(asked(), "");
  cable().run_for(1ms);
  EXPECT_EQ(asked(), lock);
  answer(locked);
  cable().run_for(1ms);
  EXPECT_EQ(asked(), abc);
}

TEST_F(Writer, AsksForNothingWhereThereIsNothingToShow) {
  cable().run_for(10s);
  EXPECT_EQ(asked(), "") << "another device may have the display";
}

TEST_F(Writer, GivesItBackWithAnEmptyText) {
  show("abc");
  answer(locked);
  cable().run_for(1ms);
  answer(text_taken);
  show("");
  EXPECT_EQ(asked(), release);
  answer(locked);
  EXPECT_TRUE(writer().is_shown());
  show("abc");
  EXPECT_EQ(asked(), lock);
}

TEST_F(Writer, AsksAgainWhileAnotherHasIt) {
  show("abc");
  answer("80 98 60 00 22 00 00 08");
  cable().clear();
  cable().run_for(1900ms);
  EXPECT_EQ(asked(), "");
  cable().run_for(100ms);
  EXPECT_EQ(asked(), lock);
  answer(locked);
  cable().run_for(1ms);
  cable().send("706#05");  // it is there
  // The text is refused: somebody has taken it away.
  answer("80 99 60 00 22 00 00 08");
  cable().run_for(2s);
  EXPECT_EQ(asked(), lock);
}

TEST_F(Writer, ATerminalThatBootsIsToldAnew) {
  cable().send("706#05");
  show("abc");
  answer(locked);
  cable().run_for(1ms);
  answer(text_taken);
  cable().clear();
  cable().send("706#00");
  cable().run_for(2s);
  EXPECT_EQ(asked(), lock);
  answer(locked);
  cable().run_for(1ms);
  EXPECT_EQ(asked(), abc);
}

TEST_F(Writer, ATextThatChangesOnTheWayIsWrittenAsItIsThen) {
  show("abc");
  show("ab");
  answer(locked);
  cable().run_for(1ms);
  EXPECT_EQ(asked(), "345#2B 99 60 00 61 62 00 00");
  show("a");
  EXPECT_EQ(asked(), "345#2B 99 60 00 61 62 00 00") << "one at a time";
  answer(text_taken);
  cable().run_for(1ms);
  EXPECT_EQ(asked(), "345#2F 99 60 00 61 00 00 00");
}

}  // namespace
}  // namespace canvoy::cia447::display_writer_test
