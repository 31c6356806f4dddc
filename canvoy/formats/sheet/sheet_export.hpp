// Makes data sheets from descriptions: of the devices of this project, and of any selection of
// objects or virtual devices of a profile.
//
//     SheetMaker maker(cia419::profile, {.product_name = "Charger"});
//     maker.add(cia419::full_charger);
//     write_eds(maker.take());
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "canvoy/formats/eds/data_sheet.hpp"
#include "canvoy/profiles/model/device_description.hpp"

namespace canvoy::formats {

/// Identification that descriptions of objects do not contain. Defaults of 1018h take precedence.
struct SheetIdentity {
  std::string vendor_name = "not set";   ///< DeviceInfo, VendorName
  std::uint32_t vendor_id = 0;           ///< 1018h:01h
  std::string product_name = "not set";  ///< DeviceInfo, ProductName
  std::uint32_t product_code = 0;        ///< 1018h:02h
  std::uint32_t revision = 0;            ///< 1018h:03h
  bool answers_lss = false;              ///< DeviceInfo, LSS_Supported
  std::string file_name = "device.eds";  ///< FileInfo, FileName
  /// Time of creation as CiA 306 writes it: hh:mmAM and mm-dd-yyyy.
  std::string time = "12:00AM";
  std::string date = "01-01-2026";     ///< of creation
  std::uint8_t node_id = 0;            ///< 0: an EDS; else a DCF for this node-ID
  unsigned kilobits_per_second = 125;  ///< DeviceComissioning, Baudrate
  // For a DCF.
  std::string node_name = {};       ///< empty: the product's
  std::string last_eds = {};        ///< source of the DCF; empty: none
  std::uint32_t serial_number = 0;  ///< DeviceComissioning, LSS_SerialNumber
};

/// Turns a sheet into a DCF: DeviceComissioning names the node, FileInfo gives the change and its
/// time.
void commission(DataSheet& sheet, const SheetIdentity& identity);

/// Collects objects and PDOs; the result is what take() returns.
class SheetMaker {
 public:
  /// Takes names from `profile`, its bases, and CiA 301.
  SheetMaker(const Profile& profile, SheetIdentity identity);

  /// Adds the objects of a part, in any order.
  void add(const Part& part);
  /// Adds all objects of a device.
  template <std::size_t capacity>
  void add(const DeviceDescription<capacity>& device) {
    for (const Part& part : device) add(part);
  }
  /// True if a dummy entry can replace what an RPDO maps.
  static bool has_dummy(std::uint32_t mapped);
  /// Adds the parameters of a PDO that the profile defines in a table. Mapped entries of an RPDO
  /// that the device does not have become dummy entries.
  void add(const PdoInfo& pdo);
  /// Adds 1000h, 1001h, 1017h and 1018h if they are missing; 1000h gets this value if it has none.
  void add_basics(std::uint32_t device_type);
  /// True if an object was added.
  bool has(std::uint16_t index) const { return sheet_.objects.contains(index); }

  /// Returns the sheet, with what its parts determine together (numbers of PDOs).
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
