// A client that reads a trip of one moment, at the wire: it is node 5, and reads node 2.
#include "canvoy/devices/cia447/taximeter/trip_reader.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "canvoy/devices/cia447/kit/car_bench_test.hpp"
#include "canvoy/devices/cia447/printer/printer_unit.hpp"

namespace canvoy::cia447::trip_reader_test {
namespace {

/// Values of a meter, as answered by SDO; missing ones do not exist (0602 0000h).
using Objects = std::map<std::pair<std::uint16_t, std::uint8_t>, std::string>;

const Objects whole_trip = {
    {{0x60DB, 0}, "4F DB 60 00 07 00 00 00"}, {{0x60D0, 1}, "43 D0 60 01 68 42 00 00"},
    {{0x60D0, 2}, "43 D0 60 02 E8 03 00 00"}, {{0x60D0, 3}, "43 D0 60 03 50 46 00 00"},
    {{0x60D0, 4}, "43 D0 60 04 01 00 00 00"}, {{0x60D0, 5}, "43 D0 60 05 3C 0F 00 00"},
    {{0x60D0, 6}, "43 D0 60 06 3D 0F 00 00"}, {{0x60D1, 0}, "43 D1 60 00 10 27 00 00"},
    {{0x60D2, 1}, "43 D2 60 01 58 02 00 00"}, {{0x60D2, 2}, "43 D2 60 02 3C 00 00 00"},
    {{0x60D2, 3}, "43 D2 60 03 00 00 00 6A"}, {{0x60D2, 4}, "43 D2 60 04 58 02 00 6A"},
    {{0x60D3, 0}, "4B D3 60 00 31 41 00 00"}, {{0x60D4, 1}, "43 D4 60 01 E8 80 00 00"},
    {{0x60D4, 2}, "43 D4 60 02 FC 08 00 00"}};

/// "40 DB 60 00": index and sub-index of an upload.
std::pair<std::uint16_t, std::uint8_t> asked(const Frame& request) {
  return {static_cast<std::uint16_t>(request.data[1] | request.data[2] << 8), request.data[3]};
}

class TripReaderWire : public testing::Test {
 protected:
  TripReaderWire()
      : bench(only_unit<PrinterKind>, [this](Environment& environment) {
          environment.watch(callback<&TripReaderWire::made>(*this));
        }) {}
  ~TripReaderWire() override { reader.reset(); }  // before the bench, which it uses

  /// The meter answers until there are no requests; each request is counted.
  void answer() {
    while (true) {
      std::optional<Frame> request;
      for (const Cable::Heard& heard : bench.cable.heard) {
        if (heard.frame.id == sdo_request(5, 2)) request = heard.frame;
      }
      if (!request) return;
      ++requests;
      bench.cable.clear();
      const auto found = objects.find(asked(*request));
      char absent[48];
      std::snprintf(absent, sizeof absent, "80 %02X %02X %02X 00 00 02 06", request->data[1],
                    request->data[2], request->data[3]);
      const std::string answered = found == objects.end() ? absent : found->second;
      before_answer(requests);
      char id[8];
      std::snprintf(id, sizeof id, "%03X#", static_cast<unsigned>(sdo_response(5, 2)));
      bench.cable.send(id + answered);
    }
  }
  void read() {
    requests = calls = 0;
    bench.cable.clear();
    reader->read();
    bench.cable.run_for(0s);
    answer();
  }

  Objects objects = whole_trip;
  std::function<void(unsigned)> before_answer = [](unsigned) {};
  std::optional<TripReader> reader;
  unsigned requests = 0;
  unsigned calls = 0;
  std::optional<TripData> last;
  CarBench bench;

 private:
  void made(CarNetwork& network, Node& /*node*/) {
    reader.emplace(network, 2, TripReader::Done::to<&TripReaderWire::came>(*this));
  }
  void came(const TripData* trip) {
    ++calls;
    last = trip != nullptr ? std::optional(*trip) : std::nullopt;
  }
};

TEST_F(TripReaderWire, ReadsAllThatAMeterTells) {
  read();
  EXPECT_EQ(calls, 1u);
  EXPECT_EQ(requests, 16u) << "fourteen values between the counter and the counter";
  ASSERT_TRUE(last);
  EXPECT_EQ(*last, (TripData{.fare = 17'000,
                             .supplements = 1000,
                             .total = 18'000,
                             .mode = FareMode::double_calculation,
                             .minimum_fare = 3900,
                             .initial_fare = 3901,
                             .distance = 10'000,
                             .duration = 600,
                             .waiting = 60,
                             .start = 0x6A00'0000,
                             .finish = 0x6A00'0258,
                             .level = {'1', 'A'},
                             .time_rate = 33'000,
                             .distance_rate = 2300}));
  EXPECT_FALSE(reader->is_reading());
}

TEST_F(TripReaderWire, ReadsAgainWhatHasChangedMeanwhile) {
  before_answer = [this](unsigned request) {
    if (request != 3) return;
    objects[{0x60DB, 0}] = "4F DB 60 00 08 00 00 00";
    objects[{0x60D0, 1}] = "43 D0 60 01 CC 42 00 00";
  };
  read();
  EXPECT_EQ(calls, 1u);
  EXPECT_EQ(requests, 32u);
  ASSERT_TRUE(last);
  EXPECT_EQ(last->fare, 17'100u);
}

TEST_F(TripReaderWire, GivesUpWhereItChangesFasterThanItIsRead) {
  before_answer = [this](unsigned request) {
    char text[32];
    std::snprintf(text, sizeof text, "4F DB 60 00 %02X 00 00 00", request);
    objects[{0x60DB, 0}] = text;
  };
  read();
  EXPECT_EQ(calls, 1u);
  EXPECT_FALSE(last);
  EXPECT_EQ(requests, 5u * 16u);
}

TEST_F(TripReaderWire, WhatAMeterLacksIsUnknown) {
  objects.erase({0x60D4, 1});
  objects.erase({0x60D3, 0});
  read();
  ASSERT_TRUE(last);
  EXPECT_EQ(last->time_rate, TripData::unknown);
  EXPECT_EQ(last->level, (std::array<std::uint8_t, 2>{0xFF, 0xFF}));
  EXPECT_EQ(last->distance_rate, 2300u);
}

TEST_F(TripReaderWire, ANumberOfAnotherLengthIsUnknown) {
  objects[{0x60D0, 1}] = "4B D0 60 01 68 42 00 00";  // two bytes
  read();
  ASSERT_TRUE(last);
  EXPECT_EQ(last->fare, TripData::unknown);
  EXPECT_EQ(last->total, 18'000u);
}

TEST_F(TripReaderWire, AMeterThatIsNotThereHasNoTrip) {
  reader->read();
  EXPECT_TRUE(reader->is_reading());
  reader->read();
  bench.cable.run_for(5s);
  EXPECT_EQ(calls, 1u);
  EXPECT_FALSE(last);
  read();
  EXPECT_TRUE(last) << "later it is";
}

}  // namespace
}  // namespace canvoy::cia447::trip_reader_test
