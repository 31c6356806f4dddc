// Commands of CiA 447-3: each command object consists of fields, and each field commands one
// function, or leaves it unchanged. The common rules for their codes are implemented here for all
// devices (4.2): reserved codes are refused (0609 0030h), "don't care" changes nothing, and a
// function that the device lacks reads as not implemented.
//
//     struct Horn {
//       void commanded(const Commanded& wanted) {
//         if (wanted.is_for(cia447::horn_command)) sound();
//       }
//     };
//
//     Commands commands(network, objects,
//                       {.commanded = Callback<void(const Commanded&)>::to<&Horn::commanded>(horn),
//                        .lacking = lacking});
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "canvoy/devices/cia447/kit/car_network.hpp"
#include "canvoy/profiles/model/description.hpp"

namespace canvoy::cia447 {

/// A field of an entry, or a whole entry.
struct FieldPlace {
  std::uint16_t index = 0;     ///< of the object
  std::uint8_t sub = 0;        ///< sub-index
  std::uint8_t first_bit = 0;  ///< 0: the least significant
  std::uint8_t bits = 0;       ///< number of bits; 0: no field

  bool operator==(const FieldPlace&) const = default;
};

/// Place of the value that a handle names.
template <class Handle>
constexpr FieldPlace place_of(const Handle& /*handle*/) {
  using Place = typename Handle::Place;
  return {.index = Place::object.index,
          .sub = Place::entry.sub_first,
          .first_bit = Place::bits.first,
          .bits = Place::bits.bits};
}

/// Its description; null for reserved bits, and if there is none.
const ValueInfo* find_value_info(const FieldPlace& place);
/// The only code with this meaning: "Failure", "Function not implemented". Nothing if there is
/// none.
std::optional<std::uint32_t> code_meaning(const FieldPlace& place, Meaning meaning);

/// 0609 0030h if a field to be written has a reserved code, or one that only the provider of a
/// command uses (4.2). Texts have no codes.
AbortCode check_codes(const Entry& entry, std::span<const std::uint8_t> value);

/// Value of a field at present; 0 if the entry does not exist.
std::uint32_t read_field(const Dictionary& dictionary, const FieldPlace& place);
/// Leaves the other bits as they are. No effect if the device has no such entry.
void write_field(Dictionary& dictionary, const FieldPlace& place, std::uint32_t code);

/// The command for one function.
struct Commanded {
  FieldPlace place;        ///< field of the command
  std::uint32_t code = 0;  ///< of the command
  NodeId client = 0;       ///< sender

  /// True if the command is for the value of a handle.
  template <class Handle>
  constexpr bool is_for(const Handle& handle) const {
    return place == place_of(handle);
  }
  /// The code as a value of its enumeration.
  template <class Enumeration>
  constexpr Enumeration as() const {
    return static_cast<Enumeration>(code);
  }
};

/// Objects that are commands, and what they do.
struct CommandSettings {
  /// Called for each field that is not "don't care", when the whole object was accepted. Optional,
  /// for applications that handle whole objects.
  Callback<void(const Commanded&)> commanded = {};
  /// May refuse a field before any is executed. Optional.
  Callback<AbortCode(const Commanded&)> refuses = {};
  /// Functions that the device lacks. Must outlive the Commands.
  std::span<const FieldPlace> lacking = {};
};

class Commands {
 public:
  static constexpr std::size_t objects_max = 12;  ///< command objects

  /// `wanted` are the command objects, objects_max at most. All arguments must outlive this.
  /// Objects that the node lacks are ignored.
  Commands(CarNetwork& network, std::span<const ObjectInfo* const> wanted,
           const CommandSettings& settings);

 private:
  void reset(ResetScope scope);
  AbortCode check(const Entry& entry, std::span<const std::uint8_t> value);
  void written(const Entry& entry, Source source);
  bool lacks(const FieldPlace& place) const;

  CarNetwork& network_;
  CommandSettings settings_;
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
  std::array<Hook, objects_max> hooks_;
};

}  // namespace canvoy::cia447
