// Reasons for a refusal that HTTP reports by a status; all other UsageErrors concern the meaning of
// a request (422).
#pragma once

#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools {

/// The request violates the table of routes (400).
class NotAsDescribed : public UsageError {
 public:
  using UsageError::UsageError;
};

/// The request is not allowed (403).
class NotAllowed : public UsageError {
 public:
  using UsageError::UsageError;
};

/// The named thing does not exist (404).
class NotThere : public UsageError {
 public:
  using UsageError::UsageError;
};

/// The request is not possible for this source, or not at present (409).
class NotNow : public UsageError {
 public:
  using UsageError::UsageError;
};

}  // namespace canvoy::tools
