// A dictionary made from a description, with memory from the heap, in its state after power-on.
//
//     DeviceMemory device(layout.tables(), 5);
//     device.dictionary.number(0x1000, 0);
//
// For tests only.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "canvoy/canopen/dictionary/dictionary.hpp"

namespace canvoy {

class DeviceMemory {
 public:
  explicit DeviceMemory(const DictionaryTables& tables, std::uint8_t node_id = 1)
      : tables_(tables),
        bytes_(tables.value_bytes),
        states_(tables.objects.size()),
        dictionary(tables_, bytes_, states_) {
    dictionary.restore_defaults(0, 0xFFFF, node_id);
  }

 private:
  DictionaryTables tables_;
  std::vector<std::uint8_t> bytes_;
  std::vector<ObjectState> states_;

 public:
  Dictionary dictionary;
};

/// "rw TR": the access of SDO, and the PDOs into which an entry may be mapped.
inline std::string access_text(Access access) {
  std::string text = allows(access, Access::const_) ? "const"
                     : allows(access, Access::rw)   ? "rw"
                     : allows(access, Access::ro)   ? "ro"
                     : allows(access, Access::wo)   ? "wo"
                                                    : "none";
  if (allows(access, Access::tpdo)) text += " T";
  if (allows(access, Access::rpdo)) text += allows(access, Access::tpdo) ? "R" : " R";
  return text;
}

}  // namespace canvoy
