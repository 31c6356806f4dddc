// A DCF (CiA 306) of a node as it is now: its entries, read one by one, by a data sheet of its
// kind or by the profile that it says to have.
//
//     SheetScan scan(read);              // how an entry of the node is read
//     scan.read_values(sheet);           // the values of all entries of an EDS
//     DataSheet found = scan.read_profile(cia419::profile, identity);  // without one
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "canvoy/canopen/dictionary/abort_code.hpp"
#include "canvoy/formats/sheet/data_sheet.hpp"
#include "canvoy/formats/sheet/sheet_export.hpp"

namespace canvoy::formats {

class SheetScan {
 public:
  using Bytes = std::vector<std::uint8_t>;
  /// The value of an entry, or why there is none. May throw, which ends the scan.
  using Read = std::function<Result<Bytes>(std::uint16_t index, std::uint8_t sub)>;
  struct Progress {
    std::size_t done = 0;  ///< objects
    std::size_t all = 0;
    std::uint16_t index = 0;
  };

  /// An entry without a value in the sheet.
  struct Unread {
    std::uint16_t index = 0;
    std::uint8_t sub = 0;
    std::string name = {};
    AbortCode abort = AbortCode::none;  ///< what the node answered; none: see `reason`
    std::string reason = {};
  };

  explicit SheetScan(Read read) : read_(std::move(read)) {}
  void on_progress(std::function<void(const Progress&)> tell) { tell_ = std::move(tell); }

  /// Gives all entries of a sheet that may be read their values, but domains: see read_domains().
  void read_values(DataSheet& sheet);
  /// The objects that a profile and CiA 301 and 302 describe and the node has, with their values.
  /// Domains, of which nobody knows the size, are left out.
  DataSheet read_profile(const Profile& profile, SheetIdentity identity);

  /// Adds the objects from `first` to `last` that the node has and the sheet does not: nobody
  /// describes them, and so their names are their indices, their types are the least that hold what
  /// was read, and all may be written. Asks for each index once, and never writes.
  void read_undescribed(DataSheet& sheet, std::uint16_t first, std::uint16_t last);

  using Keep =
      std::function<std::string(std::uint16_t index, std::uint8_t sub, const Bytes& bytes)>;
  /// Reads the domains of a sheet that may be read. `keep` puts the bytes of one into a file and
  /// returns its name, which becomes UploadFile.
  void read_domains(DataSheet& sheet, const Keep& keep);

  /// Entries that were read.
  std::size_t count() const { return count_; }
  const std::vector<Unread>& unread() const { return unread_; }

 private:
  void read_entry(std::uint16_t index, std::uint8_t sub, SheetEntry& entry);
  void read_domain(std::uint16_t index, std::uint8_t sub, SheetEntry& entry, const Keep& keep);
  void note(std::uint16_t index, std::uint8_t sub, const SheetEntry& entry,
            const Result<Bytes>& answer);
  void tell(std::size_t done, std::size_t all, std::uint16_t index) const;

  using Answers = std::map<std::uint8_t, Result<Bytes>>;
  void read_undescribed_object(DataSheet& sheet, std::uint16_t index);
  SheetEntry undescribed_entry(std::uint16_t index, std::uint8_t sub, const Bytes& bytes);
  Answers ask_object(std::uint16_t index, const ObjectInfo& object);
  void ask_entries(std::uint16_t index, const EntryInfo& entry, Answers& answers);
  void fill(std::uint16_t index, SheetObject& object, const Answers& answers);

  Read read_;
  std::function<void(const Progress&)> tell_;
  std::size_t count_ = 0;
  std::vector<Unread> unread_;
};

}  // namespace canvoy::formats
