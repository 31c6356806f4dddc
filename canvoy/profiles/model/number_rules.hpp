// Allowed raw numbers and their conversion to physical values, without texts: all that typed
// handles need at run time. They are made from a description: at compile time for handles, on
// demand for tools.
//
//     constexpr NumberRules rules(object.entry.value, bits_of(object.entry));
//     rules.physical(-320);  // -40.0
//     rules.nearest(21.5);   // 172
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/profiles/model/description.hpp"

namespace canvoy {

/// Bits of an entry that hold one number.
struct BitRange {
  std::uint8_t first = 0;  ///< 0: the least significant
  std::uint8_t bits = 8;   ///< number of bits, 1 to 64
  bool is_signed = false;  ///< two's complement

  friend constexpr bool operator==(const BitRange&, const BitRange&) = default;
};
/// All bits of an entry; none for a string or a domain.
constexpr BitRange bits_of(const EntryInfo& entry) {
  return {0, static_cast<std::uint8_t>(bit_length(entry.type)), is_signed(entry.type)};
}
/// The bits of a field.
constexpr BitRange bits_of(const FieldInfo& field) {
  return {field.first_bit, field.bits, field.is_signed};
}

/// A Boolean is transferred as a byte; any value but 0 is true.
constexpr std::uint64_t normalized(DataType type, std::uint64_t whole) {
  return type == DataType::boolean && whole != 0 ? 1 : whole;
}
/// The number in some bits of an entry's value.
constexpr std::int64_t extract(std::uint64_t whole, const BitRange& range) {
  return number_of(whole >> range.first, range.bits, range.is_signed);
}
/// The entry's value with a number inserted into some of its bits.
constexpr std::uint64_t insert(std::uint64_t whole, const BitRange& range, std::int64_t number) {
  const std::uint64_t ones = range.bits >= 64 ? ~std::uint64_t{0} : (1ULL << range.bits) - 1;
  const std::uint64_t shifted = (static_cast<std::uint64_t>(number) & ones) << range.first;
  return (whole & ~(ones << range.first)) | shifted;
}

/// Numbers from `low` to `high`.
struct NumberRange {
  std::int64_t low = 0;   ///< included
  std::int64_t high = 0;  ///< included

  /// True for a number from `low` to `high`.
  constexpr bool contains(std::int64_t number) const { return number >= low && number <= high; }
};
/// Of 64 unsigned bits, 63 are used.
constexpr NumberRange range_of_type(unsigned bits, bool is_signed) {
  constexpr std::int64_t top = std::numeric_limits<std::int64_t>::max();
  if (is_signed) return {-(top >> (64 - bits)) - 1, top >> (64 - bits)};
  return {0, bits >= 63 ? top : static_cast<std::int64_t>((1ULL << bits) - 1)};
}
/// Raw numbers of a named value, as the bits hold them.
constexpr NumberRange range_of(const NamedValue& named, const BitRange& bits) {
  return {number_of(static_cast<std::uint64_t>(named.first), bits.bits, bits.is_signed),
          number_of(static_cast<std::uint64_t>(named.last), bits.bits, bits.is_signed)};
}

class NumberRules {
 public:
  constexpr NumberRules() = default;
  /// Collects the rules for a value in these bits.
  constexpr NumberRules(const ValueInfo& value, const BitRange& bits)
      : scale_(value.scale),
        pieces_(value.pieces),
        range_(range_of_type(bits.bits, bits.is_signed)) {
    if (value.limits.kind == Limits::Kind::absolute) {
      range_ = {value.limits.low, value.limits.high};
      is_limited_ = true;
    }
    for (const NamedValue& named : value.names) {
      if (named.meaning != Meaning::state) add_gap(range_of(named, bits));
    }
    const NamedValue* invalid = find_invalid(value);
    if (invalid != nullptr) invalid_ = range_of(*invalid, bits).low;
  }

  /// Raw numbers that may be written: the limits, or all that the bits hold.
  constexpr const NumberRange& range() const { return range_; }
  /// The number that means "no value", if the description has one.
  constexpr std::optional<std::int64_t> invalid() const { return invalid_; }

  /// True beyond absolute limits; without such limits never.
  constexpr bool is_out_of_limits(std::int64_t number) const {
    return is_limited_ && !range_.contains(number);
  }
  /// True if a number is a value: no sentinel, no reserved code, and within the limits.
  constexpr bool is_value(std::int64_t number) const {
    return !is_out_of_limits(number) && find_gap(number) == nullptr;
  }
  /// The physical value, or nothing if the number is no value.
  constexpr std::optional<double> physical(std::int64_t number) const {
    if (!is_value(number)) return std::nullopt;
    return scaled(number);
  }
  /// Neither rounded nor checked. Where there are pieces and none of them reaches the value, the
  /// result is a number beyond the range.
  constexpr double exact(double physical) const {
    if (pieces_.empty()) return to_raw(physical, scale_);
    const Landing landing = land(physical);
    if (landing.missed <= 0.5) return landing.exact;
    const double beside = physical - scaled(landing.nearest);
    return static_cast<double>(beside < 0 ? range_.low : range_.high) + (beside < 0 ? -1.0 : 1.0);
  }
  /// The physical values within the limits.
  constexpr std::pair<double, double> physical_range() const {
    double low = scaled(range_.low);
    double high = scaled(range_.high);
    for (const Piece& piece : pieces_) {
      for (const std::int64_t end : {piece.first, piece.last}) {
        low = std::min(low, scaled(end));
        high = std::max(high, scaled(end));
      }
    }
    return {std::min(low, high), std::max(low, high)};
  }

  /// For a number with a fraction, the nearest one within the range.
  constexpr std::int64_t round(double exact) const {
    if (exact <= static_cast<double>(range_.low)) return range_.low;
    if (exact >= static_cast<double>(range_.high)) return range_.high;
    return exact < 0 ? -static_cast<std::int64_t>(0.5 - exact)
                     : static_cast<std::int64_t>(exact + 0.5);
  }
  /// The number nearest to a physical value: see settle(). NaN gives the sentinel, or the lowest
  /// number if there is none.
  constexpr std::int64_t nearest(double physical) const {
    if (!(physical == physical)) return invalid_.value_or(range_.low);
    if (!pieces_.empty()) {
      const Landing landing = land(physical);
      return settle(landing.nearest, landing.exact);
    }
    const double wanted = exact(physical);
    return settle(round(wanted), wanted);
  }
  /// The number to send in place of `number`. Beyond the limits, this is the limit. A number that
  /// is no value is replaced by the value nearest to `wanted`; of two equally near ones, by that
  /// nearer to 0 (CiA 419, errata 1: 0 or -2, not -1).
  constexpr std::int64_t settle(std::int64_t number, double wanted) const {
    if (is_limited_ && number < range_.low) number = range_.low;
    if (is_limited_ && number > range_.high) number = range_.high;
    if (find_gap(number) == nullptr) return number;
    const auto below = beside_gaps(number, -1);
    const auto above = beside_gaps(number, +1);
    if (!below || !above) return below ? *below : above.value_or(number);
    const double down = wanted - static_cast<double>(*below);
    const double up = static_cast<double>(*above) - wanted;
    if (down != up) return down < up ? *below : *above;
    return *below < 0 ? *above : *below;
  }

 private:
  static constexpr std::size_t gap_capacity = 4;

  constexpr double scaled(std::int64_t number) const {
    for (const Piece& piece : pieces_) {
      if (number >= piece.first && number <= piece.last) {
        return to_physical(static_cast<double>(number), piece.scale);
      }
    }
    return to_physical(static_cast<double>(number), scale_);
  }

  /// Location of a physical value among the pieces.
  struct Landing {
    double exact = 0;                                         ///< in the scale of the nearest piece
    std::int64_t nearest = 0;                                 ///< the nearest number of that piece
    double missed = std::numeric_limits<double>::infinity();  ///< distance from the piece in steps
  };
  constexpr Landing land(double physical) const {
    Landing best;
    for (const Piece& piece : pieces_) {
      const double exact = to_raw(physical, piece.scale);
      const double inside =
          std::clamp(exact, static_cast<double>(piece.first), static_cast<double>(piece.last));
      const double missed = exact < inside ? inside - exact : exact - inside;
      if (missed < best.missed) best = {exact, round(inside), missed};
    }
    return best;
  }

  /// Joins adjacent gaps.
  constexpr void add_gap(const NumberRange& gap) {
    for (std::size_t i = 0; i < gap_count_; ++i) {
      NumberRange& known = gaps_[i];
      if (gap.low > known.high + 1 || gap.high < known.low - 1) continue;
      known.low = gap.low < known.low ? gap.low : known.low;
      known.high = gap.high > known.high ? gap.high : known.high;
      return;
    }
    if (gap_count_ == gap_capacity) {
      detail::description_is_wrong("more gaps between values than there is room for");
      return;
    }
    gaps_[gap_count_++] = gap;
  }
  constexpr const NumberRange* find_gap(std::int64_t number) const {
    for (std::size_t i = 0; i < gap_count_; ++i) {
      if (gaps_[i].contains(number)) return &gaps_[i];
    }
    return nullptr;
  }
  /// The first number from `number` on in one direction that is a value.
  constexpr std::optional<std::int64_t> beside_gaps(std::int64_t number, int step) const {
    const NumberRange* gap = find_gap(number);
    while (gap != nullptr) {
      if (step < 0 ? gap->low <= range_.low : gap->high >= range_.high) return std::nullopt;
      number = step < 0 ? gap->low - 1 : gap->high + 1;
      gap = find_gap(number);
    }
    return number;
  }

  Scale scale_{};
  Items<Piece> pieces_{};
  NumberRange range_{};
  std::optional<std::int64_t> invalid_{};
  bool is_limited_ = false;
  std::uint8_t gap_count_ = 0;
  std::array<NumberRange, gap_capacity> gaps_{};
};

}  // namespace canvoy
