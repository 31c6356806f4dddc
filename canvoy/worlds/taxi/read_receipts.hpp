// Compares what passengers read on the paper of the printer, line by line, with what they have
// paid, the prices of the tariff for their services, and the distance and time of their trip.
//
//     const ReceiptVerdict read = judge_receipts(paper.lines(), trips, truth);
//     read.difference    // in 0,001 of the currency unit
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "canvoy/worlds/taxi/fare_referee.hpp"
#include "canvoy/worlds/taxi/paper_lines.hpp"

namespace canvoy::taxi {

/// Errors, and the amount of text that was read.
struct ReceiptVerdict {
  double difference = 0;       ///< between all totals and payments, in 0.001 of the currency unit
  std::uint64_t receipts = 0;  ///< receipts read, or missing
  std::uint64_t wrong_lines = 0;  ///< wrong or missing lines
  std::uint64_t lines = 0;        ///< lines read, or missing
};

/// Judges all that was printed in a shift. A receipt that a fault may have affected
/// (Trip::may_lack_receipt) may be missing, and where there is one of those, incomplete receipts
/// are ignored; a complete one must be right.
ReceiptVerdict judge_receipts(std::span<const std::string> lines, std::span<const Trip> trips,
                              const PaperTruth& truth);

/// True if any line has the amount, in 0.001 of the currency unit: a real meter may print any text
/// around it.
bool says_amount(std::span<const std::string> lines, double amount);

}  // namespace canvoy::taxi
