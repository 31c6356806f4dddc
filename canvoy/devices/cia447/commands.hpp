// Commands of CiA 447-3: each object of commands is made of fields, each field wants something of
// one function, or leaves it alone. What the profile says of their codes is done here for all
// devices (4.2): reserved codes are refused (0609 0030h), "don't care" changes nothing, and a
// function that the device lacks reads as not implemented.
//
//     Commands commands(network, objects, {.commanded = ..., .lacking = lacking});
//     void Unit::commanded(const Commanded& wanted) {
//       if (wanted.is_for(cia447::horn_command)) ...
//     }
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "canvoy/devices/cia447/car_network.hpp"
#include "canvoy/profiles/description.hpp"

namespace canvoy::cia447 {

/// A field of an entry, or a whole entry.
struct FieldPlace {
  std::uint16_t index = 0;
  std::uint8_t sub = 0;
  std::uint8_t first_bit = 0;
  std::uint8_t bits = 0;

  bool operator==(const FieldPlace&) const = default;
};

template <class Handle>
constexpr FieldPlace place_of(const Handle& /*handle*/) {
  using Place = typename Handle::Place;
  return {.index = Place::object.index,
          .sub = Place::entry.sub_first,
          .first_bit = Place::bits.first,
          .bits = Place::bits.bits};
}

/// What is known of it; null for reserved bits, and where there is none.
const ValueInfo* find_value_info(const FieldPlace& place);
/// The one code that means this: "Failure", "Function not implemented". Nothing: it has none.
std::optional<std::uint32_t> code_meaning(const FieldPlace& place, Meaning meaning);

/// 0609 0030h where a field of what is to be written has a code that is reserved, or that only who
/// provides a command says of itself (4.2). Texts have no codes.
AbortCode check_codes(const Entry& entry, std::span<const std::uint8_t> value);

std::uint32_t read_field(const Dictionary& dictionary, const FieldPlace& place);
/// Other bits stay as they are. Nothing happens where the device has no such entry.
void write_field(Dictionary& dictionary, const FieldPlace& place, std::uint32_t code);

/// What a command wants of one function.
struct Commanded {
  FieldPlace place;
  std::uint32_t code = 0;
  NodeId client = 0;  ///< who wants it

  template <class Handle>
  constexpr bool is_for(const Handle& handle) const {
    return place == place_of(handle);
  }
  template <class Enumeration>
  constexpr Enumeration as() const {
    return static_cast<Enumeration>(code);
  }
};

struct CommandSettings {
  /// Is called for each field that is not "don't care", when all of the object was accepted.
  /// Optional, for who looks at the object by itself.
  Callback<void(const Commanded&)> commanded = {};
  /// May refuse a field before any is carried out. Optional.
  Callback<AbortCode(const Commanded&)> refuses = {};
  /// What the device cannot do. It must outlive the Commands.
  std::span<const FieldPlace> lacking = {};
};

class Commands {
 public:
  static constexpr std::size_t objects_max = 12;

  /// `wanted` are the objects of commands, objects_max at most. All must outlive this. Where the
  /// node lacks an object, nothing is done for it.
  Commands(CarNetwork& network, std::span<const ObjectInfo* const> wanted,
           const CommandSettings& settings);
  Commands(const Commands&) = delete;
  Commands& operator=(const Commands&) = delete;

 private:
  void reset(ResetScope scope);
  AbortCode check(const Entry& entry, std::span<const std::uint8_t> value);
  void written(const Entry& entry, Source source);
  bool lacks(const FieldPlace& place) const;

  CarNetwork& network_;
  CommandSettings settings_;
  static const ServiceCalls service_calls;
  ServiceLink service_{&service_calls, this};
  std::array<Hook, objects_max> hooks_;
};

}  // namespace canvoy::cia447
