// Each entry of each device of the catalogue, accessed by a foreign client: writable entries of the
// data sheet accept values, write-only ones are not read, read-only ones are not written, and
// values beyond the range of the clause are refused. Where a device differs, a ruling gives the
// reason.
#include <gtest/gtest.h>

#include <cctype>
#include <set>
#include <string_view>

#include "canvoy/devices/testing/foreign_client.hpp"
#include "canvoy/devices/testing/object_rulings.hpp"
#include "canvoy/profiles/model/layout.hpp"

namespace canvoy::every_object_test {
namespace {

using Bytes = ForeignClient::Bytes;

/// Its values are those of services, which tests of these try: here they are written back.
constexpr std::uint16_t first_of_application = 0x2000;

struct Values {
  std::vector<Bytes> within;  ///< what the clause allows
  std::vector<Bytes> beyond;
};

/// The values of a number, or of some bits of it that are a field.
struct Numbers {
  std::set<std::int64_t> within;
  std::set<std::int64_t> beyond;
};

/// "Function not implemented" is the value of a command for a reader (CiA 447-3, 4.2): like
/// reserved values, it must not be written.
bool may_be_written(const NamedValue& named) {
  return named.meaning != Meaning::reserved && named.meaning != Meaning::not_implemented;
}

/// The ends of the range, and those of each named value.
Numbers numbers_of(const ValueInfo& value, const BitRange& bits) {
  const NumberRange all = range_of_type(bits.bits, bits.is_signed);
  Numbers numbers;
  const auto add = [&](std::int64_t number) {
    const NamedValue* const named = find_name(value, number, bits.bits, bits.is_signed);
    if (named == nullptr || may_be_written(*named)) numbers.within.insert(number);
  };
  if (value.limits.kind == Limits::Kind::none) {
    for (const std::int64_t end : {all.low, all.high}) add(end);
  } else {
    for (const std::int64_t end : {value.limits.low, value.limits.high}) add(end);
  }
  if (value.limits.kind == Limits::Kind::absolute) {
    for (const std::int64_t next : {value.limits.low - 1, value.limits.high + 1}) {
      const bool is_named = find_name(value, next, bits.bits, bits.is_signed) != nullptr;
      if (all.contains(next) && !is_named) numbers.beyond.insert(next);
    }
  }
  for (const NamedValue& named : value.names) {
    const NumberRange range = range_of(named, bits);
    auto& where = may_be_written(named) ? numbers.within : numbers.beyond;
    where.insert({range.low, range.high});
  }
  return numbers;
}

Bytes bytes_of(std::uint64_t number, DataType type) {
  Bytes bytes(sizeof number);
  store(bytes.data(), number);
  bytes.resize(byte_length(type));
  return bytes;
}

/// Each field by itself; the others have their values before the first write.
Values values_of_fields(const Part& part, const EntryInfo& entry) {
  Values values;
  const auto rest = static_cast<std::uint64_t>(detail::initial_of(part, entry).number);
  for (const std::int64_t number : numbers_of(entry.value, bits_of(entry)).beyond) {
    values.beyond.push_back(bytes_of(static_cast<std::uint64_t>(number), entry.type));
  }
  for (const FieldInfo& field : entry.fields) {
    if (is_reserved(field) || !field.when.empty()) continue;
    const Numbers numbers = numbers_of(field.value, bits_of(field));
    for (const std::int64_t number : numbers.within) {
      values.within.push_back(bytes_of(insert(rest, bits_of(field), number), entry.type));
    }
    for (const std::int64_t number : numbers.beyond) {
      values.beyond.push_back(bytes_of(insert(rest, bits_of(field), number), entry.type));
    }
  }
  return values;
}

/// In one segment and in several, up to the maximum length.
Values values_of_bytes(const Part& part, const EntryInfo& entry) {
  constexpr std::size_t sizes[] = {2, 7, 8, 100, 900};
  const std::size_t room = entry.type == DataType::domain ? sizes[4]
                           : part.capacity() != 0         ? part.capacity()
                                                          : entry.capacity;
  Values values;
  for (const std::size_t size : sizes) values.within.emplace_back(std::min(size, room), 'A');
  if (is_string(entry.type)) {
    values.within.emplace_back(room, 'A');
    values.beyond.emplace_back(room + 1, 'A');
  }
  return values;
}

Values values_of(const Part& part, const EntryInfo& entry) {
  if (is_string(entry.type) || entry.type == DataType::domain) return values_of_bytes(part, entry);
  if (is_real(entry.type)) return {.within = {bytes_of(0, entry.type)}, .beyond = {}};
  if (!entry.fields.empty()) return values_of_fields(part, entry);
  const Numbers numbers = numbers_of(entry.value, bits_of(entry));
  Values values;
  for (const std::int64_t number : numbers.within) {
    values.within.push_back(bytes_of(static_cast<std::uint64_t>(number), entry.type));
  }
  for (const std::int64_t number : numbers.beyond) {
    values.beyond.push_back(bytes_of(static_cast<std::uint64_t>(number), entry.type));
  }
  return values;
}

bool is_out_of_range(AbortCode answer) {
  return answer == AbortCode::value_range || answer == AbortCode::value_too_high ||
         answer == AbortCode::value_too_low || answer == AbortCode::length_too_high;
}

/// A foreign client that tries all that a device has.
class Walk {
 public:
  explicit Walk(bool is_operational) : is_operational_(is_operational) {}

  void visit(const DeviceKind& kind) {
    kind_ = &kind;
    for (const Part& part : kind.forms.front().parts()) {
      // The first and the last of many objects of one shape.
      const std::set<unsigned> places = {0U, part.count() - 1U};
      for (const unsigned place : places) visit(part, place);
    }
  }
  /// Entries that were written, and their values.
  std::size_t entries = 0;
  std::size_t writes = 0;

  void expect_all_rulings_in_use() const {
    for (const ObjectRuling& ruling : object_rulings) {
      EXPECT_TRUE(used_.contains(&ruling)) << std::hex << ruling.first << ": " << ruling.reason;
    }
  }

 private:
  void visit(const Part& part, unsigned place) {
    index_ = static_cast<std::uint16_t>(part.index() + place);
    ForeignClient desk(*kind_);
    if (is_operational_) desk.start();
    for (const EntryInfo& entry : part.object().entries()) {
      if (!part.has(entry)) continue;
      const std::set<std::uint8_t> subs = {entry.sub_first, part.last_sub(entry)};
      for (const std::uint8_t sub : subs) {
        sub_ = sub;
        visit(desk, part, entry);
      }
    }
  }

  void visit(ForeignClient& desk, const Part& part, const EntryInfo& entry) {
    const Access access = detail::access_of(part, entry);
    const Result<Bytes> before = desk.read(index_, sub_);
    if (allows(access, Access::sdo_read)) {
      expect(before.abort(), AbortCode::none, ObjectRuling::Case::read);
    } else {
      EXPECT_EQ(before.abort(), AbortCode::write_only) << place();
    }
    Values values = values_of(part, entry);
    if (!allows(access, Access::sdo_write)) {
      const Bytes& any = before && !before->empty() ? *before : values.within.front();
      EXPECT_EQ(desk.write(index_, sub_, any), AbortCode::read_only) << place();
      return;
    }
    if (index_ < first_of_application) {
      values = {};
      if (before) values.within = {*before};
    }
    entries += 1;
    for (const Bytes& value : values.within) {
      expect(desk.write(index_, sub_, value), AbortCode::none, ObjectRuling::Case::within);
    }
    for (const Bytes& value : values.beyond) expect_refused(desk.write(index_, sub_, value));
    writes += values.within.size() + values.beyond.size();
  }

  void expect(AbortCode answer, AbortCode usual, ObjectRuling::Case what) {
    if (answer == usual || rule(what, answer)) return;
    ADD_FAILURE() << place() << std::hex << static_cast<std::uint32_t>(answer)
                  << (what == ObjectRuling::Case::read ? " is read"
                                                       : " is the answer to a value of its range");
  }
  void expect_refused(AbortCode answer) {
    if (is_out_of_range(answer) || rule(ObjectRuling::Case::beyond, answer)) return;
    ADD_FAILURE() << place() << std::hex << static_cast<std::uint32_t>(answer)
                  << " is the answer to a value beyond its range";
  }
  bool rule(ObjectRuling::Case what, AbortCode answer) {
    bool is_ruled = false;
    for (const ObjectRuling& ruling : object_rulings) {
      if (!ruling.is_for(kind_->profile->number, index_, what, answer)) continue;
      used_.insert(&ruling);
      is_ruled = true;
    }
    return is_ruled;
  }
  std::string place() const {
    char text[64];
    std::snprintf(text, sizeof text, "%.*s %04Xh:%02Xh ", static_cast<int>(kind_->info.name.size()),
                  kind_->info.name.data(), unsigned{index_}, unsigned{sub_});
    return text;
  }

  bool is_operational_;
  const DeviceKind* kind_ = nullptr;
  std::uint16_t index_ = 0;
  std::uint8_t sub_ = 0;
  std::set<const ObjectRuling*> used_;
};

void walk_all(bool is_operational) {
  Walk walk(is_operational);
  for (const DeviceKind* kind : every_device_kind()) walk.visit(*kind);
  walk.expect_all_rulings_in_use();
  EXPECT_GT(walk.entries, 4000u);
  EXPECT_GT(walk.writes, 10000u);
}

TEST(EveryObject, EachRulingNamesTheClauseThatItFollows) {
  for (const ObjectRuling& ruling : object_rulings) {
    const std::string_view reason = ruling.reason;
    const bool has_clause = std::isdigit(static_cast<unsigned char>(reason.front())) != 0 ||
                            reason.starts_with("CiA ") || reason.starts_with("MID, ");
    EXPECT_TRUE(has_clause && reason.find(": ") != std::string_view::npos) << reason;
  }
}

TEST(EveryObject, IsTakenOrRefusedAsItsDataSheetSaysWhenPreOperational) {
  walk_all(false);
}

TEST(EveryObject, IsTakenOrRefusedAsItsDataSheetSaysWhenOperational) {
  walk_all(true);
}

}  // namespace
}  // namespace canvoy::every_object_test
