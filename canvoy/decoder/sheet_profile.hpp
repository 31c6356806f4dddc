// What a decoder takes from the data sheet of a node (EDS, DCF, XDD, XDC): names and types of the
// objects that a profile does not describe better, and the PDOs.
//
//     const SheetProfile profile(sheet);
//     network.set_sheet(5, profile.sheet());  // `profile` has to outlive the network
//     network.add_sheet(profile.sheet());     // of all nodes with the identity in the sheet
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "canvoy/decoder/network.hpp"
#include "canvoy/formats/eds/data_sheet.hpp"

namespace canvoy::decoder {

class SheetProfile {
 public:
  /// Copies what it needs. Omits entries of unknown types. Takes the profile of the device type as
  /// the network reads it (Network::reading_of), or the usual one.
  explicit SheetProfile(const formats::DataSheet& sheet, const Network* network = nullptr);
  SheetProfile(const SheetProfile&) = delete;
  SheetProfile& operator=(const SheetProfile&) = delete;

  /// The objects of the sheet with its limits and access. Its base, the profile of the device type,
  /// gives their meaning.
  const Profile& profile() const { return profile_; }
  /// Profile, identity, PDOs and units from the sheet.
  const DeviceSheet& sheet() const { return sheet_; }

 private:
  void add_object(std::uint16_t index, const formats::SheetObject& object);
  void add_described(std::uint16_t index, const formats::SheetObject& object,
                     const ObjectInfo& described);
  void add_parameters(std::uint16_t index, const formats::SheetObject& object);
  void add_entry(std::vector<EntryInfo>& entries, std::uint16_t index, std::uint8_t sub,
                 const formats::SheetEntry& entry);
  std::string_view keep(const std::string& text) { return texts_.emplace_back(text); }

  std::deque<std::string> texts_;
  std::deque<std::vector<EntryInfo>> entries_;
  const formats::DataSheet* source_;  ///< during construction
  std::deque<ObjectInfo> objects_;
  std::vector<const ObjectInfo*> sorted_;
  Profile profile_;
  DeviceSheet sheet_;
};

}  // namespace canvoy::decoder
