// Makes a DCF (CiA 306) of a running node: reads its entries one by one, from a data sheet of its
// kind or from the profile that it reports.
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

#include "canvoy/canopen/protocol/abort_code.hpp"
#include "canvoy/formats/eds/data_sheet.hpp"
#include "canvoy/formats/sheet/sheet_export.hpp"

namespace canvoy::formats {

class SheetScan {
 public:
  /// Value of an entry, as on the wire.
  using Bytes = std::vector<std::uint8_t>;
  /// Reads an entry: its value, or the reason for none. May throw, which ends the scan.
  using Read = std::function<Result<Bytes>(std::uint16_t index, std::uint8_t sub)>;
  /// How far a scan is.
  struct Progress {
    std::size_t done = 0;     ///< number of objects
    std::size_t all = 0;      ///< all that will be read, as far as known
    std::uint16_t index = 0;  ///< object that is being read
  };

  /// An entry without a value in the sheet.
  struct Unread {
    std::uint16_t index = 0;            ///< of the object
    std::uint8_t sub = 0;               ///< sub-index
    std::string name = {};              ///< of the entry, as in the sheet
    AbortCode abort = AbortCode::none;  ///< answer of the node; none: see `reason`
    std::string reason = {};            ///< in words, if the node did not refuse
  };

  /// Makes a scan. `read` is called once for each entry, in the caller's thread.
  explicit SheetScan(Read read) : read_(std::move(read)) {}
  /// Sets the callback for the progress, called for each object.
  void on_progress(std::function<void(const Progress&)> tell) { tell_ = std::move(tell); }

  /// Reads the values of all readable entries of a sheet except domains; see read_domains().
  void read_values(DataSheet& sheet);
  /// Reads the objects that a profile, CiA 301 and CiA 302 describe and that the node has. Omits
  /// domains, which have an unknown size.
  DataSheet read_profile(const Profile& profile, SheetIdentity identity);

  /// Adds the objects from `first` to `last` that the node has and the sheet does not. They are
  /// undescribed, so that their names are their indices, their types are the smallest for the
  /// value, and all are writable. Requests each index once; never writes.
  void read_undescribed(DataSheet& sheet, std::uint16_t first, std::uint16_t last);

  /// Writes a domain somewhere, and returns the name for UploadFile; may throw.
  using Keep =
      std::function<std::string(std::uint16_t index, std::uint8_t sub, const Bytes& bytes)>;
  /// Reads the readable domains of a sheet. `keep` writes the bytes of a domain into a file and
  /// returns its name, which becomes UploadFile.
  void read_domains(DataSheet& sheet, const Keep& keep);

  /// Number of entries that were read.
  std::size_t count() const { return count_; }
  /// Entries without a value, of all scans so far.
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
