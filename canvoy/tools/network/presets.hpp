// Values that a command sets in a node of its own: they are set after each reset, as if they had
// been stored.
//
//     Presets presets(node);
//     presets.add(0x1017, 0, 500);
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "canvoy/canopen/node/node.hpp"

namespace canvoy::tools {

class Presets {
 public:
  explicit Presets(Node& node) : node_(node) {
    service_.reset = callback<&Presets::reset>(*this);
    node.attach(service_);
  }
  Presets(const Presets&) = delete;
  Presets& operator=(const Presets&) = delete;

  void add(std::uint16_t index, std::uint8_t sub, std::uint32_t value) {
    values_.push_back({index, sub, value});
  }

 private:
  struct Value {
    std::uint16_t index;
    std::uint8_t sub;
    std::uint32_t value;
  };

  /// Writes the values, so that services that were reset before take them; sets read-only ones
  /// directly.
  void reset(ResetScope) {
    for (const Value& preset : values_) {
      const Result<Entry> entry = node_.dictionary().find(preset.index, preset.sub);
      if (!entry) continue;
      std::array<std::uint8_t, 4> bytes{};
      store(bytes.data(), preset.value);
      const auto value = std::span(bytes).first(entry->row->capacity);
      if (node_.dictionary().write(*entry, value, Source::application) != AbortCode::none) {
        node_.dictionary().set(*entry, value);
      }
    }
  }

  Node& node_;
  Service service_;
  std::vector<Value> values_;
};

}  // namespace canvoy::tools
