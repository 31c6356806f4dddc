// Every basic function and sub-function of 4.3.1 and 4.4.1 at a call controller: a table of what is
// answered. Records: basic function, sub-function, lifts, floor, doors, data.
#include <algorithm>
#include <cstdio>

#include "canvoy/devices/cia417/call/call_controller_test.hpp"

namespace canvoy::cia417::call_functions_test {
namespace {

class CallFunctionsTest : public CallControllerCable {
 protected:
  CallFunctionsTest() {
    cable.connect(0, device.node());
    start(1s);
  }

  CallControllerDevice<> device{
      cable.port(0), 1, {.lift = 1, .served = {FloorSet::between(1, 20)}}};
  CallController& calls = device.calls();
};

/// Answer to a press; empty: the function has no answer.
struct Row {
  const char* name;
  const char* press;
  const char* answer;
};
constexpr Row rows[] = {
    {"reserved", "00 01 01 03 10 01", ""},
    {"generic input: to be defined", "01 01 01 03 10 01", ""},
    {"standard hall call up", "02 01 01 03 10 01", "02 01 01 03 10 81"},
    {"standard hall call down", "02 02 01 03 10 01", "02 02 01 03 10 81"},
    {"standard hall call without direction", "02 03 01 03 10 01", "02 03 01 03 10 81"},
    {"low priority hall call", "03 01 01 03 10 01", "03 01 01 03 10 81"},
    {"high priority hall call", "04 01 01 03 10 01", "04 01 01 03 10 81"},
    {"standard car call", "05 09 01 00 11 01", "05 09 01 00 F1 81"},
    {"low priority car call", "06 09 01 00 11 01", "06 09 01 00 F1 81"},
    {"high priority car call", "07 09 01 00 11 01", "07 09 01 00 F1 81"},
    {"standard destination call", "08 09 01 03 11 01", "08 09 01 03 11 81"},
    {"low priority destination call", "09 09 01 03 11 01", "09 09 01 03 11 81"},
    {"high priority destination call", "0A 09 01 03 11 01", "0A 09 01 03 11 81"},
    {"standard call to destination floor", "0B 09 01 03 11 01", "0B 09 01 03 11 81"},
    {"low priority call to destination floor", "0C 09 01 03 11 01", "0C 09 01 03 11 81"},
    {"high priority call to destination floor", "0D 09 01 03 11 01", "0D 09 01 03 11 81"},
    {"special function, reserved", "0E 00 01 00 10 81", ""},
    {"fan 1", "0E 01 01 00 10 81", "0E 01 01 00 10 81"},
    {"fan 2", "0E 02 01 00 10 81", "0E 02 01 00 10 81"},
    {"load time 1", "0E 03 01 00 10 81", "0E 03 01 00 10 81"},
    {"load time 2", "0E 04 01 00 10 81", "0E 04 01 00 10 81"},
    {"key lock 1", "0E 05 01 00 10 81", "0E 05 01 00 10 81"},
    {"key lock 2", "0E 06 01 00 10 81", "0E 06 01 00 10 81"},
    {"key lock 3", "0E 07 01 00 10 81", "0E 07 01 00 10 81"},
    {"key lock 4", "0E 08 01 00 10 81", "0E 08 01 00 10 81"},
    {"door open", "0E 09 01 00 10 81", "0E 09 01 00 10 81"},
    {"door close", "0E 0A 01 00 10 81", "0E 0A 01 00 10 81"},
    {"fire service enable", "0E 0B 01 00 10 81", "0E 0B 01 00 10 81"},
    {"fire service", "0E 0C 01 00 10 81", "0E 0C 01 00 10 81"},
    {"hall call disable", "0E 0D 01 00 10 81", "0E 0D 01 00 10 81"},
    {"attendant service", "0E 0E 01 00 10 81", "0E 0E 01 00 10 81"},
    {"VIP service", "0E 0F 01 00 10 81", "0E 0F 01 00 10 81"},
    {"out of order", "0E 10 01 00 10 81", "0E 10 01 00 10 81"},
    {"bed passenger service", "0E 11 01 00 10 81", "0E 11 01 00 10 81"},
    {"special service", "0E 12 01 00 10 81", "0E 12 01 00 10 81"},
    {"service run", "0E 13 01 00 10 81", "0E 13 01 00 10 81"},
    {"dogging service enable", "0E 14 01 00 10 81", "0E 14 01 00 10 81"},
    {"dogging service up", "0E 15 01 00 10 81", "0E 15 01 00 10 81"},
    {"dogging service down", "0E 16 01 00 10 81", "0E 16 01 00 10 81"},
    {"special function, reserved", "0E 17 01 00 10 81", ""},
    {"access code upload, nobody has one", "0F 00 01 00 10 01", "0F 00 01 00 10 00"},
    {"speech connection, to nobody", "10 00 01 00 10 01", "10 00 01 00 10 00"},
    {"area monitoring connection, to nobody", "11 00 01 03 10 01", "11 00 01 03 10 00"},
    {"reserved", "12 00 01 00 10 01", ""},
    {"reserved", "7F 00 01 00 10 01", ""},
    {"manufacturer-specific", "80 00 01 00 10 01", ""}};

TEST_F(CallFunctionsTest, EachInputIsAnsweredAsTheTableSays) {
  for (const Row& row : rows) {
    const std::string answer = row.answer;
    const Texts expected = answer.empty() ? Texts{} : Texts{answer};
    EXPECT_EQ(answer_to(row.press), expected) << row.name;
    calls.cancel(all_calls);
    std::string released = row.press;
    released[released.size() - 1] = '0';
    answer_to(released);
    told();
  }
}

TEST_F(CallFunctionsTest, EachSpecialIndicationIsTold) {
  for (unsigned indication = 1; indication <= 0x0A; ++indication) {
    calls.display().specials = indication_bit(static_cast<SpecialIndication>(indication));
    calls.show();
    const Texts records = told();
    char shown[32];
    std::snprintf(shown, sizeof shown, "43 %02X 01 00 F0 01", indication);
    EXPECT_EQ(std::ranges::count(records, shown), 1) << "in the car";
    std::snprintf(shown, sizeof shown, "43 %02X 01 FF F0 01", indication);
    const bool is_of_car = indication == 1 || indication == 3 || indication == 6 || indication == 8;
    EXPECT_EQ(std::ranges::count(records, shown), is_of_car ? 0 : 1) << "at the floors";
  }
}

TEST_F(CallFunctionsTest, WhoHasConnectionsIsAskedAndAffirmsThem) {
  std::vector<BasicFunction> asked;
  auto connect = [&](const VirtualInput& input) {
    asked.push_back(input.function);
    return true;
  };
  calls.on_connection(Callback<bool(const VirtualInput&)>::of(connect));
  EXPECT_EQ(answer_to("0F 00 01 03 10 01"), (Texts{"0F 00 01 03 10 81"}));
  EXPECT_EQ(answer_to("0F 00 01 03 10 00"), Texts{}) << "the button is let go";
  EXPECT_EQ(answer_to("11 00 01 00 10 81"), (Texts{"11 00 01 00 10 81"}));
  EXPECT_EQ(answer_to("11 00 01 00 10 80"), (Texts{"11 00 01 00 10 00"})) << "a switch ends it";
  EXPECT_EQ(asked, (std::vector{BasicFunction::access_code_upload,
                                BasicFunction::area_monitoring_connection,
                                BasicFunction::area_monitoring_connection}));
  EXPECT_EQ(answer_to("11 00 01 00 10 82"), Texts{}) << "defective";
  EXPECT_EQ(calls.defective_inputs(), 1u);
}

TEST_F(CallFunctionsTest, WhileSomebodySpeaksToThoseInTheCarTheySeeThatHelpIsComing) {
  EXPECT_EQ(answer_to("10 00 01 00 10 01"), (Texts{"10 00 01 00 10 00"})) << "nobody is there yet";
  const VirtualInput alarm{.function = BasicFunction::speech_connection, .lifts = 1, .doors = 0x10};
  calls.connected(alarm, true);
  EXPECT_TRUE(calls.is_help_coming());
  EXPECT_EQ(told(), (Texts{"10 00 01 00 10 81", "43 06 01 00 F0 01"}));
  calls.connected(alarm, false);
  EXPECT_EQ(told(), (Texts{"10 00 01 00 10 00", "43 06 01 00 F0 00"}));
}

}  // namespace
}  // namespace canvoy::cia417::call_functions_test
