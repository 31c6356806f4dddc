// Arbitrary text as a drive recorded by a satellite receiver: a car can follow it, and splitting
// the stream differently has no effect on the receiver.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "canvoy/worlds/car/drive.hpp"

namespace {

using namespace canvoy;

void check_cuts(std::string_view text) {
  cia447::NmeaReceiver whole;
  whole.receive(text);
  cia447::NmeaReceiver cut;
  cut.receive(text.substr(0, text.size() / 2));
  cut.receive(text.substr(text.size() / 2));
  if (!(whole.counts() == cut.counts()) || !(whole.reading() == cut.reading())) std::abort();
  const cia447::GpsReading reading = whole.reading();
  if (std::abs(reading.latitude.value_or(0)) > 90) std::abort();
  if (std::abs(reading.longitude.value_or(0)) > 180) std::abort();
  if (!(reading.velocity.value_or(0) >= 0)) std::abort();
}

void check_drive(const car::DriveRecord& record) {
  for (std::size_t i = 1; i < record.samples.size(); ++i) {
    if (record.samples[i - 1].at >= record.samples[i].at) std::abort();
  }
  car::Drive drive(&record);
  constexpr int steps_max = 10'000;
  for (int i = 0; i < steps_max && !drive.is_through(); ++i) {
    if (drive.is_standing()) drive.go_on();
    const double before = drive.metres();
    constexpr Duration step = 700ms;
    drive.step(step);
    const double driven = drive.metres() - before;
    // Written so that NaN is refused as well.
    if (!(driven >= 0 && driven <= car::DriveRecord::fastest)) std::abort();
    if (!(drive.speed() >= 0 && drive.speed() <= car::DriveRecord::fastest)) std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  check_cuts(text);
  check_drive(car::read_drive_record(text));
  return 0;
}
