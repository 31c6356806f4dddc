// What the data sheet of a node (EDS, DCF, XDD, XDC) tells a decoder: the names and types of its
// objects, beside those that a profile describes better, and its PDOs.
//
//     const SheetProfile profile(sheet);
//     network.set_sheet(5, profile.sheet());  // `profile` has to outlive the network
//     network.add_sheet(profile.sheet());     // of all nodes with the identity in the sheet
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "canvoy/decoder/network.hpp"
#include "canvoy/formats/sheet/data_sheet.hpp"

namespace canvoy::decoder {

class SheetProfile {
 public:
  /// Copies what it needs; entries of types that nobody knows are left out. The profile of the
  /// device type is taken as the network reads it (Network::reading_of), or as usual.
  explicit SheetProfile(const formats::DataSheet& sheet, const Network* network = nullptr);
  SheetProfile(const SheetProfile&) = delete;
  SheetProfile& operator=(const SheetProfile&) = delete;

  /// The objects of the sheet, with its limits and its access; what they mean says the profile of
  /// its device type, which is its base.
  const Profile& profile() const { return profile_; }
  /// The profile, the identity, and the PDOs and units that the sheet says.
  const DeviceSheet& sheet() const { return sheet_; }

 private:
  void add_object(std::uint16_t index, const formats::SheetObject& object);
  void add_described(std::uint16_t index, const formats::SheetObject& object,
                     const ObjectInfo& described);
  void add_parameters(std::uint16_t index, const formats::SheetObject& object);
  void add_entry(std::vector<EntryInfo>& entries, std::uint8_t sub,
                 const formats::SheetEntry& entry);
  std::string_view keep(const std::string& text) { return texts_.emplace_back(text); }

  std::deque<std::string> texts_;
  std::deque<std::vector<EntryInfo>> entries_;
  std::deque<ObjectInfo> objects_;
  std::vector<const ObjectInfo*> sorted_;
  Profile profile_;
  DeviceSheet sheet_;
};

}  // namespace canvoy::decoder
