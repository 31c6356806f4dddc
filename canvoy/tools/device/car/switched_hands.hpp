// Hands on a status of a unit that is a table of switched things (switching.hpp).
//
//     table.tell = report_switched<RadioUnit>;
#pragma once

#include <cmath>

#include "canvoy/devices/cia447/kit/switching.hpp"
#include "canvoy/tools/device/hand/device_hand.hpp"

namespace canvoy::tools {

/// The code of a status that was given as a number or as a word.
inline std::uint32_t code_of(const HandValue& value) {
  return value.code != 0 ? value.code : static_cast<std::uint32_t>(std::lround(value.number));
}

/// `reporter` has report() and sense() for any status. A reported state makes the sensor work
/// again.
template <class Reporter>
void report_status(Reporter& reporter, const cia447::FieldPlace& status, const HandValue& value) {
  using cia447::Sensing;
  switch (value.meaning) {
    case Meaning::failure:
      return reporter.sense(status, Sensing::failure);
    case Meaning::invalid:
      return reporter.sense(status, Sensing::not_available);
    case Meaning::padding:
      return reporter.sense(status, Sensing::working);
    default:
      reporter.sense(status, Sensing::working);
      reporter.report(status, code_of(value));
  }
}

template <class Unit>
void report_switched(const HandTarget& target, const cia447::FieldPlace& status,
                     const HandValue& value) {
  report_status(target.as<Unit>().switching(), status, value);
}

}  // namespace canvoy::tools
