// Objects that are created and destroyed at run time (6020h; CiA 417-4, 4.2.6). The dictionary has
// room for all that can be created; those that are not created do not exist on the bus.
//
//     constexpr CreatableObjects inputs[] = {{.first = 0x6100, .last = 0x6103, .highest_sub = 8}};
//     CreatedObject memory[6];   // as many at a time
//     ObjectCreation creation(node, inputs, memory);
//
// In the dictionary, these objects have SDO access rw. The access of a created one is selected at
// its creation, or specified. After power-on and NMT reset node, none is created.
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/canopen/node/node.hpp"
#include "canvoy/profiles/cia417/physical.hpp"

namespace canvoy::cia417 {

/// Objects of which the sub-indices 1 to `highest_sub` can be created. Sub-index 0 exists while one
/// of the others exists, and is the highest of them.
struct CreatableObjects {
  std::uint16_t first = 0;        ///< the lowest index
  std::uint16_t last = 0;         ///< the highest index, included
  std::uint8_t highest_sub = 0;   ///< from 1 on
  Access specified = Access::ro;  ///< sdo_read and sdo_write count
};

/// A created object; the owner of ObjectCreation provides the memory.
struct CreatedObject {
  std::uint16_t index = 0;                             ///< A value written to 6020h.
  std::uint8_t sub = 0;                                ///< of the entry
  CreatedAccess access = CreatedAccess::as_specified;  ///< that the client asked for
};

/// What is written into 6020h.
struct CreationRequest {
  std::uint16_t index = 0;                             ///< index of the entry
  std::uint8_t sub = 0;                                ///< sub-index of the entry
  CreatedAccess access = CreatedAccess::as_specified;  ///< that the entry gets
  std::uint8_t action = 0;                             ///< see Creation; 0 and 3 are reserved
};
/// Takes a value written to 6020h apart.
constexpr CreationRequest decode_creation(std::uint32_t value) {
  return {.index = static_cast<std::uint16_t>(value >> 16),
          .sub = static_cast<std::uint8_t>(value >> 8),
          .access = static_cast<CreatedAccess>(value >> 6 & 3),
          .action = static_cast<std::uint8_t>(value & 3)};
}

/// Aborts: 0609 0030h for an object that cannot be created or a reserved action, 0504 0005h if
/// there is no room for another one, 0602 0000h to destroy an object that does not exist. Creating
/// an existing object gives it another access. Costs are linear in the number of created objects,
/// for each access to the objects between the first and the last that can be created.
class ObjectCreation {
 public:
  /// All arguments must outlive this.
  ObjectCreation(Node& node, std::span<const CreatableObjects> creatable,
                 std::span<CreatedObject> memory);
  ObjectCreation(const ObjectCreation&) = delete;
  ObjectCreation& operator=(const ObjectCreation&) = delete;

  /// True if the entry was created, and not destroyed since.
  bool is_created(std::uint16_t index, std::uint8_t sub) const {
    return find(index, sub) != nullptr;
  }

 private:
  void reset(ResetScope scope);
  AbortCode before_request(const Entry& entry, std::span<const std::uint8_t> value);
  void requested(const Entry& entry, Source source);
  AbortCode read_created(const Entry& entry);
  AbortCode write_created(const Entry& entry, std::span<const std::uint8_t> value);

  const CreatableObjects* find_creatable(std::uint16_t index) const;
  CreatedObject* find(std::uint16_t index, std::uint8_t sub) const;
  CreatedObject* find_free() const;
  std::uint8_t highest_sub(std::uint16_t index) const;
  AbortCode check_there(const Entry& entry) const;
  CreatedAccess access_of(const Entry& entry, const CreatableObjects& specified) const;
  void create(const CreationRequest& request);
  void destroy(const CreationRequest& request);

  Node& node_;
  std::span<const CreatableObjects> creatable_;
  std::span<CreatedObject> memory_;
  std::uint32_t last_created_ = 0;
  Hook object_hook_;
  static const AccessHandlers hook_calls[];
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
};

}  // namespace canvoy::cia417
