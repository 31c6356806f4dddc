// What passengers read on the paper of the printer, against what they paid.
//
//     difference_of_receipts(paper.lines(), trips, false)     // in 0,001 of the currency unit
#pragma once

#include <span>
#include <string>

#include "canvoy/sim/taxi/fare_referee.hpp"

namespace canvoy::taxi {

/// What is read on each receipt against what was paid, all differences together, in 0,001 of the
/// currency unit. Of receipts that wait for paper the meter keeps the last one only:
/// `some_may_lack`, where such a fault was.
double difference_of_receipts(std::span<const std::string> lines, std::span<const Trip> trips,
                              bool some_may_lack);

/// Whether any line says the amount, in 0,001 of the currency unit: a real meter may write what it
/// likes around it.
bool says_amount(std::span<const std::string> lines, double amount);

}  // namespace canvoy::taxi
