// What passengers read on the paper of the printer, line by line, against what they have paid, how
// far they went and when.
//
//     const ReceiptVerdict read = judge_receipts(paper.lines(), trips, local_begin);
//     read.difference    // in 0,001 of the currency unit
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "canvoy/sim/taxi/fare_referee.hpp"

namespace canvoy::taxi {

/// What was wrong, and of how much that was read.
struct ReceiptVerdict {
  double difference = 0;       ///< of all totals and what was paid, in 0,001 of the currency unit
  std::uint64_t receipts = 0;  ///< that were read, or missed
  std::uint64_t wrong_lines = 0;  ///< or lines that are not there
  std::uint64_t lines = 0;        ///< that were read, or missed
};

/// All that was printed in a shift. Of a receipt that a fault may have cost
/// (Trip::may_lack_receipt) nothing is missed, and where there is one of those, pieces of receipts
/// are passed over; one that is whole has to be right. `local_begin`: seconds since 1970-01-01 that
/// clocks show at time 0.
ReceiptVerdict judge_receipts(std::span<const std::string> lines, std::span<const Trip> trips,
                              std::int64_t local_begin);

/// Whether any line says the amount, in 0,001 of the currency unit: a real meter may write what it
/// likes around it.
bool says_amount(std::span<const std::string> lines, double amount);

}  // namespace canvoy::taxi
