// Filters on frames of a bus: node 10 is a battery (CiA 418), node 5 a charger (CiA 419). Bytes and
// their meaning are typed from CiA 301, 418 and 419.
#include "canvoy/tools/filter/filter.hpp"

#include <gtest/gtest.h>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/profiles/cia418.hpp"
#include "canvoy/profiles/cia419.hpp"
#include "canvoy/text/frame_decoder.hpp"
#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools::filter_test {
namespace {

const FilterNames& names() {
  static const FilterNames made;
  return made;
}

class FilterTest : public testing::Test {
 protected:
  FilterTest() {
    decoder_.network().set_profile(10, cia418::profile);
    decoder_.network().set_profile(5, cia419::profile);
  }

  /// True if a frame in the format of candump passes.
  bool passes(std::string_view filter, std::string_view frame, Duration time = {},
              std::string_view bus = "can0") {
    Filter sut;
    sut.add(filter, names());
    const Frame parsed = parse_frame(frame).frame;
    const text::FrameWords& words = decoder_.decode(parsed);
    const Duration since_first = time - first_;
    return sut.passes({time, since_first, bus, parsed, words});
  }
  /// The error of a refused filter.
  static std::string refusal(std::string_view filter) {
    Filter sut;
    try {
      sut.add(filter, names());
    } catch (const UsageError& error) {
      return error.what();
    }
    return "it is taken";
  }

  static constexpr std::string_view warm = "18A#A00001";  // 20 °C, ready
  static constexpr std::string_view hot = "18A#480100";   // 41 °C, not ready
  static constexpr std::string_view charger = "185#01";   // ready
  static constexpr std::string_view heartbeat = "70A#05";
  text::FrameDecoder decoder_;
  Duration first_{};
};

TEST_F(FilterTest, WhatIsExcludedByBusCanIdServiceAndNodeIsKnownWithoutTheContent) {
  const auto may_pass = [this](std::string_view filter, std::string_view frame) {
    Filter sut;
    sut.add(filter, names());
    const Frame parsed = parse_frame(frame).frame;
    const text::FrameWords& words = decoder_.decode(parsed);
    const text::FrameWords known{
        .service = words.service, .node = words.node, .client = words.client};
    const bool may = sut.may_pass({{}, {}, "can0", parsed, known});
    if (passes(filter, frame)) EXPECT_TRUE(may) << filter << " " << frame;
    return may;
  };
  for (const char* filter :
       {"node=5", "id=70B", "service=EMCY", "bus=can1", "not heartbeat", "heartbeat and node=11",
        "node=5 or id=18A", "not (node=10 or SYNC)"}) {
    EXPECT_FALSE(may_pass(filter, heartbeat)) << filter;
  }
  for (const char* filter :
       {"node=10", "id=70A", "heartbeat", "bus!=can1", "text=stopped", "not text=operational",
        "marks and node=10", "time>5s", "temperature>40 or node=10"}) {
    EXPECT_TRUE(may_pass(filter, heartbeat)) << filter;
  }
  EXPECT_TRUE(may_pass("id=0000018A", "00000001#")) << "any CAN-ID of 29 bits";
  EXPECT_TRUE(may_pass("temperature>40", warm)) << "values are not looked at";
}

TEST_F(FilterTest, WhatIsExcludedByItsTimeIsKnownWithoutTheContent) {
  const auto may_pass = [](std::string_view filter, Duration from, Duration to) {
    Filter sut;
    sut.add(filter, names());
    return sut.may_pass(from, to, Duration(100s));
  };
  EXPECT_TRUE(may_pass("time=10s..20s", 110s, 111s)) << "since the first frame at 100 s";
  EXPECT_TRUE(may_pass("time=10s..20s", 119s, 130s));
  EXPECT_FALSE(may_pass("time=10s..20s", 121s, 130s));
  EXPECT_FALSE(may_pass("not time=10s..20s", 112s, 118s));
  EXPECT_TRUE(may_pass("not time=10s..20s", 112s, 121s));
  EXPECT_FALSE(may_pass("time>=1700000000.5 and heartbeat", 110s, 111s)) << "since 1970";
  EXPECT_TRUE(may_pass("heartbeat", 110s, 111s));
}

TEST_F(FilterTest, BusesAreTakenAsTheyAreWritten) {
  EXPECT_TRUE(passes("bus=can0", warm));
  EXPECT_FALSE(passes("bus=can1", warm));
  EXPECT_TRUE(passes("bus=can1,can0", warm));
  EXPECT_FALSE(passes("bus=CAN0", warm)) << "interfaces of Linux differ by case";
  EXPECT_FALSE(passes("bus!=can0", warm));
  EXPECT_TRUE(passes("bus=udp:239.74.163.2:43113", warm, {}, "udp:239.74.163.2:43113"));
}

TEST_F(FilterTest, NodesAreDecimalOrHexadecimalAsTheyArePrinted) {
  for (const char* filter : {"node=10", "node=0Ah", "node=0x0A", "node=0ah", "node=5..10",
                             "node=1,10", "node>9", "node>=10", "node<11", "NODE == 10"}) {
    EXPECT_TRUE(passes(filter, warm)) << filter;
    EXPECT_FALSE(passes(std::string("not ") + filter, warm)) << filter;
  }
  EXPECT_FALSE(passes("node=5", warm));
  EXPECT_FALSE(passes("node!=10", warm));
  EXPECT_FALSE(passes("node>=1", "000#0100")) << "NMT has no node of its own";
  EXPECT_TRUE(passes("node!=10", "080#"));
}

TEST_F(FilterTest, CanIdsAreHexadecimal) {
  EXPECT_TRUE(passes("id=18A", warm));
  EXPECT_TRUE(passes("id=18Ah", warm));
  EXPECT_TRUE(passes("id=0x18a", warm));
  EXPECT_TRUE(passes("id=180..1FF", warm));
  EXPECT_TRUE(passes("id>189 and id<=18A", warm));
  EXPECT_FALSE(passes("id=180..189,18B..1FF", warm));
  EXPECT_FALSE(passes("id=0000018A", warm)) << "of 29 bits";
  EXPECT_TRUE(passes("id=0000018A", "0000018A#A00001"));
  EXPECT_FALSE(passes("id=18A", "0000018A#A00001"));
}

/// As candump chooses frames: those with `id & mask == number & mask`.
TEST_F(FilterTest, CanIdsAreChosenByAMask) {
  EXPECT_TRUE(passes("id=180:780", warm));
  EXPECT_TRUE(passes("id=1FF:780", warm));
  EXPECT_TRUE(passes("id=00A:07F", warm)) << "any frame of node 10";
  EXPECT_TRUE(passes("id=18A:7FF", warm));
  EXPECT_TRUE(passes("id=18A:C00007FF", warm)) << "bits of the kernel's identifier are left out";
  EXPECT_TRUE(passes("id=0:0", warm));
  EXPECT_FALSE(passes("id=00B:07F", warm));
  EXPECT_FALSE(passes("id=18B:7FF", warm));
  EXPECT_FALSE(passes("id=200:780,700:780", warm));
  EXPECT_TRUE(passes("id=200:780,180:780", warm));
  EXPECT_FALSE(passes("id!=180:780", warm));
  EXPECT_FALSE(passes("id=00000000:00000000", warm)) << "of 29 bits";
  EXPECT_TRUE(passes("id=00000100:00FFFF00", "0000018A#A00001"));
  EXPECT_EQ(refusal("id>180:780"),
            "filter 'id>180:780', character 4: a mask is written id=180:780");
  EXPECT_EQ(refusal("id=10000001:10000001"),
            "filter 'id=10000001:10000001', character 4: the mask leaves out too many bits between "
            "those that it has");
}

TEST_F(FilterTest, AnIdentifierAloneIsACanId) {
  for (const char* filter : {"18A", "0x18A", "18a", "18A:7FF", "18A or 70A", "not 18B"}) {
    EXPECT_TRUE(passes(filter, warm)) << filter;
  }
  EXPECT_FALSE(passes("18B", warm));
  EXPECT_FALSE(passes("0000018A", warm)) << "of 29 bits";
  EXPECT_TRUE(passes("id>7FF", "00000001#"));
  EXPECT_FALSE(passes("id>=0", "20000040#0000000000000000")) << "an error frame has none";
  EXPECT_TRUE(passes("id!=18A", "20000040#0000000000000000"));
}

TEST_F(FilterTest, ServicesAreFoundByAPartOfTheirName) {
  EXPECT_TRUE(passes("service=TPDO1", warm));
  EXPECT_TRUE(passes("service=pdo", warm));
  EXPECT_TRUE(passes("service=\"SDO request\"", "60A#4000100000000000"));
  EXPECT_TRUE(passes("service=SDO_request", "60A#4000100000000000"));
  EXPECT_TRUE(passes("service=SDO", "58A#43001000A2010000"));
  EXPECT_FALSE(passes("service=SDO", warm));
  EXPECT_FALSE(passes("service=TPDO", heartbeat));
  EXPECT_TRUE(passes("service=heartbeat,EMCY", heartbeat));
  EXPECT_TRUE(passes("service!=SDO", heartbeat));
  EXPECT_TRUE(passes("heartbeat", heartbeat)) << "alone, too";
  EXPECT_TRUE(passes("sdo", "60A#4000100000000000"));
  EXPECT_TRUE(passes("error frame", "20000040#0000000000000000"));
}

TEST_F(FilterTest, ANumberIsNoPartOfAnother) {
  EXPECT_TRUE(has_name("tpdo12", "tpdo12"));
  EXPECT_FALSE(has_name("tpdo12", "tpdo1"));
  EXPECT_FALSE(has_name("input group 12, virtual input 3", "2, virtual"));
  EXPECT_TRUE(has_name("input group 12, input group 1", "input group 1"));
}

TEST_F(FilterTest, ObjectsAreFoundByNumberNameAndPartOfAName) {
  for (const char* filter :
       {"object=6010", "object=6010h", "object=0x6010", "object=6010:00", "object=6010h:00h",
        "object=6010:0", "object=6000..601F", "object=temperature", "object=Temperature",
        "object=temper", "temperature", "\"temperature\"", "6010h", "object=battery_status",
        "battery status", "object = battery-status"}) {
    EXPECT_TRUE(passes(filter, warm)) << filter;
    EXPECT_FALSE(passes(filter, heartbeat)) << filter;
  }
  EXPECT_FALSE(passes("object=6010:01", warm));
  EXPECT_FALSE(passes("object=6011", warm));
  EXPECT_FALSE(passes("object=vehicle_serial_number", warm));
  EXPECT_TRUE(passes("object=6999", "58A#4B99690005000000")) << "no profile knows it";
}

/// Requests, confirmations and aborts have the entry in bytes 1 to 3 (CiA 301, 7.2.4.3).
TEST_F(FilterTest, ObjectsAreNamedByMessagesOfSdoWithoutAValue) {
  for (const char* frame : {"60A#4010600000000000", "58A#8010600002000106", "60A#8010600000000405",
                            "60A#2F10600001000000", "58A#6010600000000000"}) {
    for (const char* filter : {"6010h", "object=6010:00", "object=6000..60FF", "temperature"}) {
      EXPECT_TRUE(passes(filter, frame)) << filter << ' ' << frame;
    }
    for (const char* filter : {"6010:01", "6011h", "not 6010h", "battery_status"}) {
      EXPECT_FALSE(passes(filter, frame)) << filter << ' ' << frame;
    }
  }
  EXPECT_FALSE(passes("temperature<1000", "60A#4010600000000000")) << "no value is in it";
  EXPECT_FALSE(passes("temperature!=1000", "58A#8010600002000106"));
  EXPECT_TRUE(passes("6999h", "60A#4099690000000000")) << "no profile knows it";
}

/// Segments and blocks do not contain the entry (CiA 301, 7.2.4.3.5 to 7.2.4.3.15).
TEST_F(FilterTest, SegmentsAndBlocksAreOfTheObjectOfTheirTransfer) {
  const auto all_pass = [&](std::initializer_list<const char*> frames) {
    for (const char* frame : frames) EXPECT_TRUE(passes("1008h", frame)) << frame;
  };
  EXPECT_FALSE(passes("1008h", "58A#0043616E766F7920")) << "its beginning was not heard";
  all_pass({"60A#4008100000000000", "58A#410810000A000000", "60A#6000000000000000",
            "58A#0043616E766F7920", "60A#7000000000000000", "58A#1942434400000000"});
  EXPECT_FALSE(passes("1008h", "60A#6000000000000000")) << "the transfer has ended";
  all_pass({"60A#A40810007F000000", "58A#C608100009000000", "60A#A300000000000000",
            "58A#0131323334353637", "58A#8238390000000000", "60A#A2027F0000000000",
            "58A#D5C3310000000000", "60A#A100000000000000"});
  all_pass({"60A#C608100009000000", "58A#A40810007F000000", "60A#0131323334353637",
            "60A#8238390000000000", "58A#A202000000000000", "60A#D5C3310000000000",
            "58A#A100000000000000"});
  EXPECT_FALSE(passes("1008h", "60A#A300000000000000")) << "the next one began unheard";
  EXPECT_FALSE(passes("1008h", "58A#0131323334353637"));
}

TEST_F(FilterTest, EntriesAreFoundAsTheyArePrintedAndWithAColon) {
  constexpr std::string_view vendor = "58A#43181001F0020000";  // 1018h:01h Identity object
  for (const char* filter : {"object=Identity", "object=\"Identity object, Vendor-ID\"",
                             "Identity object, Vendor-ID = 2F0h", "identity_object:vendor_id",
                             "vendor id", "1018:01", "1018h:01h = 0x2F0"}) {
    EXPECT_TRUE(passes(filter, vendor)) << filter;
  }
}

TEST_F(FilterTest, ValuesAreComparedInTheirUnit) {
  EXPECT_TRUE(passes("temperature>40", hot));
  EXPECT_FALSE(passes("temperature>40", warm));
  EXPECT_TRUE(passes("temperature>=41", hot));
  EXPECT_FALSE(passes("temperature>41", hot));
  EXPECT_TRUE(passes("temperature>40degC", hot));
  EXPECT_TRUE(passes("temperature > 40 °C", hot));
  EXPECT_TRUE(passes("temperature=20.000 °C", warm)) << "as it is printed";
  EXPECT_TRUE(passes("temperature=19..20.5degC", warm));
  EXPECT_FALSE(passes("temperature=19..19.9", warm));
  EXPECT_TRUE(passes("temperature=1,20", warm));
  EXPECT_TRUE(passes("temperature!=41", warm));
  EXPECT_FALSE(passes("temperature!=41", hot));
  EXPECT_FALSE(passes("temperature!=41", heartbeat)) << "there is none";
  EXPECT_TRUE(passes("not temperature=41", heartbeat));
  EXPECT_TRUE(passes("6010h<-1", "18A#F7FF00"));
  EXPECT_FALSE(passes("6010h<-1", "18A#F8FF00")) << "-1 °C is not below";
}

TEST_F(FilterTest, ANumberThatSaysThatThereIsNoneIsNone) {
  constexpr std::string_view none = "18A#FFFF01";
  EXPECT_FALSE(passes("temperature>-40", none));
  EXPECT_FALSE(passes("temperature<40", none));
  EXPECT_TRUE(passes("temperature=invalid", none));
}

TEST_F(FilterTest, UnitsAreConverted) {
  constexpr std::string_view voltage = "28A#A000018FBE0000";  // 47.6396 V in steps of 1/1024 V
  EXPECT_TRUE(passes("battery_voltage>47600mV", voltage));
  EXPECT_FALSE(passes("battery_voltage>47700mV", voltage));
  EXPECT_TRUE(passes("battery_voltage=0.0476..0.0477kV", voltage));
  EXPECT_TRUE(passes("battery_voltage=47600mV..47.7V", voltage));
}

TEST_F(FilterTest, StatesAreComparedByNameAndByNumber) {
  EXPECT_TRUE(passes("battery_status=ready", warm));
  EXPECT_TRUE(passes("battery_status=\"not ready\"", hot));
  EXPECT_TRUE(passes("battery_status=not_ready", hot));
  EXPECT_FALSE(passes("battery_status=ready", hot));
  EXPECT_TRUE(passes("battery_status!=ready", hot));
  EXPECT_TRUE(passes("battery_status=1", warm));
  EXPECT_TRUE(passes("battery_status=1", "28A#A000018FBE0000"));
}

TEST_F(FilterTest, RawNumbersAreHexadecimal) {
  EXPECT_TRUE(passes("temperature=0xA0", warm));
  EXPECT_TRUE(passes("temperature=A0h", warm));
  EXPECT_TRUE(passes("temperature>=0x90", warm));
  EXPECT_FALSE(passes("temperature<0xA0", warm));
  EXPECT_TRUE(passes("6999h=0x605", "58A#4B99690005060000"));
  EXPECT_TRUE(passes("6999h=1541", "58A#4B99690005060000"));
}

TEST_F(FilterTest, TextsAreComparedWhole) {
  constexpr std::string_view text = "585#4F08100041000000";  // 1008h, "A"
  EXPECT_TRUE(passes("1008h=A", text));
  EXPECT_TRUE(passes("1008h=\"A\"", text));
  EXPECT_FALSE(passes("1008h=B", text));
}

TEST_F(FilterTest, CodesAreNoAmounts) {
  // 1A00h:01h maps 6010h: the entry is "temperature" (CiA 418).
  constexpr std::string_view mapping = "58A#43001A0110001060";
  EXPECT_TRUE(passes("object=temperature", mapping));
  EXPECT_FALSE(passes("temperature>40", mapping));
  EXPECT_TRUE(passes("1A00h:01h = 60100010h", mapping));
}

TEST_F(FilterTest, TimeIsSinceTheFirstFrameOrAsLinesHaveIt) {
  first_ = 1'700'000'000s;
  const Duration later = first_ + 90min;
  EXPECT_TRUE(passes("time=1h30min", warm, later));
  EXPECT_TRUE(passes("time>1h 29min and time<1h31min", warm, later));
  EXPECT_TRUE(passes("time=10s..2h", warm, later));
  EXPECT_FALSE(passes("time<=10s", warm, later));
  EXPECT_TRUE(passes("time<=10s", warm, first_));
  EXPECT_TRUE(passes("time=1700005400", warm, later));
  EXPECT_TRUE(passes("time>1700005399.999999", warm, later));
  EXPECT_FALSE(passes("time>1700005400.000000", warm, later));
  // 1700000000 is 14 November 2023, 22:13:20 UTC.
  EXPECT_TRUE(passes("time=2023-11-14 22:13:20..2023-11-14 22:13:21", warm, first_));
  EXPECT_FALSE(passes("time>2023-11-14 22:13:20", warm, first_));
}

TEST_F(FilterTest, MarksAreAnyOrOneOfThem) {
  constexpr std::string_view marked = "185#02";  // reserved (CiA 419, 6000h)
  EXPECT_TRUE(passes("marks", marked));
  EXPECT_TRUE(passes("mark", marked));
  EXPECT_TRUE(passes("marks=reserved", marked));
  EXPECT_TRUE(passes("marks=\"out of range\",reserved", marked));
  EXPECT_FALSE(passes("marks=out_of_range", marked));
  EXPECT_FALSE(passes("marks", charger));
  EXPECT_TRUE(passes("not marks", charger));
}

TEST_F(FilterTest, TextsAreLookedForInWhatTheLineSays) {
  EXPECT_TRUE(passes("text=bus-off", "20000040#0000000000000000"));
  EXPECT_TRUE(passes("text=BUS_OFF,passive", "20000004#0020000000000000"));
  EXPECT_FALSE(passes("text=bus-off", warm));
  EXPECT_FALSE(passes("text!=ready", warm));
  EXPECT_TRUE(passes("text=\"operational\"", heartbeat));
}

TEST_F(FilterTest, AndBindsMoreThanOrAndParenthesesMost) {
  EXPECT_TRUE(passes("node=10 or node=5 and heartbeat", warm));
  EXPECT_FALSE(passes("(node=10 or node=5) and heartbeat", warm));
  EXPECT_TRUE(passes("node=10 || node=5 && heartbeat", warm));
  EXPECT_TRUE(passes("NOT node=5 AND !(heartbeat)", warm));
  EXPECT_FALSE(passes("not (node=10 or node=5)", warm));
  EXPECT_TRUE(passes("not not node=10", warm));
  EXPECT_FALSE(passes("not node=10 and node=10 or heartbeat", warm));
}

TEST_F(FilterTest, SeveralHaveToHoldAll) {
  Filter sut;
  sut.add("node=10", names());
  sut.add("heartbeat or temperature", names());
  const Frame frame = parse_frame(charger).frame;
  EXPECT_FALSE(sut.passes({{}, {}, "can0", frame, decoder_.decode(frame)}));
  const Frame other = parse_frame(heartbeat).frame;
  EXPECT_TRUE(sut.passes({{}, {}, "can0", other, decoder_.decode(other)}));
  EXPECT_EQ(sut.seen(), 2U);
  EXPECT_EQ(sut.passed(), 1U);
}

TEST_F(FilterTest, TellsWhichConditionsNeverHeld) {
  Filter sut;
  sut.add("node=10 and temperature > 90 or id=7FF", names());
  const Frame frame = parse_frame(warm).frame;
  EXPECT_FALSE(sut.passes({{}, {}, "can0", frame, decoder_.decode(frame)}));
  EXPECT_EQ(sut.never_true(), (std::vector<std::string_view>{"temperature > 90", "id=7FF"}));
}

TEST_F(FilterTest, WhatHeldForAnotherFrameIsNotCalledNeverTrue) {
  Filter sut;
  sut.add("node=5 and temperature>10", names());
  for (const std::string_view text : {charger, warm}) {
    const Frame frame = parse_frame(text).frame;
    EXPECT_FALSE(sut.passes({{}, {}, "can0", frame, decoder_.decode(frame)}));
  }
  EXPECT_TRUE(sut.never_true().empty()) << "but never both of them";
}

TEST_F(FilterTest, AnErrorSaysWhereAndWhatMayHaveBeenMeant) {
  EXPECT_EQ(refusal("node=10 and tempersture>40"),
            "filter 'node=10 and tempersture>40', character 13: no object is called "
            "'tempersture'; did you mean 'temperature'?");
  EXPECT_EQ(refusal("°=1 and node=0"),
            "filter '°=1 and node=0', character 1: no object is called '°'")
      << "characters are counted, not bytes";
  EXPECT_EQ(refusal("battery_status=raedy"),
            "filter 'battery_status=raedy', character 16: no value of 'battery_status' is called "
            "'raedy'; did you mean 'ready'?");
  EXPECT_EQ(refusal("service=hartbeat"),
            "filter 'service=hartbeat', character 9: no service is called 'hartbeat'; did you mean "
            "'heartbeat'?");
  EXPECT_EQ(refusal("marks=reservd"),
            "filter 'marks=reservd', character 7: no mark is called 'reservd'; did you mean "
            "'reserved'?");
  EXPECT_EQ(refusal("temperature>40degF"),
            "filter 'temperature>40degF', character 13: 'degF' is no unit; did you mean 'degC'?");
  EXPECT_EQ(refusal("temperature>40V"),
            "filter 'temperature>40V', character 13: 'temperature' is not in V, but in °C");
  EXPECT_EQ(refusal("serivce=SDO"),
            "filter 'serivce=SDO', character 1: no object is called 'serivce'; did you mean "
            "'service'?");
}

TEST_F(FilterTest, WhatCannotBeReadIsRefusedWithItsPlace) {
  const auto expect = [](const char* filter, const char* place, const char* reason) {
    const std::string said = refusal(filter);
    EXPECT_NE(said.find(place), std::string::npos) << said;
    EXPECT_NE(said.find(reason), std::string::npos) << said;
  };
  expect("", "character 1:", "empty");
  expect("   ", "character 4:", "empty");
  expect("(node=1", "character 1:", "is not closed");
  expect("node=1)", "character 7:", "was not opened");
  expect("node=1 and", "character 11:", "a condition is expected");
  expect("node=", "character 6:", "a value is expected");
  expect("=5", "character 1:", "a condition is expected");
  expect("node=5 bus=can0", "character 8:", "'and' or 'or' is missing");
  expect("node=0", "character 6:", "1 to 127");
  expect("node=128", "character 6:", "1 to 127");
  expect("node=5..1", "character 6:", "ends before it begins");
  expect("node>1..5", "character 6:", "one value");
  expect("node", "character 1:", "write node=5");
  expect("id=20000000", "character 4:", "is no CAN-ID");
  expect("id=xyz", "character 4:", "is no CAN-ID");
  expect("bus>can0", "character 1:", "write bus=can0");
  expect("time=soon", "character 6:", "is no time");
  expect("time=10s..1700000000", "character 11:", "mixed");
  expect("object=6000..name", "character 8:", "from one index to another");
  expect("temperature=\"20", "character 13:", "has no end");
  expect("temperature<ready", "character 13:", "'ready'");
  expect("temperature=40..20", "character 13:", "ends before it begins");
  expect("temperature=40degC..50V", "character 21:", "V");
  expect("node=1 (heartbeat)", "character 8:", "does not belong here");
}

TEST_F(FilterTest, WhatCanHoldForNoFrameIsRefused) {
  for (const char* filter :
       {"bus=can0 and bus=can1", "bus=can0 and not bus=can0", "id=18A and id=18B",
        "id<100 and id>200", "time>10s and time<5s", "service=SDO and service=EMCY",
        "heartbeat and temperature", "node=5 and service=SYNC", "id=18A and error frame",
        "node=5 and (id=18A and id=18B)", "(bus=can0 or bus=can1) and bus=can2",
        "not (bus=can0 or node=5) and bus=can0", "not (not heartbeat or not EMCY)",
        "6010h>40 and 6010h<30 and 6010h:00h > 20 and 6010h:00h < 10",
        "vehicle_serial_number and heartbeat"}) {
    EXPECT_NE(refusal(filter).find("no frame can pass"), std::string::npos) << filter;
  }
  EXPECT_NE(refusal("node<1").find("is never so"), std::string::npos);
}

TEST_F(FilterTest, WhatCanHoldIsNotTakenForAContradiction) {
  for (const char* filter :
       {"node=5 and node=10",                 // the client and the server of an SDO
        "temperature>40 and temperature<30",  // of two batteries in one frame
        "bus=can0 or bus=can1", "not bus=can0 and not bus=can1", "id!=18A and id!=18B",
        "time>5s and time<10s", "service=SDO and service=request", "not heartbeat",
        "id>100 and id<200 and node=5", "error frame and not id=18A", "time>10s or time<5s"}) {
    EXPECT_EQ(refusal(filter), "it is taken") << filter;
  }
}

TEST_F(FilterTest, WhatIsBeyondBoundsIsRefusedNotFollowed) {
  EXPECT_EQ(refusal(std::string(60, '(') + "heartbeat" + std::string(60, ')')), "it is taken");
  EXPECT_NE(refusal(std::string(2000, '(')).find("more than 64"), std::string::npos);
  std::string denied;
  for (int i = 0; i < 1000; ++i) denied += "not ";
  EXPECT_NE(refusal(denied + "heartbeat").find("more than 64"), std::string::npos);
  EXPECT_NE(refusal(std::string(5000, 'x')).find("4096"), std::string::npos);
  std::string many = "heartbeat";
  for (int i = 0; i < 64; ++i) many += " or heartbeat";
  EXPECT_NE(refusal(many).find("at most 64 conditions"), std::string::npos);
}

}  // namespace
}  // namespace canvoy::tools::filter_test
