// A stored set of parameters: a concise DCF, so that a device stores the format that a
// configuration manager sends to it (CiA 302-3, object 1F22h).
//
// - number of entries: Unsigned32
// - then for each: index Unsigned16, sub-index Unsigned8, length Unsigned32, value
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "canvoy/canopen/storage/parameter.hpp"
#include "canvoy/canopen/storage/record_pair.hpp"

namespace canvoy {

/// Head of each value.
struct StoredHead {
  static constexpr std::uint32_t size = 7;       ///< in bytes
  using Bytes = std::array<std::uint8_t, size>;  ///< as in a concise DCF

  std::uint16_t index = 0;   ///< of the object
  std::uint8_t sub = 0;      ///< sub-index
  std::uint32_t length = 0;  ///< of the value that follows, in bytes

  /// The head as it is stored, little-endian.
  Bytes bytes() const;
  /// Takes a stored head apart.
  static StoredHead from(const Bytes& bytes);
};

/// True if the dictionary has such a parameter.
bool fits(const StoredHead& head, const Dictionary& dictionary);

/// Greatest size in bytes of a set of all parameters, with full strings.
std::uint32_t stored_size_max(const Dictionary& dictionary);

/// Iterates over the entries of a record.
class StoredWalk {
 public:
  static constexpr std::uint32_t first_entry = 4;  ///< after the number of entries

  /// Begins before the first entry. `record` must outlive the walk.
  explicit StoredWalk(const RecordPair& record) : record_(&record) {}

  /// Goes to the next entry; false at the end, and before invalid data: see is_whole().
  bool next(StoredHead& head);
  /// Position of the last entry's value in the record.
  std::uint32_t value() const { return offset_ - length_; }
  /// After the end: true if the record has as many entries as it states, and nothing behind.
  bool is_whole() const;

 private:
  const RecordPair* record_;
  std::uint32_t offset_ = first_entry;
  std::uint32_t length_ = 0;  ///< of the last value
  std::uint32_t count_ = 0;
};

/// Makes the content of a new record, in pieces: the present values of one group, and all others
/// from the old record if the dictionary has them.
class ParameterSet {
 public:
  /// What goes into a set.
  struct Recipe {
    std::uint8_t group = 1;    ///< sub-index of 1010h or 1011h
    bool store = true;         ///< false: the group is omitted, so that its defaults apply again
    bool keep = true;          ///< false: the old record is not used
    std::uint8_t node_id = 0;  ///< for defaults that depend on it
  };

  /// Makes the set. All arguments must outlive it.
  ParameterSet(const Dictionary& dictionary, const RecordPair& record,
               std::span<const ParameterGroup> groups)
      : groups_(groups), dictionary_(dictionary), record_(record), own_(dictionary), old_(record) {}

  /// Prepares the source for the record's writer; it refers to this object.
  RecordSource cook(const Recipe& recipe);

 private:
  void rewind();
  Result<std::size_t> next(std::span<std::uint8_t> bytes);
  void begin();
  bool next_entry();
  bool next_own();
  bool next_old();
  std::size_t give(std::span<std::uint8_t> bytes);
  bool wanted(const Entry& entry) const;

  std::span<const ParameterGroup> groups_;
  const Dictionary& dictionary_;
  const RecordPair& record_;
  Recipe recipe_;
  ParameterWalk own_;
  StoredWalk old_;

  StoredHead::Bytes head_{};  ///< of the present entry
  std::uint32_t head_size_ = 0;
  std::uint32_t length_ = 0;             ///< of its value
  const std::uint8_t* value_ = nullptr;  ///< its position in memory; null: in the old record
  std::uint32_t at_ = 0;                 ///< its position in the old record
  std::uint32_t given_ = 0;              ///< number of bytes of it, with its head
  bool torn_ = false;                    ///< the old record could not be read to its end
};

}  // namespace canvoy
