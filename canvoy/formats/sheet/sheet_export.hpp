// Data sheets of devices that descriptions make: those that the project builds, and any choice of a
// profile's objects or virtual devices.
//
//     SheetMaker maker(cia419::profile, {.product_name = "Charger"});
//     maker.add(cia419::full_charger);
//     write_eds(maker.take());
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "canvoy/formats/sheet/data_sheet.hpp"
#include "canvoy/profiles/device_description.hpp"

namespace canvoy::formats {

/// What descriptions of objects do not say. Numbers that 1018h has by default go before those here.
struct SheetIdentity {
  std::string vendor_name = "not set";
  std::uint32_t vendor_id = 0;
  std::string product_name = "not set";
  std::uint32_t product_code = 0;
  std::uint32_t revision = 0;
  bool answers_lss = false;
  std::string file_name = "device.eds";
  /// When the sheet was made, as CIA 306 writes it: hh:mmAM and mm-dd-yyyy.
  std::string time = "12:00AM";
  std::string date = "01-01-2026";
  std::uint8_t node_id = 0;  ///< 0: an EDS; else a DCF of the node with this node-ID
  unsigned kilobits_per_second = 125;
  // Of a DCF.
  std::string node_name = {};  ///< empty: the product's
  std::string last_eds = {};   ///< that it was made from; empty: from none
  std::uint32_t serial_number = 0;
};

/// Makes a DCF of a sheet: DeviceComissioning names the node, FileInfo says what was changed and
/// when.
void commission(DataSheet& sheet, const SheetIdentity& identity);

class SheetMaker {
 public:
  /// Names are taken from `profile`, what it is built on, and CiA 301.
  SheetMaker(const Profile& profile, SheetIdentity identity);

  void add(const Part& part);
  template <std::size_t capacity>
  void add(const DeviceDescription<capacity>& device) {
    for (const Part& part : device) add(part);
  }
  /// Whether a dummy entry can stand for what an RPDO maps.
  static bool has_dummy(std::uint32_t mapped);
  /// The parameters of a PDO that the profile defines in a table. What an RPDO carries and the
  /// device does not have becomes a dummy entry.
  void add(const PdoInfo& pdo);
  /// 1000h, 1001h, 1017h and 1018h, where nothing has brought them along; 1000h has this value
  /// where it has none.
  void add_basics(std::uint32_t device_type);
  bool has(std::uint16_t index) const { return sheet_.objects.contains(index); }

  /// The sheet, with what its parts say together (numbers of PDOs).
  DataSheet take();

 private:
  SheetEntry entry_of(const Part& part, const EntryInfo& entry, unsigned index, unsigned sub) const;
  SheetObject& add_record(std::uint16_t index, std::string name, bool is_array = false);
  void add_variable(std::uint16_t index, SheetEntry entry);
  std::uint32_t received(std::uint32_t mapped) const;
  void add_sections();

  const Profile& profile_;
  SheetIdentity identity_;
  DataSheet sheet_;
};

}  // namespace canvoy::formats
